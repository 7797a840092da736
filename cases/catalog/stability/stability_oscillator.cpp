// What the laboratory says of integrators on an oscillator, against closed forms, theory and runs.
#include <cmath>
#include <utility>

#include "cases/catalog/stability/orders_in_time.hpp"
#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "reference/oscillator_limits.hpp"

namespace plumbline::stability_oscillator {
namespace {

using reference::OscillatorMethod;

// An integrator with its parameter, and what textbooks say of it.
struct Member {
  std::string label;
  std::vector<Override> choice;
  double limit, displacement, velocity;  // 1/omega; orders
};

// What integrators are when no maps filter velocities: which two velocities a strain is made of, and when.
Member member(const std::string& integrator, OscillatorMethod method, double rho_b = 1) {
  const double order = reference::oscillator_order(method);
  return {integrator, {{"integrator", integrator}}, reference::oscillator_limit(method, rho_b).value, order, order};
}

Member generalized_alpha(const std::string& rho_b) {
  Member one = member("generalized-alpha", OscillatorMethod::generalized_alpha, std::stod(rho_b));
  one.label += "." + rho_b;
  one.choice.emplace_back("rho_b", std::stod(rho_b));
  return one;
}

// Those with a limit.
std::vector<Member> limited() {
  std::vector<Member> all;
  for (const char* name : {"usf", "usl", "musl"}) all.push_back(member(name, OscillatorMethod::symplectic_euler));
  for (const char* name : {"usavg", "leapfrog"}) all.push_back(member(name, OscillatorMethod::leapfrog));
  all.push_back({"midpoint", {{"integrator", "midpoint"}}, 2, 2, 2});  // reports/docs/theory/step.md, "Midpoint"
  all.push_back(member("ssp-rk3", OscillatorMethod::ssp_rk3));
  all.push_back(member("rk4", OscillatorMethod::rk4));
  all.push_back(member("central-difference", OscillatorMethod::leapfrog));
  all.back().velocity = 1;  // left half a step behind: off by dt/2 times the acceleration
  for (const char* rho_b : {"0", "0.5", "0.8", "0.9", "1"}) all.push_back(generalized_alpha(rho_b));
  return all;
}

std::vector<Member> all_members() {
  std::vector<Member> all = limited();
  all.push_back(member("implicit-midpoint", OscillatorMethod::newmark_trapezoid));
  all.push_back({"energy", {{"integrator", "energy"}}, 0, 1, 1});  // holds the stress over a step
  return all;
}

const StabilityProblem& oscillator() { return find_stability_problem("oscillator"); }
Settings settings_of(const std::vector<Override>& choice) {
  return stability_settings(oscillator(), "default", choice);
}

Findings limits() {
  Findings findings;
  for (const Member& m : limited()) {
    const Configuration found = examine(oscillator(), "default", settings_of(m.choice), false);
    findings.measures.push_back(
        scalar_measure(m.label + ".limit", found.predicted.limit(), m.limit, 4e-16 * m.limit, oscillator().unit()));
  }
  const Configuration implicit = examine(oscillator(), "default", settings_of({{"integrator", "implicit-midpoint"}}),
                                         false);
  findings.measures.push_back(finding("implicit-midpoint.always_stable", implicit.predicted.always_stable()));
  std::vector<double> rho_b, limit, closed_form;
  for (int k = 0; k <= 20; ++k) {
    const Configuration found = examine(oscillator(), "default",
                                        settings_of({{"integrator", "generalized-alpha"}, {"rho_b", k / 20.0}}), false);
    rho_b.push_back(k / 20.0);
    limit.push_back(found.predicted.limit());
    closed_form.push_back(reference::oscillator_limit(OscillatorMethod::generalized_alpha, k / 20.0).value);
  }
  findings.profile.abscissa = "rho_b";
  findings.profile.columns = {{"rho_b", "1", "rho_b of generalized-alpha", rho_b},
                              {"limit", "1/omega", "largest stable step", limit},
                              {"limit_reference", "1/omega", "closed form", closed_form}};
  return findings;
}

// A stress held over a step whose strain follows the midpoint velocity: the matrix ((1 - z^2/2, z), (-z, 1)) of
// z = omega dt has the determinant 1 + z^2/2, and up to z = 4 complex eigenvalues.
Findings growth_of_energy() {
  const Settings settings = settings_of({{"integrator", "energy"}});
  const Configuration found = examine(oscillator(), "default", settings, true);
  double worst = 0;
  std::vector<double> dt, per_step, reference;
  for (const Growth& g : found.predicted.growth) {
    if (g.dt >= 4) continue;
    dt.push_back(g.dt);
    per_step.push_back(g.per_step);
    reference.push_back(std::sqrt(1 + g.dt * g.dt / 2));
    worst = larger(worst, std::abs(g.per_step / reference.back() - 1));
  }
  Findings findings;
  findings.measures = {scalar_measure("growth.departure", worst, 0, 1e-15, "1"),
                       finding("always_unstable", found.predicted.always_unstable()),
                       finding("seen_always_unstable", found.observed->always_unstable)};
  findings.profile.abscissa = "dt";
  findings.profile.columns = {{"dt", "1/omega", "step", dt},
                              {"growth", "1", "spectral radius", per_step},
                              {"growth_reference", "1", "its closed form", reference}};
  return findings;
}

Findings runs() {
  Findings findings;
  for (const Member& m : limited()) {
    const Settings settings = settings_of(m.choice);
    const Configuration found = examine(oscillator(), "default", settings, false);
    const Observation seen = oscillator().observed(settings, 0);
    const bool one = seen.brackets.size() == 1 && seen.brackets[0].stable_below;
    const double limit = one ? 0.5 * (seen.brackets[0].low + seen.brackets[0].high) : std::nan("");
    findings.measures.push_back(
        scalar_measure(m.label + ".observed", limit, found.predicted.limit(), 1e-8, oscillator().unit()));
  }
  const Settings implicit = settings_of({{"integrator", "implicit-midpoint"}});
  findings.measures.push_back(
      finding("implicit-midpoint.seen_always_stable", oscillator().observed(implicit, 0).always_stable));
  const Settings rk4 = settings_of({{"integrator", "rk4"}});
  const Prediction predicted = oscillator().predicted(rk4, 1e-5);
  const Observation seen = oscillator().observed(rk4, 0);
  std::vector<double> dt, growth, reference;
  for (std::size_t k = 0; k < seen.growth.size(); ++k) {
    dt.push_back(seen.growth[k].dt);
    growth.push_back(seen.growth[k].per_step);
    reference.push_back(predicted.growth[k].per_step);
  }
  findings.profile.abscissa = "dt";
  findings.profile.columns = {{"dt", "1/omega", "step", dt},
                              {"growth", "1", "growth a step in runs of rk4", growth},
                              {"growth_reference", "1", "spectral radius", reference}};
  return findings;
}

Findings orders() {
  Findings findings;
  for (const Member& m : all_members()) {
    for (const auto& [quantity, order] : oscillator().orders(settings_of(m.choice))) {
      findings.measures.push_back(finding(m.label + "." + quantity, order.order));
    }
  }
  const std::vector<std::string> shown{"musl", "leapfrog", "rk4"};
  findings.profile.abscissa = "dt";
  findings.profile.columns = {{"dt", "1/omega", "step", {}}};
  for (const std::string& name : shown) findings.profile.columns.push_back({name, "1", "error of " + name, {}});
  const Eigen::Vector2d start(1, 0);
  const double t = 2;
  for (int steps = 32; steps <= 1024; steps *= 2) {
    findings.profile.columns[0].values.push_back(t / steps);
    for (std::size_t k = 0; k < shown.size(); ++k) {
      const Eigen::Vector2d off = oscillation({shown[k]}, 0, start, t, steps) - exact_oscillation(0, start, t);
      findings.profile.columns[k + 1].values.push_back(std::abs(off[0]));
    }
  }
  return findings;
}

std::vector<Trial> trials() {
  return {{"limits", "predicted limits of every integrator", "The limits are exact.", limits},
          {"energy", "the energy-conserving step, which amplifies at every step",
           "It holds the stress over the step while points strain with the midpoint velocity.", growth_of_energy},
          {"runs", "limits that runs show", "2000 steps see growth of more than 0.1 % a step.", runs},
          {"orders", "orders of displacement and velocity", "Truncation errors of the methods.", orders}};
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  const auto is_true = [&](const std::string& trial, const std::string& measure, const std::string& why) {
    all.push_back(gate(trial + "/" + measure, value_of(measure), exactly(1), theory(why)));
  };
  for (const Member& m : limited()) {
    all.push_back(
        gate("limits/" + m.label, error_of(m.label + ".limit"), at_most(1e-6),
             theory("predicted limits equal the closed form; 1e-6 for finding the step at which a radius leaves 1")));
    all.push_back(gate("runs/" + m.label, error_of(m.label + ".observed"), at_most(0.01),
                       requirement("observed limits within 1 % of the predicted ones, all of which are above 1, a "
                                   "tenth of the margin that cfl=auto leaves below a limit")));
  }
  const std::string keeps = "the implicit midpoint rule keeps the energy of an oscillator";
  is_true("limits", "implicit-midpoint.always_stable", keeps);
  is_true("runs", "implicit-midpoint.seen_always_stable", keeps);
  all.push_back(gate("energy/growth", error_of("growth.departure"), at_most(1e-13),
                     identity("eigenvalues of a two by two matrix: a hundred roundings")));
  is_true("energy", "always_unstable", "its radius is above one at every step");
  is_true("energy", "seen_always_unstable", "the scan's smallest step already grows by 0.25 % a step");
  for (const Member& m : all_members()) {
    for (const auto& [quantity, order] : {std::pair{"displacement", m.displacement}, {"velocity", m.velocity}}) {
      const std::string measure = m.label + "." + quantity;
      all.push_back(gate("orders/" + measure, value_of(measure), between(order - 0.05, order + 0.05),
                         theory("the method's order, to 0.05 for the longest steps")));
    }
  }
  return all;
}

Case stability_oscillator() { return trial_case("stability-oscillator", trials(), gates()); }
PLUMBLINE_CASE(stability_oscillator);

}  // namespace
}  // namespace plumbline::stability_oscillator
