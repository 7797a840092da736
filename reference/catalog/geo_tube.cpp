// `plumbline reference geo-tube`
#include "reference/geo_tube.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::geo_tube {
namespace {

class GeoTubeReference : public Reference {
 public:
  std::string name() const override { return "geo-tube"; }
  std::string title() const override { return "Membrane tube filled with liquid on a flat floor (elastica)"; }
  std::string source() const override {
    return "R. H. Plaut, S. Suherman, Acta Mech. 129 (1998) 207; D. Leshchinsky et al., J. Geotech. Eng. 122 (1996) "
           "682";
  }

  std::vector<Parameter> parameters() const override {
    const GeoTubeProblem p;
    const double infinity = rounding::infinity;
    return {positive_parameter("perimeter", p.perimeter, "m", "length of the unstretched membrane around the tube"),
            {"specific_weight", p.specific_weight, 0, infinity, false, true, "N/m^3",
             "density of the liquid times gravity; 0: gas, the tube is round"},
            positive_parameter("top_pressure", p.top_pressure, "Pa", "at the top, over the pressure outside"),
            {"compliance", p.compliance, 0, infinity, false, true, "m/N",
             "strain per tension of the membrane, 1/(E' t); 0: inextensible"}};
  }
  Parameter abscissa() const override {
    return {
        "along", 0,    0,   rounding::infinity,
        false,   true, "m", "unstretched distance along the membrane from the middle of the floor, counter-clockwise"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const GeoTube tube({s.at("perimeter"), s.at("specific_weight"), s.at("top_pressure"), s.at("compliance")});
    Answer answer;
    answer.add("height", tube.height());
    answer.add("width", tube.width());
    answer.add("contact_width", tube.contact_width());
    answer.add("tension", tube.tension());
    answer.add("strain", tube.strain());
    answer.add("area", tube.area());
    answer.add("bottom_pressure", tube.bottom_pressure());
    for (double along : at) {
      const GeoTubePoint point = tube.at(along);
      add_row(answer, "along", along,
              {{"x", point.x},
               {"y", point.y},
               {"angle", point.angle},
               {"curvature", point.curvature},
               {"pressure", point.pressure}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<GeoTubeReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::geo_tube
