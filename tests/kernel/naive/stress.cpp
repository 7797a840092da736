// Strains and stresses, what they store and what they take from the grid.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/kernel/naive/step.hpp"

namespace plumbline {
namespace {

using Vec = NaiveStep::Vec;
using Mat = NaiveStep::Mat;

}  // namespace

const std::vector<Vec>& NaiveStep::straining_velocity(Of which) const {
  std::vector<Vec>& straining = straining_[static_cast<std::size_t>(which)];
  if (straining.empty()) {
    for (const NaiveNode& i : nodes_) {
      straining.push_back(which == Of::start    ? i.start
                          : which == Of::end    ? i.end
                          : which == Of::middle ? i.middle
                                                : i.again);
    }
    straining = sharpened(straining);
    corrections_[static_cast<std::size_t>(which)].clear();
    std::vector<Vec>& faces = faces_[static_cast<std::size_t>(which)];
    faces.assign(at_nodes() ? nodes_.size() : 0, Vec::Zero());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (int d = 0; d < dim_; ++d) faces[i][d] = face_velocity(i, d, straining);
    }
  }
  return straining;
}

Mat NaiveStep::gradient_of_velocity(std::size_t p, Of which) const {
  Mat l = Mat::Zero();
  const std::vector<Vec>& straining = straining_velocity(which);
  if (at_nodes()) {
    l(0, 0) = divergence(p, which);  // of which stress and viscosity see the trace alone
    return l;
  }
  for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec& g) {
    const Vec& v = straining[static_cast<std::size_t>(&i - nodes_.data())];
    l += v * g.transpose();
    if (rings()) l(2, 2) += n * v[0] / at_[p][0];
  });
  if (corrects() && !even_share_.empty()) l(0, 0) += correction(p, which);  // stress and viscosity see the trace alone
  return l;
}

Mat NaiveStep::strain_rate(std::size_t p, Of which) const {
  const Mat l = gradient_of_velocity(p, which);
  return (l + l.transpose()) / 2;  // [York 3.23]
}

Vec NaiveStep::velocity_at(std::size_t p, Of which) const {
  Vec v = Vec::Zero();
  const std::vector<Vec>& straining = straining_velocity(which);
  for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec&) {
    v += n * straining[static_cast<std::size_t>(&i - nodes_.data())];
  });
  return v;
}

double NaiveStep::power_of(std::size_t p, Of which) const {
  if (segments_) return -points[p].pull.dot(velocity_at(p, which));
  return points[p].volume * points[p].stress.cwiseProduct(gradient_of_velocity(p, which)).sum();
}

double NaiveStep::stretch(std::size_t p) const {
  if (!starts_segment(p)) return 0;
  return (points[(p + 1) % points.size()].x - points[p].x).norm() / points[p].rest - 1;
}

double NaiveStep::stored_energy(std::size_t p) const {
  const NaivePoint& point = points[p];
  if (membrane_)
    return wrinkled(point.strain) ? 0 : point.volume * membrane_->modulus() * point.strain * point.strain / 2;
  const double own = own_dilatation(point.f, point.eps);
  const double bulk = (lambda_own() * own * own + lambda_shared() * point.theta * point.theta) / 2;  // [Dilatation 3]
  if (hooke_) return point.volume * (constants().mu * point.eps.squaredNorm() + bulk);
  if (neo_) {
    const double w = constants().mu / 2 * (point.f.squaredNorm() - 3 - 2 * own) + bulk;
    return point.m / neo_->density * w;
  }
  if (!starts_segment(p) || (segments_->one_way && point.strain <= 0)) return 0;
  return segments_->section * segments_->youngs_modulus * point.rest * point.strain * point.strain / 2;
}

LameConstants NaiveStep::constants() const {
  if (neo_) return lame_constants(neo_->youngs_modulus, neo_->poissons_ratio);
  if (!hooke_) return {0, 0};
  LameConstants c = lame_constants(hooke_->youngs_modulus, hooke_->poissons_ratio);
  if (dim_ == 2 && !rings() && hooke_->plane_stress) c.lambda = 2 * c.lambda * c.mu / (c.lambda + 2 * c.mu);
  if (dim_ == 1) c = {0, hooke_->youngs_modulus / 2};
  return c;
}

double NaiveStep::own_dilatation(const Mat& f, const Mat& eps) const {
  return neo_ ? std::log(f.determinant()) : hooke_ ? eps.trace() : 0;
}

double NaiveStep::lambda_shared() const {
  return scene_.mean_dilatation ? std::max(0.0, constants().lambda - 2 * constants().mu) : 0;
}

bool NaiveStep::same_cell(std::size_t p, std::size_t q) const {
  for (int d = 0; d < dim_; ++d) {
    const double low = scene_.grid.origin[static_cast<std::size_t>(d)];
    if (std::floor((at_[p][d] - low) / h_) != std::floor((at_[q][d] - low) / h_)) return false;
  }
  return true;
}

template <class Value>
double NaiveStep::mean_about(std::size_t p, Value&& value) const {
  double mass = 0, sum = 0;
  for (std::size_t q = 0; q < points.size(); ++q) {
    if (!same_cell(p, q)) continue;
    mass += points[q].m;
    sum += points[q].m * value(q);
  }
  return sum / mass;
}

double NaiveStep::mean_rate(std::size_t p, Of which) const {  // [Dilatation 1]
  return mean_about(p, [&](std::size_t q) { return gradient_of_velocity(q, which).trace(); });
}

double NaiveStep::tension(std::size_t p, double own, double ahead, Of which) const {
  if (lambda_shared() == 0) return lambda_own() * own;
  const double rate = ahead == 0 ? 0 : mean_rate(p, which);
  return lambda_own() * own +
         lambda_shared() * (mean_about(p, [&](std::size_t q) { return points[q].theta; }) + ahead * rate);
}

