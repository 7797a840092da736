#include "cases/harness/parts/material_waves.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cases/harness/parts/parts.hpp"

namespace plumbline {
namespace {

constexpr double small_strain = 1e-3;

// The acoustic tensor of waves along n, m^2/s^2: Q a is the change of the stress on n under the gradient a n^T. (The traction on a
// material surface changes by that alone.)
Eigen::MatrixXd acoustic_tensor(const MaterialProbe& probe, const Eigen::VectorXd& n, int p) {
  Eigen::MatrixXd q(probe.dim(), probe.dim());
  for (int d = 0; d < probe.dim(); ++d) {
    const Straining rate{Eigen::VectorXd::Unit(probe.dim(), d) * n.transpose(), 0};
    const Eigen::MatrixXd change = probe.strained(rate, step_of_difference).stress(p) -
                                   probe.strained(rate, -step_of_difference).stress(p);
    q.col(d) = change * n / (2 * step_of_difference * probe.density(p));
  }
  return 0.5 * (q + q.transpose());
}

// Of plane waves in any direction, m/s: from each axis the direction is turned to that of the fastest wave's motion.
double fastest_wave(const MaterialProbe& probe, int p) {
  double largest = 0;
  for (int d = 0; d < probe.dim(); ++d) {
    Eigen::VectorXd n = Eigen::VectorXd::Unit(probe.dim(), d) + Eigen::VectorXd::Constant(probe.dim(), 0.1);
    for (int k = 0; k < 4; ++k) {
      n.normalize();
      const Eigen::MatrixXd q = acoustic_tensor(probe, n, p);
      Eigen::Matrix3d whole = -q.norm() * Eigen::Matrix3d::Identity();  // no eigenvalue of q is less
      whole.topLeftCorner(q.rows(), q.cols()) = q;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> waves(whole);
      largest = std::max(largest, waves.eigenvalues()[2]);
      n = waves.eigenvectors().col(2).head(q.rows());
    }
  }
  return std::sqrt(largest);
}

// Of points at rest: the step's speed over that of the fastest wave, less 1. The least and the most of all points.
std::pair<double, double> speed_ratios(const MaterialProbe& probe) {
  std::pair<double, double> found{std::numeric_limits<double>::infinity(), 0};
  for (int p = 0; p < probe.count(); ++p) {
    const double ratio = probe.fastest(p) / fastest_wave(probe, p) - 1;
    found = {std::min(found.first, ratio), worse(ratio, found.second)};
  }
  return found;
}

double off_speed(const MaterialSubject& subject, std::size_t geometry, bool above) {
  double worst = -1;
  for (const auto& material : subject.made) {
    MaterialProbe probe(material, geometry, subject.density);
    probe = probe.strained({Eigen::MatrixXd::Identity(probe.dim(), probe.dim()), 0}, small_strain);
    const auto [least, most] = speed_ratios(probe);
    worst = worse(above ? most : -least, worst);
  }
  return worst;
}
}  // namespace

double too_slow(const MaterialSubject& subject, std::size_t geometry) { return off_speed(subject, geometry, false); }
double too_fast(const MaterialSubject& subject, std::size_t geometry) { return off_speed(subject, geometry, true); }

double overtaken(const MaterialProbe& probe, ProbeRandom&) { return -speed_ratios(probe).first; }

double off_motion(const MaterialProbe& probe, ProbeRandom& random) {
  MaterialProbe moving = probe;
  double worst = 0;
  for (int p = 0; p < probe.count(); ++p) {
    double square = 0;
    for (int d = 0; d < probe.dim(); ++d) {
      const double v = random(-1, 1);
      moving.points()(column::velocity, d)[p] = v;
      square += v * v;
    }
    worst = worse(std::abs(moving.fastest(p) - probe.fastest(p) - std::sqrt(square)) / probe.fastest(p), worst);
  }
  return worst;
}

}  // namespace plumbline
