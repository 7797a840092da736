// Normals of surfaces in space by tangents, by fits and by York's mass matrix, before and after the surface has moved far.
#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/catalog/normals/space_mass_matrix.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/normals/surface_fit.hpp"

namespace plumbline::surfaces {
namespace {

using Vec = Eigen::Vector3d;
constexpr double degree = std::numbers::pi / 180;
constexpr double from_edge = 4;  // cells: points of a cylinder nearer to its free edges are not judged

struct Surfaces : SurfaceCase {
  std::string surface;
  double jitter, reach;
  bool moved;

  explicit Surfaces(Parameters given = {}) : SurfaceCase(std::move(given)) {
    surface = one_of("surface", "sphere", {"cylinder", "ellipsoid", "sphere"}, "what the points stand on");
    jitter = within("jitter", 0.3, "1", 0, 0.4, "points are moved by up to so many of their spacings");
    reach = within("fit_reach", 1.5, "1", 0.5, 10, "of fits, in cells");
    moved = one_of("motion", "none", {"none", "twist"},
                   "of the points before normals are found: none, or stretched and "
                   "twisted") == "twist";
  }
};

// Stretched along the axes and twisted about z.
struct Twist {
  static constexpr double rate = 0.8;  // 1/m
  static Vec stretches() { return {1.3, 0.9, 1.4}; }
  static Eigen::Matrix3d turn(double z) { return Eigen::AngleAxisd(rate * z, Vec::UnitZ()).toRotationMatrix(); }
  static Vec place(const Vec& x) { return turn(x[2]) * stretches().cwiseProduct(x); }
  // F^-T n.
  static Vec normal(const Vec& x, const Vec& n) {
    const Eigen::Matrix3d r = turn(x[2]);
    Eigen::Matrix3d f = r * stretches().asDiagonal();
    f.col(2) += rate * Vec::UnitZ().cross(place(x));
    return (f.inverse().transpose() * n).normalized();
  }
};

std::vector<SurfacePoint> ellipsoid_points(const Surfaces& at, int count) {
  const Vec axes = at.size * Vec(1, 0.8, 0.6);
  std::vector<SurfacePoint> all = sphere_points(count, 1, 1);
  move_at_random(all, at.jitter);
  for (SurfacePoint& point : all) {
    const Vec place(point.place[0], point.place[1], point.place[2]);
    const Vec n = place.cwiseQuotient(axes).normalized();
    const Vec first = n.unitOrthogonal(), second = n.cross(first), x = place.cwiseProduct(axes);
    for (int d = 0; d < 3; ++d) {
      const auto k = static_cast<std::size_t>(d);
      point.place[k] = x[d];
      point.first[k] = first[d];
      point.second[k] = second[d];
    }
  }
  return all;
}

std::vector<SurfacePoint> cylinder_points(const Surfaces& at, double height, double spacing) {
  Draws random;
  std::vector<SurfacePoint> all = band_points(at.size, height, spacing, 1, 1);
  for (SurfacePoint& point : all) {
    const double angle = std::atan2(point.place[1], point.place[0]) + at.jitter * spacing / at.size * random();
    point.place = {at.size * std::cos(angle), at.size * std::sin(angle),
                   point.place[2] + at.jitter * spacing * random()};
    point.first = {-std::sin(angle), std::cos(angle), 0};
    point.second = {0, 0, 1};
  }
  return all;
}

// Points of a surface as they stand when normals are wanted, their exact normals, and those by each method.
class Marked {
 public:
  explicit Marked(const Settings& settings) : at_(settings), h_(at_.size / settings.number("cells")) {
    const double height = 2 * at_.size + 2 * from_edge * h_;
    const double spacing = h_ / std::sqrt(settings.number("ppc"));
    if (at_.surface == "cylinder") {
      points_ = cylinder_points(at_, height, spacing);
    } else {
      const int count = surface_points_on(4 * std::numbers::pi * at_.size * at_.size, settings, h_);
      points_ = at_.surface == "ellipsoid" ? ellipsoid_points(at_, count) : sphere_points(count, at_.size, 1);
      if (at_.surface == "sphere") move_at_random(points_, at_.jitter);
    }
    for (const SurfacePoint& point : points_) {
      const Vec x(point.place[0], point.place[1], point.place[2]);
      const Vec n = Vec(point.first[0], point.first[1], point.first[2])
                        .cross(Vec(point.second[0], point.second[1], point.second[2]))
                        .normalized();
      place_.push_back(at_.moved ? Twist::place(x) : x);
      exact_.push_back(at_.moved ? Twist::normal(x, n) : n);
      judged_.push_back(at_.surface != "cylinder" || std::abs(x[2]) < at_.size);
    }
  }

