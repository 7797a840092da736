// `plumbline reference bar-vibration`
#include "reference/bar_vibration.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::bar_vibration {
namespace {

class BarVibrationReference : public Reference {
 public:
  std::string name() const override { return "bar-vibration"; }
  std::string title() const override { return "Longitudinal vibration of an elastic bar, fixed and free, one mode"; }
  std::string source() const override { return "Wave equation, w = (2 n - 1) pi c/(2 L); D. Sulsky et al. 1994"; }

  std::vector<Parameter> parameters() const override {
    const BarVibrationProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "modulus of the law of the bar"),
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("area", p.area, "m^2", "section"),
            positive_parameter("length", p.length, "m", "length"),
            finite_parameter("velocity", p.velocity, "m/s", "largest velocity, at t = 0"),
            mode_parameter(p.mode),
            time_parameter(0)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const BarVibration bar({s.at("youngs_modulus"), s.at("density"), s.at("area"), s.at("length"), s.at("velocity"),
                            whole_number(s, "mode")});
    const double time = s.at("time");
    Answer answer;
    answer.add("wave_speed", bar.wave_speed());
    answer.add("omega", bar.omega());
    answer.add("period", bar.period());
    answer.add("amplitude", bar.amplitude());
    answer.add("energy", bar.energy());
    answer.add("kinetic_energy", bar.kinetic_energy(time));
    answer.add("strain_energy", bar.strain_energy(time));
    answer.add("mean_velocity", bar.mean_velocity(time));
    for (double x : at) {
      add_row(answer, "position", x,
              {{"displacement", bar.displacement(x, time)},
               {"velocity", bar.velocity(x, time)},
               {"stress", bar.stress(x, time)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<BarVibrationReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::bar_vibration
