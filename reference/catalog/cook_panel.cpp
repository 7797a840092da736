// `plumbline reference cook-panel`: rows of single meshes.
#include "reference/cook_panel.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::cook_panel {
namespace {

class CookPanelReference : public Reference {
 public:
  std::string name() const override { return "cook-panel"; }
  std::string title() const override { return "Cook's tapered panel, clamped and sheared, in plane strain"; }
  std::string source() const override { return "R. D. Cook 1974; J. C. Simo, M. S. Rifai 1990"; }

  std::vector<Parameter> parameters() const override {
    const CookPanelProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson", p.poisson, 0, 0.5, false, true, "1", "Poisson's ratio"},
            positive_parameter("load", p.load, "N/m", "upwards, evenly over the right side, per thickness")};
  }
  Parameter abscissa() const override {
    return {"elements", 0, 2, 128, false, false, "1", "along each side of one mesh, a whole number"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const CookPanelProblem problem{s.at("youngs_modulus"), s.at("poisson"), s.at("load")};
    const CookPanel panel = reference::cook_panel(problem);
    Answer answer;
    answer.add("corner", panel.corner);
    answer.add("work", panel.work);
    for (const double elements : at) {
      const CookPanel one = cook_panel_on(problem, whole_number({{"elements", elements}}, "elements"));
      add_row(answer, "elements", elements, {{"corner", one.corner}, {"work", one.work}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<CookPanelReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::cook_panel
