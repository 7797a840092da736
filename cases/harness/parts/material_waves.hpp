// How fast plane waves run through points of a material, by its stresses, and how fast step_bounds() takes them to be.
#pragma once

#include "cases/harness/parts/material_gates.hpp"

namespace plumbline {

// Differences from -dt to dt, s, have errors of dt^2 and of roundings over dt, of rates and strains of order one.
inline constexpr double step_of_difference = 1e-5, of_difference = 1e-7;

// Points pulled alike in all directions, by 0.001, so that what only pulls does: how much the step's speed is below that of the
// fastest wave, and above it, relative.
double too_slow(const MaterialSubject& subject, std::size_t geometry);
double too_fast(const MaterialSubject& subject, std::size_t geometry);

// How much faster waves are than the step takes them to be, where points stand as they are.
double overtaken(const MaterialProbe& probe, ProbeRandom& random);

// What points that move add to the speed, less their own speed, over the speed of waves.
double off_motion(const MaterialProbe& probe, ProbeRandom& random);

}  // namespace plumbline
