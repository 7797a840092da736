// Bars with irregular points: does anything grow at small steps?
#include <utility>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_irregular {
namespace {

const std::vector<std::string> transfers{"pic", "flip", "apic"};

// Largest growth per step over layouts, points per cell and steps, on wave numbers a tenth of pi apart.
Findings growth_of(const std::string& transfer, int layouts) {
  const StabilityProblem& irregular = find_stability_problem("irregular");
  double worst = 0, looked = 0;
  for (const Method& method : methods({"linear", "quadratic", "cubic"}, {transfer})) {
    if (method.integrator != "usf" && method.integrator != "musl" && method.integrator != "usl") continue;
    for (const double ppc : {1.0, 2.0, 3.0}) {
      for (int seed = 1; seed <= layouts; ++seed) {
        std::vector<Override> overrides = method.overrides();
        overrides.insert(overrides.end(), {{"ppc", ppc}, {"seed", static_cast<double>(seed)}, {"jitter", 0.99}});
        const Settings settings = stability_settings(irregular, "default", overrides);
        const Experiment experiment = experiment_of(irregular, settings);
        for (const double dt : {0.001, 0.01, 0.1}) {
          for (const double radius : radii_over_waves(experiment, dt, {0.314, 0.942, 1.571, 2.199, 2.827, 3.1416})) {
            worst = larger(worst, radius - 1);
            ++looked;
          }
        }
      }
    }
  }
  Findings findings;
  findings.measures = {finding("growth", worst), finding("looked_at", looked)};
  return findings;
}

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const std::string& transfer : transfers) {
    all.push_back({transfer, transfer + ": growth on random layouts", "Steps of 0.001, 0.01 and 0.1 h/c.",
                   [transfer] { return growth_of(transfer, 2); }});
    all.push_back({transfer + "-many", transfer + ": growth on many random layouts", "The same, twelve layouts.",
                   [transfer] { return growth_of(transfer, 12); }, Tier::full});
  }
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string& transfer : transfers) {
    for (const auto& [trial, tier] : {std::pair{transfer, Tier::quick}, {transfer + "-many", Tier::full}}) {
      all.push_back(gate(trial + "/growth", value_of("growth"), at_most(1e-9),
                         theory("no eigenvalue outside the unit circle; 1e-9 for what differences and eigenvalues "
                                "round, where two of them meet at one"))
                        .in(tier));
    }
  }
  return all;
}

Case stability_irregular() { return trial_case("stability-irregular", trials(), gates()); }
PLUMBLINE_CASE(stability_irregular);

}  // namespace
}  // namespace plumbline::stability_irregular
