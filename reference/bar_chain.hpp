#pragma once
// A string as a chain of straight bar elements with a heavy end, fixed at its top, in the plane: York's comparison for
// his membrane points (section 5.7, Figures 36 and 37). Each element pulls with E A (l/l0 - 1) along itself, where it
// stands now (updated Lagrangian), half of its mass sits on each of its nodes, gravity acts on all of them. The
// equations of motion are integrated by GSL's rk8pd with steps controlled by a tolerance.
//
// The bounds are estimates: each answer is also computed with a half and with a quarter of the elements and with a
// tolerance a hundred times larger. Lumped masses are of second order: the error is a third of what the last halving
// changed, where the string moves smoothly. The larger of that change and half of the one before is taken, plus the
// change by tolerance; coordinates share the largest of theirs, and so do velocities and energies.
#include <span>
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Support and end at t = 0, at rest, all elements with the same `strain`, in (-0.5, 0.1); gravity along -y. Any
/// consistent units: mass (of the end), gravity, youngs_modulus, area, density > 0, string lighter than the end,
/// E A/(m g) at least 10. One-way elements carry no pressure. Defaults: York's pendulum (section A.4.5).
struct BarChainProblem {
  double support_x = 0.33333, support_y = 0.99990;
  double end_x = 0.101, end_y = 0.303;
  double mass = 3.3;
  double gravity = 20;
  double youngs_modulus = 1e6;
  double area = 0.1;
  double density = 0.1;
  double strain = 0;
  bool one_way = true;
};

/// York's spring and mass (section 5.5): 0.3 long, mass 3.33, gravity 250; both ways.
BarChainProblem chain_spring_problem();
/// York's slack string (section 5.6): the same, one-way, its end 0.02 above where it becomes straight.
BarChainProblem chain_slack_problem();

/// Energies: `potential` from the place of the start, `elastic` of the elements that carry.
struct BarChainState {
  Bounded x, y, velocity_x, velocity_y;  // of the end
  Bounded length;                        // from the support to the end
  Bounded support_tension;               // of the uppermost element, a force
  Bounded kinetic, elastic, potential;
};

/// When the end stops to turn about the support (swing) or to move along gravity (bounce); the start is number 0.
enum class ChainTurn { swing, bounce };
struct BarChainTurn {
  Bounded time, x, y;
};

class BarChain {
 public:
  /// A multiple of four elements, 4 to 400; tolerance of a step in [1e-12, 1e-4], as a share of the length and of the
  /// speed sqrt(g L). Cost per simulated time grows as elements^2 (York's pendulum, 8 elements: 0.1 s a second).
  /// Throws ParameterError.
  explicit BarChain(const BarChainProblem& problem = {}, int elements = 8, double tolerance = 1e-8);

  const BarChainProblem& problem() const { return problem_; }
  double rest_length() const { return rest_length_; }
  double string_mass_ratio() const { return mass_ratio_; }  // string over end

  /// At times that do not decrease, >= 0; each call integrates from the start.
  std::vector<BarChainState> at(std::span<const double> times) const;
  BarChainState at(double time) const;
  /// The start and the next `count` turns. Throws ParameterError where a chain that hangs straight down should swing.
  std::vector<BarChainTurn> turns(ChainTurn kind, int count) const;
  /// From the start to the second turn.
  Bounded period(ChainTurn kind) const;

 private:
  BarChainProblem problem_;
  int elements_;
  double tolerance_, rest_length_, mass_ratio_;
};

}  // namespace plumbline::reference
