#include "cases/catalog/solid/manufactured_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/verdict/order.hpp"

namespace plumbline {

std::unique_ptr<Problem> axis_aligned_run(const reference::AxisAlignedProblem& motion, double end_time,
                                          const Settings& settings) {
  ManufacturedSetup setup{.exact = reference::mms_axis_aligned(motion), .end_time = end_time};
  setup.grid.dim = motion.dimension;
  setup.grid.h = motion.length / settings.number("cells");
  SolidShape cube;
  for (std::size_t d = 0; d < static_cast<std::size_t>(motion.dimension); ++d) {
    setup.grid.cells[d] = settings.integer("cells");
    setup.grid.walls[d] = {Wall::symmetry, Wall::symmetry};
    cube.high[d] = motion.length;
  }
  setup.body = fill_solid("body", material_of(*setup.exact), cube, motion.density, settings.integer("ppc"), setup.grid);
  return manufactured_problem(std::move(setup), settings);
}

Key poisson_key(double value) {
  return {.name = "poissons_ratio",
          .value = value,
          .low = -1,
          .high = 0.5,
          .low_open = true,
          .high_open = true,
          .description = "Poisson's ratio"};
}

namespace {
const std::string worst_displacement = "displacement.worst";
}

std::vector<CaseGate> displacement_orders(const std::vector<std::string>& studies, double order,
                                          const std::string& reason, Tier tier) {
  std::vector<CaseGate> all;
  for (const std::string& study : studies) {
    all.push_back(
        gate(study + "/order", fitted_order_of(worst_displacement), at_least(order), requirement(reason)).in(tier));
    all.push_back(
        gate(study + "/order-interval", order_of(worst_displacement), at_least(order - 0.1),
             requirement("the low end of the 95 % interval of the fit, 0.1 below what the estimate must reach"))
            .in(tier));
  }
  return all;
}

Number relative_error_at(double level) {
  return number_at(fmt::format("{} over the largest norm of the motion, at {} cells", worst_displacement, level),
                   worst_displacement, level,
                   [](const RunResult&, const Measure& m) { return Measured::of(m.error / m.scale); });
}

CaseGate energy_monotone_gate(const std::string& study) {
  const auto largest_rise = [](const StudyResult& s) {
    double largest = 0;
    for (const double rise : values_of(s, "energy_rise")) largest = larger(largest, rise);
    return Measured::of(largest);
  };
  return gate(
      study + "/energy-monotone",
      number_of("largest rise of the energy in a step, over that of the start", largest_rise), at_most(1e-13),
      theory("of linear elasticity the midpoint step raises the energy in no step (reports/docs/theory/step.md, "
             "Midpoint); 1e-13 for the rounding of sums"));
}

CaseGate missed_order(const std::string& study, const std::vector<double>& levels, double order,
                      const std::string& cause, Range band) {
  const auto fit = [levels](const StudyResult& s) {
    std::vector<Level> fitted;
    for (const double level : levels) {
      const StudyLevel* at = s.level(level);
      const Measure* m = at ? at->run.find(worst_displacement) : nullptr;
      fitted.push_back({.h = at ? at->h : level,
                        .error = m ? m->error : std::nan(""),
                        .reference_bound = m ? m->reference_bound : 0,
                        .offset_errors = {},
                        .dropped = {}});
    }
    return measured_order(fit_order(fitted, Weighting::equal));
  };
  return gate(study + "/order",
              number_of(fmt::format("fitted order of {} from {} to {} cells", worst_displacement, levels.front(),
                                    levels.back()),
                        fit, levels),
              at_least(order),
              requirement("second order, as with points that stay in their cells; what is missing to 2 allows for "
                          "coarse meshes"))
      .fails(cause, band, "2026-11-23 5825b24");
}

}  // namespace plumbline
