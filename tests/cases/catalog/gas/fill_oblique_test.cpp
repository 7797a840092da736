// Rows of points at an angle to the grid: the same rows as along it, turned.
#include "cases/catalog/gas/fill_oblique.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::fill_oblique_test {
namespace {

constexpr double pi = std::numbers::pi;

std::shared_ptr<const IdealGas> gas() { return std::make_shared<IdealGas>(); }

GridSpec square(int cells) {
  GridSpec grid;
  grid.dim = 2;
  grid.h = 0.1;
  grid.cells = {cells, cells, 1};
  grid.origin = {-0.3, 0.2, 0};
  return grid;
}

ObliqueGas two_gases(double angle, const GridSpec& grid) {
  const double half = grid.h * grid.cells[0] / 2;
  return {angle, {grid.origin[0] + half, grid.origin[1] + half, 0}, {0.05}, [](double s) {
            return s < 0.05 ? reference::GasState{1, 2, 3} : reference::GasState{0.25, -1, 0.5};
          }};
}

Body filled(double angle, int cells = 10, bool equal_mass = true) {
  const GridSpec grid = square(cells);
  return fill_oblique(gas(), two_gases(angle, grid), {equal_mass, 8, 2, 1}, grid);
}

TEST(FillOblique, WithoutAnAngleItIsTheFillAlongTheGrid) {
  const GridSpec grid = square(10);
  const ObliqueGas oblique = two_gases(0, grid);
  GasBox box;
  box.low = {-0.3, 0.2, 0};
  box.high = {0.7, 1.2, 0};
  box.jumps = {0.25};
  box.state = [&](const Position& x) {
    const auto at = oblique.initial(x[0] - 0.2);
    return GasAt{at.density, {at.velocity, 0, 0}, at.pressure};
  };
  const Body plain = fill_gas(gas(), box, {true, 8, 2, 1}, grid), turned = filled(0);
  ASSERT_EQ(plain.points.points(), turned.points.points());
  for (const ColumnId* id : {&column::position, &column::velocity, &column::mass, &column::volume, &column::density,
                             &column::energy, &column::pressure}) {
    for (int d = 0; d < plain.points.components(*id); ++d) {
      for (int p = 0; p < plain.points.points(); ++p) {
        EXPECT_NEAR(turned.points(*id, d)[p], plain.points(*id, d)[p], 1e-13) << id->name();
      }
    }
  }
}

TEST(FillOblique, StatesFollowTheNormal) {
  for (const double angle : {0.3, pi / 4, -2.0}) {
    const Body body = filled(angle);
    const double c = std::cos(angle), s = std::sin(angle);
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = body.points(column::position, 0)[p] - 0.2, y = body.points(column::position, 1)[p] - 0.7;
      const bool left = c * x + s * y < 0.05;
      EXPECT_NEAR(body.points(column::density)[p], left ? 1 : 0.25, 1e-14);
      EXPECT_NEAR(body.points(column::velocity, 0)[p], (left ? 2 : -1) * c, 1e-14);
      EXPECT_NEAR(body.points(column::velocity, 1)[p], (left ? 2 : -1) * s, 1e-14);
      EXPECT_NEAR(body.points(column::pressure)[p], left ? 3 : 0.5, 1e-13);
      EXPECT_NEAR(body.points(column::energy)[p], left ? 7.5 : 5, 1e-13);  // [York 4.4]
      EXPECT_GT(x, -0.5);
      EXPECT_LT(x, 0.5);
      EXPECT_GT(y, -0.5);
      EXPECT_LT(y, 0.5);
    }
  }
}

// A row is short or over by half a point at most: with its length of 1/8 cell in the dense gas, 1/2 in the thin, that is
// the circumference times a quarter of a cell, and much less as the ends of rows are scattered.
TEST(FillOblique, TheMassIsThatOfTheSquareButForTheSides) {
  for (const double angle : {pi / 6, pi / 4, 2.0}) {
    for (const bool equal_mass : {true, false}) {
      const GridSpec grid = square(40);
      const Body body = filled(angle, 40, equal_mass);
      double mass = 0, volume = 0;
      for (int p = 0; p < body.points.points(); ++p) {
        mass += body.points(column::mass)[p];
        volume += body.points(column::volume)[p];
      }
      const double side = grid.h * grid.cells[0], sides = 4 * side * 0.25 * grid.h;
      EXPECT_NEAR(volume, side * side, sides) << angle;
      EXPECT_GT(mass, 0.25 * side * side);
      EXPECT_LT(mass, side * side);
    }
  }
}

// In the middle every circle of two cells holds its area: rows are nowhere doubled or left out.
TEST(FillOblique, RowsFillTheMiddle) {
  for (const double angle : {0.0, pi / 6, pi / 4}) {
    const Body body = filled(angle, 40, false);
    double volume = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = body.points(column::position, 0)[p] - 1.7, y = body.points(column::position, 1)[p] - 2.2;
      if (std::hypot(x, y) < 1) volume += body.points(column::volume)[p];
    }
    EXPECT_NEAR(volume, pi, 0.02 * pi) << angle;
  }
}

}  // namespace
}  // namespace plumbline::fill_oblique_test
