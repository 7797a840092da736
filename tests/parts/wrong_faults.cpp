#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_faults {
namespace {

struct Faults final : AroundNeoHookean {
  std::string name() const override { return "wrong-faults"; }
  Fault first_fault(const Columns& points, PointRange range) const override {
    return first_not_finite(points, range, column::deformation, "the deformation must be finite");
  }
};
const RegisterPart entry(material<Faults>("neo-Hookean that takes points turned inside out"));

}  // namespace
}  // namespace plumbline::wrong::wrong_faults
