// Normals of points in a single cell. [York sections 7.6, 7.7]
#include <array>
#include <cmath>
#include <numbers>

#include "cases/catalog/normals/marked_points.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

constexpr double block =
    3;  // cells along a side of the grid, of 1 m; York's cell is the middle one, from (0, 0) to (1, 1)
constexpr const char* measured_on = "2026-11-21 6c78473";
constexpr const char* narrower = "2026-11-23 5825b24";

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// Eight points at these distances from the centre of the cell.
using Distances = std::array<double, 8>;
constexpr Distances even{-0.42, -0.3, -0.18, -0.06, 0.06, 0.18, 0.3, 0.42};
constexpr Distances uneven{-0.45, -0.4, -0.22, -0.1, 0.03, 0.2, 0.33, 0.44};

// Through (x, y), upright where degrees is 90.
template <class Along>
MarkedPoints line(double x, double y, double degrees, const Along& along) {
  const double tx = degrees == 90 ? 0 : std::cos(radians(degrees)), ty = std::sin(radians(degrees));
  MarkedPoints points;
  for (const double t : along) points.add(x + t * tx, y + t * ty, -ty, tx);
  return points;
}

// York's arc of radius 0.4 turned about the centre of the cell, `towards` its middle point, degrees from the x axis.
// His printed ordinates in Fig. 84, 0.7984, 0.7853 and 0.7598, each of two points, are those of points 10.36 degrees
// apart on the circle about (0.5, 0.4): the circle's centre is a tenth from that of the cell.
MarkedPoints arc(double towards) {
  constexpr double radius = 0.4, off = 0.1, apart = 10.36;
  const double cx = 0.5 - off * std::cos(radians(towards)), cy = 0.5 - off * std::sin(radians(towards));
  MarkedPoints points;
  for (int p = 0; p < 8; ++p) {
    const double a = radians(towards + (p - 3.5) * apart);
    points.add(cx + radius * std::cos(a), cy + radius * std::sin(a), std::cos(a), std::sin(a));
  }
  return points;
}

// x y + 0.1 x + C = 0 with C = -0.3 through the cell.
MarkedPoints hyperbola() {
  MarkedPoints points;
  for (const double x : {0.3, 0.36, 0.43, 0.51, 0.6, 0.7, 0.81, 0.93}) points.add(x, 0.3 / x - 0.1, 0.3 / x, x);
  return points;
}

// One point of a line in the cell; its neighbours, two or three to a cell, stand in the next ones.
MarkedPoints single() {
  MarkedPoints points = line(0.4, 0.6, 30, std::array{-1.2, -0.9, -0.6, 0.0, 0.75, 1.05, 1.35});
  points.first = 3;
  points.judged = 1;
  return points;
}

MarkedPoints points_on(const std::string& curve) {
  if (curve == "line-45") return line(0.5, 0.5, 45, even);
  if (curve == "line-80") return line(0.5, 0.5, 80, uneven);
  if (curve == "hyperbola") return hyperbola();
  if (curve == "vertical") return line(0.5, 0.5, 90, even);
  if (curve == "single") return single();
  if (curve == "perturbed") {
    MarkedPoints points = line(0.5, 0.5, 90, even);
    points.x[4] += 0.02;
    return points;
  }
  return arc(std::stod(curve.substr(curve.find('-') + 1)));
}

const std::vector<std::string>& curves() {
  static const std::vector<std::string> all{"line-45", "line-80", "hyperbola", "arc-45",    "arc-60",
                                            "arc-75",  "arc-90",  "vertical",  "perturbed", "single"};
  return all;
}

const char* title_of(const std::string& curve) {
  if (curve == "line-45") return "line at 45 degrees (Fig. 76)";
  if (curve == "line-80") return "line at 80 degrees, uneven points (Fig. 77)";
  if (curve == "hyperbola") return "xy + 0.1x + C = 0 (Fig. 78)";
  if (curve == "vertical") return "vertical line (Fig. 80 a)";
  if (curve == "perturbed") return "vertical line, one point beside it (Fig. 80 b)";
  if (curve == "single") return "one point alone in its cell (Fig. 88)";
  if (curve == "arc-45") return "arc of radius 0.4 about the diagonal (Figs. 79, 83)";
  if (curve == "arc-60") return "the arc turned by 15 degrees (Fig. 83)";
  if (curve == "arc-75") return "the arc turned by 30 degrees (Fig. 84)";
  return "the arc upright, points in pairs of equal y (Figs. 84, 85)";
}

class NormalsCell final : public Case {
 public:
  std::string name() const override { return "normals-cell"; }

  Kind kind() const override { return Kind::membrane; }

  std::vector<Key> keys() const override {
    return {{.name = "curve", .value = "arc-45", .choices = curves(), .description = "what the points stand on"}};
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", block}}; }
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("cfl", 0.5, "normals-cell");
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    GridSpec grid;
    grid.dim = 2;
    grid.h = 1;
    grid.cells[0] = grid.cells[1] = std::max(3, settings.integer("cells"));
    grid.origin[0] = grid.origin[1] = -std::floor(grid.cells[0] / 2.0);
    return normals_problem(settings, grid, points_on(settings.text("curve")));
  }

