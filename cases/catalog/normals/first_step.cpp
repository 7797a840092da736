// Normals of York's circular membrane before anything has moved. [York section 7.5.1]
#include <cmath>
#include <numbers>

#include "cases/catalog/normals/marked_points.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

constexpr int york_points = 179, york_cells = 10;
constexpr double domain = 1.5;  // m, a side of York's grid; the radius is 1
constexpr const char* measured_on = "2026-11-23 5825b24";

// A quarter of x^2 + (y/b)^2 = 1, points evenly in its parameter, half a step from both ends; and York's gas points, n
// x n to a cell, inside it.
MarkedPoints quarter(int points, double b, int cells, int inside) {
  MarkedPoints all;
  for (int p = 0; p < points; ++p) {
    const double a = (p + 0.5) / points * std::numbers::pi / 2;
    all.add(std::cos(a), b * std::sin(a), std::cos(a), std::sin(a) / b);
  }
  const double apart = inside > 0 ? 1.0 / cells / inside : 2;
  for (int j = 0; (j + 0.5) * apart < b; ++j) {
    for (int i = 0; std::hypot((i + 0.5) * apart, (j + 0.5) * apart / b) < 1; ++i) {
      all.other_x.push_back((i + 0.5) * apart);
      all.other_y.push_back((j + 0.5) * apart);
    }
  }
  return all;
}

class NormalsFirstStep final : public Case {
 public:
  std::string name() const override { return "normals-first-step"; }

  Kind kind() const override { return Kind::membrane; }

  std::vector<Key> keys() const override {
    return {{.name = "interior",
             .value = "empty",
             .choices = {"empty", "4", "16"},
             .description = "gas points per cell inside the membrane"},
            {.name = "membrane_points",
             .value = static_cast<double>(york_points),
             .low = 4,
             .high = 1e5,
             .integer = true,
             .optional = true,
             .description = "on the quarter; none: ppc per cell"},
            {.name = "aspect",
             .value = 1.0,
             .low = 0.2,
             .high = 1,
             .description = "height over width of the ellipse; 1: York's circle"}};
  }

