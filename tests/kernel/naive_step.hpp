// The step written straight from the printed equations, as slowly as can be: every node meets every point,
// weights come from the distance between them, and nothing is shared with the kernel but the scene it starts
// from. Free sides only. All vectors and tensors have three components: x, y, z, or r, z and the hoop direction of an
// axisymmetric scene, whose points may stand at negative radii as the mirror images of others.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {

struct NaivePoint {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero();
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero(), stress = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d eps = Eigen::Matrix3d::Zero(), f = Eigen::Matrix3d::Identity();  // of solids
  Eigen::Vector3d half = 0.5 * Eigen::Vector3d::Ones(), half_at_start = half;      // of the box, in cells
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();  // half edges of the domain, a column each, in cells
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();       // of the segments on the point
  double m = 0, volume = 0, density = 0, energy = 0, pressure = 0, strain = 0, loss = 0, exchanged = 0, rest = 0;
  double sound = 0, closing = 0;  // of the stress: c, and how fast the flow is compressed
  double theta = 0;               // the dilatation that cells share
};

struct NaiveNode {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), momentum = x, force = x;
  Eigen::Vector3d start = x, end = x, middle = x, again = x;
  double m = 0, volume = 0, heat = 0, alpha = 0, kept = 0;
};

class NaiveStep {
 public:
  using Vec = Eigen::Vector3d;
  using Mat = Eigen::Matrix3d;
  enum class Of { start, end, middle, again };

  std::vector<NaivePoint> points;
  double transfer = 0, integration = 0, constitutive = 0, body_work = 0;  // the ledger's flows of energy

  explicit NaiveStep(const Scene& scene)
      : scene_(scene),
        dim_(scene.grid.dim),
        h_(scene.grid.h),
        gas_(dynamic_cast<const IdealGas*>(scene.bodies[0].material.get())),
        membrane_(dynamic_cast<const UniaxialMembrane*>(scene.bodies[0].material.get())),
        hooke_(dynamic_cast<const LinearElastic*>(scene.bodies[0].material.get())),
        neo_(dynamic_cast<const NeoHookean*>(scene.bodies[0].material.get())),
        segments_(dynamic_cast<const SegmentMembrane*>(scene.bodies[0].material.get())) {
    const Columns& from = scene.bodies[0].points;
    points.resize(static_cast<std::size_t>(from.points()));
    for (std::size_t p = 0; p < points.size(); ++p) {
      NaivePoint& point = points[p];
      for (int d = 0; d < dim_; ++d) {
        point.x[d] = from(column::position, d)[p];
        point.v[d] = from(column::velocity, d)[p];
        gravity_[d] = scene.gravity[static_cast<std::size_t>(d)];
      }
      point.m = from(column::mass)[p];
      point.volume = from(column::volume)[p];
      if (gas_) point.density = from(column::density)[p];
      if (gas_) point.energy = from(column::energy)[p];
      if (membrane_) point.strain = from(column::strain)[p];
      if (hooke_) point.eps = strain_tensor(from, p);
      if (neo_) point.f = deformation(from, p);
      if (segments_) point.rest = from(column::rest_length)[p];
      // Boxes start as wide as the points stand apart; a ring's section has its volume over r.
      const double section = rings() ? point.volume / std::abs(point.x[0]) : point.volume;
      point.half_at_start.setConstant(std::pow(section, 1.0 / dim_) / h_ / 2);
      point.half = point.half_at_start.cwiseMin(0.5);
      point.edges = point.half.asDiagonal();
    }
    if (segments_) {
      for (std::size_t p = 0; p < points.size(); ++p) points[p].strain = stretch(p);
    }
    for (NaivePoint& point : points) point.theta = own_dilatation(point.f, point.eps);
    make_nodes();
    locate();
    densities();
    if (segments_) set_pulls(Of::start, 0);
    for (std::size_t p = 0; p < points.size() && !segments_; ++p) points[p].stress = stress_of(p, Mat::Zero());
  }

  void step(const std::string& integrator, double dt) {
    const double transfer_before = transfer;
    const bool leapfrog = integrator == "leapfrog", midpoint = integrator == "midpoint";
    drifted_ = leapfrog;
    if (leapfrog) drift(dt / 2);
    locate();
    to_grid();
    if (leapfrog) set_stress(Of::start, dt / 2);  // [Leapfrog 2]
    if (integrator == "usf") strain_first(dt);
    if (integrator == "usavg") strain_first(dt / 2);
    if (integrator == "energy") set_stress(Of::start);
    forces();
    advance(dt);
    exchange(Of::start, dt);
    if (integrator == "energy" && viscosity_would_cool()) {
      forces();
      exchange(Of::middle, dt);
      advance(dt);
    }
    if (midpoint) {
      set_stress(Of::middle, dt / 2);  // [Midpoint 2]
      forces();
      advance(dt);  // [Midpoint 3]
    }
    book_work(dt);
    move(dt, !leapfrog, midpoint);
    if (integrator == "usf") return;
    if (midpoint) {
      strain(dt, Of::middle);  // [Midpoint 4]
      set_stress(Of::middle);
      return;
    }
    if (integrator == "musl" || integrator == "usavg") again();
    if (integrator == "usl") strain(dt, Of::end);
    if (integrator == "musl") strain(dt, Of::again);
    if (integrator == "usavg") strain(dt / 2, Of::again);
    if (integrator == "energy" || leapfrog) {
      if (leapfrog) drift(dt / 2);  // [Leapfrog 3]
      strain(dt, Of::middle);
      if (segments_) return;
      if (gas_) {
        for (NaivePoint& point : points)
          point.energy += point.exchanged + point.loss / point.m;  // [EC-APIC 6] [Exchange 1]
        transfer = transfer_before;
      }
      return;
    }
    set_stress(integrator == "usl" ? Of::end : Of::again);
  }

