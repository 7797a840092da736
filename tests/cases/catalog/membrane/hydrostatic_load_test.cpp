// The load of a liquid on a chain.
#include "cases/catalog/membrane/hydrostatic_load.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cases/catalog/membrane/string.hpp"

namespace plumbline::hydrostatic_load_test {
namespace {

Body chain(const std::vector<std::array<double, 2>>& places) {
  StringState state;
  state.place = places;
  state.strain.assign(places.size(), 0);
  state.segment_strain.assign(places.size() - 1, 0);
  for (std::size_t p = 1; p < places.size(); ++p) {
    state.segment_length.push_back(std::hypot(places[p][0] - places[p - 1][0], places[p][1] - places[p - 1][1]));
  }
  Body body = string_body("chain", "segments", {1, 1, 2, true}, state, 2);
  body.points.add(column::body_force, 2);
  return body;
}

std::array<double, 2> force(const Body& body, int p) {
  const double m = body.points(column::mass)[p];
  return {m * body.points(column::body_force)[p], m * body.points(column::body_force, 1)[p]};
}

// Up a wall of 3 m: 10 - 2 y Pa to the right.
TEST(HydrostaticLoad, SharesLinearPressureByTheLever) {
  Body body = chain({{1, 0}, {1, 3}});
  hydrostatic_load(10, 2)(0, body.points, body.id);
  EXPECT_NEAR(force(body, 0)[0], 3 * (2 * 10.0 + 4) / 6, 1e-14);
  EXPECT_NEAR(force(body, 1)[0], 3 * (10.0 + 2 * 4) / 6, 1e-14);
  EXPECT_NEAR(force(body, 0)[1], 0, 1e-14);
  // In all the mean pressure, 7 Pa on 3 m, its moment int p y dy = 45 - 18.
  EXPECT_NEAR(force(body, 0)[0] + force(body, 1)[0], 21, 1e-13);
  EXPECT_NEAR(3 * force(body, 1)[0], 27, 1e-13);
}

// Archimedes: on a line around an area the liquid inside pushes down with its weight, and no way else.
TEST(HydrostaticLoad, ClosedAroundItIsTheWeight) {
  Body body = chain({{0.2, 0.1}, {1.1, 0.3}, {1.4, 1.2}, {0.3, 0.9}, {0.2, 0.1}});  // counter-clockwise: liquid inside
  hydrostatic_load(50, 3)(0, body.points, body.id);
  double sum[2] = {};
  for (int p = 0; p < 5; ++p) {
    sum[0] += force(body, p)[0];
    sum[1] += force(body, p)[1];
  }
  const double x[] = {0.2, 1.1, 1.4, 0.3}, y[] = {0.1, 0.3, 1.2, 0.9};
  double area = 0;
  for (int k = 0; k < 4; ++k) area += 0.5 * (x[k] * y[(k + 1) % 4] - x[(k + 1) % 4] * y[k]);
  EXPECT_NEAR(sum[0], 0, 1e-13);
  EXPECT_NEAR(sum[1], -3 * area, 1e-13);
}

}  // namespace
}  // namespace plumbline::hydrostatic_load_test
