// Cases of the catalog at shares of the limit that the laboratory predicts.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/scene_limit.hpp"
#include "cases/harness/run/experiment.hpp"

namespace plumbline::stability_catalog {
namespace {

// What became of the energy in a run: the largest store over that at the start (and what flowed in); infinite if the run
// stopped.
double growth_of(const Case& entry, const std::string& scheme, const std::vector<Override>& overrides) {
  const RunResult run = run_experiment(entry, scheme, entry.settings(scheme, overrides));
  if (!run.finished) return HUGE_VAL;
  const double scale = std::abs(run.ledger.energy.initial());
  double largest = 0;
  for (const auto& series : run.history.series) {
    if (series.quantity != "energy" || series.column != "store") continue;
    for (const double store : series.values) largest = larger(largest, std::abs(store));
  }
  return largest / scale;
}

struct Entry {
  const char *trial, *name, *scheme, *title;
  std::vector<Override> overrides;
  const char* spared = nullptr;  // why it holds above the limit all the same; null: it does not
  Range energy = {};             // what its energy stays at, over that of its start, where it is spared
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"bar-vibration", "bar-vibration", "default", "default scheme of solids", {{"cells", 13.0}}},
      {"bar-vibration-flip",
       "bar-vibration",
       "default",
       "solids: musl, linear, FLIP",
       {{"cells", 13.0}, {"integrator", "musl"}, {"shape", "linear"}, {"transfer", "flip"}, {"ppc", 2.0}},
       "its points keep to the centres of their shares of a cell, where the limit is 1.73 h/c, not the worst, 1.43",
       {1.05, 1.16}},
      {"string-vibration", "string-vibration", "default", "default scheme of membranes", {{"cells", 20.0}}},
      {"sod",
       "sod",
       "default",
       "default scheme of gases",
       {{"cells", 50.0}},
       "the limit is that of gas at rest with sound of the fastest speed everywhere; here that is a part of the tube, "
       "for 27 steps, and what grows there becomes heat: the step cannot gain energy",
       {0.99, 1.01}}};
  return all;
}

Findings shares_of(const Entry& chosen) {
  const Case& entry = find_case(chosen.name);
  std::vector<Override> overrides = chosen.overrides;
  overrides.emplace_back("cfl", "auto");
  const double limit = entry.settings(chosen.scheme, overrides).number("cfl") / auto_share;
  Findings findings;
  findings.measures.push_back(finding("limit", limit, "h/c"));
  for (const auto& [name, share] : {std::pair{"at-0.5", 0.5}, {"at-0.9", 0.9}, {"at-1.1", 1.1}, {"at-2", 2.0}}) {
    overrides.back() = {"cfl", share * limit};
    findings.measures.push_back(finding(name, std::min(1e300, growth_of(entry, chosen.scheme, overrides))));
  }
  return findings;
}

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const Entry& chosen : entries()) {
    all.push_back({chosen.trial, chosen.title, "Shares 0.5, 0.9, 1.1 and 2 of the limit.",
                   [chosen] { return shares_of(chosen); }});
  }
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const Entry& chosen : entries()) {
    const auto at = [&](const std::string& share, Range energy, Because because) {
      return gate(chosen.trial + ("/" + share), value_of(share), energy, std::move(because));
    };
    const Because holds = requirement(
        "below the limit a case holds: its energy stays within twice that of its start, what gravity and walls give "
        "included; above the limit it grows tenfold and more");
    all.push_back(at("at-0.5", at_most(2), holds));
    all.push_back(at("at-0.9", at_most(2), holds));
    all.push_back(at("at-1.1", at_least(10),
                     theory("above the limit something grows from step to step, and the energy with it")));
    if (chosen.spared) all.back() = std::move(all.back()).fails(chosen.spared, chosen.energy, "2026-11-23 5825b24");
    all.push_back(at("at-2", at_least(10), theory("twice the limit is above that of every place of the points")));
  }
  return all;
}

Case stability_catalog() { return trial_case("stability-catalog", trials(), gates()); }
PLUMBLINE_CASE(stability_catalog);

}  // namespace
}  // namespace plumbline::stability_catalog
