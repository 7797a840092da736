#include "kernel/inadmissible.hpp"
#include "tests/kernel/integrators/mass_on_spring.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::implicit_midpoint_test {
namespace {

// Of an oscillator the Cayley transform of its rates, a rotation: no step damps it or makes it grow. The corrections end
// when they are as small as roundings. [Implicit-Midpoint 1, 2]
TEST(ImplicitMidpoint, TurnsAnOscillator) {
  for (const double z : {0.1, 1.0, 10.0, 1000.0}) {
    const double c = (4 - z * z) / (4 + z * z), s = 4 * z / (4 + z * z);
    Eigen::Matrix2d turned;
    turned << c, s, -s, c;
    EXPECT_LE((spring_matrix("implicit-midpoint", z) - turned).cwiseAbs().maxCoeff(), 1e-12) << z;
  }
}

TEST(ImplicitMidpoint, IsOfSecondOrder) { expect_order_on_spring("implicit-midpoint", 2); }

// Newton's method knows the slope of the forces: of linear ones the first correction is the last but for rounding, which a
// wrong slope would need many for. Three rates a product, at most three products a correction. [Implicit-Midpoint 3]
TEST(ImplicitMidpoint, OneCorrectionIsEnoughForLinearForces) {
  MassOnSpring mass(0.3, 0.5);
  mass.pull = [](double u, double v) { return -4 * u - 0.7 * v; };
  find_integrator("implicit-midpoint")->make()->step(mass, 0.9);
  EXPECT_LE(mass.rates, 2 * (3 * 3 + 2) + 2);
}

// Through the kernel, on a viscous gas: y' = y + dt f((y + y')/2), all points of it. The roundings of a hundred rates.
// [Implicit-Midpoint 1, 2]
TEST(ImplicitMidpoint, SolvesItsEquation) {
  for (const int dim : {1, 2}) {
    Scene scene = scenes::rough_gas(dim, "quadratic", "flip");
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {.evaluates_stress_first = true});
    engine->initialise();
    ledger.open(engine->totals());
    const double dt = 0.3 * engine->step_limit();
    const State rate = engine->rate();  // sorts nothing: a state names points by their place
    const State before = engine->state();
    find_integrator("implicit-midpoint")->make()->step(*engine, dt);
    const State after = engine->state();
    engine->set_state(0.5 * (before + after));
    const State found = before + dt * engine->rate();
    double scale = 0, worst = 0;
    for (std::size_t k = 0; k < found.values.size(); ++k) {
      scale = std::max(scale, std::abs(dt * rate.values[k]));
      worst = std::max(worst, std::abs(found.values[k] - after.values[k]));
    }
    EXPECT_LE(worst, 1e-11 * scale) << dim;
  }
}

// Dry friction: a midpoint velocity of either sign gives a force that turns it round, and none is zero by itself.
TEST(ImplicitMidpoint, StopsWhereThereIsNoMidpoint) {
  MassOnSpring mass(0, 0.1);
  mass.pull = [](double, double v) { return v >= 0 ? -5.0 : 5.0; };
  EXPECT_THROW(find_integrator("implicit-midpoint")->make()->step(mass, 1), InadmissibleState);
}

// At rest there is nothing to find, and rounding is no failure.
TEST(ImplicitMidpoint, RestIsNoFailure) {
  MassOnSpring mass(0, 0);
  EXPECT_NO_THROW(find_integrator("implicit-midpoint")->make()->step(mass, 1));
  EXPECT_EQ(mass.u, 0);
  Scene still = scenes::rough_gas(1, "quadratic", "flip", scenes::no_gravity);
  Columns& points = still.bodies[0].points;
  std::fill_n(points(column::velocity), points.points(), 0.0);
  Simulation run(still, "implicit-midpoint", {0.2, {}});
  for (int k = 0; k < 5; ++k) EXPECT_NO_THROW(run.step(1));
}

}  // namespace
}  // namespace plumbline::implicit_midpoint_test
