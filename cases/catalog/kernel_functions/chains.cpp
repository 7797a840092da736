// Chains of segments between points, and of bands around an axis, now and later.
#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/points/body.hpp"

namespace plumbline::kernel_functions::chains_trial {
namespace {

constexpr double chain_modulus = 2.3, chain_ratio = 0.3, chain_density = 1.4, chain_section = 0.15;
constexpr int chain_points = 5;

double volume_at(int p) { return 0.3 + 0.08 * p; }

// Of a segment: the force on its first point and on its second, N, its energy, J, and its strains.
struct Segment {
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = first;
  double energy = 0, strain = 0, hoop = 0;
};

// Stresses along and around a band, none of them a push: by which of them pull. [Segments 3]
Segment band_state(double strain, double hoop) {
  const double wide = chain_modulus / (1 - chain_ratio * chain_ratio);
  const double along = wide * (strain + chain_ratio * hoop), around = wide * (hoop + chain_ratio * strain);
  Segment all;
  const bool taut = along > 0 && around > 0;
  if (taut || (strain > 0 && strain >= hoop)) all.first[0] = taut ? along : chain_modulus * strain;
  if (taut || (hoop > 0 && hoop > strain)) all.first[1] = taut ? around : chain_modulus * hoop;
  all.energy = (all.first[0] * strain + all.first[1] * hoop) / 2;
  return all;
}

struct GivenChain {
  SegmentMembrane law;
  int dim = 2;
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(chain_points, 3), v = x;
  std::vector<double> rest, radius;

