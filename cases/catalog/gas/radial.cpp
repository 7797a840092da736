#include "cases/catalog/gas/radial.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

using std::numbers::pi;

std::vector<std::string> names(const std::vector<RadialGeometry>& all) {
  std::vector<std::string> found;
  for (const RadialGeometry& geometry : all) found.push_back(geometry.name);
  return found;
}

double measure_of_ball(int dimension) { return dimension == 2 ? pi : 4 * pi / 3; }

}  // namespace

const std::vector<RadialGeometry>& radial_geometries(int dimension) {
  static const std::vector<RadialGeometry> cylinder{{"axisymmetric", 2, 2, true, true}, {"plane", 2, 2, false}};
  static const std::vector<RadialGeometry> sphere{{"axisymmetric", 3, 2, true}, {"3d", 3, 3, false}};
  return dimension == 2 ? cylinder : sphere;
}

const RadialGeometry& radial_geometry(int dimension, const std::string& name) {
  const auto& all = radial_geometries(dimension);
  for (const RadialGeometry& geometry : all) {
    if (geometry.name == name) return geometry;
  }
  throw unknown_name("geometry", name, names(all));
}

Key geometry_key(int dimension, std::string by_default) {
  return {.name = "geometry",
          .value = std::move(by_default),
          .choices = names(radial_geometries(dimension)),
          .description = dimension == 2 ? "a slice of rings, or a quarter of the cylinder in the plane"
                                        : "a quarter of the section, by rings, or the octant"};
}

double radius_of(const RadialGeometry& geometry, const Position& x) {
  switch (geometry.spread()) {
    case 1:
      return x[0];
    case 2:
      return std::hypot(x[0], x[1]);
    default:
      return std::hypot(x[0], x[1], x[2]);
  }
}

Position radial_direction(const RadialGeometry& geometry, const Position& x) {
  const double r = radius_of(geometry, x);
  Position n{};
  for (std::size_t d = 0; r > 0 && d < static_cast<std::size_t>(geometry.spread()); ++d) n[d] = x[d] / r;
  return n;
}

double share_of_whole(const RadialGeometry& geometry, double h) {
  if (geometry.slice) return slice_height(h) / (2 * pi);
  if (geometry.axisymmetric) return 0.5 / (2 * pi);
  return geometry.dim == 2 ? 0.25 : 0.125;
}

double space_within(const RadialGeometry& geometry, double radius, double h) {
  return share_of_whole(geometry, h) * measure_of_ball(geometry.dimension) * std::pow(radius, geometry.dimension);
}

double cell_size(const GasFlow& flow, const Settings& settings) { return flow.cells_along / settings.number("cells"); }

void set_geometry(GasFlow& flow, const RadialGeometry& geometry, double length, const Settings& settings) {
  if (settings.number("offset") != 0) {
    throw UsageError("offset", to_text(settings["offset"]), "0", {},
                     "offset: a wall must stand at the centre of a cylinder or sphere");
  }
  const double h = cell_size(flow, settings);
  flow.dim = geometry.dim;
  flow.axisymmetric = geometry.axisymmetric;
  flow.low = {};
  for (std::size_t d = 0; d < static_cast<std::size_t>(geometry.dim); ++d) {
    const bool along = static_cast<int>(d) < geometry.spread();
    flow.high[d] = along ? h * std::ceil(length / h - 1e-9) : slice_height(h);
  }
  flow.axis = 0;
  flow.lines = geometry.slice ? 2 : settings.integer("ppc");
  flow.coordinate = [geometry](const Position& x) { return radius_of(geometry, x); };
  flow.direction = [geometry](const Position& x) { return radial_direction(geometry, x); };
  flow.abscissa = "radius";
  flow.filled = false;
}

Measure coverage_within(const RadialGeometry& geometry, const std::vector<GasSample>& points, double radius, double h) {
  double volume = 0;
  for (const GasSample& p : points) volume += p.coordinate <= radius ? p.volume : 0;
  return scalar_measure("coverage", volume / space_within(geometry, radius, h), 1.0, 0.0, "1");
}

CaseGate radial_coverage_gate(const std::string& study, double level) {
  return gate(study + "/coverage-" + to_text(level), value_at("coverage", level), between(0.98, 1.02),
              theory("volumes of the points judged against their space: a circle through a lattice some tens of points "
                     "away cuts it to half a percent, and a kernel of three cells moves little across it"));
}

}  // namespace plumbline
