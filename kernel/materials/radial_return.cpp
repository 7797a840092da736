#include "kernel/materials/radial_return.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

using Matrix = Eigen::Matrix3d;
using Solver = Eigen::SelfAdjointEigenSolver<Matrix>;

// sum_k f(value_k) n_k n_k^T; of a diagonal matrix without any vectors.
template <class Function>
Matrix function_of(const Matrix& symmetric, const Function& f) {
  if (symmetric(1, 0) == 0 && symmetric(2, 0) == 0 && symmetric(2, 1) == 0) {
    return symmetric.diagonal().unaryExpr(f).asDiagonal();
  }
  const Solver principal(symmetric);
  return principal.eigenvectors() * principal.eigenvalues().unaryExpr(f).asDiagonal() *
         principal.eigenvectors().transpose();
}

Matrix deviator(const Matrix& m) { return m - m.trace() / 3 * Matrix::Identity(); }

// q of a deviatoric elastic strain.
double equivalent(const J2Law& law, const Matrix& deviatoric) {
  return std::sqrt(6.0) * law.shear * deviatoric.norm();  // [J2 2]
}

}  // namespace

double elastic_energy(const J2Law& law, const Matrix& elastic) {
  const double trace = elastic.trace();
  return 0.5 * law.bulk * trace * trace + law.shear * deviator(elastic).squaredNorm();  // [J2 1]
}

Matrix kirchhoff_stress(const J2Law& law, const Matrix& elastic) {
  return law.bulk * elastic.trace() * Matrix::Identity() + 2 * law.shear * deviator(elastic);  // [J2 1]
}

double equivalent_stress(const J2Law& law, const Matrix& elastic) { return equivalent(law, deviator(elastic)); }

Matrix strained(const Matrix& elastic, const Matrix& increment) {
  const Matrix beyond = function_of(elastic, [](double e) { return std::expm1(2 * e); });  // b_e - 1
  const Matrix half = increment + increment * beyond;
  const Matrix then = beyond + half + half.transpose() + increment * increment.transpose() +
                      increment * beyond * increment.transpose();
  const Matrix symmetric = 0.5 * (then + then.transpose());
  return function_of(symmetric, [](double b) { return 0.5 * std::log1p(b); });  // [J2 3]
}

J2State returned(const J2Law& law, const J2State& trial) {
  const Matrix deviatoric = deviator(trial.elastic);
  const double q = equivalent(law, deviatoric), beyond = q - yield_stress(law, trial.plastic);
  if (!(beyond > 0)) return trial;
  const double flow = beyond / (3 * law.shear + law.hardening);
  return {trial.elastic - 3 * law.shear * flow / q * deviatoric, trial.plastic + flow};  // [J2 4]
}

// The rate of (1/2) ln b for db/dt = L b + b L^T: in the principal axes of b component by component, times the slope of the
// logarithm between two principal values; then the flow that keeps q at the yield stress.
J2State rate_of(const J2Law& law, const J2State& state, const Matrix& gradient) {
  constexpr double on_surface = 1e-9;  // of the yield stress: a return ends there but for roundings
  const Solver principal(state.elastic);
  const Matrix& axes = principal.eigenvectors();
  const Matrix turned = axes.transpose() * gradient * axes;
  Matrix rate;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double a = principal.eigenvalues()[i], b = principal.eigenvalues()[j], x = a - b;
      const double slope = std::abs(x) < 1e-6 ? 0.5 * (1 - x * x / 6) : 0.5 * x / std::sinh(x);
      rate(i, j) = (turned(i, j) * std::exp(b - a) + turned(j, i) * std::exp(a - b)) * slope;
    }
  }
  J2State all{axes * rate * axes.transpose(), 0};
  const Matrix deviatoric = deviator(state.elastic);
  const double q = equivalent(law, deviatoric);
  if (q < (1 - on_surface) * yield_stress(law, state.plastic)) return all;
  const double rise = 6 * law.shear * law.shear * deviatoric.cwiseProduct(all.elastic).sum() / q;  // of q, without flow
  if (!(rise > 0)) return all;
  all.plastic = rise / (3 * law.shear + law.hardening);
  all.elastic -= 3 * law.shear * all.plastic / q * deviatoric;
  return all;
}

}  // namespace plumbline
