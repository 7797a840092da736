#include "cases/catalog/normals/marked_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/catalog/membrane/string.hpp"
#include "kernel/normals/normals.hpp"

namespace plumbline {
namespace {

constexpr double degree = std::numbers::pi / 180;

class NormalsProblem final : public Problem {
 public:
  NormalsProblem(const Settings& settings, const GridSpec& grid, MarkedPoints points)
      : settings_(settings),
        grid_(grid),
        points_(std::move(points)) {}

  // Waves run at 1 m/s: less than any step.
  double end_time() const override { return 1e-3 * grid_.h; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid_;
    StringState state;
    for (std::size_t p = 0; p < points_.x.size(); ++p) {
      state.place.push_back({points_.x[p], points_.y[p]});
      state.strain.push_back(0);
      if (p == 0) continue;
      state.segment_strain.push_back(0);
      state.segment_length.push_back(std::hypot(points_.x[p] - points_.x[p - 1], points_.y[p] - points_.y[p - 1]));
    }
    scene.bodies.push_back(string_body("membrane", "accumulated", {1, 1, 1, true}, state, 2));
    apply_choices(settings_, scene);
    return scene;
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const double bound = rounding_of_normals(points_);
    std::vector<Measure> all;
    for (const Choice& method : normals_methods()) {
      const std::vector<double> angles = angles_of(normals_of(simulation, method.name));
      const auto first = angles.begin() + points_.first;
      add_angles(all, method.name + ".", {first, first + judged()}, bound);
    }
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    Profile profile;
    const auto column = [&](const std::string& name, const std::string& unit, const std::string& label,
                            std::vector<double> values) {
      profile.columns.push_back({name, unit, label, std::move(values)});
    };
    std::vector<double> is_judged(points_.x.size(), 0);
    std::fill_n(is_judged.begin() + points_.first, judged(), 1);
    column("x", "m", "x", points_.x);
    column("y", "m", "y", points_.y);
    column("judged", "1", "1: judged", is_judged);
    column("normal_x", "1", "exact normal, x", points_.normal_x);
    column("normal_y", "1", "exact normal, y", points_.normal_y);
    for (const Choice& method : normals_methods()) {
      Normals n = normals_of(simulation, method.name);
      std::vector<double> angles = angles_of(n);
      for (std::size_t p = 0; p < n.x.size(); ++p) {
        if (n.x[p] * points_.normal_x[p] + n.y[p] * points_.normal_y[p] >= 0) continue;
        n.x[p] = -n.x[p];
        n.y[p] = -n.y[p];
      }
      column(method.name + ".normal_x", "1", "normal of " + method.name + ", x", std::move(n.x));
      column(method.name + ".normal_y", "1", "normal of " + method.name + ", y", std::move(n.y));
      column(method.name + ".angle_error_deg", "deg", "angle between it and the exact normal", std::move(angles));
    }
    return profile;
  }

 private:
  struct Normals {
    std::vector<double> x, y;
  };

  int judged() const { return points_.judged < 0 ? static_cast<int>(points_.x.size()) : points_.judged; }

  // Of the points as the run left them: nothing has moved.
  Normals normals_of(const Simulation& simulation, const std::string& method) const {
    const Columns& columns = simulation.scene().bodies.front().points;
    const std::size_t count = points_.x.size();
    const std::span<const double> x{columns(column::position), count}, y{columns(column::position, 1), count};
    Normals normals{std::vector<double>(count), std::vector<double>(count)};
    make_normals(method)->find({grid_, x, y, points_.other_x, points_.other_y, {}, {}, false}, normals.x, normals.y);
    return normals;
  }

  std::vector<double> angles_of(const Normals& n) const {
    std::vector<double> angles;
    for (std::size_t p = 0; p < n.x.size(); ++p) {
      angles.push_back(angle_between(n.x[p], n.y[p], points_.normal_x[p], points_.normal_y[p]));
    }
    return angles;
  }

  Settings settings_;
  GridSpec grid_;
  MarkedPoints points_;
};

}  // namespace

void MarkedPoints::add(double px, double py, double nx, double ny) {
  const double length = std::hypot(nx, ny);
  x.push_back(px);
  y.push_back(py);
  normal_x.push_back(nx / length);
  normal_y.push_back(ny / length);
}

double angle_between(double ax, double ay, double bx, double by) {
  const double cross = std::abs(ax * by - ay * bx), dot = std::abs(ax * bx + ay * by);
  return cross == 0 && dot == 0 ? 90 : std::atan2(cross, dot) / degree;
}

double rounding_of_normals(const MarkedPoints& points) {
  double nearest = std::numeric_limits<double>::infinity(), furthest = 0;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    furthest = std::max({furthest, std::abs(points.x[p]), std::abs(points.y[p])});
    for (std::size_t q = 0; q < p; ++q) {
      nearest = std::min(nearest, std::hypot(points.x[p] - points.x[q], points.y[p] - points.y[q]));
    }
  }
  return std::numeric_limits<double>::epsilon() * furthest / nearest / degree;
}

std::unique_ptr<Problem> normals_problem(const Settings& settings, const GridSpec& grid, MarkedPoints points) {
  return std::make_unique<NormalsProblem>(settings, grid, std::move(points));
}

void add_angles(std::vector<Measure>& all, const std::string& prefix, const std::vector<double>& angles, double bound) {
  double largest = 0, sum = 0;
  for (const double angle : angles) {
    largest = larger(largest, angle);
    sum += angle;
  }
  all.push_back(scalar_measure(prefix + "max_angle_error_deg", largest, 0, bound, "deg"));
  all.push_back(
      scalar_measure(prefix + "mean_angle_error_deg", sum / static_cast<double>(angles.size()), 0, bound, "deg"));
}

CaseGate angle_gate(const std::string& study, const std::string& method, double level, double bound, Because because,
                    const std::string& what) {
  return gate(study + "/" + method + "-" + what, error_at(method + "." + what + "_angle_error_deg", level),
              at_most(bound), std::move(because));
}

}  // namespace plumbline
