// Speeds and diffusivities by which materials bound the step: of waves along principal axes in closed form, of others by the row
// sums that bound them, and never below the eigenvalues of the acoustic tensor.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/points/body.hpp"
#include "kernel/shapes/reference_columns.hpp"

namespace plumbline::kernel_functions::speeds_trial {
namespace {

using Tensor = Eigen::Matrix3d;

constexpr double modulus = 1.7, ratio = 0.28, rest_density = 1.3;  // Pa, 1, kg/m^3
constexpr double first_lame = modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)), shear = modulus / (2 * (1 + ratio));

struct Space {
  const char* name;
  int dim;
  bool rings;
  // What of a tensor the geometry has; elsewhere it is one, or zero.
  Tensor of(const Tensor& all, double elsewhere) const {
    Tensor own = elsewhere * Tensor::Identity();
    own.topLeftCorner(dim, dim) = all.topLeftCorner(dim, dim);
    if (rings) own(2, 2) = all(2, 2);
    return own;
  }
};
constexpr Space spaces[] = {{"line", 1, false}, {"plane", 2, false}, {"rings", 2, true}, {"space", 3, false}};

// Component (i, j) of a tensor at point p: row by row, then the hoop's.
void set_full(Columns& points, const ColumnId& id, const Space& space, int p, const Tensor& value) {
  for (int k = 0; k < space.dim * space.dim; ++k) points(id, k)[p] = value(k / space.dim, k % space.dim);
  if (space.rings) points(id, 4)[p] = value(2, 2);
}

double row_sum(const Tensor& a) { return a.cwiseAbs().rowwise().sum().maxCoeff(); }

// Of motion: no two points are as fast, and none moves along an axis.
double set_velocity(Columns& points, const Space& space, int p) {
  const double along[] = {0.3 - 0.05 * p, 0.2 + 0.11 * ((3 * p) % 7), -0.17 + 0.02 * p};
  double square = 0;
  for (int d = 0; d < space.dim; ++d) {
    points(column::velocity, d)[p] = along[d];
    square += along[d] * along[d];
  }
  return std::sqrt(square);
}

// Of each point, and of ranges that end within a pack of points: the fastest wave and the fastest point, which may be two.
void add_ranges(const std::string& name, const Material& material, const Columns& points, int dim,
                const std::vector<double>& wave, const std::vector<double>& motion, KnownAnswers& all) {
  const int n = points.points();
  for (int first = 0; first < n; ++first) {
    for (const int last : {first + 1, n - 1, n}) {
      if (last <= first) continue;
      double fastest = 0, moving = 0;
      for (int p = first; p < last; ++p) {
        fastest = std::max(fastest, wave[static_cast<std::size_t>(p)]);
        moving = std::max(moving, motion[static_cast<std::size_t>(p)]);
      }
      all.push_back({name + "." + std::to_string(first) + "-" + std::to_string(last),
                     material.step_bounds(points, {first, last}, dim).fastest, fastest + moving});
    }
  }
}

// Without symmetry, and of volumes of which some are more than e times, but less than 1.02 e times those at rest.
std::vector<Tensor> deformations(const Space& space) {
  const Tensor bent = (Tensor() << 1.1, 0.35, -0.2, -0.25, 0.8, 0.3, 0.15, -0.4, 1.3).finished();
  std::vector<Tensor> all;
  for (int k = 0; k < 7; ++k) {
    const Eigen::AngleAxisd turn(0.4 * k, Eigen::Vector3d(1, -2, 0.5 * k).normalized());
    Tensor f = bent;
    f.row(k % 3) *= 1 + 0.1 * k;
    f.col((k + 1) % 3) *= 1.2 - 0.08 * k;
    if (space.dim == 3) f = (turn.toRotationMatrix() * f).eval();
    f = space.of(f, 1);
    const double wanted[] = {0.6, 0.9, 1.3, std::exp(0.97), std::exp(1.008), 3.4, 0.75};
    const int sides = space.dim + (space.rings ? 1 : 0);
    const double widened = std::pow(wanted[k] / std::abs(f.determinant()), 1.0 / sides);
    all.push_back(space.of(widened * f, 1));
  }
  return all;
}

