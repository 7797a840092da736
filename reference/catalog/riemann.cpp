// `plumbline reference riemann`
#include "reference/riemann.hpp"
#include "reference/registry.hpp"

namespace plumbline::reference::catalog::riemann {
namespace {

class RiemannReference : public Reference {
 public:
  std::string name() const override { return "riemann"; }
  std::string title() const override { return "Riemann problem of the Euler equations, ideal gas, vacuum included"; }
  std::string source() const override {
    return "E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., 2009, chapter 4";
  }

  std::vector<Parameter> parameters() const override {
    const double infinity = rounding::infinity;
    return {{"left.density", 1, 0, infinity, false, true, "kg/m^3", "density for x < 0 (0: vacuum)"},
            {"left.velocity", 0, -infinity, infinity, true, true, "m/s", "velocity for x < 0"},
            {"left.pressure", 1, 0, infinity, false, true, "Pa", "pressure for x < 0"},
            {"right.density", 0.125, 0, infinity, false, true, "kg/m^3", "density for x > 0 (0: vacuum)"},
            {"right.velocity", 0, -infinity, infinity, true, true, "m/s", "velocity for x > 0"},
            {"right.pressure", 0.1, 0, infinity, false, true, "Pa", "pressure for x > 0"},
            {"gamma", 1.4, 1, infinity, true, true, "1", "ratio of specific heats of both gases"}};
  }
  Parameter abscissa() const override {
    return {"xi", 0, -rounding::infinity, rounding::infinity, true, true, "m/s", "position over time, x/t"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const RiemannSolution solution({{s.at("left.density"), s.at("left.velocity"), s.at("left.pressure")},
                                    {s.at("right.density"), s.at("right.velocity"), s.at("right.pressure")},
                                    s.at("gamma")});
    Answer answer;
    answer.add("pressure_star", solution.star().pressure);
    answer.add("velocity_star", solution.star().velocity);
    answer.add("density_star_left", solution.star().density_left);
    answer.add("density_star_right", solution.star().density_right);
    for (double xi : at) {
      const Sample sample = solution.sample(xi);
      answer.at.push_back({{"xi", xi},
                           {"density", sample.density.value},
                           {"velocity", sample.velocity.value},
                           {"pressure", sample.pressure.value},
                           {"energy", sample.energy.value}});
      answer.at_bounds.push_back({{"density", sample.density.bound},
                                  {"velocity", sample.velocity.bound},
                                  {"pressure", sample.pressure.bound},
                                  {"energy", sample.energy.bound}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<RiemannReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::riemann
