// `plumbline reference bar-riemann`
#include "reference/bar_riemann.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::bar_riemann {
namespace {

class BarRiemannReference : public Reference {
 public:
  std::string name() const override { return "bar-riemann"; }
  std::string title() const override { return "Waves in a finite elastic bar from two constant states"; }
  std::string source() const override { return "J. d'Alembert; reflections by mirror images"; }

  std::vector<Parameter> parameters() const override {
    return {positive_parameter("youngs_modulus", 1e5, "Pa", "modulus of the law of the bar"),
            positive_parameter("density", 1, "kg/m^3", "density"),
            positive_parameter("area", 1, "m^2", "section"),
            positive_parameter("length", 1, "m", "the bar is [0, length]"),
            positive_parameter("middle", 0.5, "m", "where the left state ends and the right one begins"),
            finite_parameter("left.velocity", 1, "m/s", "velocity left of the middle"),
            finite_parameter("left.stress", 0, "Pa", "stress left of the middle"),
            finite_parameter("right.velocity", 0, "m/s", "velocity right of the middle"),
            finite_parameter("right.stress", 0, "Pa", "stress right of the middle"),
            {"left.fixed", 0, 0, 1, false, false, "1", "1: the left end is fixed, 0: free"},
            {"right.fixed", 0, 0, 1, false, false, "1", "1: the right end is fixed, 0: free"},
            time_parameter(1e-3)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    auto end = [&s](const char* key) { return switched_on(s, key) ? BarEnd::fixed : BarEnd::free; };
    const double middle = s.at("middle");
    if (!(middle < s.at("length"))) throw ParameterError("middle", middle, "inside the bar");
    BarRiemannProblem problem;
    problem.youngs_modulus = s.at("youngs_modulus");
    problem.density = s.at("density");
    problem.area = s.at("area");
    problem.length = s.at("length");
    problem.left_end = end("left.fixed");
    problem.right_end = end("right.fixed");
    problem.pieces = {{0, s.at("left.velocity"), s.at("left.stress")},
                      {middle, s.at("right.velocity"), s.at("right.stress")}};
    const BarRiemann bar(problem);
    Answer answer;
    answer.add("wave_speed", bar.wave_speed());
    answer.add("impedance", bar.impedance());
    answer.add("transit_time", bar.transit_time());
    answer.add("energy", bar.energy());
    answer.add("momentum", bar.momentum());
    for (double x : at) {
      const BarState state = bar.state(x, s.at("time"));
      add_row(answer, "position", x,
              {{"displacement", state.displacement}, {"velocity", state.velocity}, {"stress", state.stress}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<BarRiemannReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::bar_riemann
