// `plumbline reference membrane-equilibrium`
#include "reference/membrane_equilibrium.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::membrane_equilibrium {
namespace {

using Row = std::vector<std::pair<std::string, Bounded>>;

Row entries(const MembraneState& s) {
  return {{"radius", s.radius},
          {"apothem", s.apothem},
          {"area", s.area},
          {"pressure", s.pressure},
          {"tension", s.tension},
          {"hoop_stress", s.stress},
          {"strain", s.strain},
          {"gas_energy", s.gas_energy},
          {"membrane_energy", s.membrane_energy},
          {"dry_omega", s.dry_omega},
          {"breathing_omega", s.breathing_omega},
          {"breathing_period", s.breathing_period}};
}

class MembraneEquilibriumReference : public Reference {
 public:
  std::string name() const override { return "membrane-equilibrium"; }
  std::string title() const override { return "End of the expansion of a gas in a closed membrane, at rest"; }
  std::string source() const override {
    return "York, SAND97-1893, section 6.2 (the problem); first law and balance of the membrane, derived";
  }

  std::vector<Parameter> parameters() const override {
    const MembraneEquilibriumProblem p;
    return {positive_parameter("gas_energy", p.gas_energy, "J/m", "of the quarter's gas at the start"),
            positive_parameter("gas_area", p.gas_area, "m^2", "of the quarter's gas at the start"),
            {"gamma", p.gamma, 1, rounding::infinity, true, true, "1", "ratio of the gas's specific heats"},
            positive_parameter("length", p.length, "m", "of the quarter's unstretched membrane"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus of the membrane"),
            {"poisson_ratio", p.poisson_ratio, -0.5, 0.5, true, true, "1", "of the membrane, held out of the plane"},
            positive_parameter("thickness", p.thickness, "m", "of the unstretched membrane"),
            positive_parameter("density", p.density, "kg/m^3", "of the unstretched membrane"),
            {"lost", p.lost, 0, rounding::infinity, false, true, "J/m", "energy that heats nothing, per quarter"},
            {"law", 0, 0, 1, false, false, "1", "tension by 0: stretch of segments, 1: accumulated strain"}};
  }
  Parameter abscissa() const override {
    return {"segments", 0, 1, 1e6, false, false, "1", "straight chords on the quarter, a whole number"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const MembraneEquilibrium end({s.at("gas_energy"), s.at("gas_area"), s.at("gamma"), s.at("length"),
                                   s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"), s.at("density"),
                                   s.at("lost"), static_cast<MembraneLaw>(whole_number(s, "law"))});
    Answer answer;
    for (const auto& [key, value] : entries(end.state())) answer.add(key, value);
    const MembraneState cold = end.isentropic();
    answer.add("isentropic_pressure", cold.pressure);
    answer.add("isentropic_radius", cold.radius);
    answer.add("isentropic_hoop_stress", cold.stress);
    answer.add("virial_stress", end.virial_stress());
    answer.add("membrane_volume", end.membrane_volume());
    answer.add("membrane_mass", end.membrane_mass());
    for (double n : at) {
      const int segments = static_cast<int>(n);
      if (n != segments) throw ParameterError("segments", n, "a whole number");
      add_row(answer, "segments", n, entries(end.state(segments)));
    }
    return answer;
  }
};

const Registration registration{std::make_unique<MembraneEquilibriumReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::membrane_equilibrium
