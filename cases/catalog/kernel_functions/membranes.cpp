// Membranes in space, of tangents that are set or are given sums over places: stresses now and later, energies, rates, speeds.
#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/materials/carried_membrane.hpp"
#include "kernel/materials/surface_membrane.hpp"
#include "kernel/points/body.hpp"

namespace plumbline::kernel_functions::membranes_trial {
namespace {

using Tangents = Eigen::Matrix<double, 3, 2>;
using Flat = Eigen::Matrix2d;

constexpr double modulus = 1.9, ratio = 0.32, rest_density = 1.15, thickness = 0.03;
constexpr int membrane_points = 5;
const Flat one = Flat::Identity();

// W and S = 2 dW/dc of the two laws. [Surface 2]
struct Answer {
  double energy;
  Flat stress;
};
Answer answer_of(const Tangents& f, bool neo_hookean) {
  const Flat c = f.transpose() * f, e = (c - one) / 2;
  const double mu = modulus / 3, stiff = modulus / (1 - ratio * ratio), trace = e.trace();
  if (neo_hookean) {
    return {mu / 2 * (c.trace() + 1 / c.determinant() - 3), mu * (one - c.inverse() / c.determinant())};
  }
  return {stiff / 2 * ((1 - ratio) * e.squaredNorm() + ratio * trace * trace),
          stiff * ((1 - ratio) * e + ratio * trace * one)};
}

// Along the longer of the principal stretches: the square of it times the second derivative of the energy by it.
double wave_of(const Tangents& f, bool neo_hookean) {
  const Eigen::Vector2d squares = Eigen::SelfAdjointEigenSolver<Flat>(f.transpose() * f).eigenvalues();
  const double low = squares[0], high = squares[1], stiff = modulus / (1 - ratio * ratio);
  const double pull = stiff * ((high - 1) + ratio * (low - 1)) / 2;
  const double square = neo_hookean ? modulus / 3 * (high + 3 / (low * high))
                                    : high * std::max(pull, 0.0) + stiff * high * high;
  return std::sqrt(square / rest_density);
}

// Stretched, wrinkled and slack, and oblique to every axis.
Tangents tangents_at(int p) {
  Tangents f;
  f << 1.2 - 0.11 * p, -0.3 + 0.05 * p, 0.35, 0.9 - 0.02 * p, -0.15 + 0.07 * p, 0.5 + 0.04 * p;
  return f;
}
Eigen::Matrix3d gradient_at(int p) {
  Eigen::Matrix3d l;
  l << 0.4, -0.7 + 0.1 * p, 0.25, 0.6, -0.35, 0.5 - 0.05 * p, -0.2 + 0.03 * p, 0.8, 0.15;
  return l;
}

void set_tangents(Columns& points, int p, const Tangents& f) {
  for (int k = 0; k < 6; ++k) points(column::tangents, k)[p] = f(k % 3, k / 3);
}
Tangents tangents_of(const Columns& points, int p) {
  return Tangents::NullaryExpr(
      [&](Eigen::Index d, Eigen::Index a) { return points(column::tangents, static_cast<int>(3 * a + d))[p]; });
}

template <class Membrane>
std::shared_ptr<Membrane> membrane(bool neo_hookean) {
  const auto material = std::make_shared<Membrane>();
  material->youngs_modulus = modulus;
  material->poissons_ratio = ratio;
  material->density = rest_density;
  material->thickness = thickness;
  material->neo_hookean = neo_hookean;
  return material;
}

void add_speeds(const std::string& name, const Material& material, Columns& points, const std::vector<Tangents>& f,
                bool neo_hookean, KnownAnswers& all) {
  for (int first = 0; first < membrane_points; ++first) {
    for (const int last : {first + 1, membrane_points}) {
      double wave = 0, motion = 0;
      for (int p = first; p < last; ++p) {
        const Eigen::Vector3d v(0.2 * p, 0.1, -0.3 + 0.04 * p);
        for (int d = 0; d < 3; ++d) points(column::velocity, d)[p] = v[d];
        motion = std::max(motion, v.norm());
        wave = std::max(wave, wave_of(f[static_cast<std::size_t>(p)], neo_hookean));
      }
      all.push_back({name + ".fastest" + std::to_string(first) + "-" + std::to_string(last),
                     material.step_bounds(points, {first, last}, 3).fastest, wave + motion});
    }
  }
}

void add_carried(bool neo_hookean, KnownAnswers& all) {
  const std::string name = neo_hookean ? "carried.neo_hookean" : "carried";
  const auto material = membrane<CarriedMembrane>(neo_hookean);
  Columns points = make_body("points", material, membrane_points, 3).points;
  std::vector<Tangents> f;
  double energy = 0;
  for (int p = 0; p < membrane_points; ++p) {
    f.push_back(tangents_at(p));
    set_tangents(points, p, f.back());
    points(column::volume)[p] = 0.2 + 0.07 * p;
    for (int k = 0; k < 9; ++k) points(column::strain_rate, k)[p] = gradient_at(p)(k / 3, k % 3);
    energy += points(column::volume)[p] * answer_of(f.back(), neo_hookean).energy;
  }
  all.push_back({name + ".energy", material->stored_energy(points, all_points(points)), energy});
  all.push_back(
      {name + ".energy_of_one", material->stored_energy(points, {2, 3}), 0.34 * answer_of(f[2], neo_hookean).energy});
  MaterialContext context;
  context.dim = 3;
  for (const double ahead : {0.0, 0.2, -0.15}) {
    context.ahead = ahead;
    material->evaluate_stress(points, {0, 2}, context);
    material->evaluate_stress(points, {2, membrane_points}, context);
    for (int p = 0; p < membrane_points; ++p) {
      const Tangents then = f[static_cast<std::size_t>(p)] + ahead * gradient_at(p) * f[static_cast<std::size_t>(p)];
      const Eigen::Matrix3d stress = then * answer_of(then, neo_hookean).stress * then.transpose();
      for (int k = 0; k < 9; ++k) {
        all.push_back({name + ".stress" + std::to_string(k) + "." + std::to_string(p) +
                           (ahead > 0   ? ".later"
                            : ahead < 0 ? ".before"
                                        : ""),
                       points(column::stress, k)[p], stress(k / 3, k % 3)});
      }
    }
  }
  add_speeds(name, *material, points, f, neo_hookean, all);
  const std::vector<double> rates = material->rates(points, context);
  constexpr double dt = 0.07;
  double stored = 0;
  for (int p = 1; p < membrane_points; ++p) {
    const Tangents rate = gradient_at(p) * f[static_cast<std::size_t>(p)];
    const Tangents then = f[static_cast<std::size_t>(p)] + dt * rate;
    stored += points(column::volume)[p] *
              (answer_of(then, neo_hookean).energy - answer_of(f[static_cast<std::size_t>(p)], neo_hookean).energy);
    for (int k = 0; k < 6; ++k) {
      all.push_back({name + ".rate" + std::to_string(k) + "." + std::to_string(p),
                     rates[static_cast<std::size_t>(k * membrane_points + p)], rate(k % 3, k / 3)});
    }
    f[static_cast<std::size_t>(p)] = then;
  }
  all.push_back({name + ".stored", material->advance(points, {1, membrane_points}, context, dt), stored});
  for (int p = 0; p < membrane_points; ++p) {
    all.push_back({name + ".advanced" + std::to_string(p),
                   (tangents_of(points, p) - f[static_cast<std::size_t>(p)]).cwiseAbs().maxCoeff(), 0});
  }
  all.push_back({name + ".sound", 1.0 * material->first_fault(points, all_points(points)).point, -1});
  set_tangents(points, 3, (Tangents() << 1, 2, 0.5, 1, -1, -2).finished());
  all.push_back({name + ".fault", 1.0 * material->first_fault(points, all_points(points)).point, 3});
  all.push_back({name + ".no_fault", 1.0 * material->first_fault(points, {0, 3}).point, -1});
}

// Weights of places that are given: of each point those of two others and its own.
struct GivenLinks {
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(membrane_points, membrane_points), across = along;
  Eigen::MatrixXd fixed = Eigen::MatrixXd::Zero(membrane_points, 6);

