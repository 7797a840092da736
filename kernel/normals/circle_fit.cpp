#include "kernel/normals/circle_fit.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/normals/directions.hpp"

namespace plumbline {
namespace {

// Closer than this, in units of the reach, points are one point: an image in a wall that the point stands on.
constexpr double same_place = 1e-10;
// Where a circle through the points leaves them less spread than this share of their own, any circle does: two points.
constexpr double any_circle = 1e-12;

}  // namespace

// M and the eigenvector of its smaller eigenvalue. [Circle 2]
auto CircleFit::fit(const Moments& m) -> Circle {
  double uu = m.uu, uv = m.uv, vv = m.vv;
  bool straight = true;
  if (m.zz > 0) {
    uu -= m.zu * m.zu / m.zz;
    uv -= m.zu * m.zv / m.zz;
    vv -= m.zv * m.zv / m.zz;
    straight = uu + vv <= any_circle * (m.uu + m.vv);
    if (straight) uu = m.uu, uv = m.uv, vv = m.vv;
  }
  // Cosine and sine of twice the angle of the larger eigenvalue's vector: half the angle, the larger of both first.
  const double c = uu - vv, s = 2 * uv, length = std::sqrt(c * c + s * s);
  if (!(length > 0)) return {0, 0, 0};
  double tx = std::sqrt(0.5 * (1 + std::abs(c) / length)), ty = 0.5 * s / (length * tx);
  if (c < 0) std::swap(tx, ty);
  Circle circle{-ty, tx, 0};
  if (!straight) circle.bend = -(m.zu * circle.normal_x + m.zv * circle.normal_y) / m.zz;
  return circle;
}

void CircleFit::gather(double x, double y, double reach) {
  const GridSpec& grid = points_.grid();
  const int rings = static_cast<int>(std::ceil(reach / grid.h));
  const int i = points_.cell(x, 0), j = points_.cell(y, 1);
  const double inverse = 1 / reach;
  count_ = 0;
  near_count_ = 0;
  for (int row = j - rings; row <= j + rings; ++row) {
    const auto [first, last] = points_.row(i - rings, i + rings, row);
    for (int k = first; k < last; ++k) {
      const double u = (points_.x()[static_cast<std::size_t>(k)] - x) * inverse;
      const double v = (points_.y()[static_cast<std::size_t>(k)] - y) * inverse, z = u * u + v * v;
      if (z >= 1) continue;
      u_[count_] = u;
      v_[count_] = v;
      z_[count_] = z;
      ++count_;
      if (z < same_place * same_place || (near_count_ == nearest && z >= near_z_[nearest - 1])) continue;
      auto at = static_cast<std::size_t>(std::min(near_count_, nearest - 1));
      for (; at > 0 && near_z_[at - 1] > z; --at) {
        near_z_[at] = near_z_[at - 1];
        near_[at] = near_[at - 1];
      }
      near_z_[at] = z;
      near_[at] = count_ - 1;
      near_count_ = std::min(near_count_ + 1, nearest);
    }
  }
}

// Through p: without means, D = 0. Weights vanish at the fifth point, so that nothing jumps when another becomes the
// fifth.
auto CircleFit::first_circle() const -> Circle {
  const auto count = static_cast<std::size_t>(near_count_);
  const double edge = near_count_ == nearest ? near_z_[count - 1] : 2 * near_z_[count - 1];
  Moments m;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t q = near_[k];
    const double fade = 1 - z_[q] / edge, w = fade * fade;
    m.zz += w * z_[q] * z_[q];
    m.zu += w * z_[q] * u_[q];
    m.zv += w * z_[q] * v_[q];
    m.uu += w * u_[q] * u_[q];
    m.uv += w * u_[q] * v_[q];
    m.vv += w * v_[q] * v_[q];
  }
  return fit(m);
}

auto CircleFit::second_circle(const Circle& first) const -> Circle {
  const double spread = near_z_[static_cast<std::size_t>(near_count_ - 1)], per_spread = 1 / spread;
  const double trust = per_spread / (trusted * trusted);
  const double edge = near_count_ == nearest ? std::max(1.0, per_spread / (widest * widest)) : 1.0;  // 1/b^2
  double sum = 0, z = 0, u = 0, v = 0;
  Moments m;
  for (std::size_t q = 0; q < count_; ++q) {
    const double off = first.bend * z_[q] + first.normal_x * u_[q] + first.normal_y * v_[q];
    const double doubt = 1 + off * off * trust / (1 + z_[q] * per_spread),
                 fade = std::max(0.0, 1 - z_[q] * edge) / doubt;
    const double w = fade * fade;  // [Circle 3]
    sum += w;
    z += w * z_[q];
    u += w * u_[q];
    v += w * v_[q];
    m.zz += w * z_[q] * z_[q];
    m.zu += w * z_[q] * u_[q];
    m.zv += w * z_[q] * v_[q];
    m.uu += w * u_[q] * u_[q];
    m.uv += w * u_[q] * v_[q];
    m.vv += w * v_[q] * v_[q];
  }
  m.zz -= z * z / sum;
  m.zu -= z * u / sum;
  m.zv -= z * v / sum;
  m.uu -= u * u / sum;
  m.uv -= u * v / sum;
  m.vv -= v * v / sum;
  return fit(m);  // [Circle 1]
}

void CircleFit::find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) {
  points_.sort(input.grid, input.x, input.y);
  for (std::vector<double>* column : {&u_, &v_, &z_}) column->resize(points_.x().size());
  const double whole = input.grid.h * std::max(input.grid.cells[0], input.grid.cells[1]);
  for (std::size_t p = 0; p < input.x.size(); ++p) {
    double reach = input.grid.h;
    gather(input.x[p], input.y[p], reach);
    while (near_count_ < 2 && reach < 2 * whole) {
      reach *= 2;
      gather(input.x[p], input.y[p], reach);
    }
    Circle circle{0, 0, 0};
    if (near_count_ > 0) circle = second_circle(first_circle());
    set_normal(input, p, circle.normal_x, circle.normal_y, normal_x, normal_y);
  }
}

}  // namespace plumbline
