// Safe steps of a bar against closed forms of its limits.
#include "cases/harness/laboratory/safe_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

namespace plumbline::safe_step_test {
namespace {

// Stress last, one point in the middle of each cell: a wave of k has the gradient s = 2 sin(k h/2)/h and C = cos(k h/2) of its
// velocity on the grid, so that v' = v + dt C s S, S' = S - dt s (C v + dt s S) with trace 2 - (dt s)^2 and determinant
// 1 - (dt s)^2 (1 - C^2). At k h = pi it leaves the unit circle where 4 = 2 (dt s)^2: dt = h/(c sqrt 2). Behind a free end at
// the depth d of its cell it is that of the light node, sqrt(2 d) to the order of d: the shallowest sampled.
TEST(SafeStep, OfABarAndOfItsFreeEnd) {
  for (const bool finely : {false, true}) {
    const SafeStep safe = safe_step_of_bar({"usl", "linear", "flip"}, 2, {}, 1, finely);
    const double depth = finely ? 1e-4 : 0.01;
    EXPECT_NEAR(safe.regular, std::sqrt(0.5), 1e-4) << finely;
    EXPECT_EQ(safe.edge_depth, depth);
    EXPECT_NEAR(safe.edge, std::sqrt(2 * depth), (depth + 1e-4) * std::sqrt(2 * depth)) << finely;
    EXPECT_LE(safe.limit, safe.regular);
    EXPECT_EQ(safe.worst(), std::min(safe.limit, safe.edge));
  }
}

TEST(SafeStep, IsNoneWhereEveryStepGrows) {
  const SafeStep safe = safe_step_of_bar({made_up::forward_euler, "linear", "flip"}, 2, {}, 1, false);
  EXPECT_EQ(safe.regular, 0);
  EXPECT_EQ(safe.worst(), 0);
}

}  // namespace
}  // namespace plumbline::safe_step_test
