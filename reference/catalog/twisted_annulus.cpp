// `plumbline reference twisted-annulus`
#include "reference/twisted_annulus.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::twisted_annulus {
namespace {

class TwistedAnnulusReference : public Reference {
 public:
  std::string name() const override { return "twisted-annulus"; }
  std::string title() const override { return "Ring of membrane that wrinkles, one rim turned against the other"; }
  std::string source() const override {
    return "E. Reissner, Proc. 5th Int. Congr. Appl. Mech. (1938) 88, and M. Stein, J. M. Hedgepeth, NASA TN D-813 "
           "(1961), for small strains; derived";
  }

  std::vector<Parameter> parameters() const override {
    const TwistedAnnulusProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson_ratio", p.poisson_ratio, 0, 0.5, false, false, "1", "Poisson's ratio"},
            positive_parameter("thickness", p.thickness, "m", "at rest"),
            positive_parameter("inner_radius", p.inner_radius, "m", "of the rim that is turned"),
            positive_parameter("outer_radius", p.outer_radius, "m", "of the other rim, 1.02 to 50 times as large"),
            {"twist", p.twist, 1e-6, 3, false, false, "rad", "of the outer rim against the inner one"}};
  }
  Parameter abscissa() const override {
    return {"position", 0, 0, rounding::infinity, true, true, "m", "distance from the axis at rest"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const TwistedAnnulus ring({s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"), s.at("inner_radius"),
                               s.at("outer_radius"), s.at("twist")});
    Answer answer;
    answer.add("arm", ring.arm());
    answer.add("pull", ring.pull());
    answer.add("torque", ring.torque());
    answer.add("energy", ring.energy());
    for (const double position : at) {
      const AnnulusPoint p = ring.at(position);
      add_row(answer, "position", position,
              {{"radius", p.radius},
               {"turned", p.turned},
               {"stretch_along", p.along},
               {"stretch_across", p.across},
               {"stress", p.stress},
               {"angle_at_rest", p.rest},
               {"angle", p.now}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<TwistedAnnulusReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::twisted_annulus
