#include "cases/catalog/gas/tube_case.hpp"

#include "cases/catalog/gas/gas_case.hpp"

namespace plumbline {
namespace {

constexpr const char* first_order =
    "Shock and contact are jumps: a scheme of any order spreads them over a number of cells, so L1 errors fall at most "
    "with h.";

}  // namespace

TubeCase::TubeCase(TubeDescription description, const char* file)
    : about_(std::move(description)),
      registered_(this, file) {}

std::vector<Override> TubeCase::points_and_end(const std::string& scheme) const { return york_points(scheme); }

void TubeCase::derive(Settings& settings, const std::string& scheme) const { york_step(settings, scheme); }

std::unique_ptr<Problem> TubeCase::problem(const Settings& settings) const {
  return shock_tube_problem(shock_tube_from(settings, about_.tube), settings);
}

std::vector<double> TubeCase::default_levels() const { return {100, 200, 400, 800, 1600}; }

std::vector<StudyPlan> TubeCase::studies() const {
  return {{.id = "default",
           .title = "default: points of equal mass",
           .why = first_order,
           .values = {100, 140, 200, 280, 400},
           .full_values = {100, 200, 400, 800, 1600}}};
}

std::vector<CaseGate> TubeCase::gates() const {
  std::vector<CaseGate> all = required_order("default", "density.L1", about_.order, about_.order_reason);
  all.push_back(energy_gate("default"));
  all.push_back(coverage_gate("default", 100));
  return all;
}

std::vector<Comparator> TubeCase::comparators(const Settings& settings, const std::vector<double>& cells) const {
  return {tube_stick(shock_tube_from(settings, about_.tube), cells)};
}

}  // namespace plumbline
