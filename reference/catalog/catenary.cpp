// `plumbline reference catenary`
#include "reference/catenary.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::catenary {
namespace {

class CatenaryReference : public Reference {
 public:
  std::string name() const override { return "catenary"; }
  std::string title() const override { return "Heavy chain between supports of one height, inextensible or elastic"; }
  std::string source() const override { return "H. M. Irvine, Cable Structures, 1981, chapter 1 (elastic catenary)"; }

  std::vector<Parameter> parameters() const override {
    const CatenaryProblem p;
    return {positive_parameter("span", p.span, "m", "distance of the supports"),
            positive_parameter("length", p.length, "m", "unstretched length of the chain"),
            positive_parameter("weight", p.weight, "N/m", "weight per unstretched length"),
            {"compliance", p.compliance, 0, rounding::infinity, false, true, "1/N", "1/(E A); 0: inextensible"}};
  }
  Parameter abscissa() const override {
    return {"along", 0, 0, rounding::infinity, false, true, "m", "unstretched distance from the left support"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const Catenary chain({s.at("span"), s.at("length"), s.at("weight"), s.at("compliance")});
    Answer answer;
    answer.add("parameter", chain.parameter());
    answer.add("sag", chain.sag());
    answer.add("horizontal_force", chain.horizontal_force());
    answer.add("support_tension", chain.support_tension());
    answer.add("stretched_length", chain.stretched_length());
    for (double along : at) {
      add_row(answer, "along", along,
              {{"x", chain.x(along)},
               {"y", chain.y(along)},
               {"tension", chain.tension(along)},
               {"slope_angle", chain.slope_angle(along)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<CatenaryReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::catenary
