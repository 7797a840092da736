// `plumbline reference shear-decay`
#include "reference/shear_decay.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::shear_decay {
namespace {

class ShearDecayReference : public Reference {
 public:
  std::string name() const override { return "shear-decay"; }
  std::string title() const override { return "Viscous decay of a transverse cosine of velocity in an ideal gas"; }
  std::string source() const override {
    return "L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 24; stress of York, SAND97-1893, eq. 4.1";
  }

  std::vector<Parameter> parameters() const override {
    const ShearDecayProblem p;
    const double infinity = rounding::infinity;
    return {{"amplitude", p.amplitude, -infinity, infinity, true, true, "m/s", "largest velocity at t = 0"},
            positive_parameter("wavenumber", p.wavenumber, "1/m", "k of cos(k x)"),
            {"viscosity", p.viscosity, 0, infinity, false, true, "Pa s", "shear viscosity"},
            positive_parameter("density", p.density, "kg/m^3", "density at t = 0"),
            positive_parameter("pressure", p.pressure, "Pa", "pressure at t = 0"),
            gamma_parameter(p.gamma),
            time_parameter(1)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const ShearDecay shear(
        {s.at("amplitude"), s.at("wavenumber"), s.at("viscosity"), s.at("density"), s.at("pressure"), s.at("gamma")});
    const double time = s.at("time");
    Answer answer;
    answer.add("decay_rate", shear.decay_rate());
    answer.add("heat", shear.heat(time));
    for (double x : at) {
      add_row(answer, "position", x, shear.sample(x, time));
      const Bounded along = shear.longitudinal_velocity(x, time);
      answer.at.back().emplace_back("velocity_along", along.value);
      answer.at_bounds.back().emplace_back("velocity_along", along.bound);
    }
    return answer;
  }
};

const Registration registration{std::make_unique<ShearDecayReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::shear_decay
