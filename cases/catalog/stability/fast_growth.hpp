// Limits where something grows slowly at every step, however small.
#pragma once

#include "cases/harness/laboratory/limits.hpp"

namespace plumbline {

// As predict() of an experiment in which nothing repeats, but a step counts as stable where nothing grows by more than
// exp(slow dt). slow: per unit of the scene's time, >= 0. Prediction::growth says what grows all the same.
Prediction predict_beside(double slow, const Experiment& experiment, const Scan& scan, double width);

// The watch that tells the two apart: runs so short that slow growth stays small.
Watch watch_beside(double slow, const Scan& scan);

// Growth per step as the step predicts it, and as a run shows it that is long enough for the fastest mode to be alone and
// short enough to stay small.
struct GrowthSeen {
  double predicted = 1, observed = 1;
};
GrowthSeen compare_growth(const Experiment& experiment, double dt);

}  // namespace plumbline
