// Profiles of bars.
#pragma once

#include <gtest/gtest.h>

#include "cases/harness/run/experiment.hpp"

namespace plumbline {

// x rises from row to row, of which there are so many.
inline void expect_ordered_profile(const RunResult& run, std::size_t rows) {
  const auto& x = run.profile.find("x")->values;
  ASSERT_EQ(x.size(), rows);
  for (std::size_t k = 1; k < x.size(); ++k) EXPECT_GT(x[k], x[k - 1]);
  for (const ProfileColumn& column : run.profile.columns) EXPECT_EQ(column.values.size(), x.size());
}

}  // namespace plumbline
