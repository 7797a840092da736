// The finite bars of mpm_amplification.hpp.
#include <algorithm>
#include <cmath>

#include "reference/argument.hpp"
#include "reference/grid_maps.hpp"
#include "reference/gsl_owned.hpp"
#include "reference/linear_step.hpp"
#include "reference/nodal_filter.hpp"

namespace plumbline::reference {
namespace {

using Real = Dense<double>;

struct SymmetricPairs {
  std::vector<double> values;
  Real vectors;  // columns
};

SymmetricPairs symmetric_pairs(const Real& matrix) {
  const auto n = static_cast<std::size_t>(matrix.rows);
  const Owned<gsl_matrix> copy(gsl_matrix_alloc(n, n)), vectors(gsl_matrix_alloc(n, n));
  const Owned<gsl_vector> values(gsl_vector_alloc(n));
  const Owned<gsl_eigen_symmv_workspace> work(gsl_eigen_symmv_alloc(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) gsl_matrix_set(copy.get(), i, j, matrix.entries[i * n + j]);
  }
  gsl_eigen_symmv(copy.get(), values.get(), vectors.get(), work.get());
  SymmetricPairs pairs{{}, Real(matrix.rows, matrix.rows)};
  for (std::size_t i = 0; i < n; ++i) {
    pairs.values.push_back(gsl_vector_get(values.get(), i));
    for (std::size_t j = 0; j < n; ++j) pairs.vectors.entries[i * n + j] = gsl_matrix_get(vectors.get(), i, j);
  }
  return pairs;
}

double frobenius(const Real& matrix) {
  double square = 0;
  for (double entry : matrix.entries) square += entry * entry;
  return std::sqrt(square);
}

void check_bar(const MapScheme& scheme, const std::vector<double>& points, double spacing) {
  if (points.empty()) throw ParameterError("points", 0, "at least one");
  for (double x : points) check_within("points", x, -1e6, 1e6);
  check({"spacing", 0, 0, scheme.shape == GridShape::boxes ? 1 : 1e6, true, false, "", ""}, spacing);
  check_within("order", scheme.order, 1, 1000);
  check_within("sharpening", scheme.sharpening, 0, 1);
}

// Weights of the points on all nodes that carry mass, which `mass` lists.
struct Bar {
  Real weight, gradient, arm, affine;
  std::vector<double> mass;
  std::vector<int> node;
  double uncertain = 0;  // largest relative error of a mass: a light node's is the difference of a place and a node
};

Bar bar_of(const MapScheme& scheme, const std::vector<double>& points, double spacing) {
  std::vector<PointWeights> weights;
  for (double x : points) weights.push_back(point_weights(scheme.shape, x, spacing));
  auto by_first = [](const PointWeights& a, const PointWeights& b) { return a.first < b.first; };
  const auto [lowest, highest] = std::minmax_element(weights.begin(), weights.end(), by_first);
  const int first = lowest->first, nodes = highest->first + PointWeights::nodes - first;
  std::vector<Bounded> all(static_cast<std::size_t>(nodes));
  for (const PointWeights& at : weights) {
    for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
      Bounded& mass = all[static_cast<std::size_t>(at.first - first) + k];
      mass = mass + Bounded(spacing) * at.weight[k];
    }
  }
  Bar bar;
  std::vector<int> place(all.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(all[i].value > 0)) continue;
    place[i] = static_cast<int>(bar.mass.size());
    bar.mass.push_back(all[i].value);
    bar.uncertain = std::max(bar.uncertain, all[i].bound / all[i].value);
    bar.node.push_back(first + static_cast<int>(i));
  }
  bar.weight = bar.gradient = bar.arm = bar.affine = Real(static_cast<int>(points.size()),
                                                          static_cast<int>(bar.mass.size()));
  for (std::size_t p = 0; p < weights.size(); ++p) {
    for (std::size_t k = 0; k < PointWeights::nodes; ++k) {
      const int i = place[static_cast<std::size_t>(weights[p].first - first) + k], row = static_cast<int>(p);
      if (i < 0) continue;
      bar.weight(row, i) = weights[p].weight[k].value;
      bar.gradient(row, i) = weights[p].gradient[k].value;
      bar.arm(row, i) = weights[p].weight[k].value * weights[p].arm[k].value;
      bar.affine(row, i) = weights[p].affine[k].value;
    }
  }
  return bar;
}

// Q as it acts on nodal velocities.
Real sharpening(const MapScheme& scheme, const Bar& bar) {
  const int nodes = static_cast<int>(bar.mass.size());
  const double theta = scheme.sharpening * blur(scheme.shape).value;
  Real q = selection<double>(nodes, nodes, 0);
  for (int i = 0; i < nodes; ++i) {
    for (int j = 0; j < nodes; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      if (std::abs(bar.node[a] - bar.node[b]) != 1) continue;
      const double share = theta * 2 * bar.mass[b] / (bar.mass[a] + bar.mass[b]);
      q(i, i) += share;
      q(i, j) -= share;
    }
  }
  return q;
}

Real diagonal(const std::vector<double>& values) {
  const int size = static_cast<int>(values.size());
  Real matrix(size, size);
  for (int i = 0; i < size; ++i) matrix(i, i) = values[static_cast<std::size_t>(i)];
  return matrix;
}

Real mass_to(const Bar& bar, double power) {
  std::vector<double> values;
  for (double m : bar.mass) values.push_back(std::pow(m, power));
  return diagonal(values);
}

