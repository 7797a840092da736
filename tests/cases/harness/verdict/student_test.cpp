#include "cases/harness/verdict/student.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumbline::student_test {
namespace {

TEST(StudentQuantile, ClosedFormsOfOneAndTwoDegrees) {
  const double p = 0.975;
  EXPECT_NEAR(student_quantile(1), std::tan(std::numbers::pi * (p - 0.5)), 1e-13);
  EXPECT_NEAR(student_quantile(2), (2 * p - 1) / std::sqrt(2 * p * (1 - p)), 1e-13);
}

// Roots of the regularised incomplete beta function in 30 digits (mpmath).
TEST(StudentQuantile, ComputedInMoreDigits) {
  EXPECT_NEAR(student_quantile(3), 3.18244630528370959, 1e-13);
  EXPECT_NEAR(student_quantile(6.5), 2.40200200791027772, 1e-13);
  EXPECT_NEAR(student_quantile(20), 2.08596344726586485, 1e-13);
}

TEST(StudentQuantile, WithoutFreedomNothingIsKnown) { EXPECT_TRUE(std::isinf(student_quantile(0))); }

}  // namespace
}  // namespace plumbline::student_test
