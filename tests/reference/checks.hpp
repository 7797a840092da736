#pragma once
// What the tests of the references share.
//
// Identities are evaluated in bounded arithmetic: a residual must contain zero within its own bound, and that bound
// must be small (`sharp`, four decades above rounding) or the check would say nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "reference/bounded.hpp"
#include "reference/parameter.hpp"

namespace plumbline::reference {

inline constexpr double sharp = 1e-12;

inline void expect_zero(Bounded residual, double scale, const char* what, double margin = sharp) {
  EXPECT_LE(std::abs(residual.value), residual.bound) << what;
  EXPECT_LE(residual.bound, margin * scale) << what;
}

inline void expect_same(Bounded a, Bounded b, double scale = 1) {
  EXPECT_LE(std::abs(a.value - b.value * scale), a.bound + b.bound * scale);
}

/// The value is known to `digits` (absolute), and its bound is far below.
inline void expect_near(Bounded x, double published, double digits) {
  EXPECT_NEAR(x.value, published, digits);
  EXPECT_LE(x.bound, 1e-3 * digits);
}

/// The key of the ParameterError that `make` throws.
inline std::string refused_key(const std::function<void()>& make) {
  try {
    make();
  } catch (const ParameterError& error) {
    return error.key;
  }
  return "accepted";
}

/// The same of the reference of a default problem after a change.
template <class Reference, class Problem>
std::string refused_change(const std::function<void(Problem&)>& change) {
  Problem problem;
  change(problem);
  return refused_key([&] { Reference reference(problem); });
}

/// The same where one number is another.
template <class Reference, class Problem>
std::string refused_value(double Problem::*member, double value) {
  return refused_change<Reference, Problem>([=](Problem& problem) { problem.*member = value; });
}

}  // namespace plumbline::reference
