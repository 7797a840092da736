#include "cases/catalog/membrane/surface_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/description/drag.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

double radius_of(const Columns& points, int p) {
  return std::hypot(points(column::position, 0)[p], points(column::position, 1)[p], points(column::position, 2)[p]);
}

}  // namespace

SurfaceCase::SurfaceCase(Parameters given, bool neo_hookean) : Parameters(std::move(given)) {
  SurfaceLaw& law = choice.law;
  law.neo_hookean = neo_hookean;
  law.poissons_ratio = 0.5;  // of the neo-Hookean
  law.youngs_modulus = positive("youngs_modulus", 1, "Pa", "E");
  if (!neo_hookean)
    law.poissons_ratio = number(
        {.name = "poissons_ratio", .value = 0.3, .low = 0, .high = 0.5, .high_open = true, .description = "nu"});
  law.density = positive("surface_density", 1, "kg/m^3", "density of the membrane at rest");
  law.thickness = positive("thickness", 0.01, "m", "of the membrane at rest");
  if (!(speed() > 0) || !std::isfinite(speed())) {  // times of the end are counted by it
    const std::string allowed = "such that the speed of waves is more than 0 and finite";
    throw UsageError("surface_density", fmt::format("{:g}", law.density), allowed, {},
                     fmt::format("surface_density={:g} with youngs_modulus={:g}: waves of {:g} m/s; allowed: {}",
                                 law.density, law.youngs_modulus, speed(), allowed));
  }
  size = positive("radius", 1, "m", "of the membrane at rest");
  const std::string tangents = method(
      "tangents", "neighbours", {"neighbours", "carried", "refitted"},
      "of the surface through the points near each at rest; carried by the grid's velocity gradient; or carried and "
      "turned to the normal of the points near them");
  choice.tangents = tangents == "carried"    ? Tangents::carried
                    : tangents == "refitted" ? Tangents::refitted
                                             : Tangents::neighbours;
  choice.reach = within("reach", choice.reach, "1", 1, 10, "of neighbours, over the spacing of the points at rest");
  const char* const names[] = {"shift.x", "shift.y", "shift.z"};
  for (std::size_t d = 0; d < 3; ++d) {
    shift[d] = number({.name = names[d],
                       .value = 0.0,
                       .low = 0,
                       .high = 1,
                       .high_open = true,
                       .description = "how far the grid is moved, in cells"});
  }
}

void SurfaceCase::choose_weights() {
  choice.balanced =
      method("weights", "balanced", {"balanced", "fitted"},
             "of neighbours: changed so that a uniform tension is at rest; or as moving least squares give them") ==
      "balanced";
}

double SurfaceCase::speed() const {
  const SurfaceLaw& law = choice.law;
  return std::sqrt(law.youngs_modulus / ((1 - law.poissons_ratio * law.poissons_ratio) * law.density));
}

double SurfaceCase::pressure(double load) const { return load * choice.law.youngs_modulus * thickness() / size; }

SurfaceChoice with_fitted_weights(SurfaceChoice choice) {
  choice.balanced = false;
  return choice;
}

int surface_points_on(double area, const Settings& settings, double h) {
  return whole(std::round(settings.number("ppc") * area / (h * h)));
}

GridSpec surface_grid(const SurfaceCase& at, const Settings& settings, double across, double up) {
  constexpr int room = 4;  // cells: the stencils, and the shift
  GridSpec grid;
  grid.dim = 3;
  grid.h = at.size / settings.number("cells");
  const double reach[] = {across, across, up};
  for (std::size_t d = 0; d < 3; ++d) {
    const int half = whole(std::ceil(reach[d] / grid.h)) + room;
    grid.cells[d] = 2 * half;
    grid.origin[d] = -(half + at.shift[d]) * grid.h;
  }
  return grid;
}

void turn(Columns& points, const Vec3& spin, bool affine) {
  const double cross[3][3] = {{0, -spin[2], spin[1]}, {spin[2], 0, -spin[0]}, {-spin[1], spin[0], 0}};
  if (affine) points.add(column::affine, 9);
  for (int p = 0; p < points.points(); ++p) {
    for (int d = 0; d < 3; ++d) {
      double v = 0;
      for (int e = 0; e < 3; ++e) {
        v += cross[d][e] * points(column::position, e)[p];
        if (affine) points(column::affine, 3 * d + e)[p] = cross[d][e];
      }
      points(column::velocity, d)[p] = v;
    }
  }
}

double mean_radius(const Columns& points) {
  double sum = 0, mass = 0;
  for (int p = 0; p < points.points(); ++p) {
    sum += points(column::mass)[p] * radius_of(points, p);
    mass += points(column::mass)[p];
  }
  return sum / mass;
}

SphereTangents tangents_of_sphere(const Columns& points, double radius_at_rest) {
  SphereTangents all;
  const int n = points.points();
  for (int p = 0; p < n; ++p) {
    const double stretch = std::sqrt(std::sqrt(metric_of(points, p).determinant()));
    const double off = stretch / (radius_of(points, p) / radius_at_rest) - 1;
    all.mean += off / n;
    all.rms += off * off / n;
  }
  all.rms = std::sqrt(all.rms);
  return all;
}

double parabola_vertex(const std::vector<std::array<double, 2>>& pairs) {
  double n = 0, o2 = 0, o4 = 0, v = 0, vo2 = 0;
  for (const auto& [offset, value] : pairs) {
    const double square = offset * offset;
    n += 1;
    o2 += square;
    o4 += square * square;
    v += value;
    vo2 += value * square;
  }
  return (v * o4 - vo2 * o2) / (n * o4 - o2 * o2);
}

std::vector<double> resultants(const Columns& points, const SurfaceLaw& law) {
  std::vector<double> all;
  for (int p = 0; p < points.points(); ++p) {
    const SurfaceLaw::Stresses s = law.principal_stresses(metric_of(points, p));
    all.push_back(0.5 * law.thickness * (s.largest + s.least));
  }
  return all;
}

PlaneResultant plane_resultant(const Columns& points, int p, const SurfaceLaw& law) {
  const SurfaceLaw::Metric c = metric_of(points, p);
  const SurfaceLaw::State s = law.state(c);
  const double per = law.thickness / std::sqrt(c.determinant());
  const auto pull = [&](int i, int j) {
    const auto f = [&](int a, int d) { return points(column::tangents, 3 * a + d)[p]; };
    return per * (s.first * f(0, i) * f(0, j) + s.mixed * (f(0, i) * f(1, j) + f(1, i) * f(0, j)) +
                  s.second * f(1, i) * f(1, j));
  };
  return {pull(0, 0), pull(1, 1), pull(0, 1)};
}

void press(Body& body, const SurfaceCase& at, std::function<double(double, const Columns&)> pressure, double drag) {
  body.load = with_drag(surface_load(at.thickness(), std::move(pressure)), drag);
  if (at.choice.tangents == Tangents::refitted) {
    body.load = refitting(std::move(body.load), body.points, at.choice.reach * body.spacing);
  }
}

std::vector<StudyPlan> wrong_tangents(std::vector<double> cells) {
  return {
      study("carried", "tangents carried by the velocity gradient", "Tangents relax against the true stretch.", cells)
          .with({{"tangents", "carried"}}),
      study("refitted", "carried, and turned to the normal of the points near them",
            "What is lost is in the stretch, not in the direction.", std::move(cells))
          .with({{"tangents", "refitted"}})
          .in(Tier::full)};
}

std::vector<Override> shifted_grid() { return {{"shift.x", 0.37}, {"shift.y", 0.21}, {"shift.z", 0.13}}; }

}  // namespace plumbline
