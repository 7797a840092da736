#pragma once
// The ideal gas of the Riemann problem: p = (gamma - 1) rho e.

namespace plumbline::reference {

/// Any consistent units. A vacuum is density = pressure = 0 (its velocity means nothing); a cold gas has
/// density > 0 and pressure = 0.
struct GasState {
  double density = 0;
  double velocity = 0;
  double pressure = 0;
};

inline bool is_vacuum(const GasState& gas) { return gas.density == 0; }

}  // namespace plumbline::reference
