// Dense linear algebra of the tests by GSL: other solvers than the kernel's, and compiled in a tenth of the time of Eigen's.
#pragma once

#include <Eigen/Core>

namespace plumbline::dense {

// Of a square matrix.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);
double spectral_radius(const Eigen::MatrixXd& matrix);

// Of the symmetric part of a square matrix; values ascend, vectors are columns of length one.
struct Spectrum {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
Spectrum symmetric_spectrum(const Eigen::MatrixXd& matrix);

// x of the least norm among those that make |a x - b| least; a has no fewer rows than columns.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace plumbline::dense