  // Densities and pressures where the points stand now.
  void refresh() {
    densities();
    for (NaivePoint& point : points) point.pressure = (gas_->gamma - 1) * point.density * point.energy;  // [York 4.4]
  }

 private:
  friend class NaiveStages;
  struct Pair {
    std::size_t point, node;
    double n;
    Vec g;
  };

  bool rings() const { return scene_.grid.axisymmetric; }

  // Components of a column as the tensors they are: the plane's, the hoop's, those of space; shears are halved.
  Mat strain_tensor(const Columns& from, std::size_t p) const {
    static constexpr int plane[][2] = {{0, 0}, {1, 1}, {0, 1}}, hoop[][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}},
                         space[][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};
    Mat eps = Mat::Zero();
    for (int k = 0; k < from.components(column::strain); ++k) {
      const auto& [i, j] = rings() ? hoop[k] : dim_ == 3 ? space[k] : plane[k];
      eps(i, j) = eps(j, i) = from(column::strain, k)[p] * (i == j ? 1 : 0.5);
    }
    return eps;
  }
  Mat deformation(const Columns& from, std::size_t p) const {
    Mat f = Mat::Identity();
    for (int k = 0; k < dim_ * dim_; ++k) f(k / dim_, k % dim_) = from(column::deformation, k)[p];
    if (rings()) f(2, 2) = from(column::deformation, 4)[p];
    return f;
  }

  void make_nodes() {
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
  // Integral of N |r|, by Boole's rule on half cells: exact for these pieces of degree four. The axis, if there is one,
  // is a node line.
  double radial_volume(double centre) const {
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
  bool boxes() const { return boxes_; }
  bool domains() const { return domains_; }
  // half: of the boxes, in cells.
  double spline(double u, double half) const {
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
  double slope(double u, double half) const {
    const double a = std::abs(u), sign = u < 0 ? -1 : 1;
    if (boxes()) {  // [GIMP 1]
      const auto tent = [](double s) { return std::max(0.0, 1 - std::abs(s)); };
      return (tent(u + half) - tent(u - half)) / (2 * half);
    }
    if (linear_) return a < 1 ? -sign : 0;
    if (quadratic_) return a < 0.5 ? -2 * u : a < 1.5 ? -sign * (1.5 - a) : 0;
    return a < 1 ? -2 * u + 1.5 * a * u : a < 2 ? -sign * 0.5 * (2 - a) * (2 - a) : 0;
  }
  bool apart(const Vec& x, const NaiveNode& node) const {
    for (int d = 0; d < 3; ++d) {
      if (std::abs(x[d] - node.x[d]) >= 2.001 * h_) return true;
    }
    return false;
  }
  // visit(share of N_i, factor of grad N_i) for each corner of a domain: tents there, and (s_c . r^k)_k. [CPDI 2, 3]
  template <class Visit>
  void for_corners(const NaivePoint& p, const NaiveNode& node, Visit&& visit) const {
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
  double weight(const NaivePoint& p, const NaiveNode& node) const {
    if (domains()) {
      double sum = 0;
      for_corners(p, node, [&](double share, const Vec&) { sum += share; });
      return sum;
    }
    double n = 1;
    for (int d = 0; d < dim_; ++d) n *= spline((p.x[d] - node.x[d]) / h_, p.half[d]);
    return n;
  }
  Vec gradient(const NaivePoint& p, const NaiveNode& node) const {
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
  // D = sum N r r^T where the point stands.
  Mat inertia(const NaivePoint& p) const {
    Mat d = Mat::Zero();
    for (const NaiveNode& node : nodes_) {
      if (!apart(p.x, node)) d += weight(p, node) * (node.x - p.x) * (node.x - p.x).transpose();
    }
    return d;
  }
  // Boxes that follow the deformation have the second moments of what the box at the start became; what their inertia
  // gains of the points' affine energy is booked. [GIMP 2] So it is of domains. [CPDI 1]
  void deform_boxes() {
    if ((scene_.shape != "contiguous-gimp" && !domains()) || !neo_) return;
    for (NaivePoint& p : points) {
      const Mat moments = p.half_at_start.cwiseAbs2().asDiagonal();
      const double before = (p.c * inertia(p) * p.c.transpose()).trace();
      p.half = Mat(p.f * moments * p.f.transpose()).diagonal().cwiseSqrt().cwiseMin(0.5);
      p.edges = p.f * p.half_at_start.asDiagonal();
      transfer += p.m * ((p.c * inertia(p) * p.c.transpose()).trace() - before) / 2;
    }
  }
  template <class Visit>
  void for_pairs(Visit&& visit) {
    for (const Pair& k : pairs_) visit(points[k.point], nodes_[k.node], k.n, k.g);
  }
  template <class Visit>
  void for_nodes_of(std::size_t p, Visit&& visit) const {
    for (std::size_t k = first_pair_[p]; k < first_pair_[p + 1]; ++k) {
      visit(nodes_[pairs_[k].node], pairs_[k].n, pairs_[k].g);
    }
  }

  void locate() {
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
  const Vec& frozen(const NaivePoint& point) const { return at_[static_cast<std::size_t>(&point - points.data())]; }

  void to_grid() {
    for (auto& velocity : straining_) velocity.clear();
    for (NaiveNode& node : nodes_) {
      node.m = 0;
      node.momentum.setZero();
    }
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      i.m += p.m * n;                                           // [York 3.15]
      i.momentum += p.m * n * (p.v + p.c * (i.x - frozen(p)));  // [York 3.16] [EC-APIC 1]
    });
    for (NaiveNode& node : nodes_) node.start = node.m > 0 ? Vec(node.momentum / node.m) : Vec(Vec::Zero());
    for (NaivePoint& point : points) point.loss = 0;
    const double taken = 1 - share_kept();
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      p.loss += taken * p.m * n * (p.v + p.c * (i.x - frozen(p)) - i.start).squaredNorm() / 2;  // [EC-APIC 1] A_p
    });
  }

  void forces() {
    for (NaiveNode& node : nodes_) node.force = node.m * gravity_;  // [York 3.18]
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec& g) {
      i.force += n * p.pull;  // [Segments 2]
      if (at_nodes()) return;
      i.force -= p.volume * p.stress * g;                                       // [York 3.17]
      if (rings()) i.force[0] -= p.volume * p.stress(2, 2) * n / frozen(p)[0];  // hoop stress pulls inwards
    });
    if (at_nodes()) press_nodes();
    forces_known_ = true;
  }

  void advance(double dt) {
    std::vector<Vec> a;
    for (const NaiveNode& node : nodes_)
      a.push_back(node.m > 0 ? Vec(node.force / node.m) : Vec(Vec::Zero()));  // [York 3.19]
    a = sharpened(a);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      nodes_[i].end = nodes_[i].start + dt * a[i];  // [York 3.20]
      nodes_[i].middle = 0.5 * (nodes_[i].start + nodes_[i].end);
    }
    for (auto& velocity : straining_) velocity.clear();
  }

  bool at_nodes() const { return gas_ && scene_.nodal_pressure && !rings() && gas_->viscosity == 0; }
  double mass_of(std::optional<std::size_t> i) const { return i ? nodes_[*i].m : 0.0; }
  // visit(j, b_fj) of the face above node i along d. [Pressure 2]
  template <class Visit>
  void for_face(std::size_t i, int d, Visit&& visit) const {
    const double sixth[] = {1, -8, 37, 37, -8, 1};
    std::vector<std::optional<std::size_t>> line;
    double most = 0, taken = 0;
    for (int k = -2; k <= 3; ++k) {
      line.push_back(beside(i, d, k));
      most = std::max(most, mass_of(line.back()));
    }
    const double below = mass_of(line[2]), above = mass_of(line[3]);
    const bool edge = below == 0 || above == 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const double b = edge ? 0 : sixth[k] / 60 * std::min(1.0, 8 * mass_of(line[k]) / most);
      taken += b;
      if (b != 0) visit(*line[k], b);
    }
    if (below > 0) visit(*line[2], (1 - taken) * below / (below + above));
    if (above > 0) visit(*line[3], (1 - taken) * above / (below + above));
  }
  // u_f above node i along d. [Pressure 2]
  double face_velocity(std::size_t i, int d, const std::vector<Vec>& u) const {
    double sum = 0;
    for_face(i, d, [&](std::size_t j, double b) { sum += b * u[j][d]; });
    return sum;
  }
  // D_p. [Pressure 2]
  double divergence(std::size_t p, Of which) const {
    straining_velocity(which);
    const std::vector<Vec>& faces = faces_[static_cast<std::size_t>(which)];
    double sum = 0;
    for_nodes_of(p, [&](const NaiveNode& node, double n, const Vec&) {
      const auto i = static_cast<std::size_t>(&node - nodes_.data());
      for (int d = 0; d < dim_; ++d) sum += n * (faces[i][d] - faces[*beside(i, d, -1)][d]) / h_;
    });
    return sum;
  }
  // [Pressure 1, 3]
  void press_nodes() {
    std::vector<double> pressure(nodes_.size(), 0.0);
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      pressure[static_cast<std::size_t>(&i - nodes_.data())] -= p.volume * p.stress(0, 0) * n / i.volume;
    });
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (int d = 0; d < dim_; ++d) {
        const auto above = beside(i, d, 1);
        if (!above) continue;
        const double rise = pressure[*above] - pressure[i];
        for_face(i, d, [&](std::size_t j, double b) { nodes_[j].force[d] -= nodes_[j].volume / h_ * b * rise; });
      }
    }
  }
  // B: the mean of the shape over a cell, by Simpson's rule on quarters of a cell, exact for these cubic pieces. [Pressure 4]
  double wider_spline(double u) const {
    double sum = 0;
    const double start = u - 0.5, until = u + 0.5;
    std::vector<double> breaks{start, until};
    for (int k = -8; k <= 8; ++k) {
      if (k / 4.0 > start && k / 4.0 < until) breaks.push_back(k / 4.0);
    }
    std::sort(breaks.begin(), breaks.end());
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double a = breaks[k], b = breaks[k + 1];
      sum += (b - a) / 6 * (spline(a, 0) + 4 * spline((a + b) / 2, 0) + spline(b, 0));
    }
    return sum;
  }
  // w where a point stood. [Pressure 4]
  Vec flow_at(std::size_t p, Of which) const {
    Vec w = Vec::Zero();
    straining_velocity(which);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (int d = 0; d < dim_; ++d) {
        Vec face = nodes_[i].x;
        face[d] += h_ / 2;
        if ((at_[p] - face).cwiseAbs().maxCoeff() >= 2.6 * h_) continue;
        double b = wider_spline((at_[p][d] - face[d]) / h_);
        for (int e = 0; e < dim_; ++e) b *= e == d ? 1 : spline((at_[p][e] - face[e]) / h_, 0);
        w[d] += b * faces_[static_cast<std::size_t>(which)][i][d];
      }
    }
    return w;
  }

  // Half the variance of the shape.
  double theta() const {
    return (boxes()                       ? 1.0 / 6 + 0.25 * 0.25 / 3
            : domains()                   ? 1.0 / 6 + 0.25 * 0.25
            : scene_.shape == "linear"    ? 1.0 / 6
            : scene_.shape == "quadratic" ? 1.0 / 4
                                          : 1.0 / 3) /
           2;
  }
  // The node so many steps from another along d, if there is one.
  std::optional<std::size_t> beside(std::size_t i, int d, int side) const {
    int stride = 1;
    for (int e = 0; e < d; ++e) stride *= scene_.grid.cells[static_cast<std::size_t>(e)] + 5;  // see make_nodes()
    const auto j = static_cast<std::size_t>(static_cast<int>(i) + side * stride);
    const double away = std::abs(side) * h_;
    const bool there = j < nodes_.size() && std::abs((nodes_[j].x - nodes_[i].x).norm() - away) < 0.1 * h_;
    return there ? std::optional(j) : std::nullopt;
  }
  // The neighbour of a node that has mass.
  std::optional<std::size_t> massive(std::size_t i, int d, int side) const {
    const auto j = beside(i, d, side);
    return j && nodes_[*j].m > 0 ? j : std::nullopt;
  }
  // Of two sides their mean, or that by the share of their densities in those of the pair. [Limiter 1] [Limiter 2]
  double slope_at(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const {
    double sum = 0, weights = 0;
    const auto density = [&](std::size_t k) { return nodes_[k].m / nodes_[k].volume; };
    for (int side : {-1, 1}) {
      const auto j = massive(i, d, side);
      if (!j) continue;
      const double weight = by_density ? density(*j) / (density(i) + density(*j)) : 1;
      sum += weight * side * (u[*j][d] - u[i][d]) / h_;
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
  }
  // psi of a nodal velocity. [Limiter 1]
  double linear_share(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const {
    const auto low = massive(i, d, -1), high = massive(i, d, 1);
    const double g = slope_at(u, i, d, by_density);
    if (!low || !high || g == 0) return 0;
    const double before = slope_at(u, *low, d, by_density) / g, after = slope_at(u, *high, d, by_density) / g;
    return std::clamp(std::min({(before + after) / 2, 2 * before, 2 * after}), 0.0, 1.0);
  }
  // t of what is sharpened, by the velocity that was mapped. [Limiter 2]
  std::vector<Vec> kept_of_sharpening() const {
    std::vector<Vec> kept(nodes_.size(), Vec::Ones());
    if (scene_.sharpening_in_expansion == 1) return kept;
    std::vector<Vec> u;
    for (const NaiveNode& node : nodes_) u.push_back(node.start);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (int d = 0; d < dim_; ++d) {
        if (nodes_[i].m == 0 || slope_at(u, i, d, true) <= 0) continue;
        const auto density = [&](int side) {
          const auto j = massive(i, d, side);
          return j ? nodes_[*j].m / nodes_[*j].volume : 0.0;
        };
        const double low = density(-1), high = density(1);
        const double uneven = std::abs(high - low) / (high + low);
        const double bent = std::max(0.0, 1 - 2 * (1 - uneven) * linear_share(u, i, d, true));
        kept[i][d] -= (1 - scene_.sharpening_in_expansion) * bent * std::min(1.0, 32 * uneven);
      }
    }
    return kept;
  }
  // Each node against its neighbours, one axis after another, up to the third power. [Sharpening 1]
  std::vector<Vec> sharpened(const std::vector<Vec>& u) const {
    std::vector<Vec> q = u;
    const std::vector<Vec> kept = kept_of_sharpening();
    for (int d = 0; d < dim_ && scene_.sharpening > 0; ++d) {
      std::vector<Vec> power = u;
      for (const double amount : {scene_.sharpening, scene_.sharpening_second, scene_.sharpening_third}) {
        std::vector<Vec> next(u.size(), Vec::Zero());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          for (int side : {-1, 1}) {
            const auto j = beside(i, d, side);
            const double m = nodes_[i].m, other = j ? nodes_[*j].m : 0;
            if (!(m > 0 && other > 0)) continue;
            const double share = (kept[i][d] + kept[*j][d]) * theta() * other / (m + other);
            next[i] += share * (power[i] - power[*j]);
          }
          q[i] += amount * next[i];
        }
        power = next;
      }
    }
    return q;
  }
  // Nodal densities with what two maps smoothed of them undone. [Read-off 1]
  void sharpen_densities(std::vector<double>& rho) const {
    const double share = scene_.sharpened_density ? scene_.sharpening * theta() : 0;
    const std::vector<double> mapped = rho;
    for (int pass = 0; pass < 2 && share > 0; ++pass) {
      const std::vector<double> before = rho;
      const auto at = [&](std::optional<std::size_t> i) { return i ? before[*i] : 0.0; };
      for (std::size_t i = 0; i < rho.size(); ++i) {
        for (int d = 0; d < dim_ && mapped[i] > 0; ++d) {
          const auto j = beside(i, d, 1);
          if (!j || mapped[*j] == 0) continue;
          const double behind = at(beside(i, d, -1)), own = before[i], other = before[*j], ahead = at(beside(*j, d, 1));
          const double change = other - own, sign = change < 0 ? -1 : 1;
          const double most = share * std::min({std::abs(change), behind, own, other, ahead});
          const double flux = sign * std::max(0.0, std::min({most, sign * (own - behind), sign * (ahead - other)}));
          rho[i] -= flux;
          rho[*j] += flux;
        }
      }
    }
  }

  // All of kappa at an extremum of the nodal energies, a quarter where these are monotone. [Exchange 1]
  double exchange_share(std::size_t i) const {
    double most = 0;
    for (int d = 0; d < dim_; ++d) {
      const auto below = beside(i, d, -1), above = beside(i, d, 1);
      const bool known = below && above && nodes_[*below].m > 0 && nodes_[*above].m > 0;
      if (!known) continue;
      const double a = nodes_[i].heat - nodes_[*below].heat, b = nodes_[i].heat - nodes_[*above].heat;
      const bool extreme = (a > 0 && b > 0) || (a < 0 && b < 0);
      const auto [less, more] = std::minmax({std::abs(a), std::abs(b)});
      if (extreme) most = std::max(most, std::min(less / more, 50 * less / nodes_[i].heat));
    }
    return (1 + 3 * most) / 4;
  }
  // What a point will get through the nodes. [Exchange 1]
  void exchange(Of which, double dt) {
    for (NaivePoint& point : points) point.exchanged = 0;
    if (!gas_ || scene_.heat_exchange == 0) return;
    for (NaiveNode& node : nodes_) node.heat = node.alpha = 0;
    std::vector<double> closing;
    for (std::size_t p = 0; p < points.size(); ++p) closing.push_back(std::max(0.0, -strain_rate(p, which).trace()));
    const auto number = [&](const NaivePoint& p) { return static_cast<std::size_t>(&p - points.data()); };
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      i.heat += p.m * p.energy * n / i.m;
      i.alpha += scene_.heat_exchange * dt * p.m * n * closing[number(p)] / i.m;
    });
    std::vector<double> shares(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) shares[i] = nodes_[i].m > 0 ? exchange_share(i) : 0;
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      const double share = shares[static_cast<std::size_t>(&i - nodes_.data())];
      p.exchanged += n * std::min(1.0, share * i.alpha) * (i.heat - p.energy);
    });
  }

  // 1 - alpha_i of the velocities' filter. [Filter 1]
  void keep_shares(double dt) {
    const FilterRate& rate = scene_.filter;
    for (NaiveNode& node : nodes_) node.kept = 0;
    if (!gas_ || rate.none() || scene_.transfer != "apic") return;
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      i.kept += dt * p.m * n * (rate.sound * p.sound / h_ + rate.compression * p.closing) / i.m;
    });
    for (NaiveNode& node : nodes_) node.kept = node.m > 0 ? 1 - std::min(1.0, node.kept) : 0;
  }

  void drift(double dt) {
    for (NaivePoint& point : points) point.x += dt * point.v;  // [Leapfrog 1]
  }

  // What the nodes have of u after it went to the points and back.
  std::vector<Vec> passed(const std::vector<Vec>& u) {
    std::vector<Vec> at_points(points.size(), Vec::Zero()), back(nodes_.size(), Vec::Zero());
    const auto index = [&](const NaiveNode& i) { return static_cast<std::size_t>(&i - nodes_.data()); };
    const auto number = [&](const NaivePoint& p) { return static_cast<std::size_t>(&p - points.data()); };
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) { at_points[number(p)] += n * u[index(i)]; });
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      back[index(i)] += p.m * n / i.m * at_points[number(p)];
    });
    return back;
  }
  // The nodal velocities that points take with xpic and fmpm. [XPIC 1] [FMPM 1]
  std::vector<Vec> filtered() {
    const bool of_end = scene_.transfer == "fmpm";
    std::vector<Vec> w, left;
    for (const NaiveNode& node : nodes_) left.push_back(of_end ? node.end : node.start);
    w = left;
    for (int j = 1; j < scene_.transfer_order; ++j) {
      const std::vector<Vec> lost = passed(left);
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (nodes_[i].m == 0) continue;
        left[i] -= lost[i];
        w[i] += left[i];
      }
    }
    for (std::size_t i = 0; i < w.size() && !of_end; ++i) w[i] += nodes_[i].end - nodes_[i].start;
    return w;
  }

  // alpha of [Blend 1].
  double share_kept() const { return scene_.transfer == "flip" ? 1 : scene_.transfer == "blend" ? 0.95 : 0; }

  void move(double dt, bool along, bool with_middle) {
    const bool filters = scene_.transfer == "xpic" || scene_.transfer == "fmpm";
    const std::vector<Vec> w = filters ? filtered() : std::vector<Vec>();
    keep_shares(dt);
    for (std::size_t p = 0; p < points.size(); ++p) {
      NaivePoint& point = points[p];
      Vec v = Vec::Zero(), change = v, carried = v, of_filter = v;
      Mat moment = Mat::Zero(), b = Mat::Zero(), l = Mat::Zero();
      double square = 0, change_square = 0;
      const Vec own = point.v;
      for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec& g) {
        const Vec r = i.x - at_[p], dv = i.end - i.start;
        const Vec apart = own + point.c * r - i.start, taken = i.end + i.kept * apart;  // [Filter 1]
        v += n * taken;
        carried += n * (with_middle ? i.middle : i.end);
        if (filters) of_filter += n * w[static_cast<std::size_t>(&i - nodes_.data())];
        change += n * dv;
        square += n * (taken.squaredNorm() - i.kept * i.kept * apart.squaredNorm());
        change_square += n * dv.squaredNorm();
        b += n * taken * r.transpose();
        moment += n * r * r.transpose();
        l += taken * g.transpose();
      });
      if (filters) v = of_filter;
      if (along) point.x += dt * carried;  // [York 3.21] [Midpoint 4]
      if (!at_nodes() && scene_.sharpening > 0 && scene_.sharpened_motion)
        point.x += dt * (velocity_at(p, with_middle ? Of::middle : Of::end) - carried);  // [Sharpening 2]
      const bool affine = scene_.transfer == "apic";
      const double keep = share_kept();
      point.v = keep * (own + change) + (1 - keep) * v;  // [York 3.22] [EC-APIC 5] [Blend 1]
      if (at_nodes())
        point.x += dt * (flow_at(p, with_middle ? Of::middle : Of::end) - (along ? carried : point.v));  // [Pressure 4]
      double kept = keep * change.squaredNorm() + (1 - keep) * v.squaredNorm();
      kept -= keep * (1 - keep) * (own + change - v).squaredNorm();
      if (affine) {
        for (int d = dim_; d < 3; ++d) moment(d, d) = 1;
        point.c = scene_.shape == "linear" ? l : Mat(b * moment.inverse());  // [EC-APIC 5]
        const Mat there = inertia(point);
        const double before = (point.c * moment * point.c.transpose()).trace();
        if (domains() && !gas_ && !segments_ && before > 0)  // [CPDI 5]
          point.c *= std::sqrt(before / (point.c * there * point.c.transpose()).trace());
        kept += (point.c * there * point.c.transpose()).trace();
      }
      point.loss += point.m * (keep * change_square + (1 - keep) * square - kept) / 2;  // [EC-APIC 5] B_p
      transfer -= point.loss;
    }
    for (NaiveNode& node : nodes_) {
      body_work += dt * node.m * gravity_.dot(node.middle);
    }
  }

  void again() {
    straining_[static_cast<std::size_t>(Of::again)].clear();
    for (NaiveNode& node : nodes_) node.momentum.setZero();
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      i.momentum += p.m * n * (p.v + p.c * (i.x - frozen(p)));
    });
    for (NaiveNode& node : nodes_)
      node.again = node.m > 0 ? Vec(node.momentum / node.m) : Vec(Vec::Zero());  // [York 3.24]
  }

  // The nodal velocities that strain.
  const std::vector<Vec>& straining_velocity(Of which) const {
    std::vector<Vec>& straining = straining_[static_cast<std::size_t>(which)];
    if (straining.empty()) {
      for (const NaiveNode& i : nodes_) {
        straining.push_back(which == Of::start    ? i.start
                            : which == Of::end    ? i.end
                            : which == Of::middle ? i.middle
                                                  : i.again);
      }
      straining = sharpened(straining);
      std::vector<Vec>& faces = faces_[static_cast<std::size_t>(which)];
      faces.assign(at_nodes() ? nodes_.size() : 0, Vec::Zero());
      for (std::size_t i = 0; i < faces.size(); ++i) {
        for (int d = 0; d < dim_; ++d) faces[i][d] = face_velocity(i, d, straining);
      }
    }
    return straining;
  }
  Mat gradient_of_velocity(std::size_t p, Of which) const {
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
    return l;
  }
  Mat strain_rate(std::size_t p, Of which) const {
    const Mat l = gradient_of_velocity(p, which);
    return (l + l.transpose()) / 2;  // [York 3.23]
  }
  Vec velocity_at(std::size_t p, Of which) const {
    Vec v = Vec::Zero();
    const std::vector<Vec>& straining = straining_velocity(which);
    for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec&) {
      v += n * straining[static_cast<std::size_t>(&i - nodes_.data())];
    });
    return v;
  }
  // What the stress of a point takes from the grid, W.
  double power_of(std::size_t p, Of which) const {
    if (segments_) return -points[p].pull.dot(velocity_at(p, which));
    return points[p].volume * points[p].stress.cwiseProduct(gradient_of_velocity(p, which)).sum();
  }

  // Of the segment that starts at p; the last point of an open chain starts none. [Segments 1]
  bool starts_segment(std::size_t p) const { return segments_->closed || p + 1 < points.size(); }
  double stretch(std::size_t p) const {
    if (!starts_segment(p)) return 0;
    return (points[(p + 1) % points.size()].x - points[p].x).norm() / points[p].rest - 1;
  }
  // Energy of a point's strain, J. [Hooke 1] [Neo-Hookean 1] [Segments 1] [York 5.5]
  double stored_energy(std::size_t p) const {
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
  LameConstants constants() const {
    if (neo_) return lame_constants(neo_->youngs_modulus, neo_->poissons_ratio);
    if (!hooke_) return {0, 0};
    LameConstants c = lame_constants(hooke_->youngs_modulus, hooke_->poissons_ratio);
    if (dim_ == 2 && !rings() && hooke_->plane_stress) c.lambda = 2 * c.lambda * c.mu / (c.lambda + 2 * c.mu);
    if (dim_ == 1) c = {0, hooke_->youngs_modulus / 2};
    return c;
  }
  double own_dilatation(const Mat& f, const Mat& eps) const {
    return neo_ ? std::log(f.determinant()) : hooke_ ? eps.trace() : 0;
  }
  // What of lambda cells share, beyond 2 mu. [Dilatation 3]
  double lambda_shared() const {
    return scene_.mean_dilatation ? std::max(0.0, constants().lambda - 2 * constants().mu) : 0;
  }
  double lambda_own() const { return constants().lambda - lambda_shared(); }
  bool same_cell(std::size_t p, std::size_t q) const {
    for (int d = 0; d < dim_; ++d) {
      const double low = scene_.grid.origin[static_cast<std::size_t>(d)];
      if (std::floor((at_[p][d] - low) / h_) != std::floor((at_[q][d] - low) / h_)) return false;
    }
    return true;
  }
  // Over the points of p's cell, by their masses.
  template <class Value>
  double mean_about(std::size_t p, Value&& value) const {
    double mass = 0, sum = 0;
    for (std::size_t q = 0; q < points.size(); ++q) {
      if (!same_cell(p, q)) continue;
      mass += points[q].m;
      sum += points[q].m * value(q);
    }
    return sum / mass;
  }
  double mean_rate(std::size_t p, Of which) const {  // [Dilatation 1]
    return mean_about(p, [&](std::size_t q) { return gradient_of_velocity(q, which).trace(); });
  }
  // What lambda adds to the normal stresses, over J of finite strains. [Dilatation 2]
  double tension(std::size_t p, double own, double ahead, Of which) const {
    if (lambda_shared() == 0) return lambda_own() * own;
    const double rate = ahead == 0 ? 0 : mean_rate(p, which);
    return lambda_own() * own +
           lambda_shared() * (mean_about(p, [&](std::size_t q) { return points[q].theta; }) + ahead * rate);
  }
  // The pull of the segments on their points as places will be. [Segments 2]
  void set_pulls(Of which, double ahead) {
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

  // Strains and internal variables; what is stored beyond the stress power goes to the flows.
  void strain(double dt, Of which) {
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

  // Strain before the forces: the stress power that counts is that of the stress that the forces will use.
  void strain_first(double dt) {
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

  void book_work(double dt) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      integration -= dt * power_of(p, Of::middle);
    }
  }

  void densities() {
    if (!gas_) return;
    if (scene_.density == DensityMethod::grid) {
      std::vector<double> mass(nodes_.size(), 0.0);
      for (const NaivePoint& point : points) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          if (!apart(point.x, nodes_[i])) mass[i] += point.m * weight(point, nodes_[i]);
        }
      }
      for (std::size_t i = 0; i < nodes_.size(); ++i) mass[i] /= nodes_[i].volume;
      sharpen_densities(mass);
      for (NaivePoint& point : points) {
        point.density = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          if (apart(point.x, nodes_[i])) continue;
          point.density += weight(point, nodes_[i]) * mass[i];  // [EC-APIC 2]
        }
      }
    }
    for (NaivePoint& point : points) point.volume = point.m / point.density;
  }

  void set_stress(Of which, double ahead = 0) {
    densities();
    if (segments_) return set_pulls(which, drifted_ ? 0 : ahead);
    for (std::size_t p = 0; p < points.size(); ++p)
      points[p].stress = stress_of(p, gradient_of_velocity(p, which), ahead, which);
  }

  bool wrinkled(double strain) const { return membrane_->one_way && strain <= 0; }

  // Means of the angles of the adjoining segments. [York 7.1]
  Vec tangent(std::size_t p) const {
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

  // `ahead` seconds later, should the strain rates go on: an isentropic gas to first order, e' = -(gamma - 1) e div v, from the
  // side that stays positive; a membrane strained further. [Leapfrog 2]
  Mat stress_of(std::size_t p, const Mat& l, double ahead = 0, Of which = Of::start) {
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

  // What of the compression is not linear in the flow along an axis. [Limiter 1]
  double limited(std::size_t p, Of which) const {
    const std::vector<Vec>& u = straining_velocity(which);
    double sum = 0;
    for (std::size_t k = first_pair_[p]; k < first_pair_[p + 1]; ++k) {
      for (int d = 0; d < dim_; ++d) {
        const std::size_t i = pairs_[k].node;
        sum += pairs_[k].n * (1 - linear_share(u, i, d, false)) * std::max(0.0, -slope_at(u, i, d, false));
      }
    }
    return std::min(points[p].closing, sum);
  }

  // Where the viscous stress takes heat out over the midpoint velocity, it is taken from that velocity.
  // [EC-APIC viscous heat]
  bool viscosity_would_cool() {
    bool any = false;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Mat e = strain_rate(p, Of::middle);
      const double heat = points[p].stress.cwiseProduct(e).sum() + points[p].pressure * e.trace();
      if (heat >= 0) continue;
      points[p].stress = stress_of(p, e, 0, Of::middle);
      any = true;
    }
    for (std::size_t p = 0; p < points.size() && any; ++p) {  // forces are mapped again, with these rates
      points[p].closing = std::max(0.0, -strain_rate(p, Of::middle).trace());
    }
    return any;
  }

  const Scene scene_;
  // Of the shape's name, which all pairs of points and nodes would compare: most of what the tests took.
  const bool linear_ = scene_.shape == "linear", quadratic_ = scene_.shape == "quadratic";
  const bool boxes_ = scene_.shape == "gimp" || scene_.shape == "contiguous-gimp", domains_ = scene_.shape == "cpdi";
  int dim_;
  double h_;
  const IdealGas* gas_;
  const UniaxialMembrane* membrane_;
  const LinearElastic* hooke_;
  const NeoHookean* neo_;
  const SegmentMembrane* segments_;
  std::vector<NaiveNode> nodes_;
  Vec gravity_ = Vec::Zero();
  std::vector<Pair> pairs_;  // points and the nodes they reach, point by point
  std::vector<std::size_t> first_pair_;
  std::vector<Vec> at_, tangent_of_;
  mutable std::array<std::vector<Vec>, 4> straining_;  // nodal velocities whose gradients strain, by Of
  mutable std::array<std::vector<Vec>, 4> faces_;      // of these, u_f above the nodes [Pressure 2]
  bool forces_known_ = false, drifted_ = false;
  double stored_first_ = 0;
};

}  // namespace plumbline
