// `plumbline reference tension-field`
#include "reference/tension_field.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::tension_field {
namespace {

class TensionFieldReference : public Reference {
 public:
  std::string name() const override { return "tension-field"; }
  std::string title() const override { return "Sheet that wrinkles, stretched and sheared, and its small vibration"; }
  std::string source() const override {
    return "A. C. Pipkin, IMA J. Appl. Math. 36 (1986) 85, doi 10.1093/imamat/36.1.85; derived";
  }

  std::vector<Parameter> parameters() const override {
    const TensionFieldProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson_ratio", p.poisson_ratio, -1, 0.5, true, false, "1", "Poisson's ratio"},
            positive_parameter("thickness", p.thickness, "m", "at rest"),
            positive_parameter("density", p.density, "kg/m^3", "at rest"),
            positive_parameter("stretch", p.stretch, "1", "of every tangent before the shear"),
            {"shear", p.shear, 0, 1, false, true, "1", "stretches are those before times 1 + shear and 1 - shear"},
            positive_parameter("half_side", p.half_side, "m", "of the square at rest, along the principal stretches"),
            {"along", 1, 1, 1000, false, false, "1", "half waves along the longer stretch"},
            {"across", 1, 1, 1000, false, false, "1", "half waves along the shorter stretch"}};
  }
  Parameter abscissa() const override {
    return {"at_shear", 0, 0, 1, false, true, "1", "shear of the row, by the same stretch"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const auto sheared = [&](double shear) {
      return TensionField({s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"), s.at("density"),
                           s.at("stretch"), shear, s.at("half_side")});
    };
    const TensionField sheet = sheared(s.at("shear"));
    Answer answer;
    answer.add("energy", sheet.energy());
    answer.add("stress_along", sheet.stress_along());
    answer.add("stress_across", sheet.stress_across());
    answer.add("resultant_along", sheet.resultant_along());
    answer.add("resultant_across", sheet.resultant_across());
    answer.add("omega", sheet.omega(whole_number(s, "along"), whole_number(s, "across")));
    for (const double shear : at) {
      const TensionField row = sheared(shear);
      add_row(answer, "at_shear", shear,
              {{"energy", row.energy()}, {"stress_along", row.stress_along()}, {"stress_across", row.stress_across()}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<TensionFieldReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::tension_field
