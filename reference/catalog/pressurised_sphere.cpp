// `plumbline reference pressurised-sphere`
#include "reference/pressurised_sphere.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::pressurised_sphere {
namespace {

class PressurisedSphereReference : public Reference {
 public:
  std::string name() const override { return "pressurised-sphere"; }
  std::string title() const override { return "Thin sphere under constant pressure: its balance and its breathing"; }
  std::string source() const override {
    return "W. E. Baker, J. Acoust. Soc. Am. 33 (1961) 1749 (breathing of a shell); I. Mueller, P. Strehlow, Rubber "
           "and "
           "Rubber Balloons (2004) (balloon); derived";
  }

  std::vector<Parameter> parameters() const override {
    const PressurisedSphereProblem p;
    return {
        positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
        {"poisson_ratio", p.poisson_ratio, -1, 0.5, true, false, "1", "not of the neo-Hookean"},
        positive_parameter("thickness", p.thickness, "m", "at rest"),
        positive_parameter("density", p.density, "kg/m^3", "at rest"),
        positive_parameter("radius", p.radius, "m", "at rest"),
        positive_parameter("stretch", p.stretch, "1", "of every tangent, where the sphere rests under its pressure"),
        {"neo_hookean", 0, 0, 1, false, false, "1",
         "0: St. Venant and Kirchhoff in plane stress, 1: incompressible neo-Hookean, mu = E/3"},
        finite_parameter("amplitude", 0, "1", "stretch beyond the one at rest, at which the sphere is released")};
  }
  Parameter abscissa() const override {
    return positive_parameter("at_stretch", 0, "1", "of every tangent, at rest under the pressure of the row");
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PressurisedSphere sphere({s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"), s.at("density"),
                                    s.at("radius"), s.at("stretch"), switched_on(s, "neo_hookean")});
    Answer answer;
    const double amplitude = s.at("amplitude");
    answer.add("pressure", sphere.pressure());
    answer.add("resultant", sphere.resultant());
    answer.add("omega", sphere.omega());
    if (amplitude != 0 || sphere.omega().value > 0) {
      answer.add("period", sphere.period(amplitude));
      answer.add("turning_stretch", sphere.turning_stretch(amplitude));
    }
    for (double l : at) {
      add_row(answer, "at_stretch", l,
              {{"pressure", sphere.pressure(l)}, {"resultant", sphere.resultant(l)}, {"stress", sphere.stress(l)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<PressurisedSphereReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::pressurised_sphere
