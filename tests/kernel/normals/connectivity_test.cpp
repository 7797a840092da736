#include "kernel/normals/connectivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/kernel/normals/curves.hpp"

namespace plumbline::connectivity_test {
namespace {

TEST(Connectivity, TangentHasTheMeanOfTheTwoAngles) {  // [York 7.1]
  const std::vector<double> x{0, 1, 1.5, 1.4}, y{0, 0.2, 1, 2};
  std::vector<double> tx(4), ty(4);
  chain_tangents(x.data(), y.data(), 4, 0, 4, false, tx.data(), ty.data());
  const auto angle = [&](std::size_t a, std::size_t b) { return std::atan2(y[b] - y[a], x[b] - x[a]); };
  const double expected[] = {angle(0, 1), (angle(0, 1) + angle(1, 2)) / 2, (angle(1, 2) + angle(2, 3)) / 2,
                             angle(2, 3)};
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(std::atan2(ty[p], tx[p]), expected[p], 1e-15);
    EXPECT_NEAR(std::hypot(tx[p], ty[p]), 1, 1e-15);
  }
}

TEST(Connectivity, AClosedChainJoinsItsEnds) {
  const test::Curve ring = test::arc(0, 0, 1, 0, 360, 12);
  std::vector<double> tx(12), ty(12);
  chain_tangents(ring.x.data(), ring.y.data(), 12, 0, 12, true, tx.data(), ty.data());
  for (std::size_t p = 0; p < 12; ++p) EXPECT_NEAR(tx[p] * ring.nx[p] + ty[p] * ring.ny[p], 0, 1e-15) << p;
}

TEST(Connectivity, ARangeWritesItsOwnPointsAlone) {
  const test::Curve ring = test::arc(0, 0, 1, 0, 90, 6);
  std::vector<double> whole_x(6), whole_y(6), tx(6, 7), ty(6, 7);
  chain_tangents(ring.x.data(), ring.y.data(), 6, 0, 6, false, whole_x.data(), whole_y.data());
  chain_tangents(ring.x.data(), ring.y.data(), 6, 2, 4, false, tx.data(), ty.data());
  for (const std::size_t p : {0, 1, 4, 5}) EXPECT_EQ(tx[p], 7);
  for (const std::size_t p : {2, 3}) EXPECT_EQ(tx[p], whole_x[p]);
}

TEST(Connectivity, OnePointHasNoTangent) {
  const double x = 1, y = 2;
  double tx = 5, ty = 6;
  chain_tangents(&x, &y, 1, 0, 1, false, &tx, &ty);
  EXPECT_EQ(tx, 5);
  EXPECT_EQ(ty, 6);
}

TEST(Connectivity, EndsOfTheOpenQuarterCircleAreOffByHalfASegment) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 179);
  const test::Normals n = test::find("connectivity", test::square(15, 0.1), quarter);
  for (std::size_t p = 0; p < quarter.size(); ++p) {
    const bool end = p == 0 || p + 1 == quarter.size();
    EXPECT_NEAR(test::angle(n.x[p], n.y[p], quarter.nx[p], quarter.ny[p]), end ? 45.0 / 179 : 0, 1e-10) << p;
  }
}

}  // namespace
}  // namespace plumbline::connectivity_test
