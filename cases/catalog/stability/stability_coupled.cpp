// What the laboratory says of a membrane in a gas: York's open problem.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "cases/catalog/stability/fast_growth.hpp"
#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_coupled {
namespace {

constexpr double width = 1e-4;  // relative, of predicted limits

const StabilityProblem& coupled() { return find_stability_problem("coupled"); }

Settings settings_of(const std::string& scheme, double mass, double stiffness, const std::vector<Override>& more = {}) {
  std::vector<Override> overrides = more;
  overrides.insert(overrides.end(), {{"density_ratio", mass}, {"stiffness_ratio", stiffness}});
  return stability_settings(coupled(), scheme, overrides);
}

struct Ratios {
  double mass, stiffness;
};

// Runs against what the step predicts, for several membranes.
Findings runs(const std::string& scheme, const std::vector<Ratios>& membranes, const std::vector<Override>& more) {
  double worst = 0, brackets = 0;
  for (const Ratios& m : membranes) {
    const Settings settings = settings_of(scheme, m.mass, m.stiffness, more);
    const Prediction predicted = coupled().predicted(settings, 1e-3);
    const Observation observed = coupled().observed(settings, predicted.reach);
    brackets = larger(brackets, static_cast<double>(observed.brackets.size()));
    const auto& seen = observed.brackets;
    const double limit = seen.empty() ? std::nan("") : 0.5 * (seen[0].low + seen[0].high);
    worst = larger(worst, std::abs(limit / predicted.limit() - 1));
  }
  Findings findings;
  findings.measures = {scalar_measure("observed.departure", worst, 0, 1e-15, "1"),
                       finding("observed.brackets", brackets)};
  return findings;
}

// Limits along the membrane over its mass and stiffness.
Findings dependence(const std::string& scheme, const std::vector<double>& masses,
                    const std::vector<double>& stiffnesses) {
  std::vector<std::vector<double>> limit;
  for (const double k : stiffnesses) {
    limit.emplace_back();
    for (const double m : masses) limit.back().push_back(coupled().predicted(settings_of(scheme, m, k), width).limit());
  }
  double stiffer = 0, heavier = HUGE_VAL;
  for (std::size_t j = 0; j < stiffnesses.size(); ++j) {
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (j > 0) stiffer = larger(stiffer, limit[j][i] / limit[j - 1][i]);
      if (i > 0) heavier = std::min(heavier, limit[j][i] / limit[j][i - 1]);
    }
  }
  Findings findings;
  findings.measures = {finding("stiffer", stiffer), finding("heavier", heavier)};
  findings.profile.abscissa = "density_ratio";
  findings.profile.columns.push_back({"density_ratio", "1", "mass of the membrane", masses});
  for (std::size_t j = 0; j < stiffnesses.size(); ++j) {
    const std::string at = to_text(stiffnesses[j]);
    findings.profile.columns.push_back({"limit_" + at, "h/c", "largest stable step, stiffness " + at, limit[j]});
  }
  return findings;
}

// A membrane that is next to nothing, and one that is all there is.
Findings extremes(const std::string& scheme) {
  const auto limit = [&](double m, double k, const std::vector<Override>& more = {}) {
    return coupled().predicted(settings_of(scheme, m, k, more), width).limit();
  };
  const StabilityProblem& gas = find_stability_problem("gas");
  // On nodes that a membrane shares, here all, maps take all that nodes do not carry [Filter 1], and points do not move with what
  // sharpening adds [Sharpening 2].
  const Settings alone = stability_settings(
      gas, scheme,
      {{"ppc", 4.0}, {"side", "opening"}, {"motion", "own"}, {"filter.sound", 0.0}, {"filter.compression", 0.0}});
  const double stiff = limit(1, 1e3) * std::sqrt(1e3), stiffer = limit(1, 1e5) * std::sqrt(1e5);
  double least = HUGE_VAL, most = 0;
  for (const double place : {0.05, 0.25, 0.5, 0.75, 0.95}) {
    const double here = limit(1, 10, {{"place", place}});
    least = std::min(least, here);
    most = std::max(most, here);
  }
  Findings findings;
  findings.measures = {finding("gas", limit(1e-4, 1e-4) / gas.predicted(alone, width).limit()),
                       finding("stiff", stiffer / stiff), finding("place", least / most)};
  return findings;
}

