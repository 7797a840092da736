// The neo-Hookean material, for wrong ones that differ from it in one function.
#pragma once

#include <string>
#include <vector>

#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/register_part.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {

struct AroundNeoHookean : Material {
  double youngs_modulus = 0, poissons_ratio = 0, density = 0;

  NeoHookean right() const {
    NeoHookean material;
    material.youngs_modulus = youngs_modulus;
    material.poissons_ratio = poissons_ratio;
    material.density = density;
    return material;
  }
  StressMeasure measure() const override { return right().measure(); }
  void add_columns(Columns& points, int dim) const override { right().add_columns(points, dim); }
  Store store() const override { return right().store(); }
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
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return right().step_bounds(points, range, dim);
  }
  Fault first_fault(const Columns& points, PointRange range) const override {
    return right().first_fault(points, range);
  }
};

// M is derived from AroundNeoHookean.
template <class M>
MaterialEntry material(const std::string& defect) {
  return material_entry<M>(defect, here,
                           {{"youngs_modulus", "Pa", &M::youngs_modulus},
                            {"poissons_ratio", "1", &M::poissons_ratio},
                            {"density", "kg/m^3", &M::density}});
}

}  // namespace plumbline::wrong
