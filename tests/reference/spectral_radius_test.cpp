// Eigenvalues of matrices that are known, and the bounds, at good and at defective ones.
#include "reference/spectral_radius.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumbline::reference::spectral_radius_test {
namespace {

TEST(SpectralRadius, OfATurnAndAStretch) {
  SquareMatrix matrix(3);
  const double stretch = 1.25, angle = 0.7;
  matrix(0, 0) = matrix(1, 1) = stretch * std::cos(angle);
  matrix(1, 0) = stretch * std::sin(angle);
  matrix(0, 1) = -stretch * std::sin(angle);
  matrix(2, 2) = -0.5;
  const Bounded radius = spectral_radius(matrix);
  EXPECT_NEAR(radius.value, stretch, radius.bound);
  EXPECT_LE(radius.bound, 1e-12);
  auto values = eigenvalues(matrix);
  auto by_real = [](auto a, auto b) { return a.real() < b.real(); };
  EXPECT_NEAR(std::min_element(values.begin(), values.end(), by_real)->real(), -0.5, 1e-14);
}

TEST(SpectralRadius, AnUnevenMatrixOfKnownRoots) {  // the companion of (z - 3)(z + 2)(z - 1)(z^2 + 1)
  SquareMatrix companion(5);
  const double last[] = {-6, 5, -4, 4, 2};  // z^5 = 2 z^4 + 4 z^3 - 4 z^2 + 5 z - 6
  for (int i = 0; i < 5; ++i) {
    companion(i, 4) = last[i];
    if (i > 0) companion(i, i - 1) = 1;
  }
  const Bounded radius = spectral_radius(companion);
  EXPECT_NEAR(radius.value, 3, radius.bound);
  EXPECT_LE(radius.bound, 1e-9);
}

TEST(SpectralRadius, ADefectiveMatrixHasAWideBoundThatHolds) {
  SquareMatrix block(3);  // a triple root 0.8 of one eigenvector: rounding 1e-16 moves it by 1e-5
  for (int i = 0; i < 3; ++i) {
    block(i, i) = 0.8;
    if (i > 0) block(i - 1, i) = 1;
  }
  SquareMatrix sheared = block;  // similar by a matrix that leaves no zeros, so that rounding is met
  const double shear[3][3] = {{1, 0, 0}, {0.3, 1, 0}, {-0.7, 0.45, 1}},
               back[3][3] = {{1, 0, 0}, {-0.3, 1, 0}, {0.835, -0.45, 1}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      sheared(i, j) = 0;
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) sheared(i, j) += shear[i][k] * block(k, l) * back[l][j];
      }
    }
  }
  const Bounded radius = spectral_radius(sheared);
  EXPECT_NEAR(radius.value, 0.8, radius.bound);
  EXPECT_GE(radius.bound, 1e-6);
  EXPECT_LE(radius.bound, 1e-3);
}

TEST(SpectralRadius, EigenvectorsThatSayNothingLeaveElsnersBound) {  // the companion of (z - 1)^6
  SquareMatrix companion(6);
  const double last[] = {-1, 6, -15, 20, -15, 6};
  for (int i = 0; i < 6; ++i) {
    companion(i, 5) = last[i];
    if (i > 0) companion(i, i - 1) = 1;
  }
  const Bounded radius = spectral_radius(companion);  // the sixth root of a rounding is 2e-3
  EXPECT_NEAR(radius.value, 1, radius.bound);
  EXPECT_GE(radius.bound, 2e-3);
  EXPECT_LE(radius.bound, 1);
}

// What entries known to a share e of the norm N = |A|_F leave open. Eigenvectors of unit length that stand square to each
// other: |V|_F = |V^-1|_F = sqrt(n) and a residual of at most e N |V|_F; the discs of Bauer and Fike have a radius of e n
// N, and all n in a row reach 2 n - 1 of them. Where no eigenvectors are left it is Elsner's (2 N)^(1 - 1/n) (e N)^(1/n).
TEST(SpectralRadius, BoundOfEntriesThatAreKnownRoughly) {
  const double e = 1e-7;
  SquareMatrix square(4);
  for (int i = 0; i < 4; ++i) square(i, i) = 0.2 + i;
  square(0, 1) = square(1, 0) = 0.7;
  double norm = 0;
  for (double entry : square.entries) norm = std::hypot(norm, entry);
  EXPECT_NEAR(spectral_radius(square, e).bound, 7 * 4 * e * norm, 1e-4 * e * norm);
  for (int n : {2, 3, 5}) {  // a root of 0.8 with one eigenvector; 2 N + e N by 1 + n e at most
    SquareMatrix block(n);
    for (int i = 0; i < n; ++i) {
      block(i, i) = 0.8;
      if (i > 0) block(i - 1, i) = 1;
    }
    const double size = std::sqrt(0.64 * n + n - 1), elsner = std::pow(2, 1 - 1.0 / n) * std::pow(e, 1.0 / n) * size;
    EXPECT_NEAR(spectral_radius(block, e).bound, elsner, 1e-5 * elsner) << n;
  }
}

TEST(SpectralRadius, OfAComplexMatrix) {  // ((2i, 1), (0, 1 - i)): triangular
  ComplexMatrix matrix(2);
  matrix(0, 0) = {0, 2};
  matrix(0, 1) = 1;
  matrix(1, 1) = {1, -1};
  const Bounded radius = spectral_radius(matrix);
  EXPECT_NEAR(radius.value, 2, radius.bound);
  EXPECT_LE(radius.bound, 1e-12);
}

TEST(SpectralRadius, NumbersThatAreNotFiniteAreRefused) {
  SquareMatrix matrix(2);
  matrix(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(eigenvalues(matrix), std::invalid_argument);
  EXPECT_THROW(spectral_radius(matrix), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::reference::spectral_radius_test
