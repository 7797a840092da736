// `plumbline reference spring-mass`
#include "reference/heavy_spring.hpp"
#include "reference/registry.hpp"
#include "reference/spring.hpp"

namespace plumbline::reference::catalog::spring_mass {
namespace {

class SpringMassReference : public Reference {
 public:
  std::string name() const override { return "spring-mass"; }
  std::string title() const override {
    return "Mass on an elastic bar, gravity suddenly applied, bar without and with mass";
  }
  std::string source() const override {
    return "York, SAND97-1893, section 5.5 (massless); bar with a tip mass, x tan x = m_s/m, modal series";
  }

  std::vector<Parameter> parameters() const override {
    const double infinity = rounding::infinity;
    const SpringProblem york;
    return {{"youngs_modulus", york.youngs_modulus, 0, infinity, true, true, "Pa", "Young's modulus of the bar"},
            {"area", york.area, 0, infinity, true, true, "m^2", "section of the bar"},
            {"length", york.length, 0, infinity, true, true, "m", "unstretched length of the bar"},
            {"mass", york.mass, 0, infinity, true, true, "kg", "point mass at the lower end"},
            {"density", york.density, 0, infinity, false, true, "kg/m^3", "density of the bar (0: massless)"},
            {"gravity", york.gravity, -infinity, infinity, true, true, "m/s^2", "acceleration, along the bar"}};
  }
  Parameter abscissa() const override {
    return {"time", 0, 0, rounding::infinity, false, true, "s", "time since gravity was applied"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const SpringProblem problem{s.at("youngs_modulus"), s.at("area"),    s.at("length"),
                                s.at("mass"),           s.at("density"), s.at("gravity")};
    const MasslessSpring massless(problem);
    const HeavySpring heavy(problem);
    Answer answer;
    answer.add("omega_massless", massless.omega());
    answer.add("period_massless", massless.period());
    answer.add("max_displacement_massless", massless.max_displacement());
    answer.add("omega", heavy.omega());
    answer.add("period", heavy.period());
    answer.add("max_displacement", heavy.max_displacement());
    answer.add("static_displacement", heavy.static_displacement());
    for (double time : at) {
      const Bounded light = massless.displacement(time), full = heavy.displacement(time);
      answer.at.push_back({{"time", time}, {"displacement_massless", light.value}, {"displacement", full.value}});
      answer.at_bounds.push_back({{"displacement_massless", light.bound}, {"displacement", full.bound}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<SpringMassReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::spring_mass