// T with B = M^-1/2 T' T M^-1/2 [Stability 4]: what points carry, one row for each, scaled.
Real carried(const MapScheme& scheme, const Bar& bar, double spacing) {
  const bool affine = scheme.transfer == GridTransfer::apic;
  const int points = bar.weight.rows, nodes = bar.weight.columns;
  Real rows(affine ? 2 * points : points, nodes);
  for (int p = 0; p < points; ++p) {
    double inertia = 0;
    for (int i = 0; i < nodes; ++i) {
      rows(p, i) = std::sqrt(spacing) * bar.weight(p, i);
      if (bar.weight(p, i) > 0) inertia += bar.arm(p, i) * bar.arm(p, i) / bar.weight(p, i);
    }
    for (int i = 0; affine && i < nodes; ++i) rows(points + p, i) = std::sqrt(spacing * inertia) * bar.affine(p, i);
  }
  return rows;
}

// A function of a symmetric matrix whose eigenvalues are known to be between 0 and 1.
Real share_matrix(const MapScheme& scheme, const Real& b) {
  const SymmetricPairs pairs = symmetric_pairs(b);
  std::vector<double> values;
  for (double value : pairs.values) values.push_back(stiffness_share(scheme, std::clamp(value, 0.0, 1.0)));
  return pairs.vectors * diagonal(values) * adjoint(pairs.vectors);
}

// How much that function can change with b: nothing, a half, and sums of the filters' m terms; Frobenius norms keep it.
double steepest(const MapScheme& scheme) {
  if (scheme.transfer == GridTransfer::flip) return 0;
  const bool filters = scheme.transfer == GridTransfer::xpic || scheme.transfer == GridTransfer::fmpm;
  return filters ? scheme.order * scheme.order : 1;
}

// W K without its zeros and with an error: as G Q M^-1 T' R T M^-1 Q' G', R a function of T M^-1 T', in which no light
// node is far from 1; straining last G Q M^-1 Q' G'/2 less that.
Real burden(const MapScheme& scheme, const Bar& bar, double spacing, double& wrong) {
  // Ten roundings for each row of an eigenproblem or a product, of the matrices' own norms, and the masses' errors.
  const double size = static_cast<double>(std::max(bar.mass.size(), bar.weight.entries.size() / bar.mass.size()));
  const double ten = 10 * size * rounding::unit, input = ten + 2 * bar.uncertain;
  const Real inverse = mass_to(bar, -1), rows = carried(scheme, bar, spacing);
  const Real strains = std::sqrt(spacing) * (bar.gradient * sharpening(scheme, bar));
  const Real across = strains * inverse * adjoint(rows), b = rows * inverse * adjoint(rows);
  const Real shares = share_matrix(scheme, b), seen = across * shares * adjoint(across);
  wrong = std::pow(frobenius(across), 2) * input * (steepest(scheme) * frobenius(b) + 2 * frobenius(shares));
  if (scheme.update != StressUpdate::last) return seen;
  const Real all = 0.5 * (strains * inverse * adjoint(strains));
  wrong += input * frobenius(all);
  return all - seen;
}

// `wrong`: how much the eigenvalues may be off by the matrix.
Bounded limit_of(const Real& matrix, double wrong) {
  const std::vector<double> values = symmetric_pairs(matrix).values;
  const double largest = *std::max_element(values.begin(), values.end());  // [Stability 5]
  if (!(largest > 0)) return rounding::infinity;
  wrong += 10 * static_cast<double>(matrix.rows) * rounding::unit * frobenius(matrix);
  return Bounded(1) / sqrt(Bounded(largest, wrong));
}

}  // namespace

std::vector<double> edge_points(int per_cell, int cells, double depth) {
  check_within("per_cell", per_cell, 1, 1000);
  check_within("cells", cells, 1, 1000);
  check({"depth", 0, 0, 1.0 / per_cell, true, false, "", ""}, depth);
  std::vector<double> points;
  for (int i = 0; i < per_cell * cells; ++i) points.push_back(-depth + static_cast<double>(i) / per_cell);
  return points;
}

std::vector<double> york_points(double offset) {
  check_within("offset", offset, 0, 1);
  std::vector<double> points;
  for (int i = 0; i < 5; ++i) points.push_back(i + offset);
  return points;
}

SquareMatrix free_bar_amplification(const MapScheme& scheme, const std::vector<double>& points, double spacing,
                                    double courant) {
  check_bar(scheme, points, spacing);
  check_positive("courant", courant);
  const Bar bar = bar_of(scheme, points, spacing);
  const GridMaps<double> maps{bar.weight, bar.gradient, bar.arm, bar.affine, mass_to(bar, -1), sharpening(scheme, bar),
                              spacing};
  return LinearStep<double>(scheme, maps, courant).matrix();
}

Bounded free_bar_courant_limit(const MapScheme& scheme, const std::vector<double>& points, double spacing) {
  check_bar(scheme, points, spacing);
  double wrong = 0;
  const Real matrix = burden(scheme, bar_of(scheme, points, spacing), spacing, wrong);
  return limit_of(matrix, wrong);
}

// Strains are even in the distance from the wall: those of a point and of its image count as one.
Bounded leaning_bar_courant_limit(const MapScheme& scheme, const std::vector<double>& points, double spacing) {
  check_bar(scheme, points, spacing);
  for (double x : points) check_positive("points", x);
  std::vector<double> both = points;
  for (double x : points) both.push_back(-x);
  double wrong = 0;
  const Real matrix = burden(scheme, bar_of(scheme, both, spacing), spacing, wrong);
  const int count = static_cast<int>(points.size());
  Real even(count, count);
  for (int p = 0; p < count; ++p) {
    for (int q = 0; q < count; ++q) even(p, q) = matrix(p, q) + matrix(p, count + q);
  }
  return limit_of(even, wrong);
}

}  // namespace plumbline::reference
