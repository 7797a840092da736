// Bars with irregular points: does anything grow at small steps?
#include "cases/harness/gates.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/trial_case.hpp"

namespace plumbline {
namespace {

// Largest growth per step over layouts, points per cell and steps, on wave numbers a tenth of pi apart.
Findings growth_of(const std::string& transfer, int layouts) {
  const StabilityProblem& irregular = find_stability_problem("irregular");
  double worst = 0, looked = 0;
  for (const Method& method : methods({"linear", "quadratic", "cubic"}, {transfer})) {
    for (const double ppc : {1.0, 2.0, 3.0}) {
      for (int seed = 1; seed <= layouts; ++seed) {
        if (method.integrator != "usf" && method.integrator != "musl" && method.integrator != "usl") continue;
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

class StabilityIrregular final : public TrialCase {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "stability-irregular";
    s.sketch =
        R"svg(<svg viewBox="0 0 360 90" role="img" aria-label="A period of four cells with points at random places"><path d="M20 20h320v40h-320zM60 20v40M100 20v40M140 20v40M180 20v40M220 20v40M260 20v40M300 20v40" fill="none" stroke="currentColor" stroke-width="1.2"/><g fill="currentColor"><circle cx="31" cy="40" r="3"/><circle cx="49" cy="40" r="3"/><circle cx="70" cy="40" r="3"/><circle cx="92" cy="40" r="3"/><circle cx="108" cy="40" r="3"/><circle cx="135" cy="40" r="3"/><circle cx="150" cy="40" r="3"/><circle cx="171" cy="40" r="3"/><circle cx="191" cy="40" r="3"/><circle cx="209" cy="40" r="3"/><circle cx="230" cy="40" r="3"/><circle cx="252" cy="40" r="3"/><circle cx="268" cy="40" r="3"/><circle cx="295" cy="40" r="3"/><circle cx="310" cy="40" r="3"/><circle cx="331" cy="40" r="3"/></g><g fill="currentColor" font-size="12"><text x="120" y="80">period: four cells</text></g></svg>)svg";
    s.title = "Elastic bars with irregular points at small steps";
    s.source = "Bai, Schroeder 2022, Stability analysis of explicit MPM, doi 10.1111/cgf.14620";
    s.claim =
        "On random layouts in one dimension nothing grows at steps from a thousandth to a tenth of h/c, by PIC, FLIP "
        "or "
        "APIC: the growth at any step that is reported of APIC needs more than irregular points.";
    s.physics =
        "A linear elastic bar, free of stress, its points at random in their shares of a cell and alike every four "
        "cells. "
        "Forces derive from an energy of the points' strains, and what PIC and APIC take from velocities between two "
        "steps "
        "is a contraction in the norm of kinetic energy, whatever the layout.\n\n"
        "Growth at any step does appear where the stress at rest does not vanish and points move: `stability-gas`, "
        "`plane`, and `stability-coupled`, `growth`.";
    s.equations = {"|λ| ≤ 1"};
    s.cells_along = "nothing: trials are not refined";
    s.reference_name = "bar-stability";
    s.reference_text = "None is needed: growth is absent.";
    s.reference_bound = "Rounding.";
    s.theory_orders = {{"growth", 0, "nothing is refined"}};
    return s;
  }
  std::vector<Trial> trials() const override {
    std::vector<Trial> all;
    for (const std::string transfer : {"pic", "flip", "apic"}) {
      all.push_back({transfer, transfer + ": growth on random layouts", "Steps of 0.001, 0.01 and 0.1 h/c.",
                     [transfer] { return growth_of(transfer, 2); }});
      all.push_back({transfer + "-many", transfer + ": growth on many random layouts", "The same, twelve layouts.",
                     [transfer] { return growth_of(transfer, 12); }, Tier::full});
    }
    return all;
  }
  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string transfer : {"pic", "flip", "apic"}) {
      for (const bool many : {false, true}) {
        const std::string trial = transfer + (many ? "-many" : "");
        all.push_back(value_gate(trial, "growth", trial_level,
                                 declare(trial + "/growth", {{}, 1e-9}, Origin::theory,
                                         "no eigenvalue outside the unit circle; 1e-9 for what differences and "
                                         "eigenvalues round, where two of them meet at one"),
                                 many ? Tier::full : Tier::quick));
      }
    }
    return all;
  }
  GateCount gate_count() const override { return {15, 30}; }
};

PLUMBLINE_CASE(StabilityIrregular);

}  // namespace
}  // namespace plumbline
