// The step written straight from the printed equations, as slowly as can be: every node meets every point,
// weights come from the distance between them, and nothing is shared with the kernel but the scene it starts
// from. Free sides only. All vectors and tensors have three components: x, y, z, or r, z and the hoop direction of an
// axisymmetric scene, whose points may stand at negative radii as the mirror images of others.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline {

struct NaivePoint {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero();
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero(), stress = Eigen::Matrix3d::Zero();
  double m = 0, volume = 0, density = 0, energy = 0, pressure = 0, strain = 0, loss = 0, exchanged = 0;
};

struct NaiveNode {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), momentum = x, force = x;
  Eigen::Vector3d start = x, end = x, middle = x, again = x;
  double m = 0, volume = 0, heat = 0, alpha = 0;
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
        membrane_(dynamic_cast<const UniaxialMembrane*>(scene.bodies[0].material.get())) {
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
    }
    make_nodes();
    locate();
    densities();
    for (std::size_t p = 0; p < points.size(); ++p) points[p].stress = stress_of(p, Mat::Zero());
  }

  void step(const std::string& integrator, double dt) {
    const double transfer_before = transfer;
    const bool leapfrog = integrator == "leapfrog";
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
    book_work(dt);
    move(dt, !leapfrog);
    if (integrator == "usf") return;
    if (integrator == "musl" || integrator == "usavg") again();
    if (integrator == "usl") strain(dt, Of::end);
    if (integrator == "musl") strain(dt, Of::again);
    if (integrator == "usavg") strain(dt / 2, Of::again);
    if (integrator == "energy" || leapfrog) {
      strain(dt, Of::middle);
      if (gas_) {
        for (NaivePoint& point : points)
          point.energy += point.exchanged + point.loss / point.m;  // [EC-APIC 6] [Exchange 1]
        transfer = transfer_before;
      }
      if (leapfrog) drift(dt / 2);  // [Leapfrog 3]
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
  struct Pair {
    std::size_t point, node;
    double n;
    Vec g;
  };

  bool rings() const { return scene_.grid.axisymmetric; }

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
    for (int piece = -4; piece < 4; ++piece) {
      const double weights[5] = {7, 32, 12, 32, 7};
      for (int k = 0; k < 5; ++k) {
        const double u = piece / 2.0 + k / 8.0;
        sum += weights[k] / 90 * (h_ / 2) * spline(u) * std::abs(centre + u * h_);
      }
    }
    return sum;
  }
  double spline(double u) const {
    const double a = std::abs(u);
    if (scene_.shape == "linear") return std::max(0.0, 1 - a);
    if (scene_.shape == "quadratic") return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
    return a < 1 ? 2.0 / 3 - a * a + a * a * a / 2 : a < 2 ? std::pow(2 - a, 3) / 6 : 0;
  }
  double slope(double u) const {
    const double a = std::abs(u), sign = u < 0 ? -1 : 1;
    if (scene_.shape == "linear") return a < 1 ? -sign : 0;
    if (scene_.shape == "quadratic") return a < 0.5 ? -2 * u : a < 1.5 ? -sign * (1.5 - a) : 0;
    return a < 1 ? -2 * u + 1.5 * a * u : a < 2 ? -sign * 0.5 * (2 - a) * (2 - a) : 0;
  }
  bool apart(const Vec& x, const NaiveNode& node) const { return (x - node.x).cwiseAbs().maxCoeff() >= 2.001 * h_; }
  double weight(const Vec& x, const NaiveNode& node) const {
    double n = 1;
    for (int d = 0; d < dim_; ++d) n *= spline((x[d] - node.x[d]) / h_);
    return n;
  }
  Vec gradient(const Vec& x, const NaiveNode& node) const {
    Vec g = Vec::Zero();
    for (int d = 0; d < dim_; ++d) {
      g[d] = slope((x[d] - node.x[d]) / h_) / h_;
      for (int e = 0; e < dim_; ++e) g[d] *= e == d ? 1 : spline((x[e] - node.x[e]) / h_);
    }
    return g;
  }
  // D = sum N r r^T of the place x.
  Mat inertia(const Vec& x) const {
    Mat d = Mat::Zero();
    for (const NaiveNode& node : nodes_) {
      if (!apart(x, node)) d += weight(x, node) * (node.x - x) * (node.x - x).transpose();
    }
    return d;
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
    pairs_.clear();
    first_pair_.assign(1, 0);
    at_.clear();
    for (std::size_t p = 0; p < points.size(); ++p) {
      at_.push_back(points[p].x);
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (apart(points[p].x, nodes_[i])) continue;
        const Pair pair{p, i, weight(points[p].x, nodes_[i]), gradient(points[p].x, nodes_[i])};
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
    if (scene_.transfer == "flip") return;
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      p.loss += p.m * n * (p.v + p.c * (i.x - frozen(p)) - i.start).squaredNorm() / 2;  // [EC-APIC 1] A_p
    });
  }

  void forces() {
    for (NaiveNode& node : nodes_) node.force = node.m * gravity_;  // [York 3.18]
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec& g) {
      i.force -= p.volume * p.stress * g;                                       // [York 3.17]
      if (rings()) i.force[0] -= p.volume * p.stress(2, 2) * n / frozen(p)[0];  // hoop stress pulls inwards
    });
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

  // Each node against its neighbours along the axes, theta half the variance of the shape. [Sharpening 1]
  std::vector<Vec> sharpened(const std::vector<Vec>& u) const {
    const double variance = scene_.shape == "linear" ? 1.0 / 6 : scene_.shape == "quadratic" ? 1.0 / 4 : 1.0 / 3;
    std::vector<Vec> q = u;
    for (std::size_t i = 0; i < nodes_.size() && scene_.sharpening > 0; ++i) {
      int stride = 1;
      for (int d = 0; d < dim_; ++d) {
        for (int side : {-1, 1}) {
          const auto j = static_cast<std::size_t>(static_cast<int>(i) + side * stride);
          if (j >= nodes_.size() || std::abs((nodes_[j].x - nodes_[i].x).norm() - h_) > 0.1 * h_) continue;
          const double m = nodes_[i].m, other = nodes_[j].m;
          if (m > 0 && other > 0) q[i] += scene_.sharpening * variance / 2 * 2 * other / (m + other) * (u[i] - u[j]);
        }
        stride *= scene_.grid.cells[static_cast<std::size_t>(d)] + 5;  // nodes of a direction, see make_nodes()
      }
    }
    return q;
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
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      p.exchanged += n * std::min(1.0, i.alpha) * (i.heat - p.energy);
    });
  }

  void drift(double dt) {
    for (NaivePoint& point : points) point.x += dt * point.v;  // [Leapfrog 1]
  }

  void move(double dt, bool along) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      NaivePoint& point = points[p];
      Vec v = Vec::Zero(), change = Vec::Zero();
      Mat moment = Mat::Zero(), b = Mat::Zero(), l = Mat::Zero();
      double square = 0, change_square = 0;
      for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec& g) {
        const Vec r = i.x - at_[p], dv = i.end - i.start;
        v += n * i.end;
        change += n * dv;
        square += n * i.end.squaredNorm();
        change_square += n * dv.squaredNorm();
        b += n * i.end * r.transpose();
        moment += n * r * r.transpose();
        l += i.end * g.transpose();
      });
      if (along) point.x += dt * v;  // [York 3.21]
      const bool flip = scene_.transfer == "flip", affine = scene_.transfer == "apic";
      point.v = flip ? Vec(point.v + change) : v;  // [York 3.22] [EC-APIC 5]
      double kept = flip ? change.squaredNorm() : v.squaredNorm();
      if (affine) {
        for (int d = dim_; d < 3; ++d) moment(d, d) = 1;
        point.c = scene_.shape == "linear" ? l : Mat(b * moment.inverse());  // [EC-APIC 5]
        kept += (point.c * inertia(point.x) * point.c.transpose()).trace();
      }
      point.loss += point.m * ((flip ? change_square : square) - kept) / 2;  // [EC-APIC 5] B_p
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

  Mat strain_rate(std::size_t p, Of which) const {
    Mat l = Mat::Zero();
    std::vector<Vec>& straining = straining_[static_cast<std::size_t>(which)];
    if (straining.empty()) {
      for (const NaiveNode& i : nodes_) {
        straining.push_back(which == Of::start    ? i.start
                            : which == Of::end    ? i.end
                            : which == Of::middle ? i.middle
                                                  : i.again);
      }
      straining = sharpened(straining);
    }
    for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec& g) {
      const Vec& v = straining[static_cast<std::size_t>(&i - nodes_.data())];
      l += v * g.transpose();
      if (rings()) l(2, 2) += n * v[0] / at_[p][0];
    });
    return (l + l.transpose()) / 2;  // [York 3.23]
  }

  // Strains and internal variables; what is stored beyond the stress power goes to the flows.
  void strain(double dt, Of which) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      NaivePoint& point = points[p];
      const Mat e = strain_rate(p, which);
      const double power = dt * point.volume * point.stress.cwiseProduct(e).sum();
      double stored = power;
      if (gas_) {
        point.energy += power / point.m;                                                       // [York 4.8]
        if (scene_.density == DensityMethod::continuity) point.density /= 1 + dt * e.trace();  // [York 4.7]
      } else {
        const double before = wrinkled(point.strain) ? 0 : membrane_->youngs_modulus * point.strain * point.strain / 2;
        const Vec t = tangent_of_[p];
        point.strain += dt * t.dot(e * t);  // [York 5.2, 5.3]
        const double after = wrinkled(point.strain) ? 0 : membrane_->youngs_modulus * point.strain * point.strain / 2;
        stored = point.volume * (after - before);
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
      power += dt * points[p].volume * points[p].stress.cwiseProduct(strain_rate(p, Of::start)).sum();
    }
    integration += power;
    constitutive += stored_first_ - power;
  }

  void book_work(double dt) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      integration -= dt * points[p].volume * points[p].stress.cwiseProduct(strain_rate(p, Of::middle)).sum();
    }
  }

  void densities() {
    if (!gas_) return;
    if (scene_.density == DensityMethod::grid) {
      std::vector<double> mass(nodes_.size(), 0.0);
      for (const NaivePoint& point : points) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          if (!apart(point.x, nodes_[i])) mass[i] += point.m * weight(point.x, nodes_[i]);
        }
      }
      for (NaivePoint& point : points) {
        point.density = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          if (apart(point.x, nodes_[i])) continue;
          point.density += weight(point.x, nodes_[i]) * mass[i] / nodes_[i].volume;  // [EC-APIC 2]
        }
      }
    }
    for (NaivePoint& point : points) point.volume = point.m / point.density;
  }

  void set_stress(Of which, double ahead = 0) {
    densities();
    for (std::size_t p = 0; p < points.size(); ++p) points[p].stress = stress_of(p, strain_rate(p, which), ahead);
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
  Mat stress_of(std::size_t p, const Mat& e, double ahead = 0) {
    NaivePoint& point = points[p];
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
    const double closing = div < 0 ? h_ * std::abs(div) : 0;
    const double q = point.density * (gas_->viscosity_linear * c * closing +
                                      gas_->viscosity_quadratic * closing * closing);  // [York 4.11]
    return 2 * gas_->viscosity * e -
           (2.0 / 3 * gas_->viscosity * div + point.pressure + q) * Mat::Identity();  // [York 4.1]
  }

  // Where the viscous stress takes heat out over the midpoint velocity, it is taken from that velocity.
  // [EC-APIC viscous heat]
  bool viscosity_would_cool() {
    bool any = false;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Mat e = strain_rate(p, Of::middle);
      const double heat = points[p].stress.cwiseProduct(e).sum() + points[p].pressure * e.trace();
      if (heat >= 0) continue;
      points[p].stress = stress_of(p, e);
      any = true;
    }
    return any;
  }

  const Scene scene_;
  int dim_;
  double h_;
  const IdealGas* gas_;
  const UniaxialMembrane* membrane_;
  std::vector<NaiveNode> nodes_;
  Vec gravity_ = Vec::Zero();
  std::vector<Pair> pairs_;  // points and the nodes they reach, point by point
  std::vector<std::size_t> first_pair_;
  std::vector<Vec> at_, tangent_of_;
  mutable std::array<std::vector<Vec>, 4> straining_;  // nodal velocities whose gradients strain, by Of
  bool forces_known_ = false;
  double stored_first_ = 0;
};

}  // namespace plumbline
