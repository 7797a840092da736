#include "cases/catalog/gas/shock_front.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

constexpr double from_share = 0.5, to_share = 0.75;  // of the shock's distance: where the plateau is looked at

struct Shell {
  double volume = 0, moment = 0, mass = 0;
  double place() const { return moment / volume; }
  double density() const { return mass / volume; }
};

}  // namespace

double shock_place(const std::vector<GasSample>& points, double h, double halfway) {
  std::map<long, Shell> shells;
  for (const GasSample& p : points) {
    Shell& shell = shells[std::lround(std::floor(2 * p.coordinate / h))];
    shell.volume += p.volume;
    shell.moment += p.volume * p.coordinate;
    shell.mass += p.volume * p.density;
  }
  const Shell* outside = nullptr;
  for (auto at = shells.rbegin(); at != shells.rend(); ++at) {
    const Shell& inside = at->second;
    if (outside && inside.density() >= halfway && outside->density() < halfway) {
      const double share = (halfway - outside->density()) / (inside.density() - outside->density());
      return outside->place() + share * (inside.place() - outside->place());
    }
    outside = &inside;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Measure> shock_measures(const std::vector<GasSample>& points, double h, const ShockFront& exact) {
  const double halfway = (exact.density_ahead + exact.density_behind.value) / 2;
  const double found = shock_place(points, h, halfway) - exact.origin;
  double plateau = std::numeric_limits<double>::quiet_NaN(), hottest = 0;
  for (const GasSample& p : points) {
    const double share = (p.coordinate - exact.origin) / exact.distance.value;
    const double off = std::abs(p.density - exact.density_behind.value);
    if (share >= from_share && share <= to_share && !(off <= std::abs(plateau - exact.density_behind.value))) {
      plateau = p.density;
    }
    if (share < from_share) hottest = larger(hottest, p.energy / exact.energy_behind.value - 1);
  }
  return {scalar_measure("shock_position", found, exact.distance.value, exact.distance.bound, "m"),
          scalar_measure("plateau_density", plateau, exact.density_behind.value, exact.density_behind.bound, "kg/m^3"),
          scalar_measure("wall_heating", hottest, 0.0, exact.energy_behind.bound / exact.energy_behind.value, "1")};
}

CaseGate shock_position_gate(const std::string& study, double level, double cell) {
  return gate(
      study + "/shock-position-" + to_text(level), error_at("shock_position", level), at_most(cell),
      requirement("the shock stands within one cell of its exact place, closer than the several cells it is wide"));
}

CaseGate plateau_gate(const std::string& study, double level, double plateau) {
  return gate(study + "/plateau-" + to_text(level), error_at("plateau_density", level), at_most(0.02 * plateau),
              requirement("away from the wall the density behind it is exact to 2 %: what the first cells at the wall "
                          "are off by must not be felt there"));
}

std::vector<CaseGate> shock_gates(const std::string& study, double level, double cell, double plateau) {
  return {shock_position_gate(study, level, cell), plateau_gate(study, level, plateau)};
}

}  // namespace plumbline
