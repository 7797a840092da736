// What the laboratory says of the orders of integrators on a standing wave, against theory.
#include <cmath>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "cases/harness/laboratory/wave.hpp"

namespace plumbline::stability_wave {
namespace {

// Orders are those of textbooks. FLIP changes them where points strain with velocities of nodes that their own do not map to.
struct Member {
  std::string integrator;
  double strain, velocity;
  const char* why;
};

const std::vector<Member>& members() {
  static const std::vector<Member> all{
      {"usf", 1, 1, "symplectic Euler: strains take the velocities of the start"},
      {"usl", 1, 1, "strains take the nodes' velocities of the end, which the points' would not map to"},
      {"musl", 1, 1, "symplectic Euler: strains take the velocities of the end"},
      {"usavg", 2, 2, "half a strain, a kick, half a strain: symmetric"},
      {"midpoint", 1, 1,
       "the nodes' velocity of the midpoint is off from what the points' would map to by dt/2 (1 − P) a; of "
       "order dt h²"},
      {"central-difference", 2, 1, "strains as the leapfrog; velocities are those of half a step ago"},
      {"ssp-rk3", 3, 3, "a Runge-Kutta method of order three on the semi-discrete equations"},
      {"rk4", 4, 4, "a Runge-Kutta method of order four on the semi-discrete equations"},
      {"generalized-alpha", 2, 2, "of second order for every rho_b"},
      {"implicit-midpoint", 2, 2, "symmetric"}};
  return all;
}

Findings orders() {
  const StabilityProblem& wave = find_stability_problem("wave");
  Findings findings;
  for (const Member& m : members()) {
    for (const auto& [quantity, order] :
         wave.orders(stability_settings(wave, "default", {{"integrator", m.integrator}}))) {
      findings.measures.push_back(finding(m.integrator + "." + quantity, order.order));
    }
  }
  const std::vector<std::string> shown{"musl", "usavg", "rk4"};
  const StandingWave bar({}, 4, 2);
  const double t = 2.5;
  const StandingWave::Amplitudes exact = bar.exact(t);
  findings.profile.abscissa = "dt";
  findings.profile.columns = {{"dt", "h/c", "step", {}}};
  for (const std::string& name : shown) findings.profile.columns.push_back({name, "1", "largest error of " + name, {}});
  for (int steps = 48; steps <= 3072; steps *= 2) {
    findings.profile.columns[0].values.push_back(t / steps);
    for (std::size_t k = 0; k < shown.size(); ++k) {
      const StandingWave::Amplitudes found = bar.stepped({shown[k]}, t, steps);
      double worst = 0;
      for (std::size_t j = 0; j < found.size(); ++j) worst = larger(worst, std::abs(found[j] - exact[j]));
      findings.profile.columns[k + 1].values.push_back(worst);
    }
  }
  return findings;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const Member& m : members()) {
    for (const auto& [quantity, order] : {std::pair{"velocity", m.velocity}, {"strain", m.strain}}) {
      const std::string measure = m.integrator + "." + quantity;
      all.push_back(gate("orders/" + measure, value_of(measure), between(order - 0.05, order + 0.05),
                         theory(std::string("the method's order, to 0.05 for the longest steps: ") + m.why)));
    }
  }
  return all;
}

Case stability_wave() {
  return trial_case(
      "stability-wave",
      {{"orders", "orders of velocity and strain", "Truncation errors of the methods at a fixed mesh.", orders}},
      gates());
}
PLUMBLINE_CASE(stability_wave);

}  // namespace
}  // namespace plumbline::stability_wave