// rho_0 times the squares of the speeds of waves along n: mu |F^T n|^2 1 + (mu + lambda (1 - ln J)) n n^T.
double fastest_of(const Tensor& f, const Space& space, int directions) {
  double largest = 0;
  const double log_j = std::log(f.determinant());
  for (int k = 0; k < directions; ++k) {
    Eigen::Vector3d n(std::cos(2.4 * k), std::sin(2.4 * k), space.dim == 3 ? 1 - 2.0 * k / directions : 0);
    if (space.dim == 1) n = Eigen::Vector3d::UnitX();
    n.normalize();
    const Tensor acoustic = shear * (f.transpose() * n).squaredNorm() * Tensor::Identity() +
                            (shear + first_lame * (1 - log_j)) * n * n.transpose();
    largest = std::max(largest, Eigen::SelfAdjointEigenSolver<Tensor>(acoustic).eigenvalues().maxCoeff());
  }
  return largest;
}

std::shared_ptr<NeoHookean> neo_hookean() {
  const auto material = std::make_shared<NeoHookean>();
  material->youngs_modulus = modulus;
  material->poissons_ratio = ratio;
  material->density = rest_density;
  return material;
}

void add_neo_hookean(KnownAnswers& all) {
  const auto material = neo_hookean();
  for (const Space& space : spaces) {
    const std::vector<Tensor> fs = deformations(space);
    const int n = static_cast<int>(fs.size());
    Columns points = make_body("points", material, n, space.dim, space.rings).points;
    std::vector<double> wave, motion;
    for (int p = 0; p < n; ++p) {
      const Tensor& f = fs[static_cast<std::size_t>(p)];
      set_full(points, column::deformation, space, p, f);
      motion.push_back(set_velocity(points, space, p));
      const double log_j = std::log(f.determinant()), bulk = log_j < 1 ? first_lame * (1 - log_j) : 0;
      // Directions in which nothing stretches have none of the stiffness.
      const double square = row_sum(space.of(f * f.transpose(), 0));
      wave.push_back(std::sqrt((shear * (square + 1) + bulk) / rest_density));
      all.push_back(yes(std::string("neo_hookean.bound.") + space.name + std::to_string(p),
                        rest_density * std::pow(wave.back(), 2) >= (1 - 1e-12) * fastest_of(f, space, 200)));
    }
    add_ranges(std::string("neo_hookean.") + space.name, *material, points, space.dim, wave, motion, all);
    // The same points, of which weights are those of a start in which they were strained already.
    points.add(column::position_at_start, space.dim);
    points.add(column::deformation_at_start, points.components(column::deformation));
    for (int p = 0; p < n; ++p) {
      const Tensor &f = fs[static_cast<std::size_t>(p)], start = fs[static_cast<std::size_t>((p + 3) % n)];
      set_full(points, column::deformation_at_start, space, p, start);
      const double log_j = std::log(f.determinant()), bulk = log_j < 1 ? first_lame * (1 - log_j) : 0;
      const Tensor back = start * f.inverse();
      wave[static_cast<std::size_t>(p)] = std::sqrt((shear * row_sum(space.of(start * start.transpose(), 0)) +
                                                     (shear + bulk) * row_sum(space.of(back * back.transpose(), 0))) /
                                                    rest_density);
    }
    add_ranges(std::string("neo_hookean.start.") + space.name, *material, points, space.dim, wave, motion, all);
    const RestState rest = material->rest(space.dim).value();
    all.push_back({std::string("neo_hookean.rest.") + space.name, rest.modulus, first_lame + 2 * shear});
    all.push_back({std::string("neo_hookean.density.") + space.name, rest.density, rest_density});
  }
  // Along principal axes the bound is the speed itself: each axis in turn has the longest stretch, the hoop's among them.
  for (const Space& space : spaces) {
    for (int longest = 0; longest < (space.rings ? 3 : space.dim); ++longest) {
      Eigen::Vector3d stretch(1.1, 0.9, 1.05);
      stretch[longest] = 1.45;
      const Tensor f = space.of(stretch.asDiagonal().toDenseMatrix(), 1);
      Columns points = make_body("points", material, 2, space.dim, space.rings).points;
      set_full(points, column::deformation, space, 1, f);
      const double log_j = std::log(f.determinant());
      const double exact = std::sqrt((shear * (1 + 1.45 * 1.45) + first_lame * (1 - log_j)) / rest_density);
      all.push_back({std::string("principal.") + space.name + std::to_string(longest),
                     material->step_bounds(points, {1, 2}, space.dim).fastest, exact});
    }
  }
}

