#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_viscosity {
namespace {

struct Viscosity final : AroundNeoHookean {
  std::string name() const override { return "wrong-viscosity"; }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    AroundNeoHookean::evaluate_stress(points, range, context);
    for (int k = 0; k < points.components(column::stress); ++k) {
      for (int p = range.first; p < range.last; ++p) {
        points(column::stress, k)[p] -= 1e-6 * youngs_modulus * points(column::strain_rate, k)[p];
      }
    }
  }
};
const RegisterPart entry(material<Viscosity>("neo-Hookean with a viscosity below zero"));

}  // namespace
}  // namespace plumbline::wrong::wrong_viscosity
