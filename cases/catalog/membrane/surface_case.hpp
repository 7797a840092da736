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

  double thickness() const { return choice.law.thickness; }
};

// As many points as `ppc` says for each square of the cell size, on an area at rest, m^2.
int surface_points_on(double area, const Settings& settings, double h);

// A cell size of `size` over the cells, and a box around |x|, |y| <= across, |z| <= up with room for the stencils.
GridSpec surface_grid(const SurfaceCase& at, const Settings& settings, double across, double up);

// Means of a membrane about the origin, weighted with mass.
double mean_radius(const Columns& points);

// How far the tangents are from where the points stand: sqrt(det c) of each point over the square of its distance from the origin at
// rest, the root of which is the stretch of a sphere.
struct SphereTangents {
  double mean = 0, rms = 0, worst = 0;  // of the stretch of the tangents over that of the radius, less 1
};
SphereTangents tangents_of_sphere(const Columns& points, double radius_at_rest);

// Resultants of the points, N/m: half the trace of t S_ab f_a f_b / |f_1 x f_2|.
std::vector<double> resultants(const Columns& points, const SurfaceLaw& law);

// surface_load() of a body made by surface_body(), with what the case's tangents want beside.
void press(Body& body, const SurfaceCase& at, std::function<double(double, const Columns&)> pressure, double drag = 0);

// Studies `carried` and `refitted`, of what is not to be done.
std::vector<StudyPlan> wrong_tangents(std::vector<double> cells);

// The grid moved by a part of a cell.
std::vector<Override> shifted_grid();

}  // namespace plumbline
