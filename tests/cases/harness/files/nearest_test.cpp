#include "cases/harness/files/nearest.hpp"

#include <gtest/gtest.h>

namespace plumbline::nearest_test {
namespace {

using Names = std::vector<std::string>;

const Names keys{"cells",           "cfl",           "dt",    "gamma",    "integrator",       "offset",
                 "points",          "ppc",           "shape", "transfer", "viscosity.linear", "viscosity.quadratic",
                 "membrane.strain", "membrane.loss", "N"};
const Names cases{"sod", "gas-expansion", "spring-mass", "string-slack", "stability-york", "two-bar"};

TEST(Nearest, FindsWhatWasMeant) {
  EXPECT_EQ(nearest("cflx", keys), Names{"cfl"});
  EXPECT_EQ(nearest("gama", keys), Names{"gamma"});
  EXPECT_EQ(nearest("CFL", keys), Names{"cfl"});
  EXPECT_EQ(nearest("shaep", keys), Names{"shape"});  // neighbours swapped
  EXPECT_EQ(nearest("cfl5", keys).front(), "cfl");
  EXPECT_EQ(nearest("intergator", keys), Names{"integrator"});
  EXPECT_EQ(nearest("sodd", cases), Names{"sod"});
  EXPECT_EQ(nearest("spring_mass", cases), Names{"spring-mass"});
}

TEST(Nearest, PrefersBeginningsAndParts) {
  EXPECT_EQ(nearest("spring", cases), Names{"spring-mass"});
  EXPECT_EQ(nearest("viscosity", keys), (Names{"viscosity.linear", "viscosity.quadratic"}));
  EXPECT_EQ(nearest("trans", keys), Names{"transfer"});
  EXPECT_EQ(nearest("linear", keys), Names{"viscosity.linear"});
  EXPECT_EQ(nearest("ppd", Names{"pcd", "ppc"}), (Names{"ppc", "pcd"}));  // the same distance, longer beginning
}

TEST(Nearest, OffersNothingFarAway) {
  EXPECT_TRUE(nearest("pressure_of_the_moon", keys).empty());
  EXPECT_TRUE(nearest("xyz", keys).empty());
  EXPECT_TRUE(nearest("x", keys).empty());
  EXPECT_TRUE(nearest("", keys).empty());
  EXPECT_TRUE(nearest("cflx", Names{}).empty());
}

TEST(Nearest, CutsOffAtAThirdOfTheLength) {
  EXPECT_EQ(nearest("dx", Names{"dt"}), Names{"dt"});  // one letter is always forgiven
  EXPECT_EQ(nearest("gaXXa", Names{"gamma"}), Names{});
  EXPECT_EQ(nearest("gamXa", Names{"gamma"}), Names{"gamma"});
  EXPECT_EQ(nearest("inXXXrator", Names{"integrator"}), Names{"integrator"});
  EXPECT_EQ(nearest("inXXXXator", Names{"integrator"}), Names{});
}

TEST(Nearest, KeepsToTheNumberAskedForAndOffersEachOnce) {
  const Names similar{"aaa1", "aaa2", "aaa3", "aaa4", "aaa1"};
  EXPECT_EQ(nearest("aaa", similar), (Names{"aaa1", "aaa2", "aaa3"}));
  EXPECT_EQ(nearest("aaa", similar, 9), (Names{"aaa1", "aaa2", "aaa3", "aaa4"}));
  EXPECT_TRUE(nearest("aaa", similar, 0).empty());
}

}  // namespace
}  // namespace plumbline::nearest_test
