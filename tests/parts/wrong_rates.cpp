#include "tests/parts/around_neo_hookean.hpp"

namespace plumbline::wrong::wrong_rates {
namespace {

struct Rates final : AroundNeoHookean {
  std::string name() const override { return "wrong-rates"; }
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override {
    std::vector<double> all = AroundNeoHookean::rates(points, context);
    for (double& one : all) one *= 1 + 1e-6;
    return all;
  }
};
const RegisterPart entry(material<Rates>("neo-Hookean whose rates are 1.000001 of what it advances by"));

}  // namespace
}  // namespace plumbline::wrong::wrong_rates
