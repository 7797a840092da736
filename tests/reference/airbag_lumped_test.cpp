// The lumped airbag: energy, momentum, symmetry, limits, and the sense in which it bounds.
#include "reference/airbag_lumped.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::airbag_lumped_test {
namespace {

AirbagProblem changed(const std::function<void(AirbagProblem&)>& change, AirbagProblem problem = {}) {
  change(problem);
  return problem;
}

const AirbagProblem york = changed([](AirbagProblem& p) {
  p.pressure = 4000;
  p.ambient_pressure = 0;
});
const AirbagProblem large = changed([](AirbagProblem& p) {
  p.mass = 8.05;
  p.probe_radius = 0.25;
  p.speed = 4.7;
});
const AirbagProblem pressed = changed([](AirbagProblem& p) { p.height = 0.3; });
const AirbagProblem problems[] = {{}, york, large, pressed};

TEST(AirbagLumped, EnergyIsKept) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    expect_zero(airbag.work(airbag.max_displacement()) - airbag.energy(), airbag.energy().value, "turn", 1e-10);
    for (double share : {0.1, 0.4, 0.8, 1.2, 1.7}) {
      const AirbagState state = airbag.at(share * airbag.time_of_max().value);
      const Bounded kinetic = Bounded(0.5) * p.mass * state.velocity * state.velocity;
      const Bounded stored = airbag.work(state.displacement);
      expect_zero(kinetic + stored - airbag.energy(), airbag.energy().value, "motion", 1e-6);
    }
  }
}

// Of a displacement that is known to b the work is known to the force times b; the bag doubles its bounds of first order.
TEST(AirbagLumped, BoundOfTheWorkIsThatOfTheForce) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    for (double share : {0.3, 0.6, 0.95}) {
      const double x = share * airbag.max_displacement().value, b = 1e-5 * x;
      const double expected = 2 * airbag.at_displacement(x).force.value * b;
      EXPECT_NEAR(airbag.work({x, b}).bound, expected, 1e-3 * expected);
    }
  }
}

TEST(AirbagLumped, ForceIsTheSlopeOfTheWork) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    for (double share : {0.05, 0.3, 0.6, 0.9}) {
      const double x = share * airbag.max_displacement().value, h = 1e-5;
      const double slope = (airbag.work(x + h) - airbag.work(x - h)).value / (2 * h);
      EXPECT_NEAR(airbag.at_displacement(x).force.value, slope, 1e-6 * airbag.peak_force().value);
    }
  }
}

TEST(AirbagLumped, MotionObeysNewton) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    const double h = 1e-4 * airbag.time_of_max().value;
    for (double share : {0.2, 0.7, 1.1, 1.6}) {
      const double t = share * airbag.time_of_max().value;
      const AirbagState before = airbag.at(t - h), here = airbag.at(t), after = airbag.at(t + h);
      const double speed = (after.displacement - before.displacement).value / (2 * h);
      const double push = (before.velocity - after.velocity).value / (2 * h) * p.mass;
      EXPECT_NEAR(here.velocity.value, speed, 1e-6 * p.speed);
      EXPECT_NEAR(here.force.value, push, 1e-5 * airbag.peak_force().value);
    }
  }
}

TEST(AirbagLumped, GoesOutAsItCameIn) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    const double duration = airbag.contact_duration().value;
    for (double share : {0.0, 0.03, 0.25, 0.44}) {
      const AirbagState in = airbag.at(share * duration), out = airbag.at((1 - share) * duration);
      expect_same(in.displacement, out.displacement);
      expect_same(in.velocity, -out.velocity);
      expect_same(in.pressure, out.pressure);
    }
    const AirbagState gone = airbag.at(duration + 0.1);
    EXPECT_EQ(gone.force.value, 0);
    EXPECT_EQ(gone.velocity.value, -p.speed);
    EXPECT_NEAR(gone.displacement.value, -0.1 * p.speed, gone.displacement.bound + 1e-15);
  }
}

TEST(AirbagLumped, StartAndTurn) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    const AirbagState start = airbag.at(0), turn = airbag.at(airbag.time_of_max().value);
    EXPECT_NEAR(start.velocity.value, p.speed, 1e-10);
    EXPECT_EQ(start.displacement.value, 0);
    EXPECT_NEAR(start.pressure.value, p.pressure, 1e-6);
    EXPECT_NEAR(turn.displacement.value, airbag.max_displacement().value, 1e-9);
    EXPECT_NEAR(turn.velocity.value, 0, turn.velocity.bound);
    EXPECT_LE(turn.velocity.bound, 1e-5 * p.speed);
    const bool was_pressed = p.height > 0;  // else it is first touched at a point
    EXPECT_EQ(start.force.value > 1, was_pressed);
  }
}

TEST(AirbagLumped, GasIsAdiabatic) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped airbag(p);
    const double ratio = airbag.start_volume().value / airbag.least_volume().value;
    EXPECT_NEAR(airbag.peak_pressure().value, p.pressure * std::pow(ratio, p.gamma), 1e-8 * p.pressure);
    const double area = pi.value * std::pow(airbag.at_displacement(airbag.max_displacement()).plate_radius.value, 2);
    EXPECT_NEAR(airbag.peak_force().value, (airbag.peak_pressure().value - p.ambient_pressure) * area, 1e-5);
  }
}