void add_hooke(KnownAnswers& all) {
  for (const Space& space : spaces) {
    for (const bool plane_stress : {false, true}) {
      LinearElastic material;
      material.youngs_modulus = modulus;
      material.poissons_ratio = ratio;
      material.density = rest_density;
      material.plane_stress = plane_stress;
      Columns points = make_body("points", std::make_shared<LinearElastic>(material), 5, space.dim, space.rings).points;
      std::vector<double> motion;
      for (int p = 0; p < 5; ++p) motion.push_back(set_velocity(points, space, p));
      const bool sheet = plane_stress && space.dim == 2 && !space.rings;
      const double stiff = space.dim == 1 ? modulus
                           : sheet        ? modulus / (1 - ratio * ratio)
                                          : modulus * (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio));
      const double speed = std::sqrt(stiff / rest_density);
      const std::string name = (plane_stress ? "sheet." : "hooke.") + std::string(space.name);
      add_ranges(name, material, points, space.dim, std::vector<double>(5, speed), motion, all);
      if (space.rings) continue;
      all.push_back({name + ".wave", material.wave_speed(space.dim), speed});
      all.push_back({name + ".rest", material.rest(space.dim).value().modulus, stiff});
      all.push_back({name + ".density", material.rest(space.dim).value().density, rest_density});
    }
  }
}

// tau = lambda tr eps + 2 G eps of the elastic strain: sqrt((lambda + 2 G + 2 s) / rho_0), s its largest row sum.
void add_plastic(KnownAnswers& all) {
  const auto material = std::make_shared<J2Plasticity>();
  material->youngs_modulus = modulus;
  material->poissons_ratio = ratio;
  material->density = rest_density;
  material->yield_stress = 0.2;
  material->hardening_modulus = 0.3;
  // Of xx, yy, zz, then yz, zx, xy; in the plane xy alone.
  const double strain[] = {0.11, -0.07, 0.05, 0.03, -0.045, 0.06};
  for (const Space& space : spaces) {
    constexpr int n = 6;
    Columns points = make_body("points", material, n, space.dim, space.rings).points;
    std::vector<double> wave, motion;
    for (int p = 0; p < n; ++p) {
      Tensor eps = Tensor::Zero();
      const double size = (p % 2 == 0 ? 1 : -1) * (0.4 + 0.17 * ((5 * p) % n));
      const auto e = [&](int k) { return size * strain[(k + p) % 3 + k / 3 * 3]; };
      for (int k = 0; k < 3; ++k) points(column::elastic_strain, k)[p] = eps(k, k) = e(k);
      if (space.dim == 2) points(column::elastic_strain, 3)[p] = eps(0, 1) = eps(1, 0) = e(5);
      for (int k = 3; k < 6 && space.dim == 3; ++k) {
        const int i = k == 3 ? 1 : 0, j = k == 5 ? 1 : 2;
        points(column::elastic_strain, k)[p] = eps(i, j) = eps(j, i) = e(k);
      }
      const Tensor tau = first_lame * eps.trace() * Tensor::Identity() + 2 * shear * eps;
      wave.push_back(std::sqrt((first_lame + 2 * shear + 2 * row_sum(tau)) / rest_density));
      motion.push_back(set_velocity(points, space, p));
    }
    add_ranges(std::string("plastic.") + space.name, *material, points, space.dim, wave, motion, all);
    all.push_back(
        {std::string("plastic.rest.") + space.name, material->rest(space.dim).value().modulus, first_lame + 2 * shear});
    all.push_back(
        {std::string("plastic.density.") + space.name, material->rest(space.dim).value().density, rest_density});
  }
}

