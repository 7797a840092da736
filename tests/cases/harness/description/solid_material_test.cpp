#include "cases/harness/description/solid_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/harness/files/errors.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline::solid_material_test {
namespace {

TEST(SolidMaterial, ChoicesAreElasticSolids) {
  EXPECT_THAT(material_key(false).choices, testing::ElementsAre("own", "linear_elastic", "neo_hookean"));
  EXPECT_THAT(material_key(true).choices, testing::ElementsAre("own", "neo_hookean"));
}

TEST(SolidMaterial, AnotherLawTakesTheParametersThatItShares) {
  auto own = std::make_shared<LinearElastic>();
  own->youngs_modulus = 3;
  own->poissons_ratio = 0.2;
  own->density = 7;
  own->plane_stress = true;
  Settings settings({material_key(false)});
  EXPECT_EQ(chosen_material(settings, own), own);
  settings.set("material", "neo_hookean", "a case");
  const auto chosen = std::dynamic_pointer_cast<const NeoHookean>(chosen_material(settings, own));
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->youngs_modulus, 3);
  EXPECT_EQ(chosen->poissons_ratio, 0.2);
  EXPECT_EQ(chosen->density, 7);
  EXPECT_THROW(settings.set("material", "neo_hookan", "a case"), UsageError);
}

}  // namespace
}  // namespace plumbline::solid_material_test
