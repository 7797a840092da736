#include "kernel/materials/material.hpp"

#include "tests/kernel/solids.hpp"

namespace plumbline::material_test {
namespace {

TEST(Material, SaysWhereItsEnergyIsKept) {
  EXPECT_EQ(IdealGas().store(), Store::internal);
  EXPECT_TRUE(IdealGas().takes_heat());
  EXPECT_TRUE(IdealGas().has_density());
  EXPECT_EQ(UniaxialMembrane().store(), Store::elastic);
  EXPECT_FALSE(UniaxialMembrane().takes_heat());
  EXPECT_FALSE(UniaxialMembrane().has_density());
}

}  // namespace
}  // namespace plumbline::material_test
