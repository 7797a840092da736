// The order of a step and its maps between points and nodes.
#include <Eigen/LU>

#include "tests/kernel/naive/step.hpp"

namespace plumbline {
namespace {

using Vec = NaiveStep::Vec;
using Mat = NaiveStep::Mat;

}  // namespace

NaiveStep::NaiveStep(const Scene& scene)
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

void NaiveStep::step(const std::string& integrator, double dt) {
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

void NaiveStep::refresh() {
  densities();
  for (NaivePoint& point : points) point.pressure = (gas_->gamma - 1) * point.density * point.energy;  // [York 4.4]
  if (scene_.density != DensityMethod::grid) return;
  std::vector<double> pressed;
  for (const NaivePoint& point : points) pressed.push_back(point.volume * point.pressure);
  const std::vector<double> mapped = per_volume(pressed);
  std::vector<double> even = mapped, share(mapped.size());
  sharpen_densities(even);
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    share[i] = even_share(mapped, i, 0.3);
    even[i] *= share[i];
  }
  const std::vector<double> read = at_points(even), taken = at_points(share);
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p].pressure = read[p] + (1 - taken[p]) * points[p].pressure;  // [Read-off 2]
  }
}

Mat NaiveStep::strain_tensor(const Columns& from, std::size_t p) const {
  static constexpr int plane[][2] = {{0, 0}, {1, 1}, {0, 1}}, hoop[][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}},
                       space[][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};
  Mat eps = Mat::Zero();
  for (int k = 0; k < from.components(column::strain); ++k) {
    const auto& [i, j] = rings() ? hoop[k] : dim_ == 3 ? space[k] : plane[k];
    eps(i, j) = eps(j, i) = from(column::strain, k)[p] * (i == j ? 1 : 0.5);
  }
  return eps;
}

Mat NaiveStep::deformation(const Columns& from, std::size_t p) const {
  Mat f = Mat::Identity();
  for (int k = 0; k < dim_ * dim_; ++k) f(k / dim_, k % dim_) = from(column::deformation, k)[p];
  if (rings()) f(2, 2) = from(column::deformation, 4)[p];
  return f;
}

void NaiveStep::to_grid() {
  for (auto& velocity : straining_) velocity.clear();
  even_share_.clear();
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

void NaiveStep::forces() {
  for (NaiveNode& node : nodes_) node.force = node.m * gravity_;  // [York 3.18]
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec& g) {
    i.force += n * p.pull;  // [Segments 2]
    if (at_nodes()) return;
    i.force -= p.volume * p.stress * g;                                       // [York 3.17]
    if (rings()) i.force[0] -= p.volume * p.stress(2, 2) * n / frozen(p)[0];  // hoop stress pulls inwards
  });
  if (at_nodes()) press_nodes();
  if (corrects()) correct_forces();
  forces_known_ = true;
}

void NaiveStep::advance(double dt) {
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

void NaiveStep::keep_shares(double dt) {
  const FilterRate& rate = scene_.filter;
  for (NaiveNode& node : nodes_) node.kept = 0;
  if (!gas_ || rate.none() || scene_.transfer != "apic") return;
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    i.kept += dt * p.m * n * (rate.sound * p.sound / h_ + rate.compression * p.closing) / i.m;
  });
  for (NaiveNode& node : nodes_) node.kept = node.m > 0 ? 1 - std::min(1.0, node.kept) : 0;
}

std::vector<Vec> NaiveStep::passed(const std::vector<Vec>& u) {
  std::vector<Vec> at_points(points.size(), Vec::Zero()), back(nodes_.size(), Vec::Zero());
  const auto index = [&](const NaiveNode& i) { return static_cast<std::size_t>(&i - nodes_.data()); };
  const auto number = [&](const NaivePoint& p) { return static_cast<std::size_t>(&p - points.data()); };
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) { at_points[number(p)] += n * u[index(i)]; });
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    back[index(i)] += p.m * n / i.m * at_points[number(p)];
  });
  return back;
}

std::vector<Vec> NaiveStep::filtered() {
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

void NaiveStep::move(double dt, bool along, bool with_middle) {
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

void NaiveStep::again() {
  straining_[static_cast<std::size_t>(Of::again)].clear();
  for (NaiveNode& node : nodes_) node.momentum.setZero();
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    i.momentum += p.m * n * (p.v + p.c * (i.x - frozen(p)));
  });
  for (NaiveNode& node : nodes_)
    node.again = node.m > 0 ? Vec(node.momentum / node.m) : Vec(Vec::Zero());  // [York 3.24]
}

}  // namespace plumbline
