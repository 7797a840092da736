#include "kernel/materials/material_entry.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "tests/kernel/solids.hpp"

namespace plumbline::material_entry_test {
namespace {

TEST(MaterialEntry, RegistersItselfByItsName) {
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

TEST(MaterialEntry, AreListedInTheOrderOfTheirNames) {
  const auto& all = materials();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
}

TEST(MaterialEntry, MakesWhatItReads) {
  const auto made = material_named("neo_hookean").make({{"youngs_modulus", 3e5}, {"density", 7}});
  const auto& law = dynamic_cast<const NeoHookean&>(*made);
  EXPECT_EQ(law.youngs_modulus, 3e5);
  EXPECT_EQ(law.density, 7);
  EXPECT_EQ(law.poissons_ratio, NeoHookean().poissons_ratio);
  for (const MaterialEntry& entry : materials()) {
    const auto own = entry.make({});
    EXPECT_EQ(own->name(), entry.name);
    std::map<std::string, double> values;
    for (const MaterialParameter& parameter : entry.parameters(*own)) values[parameter.name] = 1;
    for (const MaterialParameter& parameter : parameters_of(*entry.make(values))) EXPECT_EQ(parameter.value, 1);
    EXPECT_THROW(entry.make({{"no such parameter", 1}}), std::invalid_argument);
  }
  EXPECT_THROW(material_named("rubber"), std::invalid_argument);
}

TEST(MaterialEntry, ParameterThatIsNoneIsNamedBesideThoseThatAre) {
  std::string said;
  try {
    material_named("neo_hookean").make({{"density", 7}, {"stiffness", 1}});
  } catch (const std::invalid_argument& error) {
    said = error.what();
  }
  EXPECT_EQ(said, "material neo_hookean has no parameter stiffness; it has youngs_modulus, poissons_ratio, density");
}

}  // namespace
}  // namespace plumbline::material_entry_test