// c = sqrt(gamma (gamma - 1) e), of one point with its own motion, and 4/3 mu over the least density.
void add_gas(KnownAnswers& all) {
  for (const double viscosity : {0.0, 0.35}) {
    const auto material = std::make_shared<IdealGas>();
    material->gamma = 1.63;
    material->viscosity = viscosity;
    for (const Space& space : spaces) {
      constexpr int n = 7;
      Columns points = make_body("points", material, n, space.dim, space.rings).points;
      std::vector<double> signal, density;
      for (int p = 0; p < n; ++p) {
        const double e = 0.9 + 0.2 * ((4 * p) % n);
        density.push_back(1.5 - 0.13 * ((3 * p) % n));
        points(column::energy)[p] = e;
        points(column::volume)[p] = 0.4 + 0.07 * p;
        points(column::mass)[p] = density.back() * points(column::volume)[p];
        signal.push_back(std::sqrt(1.63 * 0.63 * e) + set_velocity(points, space, p));
      }
      for (int first = 0; first < n; ++first) {
        for (const int last : {first + 1, n}) {
          double fastest = 0, least = std::numeric_limits<double>::infinity();
          for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p) {
            fastest = std::max(fastest, signal[p]);
            least = std::min(least, density[p]);
          }
          const StepBounds found = material->step_bounds(points, {first, last}, space.dim);
          const std::string at = std::string(viscosity > 0 ? "viscous." : "gas.") + space.name + "." +
                                 std::to_string(first) + "-" + std::to_string(last);
          all.push_back({at + ".fastest", found.fastest, fastest});
          all.push_back({at + ".diffusivity", found.diffusivity, 4 * viscosity / (3 * least)});
        }
      }
      points(column::energy)[2] = std::numeric_limits<double>::quiet_NaN();
      all.push_back(yes("nan.gas", std::isnan(material->step_bounds(points, {0, n}, space.dim).fastest)));
      all.push_back(no("nan.gas_beside", std::isnan(material->step_bounds(points, {3, n}, space.dim).fastest)));
    }
  }
}

void add_bounds(KnownAnswers& all) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  StepBounds bounds{2, 0.5};
  bounds.include({1.5, 0.7});
  all.push_back({"include.kept", bounds.fastest, 2});
  all.push_back({"include.taken", bounds.diffusivity, 0.7});
  bounds.include({2.5, 0.6});
  all.push_back({"include.faster", bounds.fastest, 2.5});
  all.push_back({"include.less", bounds.diffusivity, 0.7});
  bounds.include({none, 0.1});
  all.push_back(yes("include.nan", std::isnan(bounds.fastest)));
  bounds.include({4, none});
  all.push_back(yes("include.nan_stays", std::isnan(bounds.fastest) && std::isnan(bounds.diffusivity)));
  Columns points(7);
  points.add(column::velocity, 2);
  for (int p = 0; p < 7; ++p) set_velocity(points, spaces[1], p);
  points(column::velocity, 1)[5] = none;
  all.push_back(yes("nan.point", std::isnan(fastest_point(points, {1, 7}, 2))));
  all.push_back(no("nan.before", std::isnan(fastest_point(points, {1, 5}, 2))));
}

}  // namespace

KnownAnswers speed_answers() {
  KnownAnswers all;
  add_neo_hookean(all);
  add_hooke(all);
  add_plastic(all);
  add_gas(all);
  add_bounds(all);
  return all;
}

}  // namespace plumbline::kernel_functions::speeds_trial
