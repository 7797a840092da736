// Zero crossings of a sampled history, and the period they give.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace plumbline {

// Mean period of a history (times[i], values[i]) that oscillates about zero: from the first to the last crossing
// upwards and from the first to the last downwards, divided by the number of periods in both. A crossing lies where the
// chord of two samples of different sign does; sin(omega t) does not bend there, and its crossing is wrong by at most
// omega^2 tau^3 / (36 sqrt 3) for steps of tau, to leading order. An offset moves all crossings of a direction alike.
// Zero counts as positive. Empty without two crossings of one direction. Unit of the times.
// Throws std::invalid_argument for different lengths.
std::optional<double> crossing_period(std::span<const double> times, std::span<const double> values);

}  // namespace plumbline
