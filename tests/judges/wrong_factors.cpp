// Steps that are wrong by a factor: parts per mille of strain, force, motion or heat, and weights that do not sum to one.
// Their limit for dt -> 0 is the solution of other equations.
#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

const Judged strain_short("wrong-strain-short", "musl with 0.999 of each strain",
                          [](Stages& mpm, double dt) { musl(mpm, dt, {.strain = 0.999}); });
const Judged strain_short_first("wrong-strain-short-first", "usf with 0.999 of each strain",
                                [](Stages& mpm, double dt) { usf(mpm, dt, {.strain = 0.999}); });
const Judged strain_long("wrong-strain-long", "usl with 1.001 of each strain",
                         [](Stages& mpm, double dt) { usl(mpm, dt, {.strain = 1.001}); });
const Judged strain_middle("wrong-strain-middle", "midpoint with 0.999 of each strain",
                           [](Stages& mpm, double dt) { midpoint(mpm, dt, {.strain = 0.999}); });
const Judged strain_halves("wrong-strain-halves", "usavg whose halves of the strain are 0.5 and 0.499",
                           [](Stages& mpm, double dt) { usavg(mpm, dt, 0.5, 0.499); });
const Judged force_strong("wrong-force-strong", "musl with forces 1.001 times as strong",
                          [](Stages& mpm, double dt) { musl(mpm, dt, {.force = 1.001}); });
const Judged force_weak("wrong-force-weak", "usavg with forces 0.998 times as strong",
                        [](Stages& mpm, double dt) { usavg(mpm, dt, 0.5, 0.5, {.force = 0.998}); });
const Judged force_middle("wrong-force-middle", "midpoint whose second pass has forces 1.001 times as strong",
                          [](Stages& mpm, double dt) { midpoint(mpm, dt, {.force = 1.001}); });
const Judged force_leapfrog("wrong-force-leapfrog", "leapfrog that kicks by 0.999 of the step",
                            [](Stages& mpm, double dt) { leapfrog(mpm, dt, 0.5, 0.5, 0.5, {.force = 0.999}); });
const Judged motion_short("wrong-motion-short", "usl whose points move by 0.999 of the step",
                          [](Stages& mpm, double dt) { usl(mpm, dt, {.motion = 0.999}); });
const Judged motion_long("wrong-motion-long", "midpoint whose points move by 1.001 of the step",
                         [](Stages& mpm, double dt) { midpoint(mpm, dt, {.motion = 1.001}); });
const Judged drift_long("wrong-drift-long", "leapfrog whose drifts are 0.5 and 0.501 of the step",
                        [](Stages& mpm, double dt) { leapfrog(mpm, dt, 0.5, 0.5, 0.501); });
const Judged heat_short("wrong-heat-short", "leapfrog that strains, and so heats, by 0.999 of the step",
                        [](Stages& mpm, double dt) { leapfrog_apart(mpm, dt, 1, {.strain = 0.999}); });
const Judged loss_twice("wrong-loss-twice", "leapfrog that gives the losses of maps back twice: it creates heat",
                        [](Stages& mpm, double dt) { leapfrog_apart(mpm, dt, 2); });
const Judged substeps("wrong-substeps", "musl in two parts, 0.5 and 0.499 of the step", [](Stages& mpm, double dt) {
  musl(mpm, 0.5 * dt);
  musl(mpm, 0.499 * dt);
});

const Judged rk4_weight("wrong-rk4-weight", "rk4 whose last weight is 0.165, not 1/6", [](Stages& mpm, double dt) {
  runge_kutta(mpm, dt, {classical().a, {1.0 / 6, 2.0 / 6, 2.0 / 6, 0.165}});
});
const Judged rk4_last("wrong-rk4-last", "rk4 that leaves its last stage out: weights sum to 5/6",
                      [](Stages& mpm, double dt) {
                        runge_kutta(mpm, dt, {classical().a, {1.0 / 6, 2.0 / 6, 2.0 / 6, 0}});
                      });
