// `plumbline reference bar-stability`
#include "reference/bar_stability.hpp"

#include "reference/catalog/parameters.hpp"
#include "reference/catalog/stability_parameters.hpp"

namespace plumbline::reference::catalog::bar_stability {
namespace {

class BarStabilityReference : public Reference {
 public:
  std::string name() const override { return "bar-stability"; }
  std::string title() const override {
    return "Largest stable step of the material-point method on an elastic bar, one point a cell, closed form";
  }
  std::string source() const override {
    return "Von Neumann analysis of the whole step; A. R. York II, 1997, SAND97-1893, chapter 8, for his own bound";
  }
  std::vector<Parameter> parameters() const override {
    return {{"weight", 0.25, 0, 1, false, false, "1", "weight N of each point on the node above it"},
            integrator_parameter()};
  }
  Parameter abscissa() const override { return courant_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const double weight = s.at("weight");
    const StressUpdate update = stress_update(s);
    Answer answer;
    answer.add("courant_limit", frozen_courant_limit(update, weight));
    answer.add("york_limit", york_courant_limit(weight));
    answer.add("corner_limit_plane", corner_courant_limit(2));
    answer.add("corner_limit_solid", corner_courant_limit(3));
    for (double courant : at) {
      add_row(answer, "courant", courant, {{"growth", frozen_growth(update, weight, courant)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<BarStabilityReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::bar_stability
