// Consistent, and unstable at every step, if some only weakly: an undamped oscillation grows by a power of dt.
#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

const Judged forward_euler("weak-forward-euler", "forward Euler: growth (w dt)^2/2 a step",
                           "Hairer, Norsett, Wanner 1993, section I.7", [](Stages& mpm, double dt) {
                             runge_kutta(mpm, dt, {{{}}, {1}});
                           });
const Judged heun2("weak-heun2", "Heun's second-order method: growth (w dt)^4/8 a step",
                   "Hairer, Norsett, Wanner 1993, section II.1", [](Stages& mpm, double dt) {
                     runge_kutta(mpm, dt, {{{}, {1}}, {0.5, 0.5}});
                   });
const Judged midpoint2("weak-midpoint2", "the explicit midpoint rule: growth (w dt)^4/8 a step",
                       "Hairer, Norsett, Wanner 1993, section II.1", [](Stages& mpm, double dt) {
                         runge_kutta(mpm, dt, {{{}, {0.5}}, {0, 1}});
                       });
const Judged node("weak-rk4-node", "rk4 with 0.49 for its first node: of order 1, growth (w dt)^2/300 a step", here,
                  [](Stages& mpm, double dt) {
                    runge_kutta(mpm, dt, {{{}, {0.49}, {0, 0.5}, {0, 0, 1}}, classical().b});
                  });
const Judged third_slope("weak-rk4-third-slope",
                         "rk4 whose third slope is its second: of order 2, growth (w dt)^4/24 a step", here,
                         [](Stages& mpm, double dt) {
                           runge_kutta(mpm, dt, {{{}, {0.5}, {0.5}, {0, 0, 1}}, classical().b});
                         });
const Judged stale_force("weak-stale-force", "musl with the forces of the step before: growth (w dt)^2/2 a step", here,
                         [](Stages& mpm, double dt) {
                           map_and_accelerate(mpm, dt);
                           mpm.move_points(dt);
                           mpm.map_momentum();
                           mpm.evaluate_stress();
                           mpm.strain_points(dt);
                         });
const Judged unpredicted("weak-unpredicted",
                         "leapfrog with the stress of the start of the step: growth (w dt)^2/4 a step", here,
                         [](Stages& mpm, double dt) { leapfrog(mpm, dt, 0.5, 0, 0.5); });
const Judged less_than_half("weak-newmark", "explicit Newmark with gamma 0.49: growth (w dt)^2/200 a step",
                            "Newmark 1959, J. Eng. Mech. Div. 85(3)",
                            [](Stages& mpm, double dt) { newmark(mpm, dt, 0.49); });

class AdamsBashforth2 final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { adams_bashforth(mpm, dt, history_, {1.5, -0.5}); }
  std::vector<State*> memory() override { return history_.memory(); }
  History history_{1};
};
PLUMBLINE_INTEGRATOR(AdamsBashforth2, "weak-ab2", "Adams-Bashforth 2: growth (w dt)^4/4 a step",
                     "Bashforth, Adams 1883; Hairer, Norsett, Wanner 1993, section III.1");

}  // namespace
}  // namespace plumbline::judged
