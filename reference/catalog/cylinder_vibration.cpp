// `plumbline reference cylinder-vibration`
#include "reference/cylinder_vibration.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::cylinder_vibration {
namespace {

class CylinderVibrationReference : public Reference {
 public:
  std::string name() const override { return "cylinder-vibration"; }
  std::string title() const override {
    return "Radial vibration of a solid elastic cylinder in plane strain, one mode";
  }
  std::string source() const override { return "A. E. H. Love 1927, chapter XII; K. F. Graff 1975, section 8.2"; }

  std::vector<Parameter> parameters() const override {
    const CylinderVibrationProblem p;
    return {positive_parameter("radius", p.radius, "m", "of the cylinder"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson", p.poisson, -1, 0.5, true, true, "1", "Poisson's ratio"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            finite_parameter("velocity", p.velocity, "m/s", "radial, of the surface at t = 0"),
            mode_parameter(p.mode),
            time_parameter(0)};
  }
  Parameter abscissa() const override {
    return {"radius_at_rest", 0, 0, rounding::infinity, false, true, "m", "distance from the axis"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const CylinderVibration cylinder({s.at("radius"), s.at("youngs_modulus"), s.at("poisson"), s.at("density"),
                                      s.at("velocity"), whole_number(s, "mode")});
    const double time = s.at("time");
    Answer answer;
    answer.add("wave_speed", cylinder.wave_speed());
    answer.add("wavenumber", cylinder.wavenumber());
    answer.add("omega", cylinder.omega());
    answer.add("period", cylinder.period());
    answer.add("amplitude", cylinder.amplitude());
    answer.add("energy", cylinder.energy());
    for (double r : at) {
      add_row(answer, "radius_at_rest", r,
              {{"displacement", cylinder.displacement(r, time)},
               {"velocity", cylinder.velocity(r, time)},
               {"radial_stress", cylinder.radial_stress(r, time)},
               {"hoop_stress", cylinder.hoop_stress(r, time)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<CylinderVibrationReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::cylinder_vibration
