// `plumbline reference bar-chain`
#include "reference/bar_chain.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::bar_chain {
namespace {

class BarChainReference : public Reference {
 public:
  std::string name() const override { return "bar-chain"; }
  std::string title() const override {
    return "String as a chain of bar elements with a heavy end: pendulum, spring or slack string; estimated error";
  }
  std::string source() const override { return "A. R. York II, SAND97-1893, section 5.7, Figures 36 and 37"; }
  std::vector<Parameter> parameters() const override {
    const BarChainProblem p;
    return {finite_parameter("support_x", p.support_x, "m", "of the fixed top"),
            finite_parameter("support_y", p.support_y, "m", "of the fixed top"),
            finite_parameter("end_x", p.end_x, "m", "of the heavy end at t = 0"),
            finite_parameter("end_y", p.end_y, "m", "of the heavy end at t = 0"),
            positive_parameter("mass", p.mass, "kg", "of the end"),
            positive_parameter("gravity", p.gravity, "m/s^2", "along -y"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus of the string"),
            positive_parameter("area", p.area, "m^2", "section of the string"),
            positive_parameter("density", p.density, "kg/m^3", "density of the string"),
            {"strain", p.strain, -0.5, 0.1, true, true, "1", "of all elements at t = 0"},
            {"one_way", p.one_way ? 1.0 : 0.0, 0, 1, false, false, "1", "1: elements carry no pressure; 0: they do"},
            {"elements", 8, 4, 400, false, false, "1", "a multiple of four"},
            {"tolerance", 1e-8, 1e-12, 1e-4, false, false, "1", "of a step"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const BarChainProblem problem{
        s.at("support_x"),        s.at("support_y"),      s.at("end_x"), s.at("end_y"),   s.at("mass"),
        s.at("gravity"),          s.at("youngs_modulus"), s.at("area"),  s.at("density"), s.at("strain"),
        switched_on(s, "one_way")};
    const BarChain chain(problem, whole_number(s, "elements"), s.at("tolerance"));
    const bool swings = problem.end_x != problem.support_x;
    const auto turns = chain.turns(swings ? ChainTurn::swing : ChainTurn::bounce, 2);
    Answer answer;
    answer.add("period", turns[2].time);
    answer.add("first_turn_time", turns[1].time);
    answer.add("first_turn_x", turns[1].x);
    answer.add("first_turn_y", turns[1].y);
    for (double time : at) {
      const BarChainState state = chain.at(time);
      add_row(answer, "time", time,
              {{"x", state.x},
               {"y", state.y},
               {"velocity_x", state.velocity_x},
               {"velocity_y", state.velocity_y},
               {"support_tension", state.support_tension},
               {"kinetic", state.kinetic},
               {"elastic", state.elastic},
               {"potential", state.potential}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<BarChainReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::bar_chain
