#include "cases/harness/laboratory/matrices.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <unsupported/Eigen/MatrixFunctions>

namespace plumbline {

// As complex ones: a solver of their own would add half as much again to the time that this source takes to compile.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) { return eigenvalues(Eigen::MatrixXcd(matrix)); }
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXcd& matrix) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(matrix, false).eigenvalues();
}

double spectral_radius(const Eigen::MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }
double spectral_radius(const Eigen::MatrixXcd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(threshold);
  solver.compute(matrix);
  return solver.solve(right);
}

Eigen::MatrixXd exponential(const Eigen::MatrixXd& matrix) { return matrix.exp(); }

}  // namespace plumbline
