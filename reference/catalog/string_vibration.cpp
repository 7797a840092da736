// `plumbline reference string-vibration`
#include "reference/string_vibration.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::string_vibration {
namespace {

class StringVibrationReference : public Reference {
 public:
  std::string name() const override { return "string-vibration"; }
  std::string title() const override {
    return "Small transverse vibration of a taut string between fixed ends, one mode";
  }
  std::string source() const override {
    return "Wave equation, c = sqrt(T/(rho A)); finite amplitude: G. Kirchhoff, Mechanik, lecture 29";
  }

  std::vector<Parameter> parameters() const override {
    const StringVibrationProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            positive_parameter("area", p.area, "m^2", "section of the taut string"),
            positive_parameter("density", p.density, "kg/m^3", "density of the taut string"),
            positive_parameter("strain", p.strain, "1", "strain of the taut string; tension E A strain"),
            positive_parameter("length", p.length, "m", "distance of the ends"),
            mode_parameter(p.mode),
            finite_parameter("amplitude", p.amplitude, "m", "largest displacement, at t = 0"),
            time_parameter(0)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const StringVibration string({s.at("youngs_modulus"), s.at("area"), s.at("density"), s.at("strain"), s.at("length"),
                                  whole_number(s, "mode"), s.at("amplitude")});
    const double time = s.at("time");
    Answer answer;
    answer.add("tension", string.tension());
    answer.add("wave_speed", string.wave_speed());
    answer.add("omega", string.omega());
    answer.add("period", string.period());
    answer.add("kirchhoff_period", string.kirchhoff_period());
    answer.add("unstretched_length", string.unstretched_length());
    answer.add("energy", string.energy());
    answer.add("kinetic_energy", string.kinetic_energy(time));
    for (double x : at) {
      add_row(answer, "position", x,
              {{"displacement", string.displacement(x, time)},
               {"velocity", string.velocity(x, time)},
               {"slope", string.slope(x, time)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<StringVibrationReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::string_vibration
