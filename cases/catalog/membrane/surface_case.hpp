// What cases of membranes in space have in common: their keys, their grid, and what they read off the points.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "cases/catalog/membrane/surface_points.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/description/measures.hpp"
#include "cases/harness/description/parameters.hpp"

namespace plumbline {

struct SurfaceCase : Parameters {
  SurfaceChoice choice;
  double size = 1;      // of the radius at rest, m
  Vec3 shift{0, 0, 0};  // of the grid, in cells
  explicit SurfaceCase(Parameters given, bool neo_hookean = false);

  // Reads the key `weights`, of closed surfaces, of those whose points know their free edges, and of flat sheets of even tension held by
  // images behind their edges. Where such a tension is uneven, balanced weights made its errors three to eight times as large.
  void choose_weights();

  double thickness() const { return choice.law.thickness; }
  double speed() const;                // of waves in the sheet at rest, m/s
  double pressure(double load) const;  // of q = p a / (E t), Pa
};

// For what is foreseen of a scene: without the factorisation that balanced weights take.
SurfaceChoice with_fitted_weights(SurfaceChoice choice);

// As many points as `ppc` says for each square of the cell size, on an area at rest, m^2.
int surface_points_on(double area, const Settings& settings, double h);

// A cell size of `size` over the cells, and a box around |x|, |y| <= across, |z| <= up with room for the stencils.
GridSpec surface_grid(const SurfaceCase& at, const Settings& settings, double across, double up);

// Velocities of points that turn about the origin as a rigid body, 1/s; with the affine ones.
void turn(Columns& points, const Vec3& spin, bool affine);

// Of the points' distances from the origin, weighted with mass.
double mean_radius(const Columns& points);

// The stretch of the tangents of a sphere about the origin, (det c)^(1/4), over that of its radius, less 1.
struct SphereTangents {
  double mean = 0, rms = 0;
};
SphereTangents tangents_of_sphere(const Columns& points, double radius_at_rest);

// v of the parabola v + c o^2 closest to pairs (o, v): where the offset is none.
double parabola_vertex(const std::vector<std::array<double, 2>>& pairs);

// Resultants of the points, N/m: the mean of the principal ones.
std::vector<double> resultants(const Columns& points, const SurfaceLaw& law);

// Of a point of a sheet in the plane of x and y: forces per length as it is, N/m.
struct PlaneResultant {
  double along, across, mixed;  // xx, yy, xy
};
PlaneResultant plane_resultant(const Columns& points, int p, const SurfaceLaw& law);

// surface_load() of a body made by surface_body(), with a drag, 1/s, and what the case's tangents want beside.
void press(Body& body, const SurfaceCase& at, std::function<double(double, const Columns&)> pressure, double drag = 0);

// Studies `carried` and `refitted`, of what is not to be done.
std::vector<StudyPlan> wrong_tangents(std::vector<double> cells);

// The grid moved by a part of a cell.
std::vector<Override> shifted_grid();

}  // namespace plumbline
