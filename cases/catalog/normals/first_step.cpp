// Normals of York's circular membrane before anything has moved. [York section 7.5.1]
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "cases/catalog/coupled/dog_bone.hpp"
#include "cases/catalog/normals/marked_points.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline::first_step {
namespace {

constexpr int york_points = 179, york_cells = 10;
constexpr double domain = 1.5;  // m, a side of York's grid; the radius is 1

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

// At the middles of equal arcs of the dog-bone's outline, between the tenths of an arc that the outline is known at.
MarkedPoints dog_bone(int points) {
  constexpr int fine = 10;
  const Curve outline = dog_bone_outline(points * fine);
  MarkedPoints all;
  for (int p = 0; p < points; ++p) {
    const auto at = static_cast<std::size_t>(p * fine + fine / 2);
    const auto &here = outline[at], &before = outline[at - 1], &after = outline[at + 1];
    all.add(here[0], here[1], after[1] - before[1], before[0] - after[0]);
  }
  return all;
}

const std::vector<Key> keys{{.name = "interior",
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
                             .description = "height over width of the ellipse; 1: York's circle"},
                            {.name = "outline",
                             .value = "ellipse",
                             .choices = {"dog-bone", "ellipse"},
                             .description = "York's dog-bone (membrane-expansion), empty, or an ellipse"}};

std::unique_ptr<Problem> first_step(const Settings& settings) {
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
  return normals_problem(settings, grid,
                         settings.text("outline") == "dog-bone" ? dog_bone(points) : quarter(points, b, cells, inside));
}

const std::vector<double> finer{10, 14, 20, 28, 40};

StudyPlan filled(std::string id, std::string title, const char* interior) {
  return study(std::move(id), std::move(title), "York's one mesh.", {york_cells}).with({{"interior", interior}});
}

std::vector<StudyPlan> studies() {
  return {filled("empty", "nothing inside", "empty"), filled("four", "4 gas points per cell inside", "4"),
          filled("sixteen", "16 gas points per cell inside", "16"),
          study("dog-bone", "the dog-bone before it expands",
                "York's one mesh: cells of 0.1 m and points as in his simulation 3.", {york_cells})
              .with({{"outline", "dog-bone"}, {"membrane_points", 200.0}}),
          study("ellipse", "an ellipse half as high as wide, points in proportion to cells",
                "Order 2 in the distance of points.", finer)
              .with({{"aspect", 0.5}, {"membrane_points", std::monostate{}}, {"ppc", 12.0}})};
}

const Measure& found(const StudyResult& study, const std::string& measure) {
  const StudyLevel* at = study.level(york_cells);
  const Measure* m = at ? at->run.find(measure) : nullptr;
  if (!m) throw std::runtime_error("a run has no " + measure);
  return *m;
}

// An error over another one, which may be of another study.
CaseGate over(const std::string& id, const std::string& measure, const std::string& over_study,
              const std::string& over_measure, double most, std::string york) {
  const bool apart = !id.starts_with(over_study + "/");
  const Number ratio = number_of(
      measure + " over " + over_measure + (apart ? " of " + over_study : ""),
      [=](const StudyResult& s) {
        const Measure& above = found(s, measure);
        const Measure& below = found(apart ? *s.sibling(over_study) : s, over_measure);
        Measured measured = Measured::of(above.error / below.error);
        measured.scale = 1;
        measured.reference_bound = (above.reference_bound + *measured.value * below.reference_bound) / below.error;
        return measured;
      },
      {york_cells});
  CaseGate made = gate(id, ratio, at_most(most), literature(std::move(york)));
  return apart ? std::move(made).beside({over_study}) : made;
}

std::vector<CaseGate> gates() {
  const double end = 45.0 / york_points;
  const std::string measured_on = "2026-11-23 5825b24";
  const std::string one_layer =
      "one layer of points has the same colour on both sides: its gradient is what the grid makes of it (York's Figs. ";
  const std::string
      on_dog_bone = "2026-11-26 05844c9",
      corners = "where straight sides meet corners of 0.06 m, less than a cell, in an outline that is not York's";
  const std::string further = "York: further with more points inside";
  const std::string better = "York: with points inside the cubic method is the better one";
  const std::string quadratic = "york-quadratic.mean_angle_error_deg", cubic = "york-cubic.mean_angle_error_deg";
  const auto angle = [](const char* study, const char* method, double bound, Because because) {
    return angle_gate(study, method, york_cells, bound, std::move(because));
  };
  return {
      angle("empty", "modern", 0.1, requirement(undrawn)),
      angle("four", "modern", 0.1, requirement(undrawn)),
      angle("sixteen", "modern", 0.1, requirement(undrawn)),
      gate("empty/modern-exact", error_at("modern.max_angle_error_deg", york_cells), at_most(1e-9),
           identity("points of a circle leave the fitted circle nothing to miss: rounding of points over their "
                    "distance, 1e-12 degrees, times the condition of the fit")),
      gate("ellipse/modern-order", fitted_order_of("modern.max_angle_error_deg"), at_least(1.8),
           theory("order 2 in the distance of points; 0.2 for the coarsest ones")),
      angle("ellipse", "modern", 0.1, requirement(undrawn)),

      gate("empty/connectivity-ends", error_at("connectivity.max_angle_error_deg", york_cells),
           between(end - 1e-9, end + 1e-9),
           identity("chords of equal arcs are exact but at the two ends, which have one neighbour: off by half the "
                    "angle between two points")),
      angle("empty", "york-mass-matrix", drawn,
            literature("York: only a small difference from connectivity (Fig. 72), less than a drawn arrow shows")),
      angle("empty", "york-mass-matrix-quadratic", drawn,
            literature("York: accurate (Fig. 86), as far as a drawn arrow shows")),
      angle_gate("dog-bone", "york-mass-matrix-quadratic", york_cells, drawn,
                 literature("York, p. 123: accurate (Fig. 86), as far as a drawn arrow shows"), "mean"),
      angle("dog-bone", "york-mass-matrix-quadratic", drawn, literature("as of the mean (Fig. 86), at every point"))
          .fails(corners, {3.0, 3.4}, on_dog_bone),
      angle("dog-bone", "connectivity", drawn, literature("York, Fig. 86: what the mass matrix is compared with")),
      angle("dog-bone", "modern", drawn, literature("as of York's (Fig. 86), at every point"))
          .fails(corners, {6.3, 8.3}, on_dog_bone),

      angle("empty", "york-simple", drawn, literature(as_drawn)).fails(one_layer + "67 (a))", {74, 90}, measured_on),
      angle("four", "york-simple", drawn, literature(as_drawn))
          .fails("too few points inside: normals turn at cell sides (York's Fig. 67 (b))", {58, 72}, measured_on),
      angle("empty", "york-quadratic", drawn, literature(as_drawn)).fails(one_layer + "68 (a))", {78, 90}, measured_on),
      angle("empty", "york-cubic", drawn, literature(as_drawn)).fails(one_layer + "70 (a))", {80, 90}, measured_on),

      over("four/quadratic-improves", quadratic, "empty", quadratic, 0.5,
           "York: with points inside the results improve drastically"),
      over("four/cubic-improves", cubic, "empty", cubic, 0.5, "York: as of the quadratic method"),
      over("sixteen/quadratic-improves", quadratic, "four", quadratic, 1, further),
      over("sixteen/cubic-improves", cubic, "four", cubic, 1, further),
      over("empty/quadratic-below-cubic", quadratic, "empty", cubic, 1,
           "York: without points inside the cubic method is not as good as the quadratic one"),
      over("sixteen/cubic-below-quadratic", cubic, "sixteen", quadratic, 1, better),
      over("four/cubic-below-quadratic", "york-cubic.max_angle_error_deg", "four", "york-quadratic.max_angle_error_deg",
           1, better + "; of 4 to a cell that holds at the worst points")};
}

Case normals_first_step() {
  return {.name = "normals-first-step",
          .kind = Kind::membrane,
          .keys = keys,
          .sets = {{"cells", static_cast<double>(york_cells)}},
          .york_step = courant_number(0.5),
          .problem = first_step,
          .studies = studies(),
          .gates = gates(),
          .levels = finer};
}
PLUMBLINE_CASE(normals_first_step);

}  // namespace
}  // namespace plumbline::first_step
