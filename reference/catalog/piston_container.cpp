// `plumbline reference piston-container`
#include "reference/piston_container.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::piston_container {
namespace {

class PistonContainerReference : public Reference {
 public:
  std::string name() const override { return "piston-container"; }
  std::string title() const override { return "Piston between a spring and a closed column of gas, small vibration"; }
  std::string source() const override {
    return "York, SAND97-1893, section 6.1 (massless spring); spring with mass and participation of the modes derived";
  }

  std::vector<Parameter> parameters() const override {
    const PistonContainerProblem p;
    return {positive_parameter("spring_modulus", p.spring_modulus, "Pa", "Young's modulus of the spring"),
            positive_parameter("spring_length", p.spring_length, "m", "length of the spring"),
            {"spring_density", p.spring_density, 0, rounding::infinity, false, true, "kg/m^3", "0: no mass"},
            positive_parameter("area", p.area, "m^2", "section of spring, piston and gas"),
            positive_parameter("mass", p.mass, "kg", "piston"),
            positive_parameter("gas_density", p.gas_density, "kg/m^3", "gas"),
            positive_parameter("bulk_modulus", p.bulk_modulus, "Pa", "of the gas: pressure per compression"),
            positive_parameter("gas_length", p.gas_length, "m", "length of the column of gas"),
            finite_parameter("velocity", p.velocity, "m/s", "of the piston at t = 0, all else at rest")};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PistonContainer system({s.at("spring_modulus"), s.at("spring_length"), s.at("spring_density"), s.at("area"),
                                  s.at("mass"), s.at("gas_density"), s.at("bulk_modulus"), s.at("gas_length"),
                                  s.at("velocity")});
    Answer answer;
    answer.add("stiffness", system.stiffness());
    answer.add("period", system.period());
    for (int n = 1; n <= 6; ++n) answer.add("omega_" + std::to_string(n), system.omega(n));
    for (int n = 1; n <= 6; ++n) answer.add("participation_" + std::to_string(n), system.participation(n));
    answer.add("modal_mass", system.modal_mass());
    answer.add("mode_energy", system.mode_energy());
    for (double time : at) {
      add_row(answer, "time", time,
              {{"displacement", system.displacement(time)},
               {"velocity", system.velocity(time)},
               {"mode_displacement", system.mode_displacement(time)},
               {"mode_velocity", system.mode_velocity(time)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<PistonContainerReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::piston_container
