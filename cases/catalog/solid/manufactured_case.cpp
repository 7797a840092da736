#include "cases/catalog/solid/manufactured_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "cases/catalog/solid/fill_solid.hpp"

namespace plumbline {

std::vector<Override> ManufacturedCase::points_and_end(const std::string&) const { return {{"cells", 32.0}}; }

void ManufacturedCase::derive(Settings& settings, const std::string& scheme) const {
  if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) settings.set("cfl", 0.2, "solid");
}

std::unique_ptr<Problem> ManufacturedCase::problem(const Settings& settings) const {
  return manufactured_problem(setup(settings), settings);
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

std::function<Body(std::shared_ptr<const Material>)> lattice_body(const SolidShape& shape, const ExactMotion& exact,
                                                                  int ppc, const GridSpec& grid) {
  return [shape, density = exact->density(), ppc, grid](std::shared_ptr<const Material> material) {
    return fill_solid("body", std::move(material), shape, density, ppc, grid);
  };
}

namespace {
constexpr const char* worst = "displacement.worst";
}

std::vector<CaseGate> displacement_order(const std::string& study, double order, const std::string& reason, Tier tier) {
  return {fitted_order_gate(study, worst, declare(study + "/order", {order, {}}, Origin::requirement, reason), tier),
          order_gate(study, worst,
                     declare(study + "/order-interval", {order - 0.1, {}}, Origin::requirement,
                             "the low end of the 95 % interval of the fit, 0.1 below what the estimate must reach"),
                     tier)};
}

CaseGate displacement_gate(const std::string& study, double level, double most, Origin origin,
                           const std::string& reason, Tier tier) {
  return error_gate(study, worst, level, declare(study + "/error-" + to_text(level), {{}, most}, origin, reason), tier);
}

CaseGate energy_monotone_gate(const std::string& study) {
  CaseGate g = study_gate(
      study,
      declare(study + "/energy-monotone", {{}, 1e-13}, Origin::theory,
              "of linear elasticity the midpoint step raises the energy in no step (kernel/README.md, Midpoint); 1e-13 "
              "for the rounding of sums"),
      [](const StudyResult& result) {
        Measured measured;
        double largest = result.levels.empty() ? std::nan("") : 0;
        for (const StudyLevel& level : result.levels) {
          const Measure* rise = level.run.find("energy_rise");
          largest = larger(largest, rise ? *rise->value : std::nan(""));
        }
        measured.value = largest;
        return measured;
      });
  g.gate.quantity = "largest rise of the energy in a step, over that of the start";
  return g;
}

CaseGate missed_order(const std::string& study, const std::vector<double>& levels, double order,
                      const std::string& cause, Range band) {
  Gate gate = expected_failure(
      declare(study + "/order", {order, {}}, Origin::requirement,
              "second order, as with points that stay in their cells; what is missing to 2 is room for coarse meshes"),
      cause, band, "2026-11-23 5825b24");
  gate.quantity = fmt::format("fitted order of {} from {} to {} cells", worst, levels.front(), levels.back());
  return study_gate(
      study, std::move(gate),
      [levels](const StudyResult& s) {
        std::vector<Level> fitted;
        for (const double level : levels) {
          const StudyLevel* at = s.level(level);
          const Measure* m = at ? at->run.find(worst) : nullptr;
          fitted.push_back({.h = at ? at->h : level,
                            .error = m ? m->error : std::nan(""),
                            .reference_bound = m ? m->reference_bound : 0,
                            .offset_errors = {},
                            .dropped = {}});
        }
        return measured_order(fit_order(fitted, Weighting::equal));
      },
      levels);
}

}  // namespace plumbline
