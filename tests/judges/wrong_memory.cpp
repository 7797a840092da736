// Steps that are wrong now and then, for steps that vary, after a restart, or not twice the same.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

const Judged strain_forgotten("wrong-strain-forgotten", "musl that forgets the strain of every 50th step",
                              [count = 0](Stages& mpm, double dt) mutable {
                                musl(mpm, dt, {.strain = ++count % 50 == 0 ? 0.0 : 1.0});
                              });
const Judged every_other("wrong-every-other", "usl that skips every other step",
                         [count = 0](Stages& mpm, double dt) mutable {
                           if (++count % 2 == 1) usl(mpm, dt);
                         });
const Judged late("wrong-late", "musl that no longer strains from its 300th step on",
                  [count = 0](Stages& mpm, double dt) mutable {
                    musl(mpm, dt, {.strain = ++count < 300 ? 1.0 : 0.0});
                  });

const Judged first_dt("wrong-first-dt", "musl that takes every step as long as its first",
                      [first = 0.0](Stages& mpm, double dt) mutable {
                        if (first == 0) first = dt;
                        musl(mpm, first);
                      });
const Judged ratio("wrong-dt-ratio", "usl whose force counts this step over the last: right for equal steps alone",
                   [last = 0.0](Stages& mpm, double dt) mutable {
                     usl(mpm, dt, {.force = last == 0 ? 1 : dt / last});
                     last = dt;
                   });
const Judged mean_dt("wrong-dt-mean", "musl that strains by the geometric mean of this step and the last",
                     [last = 0.0](Stages& mpm, double dt) mutable {
                       musl(mpm, dt, {.strain = last == 0 ? 1 : std::sqrt(last / dt)});
                       last = dt;
                     });
const Judged never_longer("wrong-never-longer", "usavg whose step never becomes longer than the one before",
                          [last = 0.0](Stages& mpm, double dt) mutable {
                            last = last == 0 ? dt : std::min(dt, last);
                            usavg(mpm, last, 0.5, 0.5);
                          });

// A copy is what a run goes on with after it was saved.
class ForgetsInCopies final : public TimeIntegrator {
 public:
  ForgetsInCopies() = default;
  ForgetsInCopies(const ForgetsInCopies&) : copied_(true) {}

 private:
  void step(Stages& mpm, double dt) override {
    musl(mpm, dt, {.strain = copied_ ? 0.0 : 1.0});
    copied_ = false;
  }
  bool copied_ = false;
};
PLUMBLINE_INTEGRATOR(ForgetsInCopies, "wrong-restart", "musl that forgets the strain of the first step after a restart",
                     here);

class HiddenHistory final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { adams_bashforth(mpm, dt, history_, {23.0 / 12, -16.0 / 12, 5.0 / 12}); }
  History history_{2};
};
PLUMBLINE_INTEGRATOR(HiddenHistory, "wrong-hidden-memory",
                     "Adams-Bashforth 3 that does not name what it remembers: the points do not say how a run goes on",
                     here);

const Judged shared_count("wrong-shared-count", "musl that forgets the strain of every 97th step of all runs together",
                          [](Stages& mpm, double dt) {
                            static std::atomic<long> count = 0;
                            musl(mpm, dt, {.strain = ++count % 97 == 0 ? 0.0 : 1.0});
                          });
const Judged noise("wrong-noise", "usl whose velocities are off by 1e-9 of themselves at random: no run repeats",
                   [](Stages& mpm, double dt) {
                     thread_local std::minstd_rand random{std::random_device{}()};
                     usl(mpm, dt, {.force = 1 + 1e-9 * std::uniform_real_distribution(-1.0, 1.0)(random)});
                   });

}  // namespace
}  // namespace plumbline::judged
