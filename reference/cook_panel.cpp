#include "reference/cook_panel.hpp"

#include <gsl/gsl_linalg.h>

#include <array>
#include <cmath>

#include "reference/argument.hpp"
#include "reference/gsl_owned.hpp"

namespace plumbline::reference {
namespace {

constexpr double width = 48, left = 44, right = 16;  // m

struct Place {
  double x, y;
};

// Of node (i, j) of a mesh with n elements along each side, finer towards all four: at the clamped corner at the top stresses are
// singular, and at the ends of the loaded side the load does not fit the sides beside it.
Place place(int i, int j, int n) {
  const auto graded = [n](int k) { return double(k) * k / (n * n) * (3 - 2.0 * k / n); };
  const double along = graded(i), low = left * along, high = left + right * along;
  return {width * along, low + graded(j) * (high - low)};
}

// Stiffness of one element, row by row; unknowns u_x, u_y of its nodes in turn.
using Stiffness = std::array<std::array<double, 8>, 8>;

Stiffness stiffness(const std::array<Place, 4>& corner, double lambda, double mu) {
  constexpr std::array<double, 4> side_x{-1, 1, 1, -1}, side_y{-1, -1, 1, 1};
  Stiffness k{};
  std::array<double, 8> dilatation{};  // integral of div u
  double area = 0;
  for (std::size_t g = 0; g < 4; ++g) {
    const double r = side_x[g] / std::sqrt(3.0), s = side_y[g] / std::sqrt(3.0);
    std::array<double, 4> along{}, across{};
    double xr = 0, xs = 0, yr = 0, ys = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      along[a] = side_x[a] * (1 + side_y[a] * s) / 4;
      across[a] = side_y[a] * (1 + side_x[a] * r) / 4;
      xr += along[a] * corner[a].x;
      xs += across[a] * corner[a].x;
      yr += along[a] * corner[a].y;
      ys += across[a] * corner[a].y;
    }
    const double weight = xr * ys - xs * yr;
    area += weight;
    std::array<std::array<double, 8>, 3> strain{};  // xx, yy, 2 xy
    for (std::size_t a = 0; a < 4; ++a) {
      const double dx = (ys * along[a] - yr * across[a]) / weight, dy = (xr * across[a] - xs * along[a]) / weight;
      strain[0][2 * a] = strain[2][2 * a + 1] = dx;
      strain[1][2 * a + 1] = strain[2][2 * a] = dy;
      dilatation[2 * a] += weight * dx;
      dilatation[2 * a + 1] += weight * dy;
    }
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t b = 0; b < 8; ++b) {
        k[a][b] += weight * mu *
                   (2 * strain[0][a] * strain[0][b] + 2 * strain[1][a] * strain[1][b] + strain[2][a] * strain[2][b]);
      }
    }
  }
  for (std::size_t a = 0; a < 8; ++a) {
    for (std::size_t b = 0; b < 8; ++b) k[a][b] += lambda / area * dilatation[a] * dilatation[b];
  }
  return k;
}

// By the order that the three show (Aitken); the bound is how far that is from what second order gives. Singular corners of the sides
// without a clamp keep the order below 2 on these meshes.
Bounded extrapolated(double coarse, double middle, double fine) {
  const double before = middle - coarse, now = fine - middle, limit = fine + now * now / (before - now);
  return {limit, std::abs(limit - (fine + now / 3))};
}

}  // namespace

CookPanel cook_panel_on(const CookPanelProblem& p, int n) {
  check_positive("youngs_modulus", p.youngs_modulus);
  check_positive("load", p.load);
  check({"poisson", 0, 0, 0.5, false, true, "", ""}, p.poisson);
  check_within("elements", n, 2, 128);
  const double mu = p.youngs_modulus / (2 * (1 + p.poisson)), lambda = 2 * mu * p.poisson / (1 - 2 * p.poisson);
  // Nodes on the clamped side have no unknowns; the others are numbered up each line of nodes, from left to right.
  const int lines = n + 1, unknowns = 2 * n * lines, band = 2 * (lines + 1) + 1;
  const auto unknown = [&](int i, int j, int axis) { return 2 * ((i - 1) * lines + j) + axis; };
  const Owned<gsl_matrix> matrix(
      gsl_matrix_calloc(static_cast<std::size_t>(unknowns), static_cast<std::size_t>(band + 1)));
  const Owned<gsl_vector> load(gsl_vector_calloc(static_cast<std::size_t>(unknowns)));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      constexpr std::array<int, 4> to_right{0, 1, 1, 0}, up{0, 0, 1, 1};
      std::array<Place, 4> corner{};
      for (std::size_t a = 0; a < 4; ++a) corner[a] = place(i + to_right[a], j + up[a], n);
      const Stiffness k = stiffness(corner, lambda, mu);
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = 0; b < 8; ++b) {
          const int at = i + to_right[a / 2], other = i + to_right[b / 2];
          if (at == 0 || other == 0) continue;
          const int row = unknown(at, j + up[a / 2], int(a % 2)), column = unknown(other, j + up[b / 2], int(b % 2));
          if (row < column) continue;
          *gsl_matrix_ptr(matrix.get(), static_cast<std::size_t>(column),
                          static_cast<std::size_t>(row - column)) += k[a][b];
        }
      }
    }
    const double share = p.load * (place(n, i + 1, n).y - place(n, i, n).y) / right / 2;
    for (const int j : {i, i + 1}) *gsl_vector_ptr(load.get(), static_cast<std::size_t>(unknown(n, j, 1))) += share;
  }
  gsl_linalg_cholesky_band_decomp(matrix.get());
  const Owned<gsl_vector> u(gsl_vector_alloc(static_cast<std::size_t>(unknowns)));
  gsl_linalg_cholesky_band_solve(matrix.get(), load.get(), u.get());
  double work = 0;
  for (std::size_t k = 0; k < u->size; ++k) work += gsl_vector_get(load.get(), k) * gsl_vector_get(u.get(), k) / 2;
  return {gsl_vector_get(u.get(), static_cast<std::size_t>(unknown(n, n, 1))), work};
}

CookPanel cook_panel(const CookPanelProblem& p) {
  const CookPanel coarse = cook_panel_on(p, 16), middle = cook_panel_on(p, 32), fine = cook_panel_on(p, 64);
  return {extrapolated(coarse.corner.value, middle.corner.value, fine.corner.value),
          extrapolated(coarse.work.value, middle.work.value, fine.work.value)};
}

}  // namespace plumbline::reference
