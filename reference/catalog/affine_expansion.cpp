// `plumbline reference affine-expansion`
#include "reference/affine_expansion.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::affine_expansion {
namespace {

class AffineExpansionReference : public Reference {
 public:
  std::string name() const override { return "affine-expansion"; }
  std::string title() const override { return "Gas slab, cylinder or sphere expanding into a vacuum, affine motion"; }
  std::string source() const override {
    return "L. V. Ovsiannikov, Dokl. Akad. Nauk SSSR 111 (1956) 47; F. J. Dyson, J. Math. Mech. 18 (1968) 91";
  }

  std::vector<Parameter> parameters() const override {
    const AffineExpansionProblem p;
    return {dimension_parameter(p.dimension),
            positive_parameter("edge", p.radius, "m", "radius of the edge (half thickness of a slab) at t = 0"),
            positive_parameter("density", p.density, "kg/m^3", "density at the centre at t = 0"),
            positive_parameter("pressure", p.pressure, "Pa", "pressure at the centre at t = 0"),
            gamma_parameter(p.gamma),
            time_parameter(0.005)};
  }
  Parameter abscissa() const override { return radius_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const AffineExpansion expansion({dimension_of(s), s.at("edge"), s.at("density"), s.at("pressure"), s.at("gamma")});
    const AffineGas gas = expansion.at(s.at("time"));
    Answer answer;
    answer.add("edge", gas.radius());
    answer.add("edge_speed", gas.edge_speed());
    answer.add("final_speed", expansion.final_speed());
    answer.add("density_centre", gas.centre().density);
    answer.add("pressure_centre", gas.centre().pressure);
    answer.add("mass", expansion.mass());
    answer.add("energy", expansion.energy());
    for (double radius : at) add_row(answer, "radius", radius, gas.sample(radius));
    return answer;
  }
};

const Registration registration{std::make_unique<AffineExpansionReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::affine_expansion
