#include "kernel/geometry.hpp"

#include <Eigen/Geometry>

#include "kernel/pack.hpp"
#include "kernel/rotations.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::geometry_test {
namespace {

template <class G>
struct Sample {
  double s[G::strains], v[G::dim], g[G::dim], n_by_r;
  explicit Sample(scenes::Random& random) {
    for (double& x : s) x = random(-1, 1);
    for (double& x : v) x = random(-1, 1);
    for (double& x : g) x = random(-1, 1);
    n_by_r = random(-1, 1);
  }
};

// For any stress, velocity, gradient and N / r,
//   s . strain(v g^T, v_r N / r) = sum_cd v_c flux(s)_cd g_d + hoop(s) v_r N / r:
// what the forces do is what the strains get. Two sums of up to nine products of numbers below one, each good to 1.1e-16
// of their sum: 4e-15. [York 3.17, 3.23]
template <class G>
void expect_adjoint() {
  scenes::Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Sample<G> at(random);
    double gradient[G::dim][G::dim], strain[G::strains], flux[G::dim][G::dim], power = 0, work = 0;
    for (int c = 0; c < G::dim; ++c) {
      for (int d = 0; d < G::dim; ++d) gradient[c][d] = at.v[c] * at.g[d];
    }
    G::strain(gradient, at.v[0] * at.n_by_r, strain);
    G::flux(at.s, flux);
    for (int j = 0; j < G::strains; ++j) power += at.s[j] * strain[j];
    for (int c = 0; c < G::dim; ++c) {
      for (int d = 0; d < G::dim; ++d) work += at.v[c] * flux[c][d] * at.g[d];
    }
    if constexpr (G::axisymmetric) work += at.s[G::hoop] * at.v[0] * at.n_by_r;
    EXPECT_NEAR(power, work, 4e-15);
  }
}

TEST(Geometry, ForceIsAdjointToStrainOnALine) { expect_adjoint<Line>(); }
TEST(Geometry, ForceIsAdjointToStrainInThePlane) { expect_adjoint<Plane>(); }
TEST(Geometry, ForceIsAdjointToStrainOfRings) { expect_adjoint<Axisymmetric>(); }
TEST(Geometry, ForceIsAdjointToStrainInSpace) { expect_adjoint<Solid>(); }

// The fluxes are those of a symmetric tensor, so that stresses turn nothing.
template <class G>
void expect_symmetric_flux() {
  scenes::Random random(4);
  const Sample<G> at(random);
  double flux[G::dim][G::dim];
  G::flux(at.s, flux);
  for (int c = 0; c < G::dim; ++c) {
    for (int d = 0; d < G::dim; ++d) EXPECT_EQ(flux[c][d], flux[d][c]);
  }
}
TEST(Geometry, StressesAreSymmetric) {
  expect_symmetric_flux<Plane>();
  expect_symmetric_flux<Axisymmetric>();
  expect_symmetric_flux<Solid>();
}

template <class G>
std::vector<double> strain_of(const double (&gradient)[G::dim][G::dim], double hoop = 0) {
  double e[G::strains];
  G::strain(gradient, hoop, e);
  return {e, e + G::strains};
}

using Values = std::vector<double>;

// [York 3.23] e = (L + L^T)/2; shears stand as twice the tensor's.
TEST(Geometry, Strains) {
  EXPECT_EQ(strain_of<Line>({{3}}), Values{3});
  EXPECT_EQ(strain_of<Plane>({{1, 2}, {5, 7}}), (Values{1, 7, 7}));
  EXPECT_EQ(strain_of<Axisymmetric>({{1, 2}, {5, 7}}, 4), (Values{1, 7, 4, 7}));
  EXPECT_EQ(strain_of<Solid>({{1, 2, 4}, {8, 16, 32}, {64, 128, 256}}), (Values{1, 16, 256, 32 + 128, 64 + 4, 2 + 8}));
}
TEST(Geometry, RotationsDoNotStrain) {
  EXPECT_EQ(strain_of<Plane>({{0, -3}, {3, 0}}), (Values{0, 0, 0}));
  EXPECT_EQ(strain_of<Solid>({{0, -3, 2}, {3, 0, -1}, {-2, 1, 0}}), (Values{0, 0, 0, 0, 0, 0}));
}

template <int n>
Values rows_of(const double (&flux)[n][n]) {
  Values all;
  for (const auto& row : flux) all.insert(all.end(), std::begin(row), std::end(row));
  return all;
}

// [York 3.17] sigma grad N with sigma = (xx, yy, xy), (rr, zz, hoop, rz) and (xx, yy, zz, yz, zx, xy).
TEST(Geometry, Fluxes) {
  double plane[2][2], rings[2][2], solid[3][3];
  Plane::flux({2.0, 3.0, 5.0}, plane);
  EXPECT_EQ(rows_of(plane), (Values{2, 5, 5, 3}));
  Axisymmetric::flux({2.0, 3.0, 99.0, 5.0}, rings);
  EXPECT_EQ(rows_of(rings), (Values{2, 5, 5, 3}));
  Solid::flux({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, solid);
  EXPECT_EQ(rows_of(solid), (Values{1, 6, 5, 6, 2, 4, 5, 4, 3}));
}

// Packs do lane by lane what single numbers do.
TEST(Geometry, PacksStrainLikeNumbers) {
  Pack gradient[3][3], strain[6];
  double one[3][3], alone[6];
  for (int c = 0; c < 3; ++c) {
    for (int d = 0; d < 3; ++d) {
      gradient[c][d] = Pack([&](auto lane) { return 1.0 * c + 10.0 * d + 100.0 * static_cast<double>(lane); });
    }
  }
  Solid::strain(gradient, Pack(0.0), strain);
  for (int lane = 0; lane < lanes; ++lane) {
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d < 3; ++d) one[c][d] = gradient[c][d][static_cast<std::size_t>(lane)];
    }
    Solid::strain(one, 0.0, alone);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(strain[k][static_cast<std::size_t>(lane)], alone[k]);
  }
}

TEST(Geometry, CountsComponents) {
  EXPECT_EQ(strain_components(1, false), Line::strains);
  EXPECT_EQ(strain_components(2, false), Plane::strains);
  EXPECT_EQ(strain_components(2, true), Axisymmetric::strains);
  EXPECT_EQ(strain_components(3, false), Solid::strains);
  EXPECT_EQ(normal_components(1, false), Line::normals);
  EXPECT_EQ(normal_components(2, false), Plane::normals);
  EXPECT_EQ(normal_components(2, true), Axisymmetric::normals);
  EXPECT_EQ(normal_components(3, false), Solid::normals);
}

TEST(Geometry, CrossProduct) {
  const Eigen::Vector2d a(2, 3), b(5, 7);
  EXPECT_EQ(cross<2>(a, b)[0], 2 * 7 - 3 * 5);
  const Eigen::Vector3d u(2, 3, 5), v(7, 11, 13);
  const Spin<3> turn = cross<3>(u, v);
  const Eigen::Vector3d expected = u.cross(v);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(turn[k], expected[k]);
  EXPECT_EQ(cross<1>(Eigen::Matrix<double, 1, 1>(2.0), Eigen::Matrix<double, 1, 1>(5.0)).size(), 0);
}

}  // namespace
}  // namespace plumbline::geometry_test
