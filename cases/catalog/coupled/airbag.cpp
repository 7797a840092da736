// A probe falls on an airbag and is thrown back. York, section 6.3.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/coupled/airbag_run.hpp"
#include "cases/catalog/coupled/grid_convergence.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

// The largest of read(run) over the levels; NaN wins.
template <class Read>
CaseGate largest_gate(const std::string& study, Gate gate, const std::string& quantity, Read read) {
  gate.quantity = quantity;
  return study_gate(study, std::move(gate), [read](const StudyResult& s) {
    Measured measured;
    double largest = -HUGE_VAL;
    for (const StudyLevel& level : s.levels) largest = larger(largest, read(level.run));
    measured.value = largest;
    measured.scale = 1;
    return measured;
  });
}

double value_of(const RunResult& run, const char* measure) {
  const Measure* found = run.find(measure);
  return found && found->value ? *found->value : std::nan("");
}

class AirbagCase : public Case {
 public:
  explicit AirbagCase(AirbagSpec spec) : spec_(std::move(spec)) {}

  std::string name() const override { return spec_.name; }

  Kind kind() const override { return Kind::coupled; }

  std::vector<Key> keys() const override {
    return {{.name = "pressure",
             .value = "physical",
             .choices = {"york", "physical"},
             .description = "4000 Pa above the air outside, or 4000 Pa and nothing outside, as York's input has it"},
            {.name = "tether",
             .value = "removed",
             .choices = {"kept", "removed"},
             .description = "at impact; it holds the ring on the top side while the bag is blown up"},
            positive_key("speed", spec_.speed, "m/s", "of the probe at impact"),
            positive_key("t_end", spec_.end_time, "s", "end time, since impact")};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"cells", 25.0}, {"ppc", 16.0}, {"membrane.strain", "segments"}};
    return {{"cells", 25.0}};
  }

  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("dt", 3.5e-6 * 25 / settings.number("cells"), spec_.name);  // at h = 20 mm York, A.4.8, A.4.9
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override { return airbag_run(spec_, settings); }
  std::vector<double> default_levels() const override { return {12, 18, 25}; }

  std::vector<StudyPlan> studies() const override {
    const std::string touch =
        "First order: what touches is known to a share of a cell, and the skin's pull is smeared over one.";
    const std::string one = "One mesh, York's.";
    return {{.id = "default",
             .title = "default, physical pressure",
             .why = touch,
             .values = {12, 18, 25},
             .full_values = {18, 25, 36, 50},
             .frames = 25,
             .frames_at = 25.0},
            {.id = "york-pressure",
             .title = "default, York's pressure",
             .why = touch,
             .overrides = {{"pressure", "york"}},
             .values = {12, 18, 25},
             .full_values = {18, 25, 36, 50},
             .frames = 25,
             .frames_at = 25.0},
            {.id = "tether-kept",
             .title = "tether kept, physical pressure",
             .why = one,
             .overrides = {{"tether", "kept"}},
             .values = {25},
             .tier = Tier::full},
            {.id = "york1997",
             .title = "York's run, his pressure",
             .why = one,
             .scheme = "york1997",
             .overrides = {{"pressure", "york"}},
             .values = {25},
             .tier = Tier::full,
             .frames = 25}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string study : {"default", "york-pressure"}) {
      for (CaseGate& gate : bag_gates(study)) all.push_back(std::move(gate));
    }
    all.push_back(softer());
    for (CaseGate& gate : york_gates()) all.push_back(std::move(gate));
    return all;
  }

 private:
  std::vector<CaseGate> bag_gates(const std::string& study) const {
    const auto of = [&](const char* measure) { return [measure](const RunResult& r) { return value_of(r, measure); }; };
    const auto share = [](const char* measure, const char* limit) {
      return [measure, limit](const RunResult& r) { return value_of(r, measure) / value_of(r, limit); };
    };
    return {
        value_gate(study, "rebound_velocity", 25,
                   declare(study + "/rebounds", {0.5 * spec_.speed, {}}, Origin::requirement,
                           "the probe is thrown back; with less than half its speed three quarters of its energy would "
                           "be lost, and an adiabatic bag has no such sink")),
        value_gate(study, "apart", 25,
                   declare(study + "/leaves", {0.02, {}}, Origin::requirement,
                           "the probe has left the bag: a cell lies between them")),
        largest_gate(study,
                     declare(study + "/displacement-limit", {{}, 1}, Origin::theory,
                             "a bag of that meridian and gas that cannot stretch lets no probe deeper"),
                     "largest of max_displacement over its upper bound",
                     share("max_displacement", "displacement_limit")),
        largest_gate(study,
                     declare(study + "/rebound-limit", {{}, 1}, Origin::theory,
                             "the energy of probe and skin at the start, and what the gas can give by swelling"),
                     "largest of rebound_velocity over its upper bound", share("rebound_velocity", "rebound_limit")),
        uncertainty(study),
        largest_gate(study,
                     declare(study + "/no-escape", {{}, 0}, Origin::identity,
                             "gas and skin move with one velocity field: no point passes the skin"),
                     "gas points outside", of("escaped_points")),
        largest_gate(study,
                     declare(study + "/volume-ratio", {{}, 0.01}, Origin::requirement,
                             "the gas fills the bag within 1 %: its volumes are those of the space inside the skin, of "
                             "which York's density misses a tenth"),
                     "largest error of the gas's volume over that of the bag",
                     [](const RunResult& r) { return std::abs(value_of(r, "volume_ratio") - 1); }),
        drift_gate(study, declare(study + "/energy", {{}, 1e-10}, Origin::identity,
                                  "the step closes the energy ledger to rounding, which adds up over the steps"))};
  }

  static CaseGate uncertainty(const std::string& study) {
    Gate gate = declare(study + "/uncertainty", {{}, 1}, Origin::requirement,
                        "what touches, skin, probe and plate, is known to a share of a cell each: together to a cell");
    gate.quantity = "uncertainty of max_displacement on the finest mesh, over its cell";
    return study_gate(study, gate, [](const StudyResult& s) {
      std::vector<std::pair<double, double>> levels;
      double finest = HUGE_VAL;
      for (const StudyLevel& level : s.levels) {
        levels.emplace_back(level.h, value_of(level.run, "max_displacement"));
        finest = std::min(finest, level.h);
      }
      const GridConvergence known = grid_convergence(std::move(levels), 1);
      Measured measured;
      measured.value = known.uncertainty / finest;
      measured.scale = 1;
      measured.note = in_words(known);
      return measured;
    });
  }

  static std::string in_words(const GridConvergence& known);

  // Of one volume pressed out, York's gas answers with less: 1.4 p D/V, p the absolute pressure.
  static CaseGate softer() {
    Gate gate = declare("york-pressure/softer", {1, {}}, Origin::theory,
                        "the gas is 26 times softer, and presses alike at first: the probe sinks deeper");
    gate.quantity = "max_displacement at York's pressure over that at the physical one, at 25";
    CaseGate judged = study_gate("york-pressure", gate,
                                 [](const StudyResult& s) {
                                   const auto at = [](const StudyResult& of) {
                                     return value_of(of.level(25)->run, "max_displacement");
                                   };
                                   Measured measured;
                                   measured.value = at(s) / at(*s.sibling("default"));
                                   measured.scale = 1;
                                   return measured;
                                 },
                                 {25});
    judged.also = {"default"};
    return judged;
  }

  std::vector<CaseGate> york_gates() const {
    return {
        value_gate("york1997", "rebound_velocity", 25,
                   declare("york1997/rebounds", {0, {}}, Origin::literature, "York: it eventually stops and rebounds"),
                   Tier::full),
        error_gate("york1997", "volume_ratio", 25,
                   expected_failure(
                       declare("york1997/volume-ratio", {{}, 0.01}, Origin::requirement,
                               "the gas fills the bag within 1 %, as by default"),
                       "his density takes the mass of a whole cell over its volume where the skin cuts it: the gas "
                       "at the skin counts as thinner than it is",
                       {0.100, 0.126}, "2026-11-23 5825b24"),
                   Tier::full)};
  }

  AirbagSpec spec_;
};

std::string AirbagCase::in_words(const GridConvergence& known) {
  const auto millimetres = [](double x) { return to_text(std::round(1e4 * x) / 10); };
  return millimetres(known.finest) + " mm ± " + millimetres(known.uncertainty) + " mm; " + millimetres(known.limit) +
         " mm on ever finer meshes";
}

struct Airbag200 final : AirbagCase {
  Airbag200()
      : AirbagCase(
            {.name = "airbag-200", .mass = 6.03, .radius = 0.1, .speed = 3.9, .crown = 0.318, .end_time = 0.13}) {}
};
PLUMBLINE_CASE(Airbag200);

struct Airbag500 final : AirbagCase {
  Airbag500()
      : AirbagCase(
            {.name = "airbag-500", .mass = 8.05, .radius = 0.25, .speed = 4.7, .crown = 0.31, .end_time = 0.11}) {}
};
PLUMBLINE_CASE(Airbag500);

}  // namespace
}  // namespace plumbline
