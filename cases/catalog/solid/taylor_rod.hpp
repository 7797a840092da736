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

// Measures, at the end if nothing else is said:
//   length, radius     of the rod, at the corners of its points' domains, m; beside published ones, where the rod is that one
//   plastic_strain     the largest
//   estimate           length that energy alone gives a rod without hardening, L exp(-rho V^2/(2 Y)), beside `length`
//   lines_kept         mean stretch of the lines along the axis, without what elastic strains add, over the least one
//                      that the energy at the start allows  [Taylor 1]
//   lines_excess       largest over points of |ln stretch of such a line| - alpha, of which plastic flow allows none  [Taylor 2]
//   yield_violation    largest over points and steps of (q - Y - H alpha)/Y, of the strains that the columns hold
//   volume_off         largest over points and steps of |ln det F - tr elastic strain|: flow keeps the volume
//   heat_off           largest over the steps of the ledger's internal energy less Y alpha and the heat by viscosity
//   heat_fall          largest fall of that internal energy in a step
//   energy_off         largest over the steps of the energy that no flow accounts for
//   momentum_off       the same of the momentum along the axis, over that of the start: all of it is the wall's
//   kinetic, elastic, heat, hardening, lost   where the energy is at the end; lost: what the maps and strains took
//   plastic_work       Y alpha + H alpha^2/2 of all points
//                      the last nine over the energy at the start
//   mirrored           how far points stand behind the wall, over the length
//   face_stress, face_plastic_strain   of the points at the middle of the face, while nothing from the rod's side has come
//                      there, that one which is furthest from the exact plate impact; no number later
std::unique_ptr<Problem> taylor_rod_problem(const TaylorRod& rod, const Settings& settings);

}  // namespace plumbline
