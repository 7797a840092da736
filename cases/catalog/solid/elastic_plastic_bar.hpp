// A plate of an elastoplastic solid, in uniaxial strain along x, against a piston.
#pragma once

#include <memory>

#include "cases/harness/description/case.hpp"
#include "reference/elastic_plastic_impact.hpp"

namespace plumbline {

struct ElasticPlasticBar {
  reference::ElasticPlasticImpactProblem impact;
  double length = 1;            // m, at rest on [0, length]
  double end_time = 0;          // s, until the elastic wave arrives at the free end at the latest
  double viscosity_linear = 0;  // c_L of the solid
};

// Measures, at the end if nothing else is said:
//   velocity, stress, lateral_stress, plastic_strain   norms, points judged as particles
//   plateau_stress, _lateral_stress, _plastic_strain   of the point that is furthest from the exact one between a quarter and half
//                                                      of the way to the plastic wave
//   precursor_stress                                   the same in the middle fifth between the waves
//   yield_violation    largest over points and steps of (q - Y - H alpha)/Y, from what the columns hold
//   plastic_heat       Y alpha of all points, J/m^2
//   heat_off           largest over the steps of the ledger's internal energy less Y alpha and the heat by viscosity, over the
//                      piston's work
//   energy_off         the same of the piston's work and what maps and strains booked less all stores
//   unlike_power       what is stored and heated less the power of the stresses that moved the plate, over the piston's work
std::unique_ptr<Problem> elastic_plastic_bar_problem(const ElasticPlasticBar& bar, const Settings& settings);

}  // namespace plumbline
