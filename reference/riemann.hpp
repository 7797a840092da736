#pragma once
// Exact solution of the Riemann problem of the Euler equations for an ideal gas, vacuum included, with computed error
// bounds. Source: Toro, 3rd ed., chapter 4.
#include <optional>
#include <stdexcept>
#include <vector>

#include "reference/bounded.hpp"
#include "reference/gas.hpp"
#include "reference/wave_curve.hpp"

namespace plumbline::reference {

/// Two gases of the same gamma, parted at x = 0 until t = 0. Any consistent units.
struct RiemannProblem {
  GasState left, right;
  double gamma = 1.4;
};

enum class WaveKind { shock, rarefaction, none };  // none: that side is a vacuum

/// A wave between the speeds `head` (towards the undisturbed gas) and `tail`; equal for a shock.
struct Wave {
  WaveKind kind = WaveKind::none;
  Bounded head, tail;
};

/// Between the two waves. In a vacuum: pressure = density = 0, and `velocity` is its edge, or the middle of its two.
struct StarRegion {
  Bounded pressure, velocity, density_left, density_right, energy_left, energy_right;
};

/// Values on the ray x/t = xi; `energy` is specific internal energy.
struct Sample {
  Bounded density, velocity, pressure, energy;
};

class RiemannSolution {
 public:
  /// Throws ParameterError (keys `gamma`, `left.density`, ...) unless gamma > 1, all numbers are finite, density and pressure >= 0, no pressure without
  /// density, and at most one side is a vacuum; std::runtime_error if no bound can be certified (overflow).
  explicit RiemannSolution(const RiemannProblem& problem);

  const RiemannProblem& problem() const { return problem_; }
  const StarRegion& star() const { return star_; }
  const Wave& left_wave() const { return left_wave_; }
  const Wave& right_wave() const { return right_wave_; }
  bool vacuum() const { return vacuum_; }  // there is a vacuum in the solution, given or generated

  /// The solution at x/t = xi; at a jump the value on the right. About 100 ns. In a vacuum density, pressure and
  /// energy are 0 and the velocity is xi, but not beyond the edge of the gas. Where xi is so close to a wave that
  /// rounding decides the side, the bounds cover both sides.
  Sample sample(double xi) const;

  /// Positions x/t of all jumps (shocks, contact, edge of a vacuum) and kinks (head and tail of rarefactions),
  /// ascending, each once.
  std::vector<double> jumps() const;

 private:
  void solve_into_vacuum();
  void solve_star();
  Bounded star_pressure() const;
  void place_waves();
  Bounded difference(double p) const;  // f(p) of [Toro 4.5]
  Sample in_region(int region, double xi) const;
  bool has_fan(const std::optional<WaveCurve>& curve, const Wave& wave) const;

  RiemannProblem problem_;
  std::optional<WaveCurve> left_, right_;  // empty: vacuum on that side
  StarRegion star_;
  Wave left_wave_, right_wave_;
  bool vacuum_ = false;
  Bounded edges_[5];    // left head, left tail, contact, right tail, right head: region i lies left of edge i
  Sample constant_[6];  // states of the regions that are not fans (1 and 4 are)
  bool fan_[6] = {};
};

}  // namespace plumbline::reference
