// Steps that do nothing, too much, the opposite, or leave a stage out: the solutions of other equations.
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

const Judged nothing("wrong-nothing", "a step that does nothing", [](Stages&, double) {});
const Judged maps_alone("wrong-maps-alone", "maps and forces, and nothing is done with them",
                        [](Stages& mpm, double dt) { map_and_accelerate(mpm, dt); });
const Judged half("wrong-half", "musl over half of the step", [](Stages& mpm, double dt) { musl(mpm, dt / 2); });
const Judged doubled("wrong-doubled", "musl, twice", [](Stages& mpm, double dt) {
  musl(mpm, dt);
  musl(mpm, dt);
});
const Judged no_strain("wrong-no-strain", "musl without strain",
                       [](Stages& mpm, double dt) { musl(mpm, dt, {.strain = 0}); });
const Judged no_force("wrong-no-force", "usl without forces",
                      [](Stages& mpm, double dt) { usl(mpm, dt, {.force = 0}); });
const Judged no_motion("wrong-no-motion", "musl whose points stay where they are", [](Stages& mpm, double dt) {
  map_and_accelerate(mpm, dt);
  mpm.kick_points(dt);
  mpm.map_momentum();
  mpm.update_stress(dt);
});
const Judged strain_back("wrong-strain-back", "musl whose strains run backwards",
                         [](Stages& mpm, double dt) { musl(mpm, dt, {.strain = -1}); });
const Judged force_back("wrong-force-back", "usf whose forces push the other way",
                        [](Stages& mpm, double dt) { usf(mpm, dt, {.force = -1}); });
const Judged strain_twice("wrong-strain-twice", "musl that strains twice", [](Stages& mpm, double dt) {
  musl(mpm, dt);
  mpm.update_stress(dt);
});
const Judged strain_unseen("wrong-strain-unseen", "musl whose stress never follows the strain",
                           [](Stages& mpm, double dt) {
                             map_and_accelerate(mpm, dt);
                             mpm.move_points(dt);
                             mpm.map_momentum();
                             mpm.strain_points(dt);
                           });
const Judged kick_twice("wrong-kick-twice", "musl that kicks again after it has moved: under FLIP forces count twice",
                        [](Stages& mpm, double dt) {
                          map_and_accelerate(mpm, dt);
                          mpm.move_points(dt);
                          mpm.kick_points(dt);
                          mpm.map_momentum();
                          mpm.update_stress(dt);
                        });
const Judged gravity_twice("wrong-gravity-twice",
                           "musl that advances the momentum twice by the same forces: loads count twice",
                           [](Stages& mpm, double dt) {
                             map_and_accelerate(mpm, dt);
                             mpm.advance_momentum(dt);
                             mpm.move_points(dt);
                             mpm.map_momentum();
                             mpm.update_stress(dt);
                           });
const Judged not_viscous("wrong-not-viscous",
                         "usl whose stress takes strain rates of a map that is never made: no viscosity",
                         [](Stages& mpm, double dt) {
                           map_and_accelerate(mpm, dt);
                           mpm.move_points(dt);
                           mpm.strain_points(dt);
                           mpm.evaluate_stress(NodalVelocity::remapped);
                         });
const Judged old_places("wrong-old-places", "musl whose weights are those of the first step ever after",
                        [located = false](Stages& mpm, double dt) mutable {
                          if (!located) mpm.locate_points();
                          located = true;
                          mpm.map_mass_and_momentum();
                          mpm.map_forces();
                          mpm.advance_momentum(dt);
                          mpm.move_points(dt);
                          mpm.map_momentum();
                          mpm.update_stress(dt);
                        });
const Judged old_drift("wrong-drift-back", "leapfrog whose second drift takes the first one back",
                       [](Stages& mpm, double dt) { leapfrog(mpm, dt, 0.5, 0.5, -0.5); });

}  // namespace
}  // namespace plumbline::judged
