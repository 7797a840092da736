// What the laboratory says of a gas, against closed forms and against runs.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "cases/catalog/stability/fast_growth.hpp"
#include "cases/catalog/stability/gas_patch.hpp"
#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_gas {
namespace {

constexpr double quick_width = 1e-4;  // relative, of predicted limits that are compared with runs

const StabilityProblem& gas() { return find_stability_problem("gas"); }

// Linear shapes and FLIP, one point a cell, nothing viscous.
Settings frozen_bar_like(const std::string& integrator, double offset) {
  return stability_settings(gas(), "default",
                            {{"shape", "linear"},
                             {"transfer", "flip"},
                             {"integrator", integrator},
                             {"sharpening", 0.0},
                             {"ppc", 1.0},
                             {"offset", offset}});
}

Findings closed_forms(const std::string& integrator) {
  Findings findings;
  findings.profile.abscissa = "offset";
  std::vector<double> at, predicted, closed;
  double worst = 0;
  for (int k = 0; k < 12; ++k) {
    const Settings settings = frozen_bar_like(integrator, (k + 0.5) / 12);
    at.push_back(settings.number("offset"));
    predicted.push_back(gas().predicted(settings, 1e-9).limit());
    closed.push_back(gas().closed_form(settings)->limit);
    worst = larger(worst, std::abs(predicted.back() / closed.back() - 1));
  }
  findings.measures.push_back(scalar_measure("limit.departure", worst, 0, 1e-15, "1"));
  findings.profile.columns = {{"offset", "1", "shift of the lattice", at},
                              {"limit", "h/c", "largest stable step", predicted},
                              {"limit_reference", "h/c", "closed form", closed}};
  return findings;
}

struct Seen {
  double predicted = 0, observed = 0, brackets = 0;
};

Seen look(const std::string& scheme, const std::vector<Override>& overrides) {
  const Settings settings = stability_settings(gas(), scheme, overrides);
  const Prediction predicted = gas().predicted(settings, quick_width);
  const Observation observed = gas().observed(settings, predicted.reach);
  Seen seen{predicted.limit(), std::nan(""), static_cast<double>(observed.brackets.size())};
  if (!observed.brackets.empty()) seen.observed = 0.5 * (observed.brackets[0].low + observed.brackets[0].high);
  return seen;
}

Findings runs(const std::string& scheme, const std::vector<std::vector<Override>>& choices) {
  Findings findings;
  double worst = 0, brackets = 0, least = HUGE_VAL;
  for (const auto& overrides : choices) {
    const Seen seen = look(scheme, overrides);
    worst = larger(worst, std::abs(seen.observed / seen.predicted - 1));
    brackets = larger(brackets, seen.brackets);
    least = std::min(least, seen.predicted);
  }
  findings.measures = {scalar_measure("observed.departure", worst, 0, 1e-15, "1"),
                       finding("observed.brackets", brackets), finding("limit.least", least, "h/c")};
  return findings;
}

// The step, in h/c, at which waves grow by a twentieth a step: beyond all that a compression itself makes grow.
double step_of_strong_growth(const std::function<Patch(const Extent&)>& patch, const Settings& settings) {
  constexpr int reach = 5;
  double low = 0.5, high = 3;
  while (high - low > 1e-3) {
    const double dt = 0.5 * (low + high);
    const Amplification a(patch({1, reach}), {settings.text("integrator"), integrator_parameters(settings)},
                          Positions::moving, dt);
    (worst_wave(a, 1).radius > 1.05 ? high : low) = dt;
  }
  return 0.5 * (low + high);
}

// york1997: the limit of a gas under compression, its switch as it is, over that of the viscosity that `closing` takes.
Findings the_switch() {
  const Settings settings = stability_settings(gas(), "york1997", {});
  const auto limit = [&](const GasLattice& lattice) {
    return step_of_strong_growth([&](const Extent& e) { return gas_patch(settings, lattice, e); }, settings);
  };
  const double closing = limit({.side = Side::closing}), opening = limit({.side = Side::opening});
  Findings findings;
  findings.measures = {finding("compressed", limit({.compression = 0.003}) / closing),
                       finding("expanding", limit({.compression = -0.003}) / opening)};
  const double both = look("york1997", {{"side", "both"}}).observed;
  findings.measures.push_back(finding("both", (both - closing) / (opening - closing)));
  return findings;
}

// How far sound of infinitesimal amplitude comes in h/c, in cells: of the eigenvalues those of the two waves have the
// largest argument among all that the maps hardly damp.
double speed_of_sound(const std::string& scheme, const std::vector<Override>& overrides) {
  constexpr double dt = 0.1, theta = 0.1;
  const Settings settings = stability_settings(gas(), scheme, overrides);
  const Experiment experiment = experiment_of(gas(), settings);
  const Amplification a(experiment.patch({1, 16}), experiment.integrator, experiment.positions, dt);
  double fastest = 0;
  for (const std::complex<double>& value : eigenvalues(a.at({theta, 0}))) {
    if (std::abs(value) > 0.99) fastest = std::max(fastest, std::abs(std::arg(value)));
  }
  return fastest / (theta * dt);
}

Findings sound() {
  Findings findings;
  findings.measures = {
      finding("default", speed_of_sound("default", {})),
      finding("york1997", speed_of_sound("york1997", {{"side", "opening"}})),
      finding("york1997.quadratic", speed_of_sound("york1997", {{"side", "opening"}, {"shape", "quadratic"}}))};
  return findings;
}

Findings viscosities() {
  Findings findings;
  findings.profile.abscissa = "viscosity";
  std::vector<double> at{0, 0.03, 0.1, 0.3, 1, 3, 10, 30};
  for (const std::string scheme : {"default", "york1997"}) {
    std::vector<double> limits;
    for (const double nu : at) {
      const Settings settings = stability_settings(gas(), scheme,
                                                   {{"viscosity", nu}, {"side", "opening"}, {"ppc", 3.0}});
      limits.push_back(gas().predicted(settings, 1e-4).limit());
    }
    double rise = 0;
    for (std::size_t k = 1; k < at.size(); ++k) rise = larger(rise, limits[k] - limits[k - 1]);
    const std::size_t last = at.size() - 1;
    findings.measures.push_back(finding(scheme + ".rise", rise, "h/c"));
    findings.measures.push_back(
        finding(scheme + ".diffusive", limits[last] * at[last] / (limits[last - 1] * at[last - 1])));
    findings.profile.columns.push_back({"limit_" + scheme, "h/c", "largest stable step, " + scheme, limits});
  }
  findings.profile.columns.insert(findings.profile.columns.begin(), {"viscosity", "1", "viscosity", at});
  return findings;
}

const Override uncorrected{"quadrature", 0.0}, at_nodes{"pressure_at", std::string("nodes")};

Settings in_plane(const std::string& scheme, double per_cell, const std::vector<Override>& more = {}) {
  std::vector<Override> overrides{{"dim", 2.0}, {"ppc", per_cell}, {"side", "opening"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return stability_settings(gas(), scheme, overrides);
}

// Pressures at the nodes, and of nodes in sums that are corrected, reach further: a point those that share a node with it, and on
// each way of its change to a force three nodes along an axis. Each further power of sharpening reaches one node further on
// either way.
Amplification amplification(const Settings& settings, double dt) {
  const int powers = settings.number("sharpening.third") > 0 ? 3 : settings.number("sharpening.second") > 0 ? 2 : 1;
  const bool further = settings.text("pressure_at") == "nodes" || settings.number("quadrature") > 0;
  const int reach = (further ? 12 : 5) + 2 * (powers - 1);
  const Experiment experiment = experiment_of(gas(), settings);
  return Amplification(experiment.patch({1, reach}), experiment.integrator, experiment.positions, dt);
}

// Growth in the plane in a step, of the wave that grows most.
double growth_in_plane(const Settings& settings, double dt) {
  return worst_wave(amplification(settings, dt), 2).radius - 1;
}

// Of a scheme by which waves grow: how fast, and growth in a step over that in half as long a step.
void find_growth(const std::string& name, const Settings& settings, Findings& findings) {
  const double fine = growth_in_plane(settings, 0.1), coarse = growth_in_plane(settings, 0.2);
  findings.measures.push_back(finding(name + ".rate", std::log1p(coarse) / 0.2, "c/h"));
  findings.measures.push_back(finding(name + ".ratio", coarse / fine));
}

// A growth below 1e-6 a step is none: by so much the derivatives' error moves neutral waves.
double rate_of_growth(const Settings& settings, double dt) {
  const double grown = growth_in_plane(settings, dt);
  return grown > 1e-6 ? std::log1p(grown) / dt : 0.0;
}

Findings plane() {
  Findings findings;
  findings.measures = {finding("default.rate", rate_of_growth(in_plane("default", 4), 0.2), "c/h")};
  find_growth("york1997", in_plane("york1997", 4), findings);
  return findings;
}

Findings uncorrected_in_plane() {
  Findings findings;
  find_growth("default", in_plane("default", 4, {uncorrected}), findings);
  return findings;
}

// Of a short and a long step, and of points in greater number.
Findings no_growth_in_plane(const std::vector<Override>& more) {
  const Settings four = in_plane("default", 4, more), nine = in_plane("default", 9, more);
  Findings findings;
  findings.measures = {finding("short", rate_of_growth(four, 0.2), "c/h"),
                       finding("long", rate_of_growth(four, 0.8), "c/h"),
                       finding("of_nine", rate_of_growth(nine, 0.2), "c/h")};
  return findings;
}

Findings points_in_plane() {
  const auto growth = [](double per_cell) {
    return growth_in_plane(in_plane("default", per_cell, {uncorrected}), 0.2);
  };
  Findings findings;
  findings.measures = {finding("default.of_sixteen", growth(16) / growth(4))};
  return findings;
}

// The eigenvalues of one wave: those that are 1, those that are what the filter leaves in a step, and the moduli of the others.
struct Spectrum {
  int neutral = 0, filtered = 0;
  std::vector<double> others;  // falling
};

// Derivatives are good to 1e-9, and an eigenvalue of a Jordan block of two, a place by its velocity, spreads by the root of that.
constexpr double spread = 3e-5;

Spectrum spectrum_of(const Amplification& a, const WaveNumber& theta, double left) {
  constexpr double near = 1e-4;
  Spectrum found;
  for (const std::complex<double>& value : eigenvalues(a.at(theta))) {
    if (std::abs(value - 1.0) < spread)
      ++found.neutral;
    else if (std::abs(value - left) < near)
      ++found.filtered;
    else
      found.others.push_back(std::abs(value));
  }
  std::sort(found.others.rbegin(), found.others.rend());
  return found;
}

// All eigenvalues of waves along an axis and along the diagonal: 4 points a cell have 36 numbers that a step reads, 8 of places,
// 8 of velocities, 16 of their gradients and 4 of energies.
Findings whole_spectrum() {
  constexpr double dt = 0.2;
  constexpr int waves = 16;
  const Settings settings = in_plane("default", 4);
  const double left = 1 - settings.number("filter.sound") * dt;
  const Amplification a = amplification(settings, dt);
  Findings findings;
  findings.profile.abscissa = "wave_number";
  std::vector<double> at, largest, second, least;
  double fewest_neutral = HUGE_VAL, fewest_filtered = HUGE_VAL, growing_on_axis = 0, growing_on_diagonal = 0;
  for (int k = 1; k < waves; ++k) {  // at pi the waves of sound are filtered about as fast as the null space
    const double t = std::numbers::pi * k / waves;
    for (const bool diagonal : {false, true}) {
      const Spectrum found = spectrum_of(a, {t, diagonal ? t : 0}, left);
      fewest_neutral = std::min<double>(fewest_neutral, found.neutral);
      fewest_filtered = std::min<double>(fewest_filtered, found.filtered);
      const auto grow = std::count_if(found.others.begin(), found.others.end(),
                                      [](double m) { return m > 1 + spread; });
      double& most = diagonal ? growing_on_diagonal : growing_on_axis;
      most = larger(most, static_cast<double>(grow));
      if (!diagonal || found.others.size() < 2) continue;
      at.push_back(t);
      largest.push_back(found.others[0]);
      second.push_back(found.others[1]);
      least.push_back(found.others.back());
    }
  }
  const std::vector<double> filtered(at.size(), left), neutral(at.size(), 1.0);
  findings.measures = {finding("unknowns", a.unknowns()), finding("neutral", fewest_neutral),
                       finding("filtered", fewest_filtered), finding("growing.axis", growing_on_axis),
                       finding("growing.diagonal", growing_on_diagonal)};
  findings.profile.columns = {
      {"wave_number", "1/h", "of the wave in either direction, times the cell", at},
      {"largest", "1", "largest modulus of the others", largest},
      {"neutral", "1", "of ten displacements and energies in the null space of the forces", neutral},
      {"second", "1", "and the second largest", second},
      {"least", "1", "and the least", least},
      {"filtered", "1", "of 22 velocities and gradients in the null space of the map to the nodes", filtered}};
  return findings;
}

Trial closed_form(const std::string& integrator) {
  return {integrator + "-closed-form", integrator + ": limits at twelve offsets of the lattice",
          "Points that stay in their cells push a bar of the modulus (γ − 1) p.",
          [integrator] { return closed_forms(integrator); }};
}

std::vector<Trial> trials() {
  return {
      closed_form("usf"),
      closed_form("musl"),
      closed_form("usl"),
      {"default-runs", "default: limits that runs show", "24 periods carry 24 of all wave numbers.",
       [] {
         return runs("default", {{}, {{"offset", 0.2}, {"ppc", 3.0}}});
       }},
      {"york1997-runs", "york1997: limits that runs show, on both sides of the viscosity's switch",
       "Three points a cell at three offsets.",
       [] {
         return runs(
             "york1997",
             {{}, {{"offset", 0.1}}, {{"offset", 0.2}}, {{"side", "opening"}}, {{"offset", 0.2}, {"side", "opening"}}});
       }},
      {"switch", "A gas that closes, one that opens, and the switch between",
       "The limit of a gas that is compressed, its own switch on, is that of a viscosity 4/3 μ = c_L ρ c h.",
       the_switch},
      {"sound", "How fast sound of no amplitude travels", "π/31 a cell.", sound},
      {"viscosity", "Limits with physical viscosity", "From none to 30 c h.", viscosities, Tier::full},
      {"spectrum", "All modes of waves in the plane", "Along an axis and the diagonal, 2 x 2 points a cell, 0.2 h/c.",
       whole_spectrum},
      {"plane", "Growth in the plane, at steps of 0.1 and 0.2 h/c", "All wave numbers, 2 x 2 points a cell.", plane},
      {"plane-uncorrected", "Growth in the plane with sums over points left as they are, at steps of 0.1 and 0.2 h/c",
       "All wave numbers, 2 x 2 points a cell.", uncorrected_in_plane},
      {"plane-corrected", "Growth in the plane, longer steps and more points",
       "2 x 2 points a cell at 0.2 and 0.8 h/c, 3 x 3 at 0.2.", [] { return no_growth_in_plane({}); }, Tier::full},
      {"plane-nodes", "Growth in the plane with pressures at the nodes",
       "2 x 2 points a cell at 0.2 and 0.8 h/c, 3 x 3 at 0.2.", [] { return no_growth_in_plane({at_nodes}); },
       Tier::full},
      {"plane-points", "Growth in the plane with more points, sums over points left as they are",
       "4 x 4 points a cell over 2 x 2, at steps of 0.2 h/c.", points_in_plane, Tier::full}};
}

std::vector<CaseGate> gates() {
  const Number departure = error_of("limit.departure"), observed = error_of("observed.departure"),
               brackets = value_of("observed.brackets");
  const Because closed = theory(
      "predicted limits equal the closed form to 1e-6; a growth below 1e-6 a step is no growth, which moves limits by "
      "less, as growth begins like a root");
  const Because near_predicted = requirement(roughly_observed_limits);
  const Because one_limit = theory("below the limit all steps are stable, above it none");
  const Because same = identity(
      "the same law on this side of its switch; 2 % for the compression of 0.003 c/h and 5 % a step");
  const Because long_waves = theory("long waves travel with c, but for (k h)² = 0.01 and the step");
  const Because falling = theory(
      "more diffusion never lets a step be longer; a thousandth for the limits' own accuracy");
  const Because diffusive = theory("of great viscosity the limit falls as h²/ν; from 10 to 30 c h all but (c h/ν)²");
  const Because at_rest = theory("a gas at rest stays at rest");
  return {
      gate("usf-closed-form/limit", departure, at_most(1e-6), closed),
      gate("musl-closed-form/limit", departure, at_most(1e-6), closed),
      gate("usl-closed-form/limit", departure, at_most(1e-6), closed),
      gate("default-runs/limit", observed, at_most(0.02), near_predicted),
      gate("default-runs/brackets", brackets, exactly(1), one_limit),
      gate("york1997-runs/limit", observed, at_most(0.02), near_predicted),
      gate("york1997-runs/brackets", brackets, exactly(1), one_limit),

      gate("switch/compressed", value_of("compressed"), between(0.98, 1.02), same),
      gate("switch/expanding", value_of("expanding"), between(0.98, 1.02), same),
      gate("switch/both", value_of("both"), between(0, 1), theory("a mean of both sides")),

      gate("sound/default", value_of("default"), between(0.99, 1.01), long_waves),
      gate("sound/quadratic", value_of("york1997.quadratic"), between(0.99, 1.01), long_waves),
      gate("sound/york1997", value_of("york1997"), between(0.99, 1.01), long_waves)
          .fails("gradients of linear shapes do not change within a cell: √((γ − 1)/γ) = 0.5345", {0.529, 0.540}),

      gate("viscosity/default-rise", value_of("default.rise"), at_most(1e-3), falling).in(Tier::full),
      gate("viscosity/default-diffusive", value_of("default.diffusive"), between(0.95, 1.05), diffusive).in(Tier::full),
      gate("viscosity/york1997-rise", value_of("york1997.rise"), at_most(1e-3), falling).in(Tier::full),
      gate("viscosity/york1997-diffusive", value_of("york1997.diffusive"), between(0.95, 1.05), diffusive)
          .in(Tier::full),

      gate("spectrum/unknowns", value_of("unknowns"), exactly(36),
           theory("of each point two places, two velocities, their four gradients and an energy; the rest follows")),
      gate("spectrum/neutral", value_of("neutral"), exactly(10),
           theory(
               "forces have two components a cell: of eight places and four energies ten combinations change neither")),
      gate("spectrum/filtered", value_of("filtered"), exactly(22),
           theory("the map to the nodes has rank two a cell, of eight velocities and sixteen gradients; of its null "
                  "space a "
                  "step leaves 1 - k_f c Δt/h")),
      gate("spectrum/growing-axis", value_of("growing.axis"), exactly(0), at_rest),
      gate("spectrum/growing-diagonal", value_of("growing.diagonal"), exactly(0), at_rest),

      gate("plane/york1997-rate", value_of("york1997.rate"), at_most(1e-5), at_rest)
          .fails("the mixed derivative of bilinear shapes, but not their second ones, changes forces as points move: "
                 "waves of shear grow",
                 {0.55, 0.7}),
      gate("plane/york1997-ratio", value_of("york1997.ratio"), between(1.9, 2.2),
           theory("FLIP damps nothing: growth per time does not depend on the step, growth per step is in proportion")),
      gate("plane/default-rate", value_of("default.rate"), at_most(1e-5), at_rest),
      gate("plane-uncorrected/rate", value_of("default.rate"), between(0.02931, 0.02937),
           theory(
               "0.02934 by an analysis apart from the kernel, tests/reference/gas_at_rest_test.py, to a thousandth for "
               "the wave numbers that both look at: sums over points of second derivatives of shapes are not the "
               "integrals that vanish")),
      gate(
          "plane-uncorrected/ratio", value_of("default.ratio"), between(1.9, 2.2),
          theory("damped at a rate, driven by a force: growth per time does not depend on the step, growth per step is "
                 "in proportion")),
      gate("plane-corrected/short", value_of("short"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-corrected/long", value_of("long"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-corrected/of-nine", value_of("of_nine"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-nodes/short", value_of("short"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-nodes/long", value_of("long"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-nodes/of-nine", value_of("of_nine"), at_most(1e-5), at_rest).in(Tier::full),
      gate("plane-points/uncorrected", value_of("default.of_sixteen"), at_most(0.5),
           theory("what the sums miss of the integrals falls with the square of the points' distance, to a quarter; as "
                  "much "
                  "again is left to the place of the lattice"))
          .in(Tier::full)};
}

Case stability_gas() { return trial_case("stability-gas", trials(), gates()); }
PLUMBLINE_CASE(stability_gas);

}  // namespace
}  // namespace plumbline::stability_gas
