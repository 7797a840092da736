// Nodes, shapes and the pairs of points and nodes that meet.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tests/kernel/naive/step.hpp"

namespace plumbline {
namespace {

using Vec = NaiveStep::Vec;
using Mat = NaiveStep::Mat;

}  // namespace

void NaiveStep::make_nodes() {
  int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (int d = 0; d < dim_; ++d) {
    low[d] = -2;
    high[d] = scene_.grid.cells[static_cast<std::size_t>(d)] + 2;
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        NaiveNode node;
        const int index[3] = {i, j, k};
        for (int d = 0; d < dim_; ++d) {
          node.x[d] = scene_.grid.origin[static_cast<std::size_t>(d)] + index[d] * h_;
        }
        node.volume = (rings() ? radial_volume(node.x[0]) : h_) * std::pow(h_, dim_ - 1);
        nodes_.push_back(node);
      }
    }
  }
}

double NaiveStep::radial_volume(double centre) const {
  double sum = 0;
  for (int piece = -8; piece < 8; ++piece) {
    const double weights[5] = {7, 32, 12, 32, 7};
    for (int k = 0; k < 5; ++k) {
      const double u = piece / 4.0 + k / 16.0;
      sum += weights[k] / 90 * (h_ / 4) * spline(u, 0.25) * std::abs(centre + u * h_);
    }
  }
  return sum;
}

double NaiveStep::spline(double u, double half) const {
  const double a = std::abs(u);
  if (boxes()) {  // [GIMP 1]
    const auto until = [](double s) {
      s = std::clamp(s, -1.0, 1.0);
      return s < 0 ? (1 + s) * (1 + s) / 2 : 1 - (1 - s) * (1 - s) / 2;
    };
    return (until(u + half) - until(u - half)) / (2 * half);
  }
  if (domains()) {  // of the volumes of nodes: a domain of this half edge along the axis
    return 0.5 * (std::max(0.0, 1 - std::abs(u - half)) + std::max(0.0, 1 - std::abs(u + half)));
  }
  if (linear_) return std::max(0.0, 1 - a);
  if (quadratic_) return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
  return a < 1 ? 2.0 / 3 - a * a + a * a * a / 2 : a < 2 ? (2 - a) * (2 - a) * (2 - a) / 6 : 0;
}

double NaiveStep::slope(double u, double half) const {
  const double a = std::abs(u), sign = u < 0 ? -1 : 1;
  if (boxes()) {  // [GIMP 1]
    const auto tent = [](double s) { return std::max(0.0, 1 - std::abs(s)); };
    return (tent(u + half) - tent(u - half)) / (2 * half);
  }
  if (linear_) return a < 1 ? -sign : 0;
  if (quadratic_) return a < 0.5 ? -2 * u : a < 1.5 ? -sign * (1.5 - a) : 0;
  return a < 1 ? -2 * u + 1.5 * a * u : a < 2 ? -sign * 0.5 * (2 - a) * (2 - a) : 0;
}

template <class Visit>
void NaiveStep::for_corners(const NaivePoint& p, const NaiveNode& node, Visit&& visit) const {
  const int corners = 1 << dim_;
  Mat edges = Mat::Identity();
  edges.topLeftCorner(dim_, dim_) = h_ * p.edges.topLeftCorner(dim_, dim_);
  const Mat duals = edges.inverse();  // row by row
  for (int c = 0; c < corners; ++c) {
    Vec corner = p.x, slope = Vec::Zero();
    for (int k = 0; k < dim_; ++k) {
      const double sign = (c >> k) % 2 == 1 ? 1 : -1;
      corner += sign * edges.col(k);
      slope += sign * duals.row(k).transpose();
    }
    double share = 1.0 / corners;
    for (int d = 0; d < dim_; ++d) share *= std::max(0.0, 1 - std::abs(corner[d] - node.x[d]) / h_);
    visit(share, slope);
  }
}

double NaiveStep::weight(const NaivePoint& p, const NaiveNode& node) const {
  if (domains()) {
    double sum = 0;
    for_corners(p, node, [&](double share, const Vec&) { sum += share; });
    return sum;
  }
  double n = 1;
  for (int d = 0; d < dim_; ++d) n *= spline((p.x[d] - node.x[d]) / h_, p.half[d]);
  return n;
}

Vec NaiveStep::gradient(const NaivePoint& p, const NaiveNode& node) const {
  Vec g = Vec::Zero();
  if (domains()) {
    for_corners(p, node, [&](double share, const Vec& slope) { g += share * slope; });
    return g;
  }
  for (int d = 0; d < dim_; ++d) {
    g[d] = slope((p.x[d] - node.x[d]) / h_, p.half[d]) / h_;
    for (int e = 0; e < dim_; ++e) g[d] *= e == d ? 1 : spline((p.x[e] - node.x[e]) / h_, p.half[e]);
  }
  return g;
}

Mat NaiveStep::inertia(const NaivePoint& p) const {
  Mat d = Mat::Zero();
  for (const NaiveNode& node : nodes_) {
    if (!apart(p.x, node)) d += weight(p, node) * (node.x - p.x) * (node.x - p.x).transpose();
  }
  return d;
}

void NaiveStep::deform_boxes() {
  if ((scene_.shape != "contiguous-gimp" && !domains()) || !neo_) return;
  for (NaivePoint& p : points) {
    const Mat moments = p.half_at_start.cwiseAbs2().asDiagonal();
    const double before = (p.c * inertia(p) * p.c.transpose()).trace();
    p.half = Mat(p.f * moments * p.f.transpose()).diagonal().cwiseSqrt().cwiseMin(0.5);
    p.edges = p.f * p.half_at_start.asDiagonal();
    transfer += p.m * ((p.c * inertia(p) * p.c.transpose()).trace() - before) / 2;
  }
}

void NaiveStep::locate() {
  deform_boxes();
  pairs_.clear();
  first_pair_.assign(1, 0);
  at_.clear();
  for (std::size_t p = 0; p < points.size(); ++p) {
    at_.push_back(points[p].x);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (apart(points[p].x, nodes_[i])) continue;
      const Pair pair{p, i, weight(points[p], nodes_[i]), gradient(points[p], nodes_[i])};
      if (pair.n != 0 || !pair.g.isZero(0)) pairs_.push_back(pair);
    }
    first_pair_.push_back(pairs_.size());
  }
}

std::optional<std::size_t> NaiveStep::beside(std::size_t i, int d, int side) const {
  int stride = 1;
  for (int e = 0; e < d; ++e) stride *= scene_.grid.cells[static_cast<std::size_t>(e)] + 5;  // see make_nodes()
  const auto j = static_cast<std::size_t>(static_cast<int>(i) + side * stride);
  const double away = std::abs(side) * h_;
  const bool there = j < nodes_.size() && std::abs((nodes_[j].x - nodes_[i].x).norm() - away) < 0.1 * h_;
  return there ? std::optional(j) : std::nullopt;
}

}  // namespace plumbline
