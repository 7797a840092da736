// The step written straight from the printed equations, as slowly as can be: every node meets every point,
// weights come from the distance between them, and nothing is shared with the kernel but the scene it starts
// from. Free sides only.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline {

struct NaivePoint {
  Eigen::Vector2d x = Eigen::Vector2d::Zero(), v = Eigen::Vector2d::Zero();
  Eigen::Matrix2d c = Eigen::Matrix2d::Zero(), stress = Eigen::Matrix2d::Zero();
  double m = 0, volume = 0, density = 0, energy = 0, pressure = 0, strain = 0, loss = 0;
};

struct NaiveNode {
  Eigen::Vector2d x = Eigen::Vector2d::Zero(), momentum = x, force = x;
  Eigen::Vector2d start = x, end = x, middle = x, again = x;
  double m = 0;
};

class NaiveStep {
 public:
  using Vec = Eigen::Vector2d;
  using Mat = Eigen::Matrix2d;
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
      }
      point.m = from(column::mass)[p];
      point.volume = from(column::volume)[p];
      if (gas_) point.density = from(column::density)[p];
      if (gas_) point.energy = from(column::energy)[p];
      if (membrane_) point.strain = from(column::strain)[p];
    }
    for (int j = dim_ == 1 ? 0 : -2; j <= (dim_ == 1 ? 0 : scene.grid.cells[1] + 2); ++j) {
      for (int i = -2; i <= scene.grid.cells[0] + 2; ++i) {
        NaiveNode node;
        node.x = Vec(scene.grid.origin[0] + i * h_, scene.grid.origin[1] + j * h_);
        nodes_.push_back(node);
      }
    }
    locate();
    densities();
    for (std::size_t p = 0; p < points.size(); ++p) points[p].stress = stress_of(p, Mat::Zero());
  }

  void step(const std::string& integrator, double dt) {
    const double transfer_before = transfer;
    locate();
    to_grid();
    if (integrator == "usf") strain_first(dt);
    if (integrator == "usavg") strain_first(dt / 2);
    if (integrator == "energy") set_stress(Of::start);
    forces();
    advance(dt);
    if (integrator == "energy" && viscosity_would_cool()) {
      forces();
      advance(dt);
    }
    book_work(dt);
    move(dt);
    if (integrator == "usf") return;
    if (integrator == "musl" || integrator == "usavg") again();
    if (integrator == "usl") strain(dt, Of::end);
    if (integrator == "musl") strain(dt, Of::again);
    if (integrator == "usavg") strain(dt / 2, Of::again);
    if (integrator == "energy") {
      strain(dt, Of::middle);
      if (membrane_) return;
      for (NaivePoint& point : points) point.energy += point.loss / point.m;  // [EC-APIC 6]
      transfer = transfer_before;
      return;
    }
    set_stress(integrator == "usl" ? Of::end : Of::again);
  }

 private:
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
    for (const NaiveNode& node : nodes_) d += weight(x, node) * (node.x - x) * (node.x - x).transpose();
    return d;
  }
  template <class Visit>
  void for_pairs(Visit&& visit) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const std::size_t k = p * nodes_.size() + i;
        if (n_[k] != 0 || !g_[k].isZero(0)) visit(points[p], nodes_[i], n_[k], g_[k]);
      }
    }
  }

  void locate() {
    n_.resize(points.size() * nodes_.size());
    g_.resize(n_.size());
    at_.clear();
    for (std::size_t p = 0; p < points.size(); ++p) {
      at_.push_back(points[p].x);
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        n_[p * nodes_.size() + i] = weight(points[p].x, nodes_[i]);
        g_[p * nodes_.size() + i] = gradient(points[p].x, nodes_[i]);
      }
    }
  }
  const Vec& frozen(const NaivePoint& point) const { return at_[static_cast<std::size_t>(&point - points.data())]; }

  void to_grid() {
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
    for (NaiveNode& node : nodes_)
      node.force = node.m * Vec(scene_.gravity[0], dim_ == 1 ? 0 : scene_.gravity[1]);  // [York 3.18]
    for_pairs(
        [&](NaivePoint& p, NaiveNode& i, double, const Vec& g) { i.force -= p.volume * p.stress * g; });  // [York 3.17]
    forces_known_ = true;
  }

  void advance(double dt) {
    for (NaiveNode& node : nodes_) {
      const Vec a = node.m > 0 ? Vec(node.force / node.m) : Vec(Vec::Zero());  // [York 3.19]
      node.end = node.start + dt * a;                                          // [York 3.20]
      node.middle = 0.5 * (node.start + node.end);
    }
  }

  void move(double dt) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      NaivePoint& point = points[p];
      Vec v = Vec::Zero(), change = Vec::Zero();
      Mat moment = Mat::Zero(), b = Mat::Zero(), l = Mat::Zero();
      double square = 0, change_square = 0;
      for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const NaiveNode& i = nodes_[k];
        const double n = n_[p * nodes_.size() + k];
        const Vec r = i.x - at_[p], dv = i.end - i.start;
        v += n * i.end;
        change += n * dv;
        square += n * i.end.squaredNorm();
        change_square += n * dv.squaredNorm();
        b += n * i.end * r.transpose();
        moment += n * r * r.transpose();
        l += i.end * g_[p * nodes_.size() + k].transpose();
      }
      point.x += dt * v;  // [York 3.21]
      const bool flip = scene_.transfer == "flip", affine = scene_.transfer == "apic";
      point.v = flip ? Vec(point.v + change) : v;  // [York 3.22] [EC-APIC 5]
      double kept = flip ? change.squaredNorm() : v.squaredNorm();
      if (affine) {
        if (dim_ == 1) moment(1, 1) = 1;
        point.c = scene_.shape == "linear" ? l : Mat(b * moment.inverse());  // [EC-APIC 5]
        kept += (point.c * inertia(point.x) * point.c.transpose()).trace();
      }
      point.loss += point.m * ((flip ? change_square : square) - kept) / 2;  // [EC-APIC 5] B_p
      transfer -= point.loss;
    }
    for (NaiveNode& node : nodes_) {
      body_work += dt * node.m * Vec(scene_.gravity[0], dim_ == 1 ? 0 : scene_.gravity[1]).dot(node.middle);
    }
  }

  void again() {
    for (NaiveNode& node : nodes_) node.momentum.setZero();
    for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
      i.momentum += p.m * n * (p.v + p.c * (i.x - frozen(p)));
    });
    for (NaiveNode& node : nodes_)
      node.again = node.m > 0 ? Vec(node.momentum / node.m) : Vec(Vec::Zero());  // [York 3.24]
  }

  Mat strain_rate(std::size_t p, Of which) const {
    Mat l = Mat::Zero();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const NaiveNode& i = nodes_[k];
      const Vec& v = which == Of::start ? i.start : which == Of::end ? i.end : which == Of::middle ? i.middle : i.again;
      l += v * g_[p * nodes_.size() + k].transpose();
    }
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
        for (std::size_t i = 0; i < nodes_.size(); ++i) mass[i] += point.m * weight(point.x, nodes_[i]);
      }
      for (NaivePoint& point : points) {
        point.density = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          point.density += weight(point.x, nodes_[i]) * mass[i] / std::pow(h_, dim_);  // [EC-APIC 2]
        }
      }
    }
    for (NaivePoint& point : points) point.volume = point.m / point.density;
  }

  void set_stress(Of which) {
    densities();
    for (std::size_t p = 0; p < points.size(); ++p) points[p].stress = stress_of(p, strain_rate(p, which));
  }

  bool wrinkled(double strain) const { return membrane_->one_way && strain <= 0; }

  // Means of the angles of the adjoining segments. [York 7.1]
  Vec tangent(std::size_t p) const {
    if (dim_ == 1) return Vec(1, 0);
    const std::size_t n = points.size();
    const bool open = !membrane_->closed;
    const auto angle = [&](std::size_t from) {
      const Vec d = points[(from + 1) % n].x - points[from % n].x;
      return std::atan2(d[1], d[0]);
    };
    const double before = open && p == 0 ? angle(0) : angle(p + n - 1),
                 after = open && p == n - 1 ? angle(n - 2) : angle(p);
    const double turn = std::remainder(after - before, 2 * std::numbers::pi);
    return Vec(std::cos(before + turn / 2), std::sin(before + turn / 2));
  }

  Mat stress_of(std::size_t p, const Mat& e) {
    NaivePoint& point = points[p];
    if (membrane_) {
      if (p == 0) {
        tangent_of_.clear();
        for (std::size_t k = 0; k < points.size(); ++k) tangent_of_.push_back(tangent(k));
      }
      const double s = wrinkled(point.strain) ? 0 : membrane_->youngs_modulus * point.strain;  // [York 5.5]
      return s * tangent_of_[p] * tangent_of_[p].transpose();
    }
    const double div = e.trace(), c = std::sqrt(gas_->gamma * (gas_->gamma - 1) * point.energy);
    point.pressure = (gas_->gamma - 1) * point.density * point.energy;  // [York 4.4]
    const double closing = div < 0 ? h_ * std::abs(div) : 0;
    const double q = point.density * (gas_->viscosity_linear * c * closing +
                                      gas_->viscosity_quadratic * closing * closing);  // [York 4.11]
    Mat one = Mat::Identity();
    if (dim_ == 1) one(1, 1) = 0;
    return 2 * gas_->viscosity * e - (2.0 / 3 * gas_->viscosity * div + point.pressure + q) * one;  // [York 4.1]
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
  std::vector<double> n_;  // N_ip, point by point
  std::vector<Vec> g_, at_, tangent_of_;
  bool forces_known_ = false;
  double stored_first_ = 0;
};

}  // namespace plumbline
