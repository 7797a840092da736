#pragma once
// The exponential function and its divided difference, with bounds.
#include "reference/bounded.hpp"

namespace plumbline::reference {

inline Bounded exp(Bounded x) {
  const double value = std::exp(x.value);
  return rounding::result(value, value * std::expm1(x.bound) * rounding::inflate, 2);
}

namespace divided_difference {
inline constexpr double tiny = 1e-30;  // far below rounding, far above the numbers that lose digits
}

/// (e^x - 1)/x, and 1 at x = 0: increasing, without cancellation.
inline Bounded expm1_over(Bounded x) {
  constexpr double tiny = divided_difference::tiny;
  auto exact = [](double at) { return std::abs(at) < tiny ? Bounded(1, tiny) : expm1(Bounded(at)) / at; };
  return over_interval(exact, x, -rounding::infinity);
}

/// -log(1 - x)/x for x < 1, and 1 at x = 0: increasing, without cancellation.
inline Bounded log1m_over(Bounded x) {
  constexpr double tiny = divided_difference::tiny;
  auto exact = [](double at) {
    return std::abs(at) < tiny ? Bounded(1, tiny) : rounding::result(-std::log1p(-at), 0, 2) / at;
  };
  return over_interval(exact, x, -rounding::infinity);
}

/// x^n for a whole n >= 0.
inline Bounded power(Bounded x, int n) {
  Bounded product(1);
  for (int i = 0; i < n; ++i) product = i == 0 ? x : product * x;
  return product;
}

}  // namespace plumbline::reference