  double h() const { return h_; }
  const std::vector<SurfacePoint>& start() const { return points_; }
  const std::vector<Vec>& place() const { return place_; }
  bool is_judged(std::size_t p) const { return judged_[p]; }

  // Of each judged point, degrees; 90 where a method has no direction.
  std::vector<double> angles(const std::vector<Vec>& normals) const {
    std::vector<double> all;
    for (std::size_t p = 0; p < normals.size(); ++p) {
      if (!is_judged(p)) continue;
      const double across = normals[p].cross(exact_[p]).norm(), along = std::abs(normals[p].dot(exact_[p]));
      all.push_back(across == 0 && along == 0 ? 90 : std::atan2(across, along) / degree);
    }
    return all;
  }
  std::vector<Vec> fitted(SurfaceFit fit) const { return fitted_normals(place_, at_.reach * h_, fit); }
  // f_1 x f_2 of the neighbours of the start, wherever these stand now.
  std::vector<Vec> by_tangents() const {
    Columns points(static_cast<int>(points_.size()));
    points.add(column::position, 3);
    points.add(column::tangents, 6);
    double area = 0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      area += points_[p].area / static_cast<double>(points_.size());
      for (int d = 0; d < 3; ++d) {
        const auto k = static_cast<std::size_t>(d);
        points(column::position, d)[p] = points_[p].place[k];
        points(column::tangents, d)[p] = points_[p].first[k];
        points(column::tangents, 3 + d)[p] = points_[p].second[k];
      }
    }
    const SurfaceNeighbours::Links of = surface_neighbours(points, at_.choice.reach * std::sqrt(area)).of;
    std::vector<Vec> normals;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      Vec first = Vec::Zero(), second = Vec::Zero();
      for (int k = of.first[p]; k < of.first[p + 1]; ++k) {
        const auto link = static_cast<std::size_t>(k);
        const Vec& x = place_[static_cast<std::size_t>(of.other[link])];
        first += of.along[link] * x;
        second += of.across[link] * x;
      }
      normals.push_back(first.cross(second));
    }
    return normals;
  }

 private:
  Surfaces at_;
  double h_;
  std::vector<SurfacePoint> points_;
  std::vector<Vec> place_, exact_;
  std::vector<bool> judged_;
};

class SurfaceNormals final : public Problem {
 public:
  explicit SurfaceNormals(const Settings& settings) : settings_(settings), at_(settings_), marked_(settings) {}

  // Waves run less than a step far.
  double end_time() const override { return 1e-3 * marked_.h() / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid = surface_grid(at_, settings_, at_.size, at_.size + from_edge * marked_.h());
    scene.bodies.push_back(surface_body("surface", at_.choice, marked_.start(), marked_.h()));
    apply_choices(settings_, scene);
    return scene;
  }

  std::vector<Measure> measures(const Simulation&) const override {
    // Rounding of places over the distance between neighbours.
    const double bound = std::numeric_limits<double>::epsilon() * 4 * at_.size / marked_.h() *
                         std::sqrt(settings_.number("ppc")) / degree;
    std::vector<Measure> all;
    for (const auto& [method, normals] : by_method()) {
      double square = 0, largest = 0;
      const std::vector<double> angles = marked_.angles(normals);
      for (const double angle : angles) {
        square += angle * angle / static_cast<double>(angles.size());
        largest = larger(largest, angle);
      }
      all.push_back(scalar_measure(method + ".rms_angle_error_deg", std::sqrt(square), 0, bound, "deg"));
      all.push_back(scalar_measure(method + ".max_angle_error_deg", largest, 0, bound, "deg"));
    }
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.abscissa = "z";
    std::vector<double> z;
    for (std::size_t p = 0; p < marked_.place().size(); ++p) {
      if (marked_.is_judged(p)) z.push_back(marked_.place()[p][2]);
    }
    profile.columns.push_back({"z", "m", "z", std::move(z)});
    for (const auto& [method, normals] : by_method()) {
      profile.columns.push_back({method + ".angle_error_deg", "deg",
                                 "angle between the normal by " + method + " and the exact one",
                                 marked_.angles(normals)});
    }
    return profile;
  }

