// `plumbline reference bar-impact`
#include "reference/bar_impact.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::bar_impact {
namespace {

class BarImpactReference : public Reference {
 public:
  std::string name() const override { return "bar-impact"; }
  std::string title() const override { return "Two equal elastic bars meet end to end and part"; }
  std::string source() const override {
    return "J. d'Alembert: contact for 2 L/c under -rho c v/2, restitution 1; sizes of York, SAND97-1893, A.1.5";
  }

  std::vector<Parameter> parameters() const override {
    const BarImpactProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "modulus of the law of the bars"),
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("area", p.area, "m^2", "section"),
            positive_parameter("length", p.length, "m", "length of each bar"),
            finite_parameter("left", p.left, "m", "left end of the left bar"),
            {"gap", p.gap, 0, rounding::infinity, false, true, "m", "between the bars at t = 0"},
            finite_parameter("velocity_left", p.velocity_left, "m/s", "of the left bar"),
            finite_parameter("velocity_right", p.velocity_right, "m/s", "of the right bar"),
            time_parameter(0.2538)};
  }
  Parameter abscissa() const override {
    return {"distance", 0, 0, rounding::infinity, false, true, "m", "from the ends that meet, in each unstretched bar"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const BarImpactProblem p{s.at("youngs_modulus"), s.at("density"), s.at("area"),          s.at("length"),
                             s.at("left"),           s.at("gap"),     s.at("velocity_left"), s.at("velocity_right")};
    const BarImpact impact(p);
    const double time = s.at("time");
    Answer answer;
    answer.add("wave_speed", impact.wave_speed());
    answer.add("contact_time", impact.contact_time());
    answer.add("release_time", impact.release_time());
    answer.add("contact_duration", impact.contact_duration());
    answer.add("contact_stress", impact.contact_stress());
    answer.add("restitution", impact.restitution());
    answer.add("kinetic_energy", impact.kinetic_energy(time));
    answer.add("strain_energy", impact.strain_energy(time));
    for (double x : at) {
      const BarState left = impact.state_from_contact(ImpactBar::left, x, time);
      const BarState right = impact.state_from_contact(ImpactBar::right, x, time);
      add_row(answer, "distance", x,
              {{"displacement_left", left.displacement},
               {"velocity_left", left.velocity},
               {"stress_left", left.stress},
               {"displacement_right", right.displacement},
               {"velocity_right", right.velocity},
               {"stress_right", right.stress}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<BarImpactReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::bar_impact
