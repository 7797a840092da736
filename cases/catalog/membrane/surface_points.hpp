// Membranes in space: how their points are laid out, and the pressure on them.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "cases/harness/description/drag.hpp"
#include "kernel/materials/surface_law.hpp"
#include "kernel/points/body.hpp"
#include "kernel/surface_neighbours.hpp"

namespace plumbline {

using Vec3 = std::array<double, 3>;

// A point at the start of a run: where it stands, f_1 and f_2 there, and the area that it stands for at rest, m^2.
struct SurfacePoint {
  Vec3 place, first, second;
  double area;
  int sheet = 0;   // see surface_neighbours()
  Vec3 outward{};  // of a free edge within reach; see balance_weights()
};

// Numbers from -1 to 1, in each object the same ones.
class Draws {
 public:
  double operator()() { return 2 * static_cast<double>(numbers_() >> 11U) / 9007199254740992.0 - 1; }

 private:
  std::mt19937_64 numbers_{1997};
};

// `count` points of equal areas along a spiral (Fibonacci) on a sphere about the origin, `stretch` times as large as at rest.
std::vector<SurfacePoint> sphere_points(int count, double radius_at_rest, double stretch);

// Moves each point of a sphere along it by up to `share` of the spacing, each way by a random number: the same points for the same
// share.
void move_at_random(std::vector<SurfacePoint>& sphere, double share);
// Areas of points on a sphere whose sum, weighted around each point, is the same for all: sweeps that divide each area by its sum so
// far. The whole area is kept.
void sweep_areas(std::vector<SurfacePoint>& sphere);

// A disk about the axis z in the plane z = 0, its radius at the start, in rings `spacing` apart whose points stand as close; stretched
// alike in all directions.
std::vector<SurfacePoint> disk_points(double radius, double spacing, double stretch);
// A band about the axis z, |z| <= height / 2 at rest, in rows around it `spacing` apart whose points stand as close; stretched by
// `around` and `along` the axis.
std::vector<SurfacePoint> band_points(double radius_at_rest, double height, double spacing, double around,
                                      double along);
// Turned about the axis x.
void tilt(std::vector<SurfacePoint>& points, double angle);
// Images behind the rim of a disk, of its points no farther than `depth` from it.
std::vector<OddImage> images_behind_rim(const Columns& points, double radius, double depth);

// How a membrane knows its tangents.
//   neighbours  those of the surface through the points near it at rest, SurfaceMembrane
//   carried     by the velocity gradient of the grid, CarriedMembrane
//   refitted    carried, and turned in each step to the normal of the points near it; see refitting()
enum class Tangents { neighbours, carried, refitted };
struct SurfaceChoice {
  SurfaceLaw law;
  Tangents tangents = Tangents::neighbours;
  double reach = 2.6;
  bool balanced = false;  // weights of neighbours, see balance_weights()
};
// The points in the order of the cells of size h that they stand in, so that those of a cell are worked on together.
// images_of, given_of: images, and neighbours given, of these points in their new order; may be empty.
Body surface_body(const std::string& name, const SurfaceChoice& choice, std::vector<SurfacePoint> points, double h,
                  const std::function<std::vector<OddImage>(const Columns&)>& images_of = {},
                  const std::function<std::vector<std::vector<int>>(const Columns&)>& given_of = {});

// Of a closed surface about the origin: a third of the sum of A n . x, m^3.
double enclosed_volume(const Columns& points, double thickness);

// The load of a pressure from inside, Pa: p A f_1 x f_2.
Load surface_load(double thickness, std::function<double(double time, const Columns& points)> pressure);

// A load that first turns the tangents of each point so that their normal is that of the plane closest to the points within `reach`
// of it at rest (principal components), the same ones always. Lengths stay.
Load refitting(Load load, const Columns& start, double reach);

// f_1 x f_2 of point p.
Vec3 area_vector(const Columns& points, int p);

}  // namespace plumbline
