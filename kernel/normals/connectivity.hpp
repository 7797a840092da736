// Tangents of a chain of points from the order in which they stand.
#pragma once

namespace plumbline {

// Unit tangents of points first ... last - 1 of a chain of `points` points, of the mean of the two adjoining segments'
// angles; at an open end that of the one segment. closed: the last point is joined to the first. Below two points
// nothing is written. Neighbours must not coincide. [York 7.1]
void chain_tangents(const double* x, const double* y, int points, int first, int last, bool closed, double* tangent_x,
                    double* tangent_y);

}  // namespace plumbline
