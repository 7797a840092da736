// Points of each material along paths of deformation whose stresses and energies are known in closed form.
#include <Eigen/Dense>
#include <cmath>
#include <memory>

#include "cases/catalog/estimators/known_answers.hpp"
#include "cases/harness/parts/material_probe.hpp"
#include "cases/harness/parts/shape_probe.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/surface_law.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline::strain_paths {
namespace {

using Tensor = Eigen::Matrix3d;

constexpr double youngs_modulus = 1.5, poissons_ratio = 0.3, rest_density = 1.25;  // Pa, 1, kg/m^3
constexpr double lambda = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
constexpr double shear = youngs_modulus / (2 * (1 + poissons_ratio)), bulk = lambda + 2 * shear / 3;
constexpr double dt = 0.01;
constexpr int path_steps = 20;

// What of a tensor in space a geometry has: rows and columns of its directions, and the hoop's.
struct GeometryOfPath {
  std::size_t number;
  const std::string& name() const { return geometry_names()[number]; }
  int dim() const { return number == 0 ? 1 : number == 3 ? 3 : 2; }
  bool rings() const { return number == 2; }
  Tensor of(const Tensor& all) const {
    Tensor own = Tensor::Zero();
    own.topLeftCorner(dim(), dim()) = all.topLeftCorner(dim(), dim());
    if (rings()) own(2, 2) = all(2, 2);
    return own;
  }
  Straining rate(const Tensor& gradient) const {
    return {gradient.topLeftCorner(dim(), dim()), rings() ? gradient(2, 2) : 0};
  }
};

const Tensor any_gradient = (Tensor() << 0.7, -0.9, 0.4, 0.5, -0.6, 0.8, -0.3, 0.2, 0.45).finished();  // 1/s

MaterialProbe along(MaterialProbe probe, const Straining& rate, int steps = path_steps) {
  for (int k = 0; k < steps; ++k) probe = probe.strained(rate, dt);
  return probe;
}

void add_stress(const std::string& name, const MaterialProbe& probe, const GeometryOfPath& geometry,
                const Tensor& exact, int p, KnownAnswers& all) {
  const double size = exact.norm();
  const double off = (probe.stress(p) - exact.topLeftCorner(geometry.dim(), geometry.dim())).norm();
  all.push_back({name + ".stress/" + geometry.name(), off, 0, size});
  if (geometry.rings()) all.push_back({name + ".hoop/" + geometry.name(), probe.hoop_stress(p), exact(2, 2), size});
}

// W = mu/2 (F : F - d - 2 ln J) + lambda/2 (ln J)^2 under F = (1 + dt L)^n; the speed along stretches in the axes.
KnownAnswers neo_hookean() {
  KnownAnswers all;
  const auto material = std::make_shared<NeoHookean>();
  material->youngs_modulus = youngs_modulus;
  material->poissons_ratio = poissons_ratio;
  material->density = rest_density;
  for (std::size_t number = 0; number < geometry_names().size(); ++number) {
    const GeometryOfPath geometry{number};
    const Tensor gradient = geometry.of(any_gradient), step = Tensor::Identity() + dt * gradient;
    Tensor f = Tensor::Identity();
    for (int k = 0; k < path_steps; ++k) f = step * f;
    const double j = f.determinant(), log_j = std::log(j);
    const Tensor stress = (shear * (f * f.transpose() - Tensor::Identity()) + lambda * log_j * Tensor::Identity()) / j;
    const double energy = shear / 2 * (f.squaredNorm() - 3 - 2 * log_j) + lambda / 2 * log_j * log_j;
    const MaterialProbe start(material, number, rest_density), end = along(start, geometry.rate(gradient));
    for (const int p : {0, end.count() - 1}) {
      const std::string name = "point." + std::to_string(p);
      add_stress(name, end, geometry, geometry.of(stress), p, all);
      all.push_back({name + ".energy/" + geometry.name(), end.energy(p) / start.volume(p), energy, energy});
      all.push_back({name + ".density/" + geometry.name(), end.density(p), rest_density / j, rest_density});
    }
    const Tensor stretching = geometry.of(Eigen::Vector3d(0.8, -0.5, 0.3).asDiagonal().toDenseMatrix());
    const MaterialProbe stretched = along(start, geometry.rate(stretching));
    const double largest = std::pow(1 + dt * 0.8, 2 * path_steps);
    const double log_stretched = path_steps * std::log((Tensor::Identity() + dt * stretching).determinant());
    all.push_back({"speed/" + geometry.name(), stretched.fastest(0),
                   std::sqrt((shear * (largest + 1) + lambda * (1 - log_stretched)) / rest_density)});
  }
  return all;
}

// sigma = lambda tr eps + 2 mu eps of strains that add up; on a line E eps; without stress out of a plane another lambda.
KnownAnswers hooke() {
  KnownAnswers all;
  for (std::size_t number = 0; number < geometry_names().size(); ++number) {
    for (const bool plane_stress : {false, true}) {
      if (plane_stress && number != 1) continue;
      const GeometryOfPath geometry{number};
      const auto material = std::make_shared<LinearElastic>();
      material->youngs_modulus = youngs_modulus;
      material->poissons_ratio = poissons_ratio;
      material->density = rest_density;
      material->plane_stress = plane_stress;
      const double first = number == 0 ? 0 : plane_stress ? 2 * lambda * shear / (lambda + 2 * shear) : lambda;
      const double second = number == 0 ? youngs_modulus / 2 : shear;
      const Tensor gradient = geometry.of(any_gradient);
      const Tensor strain = path_steps * dt * (gradient + gradient.transpose()) / 2;
      const Tensor stress = first * strain.trace() * Tensor::Identity() + 2 * second * strain;
      const double energy = first / 2 * strain.trace() * strain.trace() + second * strain.squaredNorm();
      const MaterialProbe start(material, number, rest_density), end = along(start, geometry.rate(gradient));
      const std::string name = plane_stress ? "plane_stress" : "hooke";
      add_stress(name, end, geometry, geometry.of(stress), 3, all);
      all.push_back({name + ".energy/" + geometry.name(), end.energy(3) / start.volume(3), energy, energy});
      all.push_back(
          {name + ".speed/" + geometry.name(), end.fastest(3), std::sqrt((first + 2 * second) / rest_density)});
    }
  }
  return all;
}

// Of stretches in fixed directions that grow in proportion, in logarithms, the return to the yield surface is a scalar's: the
// equivalent strain x is elastic up to Y/(3 G), then of each part beyond 3 G/(3 G + H) is plastic; the way back begins at what
// was reached, with the yield stress that hardening has left.
struct ScalarFlow {
  double yield, hardening;
  double flowed = 0, plastic = 0;  // along the path, with its sign; and in all
  double stress(double x) const { return 3 * shear * (x - flowed); }
  void to(double x) {
    const double beyond = std::abs(stress(x)) - yield - hardening * plastic;
    if (beyond <= 0) return;
    const double more = beyond / (3 * shear + hardening);
    flowed += std::copysign(more, stress(x));
    plastic += more;
  }
};

KnownAnswers plasticity() {
  KnownAnswers all;
  constexpr double yield = 0.06, hardening = 0.4;
  const auto material = std::make_shared<J2Plasticity>();
  material->youngs_modulus = youngs_modulus;
  material->poissons_ratio = poissons_ratio;
  material->density = rest_density;
  material->yield_stress = yield;
  material->hardening_modulus = hardening;
  const Eigen::Vector3d rates(0.9, -0.5, 0.2);
  const Eigen::AngleAxisd turned(0.6, Eigen::Vector3d(1, 2, 3).normalized());
  for (std::size_t number = 0; number < geometry_names().size(); ++number) {
    const GeometryOfPath geometry{number};
    Tensor axes = Tensor::Identity();
    if (number == 3) axes = turned.toRotationMatrix();
    if (number == 1 || number == 2) axes = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    // What a geometry does not have, does not stretch.
    const Eigen::Vector3d own = geometry.of(rates.asDiagonal().toDenseMatrix()).diagonal();
    const Eigen::Vector3d back = -own.cwiseQuotient(Eigen::Vector3d::Ones() + dt * own);  // undoes a step
    const auto rate_of = [&](const Eigen::Vector3d& r) {
      return geometry.rate(axes * r.asDiagonal() * axes.transpose());
    };
    const Eigen::Vector3d log_step = (dt * own).array().log1p();
    const Eigen::Vector3d deviator = log_step.array() - log_step.mean();
    const double x_step = std::sqrt(2.0 / 3) * deviator.norm();
    ScalarFlow flow{yield, hardening};
    const MaterialProbe start(material, number, rest_density);
    MaterialProbe probe = start;
    int done = 0;
    // Elastic; flowing; back within the yield surface; flowing back, past the start; and forwards once more.
    for (const int steps : {4, 16, -5, -35, 40}) {
      probe = along(std::move(probe), rate_of(steps > 0 ? own : back), std::abs(steps));
      done += steps;
      flow.to(done * x_step);
      const double q = flow.stress(done * x_step), log_j = done * log_step.sum(), j = std::exp(log_j);
      const Eigen::Vector3d principal = Eigen::Vector3d::Constant(bulk * log_j) +
                                        std::sqrt(2.0 / 3) * q * deviator.normalized();
      const Tensor stress = axes * principal.asDiagonal() * axes.transpose() / j;
      const double elastic = bulk / 2 * log_j * log_j + q * q / (6 * shear);
      const double kept = hardening / 2 * flow.plastic * flow.plastic, heat = yield * flow.plastic;
      const std::string name = "after." + std::to_string(all.size());
      add_stress(name, probe, geometry, geometry.of(stress), 2, all);
      all.push_back({name + ".plastic/" + geometry.name(), probe.points()(column::plastic_strain)[2], flow.plastic});
      all.push_back({name + ".energy/" + geometry.name(), probe.energy(2) / start.volume(2), elastic + kept + heat});
      all.push_back(
          {name + ".heat/" + geometry.name(), material->heat(probe.points(), {2, 3}) / start.volume(2), heat});
      all.push_back({name + ".density/" + geometry.name(), probe.density(2), rest_density / j, rest_density});
    }
  }
  return all;
}

// sigma = 2 mu (D - tr D/3) - (p + q), p = (gamma - 1) rho e, q of compression alone. [York 4.1, 4.4, 4.11]
KnownAnswers gas() {
  KnownAnswers all;
  const auto material = std::make_shared<IdealGas>();
  material->gamma = 1.6;
  material->viscosity = 0.3;
  material->viscosity_linear = 0.4;
  material->viscosity_quadratic = 1.5;
  for (std::size_t number = 0; number < geometry_names().size(); ++number) {
    const GeometryOfPath geometry{number};
    for (const double sign : {1.0, -1.0}) {
      const Tensor gradient = sign * geometry.of(any_gradient), rate = (gradient + gradient.transpose()) / 2;
      MaterialProbe probe(material, number, rest_density);
      probe.set_rate(geometry.rate(gradient));
      probe.evaluate();
      for (const int p : {1, 6}) {
        const double energy = 1 + 0.2 * p, pressure = 0.6 * rest_density * energy,
                     sound = std::sqrt(1.6 * 0.6 * energy);
        const double closing = std::max(0.0, -rate.trace()), h = probe.context().h;
        const double q = rest_density * (0.4 * sound * h * closing + 1.5 * h * h * closing * closing);
        const Tensor stress = 2 * 0.3 * (rate - rate.trace() / 3 * Tensor::Identity()) -
                              (pressure + q) * Tensor::Identity();
        const std::string name = (sign > 0 ? "opens." : "closes.") + std::to_string(p);
        add_stress(name, probe, geometry, geometry.of(stress), p, all);
        all.push_back({name + ".pressure/" + geometry.name(), probe.points()(column::pressure)[p], pressure});
      }
    }
  }
  return all;
}

// Along tangents: sigma = E eps t t, of the strain t . D t dt of one step, none of a slack one that is one-way. [York 5.2, 5.5]
KnownAnswers tangents() {
  KnownAnswers all;
  const auto two_way = std::make_shared<UniaxialMembrane>(), one_way = std::make_shared<UniaxialMembrane>();
  const auto wide = std::make_shared<PlaneStressMembrane>();
  wide->poissons_ratio = poissons_ratio;
  for (UniaxialMembrane* const one : {two_way.get(), one_way.get(), static_cast<UniaxialMembrane*>(wide.get())}) {
    one->youngs_modulus = youngs_modulus;
    one->density = rest_density;
    one->one_way = one == one_way.get();
  }
  const Eigen::Matrix2d gradient = any_gradient.topLeftCorner(2, 2);
  const std::pair<const char*, std::shared_ptr<const Material>> materials[] = {
      {"two_way", two_way}, {"one_way", one_way}, {"wide", wide}};
  for (const auto& [name, material] : materials) {
    const double modulus = youngs_modulus / (name == std::string("wide") ? 1 - poissons_ratio * poissons_ratio : 1);
    const MaterialProbe start(material, 1, rest_density), end = start.strained({gradient, 0}, dt);
    for (int p = 0; p < end.count(); ++p) {
      const Eigen::Vector2d before(std::cos(p), std::sin(p)), after = (before + dt * gradient * before).normalized();
      double strain = dt * before.dot(gradient * before);
      if (name == std::string("one_way")) strain = std::max(strain, 0.0);
      const std::string at = std::string(name) + "." + std::to_string(p);
      const double off = (end.stress(p) - modulus * strain * after * after.transpose()).norm();
      all.push_back({at + ".stress", off, 0, modulus * dt});
      all.push_back(
          {at + ".energy", end.energy(p) / start.volume(p), modulus * strain * strain / 2, modulus * dt * dt});
    }
  }
  return all;
}

// Membranes in space, of the metric c of their tangents: S = 2 dW/dc, and the principal values of S c over the root of det c.
Eigen::Matrix2d matrix_of(double first, double mixed, double second) {
  return (Eigen::Matrix2d() << first, mixed, mixed, second).finished();
}

KnownAnswers surfaces() {
  KnownAnswers all;
  const auto add = [&](const std::string& name, const SurfaceLaw& law, const Eigen::Matrix2d& c, double energy,
                       const Eigen::Matrix2d& s) {
    const SurfaceLaw::Metric metric{c(0, 0), c(0, 1), c(1, 1)};
    const SurfaceLaw::State found = law.state(metric);
    all.push_back({name + ".energy", found.energy, energy});
    all.push_back({name + ".stress", (matrix_of(found.first, found.mixed, found.second) - s).norm(), 0});
    const Eigen::EigenSolver<Eigen::Matrix2d> solver(s * c / std::sqrt(c.determinant()));
    const Eigen::Vector2d values = solver.eigenvalues().real();
    const SurfaceLaw::Stresses principal = law.principal_stresses(metric);
    all.push_back({name + ".largest", principal.largest, values.maxCoeff()});
    all.push_back({name + ".least", principal.least, values.minCoeff()});
  };
  SurfaceLaw law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.density = rest_density;
  law.thickness = 0.01;
  const double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  // Taut, wrinkled along two axes, and slack.
  const Eigen::Matrix2d metrics[] = {matrix_of(1.4, 0.1, 1.2), matrix_of(1.4, 0.2, 0.6), matrix_of(0.7, -0.1, 1.3),
                                     matrix_of(0.8, 0.05, 0.7)};
  for (std::size_t k = 0; k < std::size(metrics); ++k) {
    const Eigen::Matrix2d c = metrics[k], e = (c - Eigen::Matrix2d::Identity()) / 2;
    const std::string at = "." + std::to_string(k);
    const double trace = e.trace();
    const Eigen::Matrix2d linear = plane *
                                   ((1 - poissons_ratio) * e + poissons_ratio * trace * Eigen::Matrix2d::Identity());
    const double energy = plane / 2 * ((1 - poissons_ratio) * e.squaredNorm() + poissons_ratio * trace * trace);
    law.one_way = law.neo_hookean = false;
    add("linear" + at, law, c, energy, linear);
    law.one_way = true;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> strains(e);
    const double least = strains.eigenvalues()[0], largest = strains.eigenvalues()[1];
    const Eigen::Vector2d axis = strains.eigenvectors().col(1);
    if (largest <= 0) {
      add("slack" + at, law, c, 0, Eigen::Matrix2d::Zero());
    } else if (least + poissons_ratio * largest <= 0) {
      add("wrinkled" + at, law, c, youngs_modulus / 2 * largest * largest,
          youngs_modulus * largest * axis * axis.transpose());
    } else {
      add("taut" + at, law, c, energy, linear);
    }
    law.one_way = false;
    law.neo_hookean = true;
    const double mu = youngs_modulus / 3, determinant = c.determinant();
    add("neo_hookean" + at, law, c, mu / 2 * (c.trace() + 1 / determinant - 3),
        mu * (Eigen::Matrix2d::Identity() - c.inverse() / determinant));
  }
  return all;
}

const std::vector<KnownTrial> all_paths{
    {"neo-hookean", "compressible neo-Hookean solids", "Powers of one increment are the deformation.", neo_hookean,
     few_roundings, rounded},
    {"hooke", "Hooke's law of small strains", "Strains add up.", hooke, few_roundings, rounded},
    {"plasticity", "von Mises solids, there and back", "In proportion the return is a scalar's.", plasticity,
     few_roundings, rounded},
    {"gas", "ideal gas that opens and closes", "Viscous and artificial stresses of one rate.", gas, few_roundings,
     rounded},
    {"tangents", "layers that carry stress along a tangent", "One step, and the tangent that it turns.", tangents,
     few_roundings, rounded},
    {"surfaces", "laws of membranes in space", "Energies of metrics: taut, wrinkled, slack.", surfaces, few_roundings,
     rounded}};

Case strain_paths() { return known_answers_case("strain-paths", all_paths); }
PLUMBLINE_CASE(strain_paths);

}  // namespace
}  // namespace plumbline::strain_paths
