// A square and a cube whose planes move as sin(pi X_i), each along its own axis.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/parameters.hpp"

namespace plumbline::mms_axis_aligned {
namespace {

struct SquareOrCube : Parameters {
  int dim = integer({.name = "dimension", .value = 2.0, .low = 2, .high = 3, .description = "square or cube"});
  reference::AxisAlignedProblem motion = dim == 2 ? reference::mms_square_problem() : reference::mms_cube_problem();
  double end_time = 0;

  explicit SquareOrCube(Parameters given = {}) : Parameters(std::move(given)) {
    motion.amplitude = within("amplitude", motion.amplitude, "m", 0, 0.3, "A, largest displacement");
    motion.youngs_modulus = positive("youngs_modulus", motion.youngs_modulus, "Pa", "E");
    motion.poisson = number(poisson_key(motion.poisson));
    motion.density = positive("initial_density", motion.density, "kg/m^3", "initial density");
    end_time = positive("t_end", 0.006, "s", "end time");
  }
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const SquareOrCube at(settings);
  return axis_aligned_run(at.motion, at.end_time, settings);
}

const std::vector<double> levels{6, 8, 11, 16, 22};

std::vector<StudyPlan> studies() {
  const std::string why = "Boxes tile the body throughout: order 2.";
  return {study("plane", "default, square", why, levels).in_full({8, 12, 16, 24, 32, 48, 64}),
          study("space", "default, cube", why, {5, 6, 8, 9, 11}).with({{"dimension", 3.0}}).in_full(levels)};
}

Case mms_axis_aligned() {
  return {.name = "mms-axis-aligned",
          .kind = Kind::solid,
          .keys = SquareOrCube().keys(),
          .sets = {{"cells", 32.0}},
          .york_step = courant_number(published_courant),
          .problem = run,
          .studies = studies(),
          .gates = displacement_orders({"plane", "space"}, 1.8, "second order; 0.2 for coarse meshes"),
          .levels = levels};
}
PLUMBLINE_CASE(mms_axis_aligned);

}  // namespace
}  // namespace plumbline::mms_axis_aligned
