// `plumbline reference piston-shock`
#include "reference/piston_shock.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::piston_shock {
namespace {

class PistonShockReference : public Reference {
 public:
  std::string name() const override { return "piston-shock"; }
  std::string title() const override { return "Shock ahead of a piston pushed at constant speed into gas at rest"; }
  std::string source() const override {
    return "Rankine-Hugoniot conditions: E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd "
           "ed., 2009, section 3.1.3";
  }

  std::vector<Parameter> parameters() const override {
    const PistonShockProblem p;
    return {positive_parameter("piston_velocity", p.piston_velocity, "m/s", "speed of the piston"),
            positive_parameter("density", p.density, "kg/m^3", "density of the gas at rest"),
            {"pressure", p.pressure, 0, rounding::infinity, false, true, "Pa", "pressure of the gas at rest"},
            gamma_parameter(p.gamma),
            time_parameter(0.2)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PistonShock piston({s.at("piston_velocity"), s.at("density"), s.at("pressure"), s.at("gamma")});
    Answer answer;
    answer.add("shock_speed", piston.shock_speed());
    answer.add("density_behind", piston.behind().density);
    answer.add("pressure_behind", piston.behind().pressure);
    answer.add("energy_behind", piston.behind().energy);
    for (double x : at) add_row(answer, "position", x, piston.sample(x, s.at("time")));
    return answer;
  }
};

const Registration registration{std::make_unique<PistonShockReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::piston_shock
