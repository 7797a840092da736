#include "kernel/contact/separation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double penalty = 1e-4;  // lambda
// Newton's steps end where one would change the function by less than rounding; from zero they are fewer than ten.
constexpr double settled_plane = 1e-14;
constexpr int most_steps = 50;

// A point as the fit sees it: (xi, 1), with the sign of its side, and its share of that side's weights.
template <int dim>
struct Sample {
  Eigen::Matrix<double, dim + 1, 1> signed_place;
  double share;
};

template <int dim>
bool add_samples(const std::vector<Eigen::Matrix<double, dim, 1>>& cloud, double sign, double reach,
                 std::vector<Sample<dim>>& samples) {
  const std::size_t before = samples.size();
  double sum = 0;
  for (const auto& xi : cloud) {
    double weight = 1;
    for (int d = 0; d < dim; ++d) {
      const double inside = std::max(0.0, 1 - xi[d] * xi[d] / (reach * reach));
      weight *= inside * inside;
    }
    if (!(weight > 0)) continue;
    Sample<dim> sample{.signed_place = {}, .share = weight};
    sample.signed_place << sign * xi, sign;
    samples.push_back(sample);
    sum += weight;
  }
  for (std::size_t k = before; k < samples.size(); ++k) samples[k].share /= sum;
  return samples.size() > before;
}

// The function at a plane (a, b), with its slope and curvature.
template <int dim>
struct Fit {
  using Plane = Eigen::Matrix<double, dim + 1, 1>;
  double value = 0;
  Plane slope = Plane::Zero();
  Eigen::Matrix<double, dim + 1, dim + 1> curvature = Eigen::Matrix<double, dim + 1, dim + 1>::Zero();

  Fit(const std::vector<Sample<dim>>& samples, const Plane& plane) {
    for (int d = 0; d < dim; ++d) {
      value += 0.5 * penalty * plane[d] * plane[d];
      slope[d] = penalty * plane[d];
      curvature(d, d) = penalty;
    }
    for (const Sample<dim>& s : samples) {
      const double z = plane.dot(s.signed_place), decay = std::exp(-std::abs(z));
      const double wrong = (z > 0 ? decay : 1) / (1 + decay);  // probability of the other side
      value += s.share * (std::log1p(decay) + (z > 0 ? 0 : -z));
      slope -= s.share * wrong * s.signed_place;
      curvature += s.share * wrong * (1 - wrong) * s.signed_place * s.signed_place.transpose();
    }
  }
};

}  // namespace

template <int dim>
Eigen::Matrix<double, dim, 1> separating_direction(const Clouds<dim>& clouds, double reach) {
  std::vector<Sample<dim>> samples;
  samples.reserve(clouds.first.size() + clouds.second.size());
  const bool first = add_samples<dim>(clouds.first, -1, reach, samples);
  if (!add_samples<dim>(clouds.second, 1, reach, samples) || !first) return Eigen::Matrix<double, dim, 1>::Zero();
  typename Fit<dim>::Plane plane = Fit<dim>::Plane::Zero();
  Fit<dim> fit(samples, plane);
  for (int k = 0; k < most_steps; ++k) {
    const typename Fit<dim>::Plane step = fit.curvature.ldlt().solve(-fit.slope);
    if (-step.dot(fit.slope) <= settled_plane * fit.value) break;
    double part = 1;
    Fit<dim> next(samples, plane + step);
    while (next.value > fit.value && part > settled_plane) next = Fit<dim>(samples, plane + (part *= 0.5) * step);
    plane += part * step;
    fit = next;
  }
  const Eigen::Matrix<double, dim, 1> across = plane.template head<dim>();
  return across.norm() > 0 ? across.normalized() : across;
}

template Eigen::Matrix<double, 1, 1> separating_direction<1>(const Clouds<1>&, double);
template Eigen::Matrix<double, 2, 1> separating_direction<2>(const Clouds<2>&, double);
template Eigen::Matrix<double, 3, 1> separating_direction<3>(const Clouds<3>&, double);

}  // namespace plumbline
