// `plumbline reference gas-sphere`
#include "reference/gas_sphere.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::gas_sphere {
namespace {

class GasSphereReference : public Reference {
 public:
  std::string name() const override { return "gas-sphere"; }
  std::string title() const override { return "Breathing of a thin sphere around a gas at rest, small"; }
  std::string source() const override {
    return "acoustics of a ball (spherical Bessel functions) with the sheet's equation of motion, derived";
  }

  std::vector<Parameter> parameters() const override {
    const GasSphereProblem p;
    return {positive_parameter("youngs_modulus", p.sheet.youngs_modulus, "Pa", "Young's modulus of the sheet"),
            {"poisson_ratio", p.sheet.poisson_ratio, -1, 0.5, true, false, "1", "of the sheet"},
            positive_parameter("thickness", p.sheet.thickness, "m", "of the sheet at rest"),
            positive_parameter("density", p.sheet.density, "kg/m^3", "of the sheet at rest"),
            positive_parameter("radius", p.sheet.radius, "m", "of the sphere without pressure"),
            {"stretch", p.sheet.stretch, 1, rounding::infinity, true, true, "1", "of the sheet under the pressure"},
            {"neo_hookean", 0, 0, 1, false, false, "1", "0: St. Venant and Kirchhoff, 1: incompressible neo-Hookean"},
            positive_parameter("gas_density", p.gas_density, "kg/m^3", "gas at rest under the pressure"),
            {"gamma", p.gamma, 1, rounding::infinity, true, true, "1", "ratio of the gas's specific heats"},
            finite_parameter("velocity", p.velocity, "m/s", "of the sheet, at t = 0 of a mode"),
            {"mode", 1, 1, GasSphere::most_mode, false, false, "1", "of the rows, a whole number from 1"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    GasSphereProblem problem;
    problem.sheet = {.youngs_modulus = s.at("youngs_modulus"),
                     .poisson_ratio = s.at("poisson_ratio"),
                     .thickness = s.at("thickness"),
                     .density = s.at("density"),
                     .radius = s.at("radius"),
                     .stretch = s.at("stretch"),
                     .neo_hookean = whole_number(s, "neo_hookean") == 1};
    problem.gas_density = s.at("gas_density");
    problem.gamma = s.at("gamma");
    problem.velocity = s.at("velocity");
    const GasSphere sphere(problem);
    const int mode = whole_number(s, "mode");
    Answer answer;
    answer.add("pressure", sphere.pressure());
    answer.add("resultant", sphere.resultant());
    answer.add("sheet_stiffness", sphere.sheet_stiffness());
    answer.add("dry_omega", sphere.dry_omega());
    answer.add("quasi_static_omega", sphere.quasi_static_omega());
    for (int n = 1; n <= 10; ++n) answer.add("omega_" + std::to_string(n), sphere.omega(n));
    answer.add("shape_half", sphere.shape(0.5 * sphere.radius().value, mode));
    answer.add("pressure_shape_centre", sphere.pressure_shape(0, mode));
    for (double time : at) add_row(answer, "time", time, {{"velocity", sphere.velocity(time, mode)}});
    return answer;
  }
};

const Registration registration{std::make_unique<GasSphereReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::gas_sphere
