#include "cases/catalog/membrane/surface_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernel/materials/carried_membrane.hpp"
#include "kernel/materials/surface_membrane.hpp"

namespace plumbline {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 times(double factor, const Vec3& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

double norm(const Vec3& a) { return std::hypot(a[0], a[1], a[2]); }

// A vector of length 1 across n, which has length 1.
Vec3 across(const Vec3& n) {
  const auto least = static_cast<std::size_t>(
      std::min_element(n.begin(), n.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) - n.begin());
  Vec3 axis{};
  axis[least] = 1;
  const Vec3 t = cross(n, axis);
  return times(1 / norm(t), t);
}

Eigen::Vector3d vector_of(const Columns& points, const ColumnId& id, int first, int p) {
  return {points(id, first)[p], points(id, first + 1)[p], points(id, first + 2)[p]};
}

// Cells from the last direction to the first, as the nodes are counted.
std::array<double, 3> cell_of(const SurfacePoint& point, double h) {
  return {std::floor(point.place[2] / h + 0.5), std::floor(point.place[1] / h + 0.5),
          std::floor(point.place[0] / h + 0.5)};
}

std::shared_ptr<Material> material_of(const SurfaceChoice& choice) {
  if (choice.tangents != Tangents::neighbours) {
    auto carried = std::make_shared<CarriedMembrane>();
    static_cast<SurfaceLaw&>(*carried) = choice.law;
    return carried;
  }
  auto membrane = std::make_shared<SurfaceMembrane>();
  static_cast<SurfaceLaw&>(*membrane) = choice.law;
  membrane->reach = choice.reach;
  return membrane;
}

}  // namespace

std::vector<SurfacePoint> sphere_points(int count, double radius_at_rest, double stretch) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0)), radius = radius_at_rest * stretch;
  std::vector<SurfacePoint> all;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z);
    const Vec3 n{r * std::cos(golden * k), r * std::sin(golden * k), z}, first = across(n);
    all.push_back({times(radius, n), times(stretch, first), times(stretch, cross(n, first)),
                   4 * std::numbers::pi * radius_at_rest * radius_at_rest / count});
  }
  return all;
}

void move_at_random(std::vector<SurfacePoint>& sphere, double share) {
  Draws random;
  for (SurfacePoint& point : sphere) {
    const double stretch = norm(point.first), radius = norm(point.place),
                 most = share * stretch * std::sqrt(point.area);
    const double along = random() * most / stretch, across_it = random() * most / stretch;
    for (std::size_t d = 0; d < 3; ++d) point.place[d] += along * point.first[d] + across_it * point.second[d];
    const Vec3 n = times(1 / norm(point.place), point.place), first = across(n);
    point.place = times(radius, n);
    point.first = times(stretch, first);
    point.second = times(stretch, cross(n, first));
  }
}

void sweep_areas(std::vector<SurfacePoint>& sphere) {
  constexpr int sweeps = 10;
  constexpr double reach = 1.6;  // spacings
  double area = 0;
  for (const SurfacePoint& point : sphere) area += point.area;
  const double count = static_cast<double>(sphere.size());
  const double square = reach * reach * area / count * std::pow(norm(sphere.front().first), 2);
  for (int k = 0; k < sweeps; ++k) {
    std::vector<double> density;
    for (const SurfacePoint& p : sphere) {
      double sum = 0;
      for (const SurfacePoint& q : sphere) {
        double apart = 0;
        for (std::size_t d = 0; d < 3; ++d) apart += (p.place[d] - q.place[d]) * (p.place[d] - q.place[d]);
        if (apart < square) sum += q.area * (1 - apart / square) * (1 - apart / square);
      }
      density.push_back(sum);
    }
    double now = 0;
    for (std::size_t p = 0; p < sphere.size(); ++p) now += sphere[p].area /= density[p];
    for (SurfacePoint& point : sphere) point.area *= area / now;
  }
}

std::vector<SurfacePoint> disk_points(double radius, double spacing, double stretch) {
  const int rings = std::max(2, static_cast<int>(std::lround(radius / spacing)));
  const double wide = radius / rings;
  std::vector<SurfacePoint> all;
  for (int k = 0; k < rings; ++k) {
    const double r = (k + 0.5) * wide;
    const int count = std::max(3, static_cast<int>(std::lround(2 * std::numbers::pi * (k + 0.5))));
    for (int j = 0; j < count; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5 * (k % 2)) / count;
      all.push_back({{r * std::cos(angle), r * std::sin(angle), 0},
                     {stretch, 0, 0},
                     {0, stretch, 0},
                     2 * std::numbers::pi * r * wide / count / (stretch * stretch)});
    }
  }
  return all;
}

std::vector<SurfacePoint> band_points(double radius_at_rest, double height, double spacing, double around,
                                      double along) {
  const int rows = std::max(3, static_cast<int>(std::lround(height / spacing)));
  const int count = std::max(8, static_cast<int>(std::lround(2 * std::numbers::pi * radius_at_rest / spacing)));
  std::vector<SurfacePoint> all;
  for (int k = 0; k < rows; ++k) {
    const double z = height * ((k + 0.5) / rows - 0.5);
    for (int j = 0; j < count; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5 * (k % 2)) / count, c = std::cos(angle), s = std::sin(angle);
      all.push_back({{around * radius_at_rest * c, around * radius_at_rest * s, along * z},
                     {-around * s, around * c, 0},
                     {0, 0, along},
                     2 * std::numbers::pi * radius_at_rest * height / rows / count});
    }
  }
  return all;
}

