#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_stored {
namespace {

struct Stored final : AroundNeoHookean {
  std::string name() const override { return "wrong-stored"; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override {
    return 1.001 * AroundNeoHookean::advance(points, range, context, dt);
  }
};
const RegisterPart entry(material<Stored>("neo-Hookean that tells 1.001 of what it stores"));

}  // namespace
}  // namespace plumbline::wrong::wrong_stored
