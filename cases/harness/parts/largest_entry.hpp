#pragma once

#include <Eigen/Core>
#include <limits>

namespace plumbline {

// The largest absolute value of a matrix's entries; NaN if one of them is.
inline double largest_entry(const Eigen::MatrixXd& all) {
  return all.hasNaN() ? std::numeric_limits<double>::quiet_NaN() : all.cwiseAbs().maxCoeff();
}

}  // namespace plumbline
