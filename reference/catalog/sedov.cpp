// `plumbline reference sedov`
#include "reference/sedov.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::sedov {
namespace {

class SedovReference : public Reference {
 public:
  std::string name() const override { return "sedov"; }
  std::string title() const override { return "Strong explosion from a plane, line or point in a uniform cold gas"; }
  std::string source() const override {
    return "L. I. Sedov, Similarity and Dimensional Methods in Mechanics, 1959, chapter IV; J. R. Kamm, F. X. Timmes, "
           "LA-UR-07-2849, 2007";
  }

  std::vector<Parameter> parameters() const override {
    const SedovProblem p;
    return {
        dimension_parameter(p.dimension), gamma_parameter(p.gamma),
        positive_parameter("density", p.density, "kg/m^3", "density of the gas at rest"),
        positive_parameter("energy", p.energy, "J", "energy of the whole flow, per area or length of a plane, line"),
        positive_parameter("time", 1, "s", "time since the explosion")};
  }
  Parameter abscissa() const override { return radius_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const Sedov sedov({dimension_of(s), s.at("gamma"), s.at("density"), s.at("energy")});
    const double time = s.at("time");
    const Sample behind = sedov.behind(time);
    Answer answer;
    answer.add("alpha", sedov.alpha());
    answer.add("shock_radius", sedov.shock_radius(time));
    answer.add("shock_speed", sedov.shock_speed(time));
    answer.add("density_behind", behind.density);
    answer.add("velocity_behind", behind.velocity);
    answer.add("pressure_behind", behind.pressure);
    for (double radius : at) add_row(answer, "radius", radius, sedov.sample(radius, time));
    return answer;
  }
};

const Registration registration{std::make_unique<SedovReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::sedov
