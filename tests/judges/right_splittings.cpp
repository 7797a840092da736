// Right integrators made of stages: drifts and kicks in turns, and steps with one map. Orders and limits: known.json.
#include <cmath>

#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

const char* const verlet = "Swope et al. 1982, doi 10.1063/1.442716";
const char* const geometric = "Hairer, Lubich, Wanner 2006, doi 10.1007/3-540-30666-8, section I.1";

const Judged kick_first("right-symplectic-kick-first", "symplectic Euler, kick then drift", geometric,
                        [](Stages& mpm, double dt) {
                          split(mpm, dt, {0, 1, 1});
                        });
const Judged drift_first("right-symplectic-drift-first", "symplectic Euler, drift then kick", geometric,
                         [](Stages& mpm, double dt) {
                           split(mpm, dt, {1, 1});
                         });
const Judged velocity_verlet("right-velocity-verlet", "kick, drift, kick", verlet, [](Stages& mpm, double dt) {
  split(mpm, dt, {0, 0.5, 1, 0.5});
});
const Judged position_verlet("right-position-verlet", "drift, kick, drift",
                             "Tuckerman et al. 1992, doi 10.1063/1.463137",
                             [](Stages& mpm, double dt) { split(mpm, dt, composed({1})); });
const Judged mclachlan_atela("right-mclachlan-atela", "McLachlan and Atela's second-order method, not symmetric",
                             "McLachlan, Atela 1992, doi 10.1088/0951-7715/5/2/011", [](Stages& mpm, double dt) {
                               const double r = std::sqrt(0.5);
                               split(mpm, dt, {1 - r, r, r, 1 - r});
                             });
const Judged mclachlan("right-mclachlan", "McLachlan's symmetric second-order method of two kicks",
                       "McLachlan 1995, doi 10.1137/0916010", [](Stages& mpm, double dt) {
                         const double first = 0.1931833275037836;
                         split(mpm, dt, {first, 0.5, 1 - 2 * first, 0.5, first});
                       });
const Judged ruth("right-ruth3", "Ruth's third-order method", "Ruth 1983, doi 10.1109/TNS.1983.4332919",
                  [](Stages& mpm, double dt) {
                    split(mpm, dt, {7.0 / 24, 2.0 / 3, 3.0 / 4, -2.0 / 3, -1.0 / 24, 1});
                  });
const Judged forest_ruth("right-forest-ruth", "Forest and Ruth's fourth-order method",
                         "Forest, Ruth 1990, doi 10.1016/0167-2789(90)90019-L", [](Stages& mpm, double dt) {
                           const double part = 1 / (2 - std::cbrt(2.0));
                           split(mpm, dt, composed({part, 1 - 2 * part, part}));
                         });
const Judged suzuki("right-suzuki4", "Suzuki's fourth-order method of five leapfrogs",
                    "Suzuki 1990, doi 10.1016/0375-9601(90)90962-N", [](Stages& mpm, double dt) {
                      const double part = 1 / (4 - std::cbrt(4.0));
                      split(mpm, dt, composed({part, part, 1 - 4 * part, part, part}));
                    });
const Judged pefrl("right-pefrl", "the optimised fourth-order method of four kicks",
                   "Omelyan, Mryglod, Folk 2002, doi 10.1016/S0010-4655(02)00451-4", [](Stages& mpm, double dt) {
                     const double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
                     const double outer = 0.5 - lambda;
                     split(mpm, dt, {xi, outer, chi, lambda, 1 - 2 * (chi + xi), lambda, chi, outer, xi});
                   });
const Judged yoshida("right-yoshida6", "Yoshida's sixth-order method, solution A",
                     "Yoshida 1990, doi 10.1016/0375-9601(90)90092-3", [](Stages& mpm, double dt) {
                       const double w1 = -1.17767998417887, w2 = 0.235573213359357, w3 = 0.784513610477560;
                       split(mpm, dt, composed({w3, w2, w1, 1 - 2 * (w1 + w2 + w3), w1, w2, w3}));
                     });
const Judged apart("right-leapfrog-apart", "leapfrog, its last stages one by one",
                   "reports/docs/theory/step.md, \"Leapfrog\"",
                   [](Stages& mpm, double dt) { leapfrog_apart(mpm, dt, 1); });
const Judged lossy("right-leapfrog-lossy", "leapfrog that gives no losses back",
                   "Tuckerman et al. 1992, doi 10.1063/1.463137",
                   [](Stages& mpm, double dt) { leapfrog_apart(mpm, dt, 0); });
const Judged half_step_stress("right-half-step-stress", "forces with the stress of the half step",
                              "reports/docs/start.md", [](Stages& mpm, double dt) {
                                mpm.locate_points();
                                mpm.map_mass_and_momentum();
                                mpm.predict_stress(dt / 2);
                                mpm.map_forces();
                                mpm.advance_momentum(dt);
                                mpm.move_points(dt, NodalVelocity::midpoint);
                                mpm.update_stress(dt, NodalVelocity::midpoint);
                              });
const Judged two_halves("right-two-halves", "musl in two halves of the step: twice its limit",
                        "York 1997, SAND97-1893, chapter 3", [](Stages& mpm, double dt) {
                          musl(mpm, dt / 2);
                          musl(mpm, dt / 2);
                        });

}  // namespace
}  // namespace plumbline::judged
