#include "cases/harness/files/whole.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/harness/files/errors.hpp"

namespace plumbline::whole_test {
namespace {

TEST(Whole, NumbersThatAnIntHoldsAreKept) {
  EXPECT_EQ(whole(0), 0);
  EXPECT_EQ(whole(-3), -3);
  EXPECT_EQ(whole(std::numeric_limits<int>::max()), std::numeric_limits<int>::max());
}

TEST(Whole, AllOthersAreRefused) {
  for (const double count : {2147483648.0, -2147483648.0, 6e161, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(whole(count), UsageError) << count;
  }
}

}  // namespace
}  // namespace plumbline::whole_test