// Growth with points that move, in the box, against runs.
Findings growth(const std::string& scheme, const std::vector<double>& steps) {
  double worst = 0, rate = 0;
  for (const double dt : steps) {
    const Settings settings = settings_of(scheme, 1, 1, {{"dim", 2.0}, {"positions", "moving"}});
    const GrowthSeen seen = compare_growth(experiment_of(coupled(), settings), dt);
    worst = larger(worst, std::abs(std::log(seen.observed) / std::log(seen.predicted) - 1));
    rate = larger(rate, std::log(seen.predicted) / dt);
  }
  Findings findings;
  findings.measures = {scalar_measure("observed.departure", worst, 0, 1e-15, "1"), finding("rate", rate, "c/h")};
  return findings;
}

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const std::string scheme : {"default", "york1997"}) {
    const auto add = [&](const std::string& name, const std::string& title, const std::string& why,
                         std::function<Findings()> find, Tier tier = Tier::full) {
      all.push_back({scheme + name, scheme + title, why, std::move(find), tier});
    };
    const auto of = [&](const std::vector<Ratios>& membranes, const std::vector<Override>& more = {}) {
      return [=] { return runs(scheme, membranes, more); };
    };
    add("-line", ": along the membrane", "Light and heavy, soft and stiff.", of({{0.1, 100}, {100, 0.01}}),
        Tier::quick);
    add("-line-more", ": along the membrane, further ones", "Equal to the gas, or nothing.",
        of({{1, 1}, {0.01, 0.01}, {0.01, 1e4}, {100, 1e4}}));
    add("-box", ": a box that the membrane divides", "2 x 2 points of gas a cell.", of({{0.1, 100}}, {{"dim", 2.0}}),
        Tier::quick);
    add("-box-more", ": the box at other heights of the membrane", "2 x 2 points a cell.",
        of({{1, 1}, {0.1, 100}}, {{"dim", 2.0}, {"place", 0.1}}));
    add("-extremes", ": limits of limits", "Next to no membrane; next to no gas.", [=] { return extremes(scheme); });
    add("-dependence", ": limits over mass and stiffness", "Along the membrane.", [=] {
      return dependence(scheme, {0.01, 0.1, 1, 10, 100}, {0.01, 0.1, 1, 10, 100, 1e4});
    });
  }
  all.push_back({"york1997-growth", "york1997: growth in the box, points moving", "Steps of 0.1, 0.3 and 1 h/c.", [] {
                   return growth("york1997", {0.1, 0.3, 1});
                 }});
  all.push_back({"default-growth", "default: growth in the box, points moving", "A step of h/c.",
                 [] { return growth("default", {1}); }});
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string scheme : {"default", "york1997"}) {
    for (const std::string trial : {"-line", "-line-more", "-box", "-box-more"}) {
      const Tier tier = trial.ends_with("more") ? Tier::full : Tier::quick;
      all.push_back(gate(scheme + trial + "/limit", error_of("observed.departure"), at_most(0.02),
                         requirement(roughly_observed_limits))
                        .in(tier));
      all.push_back(gate(scheme + trial + "/brackets", value_of("observed.brackets"), exactly(1),
                         theory("below the limit all steps are stable, above it none"))
                        .in(tier));
    }
    const auto value = [&](const std::string& trial, const std::string& measure, Range range,
                           const std::string& reason) {
      all.push_back(gate(scheme + trial + "/" + measure, value_of(measure), range, theory(reason)).in(Tier::full));
    };
    const std::string rayleigh =
        "frequencies are Rayleigh quotients of both stiffnesses over both masses; 1e-3 for the limits' own accuracy";
    value("-dependence", "stiffer", at_most(1.001), rayleigh + ": stiffer is faster");
    value("-dependence", "heavier", at_least(0.999), rayleigh + ": heavier is slower");
    value("-extremes", "gas", between(0.99, 1.01),
          "a membrane of 1e-4 the mass and stiffness changes frequencies by 1e-4");
    value("-extremes", "stiff", between(0.99, 1.01), "the gas adds 1e-3 and 1e-5 of the stiffness");
    value("-extremes", "place", between(0.5, 1), "linear shapes with one point: 1 to 2 over all places");
  }
  for (const std::string study : {"default-growth", "york1997-growth"}) {
    all.push_back(gate(study + "/observed", error_of("observed.departure"), at_most(0.02),
                       requirement("growth per step of runs within 2 % of what the step predicts, as of the limits")));
  }
  all.push_back(gate("york1997-growth/rate", value_of("rate"), at_most(1e-5), theory("a gas at rest stays at rest"))
                    .fails("waves of shear of a gas on bilinear shapes, see stability-gas", {0.45, 0.6}));
  return all;
}

Case stability_coupled() { return trial_case("stability-coupled", trials(), gates()); }
PLUMBLINE_CASE(stability_coupled);

}  // namespace
}  // namespace plumbline::stability_coupled
