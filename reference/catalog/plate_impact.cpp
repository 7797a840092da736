// `plumbline reference plate-impact`
#include "reference/plate_impact.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::plate_impact {
namespace {

class PlateImpactReference : public Reference {
 public:
  std::string name() const override { return "plate-impact"; }
  std::string title() const override {
    return "Elastic and plastic shock in a plate that strikes a rigid wall, at finite strains";
  }
  std::string source() const override {
    return "D. S. Wood, J. Appl. Mech. 19 (1952) 521; Wang Li-Li, Foundations of Stress Waves, 2007; Simo 1992, doi "
           "10.1016/0045-7825(92)90123-2";
  }

  std::vector<Parameter> parameters() const override {
    const PlateImpactProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "E"),
            {"poissons_ratio", p.poissons_ratio, -1, 0.5, true, true, "1", "nu"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("yield_stress", p.yield_stress, "Pa", "Y"),
            {"hardening_modulus", p.hardening_modulus, 0, rounding::infinity, false, true, "Pa", "H"},
            positive_parameter("velocity", p.velocity, "m/s", "of the plate, towards the wall"),
            time_parameter(3.4e-7)};
  }
  Parameter abscissa() const override {
    return {"place", 0, 0, rounding::infinity, false, true, "m", "in the undeformed plate, from the face that strikes"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PlateImpact impact({s.at("youngs_modulus"), s.at("poissons_ratio"), s.at("density"), s.at("yield_stress"),
                              s.at("hardening_modulus"), s.at("velocity")});
    const PlateState &ahead = impact.precursor(), &behind = impact.plateau();
    Answer answer;
    answer.add("elastic_speed", impact.elastic_speed());
    answer.add("plastic_speed", impact.plastic_speed());
    answer.add("precursor_stress", ahead.stress);
    answer.add("precursor_velocity", ahead.velocity);
    answer.add("plateau_stretch", behind.stretch);
    answer.add("plateau_stress", behind.stress);
    answer.add("plateau_lateral_stress", behind.lateral_stress);
    answer.add("plateau_plastic_strain", behind.plastic_strain);
    for (double x : at) {
      const PlateState state = impact.state(x, s.at("time"));
      add_row(answer, "place", x,
              {{"velocity", state.velocity},
               {"stress", state.stress},
               {"lateral_stress", state.lateral_stress},
               {"plastic_strain", state.plastic_strain}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<PlateImpactReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::plate_impact
