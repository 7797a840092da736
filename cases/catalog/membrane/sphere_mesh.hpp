// The mesh of points on a sphere.
#pragma once

#include <vector>

#include "kernel/points/columns.hpp"
#include "kernel/surface_mesh.hpp"

namespace plumbline {

// Triangles between points on a sphere about the origin, counter-clockwise from outside: the faces of their convex hull, in whose
// circles on the sphere no other point lies (K. Q. Brown, Inf. Process. Lett. 9 (1979) 223, doi 10.1016/0020-0190(79)90074-7). Points
// are added one by one; takes the square of their number.
// Throws std::invalid_argument for fewer than four points or all in one plane, for two in one place, and where the faces do not
// close with each point for a corner, as of points that are not on a sphere.
std::vector<Triangle> sphere_mesh(const Columns& points);

}  // namespace plumbline