  std::vector<Override> points_and_end(const std::string&) const override {
    return {{"cells", static_cast<double>(york_cells)}};
  }
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("cfl", 0.5, "normals-first-step");
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    const int cells = settings.integer("cells");
    const double b = settings.number("aspect");
    const int points = settings.is_set("membrane_points")
                           ? settings.integer("membrane_points")
                           : whole(std::round(cells * settings.number("ppc") * std::numbers::pi / 2));
    const std::string& interior = settings.text("interior");
    const int inside = interior == "16" ? 4 : interior == "4" ? 2 : 0;
    GridSpec grid;
    grid.dim = 2;
    grid.h = 1.0 / cells;
    grid.cells[0] = grid.cells[1] = whole(std::round(domain * cells));
    grid.walls[0][0] = grid.walls[1][0] = Wall::symmetry;
    return normals_problem(settings, grid, quarter(points, b, cells, inside));
  }

  std::vector<double> default_levels() const override { return {10, 14, 20, 28, 40}; }

  std::vector<StudyPlan> studies() const override {
    const auto plan = [](const char* id, const char* title, const char* interior) {
      return StudyPlan{.id = id,
                       .title = title,
                       .why = "York's one mesh.",
                       .overrides = {{"interior", interior}},
                       .values = {york_cells}};
    };
    return {plan("empty", "nothing inside", "empty"),
            plan("four", "4 gas points per cell inside", "4"),
            plan("sixteen", "16 gas points per cell inside", "16"),
            {.id = "ellipse",
             .title = "an ellipse half as high as wide, points in proportion to cells",
             .why = "Order 2 in the distance of points.",
             .overrides = {{"aspect", 0.5}, {"membrane_points", std::monostate{}}, {"ppc", 12.0}},
             .values = {10, 14, 20, 28, 40}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = modern_gates();
    for (CaseGate& gate : york_gates()) all.push_back(std::move(gate));
    for (CaseGate& gate : colour_gates()) all.push_back(std::move(gate));
    return all;
  }

 private:
  static constexpr double drawn = 3;  // degrees: half a millimetre at the end of an arrow of ten

  static std::vector<CaseGate> modern_gates() {
    std::vector<CaseGate> all;
    for (const char* study : {"empty", "four", "sixteen"}) {
      all.push_back(angle_gate(study, "modern", "max", york_cells, 0.1, Origin::requirement,
                               "at most 0.1 degrees, a thirtieth of what a drawn arrow shows"));
    }
    Gate exact = declare("empty/modern-exact", {{}, 1e-9}, Origin::identity,
                         "points of a circle leave the fitted circle nothing to miss: rounding of points over their "
                         "distance, 1e-12 degrees, times the condition of the fit");
    all.push_back(error_gate("empty", "modern.max_angle_error_deg", york_cells, exact));
    all.push_back(fitted_order_gate("ellipse", "modern.max_angle_error_deg",
                                    declare("ellipse/modern-order", {1.8, {}}, Origin::theory,
                                            "order 2 in the distance of points; 0.2 for the coarsest ones")));
    all.push_back(angle_gate("ellipse", "modern", "max", 10, 0.1, Origin::requirement,
                             "at most 0.1 degrees, a thirtieth of what a drawn arrow shows"));
    return all;
  }

  static std::vector<CaseGate> york_gates() {
    const double end = 45.0 / york_points;
    return {
        error_gate("empty", "connectivity.max_angle_error_deg", york_cells,
                   declare("empty/connectivity-ends", {end - 1e-9, end + 1e-9}, Origin::identity,
                           "chords of equal arcs are exact but at the two ends, which have one neighbour: off by half"
                           " the angle between two points")),
        angle_gate("empty", "york-mass-matrix", "max", york_cells, drawn, Origin::literature,
                   "York: only a small difference from connectivity (Fig. 72), less than a drawn arrow shows"),
        angle_gate("empty", "york-mass-matrix-quadratic", "max", york_cells, drawn, Origin::literature,
                   "York: accurate (Fig. 86), as far as a drawn arrow shows")};
  }

  static std::vector<CaseGate> colour_gates() {
    const std::string reason = "normals as a drawn arrow would show them, within three degrees";
    const std::string one_layer =
        "one layer of points has the same colour on both sides: its gradient is what the grid makes of it (York's "
        "Figs. ";
    std::vector<CaseGate> all{
        failing_angle_gate("empty", "york-simple", "max", york_cells, drawn, reason, one_layer + "67 (a))", {74, 90},
                           measured_on),
        failing_angle_gate("four", "york-simple", "max", york_cells, drawn, reason,
                           "too few points inside: normals turn at cell sides (York's Fig. 67 (b))", {58, 72},
                           measured_on),
        failing_angle_gate("empty", "york-quadratic", "max", york_cells, drawn, reason, one_layer + "68 (a))", {78, 90},
                           measured_on),
        failing_angle_gate("empty", "york-cubic", "max", york_cells, drawn, reason, one_layer + "70 (a))", {80, 90},
                           measured_on)};
    const auto ratio = [&](const char* id, const char* study, const char* measure, const char* over_study,
                           const char* over, double most, const char* why) {
      all.push_back(angle_ratio_gate(study, measure, over_study, over, york_cells,
                                     declare(std::string(study) + "/" + id, {{}, most}, Origin::literature, why)));
    };
    const char *quadratic = "york-quadratic.mean_angle_error_deg", *cubic = "york-cubic.mean_angle_error_deg";
    ratio("quadratic-improves", "four", quadratic, "empty", quadratic, 0.5,
          "York: with points inside the results improve drastically");
    ratio("cubic-improves", "four", cubic, "empty", cubic, 0.5, "York: as of the quadratic method");
    ratio("quadratic-improves", "sixteen", quadratic, "four", quadratic, 1, "York: further with more points inside");
    ratio("cubic-improves", "sixteen", cubic, "four", cubic, 1, "York: further with more points inside");
    ratio("quadratic-below-cubic", "empty", quadratic, "empty", cubic, 1,
          "York: without points inside the cubic method is not as good as the quadratic one");
    ratio("cubic-below-quadratic", "sixteen", cubic, "sixteen", quadratic, 1,
          "York: with points inside the cubic method is the better one");
    ratio("cubic-below-quadratic", "four", "york-cubic.max_angle_error_deg", "four",
          "york-quadratic.max_angle_error_deg", 1,
          "York: with points inside the cubic method is the better one; of 4 to a cell that holds at the worst points");
    return all;
  }
};

PLUMBLINE_CASE(NormalsFirstStep);

}  // namespace
}  // namespace plumbline
