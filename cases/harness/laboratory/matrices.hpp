// Functions of dense matrices: Eigen's headers for them take seconds to compile, and are included in one source.
#pragma once

#include <Eigen/Core>

namespace plumbline {

// Of square matrices; of none, no eigenvalues.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXcd& matrix);
// The largest magnitude of the eigenvalues.
double spectral_radius(const Eigen::MatrixXd& matrix);
double spectral_radius(const Eigen::MatrixXcd& matrix);

// The shortest vector that leaves the smallest matrix x - right; pivots below `threshold` of the largest count as zero.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, double threshold);

Eigen::MatrixXd exponential(const Eigen::MatrixXd& matrix);

}  // namespace plumbline
