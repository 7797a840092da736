#include "cases/harness/run/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace plumbline {
namespace {

constexpr double reversal_factor = 2;  // two samples, each wrong by `noise`, differ by twice as much
constexpr double depth_factor = 10;    // deep enough that the bend stands out from the noise

struct History {
  std::span<const double> times, values;
};

void check(const History& history, double noise) {
  const auto [times, values] = history;
  if (times.size() != values.size()) throw std::invalid_argument("extremes: times and values differ in length");
  if (!std::isfinite(noise) || noise < 0) throw std::invalid_argument("extremes: noise must be finite and >= 0");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !std::isfinite(values[i]))
      throw std::invalid_argument("extremes: sample " + std::to_string(i) + " is not finite");
    if (i > 0 && !(times[i] > times[i - 1]))
      throw std::invalid_argument("extremes: times do not increase at sample " + std::to_string(i));
  }
}

struct TurningPoint {
  std::size_t index;  // the first of equal samples
  bool maximum;
};

// A sample is a turn once the values have come back from it by more than the threshold.
std::vector<TurningPoint> find_turns(std::span<const double> values, double threshold) {
  std::vector<TurningPoint> turns;
  enum class Way { unknown, up, down } way = Way::unknown;
  std::size_t top = 0, bottom = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[top]) top = i;
    if (values[i] < values[bottom]) bottom = i;
    if (way != Way::down && values[top] - values[i] > threshold) {
      if (way == Way::up) turns.push_back({top, true});
      way = Way::down;
      bottom = i;
    } else if (way != Way::up && values[i] - values[bottom] > threshold) {
      if (way == Way::down) turns.push_back({bottom, false});
      way = Way::up;
      top = i;
    }
  }
  return turns;
}

struct Window {
  std::size_t first, last;
};

// The unbroken stretch of samples within `depth` of sample `index`.
Window stretch(std::span<const double> values, std::size_t index, double depth) {
  Window window{index, index};
  const auto near = [&](std::size_t i) { return std::abs(values[i] - values[index]) <= depth; };
  while (window.first > 0 && near(window.first - 1)) --window.first;
  while (window.last + 1 < values.size() && near(window.last + 1)) ++window.last;
  return window;
}

struct Parabola {
  double c0, c1, c2;  // c0 + c1 u + c2 u^2
};

// Least squares by discrete orthogonal polynomials 1, u, u^2 - alpha u - beta; the sum of u must be zero.
Parabola fit_parabola(const std::vector<double>& u, const std::vector<double>& y) {
  double u2 = 0, u3 = 0;
  for (double x : u) {
    u2 += x * x;
    u3 += x * x * x;
  }
  const double count = static_cast<double>(u.size());
  const double alpha = u3 / u2, beta = u2 / count;
  double sum = 0, linear = 0, quadratic = 0, square = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double p = u[i] * u[i] - alpha * u[i] - beta;
    sum += y[i];
    linear += y[i] * u[i];
    quadratic += y[i] * p;
    square += p * p;
  }
  const double c2 = quadratic / square;
  return {sum / count - c2 * beta, linear / u2 - c2 * alpha, c2};
}

// Vertex of the least-squares parabola through the samples of the window, or nothing where it is no extreme of the
// kind wanted inside the window. Times and values are centred: that keeps the digits of a fine step at a late time.
std::optional<Extreme> vertex_in(const History& history, const Window& window, const TurningPoint& turn) {
  const auto [times, values] = history;
  const double begin = times[window.first], span = times[window.last] - begin;
  const std::size_t count = window.last - window.first + 1;
  double mean = 0;
  for (std::size_t i = window.first; i <= window.last; ++i)
    mean += (times[i] - begin) / span / static_cast<double>(count);
  std::vector<double> u, y;
  for (std::size_t i = window.first; i <= window.last; ++i) {
    u.push_back((times[i] - begin) / span - mean);
    y.push_back(values[i] - values[turn.index]);
  }
  const Parabola p = fit_parabola(u, y);
  const double vertex = -p.c1 / (2 * p.c2);
  const bool bends_rightly = turn.maximum ? p.c2 < 0 : p.c2 > 0;
  if (!bends_rightly || vertex < u.front() || vertex > u.back()) return {};
  return Extreme{begin + (vertex + mean) * span, values[turn.index] + p.c0 + p.c1 * vertex / 2, turn.maximum};
}

Extreme interpolate(const History& history, const TurningPoint& turn, double noise) {
  const auto [times, values] = history;
  const Window flat = stretch(values, turn.index, 0);
  const Extreme middle{(times[flat.first] + times[flat.last]) / 2, values[turn.index], turn.maximum};
  if (noise == 0 && flat.last - flat.first >= 2) return middle;
  const Window inner = stretch(values, turn.index, depth_factor * noise);
  const Window window{inner.first > 0 ? inner.first - 1 : 0, std::min(inner.last + 1, values.size() - 1)};
  return vertex_in(history, window, turn).value_or(middle);
}

}  // namespace

std::vector<Extreme> find_extremes(std::span<const double> times, std::span<const double> values, double noise) {
  const History history{times, values};
  check(history, noise);
  std::vector<Extreme> extremes;
  for (const TurningPoint& turn : find_turns(values, reversal_factor * noise))
    extremes.push_back(interpolate(history, turn, noise));
  return extremes;
}

std::optional<double> mean_period(std::span<const Extreme> extremes) {
  double time = 0;
  std::size_t periods = 0;
  for (bool maximum : {true, false}) {
    const Extreme* previous = nullptr;
    for (const Extreme& extreme : extremes) {
      if (extreme.maximum != maximum) continue;
      if (previous) {
        time += extreme.time - previous->time;
        ++periods;
      }
      previous = &extreme;
    }
  }
  if (periods == 0) return {};
  return time / static_cast<double>(periods);
}

}  // namespace plumbline
