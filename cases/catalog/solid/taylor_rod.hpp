// A cylinder of an elastoplastic metal that strikes a rigid frictionless wall, by rings.
#pragma once

#include <memory>

#include "cases/harness/description/case.hpp"

namespace plumbline {

struct TaylorRod {
  double length = 32.4e-3, radius = 3.2e-3;  // m
  double velocity = 227;                     // m/s, towards the wall
  double youngs_modulus = 117e9, poissons_ratio = 0.35, density = 8930;
  double yield_stress = 400e6, hardening_modulus = 100e6;  // Pa
  double viscosity_linear = 0;                             // c_L of the solid
  double end_time = 80e-6;                                 // s

  bool operator==(const TaylorRod&) const = default;
};

// Measures, at the end if nothing else is said; "share": over the energy at the start:
//   length, radius     of the rod, at the corners of its points' domains, m; beside published ones, where the rod is that one
//   estimate           L exp(-rho V^2/(2 Y)), m, beside `length`
//   plastic_strain     the largest
//   lines_kept         mean stretch of the lines along the axis, without what elastic strains add, over the least one
//                      that the energy at the start allows  [Taylor 1]
//   lines_excess       largest over points of |ln stretch of such a line| - alpha, of which plastic flow allows none  [Taylor 2]
//   yield_off          largest over points and steps of (q - Y - H alpha)/Y, of points that flow its size
//   flow_back          largest fall of a point's plastic strain in a step
//   volume_off         largest over points and steps of |ln det F - tr elastic strain|: flow keeps the volume
//   store_off          largest share over the steps of the ledger's elastic energy less that of the strains and H alpha^2/2
//   heat_off           the same of its internal energy less Y alpha and the heat by viscosity
//   heat_fall          the same of the fall of that internal energy in a step
//   energy_off         the same of the energy that no flow accounts for
//   momentum_off       the same of the momentum along the axis, over that of the start: all of it is the wall's
//   wall_work, kinetic, elastic, heat, hardening, lost, plastic_work   shares; lost: what the maps and strains took
//   start              the points' energy at the start less the rod's, over it
//   alternation        of the pressure from point to point along the axis, over Y
//   face_stress.L1, face_velocity.L1, face_plastic_strain.L1   of points within R/5 of the axis against the plate impact
//   face_plateau       mean stress of those from a quarter to half of the way to the plastic shock, Pa
//                      of the face none but up to R/(2 c_e), while nothing from the rod's side has come there
std::unique_ptr<Problem> taylor_rod_problem(const TaylorRod& rod, const Settings& settings);

}  // namespace plumbline
