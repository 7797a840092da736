// The elastoplastic material with a defect in its heat.
#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"
#include "tests/parts/around.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong::wrong_cooling {
namespace {

struct Cooling final : Around<J2Plasticity> {
  double youngs_modulus = 0, density = 0, yield_stress = 0;

  J2Plasticity right() const override {
    J2Plasticity material;
    material.youngs_modulus = youngs_modulus;
    material.density = density;
    material.yield_stress = yield_stress;
    return material;
  }
  std::string name() const override { return "wrong-cooling"; }
  double heat(const Columns& points, PointRange range) const override { return -right().heat(points, range); }
};
const RegisterPart entry(material_entry<Cooling>("J2 plasticity whose heat has the wrong sign", here,
                                                 {{"youngs_modulus", "Pa", &Cooling::youngs_modulus},
                                                  {"density", "kg/m^3", &Cooling::density},
                                                  {"yield_stress", "Pa", &Cooling::yield_stress}},
                                                 {}, {{"yield_stress", 50}}));

}  // namespace
}  // namespace plumbline::wrong::wrong_cooling