void tilt(std::vector<SurfacePoint>& points, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (SurfacePoint& point : points) {
    for (Vec3* v : {&point.place, &point.first, &point.second, &point.outward})
      *v = {(*v)[0], c * (*v)[1] - s * (*v)[2], s * (*v)[1] + c * (*v)[2]};
  }
}

std::vector<OddImage> images_behind_rim(const Columns& points, double radius, double depth) {
  std::vector<OddImage> images;
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position, 0)[p], y = points(column::position, 1)[p], r = std::hypot(x, y);
    if (radius - r > depth) continue;
    const double out = (2 * radius - r) / r;
    images.push_back({p, {out * x, out * y, points(column::position, 2)[p]}});
  }
  return images;
}

Body surface_body(const std::string& name, const SurfaceChoice& choice, std::vector<SurfacePoint> points, double h,
                  const std::function<std::vector<OddImage>(const Columns&)>& images_of,
                  const std::function<std::vector<std::vector<int>>(const Columns&)>& given_of) {
  std::stable_sort(points.begin(), points.end(),
                   [h](const SurfacePoint& a, const SurfacePoint& b) { return cell_of(a, h) < cell_of(b, h); });
  const auto material = material_of(choice);
  Body body = make_body(name, material, static_cast<int>(points.size()), 3);
  Columns& columns = body.points;
  std::vector<int> sheet;
  std::vector<Vec3> outward;
  double area = 0;
  for (int p = 0; p < columns.points(); ++p) {
    const SurfacePoint& own = points[at(p)];
    for (int d = 0; d < 3; ++d) {
      columns(column::position, d)[p] = own.place[at(d)];
      columns(column::tangents, d)[p] = own.first[at(d)];
      columns(column::tangents, 3 + d)[p] = own.second[at(d)];
    }
    columns(column::volume)[p] = choice.law.thickness * own.area;
    columns(column::mass)[p] = choice.law.density * choice.law.thickness * own.area;
    area += own.area;
    sheet.push_back(own.sheet);
    if (choice.balanced) outward.push_back(own.outward);
  }
  body.spacing = std::sqrt(area / columns.points());
  if (const auto* membrane = dynamic_cast<const SurfaceMembrane*>(material.get())) {
    const std::vector<OddImage> images = images_of ? images_of(columns) : std::vector<OddImage>();
    const std::vector<std::vector<int>> given = given_of ? given_of(columns) : std::vector<std::vector<int>>();
    body.material = membrane->of_rest(columns, images, sheet, outward, given);
    if (!images.empty()) columns.add(column::clamped);
    for (const OddImage& image : images) columns(column::clamped)[image.partner] = 1;
  }
  return body;
}

Load refitting(Load load, const Columns& start, double reach) {
  return [load = std::move(load), near = surface_neighbours(start, reach).of](double time, Columns& points,
                                                                              std::span<const int> id) {
    const auto place = [&](int p) { return vector_of(points, column::position, 0, p); };
    for (int p = 0; p < points.points(); ++p) {
      const int first = near.first[at(p)], last = near.first[at(p) + 1];
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (int k = first; k < last; ++k) mean += place(near.other[at(k)]) / (last - first);
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (int k = first; k < last; ++k) {
        const Eigen::Vector3d off = place(near.other[at(k)]) - mean;
        spread += off * off.transpose();
      }
      Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
      const Eigen::Vector3d a = vector_of(points, column::tangents, 0, p),
                            b = vector_of(points, column::tangents, 3, p);
      if (normal.dot(a.cross(b)) < 0) normal = -normal;
      const Eigen::Vector3d own = a.cross(b).normalized(), axis = own.cross(normal);
      const auto turned =
          [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {  // by the least angle from `own` to `normal`
        return x + axis.cross(x) + axis.cross(axis.cross(x)) / (1 + own.dot(normal));
      };
      const Eigen::Vector3d turned_a = turned(a), turned_b = turned(b);
      for (int d = 0; d < 3; ++d) {
        points(column::tangents, d)[p] = turned_a[d];
        points(column::tangents, 3 + d)[p] = turned_b[d];
      }
    }
    load(time, points, id);
  };
}

Vec3 area_vector(const Columns& points, int p) {
  Vec3 first, second;
  for (int d = 0; d < 3; ++d) {
    first[at(d)] = points(column::tangents, d)[p];
    second[at(d)] = points(column::tangents, 3 + d)[p];
  }
  return cross(first, second);
}

double enclosed_volume(const Columns& points, double thickness) {
  double sum = 0;
  for (int p = 0; p < points.points(); ++p) {
    const Vec3 n = area_vector(points, p);
    for (int d = 0; d < 3; ++d)
      sum += points(column::volume)[p] / thickness * n[at(d)] * points(column::position, d)[p];
  }
  return sum / 3;
}

Load surface_load(double thickness, std::function<double(double time, const Columns& points)> pressure) {
  return [=, pressure = std::move(pressure)](double time, Columns& points, std::span<const int>) {
    const double p = pressure(time, points) / thickness;
    for (int k = 0; k < points.points(); ++k) {
      const Vec3 n = area_vector(points, k);
      const double share = p * points(column::volume)[k] / points(column::mass)[k];
      for (int d = 0; d < 3; ++d) {
        points(column::body_force, d)[k] = share * n[at(d)];
      }
    }
  };
}

}  // namespace plumbline
