// Right integrators that see the semi-discrete equations alone. Orders and limits: known.json.
#include <cmath>

#include "tests/judges/methods.hpp"
#include "tests/judges/registration.hpp"

namespace plumbline::judged {
namespace {

const Judged kutta("right-kutta3", "Kutta's third-order method",
                   "Kutta 1901; Hairer, Norsett, Wanner 1993, section II.1",
                   [](Stages& mpm, double dt) { runge_kutta(mpm, dt, kutta3()); });
const Judged heun3("right-heun3", "Heun's third-order method", "Heun 1900; Hairer, Norsett, Wanner 1993, section II.1",
                   [](Stages& mpm, double dt) {
                     runge_kutta(mpm, dt, {{{}, {1.0 / 3}, {0, 2.0 / 3}}, {0.25, 0, 0.75}});
                   });
const Judged ralston3("right-ralston3", "Ralston's third-order method",
                      "Ralston 1962, doi 10.1090/S0025-5718-1962-0150954-0", [](Stages& mpm, double dt) {
                        runge_kutta(mpm, dt, {{{}, {0.5}, {0, 0.75}}, {2.0 / 9, 1.0 / 3, 4.0 / 9}});
                      });
const Judged ssp43("right-ssp-rk43", "strong-stability-preserving Runge-Kutta, four stages of order three",
                   "Spiteri, Ruuth 2002, doi 10.1137/S0036142901389025", [](Stages& mpm, double dt) {
                     const double sixth = 1.0 / 6;
                     runge_kutta(mpm, dt, {{{}, {0.5}, {0.5, 0.5}, {sixth, sixth, sixth}}, {sixth, sixth, sixth, 0.5}});
                   });
const Judged three_eighths(
    "right-rk4-38", "the 3/8 rule of order four", "Kutta 1901; Hairer, Norsett, Wanner 1993, section II.1",
    [](Stages& mpm, double dt) {
      const double third = 1.0 / 3;
      runge_kutta(mpm, dt, {{{}, {third}, {-third, 1}, {1, -1, 1}}, {0.125, 0.375, 0.375, 0.125}});
    });
const Judged dopri5("right-dopri5", "Dormand and Prince's method of order five",
                    "Dormand, Prince 1980, doi 10.1016/0771-050X(80)90013-3", [](Stages& mpm, double dt) {
                      runge_kutta(mpm, dt,
                                  {{{},
                                    {1.0 / 5},
                                    {3.0 / 40, 9.0 / 40},
                                    {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
                                   {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}});
                    });

const Judged newmark_half("right-newmark", "explicit Newmark with gamma 1/2", "Newmark 1959, J. Eng. Mech. Div. 85(3)",
                          [](Stages& mpm, double dt) { newmark(mpm, dt, 0.5); });
const Judged newmark_damped("right-newmark-damped", "explicit Newmark with gamma 0.51, which damps",
                            "Newmark 1959, J. Eng. Mech. Div. 85(3)",
                            [](Stages& mpm, double dt) { newmark(mpm, dt, 0.51); });

class AdamsBashforth3 final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { adams_bashforth(mpm, dt, history_, {23.0 / 12, -16.0 / 12, 5.0 / 12}); }
  std::vector<State*> memory() override { return history_.memory(); }
  History history_{2};
};
PLUMBLINE_INTEGRATOR(AdamsBashforth3, "right-ab3", "Adams-Bashforth 3",
                     "Bashforth, Adams 1883; Hairer, Norsett, Wanner 1993, section III.1");

// z = y + share(z), solved by putting in, which a short step makes contracting. Ends when rounding is left.
template <class Share>
State fixed_point(State z, Share&& share) {
  double last = HUGE_VAL;
  for (int k = 0; k < 100; ++k) {
    const State next = share(z);
    double change = 0;
    for (std::size_t i = 0; i < z.values.size(); ++i) change += std::pow(next.values[i] - z.values[i], 2);
    z = next;
    if (change == 0 || (k > 3 && change >= last)) break;
    last = change;
  }
  return z;
}

const Judged midpoint("right-midpoint-fixed-point", "the implicit midpoint rule, solved by fixed-point iteration",
                      "Hairer, Lubich, Wanner 2006, doi 10.1007/3-540-30666-8, section VIII.6",
                      [](Stages& mpm, double dt) {
                        const State y = mpm.state();
                        const State middle = fixed_point(y, [&](const State& z) {
                          mpm.set_state(z);
                          return y + dt / 2 * mpm.rate();
                        });
                        mpm.set_state(2.0 * middle + -1.0 * y);
                      });
const Judged trapezoid("right-trapezoid-fixed-point",
                       "the trapezoidal rule (Lobatto IIIA, Newmark's average), by fixed-point iteration",
                       "Hairer, Lubich, Wanner 2006, doi 10.1007/3-540-30666-8, section II.1",
                       [](Stages& mpm, double dt) {
                         const State start = mpm.state() + dt / 2 * mpm.rate();
                         mpm.set_state(fixed_point(start, [&](const State& z) {
                           mpm.set_state(z);
                           return start + dt / 2 * mpm.rate();
                         }));
                       });

}  // namespace
}  // namespace plumbline::judged
