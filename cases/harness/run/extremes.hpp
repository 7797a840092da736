// Extremes of a sampled history, and the period they give.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace plumbline {

struct Extreme {
  double time;
  double value;
  bool maximum;  // else a minimum
};

// Interior extremes of the history (times[i], values[i]) in order of time; maxima and minima alternate.
// Each is the vertex of the parabola through the highest (lowest) sample and its two neighbours; steps may
// differ. The first and last sample are never extremes: nothing is known beyond them.
//
// For a cos(omega t) and steps of tau, to leading order in omega tau (a quadratic p that interpolates t^4
// at a, b, c has p'(0) = -(a + b)(b + c)(c + a)):
//   error in time  <= omega^2 tau^3 / (36 sqrt 3) with equal steps,
//                  <= omega^2 tau^3 / 8 with steps of at most tau;
//   error in value <= 3 a (omega tau)^4 / 128 with equal steps.
//
// Two equal samples at the top count as one: the parabola is then the least-squares one through both and a neighbour
// on either side. Three or more are flat (quantised values, a body at rest): their middle is the extreme.
//
// noise >= 0, unit of the values: samples may be wrong by that much. Reversals of up to 2 noise are not
// extremes, and the parabola is the least-squares one through the unbroken stretch of samples within 10
// noise of the extreme sample and one neighbour on either side. Choose it well below the amplitude: the
// quartic term that the parabola leaves out grows with the square of the stretch's depth.
//
// Where that parabola bends the wrong way or has its vertex outside the stretch (a cusp), the middle of the samples
// equal to the extreme one counts.
//
// Throws std::invalid_argument for different lengths, times that do not increase, values or noise not
// finite.
std::vector<Extreme> find_extremes(std::span<const double> times, std::span<const double> values, double noise = 0);

// Mean over the whole periods between extremes of the same kind: first to last maximum and first to last
// minimum, divided by the number of periods in both. With N periods of either kind the error is at most
// 2/N of an extreme's error in time. Empty without two extremes of one kind. Unit of the times.
std::optional<double> mean_period(std::span<const Extreme> extremes);

}  // namespace plumbline
