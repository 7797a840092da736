// Sod's shock tube at an angle to the grid.
#include <array>
#include <cmath>
#include <numbers>

#include "cases/catalog/gas/fill_oblique.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/sod_tube.hpp"
#include "cases/harness/description/parameters.hpp"

namespace plumbline::sod_rotated {
namespace {

// A square of gas, turned waves in its middle. Waves run from the sides with at most u* + c* = 2.19 m/s, by 0.313 m
// until the end; 0.36 leaves some cells for their width. What is judged is a strip along the normal through the centre,
// from behind the rarefaction's head (0.169 m left of the diaphragm) to beyond the shock (0.251 m right of it).
constexpr double half_length = 0.3, half_width = 0.1, from_sides = 0.36;  // m
constexpr double ahead_of_centre = -0.05;  // of the diaphragm, m: waves run further right
const double side = 2 * (std::hypot(half_length, half_width) + from_sides);

struct Turned : Parameters {
  using Parameters::Parameters;
  double degrees = number({.name = "angle",
                           .value = 45.0,
                           .unit = "degrees",
                           .low = -180,
                           .high = 180,
                           .description = "of the waves' normal to the grid's x axis"});
  double end_time = within("t_end", sod_tube.end_time, "s", 0, sod_tube.end_time, "end time");
};

GasFlow turned_flow(const Settings& settings) {
  const Turned turned(settings);
  const double angle = turned.degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const double h = 1 / settings.number("cells"), length = h * std::ceil(side / h);
  ShockTube centred = sod_tube;
  centred.low = -length / 2;
  centred.high = length / 2;
  centred.diaphragm = ahead_of_centre;
  centred.end_time = turned.end_time;
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
  return flow;
}

std::vector<StudyPlan> studies() {
  std::vector<StudyPlan> plans;
  for (const double angle : {0.0, 30.0, 45.0}) {
    plans.push_back(study("angle-" + to_text(angle), "default, waves at " + to_text(angle) + " degrees to the grid",
                          "Shock and contact are jumps: order 1, whatever the angle.", {50})
                        .with({{"angle", angle}})
                        .in_full({50, 100, 200}));
  }
  return plans;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string turned : {"angle-30", "angle-45"}) {
    for (const double level : {50.0, 100.0, 200.0}) {
      all.push_back(gate(turned + "/as-aligned-" + to_text(level),
                         error_over("density.L1", "angle-0", "waves along the grid", level), between(0.9, 1.1),
                         requirement("within 10 % of the aligned tube's error at the same h: at first order so much "
                                     "comes of cells a tenth larger"))
                        .beside({"angle-0"})
                        .in(level > 50 ? Tier::full : Tier::quick));
    }
    all.push_back(energy_gate(turned));
  }
  return all;
}

Case sod_rotated() {
  return {.name = "sod-rotated",
          .kind = Kind::gas,
          .keys = Turned().keys(),
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run(turned_flow),
          .studies = studies(),
          .gates = gates(),
          .levels = {50, 60, 70, 85, 100}};
}
PLUMBLINE_CASE(sod_rotated);

}  // namespace
}  // namespace plumbline::sod_rotated
