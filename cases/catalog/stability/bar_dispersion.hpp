// How fast a wave of a few cells runs along a bar and decays, by the matrix of a step.
#pragma once

#include <vector>

#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {

// A trial for each transfer; names "dispersion-" and the transfer's.
std::vector<Trial> dispersion_trials();
// A gate for each of them.
std::vector<CaseGate> dispersion_gates();

}  // namespace plumbline
