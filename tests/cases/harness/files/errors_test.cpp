// What the errors say.
#include "cases/harness/files/errors.hpp"

#include <gtest/gtest.h>

namespace plumbline::errors_test {
namespace {

TEST(Errors, AnUnknownNameOffersTheNearestAndListsAll) {
  const UsageError error = unknown_name("case", "sodd", {"sod", "spring-mass"});
  EXPECT_EQ(error.key, "case");
  EXPECT_EQ(error.value, "sodd");
  EXPECT_EQ(error.allowed, "sod, spring-mass");
  EXPECT_EQ(error.nearest, std::vector<std::string>{"sod"});
  EXPECT_STREQ(error.what(), "unknown case 'sodd'; did you mean sod? (known: sod, spring-mass)");
}

TEST(Errors, NothingIsOfferedWhereNothingIsNear) {
  const UsageError error = unknown_name("case", "xyzzy", {"sod"});
  EXPECT_TRUE(error.nearest.empty());
  EXPECT_STREQ(error.what(), "unknown case 'xyzzy' (known: sod)");
}

TEST(Errors, StatusesAreThoseOfTheContract) {
  EXPECT_EQ(exit_red, 1);
  EXPECT_EQ(exit_usage, 2);
  EXPECT_EQ(exit_stopped, 3);
  EXPECT_EQ(exit_files, 4);
}

}  // namespace
}  // namespace plumbline::errors_test
