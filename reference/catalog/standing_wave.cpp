// `plumbline reference standing-wave`
#include "reference/standing_wave.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::standing_wave {
namespace {

class StandingWaveReference : public Reference {
 public:
  std::string name() const override { return "standing-wave"; }
  std::string title() const override {
    return "A standing sound wave in an ideal gas, to second order in its amplitude";
  }
  std::string source() const override { return "L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 64"; }

  std::vector<Parameter> parameters() const override {
    const StandingWaveProblem p;
    const double infinity = rounding::infinity;
    return {{"amplitude", p.amplitude, -infinity, infinity, true, true, "m/s", "largest velocity at t = 0"},
            positive_parameter("wavenumber", p.wavenumber, "1/m", "k of sin(k x)"),
            positive_parameter("density", p.density, "kg/m^3", "density at rest"),
            positive_parameter("pressure", p.pressure, "Pa", "pressure at rest"),
            gamma_parameter(p.gamma),
            time_parameter(1)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const StandingWave wave({s.at("amplitude"), s.at("wavenumber"), s.at("density"), s.at("pressure"), s.at("gamma")});
    Answer answer;
    answer.add("sound_speed", wave.sound_speed());
    answer.add("period", wave.period());
    for (double x : at) add_row(answer, "position", x, wave.sample(x, s.at("time")));
    return answer;
  }
};

const Registration registration{std::make_unique<StandingWaveReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::standing_wave