void NaiveStep::set_pulls(Of which, double ahead) {
  std::vector<Vec> x;
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p].pull.setZero();
    x.push_back(points[p].x);
    if (ahead != 0) x.back() += ahead * velocity_at(p, which);
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!starts_segment(p)) continue;
    const std::size_t q = (p + 1) % points.size();
    const Vec edge = x[q] - x[p];
    const double strain = edge.norm() / points[p].rest - 1;
    if (segments_->one_way && strain <= 0) continue;
    const Vec pull = segments_->section * segments_->youngs_modulus * strain * edge.normalized();
    points[p].pull += pull;
    points[q].pull -= pull;
  }
}

void NaiveStep::strain(double dt, Of which) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    NaivePoint& point = points[p];
    const Mat l = gradient_of_velocity(p, which), e = (l + l.transpose()) / 2;
    const double power = dt * power_of(p, which);
    double stored = power;
    if (gas_) {
      point.energy += power / point.m;                                                       // [York 4.8]
      if (scene_.density == DensityMethod::continuity) point.density /= 1 + dt * e.trace();  // [York 4.7]
    } else {
      const double before = stored_energy(p), own_before = own_dilatation(point.f, point.eps);
      if (membrane_) point.strain += dt * tangent_of_[p].dot(e * tangent_of_[p]);  // [York 5.2, 5.3]
      if (hooke_) point.eps += dt * e;                                             // [Hooke 1]
      if (neo_) point.f += dt * l * point.f;                                       // [Neo-Hookean 2]
      if (segments_) point.strain = stretch(p);                                    // [Segments 1]
      if (lambda_shared() > 0) {
        point.theta += dt * mean_rate(p, which);                                                    // [Dilatation 1]
        if (neo_) point.theta += own_dilatation(point.f, point.eps) - own_before - dt * l.trace();  // [Dilatation 4]
      }
      stored = stored_energy(p) - before;
    }
    if (forces_known_) integration += power;
    if (forces_known_) constitutive += stored - power;
    stored_first_ += stored;
  }
}

void NaiveStep::strain_first(double dt) {
  forces_known_ = false;
  stored_first_ = 0;
  strain(dt, Of::start);
  set_stress(Of::start);
  double power = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    power += dt * power_of(p, Of::start);
  }
  integration += power;
  constitutive += stored_first_ - power;
}

void NaiveStep::book_work(double dt) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    integration -= dt * power_of(p, Of::middle);
  }
}

void NaiveStep::set_stress(Of which, double ahead) {
  densities();
  if (segments_) return set_pulls(which, drifted_ ? 0 : ahead);
  for (std::size_t p = 0; p < points.size(); ++p)
    points[p].stress = stress_of(p, gradient_of_velocity(p, which), ahead, which);
}

Vec NaiveStep::tangent(std::size_t p) const {
  if (dim_ == 1) return Vec(1, 0, 0);
  const std::size_t n = points.size();
  const bool open = !membrane_->closed;
  const auto angle = [&](std::size_t from) {
    const Vec d = points[(from + 1) % n].x - points[from % n].x;
    return std::atan2(d[1], d[0]);
  };
  const double before = open && p == 0 ? angle(0) : angle(p + n - 1),
               after = open && p == n - 1 ? angle(n - 2) : angle(p);
  const double turn = std::remainder(after - before, 2 * std::numbers::pi);
  return Vec(std::cos(before + turn / 2), std::sin(before + turn / 2), 0);
}

Mat NaiveStep::stress_of(std::size_t p, const Mat& l, double ahead, Of which) {
  NaivePoint& point = points[p];
  const Mat e = (l + l.transpose()) / 2;
  if (hooke_) {
    const Mat then = point.eps + ahead * e;  // [Hooke 1]
    return tension(p, then.trace(), ahead, which) * Mat::Identity() + 2 * constants().mu * then;
  }
  if (neo_) {
    const Mat then = point.f + ahead * l * point.f, inverse = then.inverse().transpose();
    const double pull = tension(p, std::log(then.determinant()), ahead, which);
    const Mat first = constants().mu * (then - inverse) + pull * inverse;  // [Neo-Hookean 1]
    point.volume = point.f.determinant() * point.m / neo_->density;
    return first * point.f.transpose() / point.f.determinant();
  }
  if (membrane_) {
    if (p == 0) {
      tangent_of_.clear();
      for (std::size_t k = 0; k < points.size(); ++k) tangent_of_.push_back(tangent(k));
    }
    const double strain = point.strain + ahead * tangent_of_[p].dot(e * tangent_of_[p]);
    const double s = wrinkled(strain) ? 0 : membrane_->youngs_modulus * strain;  // [York 5.5]
    return s * tangent_of_[p] * tangent_of_[p].transpose();
  }
  const double div = e.trace(), z = (gas_->gamma - 1) * ahead * div;
  const double energy = z < 0 ? point.energy * (1 - z) : point.energy / (1 + z);
  const double c = std::sqrt(gas_->gamma * (gas_->gamma - 1) * energy);
  point.pressure = (gas_->gamma - 1) * point.density * energy;  // [York 4.4]
  point.sound = c;
  point.closing = std::max(0.0, -div);
  const double closing = h_ * (gas_->limits_viscosity && !l.isZero(0) ? limited(p, which) : point.closing);
  const double q = point.density * (gas_->viscosity_linear * c * closing +
                                    gas_->viscosity_quadratic * closing * closing);  // [York 4.11]
  return 2 * gas_->viscosity * e -
         (2.0 / 3 * gas_->viscosity * div + point.pressure + q) * Mat::Identity();  // [York 4.1]
}

}  // namespace plumbline
