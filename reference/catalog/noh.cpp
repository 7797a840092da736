// `plumbline reference noh`
#include "reference/noh.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::noh {
namespace {

class NohReference : public Reference {
 public:
  std::string name() const override { return "noh"; }
  std::string title() const override { return "Noh's problem: cold gas streams to a wall, an axis or a centre"; }
  std::string source() const override { return "W. F. Noh, J. Comput. Phys. 72 (1987) 78"; }

  std::vector<Parameter> parameters() const override {
    const NohProblem noh;
    return {dimension_parameter(noh.dimension), gamma_parameter(noh.gamma),
            positive_parameter("density", noh.density, "kg/m^3", "density of the gas at t = 0"),
            positive_parameter("velocity", noh.velocity, "m/s", "speed of approach"), time_parameter(0.6)};
  }
  Parameter abscissa() const override { return radius_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const Noh noh({dimension_of(s), s.at("gamma"), s.at("density"), s.at("velocity")});
    Answer answer;
    answer.add("shock_speed", noh.shock_speed());
    answer.add("shock_radius", noh.shock_radius(s.at("time")));
    answer.add("density_behind", noh.behind().density);
    answer.add("pressure_behind", noh.behind().pressure);
    answer.add("energy_behind", noh.behind().energy);
    for (double radius : at) add_row(answer, "radius", radius, noh.sample(radius, s.at("time")));
    return answer;
  }
};

const Registration registration{std::make_unique<NohReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::noh
