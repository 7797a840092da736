// `plumbline reference simple-wave`
#include "reference/simple_wave.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::simple_wave {
namespace {

class SimpleWaveReference : public Reference {
 public:
  std::string name() const override { return "simple-wave"; }
  std::string title() const override { return "Smooth pulse running into gas at rest, nonlinear, before it breaks"; }
  std::string source() const override {
    return "R. Courant, K. O. Friedrichs, Supersonic Flow and Shock Waves, 1948, sections 40 and 41";
  }

  std::vector<Parameter> parameters() const override {
    const SimpleWaveProblem p;
    const double infinity = rounding::infinity;
    return {{"amplitude", p.amplitude, -infinity, infinity, true, true, "m/s", "largest velocity of the pulse"},
            {"centre", p.centre, -infinity, infinity, true, true, "m", "its place at t = 0"},
            positive_parameter("half_width", p.half_width, "m", "distance from the centre to its ends at t = 0"),
            positive_parameter("density", p.density, "kg/m^3", "density of the gas at rest"),
            positive_parameter("pressure", p.pressure, "Pa", "pressure of the gas at rest"),
            gamma_parameter(p.gamma),
            time_parameter(0.3)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const SimpleWave wave(
        {s.at("amplitude"), s.at("centre"), s.at("half_width"), s.at("density"), s.at("pressure"), s.at("gamma")});
    Answer answer;
    answer.add("sound_speed", wave.sound_speed());
    answer.add("breaking_time", wave.breaking_time());
    for (double x : at) add_row(answer, "position", x, wave.sample(x, s.at("time")));
    return answer;
  }
};

const Registration registration{std::make_unique<SimpleWaveReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::simple_wave
