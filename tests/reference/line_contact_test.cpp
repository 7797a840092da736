// An elastic cylinder on a flat: its patch, its depth, its creep.
#include "reference/line_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumbline::reference::line_contact_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(LineContactIdentity, HertzsPressureBearsTheForce) {  // p0 = E* a/(2 R), P = pi a p0/2 [Johnson 4.2]
  const LineContact c{2, 300, 0.25, 0.7};
  const double a = c.half_width(), stiffness = 300 / (2 * (1 - 0.25 * 0.25));
  EXPECT_NEAR(pi * a / 2 * stiffness * a / (2 * c.radius), c.force, 1e-14);
}

// The work of pressing is what both bodies store: P d(approach) with the approach's own half width gives for the cylinder and the
// layer the compliance d(approach)/dP = (1 - nu^2)/(pi E) (2 ln(4 R/a) - 2 + 2 ln(2 d/a) - 1 - nu/(1 - nu)), since
// a ~ sqrt(P). [Johnson 5.6]
TEST(LineContactIdentity, ApproachByItsCompliance) {
  const double step = 1e-5;
  LineContact low{1, 100, 0.3, 1 - step}, high{1, 100, 0.3, 1 + step};
  const double a = LineContact{1, 100, 0.3, 1}.half_width();
  const double compliance = 0.91 / (pi * 100) * (2 * std::log(4 / a) - 2 + 2 * std::log(1 / a) - 1 - 0.3 / 0.7);
  EXPECT_NEAR((high.approach(0.5) - low.approach(0.5)) / (2 * step), compliance, 1e-9);
  // By hand: E = 8 (1 - nu^2)/pi and P = 1/4 make a = 1/2 and the scale 1/32: 2 ln 8 - 1 + 2 ln 4 - 3/7.
  const LineContact wide{1, 8 * 0.91 / pi, 0.3, 0.25};
  EXPECT_NEAR(wide.half_width(), 0.5, 1e-15);
  EXPECT_NEAR(wide.approach(1), (10 * std::log(2.0) - 10.0 / 7) / 32, 1e-14);
}

// Carter's traction mu p0 (sqrt(1 - x^2/a^2) - (c/a) sqrt(1 - (x - a + c)^2/c^2)) pulls with F = mu P (1 - (c/a)^2), and an
// elliptic traction of height q strains both bodies by 2 q x/(E* a) under it: what creeps is strained evenly where it sticks. [Johnson 8.3]
TEST(LineContactIdentity, CarterSticksEvenly) {
  const LineContact c{2, 300, 0.25, 0.7};
  const double mu = 0.3, pull = 0.1, a = c.half_width(), e = 300 / (2 * (1 - 0.25 * 0.25));
  const double share = std::sqrt(1 - pull / (mu * c.force)), stuck = share * a, p0 = e * a / (2 * c.radius);
  EXPECT_NEAR(mu * p0 * pi / 2 * (a - share * stuck), pull, 1e-14);
  for (const double x : {a - 2 * stuck, a - stuck, a}) {
    const double strain = 2 * mu * p0 / e * (x / a - share * (x - a + stuck) / stuck);
    EXPECT_NEAR(c.creep(mu, pull), strain, 1e-15) << x;
  }
  EXPECT_EQ(c.creep(mu, 0), 0);
  EXPECT_NEAR(c.creep(mu, mu * c.force), mu * a / c.radius, 1e-8);  // all slips
}

}  // namespace
}  // namespace plumbline::reference::line_contact_test
