#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_axes {
namespace {

struct Axes final : AroundNeoHookean {
  std::string name() const override { return "wrong-axes"; }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    AroundNeoHookean::evaluate_stress(points, range, context);
    const double more = 1e-3 * youngs_modulus;
    for (int p = range.first; p < range.last; ++p) {
      points(column::stress)[p] += more * (points(column::deformation)[p] - 1);
    }
  }
};
const RegisterPart entry(material<Axes>("neo-Hookean that is a thousandth stiffer along x"));

}  // namespace
}  // namespace plumbline::wrong::wrong_axes
