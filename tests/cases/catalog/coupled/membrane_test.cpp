// Membranes of coupled cases: shares of length, mass and volume, what they enclose, and how a bag is looked at.
#include "cases/catalog/coupled/membrane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/catalog/coupled/dog_bone.hpp"
#include "cases/harness/description/case.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline::membrane_test {
namespace {

const MembraneMaterial skin{1e6, 0.3, 0.5, 0.1};

Curve arc(double radius, int segments) {
  Curve curve;
  for (int k = 0; k <= segments; ++k) {
    const double angle = std::numbers::pi / 2 * k / segments;
    curve.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

double sum(const Columns& points, const ColumnId& id) {
  double all = 0;
  for (int p = 0; p < points.points(); ++p) all += points(id)[p];
  return all;
}

Settings choices(const std::string& strain) {
  return find_case("membrane-expansion").settings("default", {{"membrane.strain", strain}});
}

// Of an arc and of the dog-bone at all of York's meshes but the coarsest, whose corners lie between two points.
TEST(Membrane, OrderIsFoundAgain) {
  for (const Curve& curve :
       {arc(2, 7), arc(2, 100), dog_bone_outline(16), dog_bone_outline(32), dog_bone_outline(500)}) {
    const Curve mixed = out_of_order(curve);
    EXPECT_TRUE(std::is_permutation(curve.begin(), curve.end(), mixed.begin(), mixed.end()));
    int still = 0;
    for (std::size_t k = 1; k < mixed.size(); ++k) {
      const auto at = std::find(curve.begin(), curve.end(), mixed[k]) - curve.begin();
      still += std::abs(at - (std::find(curve.begin(), curve.end(), mixed[k - 1]) - curve.begin())) == 1;
    }
    EXPECT_EQ(still, 0) << curve.size();
    EXPECT_EQ(in_order(mixed, {{0, 0}}), curve) << curve.size();
  }
  const Curve quarter = arc(1, 9);
  EXPECT_EQ(in_order({quarter.rbegin(), quarter.rend()}, {{0, 0}}), quarter);
}

TEST(Membrane, VerticesAtEvenDistances) {
  const Curve bent{{0, 0}, {1, 0}, {1, 2}};
  EXPECT_DOUBLE_EQ(length(bent), 3);
  const Curve even = evenly(bent, 6);
  ASSERT_EQ(even.size(), 7U);
  for (std::size_t k = 0; k + 1 < even.size(); ++k) {
    EXPECT_NEAR(std::hypot(even[k + 1][0] - even[k][0], even[k + 1][1] - even[k][1]), 0.5, 1e-15);
  }
  EXPECT_EQ(even.back(), bent.back());
  EXPECT_THROW(evenly(bent, 0), std::invalid_argument);
  EXPECT_THROW(length({{0, 0}}), std::invalid_argument);
}

// All of rho t L, whichever points carry it; a strain at the start leaves the unstretched membrane's.
TEST(Membrane, MassAndVolumeAreThoseOfTheUnstretchedLength) {
  const Curve curve{{0, 0}, {1, 0}, {1, 2}};
  for (const char* strain : {"segments", "accumulated"}) {
    for (const bool closed : {false, true}) {
      const Body body = membrane_body(choices(strain), "skin", skin, curve, 0.25, closed);
      const double whole = (3 + (closed ? std::sqrt(5.0) : 0)) / 1.25;
      EXPECT_NEAR(sum(body.points, column::volume), skin.thickness * whole, 1e-15) << strain << closed;
      EXPECT_NEAR(sum(body.points, column::mass), skin.density * skin.thickness * whole, 1e-15) << strain << closed;
      EXPECT_GT(body.spacing, 0);
    }
  }
  const Body ends = membrane_body(choices("segments"), "skin", skin, curve);
  EXPECT_DOUBLE_EQ(ends.points(column::mass)[0], 0.5 * 0.5 * 0.1);  // half of the first segment, 1 m
  EXPECT_DOUBLE_EQ(ends.points(column::rest_length)[1], 2);
}

// A cone's side: pi r s, half of it per pi; per radian r s / 2.
TEST(Membrane, RevolvedMassIsThatOfTheSurface) {
  const Body cone = revolved_body("cone", skin, evenly({{0, 1}, {2, 0}}, 7));
  EXPECT_NEAR(sum(cone.points, column::mass), skin.density * skin.thickness * std::sqrt(5.0), 1e-14);
  for (int p = 0; p < cone.points.points(); ++p) EXPECT_GT(cone.points(column::mass)[p], 0);
  EXPECT_NEAR(cone.points(column::rest_radius)[0], 1.0 / 7, 1e-15);
}

TEST(Membrane, EnclosedAreaAndVolume) {
  const Curve square{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_DOUBLE_EQ(enclosed(square), 2);
  EXPECT_DOUBLE_EQ(enclosed(square, true), 2);  // r^2/2 h per radian
  EXPECT_DOUBLE_EQ(enclosed({square.rbegin(), square.rend()}), -2);
  EXPECT_DOUBLE_EQ(enclosed({{0, 0}, {3, 0}, {0, 2}}, true), 3);  // a cone: r^2 h/6
  EXPECT_TRUE(inside(square, 1.9, 0.9));
  EXPECT_FALSE(inside(square, 2.1, 0.5));
  EXPECT_FALSE(inside(square, 1, -0.1));
}

TEST(Membrane, GasHasTheMassAndEnergyOfItsSpace) {
  GridSpec grid;
  grid.dim = 2;
  grid.cells = {16, 16, 1};
  grid.h = 0.1;
  for (const bool rings : {false, true}) {
    grid.axisymmetric = rings;
    const Body gas = fill_polygon("gas", std::make_shared<IdealGas>(), grid, 4, dog_bone_gas(), 2, 250);
    const double space = enclosed(dog_bone_gas(), rings);
    EXPECT_NEAR(sum(gas.points, column::mass), 2 * space, 1e-14);
    EXPECT_NEAR(sum(gas.points, column::volume), space, 1e-14);
    for (int p = 0; p < gas.points.points(); ++p) {
      EXPECT_TRUE(inside(dog_bone_gas(), gas.points(column::position)[p], gas.points(column::position, 1)[p]));
    }
  }
  EXPECT_THROW(fill_polygon("gas", std::make_shared<IdealGas>(), grid, 1, {{0, 0}, {1e-3, 0}, {0, 1e-3}}, 1, 1),
               std::invalid_argument);
}

TEST(Membrane, ABagIsLookedAt) {
  Body membrane = membrane_body(choices("segments"), "skin", skin, arc(1, 4));
  Body gas = make_body("gas", std::make_shared<IdealGas>(), 3, 2);
  const double at[3][2] = {{0.1, 0.1}, {0.5, 0.5}, {0.9, 0.9}};  // the last one outside
  for (int p = 0; p < 3; ++p) {
    for (int d = 0; d < 2; ++d) gas.points(column::position, d)[p] = at[p][d];
    gas.points(column::volume)[p] = p + 1;
    gas.points(column::pressure)[p] = 10 * (p + 1);
  }
  const double strains[4] = {1e-3, 2e-3, -1e-3, 3e-3};
  for (int s = 0; s < 4; ++s) membrane.points(column::strain)[s] = strains[s];
  const BagState bag = look_at(gas, membrane, skin, {{0, 0}});
  EXPECT_NEAR(bag.area, 2 * std::sin(std::numbers::pi / 8), 1e-15);  // four triangles
  EXPECT_DOUBLE_EQ(bag.gas_volume, 6);
  EXPECT_DOUBLE_EQ(bag.pressure, 140.0 / 6);
  EXPECT_EQ(bag.escaped, 1);
  const double modulus = 1e6 / 0.91;  // slack counts as no stress [York 5.12]
  EXPECT_NEAR(bag.hoop_stress, 1.5e-3 * modulus, 1e-9 * modulus);
  EXPECT_NEAR(bag.hoop_scatter, std::sqrt(1.25e-6) / 1.5e-3, 1e-12);
}

// [York A.4.7] Ends, length, area; a membrane that keeps its distance from the gas.
TEST(DogBone, IsAsYorkDescribesIt) {
  EXPECT_NEAR(enclosed(dog_bone_gas()), 0.47463, 5e-6);
  EXPECT_NEAR(dog_bone_length, 2.19919, 5e-6);
  const Curve outline = dog_bone_outline(2000);
  EXPECT_EQ(outline.front(), (std::array<double, 2>{0.5, 0}));
  EXPECT_EQ(outline.back()[0], 0);
  EXPECT_NEAR(outline.back()[1], 1, 0.01);
  EXPECT_NEAR(length(outline), dog_bone_length, 1e-4);
  double nearest = 1;
  const Curve gas = evenly(dog_bone_gas(), 400);
  for (const auto& at : outline) {
    EXPECT_FALSE(inside(dog_bone_gas(), at[0], at[1]));
    for (const auto& g : gas) {
      if (g[0] > 1e-9 && g[1] > 1e-9) nearest = std::min(nearest, std::hypot(at[0] - g[0], at[1] - g[1]));
    }
  }
  EXPECT_GT(nearest, 0.04);
  EXPECT_LT(nearest, 0.1);
}

}  // namespace
}  // namespace plumbline::membrane_test
