// What another program's points must have kept of the start's, whatever is judged of them otherwise.
#pragma once

#include <optional>
#include <vector>

#include "cases/harness/exchange/final_state.hpp"

namespace plumbline {

struct Balance {
  double mass = 0;                 // relative difference
  std::optional<double> momentum;  // largest difference over sum m |v|; none where something pushes in all directions
  double energy = 0;               // of motion and heat, over what the start has and loads and pistons can have added

  // The larger of each; what is not a number is the largest.
  void take_worse(const Balance& other);
};

struct Balanced {
  Balance balance;
  double mass_at_start = 0, mass_at_end = 0;  // kg
};

// Of the points `bodies` at `end_time` (s) with the start of `problem`.
Balanced balance_of(const Problem& problem, const Settings& settings, const std::vector<HandedIn>& bodies);

}  // namespace plumbline
