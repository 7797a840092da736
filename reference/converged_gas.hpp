#pragma once
// References for gas flows without a closed solution: the Lagrangian scheme on three meshes, each twice as fine as the
// one before, and from their differences an estimate of what the finest still gets wrong.
#include <optional>
#include <vector>

#include "reference/lagrangian_gas.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

/// `gas` may be longer or shorter than the domain [low, high] on which the flow at the end time is asked for: beyond an
/// outflow end the gas must still be as at t = 0, carried on at its own speed (so `gas.initial` must answer there),
/// beyond a free surface is vacuum.
struct ConvergedGasProblem {
  GasProblem gas;
  double low = 0, high = 1;
  CellPlacement place;                // of the cells at t = 0
  std::optional<double> front_speed;  // of a free surface on the right that stands at `high` at the end, if known
};

/// The estimate is Roache's grid convergence index: difference of the two finer meshes over 2^p - 1, times 1.25, with
/// the order p observed in the mean of the field, no less than 1/2 and no more than theory allows: 1, or 2 without
/// shocks (P. J. Roache, Verification and Validation in Computational Science and Engineering, 1998, chapter 5). It is
/// meant as a 95 % interval and is no proof: a value at a point is expected to lie within its bound at 95 % of the gas,
/// a mean always.
class ConvergedGas {
 public:
  /// About `cells` cells on the finest mesh. Throws ParameterError or std::runtime_error as the solver does.
  ConvergedGas(const ConvergedGasProblem& problem, int cells);

  const ConvergedGasProblem& problem() const { return problem_; }
  /// At the end time. In a vacuum density, pressure and energy are 0 and the velocity is that of the gas's edge.
  Sample sample(double x) const;
  /// Estimated mean |error| of `sample` over the volume of [low, high].
  const GasFields& error() const { return error_; }
  const GasFields& order() const { return order_; }  // observed, as it came out
  const LagrangianSolution& finest() const { return fine_; }
  double steepest() const;  // where the pressure changes most from one cell to the next: the strongest shock

 private:
  GasFields value(const LagrangianSolution& solution, double x) const;
  void compare(const LagrangianSolution& medium, const LagrangianSolution& coarse);
  bool is_vacuum(const LagrangianSolution& solution, double x) const;
  GasFields beyond_edge() const;

  ConvergedGasProblem problem_;
  LagrangianSolution fine_;
  std::vector<GasFields> bounds_;  // for each cell of the finest mesh
  GasFields error_, order_;
};

ConvergedGasProblem shu_osher_reference(double end_time = 1.8, double amplitude = 0.2, double wave_number = 5);
ConvergedGasProblem woodward_colella_reference(double end_time = 0.038);
ConvergedGasProblem gas_expansion_reference(double radius = 0.38, double end_time = 0.005);

inline constexpr int shu_osher_cells = 3600, woodward_colella_cells = 2800, gas_expansion_cells = 2000;

/// Solved at the first call, once in a process (about 1 s on one core); thread safe.
const ConvergedGas& shu_osher();         // x in [-5, 5]
const ConvergedGas& woodward_colella();  // x in [0, 1]
const ConvergedGas& gas_expansion();     // x = radius >= 0, York's text: radius 0.38, t = 0.005
/// Each radius (0, inf), time (0, 0.8 radius/c0), before the rarefaction meets itself on the axis, and mesh once.
const ConvergedGas& gas_expansion(double radius, double end_time, int cells = gas_expansion_cells);

/// Closed forms for York's gas: first gas to move, radius - c0 t (before it reaches the axis), and edge of the
/// vacuum, radius + 2 c0 t/(gamma - 1) (Toro, section 4.6), in the cylinder too: at the edge no pressure is left to
/// change its speed.
Bounded gas_expansion_head(double radius, double time);
Bounded gas_expansion_front(double radius, double time);

}  // namespace plumbline::reference
