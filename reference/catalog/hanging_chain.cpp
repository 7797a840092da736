// `plumbline reference hanging-chain`
#include "reference/hanging_chain.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::hanging_chain {
namespace {

class HangingChainReference : public Reference {
 public:
  std::string name() const override { return "hanging-chain"; }
  std::string title() const override { return "Small transverse vibration of a heavy hanging chain, one mode"; }
  std::string source() const override {
    return "D. Bernoulli; H. Lamb, Hydrodynamics: w_n = j_{0,n}/2 sqrt(g/L), modes J0(2 w sqrt(s/g))";
  }

  std::vector<Parameter> parameters() const override {
    const HangingChainProblem p;
    return {positive_parameter("length", p.length, "m", "length of the chain"),
            positive_parameter("gravity", p.gravity, "m/s^2", "acceleration, along the chain"),
            positive_parameter("line_density", p.line_density, "kg/m", "mass per length"),
            mode_parameter(p.mode),
            finite_parameter("amplitude", p.amplitude, "m", "displacement of the free end at t = 0"),
            time_parameter(0)};
  }
  Parameter abscissa() const override {
    return {"position", 0, 0, rounding::infinity, false, true, "m", "distance from the free end"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const HangingChain chain(
        {s.at("length"), s.at("gravity"), s.at("line_density"), whole_number(s, "mode"), s.at("amplitude")});
    const double time = s.at("time");
    Answer answer;
    answer.add("zero", chain.zero());
    answer.add("omega", chain.omega());
    answer.add("period", chain.period());
    answer.add("energy", chain.energy());
    answer.add("kinetic_energy", chain.kinetic_energy(time));
    for (double x : at) {
      add_row(answer, "position", x,
              {{"displacement", chain.displacement(x, time)},
               {"velocity", chain.velocity(x, time)},
               {"slope", chain.slope(x, time)},
               {"tension", chain.tension(x)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<HangingChainReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::hanging_chain