  GivenLinks() {
    for (int p = 0; p < membrane_points; ++p) {
      for (int k = 0; k < 3; ++k) {
        const int q = (p + k * (k + 1)) % membrane_points;
        along(p, q) += 0.7 - 0.45 * k + 0.06 * p;
        across(p, q) += -0.5 + 0.55 * k - 0.05 * p;
      }
      for (int k = 0; k < 6; ++k) fixed(p, k) = 0.1 * (k - 2) + 0.02 * p;
    }
  }
  SurfaceNeighbours::Links links(bool transposed) const {
    SurfaceNeighbours::Links all;
    all.first.push_back(0);
    for (int p = 0; p < membrane_points; ++p) {
      for (int q = 0; q < membrane_points; ++q) {
        const int row = transposed ? q : p, other = transposed ? p : q;
        if (along(row, other) == 0 && across(row, other) == 0) continue;
        all.other.push_back(q);
        all.along.push_back(along(row, other));
        all.across.push_back(across(row, other));
      }
      all.first.push_back(static_cast<int>(all.other.size()));
    }
    return all;
  }
  Tangents of(const Eigen::MatrixXd& q, int p, bool with_fixed) const {
    Tangents f;
    f.col(0) = (along.row(p) * q).transpose();
    f.col(1) = (across.row(p) * q).transpose();
    if (with_fixed) {
      f.col(0) += fixed.row(p).head(3).transpose();
      f.col(1) += fixed.row(p).tail(3).transpose();
    }
    return f;
  }
};

void add_surface(bool with_images, bool neo_hookean, KnownAnswers& all) {
  const std::string name = std::string("surface") + (with_images ? ".images" : "") + (neo_hookean ? ".neo" : "");
  const GivenLinks given;
  const auto material = membrane<SurfaceMembrane>(neo_hookean);
  SurfaceNeighbours neighbours{given.links(false), given.links(true), {}};
  for (int k = 0; k < 6 * membrane_points && with_images; ++k) neighbours.fixed.push_back(given.fixed(k / 6, k % 6));
  material->neighbours = std::make_shared<const SurfaceNeighbours>(neighbours);
  Columns points = make_body("points", material, membrane_points, 3).points;
  points.add(column::transfer_loss);
  Eigen::MatrixXd x(membrane_points, 3), v(membrane_points, 3);
  double area = 0;
  for (int p = 0; p < membrane_points; ++p) {
    x.row(p) << 0.9 * std::cos(1.9 * p), 1.1 * std::sin(2.3 * p + 0.4), 0.8 * std::cos(3.1 * p + 1);
    v.row(p) << 0.5 * std::sin(1.3 * p + 0.2), -0.4 + 0.17 * p, 0.6 * std::cos(2.7 * p);
    points(column::volume)[p] = 0.2 + 0.07 * p;
    area += points(column::volume)[p] / thickness / membrane_points;
    for (int d = 0; d < 3; ++d) {
      points(column::position, d)[p] = x(p, d);
      points(column::strain_rate, d)[p] = v(p, d);
    }
  }
  all.push_back({name + ".spacing", material->spacing(points), std::sqrt(area), std::sqrt(area)});
  MaterialContext context;
  context.dim = 3;
  std::vector<Tangents> pulls;
  for (const double ahead : {0.3, 0.0}) {
    context.ahead = ahead;
    material->prepare_stress(points, {0, 2}, context);
    material->prepare_stress(points, {2, membrane_points}, context);
    material->evaluate_stress(points, all_points(points), context);
    pulls.clear();
    for (int p = 0; p < membrane_points; ++p) {
      const Tangents f = given.of(x + ahead * v, p, with_images);
      pulls.push_back(points(column::volume)[p] * f * answer_of(f, neo_hookean).stress);
      all.push_back({name + ".tangents" + std::to_string(p) + (ahead > 0 ? ".later" : ""),
                     (tangents_of(points, p) - f).norm(), 0});
    }
    for (int p = 0; p < membrane_points; ++p) {
      Eigen::Vector3d force = Eigen::Vector3d::Zero();
      double size = 1;
      for (int q = 0; q < membrane_points; ++q) {
        const Tangents& pull = pulls[static_cast<std::size_t>(q)];
        size = std::max(size, pull.norm() / points(column::volume)[p]);
        force -= given.along(q, p) * pull.col(0) + given.across(q, p) * pull.col(1);
      }
      for (int d = 0; d < 3; ++d) {
        const double stress = -force[d] / points(column::volume)[p];
        all.push_back({name + ".force" + std::to_string(d) + "." + std::to_string(p) + (ahead > 0 ? ".later" : ""),
                       points(column::stress, d)[p], stress, size});
      }
    }
  }
  std::vector<Tangents> f;
  for (int p = 0; p < membrane_points; ++p) f.push_back(given.of(x, p, with_images));
  add_speeds(name, *material, points, f, neo_hookean, all);
  // The power of what points pull with is the rate of their energy, and the loss what of it the stored energy does not show.
  const std::vector<double> rates = material->rates(points, context);
  constexpr double dt = 0.06;
  double stored = 0, kept = 0;
  for (int p = 0; p < membrane_points; ++p) points(column::surface_energy)[p] = 0.01 * p - 0.3;
  std::vector<double> energy, loss;
  for (int p = 0; p < membrane_points; ++p) {
    const double power = pulls[static_cast<std::size_t>(p)].cwiseProduct(given.of(v, p, false)).sum();
    energy.push_back(points(column::volume)[p] * answer_of(f[static_cast<std::size_t>(p)], neo_hookean).energy);
    loss.push_back(dt * power - (energy.back() - (0.01 * p - 0.3)));
    if (p > 0) stored += energy.back() - (0.01 * p - 0.3);
    if (p > 0) kept += energy.back();
    all.push_back({name + ".power" + std::to_string(p), rates[static_cast<std::size_t>(p)], power,
                   std::max(1.0, pulls[static_cast<std::size_t>(p)].norm())});
  }
  const double size = std::max(1.0, kept);
  all.push_back({name + ".stored", material->advance(points, {1, membrane_points}, context, dt), stored, size});
  all.push_back({name + ".kept", material->stored_energy(points, {1, membrane_points}), kept, size});
  for (int p = 1; p < membrane_points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    all.push_back({name + ".loss" + std::to_string(p), points(column::transfer_loss)[p], loss[at], size});
  }
  material->describe(points);
  for (int p = 0; p < membrane_points; ++p) {
    all.push_back({name + ".described" + std::to_string(p), points(column::surface_energy)[p],
                   energy[static_cast<std::size_t>(p)], size});
  }
  all.push_back({name + ".sound", 1.0 * material->first_fault(points, all_points(points)).point, -1});
  set_tangents(points, 3, (Tangents() << 1, 2, 0.5, 1, -1, -2).finished());
  all.push_back({name + ".flat", 1.0 * material->first_fault(points, all_points(points)).point, 3});
  points(column::surface_energy)[4] = std::nan("");
  all.push_back({name + ".fault", 1.0 * material->first_fault(points, all_points(points)).point, 4});
}

}  // namespace

KnownAnswers membrane_answers() {
  KnownAnswers all;
  for (const bool neo_hookean : {false, true}) {
    add_carried(neo_hookean, all);
    for (const bool with_images : {false, true}) add_surface(with_images, neo_hookean, all);
  }
  return all;
}

}  // namespace plumbline::kernel_functions::membranes_trial
