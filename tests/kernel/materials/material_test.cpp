#include "kernel/materials/material.hpp"

#include <algorithm>

#include "tests/kernel/solids.hpp"

namespace plumbline {
namespace {

TEST(Material, RegistersItselfByItsName) {
  for (const std::string& name : {IdealGas().name(), UniaxialMembrane().name(), PlaneStressMembrane().name(),
                                  SegmentMembrane().name(), LinearElastic().name(), NeoHookean().name()}) {
    const auto& all = materials();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const MaterialEntry& entry) { return entry.name == name; });
    ASSERT_NE(found, all.end()) << name;
    EXPECT_FALSE(found->title.empty());
    EXPECT_FALSE(found->source.empty());
  }
}

TEST(Material, AreListedInTheOrderOfTheirNames) {
  const auto& all = materials();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
}

TEST(Material, SaysWhereItsEnergyIsKept) {
  EXPECT_EQ(IdealGas().store(), Store::internal);
  EXPECT_TRUE(IdealGas().takes_heat());
  EXPECT_TRUE(IdealGas().has_density());
  EXPECT_EQ(UniaxialMembrane().store(), Store::elastic);
  EXPECT_FALSE(UniaxialMembrane().takes_heat());
  EXPECT_FALSE(UniaxialMembrane().has_density());
}

}  // namespace
}  // namespace plumbline
