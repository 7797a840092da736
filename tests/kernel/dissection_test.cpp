// Cholesky factors by nested dissection: against dense ones and against a right side of a known solution.
#include "kernel/dissection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <stdexcept>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline::dissection_test {
namespace {

struct System {
  std::vector<Eigen::Vector3d> places;
  Eigen::SparseMatrix<double> matrix;
};

// Unknowns at random on a sphere that couple where they are closer than the reach, by B^T B with B at random and 1 on the diagonal.
System on_sphere(int unknowns, double reach) {
  scenes::Random random(7);
  System made;
  while (static_cast<int>(made.places.size()) < unknowns) {
    const Eigen::Vector3d place(random(-1, 1), random(-1, 1), random(-1, 1));
    if (place.norm() > 0.1) made.places.push_back(place.normalized());
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < unknowns; ++i) {
    entries.emplace_back(i, i, 1.0);
    for (int j = 0; j < unknowns; ++j) {
      const double apart = (made.places[static_cast<std::size_t>(i)] - made.places[static_cast<std::size_t>(j)]).norm();
      if (i != j && apart < reach) entries.emplace_back(i, j, random(-0.2, 0.2));
    }
  }
  Eigen::SparseMatrix<double> root(unknowns, unknowns);
  root.setFromTriplets(entries.begin(), entries.end());
  made.matrix = Eigen::SparseMatrix<double>(root.transpose() * root);
  return made;
}

Eigen::VectorXd wave(int size) {
  Eigen::VectorXd all(size);
  for (int k = 0; k < size; ++k) all[k] = std::sin(0.7 * k) + 0.1;
  return all;
}

// Below the size that is halved, at one halving, and at several.
TEST(Dissection, SolvesWhatADenseFactorSolves) {
  for (const int unknowns : {1, 150, 301, 2000}) {
    SCOPED_TRACE(unknowns);
    const System system = on_sphere(unknowns, 0.15);
    const Eigen::VectorXd right = wave(unknowns);
    const Eigen::LLT<Eigen::MatrixXd> dense{Eigen::MatrixXd(system.matrix)};
    const Eigen::VectorXd expected = dense.solve(right);
    const double rounding = 1e-16 * unknowns / dense.rcond();
    const Eigen::VectorXd found = DissectedCholesky(system.matrix, system.places).solve(right);
    EXPECT_LE((found - expected).norm(), rounding * expected.norm());
  }
}

// Halves that do not couple, and unknowns that stand at one place.
TEST(Dissection, TakesPartsWithoutConnection) {
  System system = on_sphere(600, 1e-9);
  const Eigen::VectorXd solution = wave(600);
  EXPECT_EQ(DissectedCholesky(system.matrix, system.places).solve(system.matrix * solution), solution);
  system = on_sphere(600, 0.2);
  std::fill(system.places.begin(), system.places.end(), Eigen::Vector3d::Zero());
  const Eigen::VectorXd found = DissectedCholesky(system.matrix, system.places).solve(system.matrix * solution);
  EXPECT_LE((found - solution).norm(), 1e-9 * solution.norm());
}

TEST(Dissection, RefusesWhatHasNoFactor) {
  const System system = on_sphere(300, 0.2);
  EXPECT_THROW(DissectedCholesky(-system.matrix, system.places), std::invalid_argument);
  EXPECT_THROW(DissectedCholesky(system.matrix, {}), std::invalid_argument);
  const DissectedCholesky factors(system.matrix, system.places);
  EXPECT_THROW(factors.solve(wave(299)), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::dissection_test