  std::vector<double> default_levels() const override { return {block}; }

  std::vector<StudyPlan> studies() const override {
    std::vector<StudyPlan> all;
    for (const std::string& curve : curves()) {
      all.push_back({.id = curve,
                     .title = title_of(curve),
                     .why = "One cell.",
                     .overrides = {{"curve", curve}},
                     .values = {block}});
    }
    return all;
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = modern_gates();
    for (CaseGate& gate : exact_gates()) all.push_back(std::move(gate));
    for (CaseGate& gate : arc_gates()) all.push_back(std::move(gate));
    for (CaseGate& gate : perturbed_gates()) all.push_back(std::move(gate));
    return all;
  }

 private:
  static constexpr double rounding = 1e-10;  // degrees: 1e-13 of the points, times the condition of the fit
  static constexpr double drawn = 3;         // degrees that a drawn arrow shows

  static std::vector<CaseGate> modern_gates() {
    std::vector<CaseGate> all;
    for (const char* study : {"line-45", "line-80", "vertical", "single"}) {
      all.push_back(
          angle_gate(study, "modern", "max", block, rounding, Origin::identity, "exact on lines, but for rounding"));
    }
    for (const char* study : {"arc-45", "arc-60", "arc-75", "arc-90"}) {
      all.push_back(angle_gate(study, "modern", "max", block, 0.1, Origin::requirement,
                               "at most 0.1 degrees, a thirtieth of what a drawn arrow shows"));
    }
    return all;
  }

  static std::vector<CaseGate> exact_gates() {
    const char* mass = "york-mass-matrix";
    return {
        angle_gate("line-45", mass, "max", block, rounding, Origin::literature,
                   "York: 90 degrees to machine precision"),
        angle_gate("line-80", mass, "mean", block, 0.01, Origin::literature, "York: on average within 0.01 degrees"),
        angle_gate("hyperbola", mass, "max", block, 1e-5 / radians(1), Origin::literature,
                   "York: ends of the unit normals aligned to within the fifth decimal place"),
        angle_gate("vertical", mass, "max", block, rounding, Origin::theory,
                   "the least colours above the membrane's that vanish on the line x = c and not at the lower corner "
                   "are (x - c)(1 - y): exact normals, where York's singular system failed"),
        angle_gate("single", mass, "max", block, rounding, Origin::theory,
                   "points of a line in the ghost cell determine bilinear colours up to their size")};
  }

  static std::vector<CaseGate> arc_gates() {
    const std::string reason = "normals as a drawn arrow would show them, within three degrees";
    const std::string bilinear = "bilinear colours are constant along lines and hyperbolas, not along an arc";
    const char *mass = "york-mass-matrix", *nine = "york-mass-matrix-quadratic";
    std::vector<CaseGate> all{
        failing_angle_gate("arc-45", mass, "max", block, drawn, reason,
                           bilinear + ": several degrees off (York's Fig. 79)", {4.9, 6.1}, narrower),
        failing_angle_gate("arc-60", mass, "max", block, drawn, reason, bilinear, {12, 15}, measured_on),
        failing_angle_gate("arc-75", mass, "max", block, drawn, reason, bilinear, {43, 53}, measured_on),
        failing_angle_gate("arc-90", mass, "max", block, drawn, reason,
                           "points of equal y have one x component where the exact ones are opposite [York 7.15-7.17]",
                           {75, 90}, measured_on)};
    for (const char* study : {"arc-45", "arc-60", "arc-75", "arc-90"}) {
      all.push_back(angle_gate(study, nine, "max", block, 0.1, Origin::literature,
                               "York: computed normals lie on the exact ones (Fig. 85); 0.1 degrees, a thirtieth of "
                               "what a drawn arrow shows"));
    }
    return all;
  }

  static std::vector<CaseGate> perturbed_gates() {
    const char* mass = "york-mass-matrix";
    Gate others = declare(
        "perturbed/york-mass-matrix-others", {{}, 1e-8}, Origin::theory,
        "(x - 1/2)(y - y_p) has exact normals at all points of the line (York: the points away from the centre have "
        "accurate normals); 1e-8 for the difference of sums of up to 90 degrees, over the smallest gradient");
    others.quantity = "sum of all angles but the largest";
    return {failing_angle_gate("perturbed", mass, "max", block, drawn,
                               "normals as a drawn arrow would show them, within three degrees",
                               "the colours (x - 1/2)(y - y_p) hold all points and have no gradient along x at the "
                               "one beside the line (York's Fig. 80 b)",
                               {85, 90}),
            measure_gate("perturbed", others, "york-mass-matrix.mean_angle_error_deg", block,
                         [](const RunResult& run, const Measure& mean) {
                           const Measure* largest = run.find("york-mass-matrix.max_angle_error_deg");
                           Measured measured;
                           measured.value = largest ? std::abs(even.size() * mean.error - largest->error)
                                                    : std::nan("");
                           measured.reference_bound = even.size() * mean.reference_bound;
                           return measured;
                         })};
  }
};

PLUMBLINE_CASE(NormalsCell);

}  // namespace
}  // namespace plumbline
