#include "cases/gas/tube_case.hpp"

#include <fmt/format.h>

#include "cases/gas/gas_case.hpp"

namespace plumbline {
namespace {

constexpr const char* frame =
    R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="A tube with a diaphragm between two gases">
<g fill="none" stroke="currentColor" stroke-width="1.5"><path d="M20 25h320M20 65h320"/><path d="M{0} 19v52" stroke-dasharray="4 3"/></g>
<rect x="20" y="25" width="{1}" height="40" fill="currentColor" opacity=".28"/><rect x="{0}" y="25" width="{2}" height="40" fill="currentColor" opacity=".06"/>
<g fill="currentColor" font-size="11"><text x="24" y="42">ρ {3}</text><text x="24" y="57">u {4}, p {5}</text>
<text x="336" y="42" text-anchor="end">ρ {6}</text><text x="336" y="57" text-anchor="end">u {7}, p {8}</text></g>
<g fill="currentColor" font-size="12" text-anchor="middle"><text x="20" y="85">{9}</text><text x="{0}" y="85">{10}</text><text x="340" y="85">{11}</text></g></svg>)svg";

std::string sketch(const ShockTube& tube) {
  const auto text = [](double x) { return fmt::format("{:.6g}", x); };
  const double at = 20 + 320 * (tube.diaphragm - tube.low) / (tube.high - tube.low);
  const auto& [left, right, gamma] = tube.states;
  return fmt::format(fmt::runtime(frame), text(at), text(at - 20), text(340 - at), text(left.density),
                     text(left.velocity), text(left.pressure), text(right.density), text(right.velocity),
                     text(right.pressure), text(tube.low), text(tube.diaphragm), text(tube.high));
}

constexpr const char* first_order =
    "Shock and contact are jumps: a scheme of any order spreads them over a number of cells, so L1 errors fall at most "
    "with h.";

std::string ends(const ShockTube& tube) {
  const bool left = tube.states.left.velocity != 0, right = tube.states.right.velocity != 0;
  if (!left && !right) return "No wave reaches the tube's ends before the end time.";
  const std::string which = left && right ? "both ends" : left ? "the left end" : "the right end";
  return "Gas moves through " + which +
         ": it goes on beyond, so far that nothing which the wall out there sends arrives in the tube. Errors are "
         "judged "
         "in the tube alone.";
}

}  // namespace

TubeCase::TubeCase(TubeDescription description, const char* file)
    : about_(std::move(description)),
      registered_(this, file) {}

Statement TubeCase::statement() const {
  Statement s;
  s.name = about_.name;
  s.title = about_.title;
  s.source = about_.source;
  s.claim = about_.claim;
  s.physics = about_.physics + "\n\n" + ends(about_.tube) +
              " Errors are volume-weighted means over the points, each judged where it stands; jumps are included.";
  if (!about_.near_vacuum.empty()) s.physics += "\n\n" + about_.near_vacuum;
  s.equations = gas_equations();
  s.sketch = sketch(about_.tube);
  s.cells_along = fmt::format("the tube's length of {:g} m", about_.tube.high - about_.tube.low);
  s.reference_name = "riemann";
  s.reference_text =
      "Exact solution of the Riemann problem; every point is sampled at (x − diaphragm)/t. At a jump the value on the "
      "right.";
  s.reference_bound = "Computed with each value: residual of the root over the slope, and rounding carried through.";
  s.theory_orders = first_order_at_jumps();
  s.known_limits = about_.known_limits;
  return s;
}

std::vector<Override> TubeCase::points_and_end(const std::string& scheme) const { return york_points(scheme); }

void TubeCase::derive(Settings& settings, const std::string& scheme) const { york_step(settings, scheme); }

std::unique_ptr<Problem> TubeCase::problem(const Settings& settings) const {
  return shock_tube_problem(shock_tube_from(settings, about_.tube), settings);
}

std::vector<double> TubeCase::default_levels() const { return {100, 200, 400, 800, 1600}; }

std::vector<StudyPlan> TubeCase::studies() const {
  return {{.id = "default",
           .title = "default: points of equal mass",
           .why = first_order,
           .values = {100, 140, 200, 280, 400},
           .full_values = {100, 200, 400, 800, 1600}}};
}

std::vector<CaseGate> TubeCase::gates() const {
  std::vector<CaseGate> all = target_order("default", "density.L1", about_.order, about_.order_reason);
  all.push_back(energy_gate("default"));
  all.push_back(coverage_gate("default", 100));
  return all;
}

std::vector<Comparator> TubeCase::comparators(const Settings& settings, const std::vector<double>& cells) const {
  return {tube_stick(shock_tube_from(settings, about_.tube), cells)};
}

GateCount TubeCase::gate_count() const { return {8, 8}; }

}  // namespace plumbline
