// What a run may take of the machine, known before its first step as far as it can be.
#pragma once

#include "cases/harness/description/case.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline {

// Of the whole process. Memory: nine tenths of what the machine, or the group of processes that this one is in, has.
struct Budget {
  double memory;       // bytes, > 0
  double steps = 1e9;  // of one run; with a hundred points, hours. Above 2^52 a step no longer advances the time.
};
Budget& budget();

// Allocations beyond the budget throw std::bad_alloc from here on, in this process and in those that it starts.
void limit_memory();

// What is said where memory beyond the budget was asked for.
UsageError beyond_memory();

// Points and cells of a scene, and what they take while it runs.
struct SceneSize {
  double points = 0, cells = 0;
  int dim = 1;
  double bytes() const;
};
SceneSize size_of(const Scene& scene);

// The size of a scene with many cells or points per cell, from small ones like it, as both grow as powers of the two; what is
// small is not asked for, and taken for nothing.
SceneSize foreseen_size(const Case& entry, const Settings& settings);

// Throws UsageError with the estimate where the budget is less.
void require_memory(const SceneSize& size, const Settings& settings);
// The same for a run to `end` (s) by steps of dt (s).
void require_steps(double end, double dt, const Settings& settings);
// Throws UsageError for an end that is no finite time, s.
void require_end(double end);

}  // namespace plumbline
