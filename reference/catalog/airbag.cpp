// `plumbline reference airbag`
#include "reference/airbag_lumped.hpp"
#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::airbag {
namespace {

class AirbagReference : public Reference {
 public:
  std::string name() const override { return "airbag"; }
  std::string title() const override {
    return "Flat probe on a gas-filled inextensible bag, lumped: bounds the displacement from above";
  }
  std::string source() const override {
    return "York, SAND97-1893, section 6.3 (problem); I. M. Mladenov, J. Oprea, Amer. Math. Monthly 110 (2003) 761 "
           "(shape of the free bag)";
  }

  std::vector<Parameter> parameters() const override {
    const AirbagProblem p;
    const double infinity = rounding::infinity;
    return {positive_parameter("mass", p.mass, "kg", "probe"),
            positive_parameter("probe_radius", p.probe_radius, "m", "of its flat face"),
            positive_parameter("speed", p.speed, "m/s", "of the probe at first touch"),
            positive_parameter("meridian", p.meridian, "m", "length of the skin from pole to pole"),
            {"height", p.height, 0, infinity, false, true, "m", "gap at first touch; 0: that of the untouched bag"},
            {"gamma", p.gamma, 1, infinity, true, true, "1", "ratio of specific heats"},
            positive_parameter("pressure", p.pressure, "Pa", "absolute, in the bag at first touch"),
            {"ambient_pressure", p.ambient_pressure, 0, infinity, false, true, "Pa", "absolute, outside"},
            {"gas_volume", p.gas_volume, 0, infinity, false, true, "m^3",
             "for displacement_limit alone: volume at first touch of a bag in another shape; 0: start_volume"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const AirbagLumped airbag({s.at("mass"), s.at("probe_radius"), s.at("speed"), s.at("meridian"), s.at("height"),
                               s.at("gamma"), s.at("pressure"), s.at("ambient_pressure"), s.at("gas_volume")});
    Answer answer;
    answer.add("max_displacement", airbag.max_displacement());
    answer.add("time_of_max", airbag.time_of_max());
    answer.add("contact_duration", airbag.contact_duration());
    answer.add("rebound_speed", airbag.rebound_speed());
    answer.add("peak_force", airbag.peak_force());
    answer.add("peak_pressure", airbag.peak_pressure());
    answer.add("least_volume", airbag.least_volume());
    answer.add("start_height", airbag.start_height());
    answer.add("start_volume", airbag.start_volume());
    answer.add("free_height", airbag.bag().free_height());
    answer.add("free_radius", airbag.bag().free_radius());
    answer.add("displacement_limit", airbag.displacement_limit());
    for (double time : at) {
      const AirbagState state = airbag.at(time);
      add_row(answer, "time", time,
              {{"displacement", state.displacement},
               {"velocity", state.velocity},
               {"force", state.force},
               {"pressure", state.pressure},
               {"volume", state.volume},
               {"plate_radius", state.plate_radius},
               {"equator", state.equator}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<AirbagReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::airbag
