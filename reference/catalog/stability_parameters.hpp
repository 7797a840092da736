#pragma once
// Choices among integrators, shapes and transfers as numbers, which is all that a catalog's parameters can be.
#include <map>
#include <string>
#include <vector>

#include "reference/catalog/parameters.hpp"
#include "reference/mpm_amplification.hpp"

namespace plumbline::reference {

inline Parameter integrator_parameter() {
  return {"integrator", 1, 0, 3, false, false, "1", "0 usf, 1 musl, 2 usl, 3 usavg"};
}
inline Parameter courant_abscissa() { return {"courant", 0, 0, 100, true, false, "1", "Courant number c dt/h"}; }

/// Throws ParameterError.
inline StressUpdate stress_update(const std::map<std::string, double>& settings) {
  static constexpr StressUpdate updates[] = {StressUpdate::first, StressUpdate::modified_last, StressUpdate::last,
                                             StressUpdate::averaged};
  return updates[whole_number(settings, "integrator")];
}

inline std::vector<Parameter> scheme_parameters() {
  return {
      integrator_parameter(),
      {"shape", 0, 0, 3, false, false, "1", "0 linear, 1 boxes as wide as the spacing, 2 quadratic, 3 cubic B-splines"},
      {"transfer", 1, 0, 4, false, false, "1", "0 pic, 1 flip, 2 apic, 3 xpic, 4 fmpm"},
      {"order", 2, 1, 100, false, false, "1", "terms of xpic and fmpm"},
      {"sharpening", 0, 0, 1, false, false, "1", "share of the maps' smoothing that is undone"}};
}

/// Throws ParameterError.
inline MapScheme map_scheme(const std::map<std::string, double>& settings) {
  return {stress_update(settings), static_cast<GridShape>(whole_number(settings, "shape")),
          static_cast<GridTransfer>(whole_number(settings, "transfer")), whole_number(settings, "order"),
          settings.at("sharpening")};
}

}  // namespace plumbline::reference
