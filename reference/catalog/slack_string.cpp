// `plumbline reference slack-string`
#include "reference/slack_string.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::slack_string {
namespace {

class SlackStringReference : public Reference {
 public:
  std::string name() const override { return "slack-string"; }
  std::string title() const override { return "Mass on a massless string with slack: fall, taut swing, release, apex"; }
  std::string source() const override { return "York, SAND97-1893, section 5.6; closed form of the piecewise motion"; }

  std::vector<Parameter> parameters() const override {
    const SlackStringProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus of the string"),
            positive_parameter("area", p.area, "m^2", "section of the string"),
            positive_parameter("length", p.length, "m", "unstretched length of the string"),
            positive_parameter("mass", p.mass, "kg", "point mass at the lower end"),
            positive_parameter("gravity", p.gravity, "m/s^2", "acceleration, along the string"),
            {"slack", p.slack, 0, rounding::infinity, false, true, "m", "free fall until the string is straight"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const SlackString string(
        {s.at("youngs_modulus"), s.at("area"), s.at("length"), s.at("mass"), s.at("gravity"), s.at("slack")});
    Answer answer;
    answer.add("taut_time", string.taut_time());
    answer.add("release_time", string.release_time());
    answer.add("apex_time", string.apex_time());
    answer.add("taut_speed", string.taut_speed());
    answer.add("max_displacement", string.max_displacement());
    answer.add("max_tension", string.max_tension());
    for (double time : at) {
      add_row(answer, "time", time,
              {{"displacement", string.displacement(time)},
               {"velocity", string.velocity(time)},
               {"tension", string.tension(time)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<SlackStringReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::slack_string
