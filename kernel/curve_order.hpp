// Who follows whom among points of a curve, from where they stand alone.
#pragma once

#include <span>
#include <vector>

namespace plumbline {

struct CurveOrder {
  std::vector<int> points;  // each once, along the curve
  bool closed = false;      // the last is a neighbour of the first
};

// A point's neighbours are the nearest other point q and the nearest s on the other side of it, (q - p) . (s - p) < 0; two points
// are joined where each is a neighbour of the other. [Curve 1] (Dey and Kumar 1999, A simple provable algorithm for curve
// reconstruction, SODA, pp. 893-894: right where points are nearer to each other than a third of the distance to the curve's medial
// axis. What is not chosen by both is how the ends of an open curve are known.)
//   x, y   m, of two points at least
// An open curve starts at the end with the lower number, a closed one at point 0, on to its neighbour of the lower number. Takes
// the square of the number of points. Throws std::invalid_argument where the points are not joined to one curve.
CurveOrder order_along_curve(std::span<const double> x, std::span<const double> y);

}  // namespace plumbline
