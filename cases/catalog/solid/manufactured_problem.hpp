// A manufactured solution run on points: the start, the load, and the errors against the exact motion.
#pragma once

#include <memory>

#include "cases/harness/description/case.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/points/body.hpp"
#include "reference/manufactured/manufactured.hpp"

namespace plumbline {

using ExactMotion = std::shared_ptr<const reference::ManufacturedSolution>;

// What a case has to state. The body's points stand where the material was before anything moved, at X.
struct ManufacturedSetup {
  ExactMotion exact;
  double end_time = 0;  // s
  GridSpec grid = {};
  Body body = Body();
  bool loaded = true;  // false: the body is let go from the start of the motion
  bool turns = false;  // in the plane: grid and motion stay the same in a quarter turn about the origin
};

// The neo-Hookean material of the solution.
std::shared_ptr<NeoHookean> material_of(const reference::ManufacturedSolution& exact);

// grad v at t = 0, row-major: dv/dX F^-1, with dv/dX by central differences of fourth order with steps of 1e-3
// of `length`, the distance over which v changes by itself: right to some 1e-9 of v / length.
reference::Tensor<double> initial_velocity_gradient(const reference::ManufacturedSolution& exact,
                                                    const reference::Vector<double>& position, double length);

// Moves undeformed points to their places at t = 0, with velocities and F; with grad v where points carry one.
void start_motion(const reference::ManufacturedSolution& exact, bool affine, Body& body);

// Measures:
//   displacement.worst  largest over time of sqrt(sum_p V_p |u_p - u(X_p, t)|^2), m^(1 + dim/2): the norm of the
//                       published studies (de Vaucorbeil et al. 2020), over some 400 instants and the end
//   displacement, velocity, stress (first Piola-Kirchhoff, worked out of F): .L1 .L2 .Linf at the end
//   turned              of a setup that turns, if its points are the same after a quarter turn: largest distance between the displacement of a point's image in a quarter turn
//                       and the turned displacement, over the largest displacement, at the end
// Of a body that is let go, which follows a motion of its own:
//   energy_rise, energy_lost  largest rise in a step, and what is lost to the end, over the energy at the start
std::unique_ptr<Problem> manufactured_problem(ManufacturedSetup setup, const Settings& settings);

}  // namespace plumbline
