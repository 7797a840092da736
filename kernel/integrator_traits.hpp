// What a time integrator needs and offers, found by stepping a small scene and recording the stages it calls.
#pragma once

#include <string>
#include <vector>

#include "kernel/mechanics.hpp"
#include "kernel/time_integrator.hpp"
#include "kernel/traits.hpp"

namespace plumbline {

struct IntegratorTraits {
  Traits needs, offers;
  // In every step, before anything uses it: stresses need not follow sorted points.
  bool evaluates_stress_first = false;
  int force_evaluations = 0;  // of one step, the most of those tried
  int maps = 0;               // how often a step takes velocities from the grid to the points, the most of those tried
  bool drifts = false;        // points move with velocities of their own, not the grid's
  std::string failure;        // what the integrator threw when it was tried; else empty
};

// Found once for each entry, with its parameters as they are when made: two steps of different size on a column of gas,
// under a transfer that filters nothing and, if it fails there, under one that does. Any thread may ask.
const IntegratorTraits& traits_of(const IntegratorEntry& entry);

// How an engine serves an integrator.
EngineOptions engine_options(const IntegratorEntry& entry, int threads = 1);

// What is missing for an integrator under a shape and a transfer; in a whole scene, materials and couplings included. Empty
// where they can work together. Unknown names offer nothing.
std::vector<Lack> lacks(const IntegratorEntry& entry, const std::string& shape, const std::string& transfer);
std::vector<Lack> lacks(const IntegratorEntry& entry, const Scene& scene);

}  // namespace plumbline
