// Normals from circles fitted to the points nearby, by distance alone.
//
// A circle or line near the point p, in coordinates (u, v) from it with z = u^2 + v^2, is A z + n . (u, v) + D = 0.
// With |n| = 1 its value is, near p, the distance from it. The best under weights w,
//   min sum_q w_q (A z_q + n . (u_q, v_q) + D)^2,  |n| = 1                                    [Circle 1]
// has A and D eliminated like the slope and intercept of a regression; n is then the eigenvector of a 2 x 2 matrix,
//   M = <r r^T> - <z r> <z r>^T / <z^2>,  r = (u, v), averages about the mean                [Circle 2]
// of its smaller eigenvalue: in closed form, exact for points on a circle or on a line in any direction. That is the
// algebraic fit of V. Pratt (SIGGRAPH 1987, doi 10.1145/37401.37420) and of algebraic point set surfaces (Guennebaud,
// Gross 2007, doi 10.1145/1276377.1276406) with the gradient normed where the normal is wanted.
#pragma once

#include <array>
#include <vector>

#include "kernel/normals/normals.hpp"
#include "kernel/normals/point_cells.hpp"

namespace plumbline {

// Two passes. The first takes the four points nearest to p and has the circle go through p. The second takes all within
// the radius b, and trusts them the less the further they are from the first circle, e, so that another sheet of the
// membrane does not count:
//   w = (1 - z/b^2)^2 / (1 + e^2 / (s^2 (1 + z/d^2)))^2,  d: distance of the fifth point, s = d/10, b = 5d/2 [Circle 3]
// For points evenly along a line d is three spacings, s a third of one, and fourteen neighbours are within b; b is at
// most a cell edge. Where fewer than two points are that near, the search goes out to two, four, ... cells as far as
// the grid. Two points: the chord. Sheets should be four spacings apart at least.
class CircleFit final : public NormalsMethod {
 public:
  void find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) override;

 private:
  struct Circle {
    double normal_x, normal_y, bend;  // n and A
  };
  struct Moments {
    double zz = 0, zu = 0, zv = 0, uu = 0, uv = 0, vv = 0;
  };
  static constexpr int nearest = 5;
  static constexpr double trusted = 0.1, widest = 2.5;  // s/d and b/d

  static Circle fit(const Moments& m);
  void gather(double x, double y, double reach);
  Circle first_circle() const;
  Circle second_circle(const Circle& first) const;

  PointCells points_;
  // Points within reach of p, p itself among them, and images: lengths in units of the reach.
  std::vector<double> u_, v_, z_;
  std::size_t count_ = 0;
  // The nearest, in the order of their distances, p itself left out.
  std::array<std::size_t, nearest> near_{};
  std::array<double, nearest> near_z_{};
  int near_count_ = 0;
};

}  // namespace plumbline
