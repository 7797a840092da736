// A bag of revolution: the slope of its volume, the work of the pressure outside, the tether.
#include "cases/catalog/coupled/bag_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/catalog/coupled/membrane.hpp"
#include "kernel/materials/material.hpp"

namespace plumbline::bag_forces_test {
namespace {

const MembraneMaterial skin{.youngs_modulus = 6e7, .poissons_ratio = 0.4, .density = 662, .thickness = 5e-4};

Columns chain_of(const Curve& curve) {
  Columns chain = revolved_body("bag", skin, curve).points;
  chain.add(column::body_force, 2);
  return chain;
}

double volume_of(const Columns& chain) {
  Curve polygon;
  for (int p = 0; p < chain.points(); ++p) {
    polygon.push_back({chain(column::position)[p], chain(column::position, 1)[p]});
  }
  return enclosed(polygon, true);
}

const Curve lens{{0, 0}, {0.1, 0.01}, {0.25, 0.08}, {0.22, 0.19}, {0.09, 0.26}, {0, 0.27}};

// [Airbag 1] The volume is a cubic of each coordinate: central differences are off by its third derivative.
TEST(BagForces, GradientOfTheVolume) {
  Columns chain = chain_of(lens);
  const int n = chain.points();
  const std::vector<double> gradient = volume_gradient(chain);
  ASSERT_EQ(gradient.size(), 2u * static_cast<std::size_t>(n));
  const double step = 1e-5;
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < n; ++p) {
      double& x = chain(column::position, d)[p];
      const double at = x;
      x = at + step;
      const double more = volume_of(chain);
      x = at - step;
      const double less = volume_of(chain);
      x = at;
      EXPECT_NEAR(gradient[static_cast<std::size_t>(d * n + p)], (more - less) / (2 * step), 1e-10) << d << " " << p;
    }
  }
}

// A uniform pressure outside does -p dV/dt to whatever motion; p times three times the volume to a uniform shrinking.
TEST(BagForces, WorkOfThePressureOutside) {
  Columns chain = chain_of(lens);
  add_outside_pressure(chain, 2000);
  double power = 0;
  for (int p = 0; p < chain.points(); ++p) {
    for (int d = 0; d < 2; ++d) {
      power -= chain(column::mass)[p] * chain(column::body_force, d)[p] * chain(column::position, d)[p];
    }
  }
  EXPECT_NEAR(power, 2000 * 3 * volume_of(chain), 1e-12 * power);
  EXPECT_GT(volume_of(chain), 0);
}

// Forces add to what is there, and along the axis they cancel: the bag is closed.
TEST(BagForces, PressureAddsAndLeavesTheBagWhereItIs) {
  Columns chain = chain_of(lens);
  add_outside_pressure(chain, 1000);
  add_outside_pressure(chain, 500);
  Columns once = chain_of(lens);
  add_outside_pressure(once, 1500);
  double lift = 0;
  for (int p = 0; p < chain.points(); ++p) {
    EXPECT_NEAR(chain(column::body_force, 0)[p], once(column::body_force, 0)[p], 1e-9 * 1500);
    lift += once(column::mass)[p] * once(column::body_force, 1)[p];
  }
  EXPECT_NEAR(lift, 0, 1e-12 * 1500 * 0.03);
}

// [Airbag 2] Force is the slope of k (d - L)^2 / 2; a slack tether does nothing.
TEST(BagForces, Tether) {
  Columns chain = chain_of(lens);
  Tether tether{.after = 3, .share = 0.25, .anchor = {0, 0.01}, .length = 0.2, .stiffness = 7e4};
  const auto energy = [&] {
    const double t = tension(chain, tether);
    return 0.5 * t * t / tether.stiffness;
  };
  const double r = 0.75 * 0.22 + 0.25 * 0.09, y = 0.75 * 0.19 + 0.25 * 0.26 - 0.01;
  EXPECT_NEAR(tension(chain, tether), 7e4 * (std::hypot(r, y) - 0.2), 1e-9);
  add_tether(chain, tether);
  const double step = 1e-6;
  for (int p = 0; p < chain.points(); ++p) {
    for (int d = 0; d < 2; ++d) {
      double& x = chain(column::position, d)[p];
      const double at = x;
      x = at + step;
      const double more = energy();
      x = at - step;
      const double less = energy();
      x = at;
      EXPECT_NEAR(chain(column::mass)[p] * chain(column::body_force, d)[p], (less - more) / (2 * step), 1e-3) << p;
    }
  }
  tether.length = 0.4;
  EXPECT_EQ(tension(chain, tether), 0);
  Columns slack = chain_of(lens);
  add_tether(slack, tether);
  for (int p = 0; p < slack.points(); ++p) EXPECT_EQ(slack(column::body_force, 1)[p], 0);
}

}  // namespace
}  // namespace plumbline::bag_forces_test
