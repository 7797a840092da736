#include "cases/catalog/normals/marked_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/judge/gates.hpp"
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
      double largest = 0, sum = 0;
      for (std::size_t k = 0; k < judged(); ++k) {
        const double angle = angles[static_cast<std::size_t>(points_.first) + k];
        largest = larger(largest, angle);
        sum += angle;
      }
      all.push_back(scalar_measure(method.name + ".max_angle_error_deg", largest, 0, bound, "deg"));
      all.push_back(
          scalar_measure(method.name + ".mean_angle_error_deg", sum / static_cast<double>(judged()), 0, bound, "deg"));
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
    for (std::size_t k = 0; k < judged(); ++k) is_judged[static_cast<std::size_t>(points_.first) + k] = 1;
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

  std::size_t judged() const {
    return points_.judged < 0 ? points_.x.size() : static_cast<std::size_t>(points_.judged);
  }

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

std::string measure_of(const std::string& method, const std::string& what) {
  return method + "." + what + "_angle_error_deg";
}

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

CaseGate angle_gate(const std::string& study, const std::string& method, const std::string& what, double level,
                    double bound, Origin origin, const std::string& reason) {
  return error_gate(study, measure_of(method, what), level,
                    declare(study + "/" + method + "-" + what, {{}, bound}, origin, reason));
}

CaseGate failing_angle_gate(const std::string& study, const std::string& method, const std::string& what, double level,
                            double bound, const std::string& reason, const std::string& cause, Range band,
                            const std::string& stamp) {
  return error_gate(
      study, measure_of(method, what), level,
      expected_failure(declare(study + "/" + method + "-" + what, {{}, bound}, Origin::literature, reason), cause, band,
                       stamp));
}

CaseGate angle_ratio_gate(const std::string& study, const std::string& measure, const std::string& over_study,
                          const std::string& over_measure, double level, Gate gate) {
  gate.quantity = measure + " over " + over_measure + (over_study == study ? "" : " of " + over_study);
  CaseGate g = study_gate(
      study, std::move(gate),
      [=](const StudyResult& result) {
        const StudyResult* other = over_study == study ? &result : result.sibling(over_study);
        const StudyLevel *here = result.level(level), *there = other ? other->level(level) : nullptr;
        const Measure *above = here ? here->run.find(measure) : nullptr,
                      *below = there ? there->run.find(over_measure) : nullptr;
        Measured measured;
        measured.value = above && below ? above->error / below->error : std::nan("");
        measured.scale = 1;
        if (above && below) {
          measured.reference_bound = (above->reference_bound + *measured.value * below->reference_bound) / below->error;
        }
        return measured;
      },
      {level});
  if (over_study != study) g.also = {over_study};
  return g;
}

}  // namespace plumbline
