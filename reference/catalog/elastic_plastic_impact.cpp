// `plumbline reference elastic-plastic-impact`
#include "reference/elastic_plastic_impact.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::elastic_plastic_impact {
namespace {

class ElasticPlasticImpactReference : public Reference {
 public:
  std::string name() const override { return "elastic-plastic-impact"; }
  std::string title() const override { return "Elastic and plastic wave ahead of a piston in uniaxial strain"; }
  std::string source() const override {
    return "D. S. Wood, J. Appl. Mech. 19 (1952) 521; Wang Li-Li, Foundations of Stress Waves, 2007";
  }

  std::vector<Parameter> parameters() const override {
    const ElasticPlasticImpactProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "E"),
            {"poissons_ratio", p.poissons_ratio, -1, 0.5, true, true, "1", "nu"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("yield_stress", p.yield_stress, "Pa", "Y"),
            {"hardening_modulus", p.hardening_modulus, 0, rounding::infinity, false, true, "Pa", "H"},
            positive_parameter("velocity", p.velocity, "m/s", "of the piston, from rise_time on"),
            {"rise_time", p.rise_time, 0, rounding::infinity, false, true, "s", "over which it grows from zero"},
            time_parameter(2e-3)};
  }
  Parameter abscissa() const override {
    return {"position", 0, 0, rounding::infinity, false, true, "m", "place in the undeformed body"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const ElasticPlasticImpact impact({s.at("youngs_modulus"), s.at("poissons_ratio"), s.at("density"),
                                       s.at("yield_stress"), s.at("hardening_modulus"), s.at("velocity"),
                                       s.at("rise_time")});
    const ElasticPlasticState plateau = impact.plateau();
    Answer answer;
    answer.add("elastic_speed", impact.elastic_speed());
    answer.add("plastic_speed", impact.plastic_speed());
    answer.add("elastic_limit", impact.elastic_limit());
    answer.add("limit_velocity", impact.limit_velocity());
    answer.add("strain", impact.strain());
    answer.add("plateau_stress", plateau.stress);
    answer.add("plateau_lateral_stress", plateau.lateral_stress);
    answer.add("plateau_plastic_strain", plateau.plastic_strain);
    answer.add("heat", impact.heat(s.at("time")));
    for (double x : at) {
      const ElasticPlasticState state = impact.state(x, s.at("time"));
      add_row(answer, "position", x,
              {{"velocity", state.velocity},
               {"stress", state.stress},
               {"lateral_stress", state.lateral_stress},
               {"plastic_strain", state.plastic_strain}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<ElasticPlasticImpactReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::elastic_plastic_impact
