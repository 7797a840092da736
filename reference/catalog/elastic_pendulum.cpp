// `plumbline reference elastic-pendulum`
#include "reference/elastic_pendulum.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::elastic_pendulum {
namespace {

class ElasticPendulumReference : public Reference {
 public:
  std::string name() const override { return "elastic-pendulum"; }
  std::string title() const override { return "Bob on an elastic string, started at rest"; }
  std::string source() const override {
    return "York, SAND97-1893, sections 5.7, A.4.5; rigid: L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed., section "
           "11";
  }

  std::vector<Parameter> parameters() const override {
    const ElasticPendulumProblem p;
    return {
        finite_parameter("pivot_x", p.pivot_x, "m", "pivot"),
        finite_parameter("pivot_y", p.pivot_y, "m", "pivot"),
        finite_parameter("bob_x", p.bob_x, "m", "bob at t = 0"),
        finite_parameter("bob_y", p.bob_y, "m", "bob at t = 0, below the pivot"),
        positive_parameter("mass", p.mass, "kg", "bob"),
        positive_parameter("gravity", p.gravity, "m/s^2", "acceleration along -y"),
        positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus of the string"),
        positive_parameter("area", p.area, "m^2", "section of the string"),
        {"density", p.density, 0, rounding::infinity, false, true, "kg/m^3", "of the string, for heavy_period alone"},
        {"strain", p.strain, -0.1, 0.1, true, true, "1", "of the string at t = 0"},
        {"one_way", p.one_way ? 1.0 : 0.0, 0, 1, false, false, "1", "1: the string carries no pressure, 0: it does"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const ElasticPendulum pendulum({s.at("pivot_x"), s.at("pivot_y"), s.at("bob_x"), s.at("bob_y"), s.at("mass"),
                                    s.at("gravity"), s.at("youngs_modulus"), s.at("area"), s.at("density"),
                                    s.at("strain"), switched_on(s, "one_way")});
    const std::vector<PendulumExtreme> turns = pendulum.extremes(2);
    const std::vector<Bounded> crossings = pendulum.crossings(2);
    Answer answer;
    answer.add("period", turns[2].time);
    answer.add("heavy_period", turns[2].time * pendulum.string_factor());
    answer.add("rigid_period", pendulum.rigid_period());
    answer.add("other_side_time", turns[1].time);
    answer.add("other_side_angle", turns[1].angle);
    answer.add("return_angle", turns[2].angle);
    answer.add("first_crossing", crossings[0]);
    answer.add("second_crossing", crossings[1]);
    answer.add("angle", pendulum.angle());
    answer.add("rest_length", pendulum.rest_length());
    answer.add("stiffness", pendulum.stiffness());
    answer.add("axial_omega", pendulum.axial_omega());
    for (double time : at) {
      const PendulumState state = pendulum.at(time);
      add_row(answer, "time", time,
              {{"x", state.x},
               {"y", state.y},
               {"velocity_x", state.velocity_x},
               {"velocity_y", state.velocity_y},
               {"angle", state.angle},
               {"length", state.length},
               {"tension", state.tension}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<ElasticPendulumReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::elastic_pendulum
