#include "tests/kernel/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plumbline::dense {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) { return matrix.eigenvalues(); }

double spectral_radius(const Eigen::MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

Spectrum symmetric_spectrum(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved((matrix + matrix.transpose()) / 2);
  return {solved.eigenvalues(), solved.eigenvectors()};
}

Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

}  // namespace plumbline::dense
