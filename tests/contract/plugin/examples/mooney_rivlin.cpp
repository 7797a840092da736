// A material outside the repository: compressible Mooney-Rivlin, strains finite; without strain in the directions that a scene
// lacks. With I_1 = tr C, I_2 = (I_1^2 - tr C^2) / 2, C = F^T F:
//   W = c (J - 1)^2 - 2 (c_1 + 2 c_2) ln J + c_1 (I_1 - 3) + c_2 (I_2 - 3)
//   P = 2 c_1 F + 2 c_2 (I_1 F - F C) + (2 c J (J - 1) - 2 (c_1 + 2 c_2)) F^-T
// (Holzapfel, Nonlinear Solid Mechanics, 2000, (6.147)). For small strains it is Hooke's law with mu = 2 (c_1 + c_2) and
// lambda = 2 c + 4 c_2.
#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <vector>

#include "kernel/materials/elastic.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"

namespace {

using namespace plumbline;
using Matrix = Eigen::Matrix3d;

struct MooneyRivlin final : Material {
  double youngs_modulus = 1, poissons_ratio = 0.3, density = 1;  // Pa; 1; kg/m^3
  double share = 0.5;                                            // c_2 / (c_1 + c_2), [0, 1]

  std::string name() const override { return "mooney_rivlin"; }
  StressMeasure measure() const override { return StressMeasure::full; }
  Store store() const override { return Store::elastic; }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override {
    return {&column::deformation};
  }

  void add_columns(Columns& points, int) const override {
    points.add(column::deformation, points.components(column::stress));
    for (int p = 0; p < points.points(); ++p) write(points, column::deformation, p, Matrix::Identity());
  }

  double advance(Columns& points, PointRange range, const MaterialContext&, double dt) const override {
    double stored = 0;
    for (int p = range.first; p < range.last; ++p) {
      const Matrix before = read(points, column::deformation, p, 1);
      const Matrix now = before + dt * read(points, column::strain_rate, p, 0) * before;
      write(points, column::deformation, p, now);
      stored += points(column::mass)[p] / density * (energy(now) - energy(before));
    }
    return stored;
  }

  std::vector<double> rates(const Columns& points, const MaterialContext&) const override {
    Columns change(points.points());
    change.add(column::deformation, points.components(column::deformation));
    for (int p = 0; p < points.points(); ++p) {
      const Matrix f = read(points, column::deformation, p, 1), rate = read(points, column::strain_rate, p, 0);
      write(change, column::deformation, p, rate * f);
    }
    const auto values = change.values(column::deformation);
    return {values.begin(), values.end()};
  }

  // J^-1 P(F + ahead dF/dt) F^T.
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    for (int p = range.first; p < range.last; ++p) {
      const Matrix f = read(points, column::deformation, p, 1), rate = read(points, column::strain_rate, p, 0);
      const double j = f.determinant();
      write(points, column::stress, p, first_stress(f + context.ahead * rate * f) * f.transpose() / j);
      points(column::volume)[p] = j * points(column::mass)[p] / density;
    }
  }

  double stored_energy(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p)
      sum += points(column::mass)[p] / density * energy(read(points, column::deformation, p, 1));
    return sum;
  }

  std::optional<RestState> rest(int) const override {
    const LameConstants lame = lame_constants(youngs_modulus, poissons_ratio);
    return RestState{density, lame.lambda + 2 * lame.mu};
  }

  // Along the principal stretch s waves run at sqrt(s^2 W'' / rho_0) in space, s^2 W'' = 2 c_1 s^2 + 2 c_2 s^2 (I_1 - s^2) +
  // 2 (c_1 + 2 c_2) + 2 c J^2; s^2 is at most I_1 and s^2 (I_1 - s^2) at most I_2.
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    const Constants k = constants();
    StepBounds bounds;
    for (int p = range.first; p < range.last; ++p) {
      const Matrix f = read(points, column::deformation, p, 1), right = f.transpose() * f;
      const double j = f.determinant(), i1 = right.trace(), i2 = 0.5 * (i1 * i1 - right.squaredNorm());
      const double square = 2 * k.c1 * i1 + 2 * k.c2 * i2 + 2 * (k.c1 + 2 * k.c2) + 2 * std::max(k.c, 0.0) * j * j;
      bounds.include({.fastest = std::sqrt(square / density)});
    }
    bounds.fastest += fastest_point(points, range, dim);
    return bounds;
  }

  Fault first_fault(const Columns& points, PointRange range) const override {
    for (int p = range.first; p < range.last; ++p) {
      const double j = read(points, column::deformation, p, 1).determinant();
      if (!(j > 0) || !std::isfinite(j))
        return {p, column::deformation.name(), j, "the determinant of the deformation gradient must be positive"};
    }
    return {};
  }

 private:
  struct Constants {
    double c, c1, c2;  // Pa
  };
  Constants constants() const {
    const LameConstants lame = lame_constants(youngs_modulus, poissons_ratio);
    const double c2 = 0.5 * share * lame.mu;
    return {0.5 * lame.lambda - 2 * c2, 0.5 * lame.mu - c2, c2};
  }
  double energy(const Matrix& f) const {
    const Constants k = constants();
    const Matrix right = f.transpose() * f;
    const double j = f.determinant(), i1 = right.trace(), i2 = 0.5 * (i1 * i1 - right.squaredNorm());
    return k.c * (j - 1) * (j - 1) - 2 * (k.c1 + 2 * k.c2) * std::log(j) + k.c1 * (i1 - 3) + k.c2 * (i2 - 3);
  }
  Matrix first_stress(const Matrix& f) const {
    const Constants k = constants();
    const Matrix right = f.transpose() * f;
    const double j = f.determinant();
    return 2 * k.c1 * f + 2 * k.c2 * (right.trace() * f - f * right) +
           (2 * k.c * j * (j - 1) - 2 * (k.c1 + 2 * k.c2)) * f.inverse().transpose();
  }

  // Columns hold the components of the scene's dimensions row by row, then the hoop's: 1, 4, 5 or 9.
  template <class C, class Visit>
  static void for_components(C& points, const ColumnId& id, Visit&& visit) {
    const int components = points.components(id), dim = components == 1 ? 1 : components == 9 ? 3 : 2;
    for (int k = 0; k < dim * dim; ++k) visit(points(id, k), k / dim, k % dim);
    if (components == 5) visit(points(id, 4), 2, 2);
  }
  static Matrix read(const Columns& points, const ColumnId& id, int p, double elsewhere) {
    Matrix whole = elsewhere * Matrix::Identity();
    for_components(points, id, [&](const double* column, int d, int e) { whole(d, e) = column[p]; });
    return whole;
  }
  static void write(Columns& points, const ColumnId& id, int p, const Matrix& whole) {
    for_components(points, id, [&](double* column, int d, int e) { column[p] = whole(d, e); });
  }
};

const RegisterPart entry(material_entry<MooneyRivlin>("finite strains, compressible Mooney-Rivlin",
                                                      "Holzapfel 2000, ISBN 0-471-82319-8, (6.147)",
                                                      {{"youngs_modulus", "Pa", &MooneyRivlin::youngs_modulus},
                                                       {"poissons_ratio", "1", &MooneyRivlin::poissons_ratio},
                                                       {"density", "kg/m^3", &MooneyRivlin::density},
                                                       {"share", "1", &MooneyRivlin::share}}));

}  // namespace
