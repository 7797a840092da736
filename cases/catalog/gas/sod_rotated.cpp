// Sod's shock tube at an angle to the grid.
#include <cmath>
#include <numbers>

#include "cases/catalog/gas/fill_oblique.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"

namespace plumbline {
namespace {

// A square of gas, turned waves in its middle. Waves run from the sides with at most u* + c* = 2.19 m/s, by 0.313 m until
// the end; 0.36 leaves some cells for their width. What is judged is a strip along the normal through the centre, from
// behind the rarefaction's head (0.169 m left of the diaphragm) to beyond the shock (0.251 m right of it).
constexpr double half_length = 0.3, half_width = 0.1, from_sides = 0.36;  // m
constexpr double ahead_of_centre = -0.05;  // of the diaphragm, m: waves run further right
const double side = 2 * (std::hypot(half_length, half_width) + from_sides);

double radians(const Settings& settings) { return settings.number("angle") * std::numbers::pi / 180; }

class SodRotated final : public Case {
 public:
  std::string name() const override { return "sod-rotated"; }

  Kind kind() const override { return Kind::gas; }

  std::vector<Key> keys() const override {
    return {{.name = "angle",
             .value = 45.0,
             .unit = "degrees",
             .low = -180,
             .high = 180,
             .description = "of the waves' normal to the grid's x axis"},
            {.name = "t_end",
             .value = sod_tube.end_time,
             .unit = "s",
             .low = 0,
             .high = sod_tube.end_time,
             .low_open = true,
             .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    const double angle = radians(settings), c = std::cos(angle), s = std::sin(angle);
    const double h = 1 / settings.number("cells"), length = h * std::ceil(side / h);
    ShockTube centred = sod_tube;
    centred.low = -length / 2;
    centred.high = length / 2;
    centred.diaphragm = ahead_of_centre;
    centred.end_time = settings.number("t_end");
    GasFlow flow = tube_flow(centred);
    flow.dim = 2;
    flow.cells_along = 1;
    flow.low = {0, 0, 0};
    flow.high = {length, length, 0};
    flow.filled = false;
    flow.judged = Interval{-half_length, half_length};
    const auto from_centre = [length](const Position& x) {
      return std::array<double, 2>{x[0] - length / 2, x[1] - length / 2};
    };
    flow.coordinate = [=](const Position& x) {
      const auto r = from_centre(x);
      return c * r[0] + s * r[1];
    };
    flow.inside = [=](const Position& x) {
      const auto r = from_centre(x);
      return std::abs(c * r[1] - s * r[0]) <= half_width;
    };
    flow.direction = [=](const Position&) { return Position{c, s, 0}; };
    const ObliqueGas oblique{angle, {length / 2, length / 2, 0}, {centred.diaphragm}, flow.initial};
    flow.fill = [oblique](std::shared_ptr<const IdealGas> gas, const PointRule& rule, const GridSpec& grid) {
      return fill_oblique(std::move(gas), oblique, rule, grid);
    };
    return gas_problem(flow, settings);
  }

  std::vector<double> default_levels() const override { return {50, 60, 70, 85, 100}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "Shock and contact are jumps: order 1, whatever the angle.";
    const std::vector<double> few{50}, more{50, 100, 200};
    std::vector<StudyPlan> plans;
    for (const double angle : {0.0, 30.0, 45.0}) {
      plans.push_back({.id = "angle-" + to_text(angle),
                       .title = "default, waves at " + to_text(angle) + " degrees to the grid",
                       .why = why,
                       .overrides = {{"angle", angle}},
                       .values = few,
                       .full_values = more});
    }
    return plans;
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* study : {"angle-30", "angle-45"}) {
      for (const double level : {50.0, 100.0, 200.0}) all.push_back(isotropy_gate(study, level));
      all.push_back(energy_gate(study));
    }
    return all;
  }

 private:
  static CaseGate isotropy_gate(const std::string& study, double level) {
    CaseGate g = study_gate(
        study,
        declare(study + "/as-aligned-" + to_text(level), {0.9, 1.1}, Origin::requirement,
                "within 10 % of the aligned tube's error at the same h: at first order so much comes of cells a tenth "
                "larger"),
        [level](const StudyResult& s) {
          Measured measured;
          measured.value = error(s, level) / error(*s.sibling("angle-0"), level);
          return measured;
        },
        {level}, level > 50 ? Tier::full : Tier::quick);
    g.gate.quantity = "density.L1 over that of waves along the grid, at " + to_text(level);
    g.also = {"angle-0"};
    return g;
  }

  static double error(const StudyResult& s, double level) {
    const StudyLevel* at = s.level(level);
    const Measure* m = at ? at->run.find("density.L1") : nullptr;
    return m ? m->error : std::nan("");
  }
};

PLUMBLINE_CASE(SodRotated);

}  // namespace
}  // namespace plumbline
