#include "kernel/normals/normals.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/normals/curves.hpp"

namespace plumbline::normals_test {
namespace {

TEST(Normals, EveryNameMakesAMethodAndOthersDoNot) {
  EXPECT_EQ(normals_methods().size(), 8u);
  for (const Choice& choice : normals_methods()) {
    EXPECT_NE(make_normals(choice.name), nullptr) << choice.name;
    EXPECT_FALSE(choice.title.empty() || choice.source.empty()) << choice.name;
  }
  EXPECT_THROW(make_normals("yorks"), std::out_of_range);
}

TEST(Normals, AreUnitVectorsAndTheSameAgainFromTheSameObject) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 50), other = test::arc(0.5, 0.5, 0.3, 0, 360, 80);
  std::vector<double> gas_x, gas_y;
  test::fill_circle(0.1, 2, gas_x, gas_y);
  const GridSpec grid = test::square(12, 0.1, true);
  for (const Choice& choice : normals_methods()) {
    const auto method = make_normals(choice.name);
    std::vector<double> x(50), y(50), again_x(50), again_y(50), between_x(80), between_y(80);
    method->find({grid, quarter.x, quarter.y, gas_x, gas_y, {}, {}, false}, x, y);
    method->find({test::square(3, 0.4), other.x, other.y, {}, {}, {}, {}, true}, between_x, between_y);
    method->find({grid, quarter.x, quarter.y, gas_x, gas_y, {}, {}, false}, again_x, again_y);
    EXPECT_EQ(x, again_x) << choice.name;
    EXPECT_EQ(y, again_y) << choice.name;
    for (std::size_t p = 0; p < 50; ++p) EXPECT_NEAR(std::hypot(x[p], y[p]), 1, 1e-14) << choice.name;
  }
}

TEST(Normals, OutputMayBeThePreviousNormals) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 50);
  const GridSpec grid = test::square(12, 0.1, true);
  for (const Choice& choice : normals_methods()) {
    const std::vector<double> before_x(50, 1), before_y(50, 0);
    std::vector<double> x = before_x, y = before_y, apart_x(50), apart_y(50);
    make_normals(choice.name)->find({grid, quarter.x, quarter.y, {}, {}, before_x, before_y, false}, apart_x, apart_y);
    make_normals(choice.name)->find({grid, quarter.x, quarter.y, {}, {}, x, y, false}, x, y);
    EXPECT_EQ(x, apart_x) << choice.name;
    EXPECT_EQ(y, apart_y) << choice.name;
  }
}

TEST(Normals, NothingToDoWithoutPoints) {
  const GridSpec grid = test::square(12, 0.1);
  for (const Choice& choice : normals_methods()) {
    EXPECT_NO_THROW(make_normals(choice.name)->find({grid, {}, {}, {}, {}, {}, {}, false}, {}, {})) << choice.name;
  }
}

}  // namespace
}  // namespace plumbline::normals_test