 private:
  std::vector<std::pair<std::string, std::vector<Vec>>> by_method() const {
    return {{"tangents", marked_.by_tangents()},
            {"plane-fit", marked_.fitted(SurfaceFit::plane)},
            {"quadric-fit", marked_.fitted(SurfaceFit::quadric)},
            {"york-mass-matrix", space_mass_matrix_normals(marked_.place(), marked_.h())}};
  }

  Settings settings_;
  Surfaces at_;
  Marked marked_;
};

const std::vector<double> levels{4, 5, 6, 8, 10};

StudyPlan on(const char* id, const char* title, const char* orders, const char* surface, const char* motion) {
  return study(id, title, orders, levels)
      .with({{"surface", surface}, {"motion", motion}})
      .in_full({4, 6, 8, 12, 16, 24});
}

std::vector<StudyPlan> studies() {
  const char* even = "Heights of a sphere or a cylinder have no terms of third order: order 3 by quadrics.";
  const char* odd = "Terms of third order are left over: order 2 by quadrics and by tangents.";
  return {on("sphere", "on a sphere", even, "sphere", "none"),
          on("cylinder", "on a cylinder, away from its edges", even, "cylinder", "none"),
          on("ellipsoid", "on an ellipsoid", odd, "ellipsoid", "none"),
          on("moved", "on the ellipsoid, stretched by up to 1.4 and twisted", odd, "ellipsoid", "twist"),
          study("sixteen", "on a sphere, sixteen points to a cell's area", "One mesh.", {8})
              .with({{"surface", "sphere"}, {"ppc", 16.0}})};
}

std::vector<CaseGate> gates() {
  const std::string rms = ".rms_angle_error_deg", largest = ".max_angle_error_deg", stamp = "2026-11-27 fbc282b";
  const Because third = theory(
                    "what a quadratic leaves over is of fourth order in the distance: slopes are off by its cube; "
                    "0.2 for coarse meshes"),
                second = theory(
                    "what a quadratic leaves over is of third order in the distance: slopes are off by its square; "
                    "0.2 for coarse meshes"),
                first = theory(
                    "a plane leaves the curvature over: slopes are off by the distance, on irregular points; 0.1 "
                    "for coarse meshes"),
                arrow = requirement("three degrees, what a drawn arrow shows, at every point");
  // Of a sphere, at 8 cells: the slope of r^4/(8 R^3) where fits reach to.
  const double left_over = std::pow(1.5 / 8, 3) / 2 / degree;
  const std::string undetermined =
      "a cell has eight colours and, of one layer, some four points: of the many that suit them those of minimum norm "
      "have no layer in them";
  std::vector<CaseGate> all;
  for (const std::string study : {"sphere", "cylinder", "ellipsoid", "moved"}) {
    const bool even = study == "sphere" || study == "cylinder";
    for (const std::string method : {"tangents", "quadric-fit"}) {
      all.push_back(gate(study + "/" + method + "-order", fitted_order_of(method + rms), at_least(even ? 2.8 : 1.8),
                         even ? third : second));
      all.push_back(gate(study + "/" + method + "-8", error_at(method + largest, 8), at_most(even ? left_over : 3),
                         even ? theory("the slope of what a quadratic leaves over, as far as fits reach") : arrow));
    }
    all.push_back(gate(study + "/plane-fit-order", fitted_order_of("plane-fit" + rms), at_least(0.9), first));
    all.push_back(gate(study + "/plane-fit-8", error_at("plane-fit" + largest, 8), at_most(3), arrow));
  }
  const auto york = [&](const char* study, const std::string& why, Range band) {
    return gate(std::string(study) + "/york-mass-matrix-8", error_at("york-mass-matrix" + rms, 8), at_most(3),
                literature(
                    "York, section 7.8, has his mass matrix in the plane as accurate as connectivity: a drawn arrow"))
        .fails(why, band, stamp);
  };
  all.push_back(york("sphere", undetermined, {25.5, 33.5}));
  all.push_back(york("ellipsoid", undetermined, {16.2, 21.5}));
  all.push_back(york("sixteen",
                     "with sixteen points a cell some cells have their eight, those that the surface cuts a "
                     "corner of have not",
                     {6.5, 8.7}));
  return all;
}

Case normals_surface() {
  return {.name = "normals-surface",
          .kind = Kind::membrane,
          .keys = Surfaces().keys(),
          .sets = {{"cells", 8.0}},
          .york_step = courant_number(0.3),
          .problem = run_of<SurfaceNormals>,
          .studies = studies(),
          .gates = gates(),
          .levels = levels};
}
PLUMBLINE_CASE(normals_surface);

}  // namespace
}  // namespace plumbline::surfaces
