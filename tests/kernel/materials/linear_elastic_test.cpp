#include "kernel/materials/linear_elastic.hpp"

#include <Eigen/Core>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::linear_elastic_test {
namespace {

using scenes::Space;
using Matrix = Eigen::Matrix3d;

constexpr double e = 7, nu = 0.3, rho = 2, volume = 0.5;

LinearElastic law(bool plane_stress = false) {
  LinearElastic material;
  material.youngs_modulus = e;
  material.poissons_ratio = nu;
  material.density = rho;
  material.plane_stress = plane_stress;
  return material;
}

Columns points_of(const LinearElastic& material, Space space, int count = 1) {
  Body body = make_body("solid", std::make_shared<LinearElastic>(material), count, scenes::dim_of(space),
                        space == Space::axisymmetric);
  std::fill_n(body.points(column::volume), count, volume);
  std::fill_n(body.points(column::mass), count, rho * volume);
  return std::move(body.points);
}
MaterialContext in(Space space, double ahead = 0) { return {scenes::dim_of(space), 0.1, false, ahead, false}; }

// Which entry of the tensor each component is.
std::vector<std::array<int, 2>> entries(Space space) {
  if (space == Space::line) return {{0, 0}};
  if (space == Space::plane) return {{0, 0}, {1, 1}, {0, 1}};
  if (space == Space::axisymmetric) return {{0, 0}, {1, 1}, {2, 2}, {0, 1}};
  return {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};
}

// Strains of any sign; shears are engineering strains.
std::vector<double> some_strain(Space space) {
  const double all[] = {0.01, -0.02, 0.03, 0.014, -0.022, 0.006};
  return {all, all + entries(space).size()};
}

// eps = ((1 + nu) sigma - nu tr(sigma) 1) / E, solved for sigma with what the geometry says of the other directions: on a
// line no other stress, in the plane no strain or no stress across it.
Matrix stress_by_compliance(Space space, const std::vector<double>& strain, bool plane_stress) {
  Matrix eps = Matrix::Zero();
  const auto where = entries(space);
  for (std::size_t k = 0; k < where.size(); ++k) {
    const auto [i, j] = where[k];
    eps(i, j) = eps(j, i) = i == j ? strain[k] : strain[k] / 2;
  }
  const bool given[3] = {
      true, space != Space::line,
      space == Space::solid || space == Space::axisymmetric || (space == Space::plane && !plane_stress)};
  // Unknown: the three normal stresses. Rows: the strain where it is given, no stress elsewhere.
  Eigen::Matrix3d rows;
  Eigen::Vector3d right;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rows(i, j) = given[i] ? (i == j ? 1 / e : -nu / e) : i == j;
    right[i] = given[i] ? eps(i, i) : 0;
  }
  const Eigen::Vector3d normal = dense::solve(rows, right);
  Matrix sigma = e / (1 + nu) * eps;
  for (int i = 0; i < 3; ++i) sigma(i, i) = normal[i];
  return sigma;
}

class Hooke : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Hooke, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// A handful of roundings of numbers below one, times E.
constexpr double rounding = 1e-15;

// The stress of a strain is what has that strain by the law as handbooks print it, strains from stresses. [Hooke 1]
TEST_P(Hooke, StressHasTheStrain) {
  for (bool plane_stress : {false, true}) {
    const LinearElastic material = law(plane_stress);
    Columns points = points_of(material, GetParam());
    const auto strain = some_strain(GetParam());
    for (std::size_t k = 0; k < strain.size(); ++k) points(column::strain, static_cast<int>(k))[0] = strain[k];
    material.evaluate_stress(points, all_points(points), in(GetParam()));
    const Matrix sigma = stress_by_compliance(GetParam(), strain, plane_stress);
    const auto where = entries(GetParam());
    for (std::size_t k = 0; k < where.size(); ++k) {
      EXPECT_NEAR(points(column::stress, static_cast<int>(k))[0], sigma(where[k][0], where[k][1]), rounding) << k;
    }
  }
}

// dW/d eps = sigma, component by component: W is a parabola, whose central difference is exact but for rounding. [Hooke 1]
TEST_P(Hooke, StressIsTheSlopeOfTheEnergy) {
  for (bool plane_stress : {false, true}) {
    const LinearElastic material = law(plane_stress);
    Columns points = points_of(material, GetParam());
    const auto strain = some_strain(GetParam());
    const auto set = [&](std::size_t moved, double by) {
      for (std::size_t k = 0; k < strain.size(); ++k) {
        points(column::strain, static_cast<int>(k))[0] = strain[k] + (k == moved ? by : 0);
      }
    };
    const double d = 1e-3;
    for (std::size_t k = 0; k < strain.size(); ++k) {
      set(k, d);
      const double more = material.stored_energy(points, all_points(points));
      set(k, -d);
      const double less = material.stored_energy(points, all_points(points));
      set(k, 0);
      material.evaluate_stress(points, all_points(points), in(GetParam()));
      EXPECT_NEAR((more - less) / (2 * d) / volume, points(column::stress, static_cast<int>(k))[0], 1e-14) << k;
    }
  }
}

