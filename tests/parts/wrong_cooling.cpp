// The elastoplastic material with a defect in its heat.
#include <memory>

#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {
namespace {

struct Cooling final : Material {
  double youngs_modulus = 0, density = 0, yield_stress = 0;

  J2Plasticity right() const {
    J2Plasticity material;
    material.youngs_modulus = youngs_modulus;
    material.density = density;
    material.yield_stress = yield_stress;
    return material;
  }
  std::string name() const override { return "wrong-cooling"; }
  StressMeasure measure() const override { return right().measure(); }
  void add_columns(Columns& points, int dim) const override { right().add_columns(points, dim); }
  Store store() const override { return right().store(); }
  bool dissipates() const override { return true; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override {
    return right().advance(points, range, context, dt);
  }
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override {
    return right().internal_variables(context);
  }
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override {
    return right().rates(points, context);
  }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    right().evaluate_stress(points, range, context);
  }
  double stored_energy(const Columns& points, PointRange range) const override {
    return right().stored_energy(points, range);
  }
  double heat(const Columns& points, PointRange range) const override { return -right().heat(points, range); }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return right().step_bounds(points, range, dim);
  }
  Fault first_fault(const Columns& points, PointRange range) const override {
    return right().first_fault(points, range);
  }
};
const RegisterPart entry(material_entry<Cooling>("J2 plasticity whose heat has the wrong sign", here,
                                                 {{"youngs_modulus", "Pa", &Cooling::youngs_modulus},
                                                  {"density", "kg/m^3", &Cooling::density},
                                                  {"yield_stress", "Pa", &Cooling::yield_stress}},
                                                 {}, {{"yield_stress", 50}}));

}  // namespace
}  // namespace plumbline::wrong