// A slow, heavy blow on a bag pressed far before: force and area hardly change, x = m v^2/(2 F).
TEST(AirbagLumped, GentleBlowMeetsAConstantForce) {
  const AirbagLumped airbag(changed([](AirbagProblem& p) {
    p.height = 0.25;
    p.speed = 0.01;
  }));
  const double force = airbag.at_displacement(0).force.value;
  const double far = airbag.energy().value / force;
  EXPECT_NEAR(airbag.max_displacement().value, far, 1e-3 * far);
  EXPECT_NEAR(airbag.time_of_max().value, 2 * far / 0.01, 1e-3 * 2 * far / 0.01);
}

// A light blow on the untouched bag: pressed area and so force grow with x, and it is half a sine. The next term of the
// area goes with the root of x over the height.
TEST(AirbagLumped, LightBlowIsHalfASine) {
  const AirbagLumped airbag(changed([](AirbagProblem& p) { p.speed = 0.01; }));
  const double far = airbag.max_displacement().value, margin = std::sqrt(far / airbag.start_height().value);
  const double omega = std::sqrt(airbag.at_displacement(far).force.value / far / 6.03);
  EXPECT_LE(margin, 0.05);
  EXPECT_NEAR(far, 0.01 / omega, margin * far);
  EXPECT_NEAR(airbag.time_of_max().value, 0.5 * pi.value / omega, margin / omega);
}

// What it bounds: less gas pressure, more energy or a longer skin let the probe in further; that is why the largest
// volume and no losses give the upper bound.
TEST(AirbagLumped, IsMonotone) {
  const double far = AirbagLumped().max_displacement().value;
  auto displacement = [](const std::function<void(AirbagProblem&)>& change) {
    return AirbagLumped(changed(change)).max_displacement().value;
  };
  EXPECT_GT(displacement([](AirbagProblem& p) { p.speed *= 1.05; }), far);
  EXPECT_GT(displacement([](AirbagProblem& p) { p.pressure -= 1000; }), far);
  EXPECT_LT(displacement([](AirbagProblem& p) { p.probe_radius = 0.15; }), far);
  EXPECT_LT(displacement([](AirbagProblem& p) { p.gamma = 1.6; }), far);
  EXPECT_GT(displacement([](AirbagProblem& p) {
              p.pressure = 4000;
              p.ambient_pressure = 0;
            }),
            far);
}

// Gas of York's outline (54.7 litres) in a bag that could hold 56.1: the isentrope from there meets the probe's energy
// later.
TEST(AirbagLumped, LimitOfABagInAnotherShape) {
  for (const AirbagProblem& p : problems) {
    const AirbagLumped full(p), other(changed([](AirbagProblem&q) { q.gas_volume = 0.0547; }, p));
    expect_same(full.displacement_limit(), full.max_displacement());
    EXPECT_EQ(other.max_displacement().value, full.max_displacement().value);
    EXPECT_GT(other.displacement_limit().value, full.max_displacement().value);
    const double left = other.bag().at(other.start_height() - other.displacement_limit()).volume.value;
    const double stored = p.pressure * 0.0547 / 0.4 * (std::pow(0.0547 / left, 0.4) - 1);
    EXPECT_NEAR(stored - p.ambient_pressure * (0.0547 - left), other.energy().value, 1e-9 * other.energy().value);
    EXPECT_LE(other.displacement_limit().bound, 1e-11);
  }
}

TEST(AirbagProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<AirbagLumped, AirbagProblem>;
  EXPECT_EQ(key([](AirbagProblem& p) { p.mass = 0; }), "mass");
  EXPECT_EQ(key([](AirbagProblem& p) { p.probe_radius = 0; }), "probe_radius");
  EXPECT_EQ(key([](AirbagProblem& p) { p.speed = 0; }), "speed");
  EXPECT_EQ(key([](AirbagProblem& p) { p.speed = 40; }), "speed");
  EXPECT_EQ(key([](AirbagProblem& p) { p.speed = 1e-5; }), "speed");
  EXPECT_EQ(key([](AirbagProblem& p) { p.meridian = -1; }), "meridian");
  EXPECT_EQ(key([](AirbagProblem& p) { p.height = 0.33; }), "height");
  EXPECT_EQ(key([](AirbagProblem& p) { p.height = 0.01; }), "height");
  EXPECT_EQ(key([](AirbagProblem& p) { p.gamma = 1; }), "gamma");
  EXPECT_EQ(key([](AirbagProblem& p) { p.pressure = 101325; }), "pressure");
  EXPECT_EQ(key([](AirbagProblem& p) { p.ambient_pressure = -1; }), "ambient_pressure");
  EXPECT_EQ(key([](AirbagProblem& p) { p.gas_volume = -1; }), "gas_volume");
  EXPECT_EQ(key([](AirbagProblem& p) { p.gas_volume = 0.0562; }), "gas_volume");
  EXPECT_EQ(refused_key([] { AirbagLumped().at(-1); }), "time");
  EXPECT_EQ(refused_key([] { AirbagLumped().at_displacement(0.2); }), "displacement");
}

}  // namespace
}  // namespace plumbline::reference::airbag_lumped_test