  GivenChain(int dimension, bool closed, bool one_way, bool revolved) : dim(dimension) {
    law.youngs_modulus = chain_modulus;
    law.density = chain_density;
    law.section = chain_section;
    law.one_way = one_way;
    law.closed = closed;
    law.revolved = revolved;
    if (revolved) law.poissons_ratio = chain_ratio;
    for (int p = 0; p < chain_points; ++p) {
      for (int d = 0; d < dim; ++d) {
        x(p, d) = (d == 0 ? 2.0 : 0.3) + (0.8 + 0.1 * d) * std::cos(1.25 * p + 1.4 * d);
        v(p, d) = 0.5 * std::sin(2.1 * p + 0.9 * d + 0.3);
      }
    }
    for (int p = 0; p < chain_points; ++p) {
      const int q = (p + 1) % chain_points;
      const double stretch[] = {1.1, 0.92, 1.25, 0.97, 1.07}, around[] = {1.06, 1.15, 0.96, 0.9, 0.8};
      rest.push_back((x.row(q) - x.row(p)).norm() / stretch[p]);
      radius.push_back((x(p, 0) + x(q, 0)) / 2 / around[p]);
    }
  }
  bool has(int p) const { return law.closed || p + 1 < chain_points; }
  Segment segment(int p, double ahead) const {
    Segment all;
    if (!has(p)) return all;
    const auto at = static_cast<std::size_t>(p);
    const Eigen::MatrixXd then = x + ahead * v;
    const Eigen::RowVector3d from = then.row(p), to = then.row((p + 1) % chain_points), edge = to - from;
    const Eigen::Vector3d direction = edge.normalized().transpose();
    all.strain = edge.norm() / rest[at] - 1;
    double pull = law.one_way && all.strain < 0 ? 0 : chain_section * chain_modulus * all.strain, outward = 0;
    all.energy = rest[at] * pull * all.strain / 2;
    if (law.revolved) {
      all.hoop = (from[0] + to[0]) / 2 / radius[at] - 1;
      const Segment state = band_state(all.strain, all.hoop);
      all.energy = chain_section * rest[at] * radius[at] * state.energy;
      pull = chain_section * radius[at] * state.first[0];
      outward = -chain_section * rest[at] * state.first[1] / 2;
    }
    all.first = pull * direction + outward * Eigen::Vector3d::UnitX();
    all.second = -pull * direction + outward * Eigen::Vector3d::UnitX();
    return all;
  }
  double stiffness(int p) const {
    if (!has(p)) return 0;
    const auto at = static_cast<std::size_t>(p);
    if (!law.revolved) return chain_section * chain_modulus / rest[at];
    return chain_section * chain_modulus / (1 - chain_ratio * chain_ratio) *
           (radius[at] / rest[at] + rest[at] / (4 * radius[at]));
  }
};

void add_chain(const std::string& name, const GivenChain& chain, KnownAnswers& all) {
  const SegmentMembrane& law = chain.law;
  const int dim = chain.dim, n = chain_points;
  Columns points = make_body("points", std::make_shared<SegmentMembrane>(law), n, dim, law.revolved).points;
  points.add(column::transfer_loss);
  double motion = 0, stored = 0;
  for (int p = 0; p < n; ++p) {
    const auto at = static_cast<std::size_t>(p);
    points(column::volume)[p] = volume_at(p);
    points(column::mass)[p] = chain_density * volume_at(p) * (1 + 0.1 * p);
    points(column::rest_length)[p] = chain.rest[at];
    if (law.revolved) points(column::rest_radius)[p] = chain.radius[at];
    double square = 0;
    for (int d = 0; d < dim; ++d) {
      points(column::position, d)[p] = chain.x(p, d);
      points(column::strain_rate, d)[p] = chain.v(p, d);
      points(column::velocity, d)[p] = 0.1 * p + 0.2 * d - 0.3;
      square += std::pow(0.1 * p + 0.2 * d - 0.3, 2);
    }
    motion = std::max(motion, std::sqrt(square));
  }
  law.describe(points);
  for (int p = 0; p < n; ++p) {
    const Segment own = chain.segment(p, 0);
    stored += own.energy;
    all.push_back({name + ".strain" + std::to_string(p), points(column::strain)[p], own.strain});
    if (law.revolved) all.push_back({name + ".hoop" + std::to_string(p), points(column::hoop_strain)[p], own.hoop});
  }
  all.push_back({name + ".kept", law.stored_energy(points, all_points(points)), stored});
  all.push_back({name + ".kept_by_one", law.stored_energy(points, {2, 3}), chain.segment(2, 0).energy});
  MaterialContext context;
  context.dim = dim;
  for (const double ahead : {0.25, 0.0}) {
    context.ahead = ahead;
    law.evaluate_stress(points, {0, 2}, context);
    law.evaluate_stress(points, {2, n}, context);
    for (int p = 0; p < n; ++p) {
      const Segment own = chain.segment(p, ahead), before = chain.segment((p + n - 1) % n, ahead);
      for (int d = 0; d < dim; ++d) {
        const std::string at = std::to_string(d) + "." + std::to_string(p) + (ahead > 0 ? ".later" : "");
        all.push_back({name + ".first" + at, points(column::segment_force, d)[p], own.first[d]});
        all.push_back({name + ".second" + at, points(column::segment_force, dim + d)[p], own.second[d]});
        all.push_back(
            {name + ".stress" + at, points(column::stress, d)[p], -(own.first[d] + before.second[d]) / volume_at(p)});
      }
    }
  }
  std::vector<double> forces;
  const double time = law.point_forces(points, forces);
  double fastest = 0;
  for (int p = 0; p < n; ++p) {
    const Segment own = chain.segment(p, 0), before = chain.segment((p + n - 1) % n, 0);
    fastest = std::max(fastest, 2 * (chain.stiffness(p) + chain.stiffness((p + n - 1) % n)) / points(column::mass)[p]);
    for (int d = 0; d < dim; ++d) {
      all.push_back({name + ".force" + std::to_string(d) + "." + std::to_string(p),
                     forces[static_cast<std::size_t>(d * n + p)], own.first[d] + before.second[d]});
    }
  }
  all.push_back({name + ".time", time * fastest, 1});
  const double modulus = chain_modulus / (law.revolved ? 1 - chain_ratio * chain_ratio : 1);
  all.push_back({name + ".fastest", law.step_bounds(points, all_points(points), dim).fastest,
                 std::sqrt(modulus / chain_density) + motion});
  // A step from other places: strains are those of the places, losses what the work of the forces leaves.
  const std::vector<double> rates = law.rates(points, context);
  constexpr double dt = 0.11;
  GivenChain moved = chain;
  moved.x += dt * chain.v;
  for (int p = 0; p < n; ++p) {
    for (int d = 0; d < dim; ++d) points(column::position, d)[p] = moved.x(p, d);
  }
  double gained = 0;
  for (int p = 1; p < n; ++p) gained += moved.segment(p, 0).energy - chain.segment(p, 0).energy;
  all.push_back({name + ".gained", law.advance(points, {1, n}, context, dt), gained});
  for (int p = 0; p < n; ++p) {
    const int q = (p + 1) % n;
    const Segment own = chain.segment(p, 0), now = moved.segment(p, 0);
    const double work = -dt * (own.first.dot(chain.v.row(p)) + own.second.dot(chain.v.row(q)));
    all.push_back({name + ".loss" + std::to_string(p), points(column::transfer_loss)[p],
                   p == 0 ? 0 : work - (now.energy - own.energy)});
    all.push_back({name + ".after" + std::to_string(p), points(column::strain)[p], p == 0 ? own.strain : now.strain});
    const auto at = static_cast<std::size_t>(p);
    const Eigen::RowVector3d edge = chain.x.row(q) - chain.x.row(p);
    const double opening = edge.normalized().dot(chain.v.row(q) - chain.v.row(p)) / chain.rest[at];
    all.push_back({name + ".rate" + std::to_string(p), rates[at], chain.has(p) ? opening : 0});
    if (!law.revolved) continue;
    const double widening = (chain.v(p, 0) + chain.v(q, 0)) / 2 / chain.radius[at];
    all.push_back(
        {name + ".hoop_rate" + std::to_string(p), rates[static_cast<std::size_t>(n + p)], chain.has(p) ? widening : 0});
  }
}

}  // namespace

KnownAnswers chain_answers() {
  KnownAnswers all;
  for (const bool closed : {false, true}) {
    for (const int dim : {2, 3}) {
      for (const bool one_way : {false, true}) {
        add_chain("chain" + std::to_string(dim) + (closed ? ".closed" : "") + (one_way ? ".one_way" : ""),
                  GivenChain(dim, closed, one_way, false), all);
      }
    }
    add_chain(std::string("bands") + (closed ? ".closed" : ""), GivenChain(2, closed, true, true), all);
  }
  SegmentMembrane law;
  law.youngs_modulus = chain_modulus;
  law.poissons_ratio = chain_ratio;
  // Both pull, of positive strains and with one negative; one pulls; none.
  const double strains[][2] = {{0.2, 0.1},     {0.2, -0.059}, {0.2, -0.0612}, {-0.059, 0.2},
                               {-0.0612, 0.2}, {-0.1, -0.2},  {-0.2, -0.1}};
  for (const auto& [strain, hoop] : strains) {
    const SegmentMembrane::BandState found = law.band(strain, hoop);
    const Segment exact = band_state(strain, hoop);
    const std::string at = "band" + std::to_string(strain) + "," + std::to_string(hoop);
    all.push_back({at + ".energy", found.energy, exact.energy});
    all.push_back({at + ".along", found.along, exact.first[0]});
    all.push_back({at + ".around", found.around, exact.first[1]});
  }
  return all;
}

}  // namespace plumbline::kernel_functions::chains_trial