const Judged ssp_share("wrong-ssp-share", "ssp-rk3 whose second stage takes 0.7 of the start and 0.3 of the first",
                       [](Stages& mpm, double dt) {
                         const State y = mpm.state();
                         mpm.set_state(y + dt * mpm.rate());
                         mpm.set_state(0.7 * y + 0.3 * (mpm.state() + dt * mpm.rate()));
                         mpm.set_state(1.0 / 3 * y + 2.0 / 3 * (mpm.state() + dt * mpm.rate()));
                       });
const Judged ssp_left_out("wrong-ssp-left-out", "ssp-rk3 without its second stage: weights sum to 4/3",
                          [](Stages& mpm, double dt) {
                            const State y = mpm.state();
                            mpm.set_state(y + dt * mpm.rate());
                            mpm.set_state(1.0 / 3 * y + 2.0 / 3 * (mpm.state() + dt * mpm.rate()));
                          });
const Judged ssp_doubled("wrong-ssp-doubled", "ssp-rk3 that takes its first stage twice: weights sum to 7/6",
                         [](Stages& mpm, double dt) {
                           const State y = mpm.state();
                           mpm.set_state(y + dt * mpm.rate());
                           mpm.set_state(mpm.state() + dt * mpm.rate());
                           mpm.set_state(0.75 * y + 0.25 * (mpm.state() + dt * mpm.rate()));
                           mpm.set_state(1.0 / 3 * y + 2.0 / 3 * (mpm.state() + dt * mpm.rate()));
                         });
const Judged midpoint_kept("wrong-midpoint-kept", "the explicit midpoint rule that stays at the midpoint",
                           [](Stages& mpm, double dt) {
                             const State y = mpm.state();
                             mpm.set_state(y + dt / 2 * mpm.rate());
                             mpm.set_state(y + dt / 2 * mpm.rate());
                           });
const Judged verlet_shares("wrong-verlet-shares", "position Verlet whose drifts are 0.5 and 0.49 of the step",
                           [](Stages& mpm, double dt) {
                             split(mpm, dt, {0.5, 1, 0.49});
                           });
const Judged ruth_sign("wrong-ruth-sign", "Ruth's third-order method with 1/24 for -1/24", [](Stages& mpm, double dt) {
  split(mpm, dt, {7.0 / 24, 2.0 / 3, 3.0 / 4, -2.0 / 3, 1.0 / 24, 1});
});

class AdamsBashforth3 final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { adams_bashforth(mpm, dt, history_, {23.0 / 12, -16.0 / 12, 4.0 / 12}); }
  std::vector<State*> memory() override { return history_.memory(); }
  History history_{2};
};
PLUMBLINE_INTEGRATOR(AdamsBashforth3, "wrong-ab3-weight", "Adams-Bashforth 3 whose oldest weight is 4/12, not 5/12",
                     here);

// a' of forces that last is not a: the acceleration of the algorithm is 1 - alpha_m of itself too small.
class GeneralizedAlpha final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const double r = 0.8, alpha_m = (2 * r - 1) / (1 + r), gamma = 1.5 - alpha_m;
    const double beta = (5 - 3 * r) / ((1 + r) * (1 + r) * (2 - r));
    const State start = mpm.state(), force = mpm.velocities_of(mpm.rate());
    if (acceleration_.values.size() != force.values.size()) acceleration_ = force;
    const State next = force + -alpha_m * acceleration_;
    mpm.set_state(start + dt * ((0.5 - beta) * acceleration_ + beta * next));
    const State moved = mpm.rate();
    mpm.set_state(start + dt * (moved + -1.0 * mpm.velocities_of(moved)) +
                  dt * ((1 - gamma) * acceleration_ + gamma * next));
    acceleration_ = next;
  }
  std::vector<State*> memory() override { return {&acceleration_}; }
  State acceleration_;
};
PLUMBLINE_INTEGRATOR(GeneralizedAlpha, "wrong-alpha-norm", "generalized-alpha that forgets to divide by 1 - alpha_m",
                     here);

}  // namespace
}  // namespace plumbline::judged
