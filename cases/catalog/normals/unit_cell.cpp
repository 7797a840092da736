// Normals of points in a single cell. [York sections 7.6, 7.7]
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "cases/catalog/normals/marked_points.hpp"

namespace plumbline::unit_cell {
namespace {

// Cells along a side of the grid, of 1 m; York's cell is the middle one, from (0, 0) to (1, 1).
constexpr double block = 3;

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

MarkedPoints perturbed() {
  MarkedPoints points = line(0.5, 0.5, 90, even);
  points.x[4] += 0.02;
  return points;
}

// What the points stand on.
struct Curve {
  std::string name, title;
  MarkedPoints points;
};
const std::vector<Curve>& curves() {
  static const std::vector<Curve> all{
      {"line-45", "line at 45 degrees (Fig. 76)", line(0.5, 0.5, 45, even)},
      {"line-80", "line at 80 degrees, uneven points (Fig. 77)", line(0.5, 0.5, 80, uneven)},
      {"hyperbola", "xy + 0.1x + C = 0 (Fig. 78)", hyperbola()},
      {"arc-45", "arc of radius 0.4 about the diagonal (Figs. 79, 83)", arc(45)},
      {"arc-60", "the arc turned by 15 degrees (Fig. 83)", arc(60)},
      {"arc-75", "the arc turned by 30 degrees (Fig. 84)", arc(75)},
      {"arc-90", "the arc upright, points in pairs of equal y (Figs. 84, 85)", arc(90)},
      {"vertical", "vertical line (Fig. 80 a)", line(0.5, 0.5, 90, even)},
      {"perturbed", "vertical line, one point beside it (Fig. 80 b)", perturbed()},
      {"single", "one point alone in its cell (Fig. 88)", single()}};
  return all;
}

std::unique_ptr<Problem> unit_cell(const Settings& settings) {
  GridSpec grid;
  grid.dim = 2;
  grid.h = 1;
  grid.cells[0] = grid.cells[1] = std::max(3, settings.integer("cells"));
  grid.origin[0] = grid.origin[1] = -std::floor(grid.cells[0] / 2.0);
  const auto on = std::find_if(curves().begin(), curves().end(),
                               [&](const Curve& curve) { return curve.name == settings.text("curve"); });
  return normals_problem(settings, grid, on->points);
}

std::vector<CaseGate> gates() {
  const double rounding = 1e-10;  // degrees: 1e-13 of the points, times the condition of the fit
  const std::string measured_on = "2026-11-21 6c78473", narrower = "2026-11-23 5825b24";
  const std::string bilinear = "bilinear colours are constant along lines and hyperbolas, not along an arc";
  const std::string mass = "york-mass-matrix", nine = "york-mass-matrix-quadratic";
  const Because on_lines = identity("exact on lines, but for rounding");
  const Because on_exact = literature(
      "York: computed normals lie on the exact ones (Fig. 85); 0.1 degrees, a thirtieth of what a drawn arrow shows");
  const auto angle = [](const char* study, const std::string& method, double bound, Because because) {
    return angle_gate(study, method, block, bound, std::move(because));
  };
  const Number others = number_at("sum of all angles but the largest", mass + ".mean_angle_error_deg", block,
                                  [largest = mass + ".max_angle_error_deg"](const RunResult& run, const Measure& mean) {
                                    const Measure* most = run.find(largest);
                                    if (!most) throw std::runtime_error("the run has no " + largest);
                                    Measured measured = Measured::of(std::abs(even.size() * mean.error - most->error));
                                    measured.reference_bound = even.size() * mean.reference_bound;
                                    return measured;
                                  });
  return {angle("line-45", "modern", rounding, on_lines),
          angle("line-80", "modern", rounding, on_lines),
          angle("vertical", "modern", rounding, on_lines),
          angle("single", "modern", rounding, on_lines),
          angle("arc-45", "modern", 0.1, requirement(undrawn)),
          angle("arc-60", "modern", 0.1, requirement(undrawn)),
          angle("arc-75", "modern", 0.1, requirement(undrawn)),
          angle("arc-90", "modern", 0.1, requirement(undrawn)),

          angle("line-45", mass, rounding, literature("York: 90 degrees to machine precision")),
          angle_gate("line-80", mass, block, 0.01, literature("York: on average within 0.01 degrees"), "mean"),
          angle("hyperbola", mass, 1e-5 / radians(1),
                literature("York: ends of the unit normals aligned to within the fifth decimal place")),
          angle("vertical", mass, rounding,
                theory("the least colours above the membrane's that vanish on the line x = c and not at the lower "
                       "corner are (x - c)(1 - y): exact normals, where York's singular system failed")),
          angle("single", mass, rounding,
                theory("points of a line in the ghost cell determine bilinear colours up to their size")),

          angle("arc-45", mass, drawn, literature(as_drawn))
              .fails(bilinear + ": several degrees off (York's Fig. 79)", {4.9, 6.1}, narrower),
          angle("arc-60", mass, drawn, literature(as_drawn)).fails(bilinear, {12, 15}, measured_on),
          angle("arc-75", mass, drawn, literature(as_drawn)).fails(bilinear, {43, 53}, measured_on),
          angle("arc-90", mass, drawn, literature(as_drawn))
              .fails("points of equal y have one x component where the exact ones are opposite [York 7.15-7.17]",
                     {75, 90}, measured_on),
          angle("arc-45", nine, 0.1, on_exact),
          angle("arc-60", nine, 0.1, on_exact),
          angle("arc-75", nine, 0.1, on_exact),
          angle("arc-90", nine, 0.1, on_exact),

          angle("perturbed", mass, drawn, literature(as_drawn))
              .fails("the colours (x - 1/2)(y - y_p) hold all points and have no gradient along x at the one "
                     "beside the line (York's Fig. 80 b)",
                     {85, 90}),
          gate("perturbed/york-mass-matrix-others", others, at_most(1e-8),
               theory("(x - 1/2)(y - y_p) has exact normals at all points of the line (York: the points away from "
                      "the centre have accurate normals); 1e-8 for the difference of sums of up to 90 degrees, "
                      "over the smallest gradient"))};
}

Case normals_cell() {
  Case made{.name = "normals-cell",
            .kind = Kind::membrane,
            .sets = {{"cells", block}},
            .york_step = courant_number(0.5),
            .problem = unit_cell,
            .gates = gates(),
            .levels = {block}};
  Key key{.name = "curve", .value = "arc-45", .description = "what the points stand on"};
  for (const Curve& curve : curves()) {
    key.choices.push_back(curve.name);
    made.studies.push_back(study(curve.name, curve.title, "One cell.", {block}).with({{"curve", curve.name}}));
  }
  made.keys = {key};
  return made;
}
PLUMBLINE_CASE(normals_cell);

}  // namespace
}  // namespace plumbline::unit_cell