// Strains add up what the rates are, and what is stored meanwhile is returned; of other points nothing changes. [Hooke 1]
TEST_P(Hooke, AdvancesByItsRates) {
  const LinearElastic material = law();
  Columns points = points_of(material, GetParam(), 11);
  const int components = points.components(column::strain);
  for (int p = 0; p < 11; ++p) {
    for (int k = 0; k < components; ++k) {
      points(column::strain, k)[p] = 0.01 * p - 0.003 * k;
      points(column::strain_rate, k)[p] = 0.2 * k - 0.1 * p;
    }
  }
  const Columns before = points;
  const PointRange range{3, 10};
  const double stored = material.advance(points, range, in(GetParam()), 0.01);
  for (int p = 0; p < 11; ++p) {
    const double moved = p >= 3 && p < 10 ? 0.01 : 0;
    for (int k = 0; k < components; ++k) {
      EXPECT_NEAR(points(column::strain, k)[p],
                  before(column::strain, k)[p] + moved * before(column::strain_rate, k)[p],
                  1e-16);  // two roundings of 0.1
    }
  }
  EXPECT_NEAR(stored, material.stored_energy(points, range) - material.stored_energy(before, range), rounding);
  EXPECT_NEAR(stored,
              material.stored_energy(points, all_points(points)) - material.stored_energy(before, all_points(before)),
              rounding);
  ASSERT_EQ(material.internal_variables(in(GetParam())), (std::vector<const ColumnId*>{&column::strain}));
  const auto rates = material.rates(before, in(GetParam()));
  for (int k = 0; k < components; ++k) {
    for (int p = 0; p < 11; ++p) {
      EXPECT_EQ(rates[static_cast<std::size_t>(k * 11 + p)], before(column::strain_rate, k)[p]);
    }
  }
}

// `ahead`: the stress that the strain rates lead to, while nothing is advanced. [Hooke 1]
TEST_P(Hooke, PredictsItsStress) {
  const LinearElastic material = law();
  Columns points = points_of(material, GetParam());
  const auto strain = some_strain(GetParam());
  for (std::size_t k = 0; k < strain.size(); ++k) {
    points(column::strain, static_cast<int>(k))[0] = strain[k];
    points(column::strain_rate, static_cast<int>(k))[0] = 1 - 0.7 * static_cast<double>(k);
  }
  Columns later = points;
  material.evaluate_stress(points, all_points(points), in(GetParam(), 0.02));
  material.advance(later, all_points(later), in(GetParam()), 0.02);
  material.evaluate_stress(later, all_points(later), in(GetParam()));
  for (std::size_t k = 0; k < strain.size(); ++k) {
    const int c = static_cast<int>(k);
    EXPECT_NEAR(points(column::stress, c)[0], later(column::stress, c)[0], rounding);
    EXPECT_EQ(points(column::strain, c)[0], strain[k]);
  }
}

// rho c^2 is what an added strain along one axis adds to the stress along it. [Hooke 1]
TEST_P(Hooke, WaveSpeedIsTheStiffnessOfOneAxis) {
  const int dim = scenes::dim_of(GetParam());
  for (bool plane_stress : {false, true}) {
    const LinearElastic material = law(plane_stress);
    Columns points = points_of(material, GetParam());
    points(column::strain)[0] = 1;
    material.evaluate_stress(points, all_points(points), in(GetParam()));
    const double c = std::sqrt(points(column::stress)[0] / rho);
    if (GetParam() != Space::axisymmetric) {
      EXPECT_NEAR(material.wave_speed(dim), c, 4 * rounding);
    }
    points(column::velocity, dim - 1)[0] = -3;
    EXPECT_NEAR(material.step_bounds(points, all_points(points), dim).fastest, c + 3, 8 * rounding);
    EXPECT_EQ(material.step_bounds(points, all_points(points), dim).diffusivity, 0);
  }
}

// As the books print it: sqrt(E/rho) on a line, sqrt(E/((1 - nu^2) rho)) in plane stress, sqrt(E (1 - nu)/((1 + nu)
// (1 - 2 nu) rho)) where nothing can contract. [Hooke 1]
TEST(LinearElastic, WaveSpeeds) {
  EXPECT_NEAR(law().wave_speed(1), std::sqrt(e / rho), rounding);
  EXPECT_NEAR(law(true).wave_speed(2), std::sqrt(e / (1 - nu * nu) / rho), 4 * rounding);
  const double bulk = std::sqrt(e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho);
  EXPECT_NEAR(law().wave_speed(2), bulk, 4 * rounding);
  EXPECT_NEAR(law().wave_speed(3), bulk, 4 * rounding);
  EXPECT_NEAR(law(true).wave_speed(3), bulk, 4 * rounding);  // plane stress is a choice of the plane alone
}

TEST(LinearElastic, SaysWhatIsWrong) {
  const LinearElastic material = law();
  Columns points = points_of(material, Space::plane, 3);
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, -1);
  points(column::strain, 2)[1] = std::nan("");
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, 1);
  EXPECT_EQ(material.first_fault(points, all_points(points)).field, "strain");
  EXPECT_EQ(material.first_fault(points, {2, 3}).point, -1);
}

TEST(LinearElastic, IsASymmetricElasticMaterial) {
  EXPECT_EQ(law().measure(), StressMeasure::symmetric);
  EXPECT_EQ(law().store(), Store::elastic);
  EXPECT_FALSE(law().takes_heat());
  EXPECT_FALSE(law().chain());
}

}  // namespace
}  // namespace plumbline::linear_elastic_test
