// The finite bars of mpm_amplification.hpp.
#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "reference/argument.hpp"
#include "reference/grid_maps.hpp"
#include "reference/linear_step.hpp"
#include "reference/nodal_filter.hpp"

namespace plumbline::reference {
namespace {

using Real = Dense<double>;

struct Free {
  void operator()(gsl_matrix* p) const { gsl_matrix_free(p); }
  void operator()(gsl_vector* p) const { gsl_vector_free(p); }
  void operator()(gsl_eigen_symmv_workspace* p) const { gsl_eigen_symmv_free(p); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Free>;

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
  bar.weight = bar.gradient = bar.arm = bar.affine =
      Real(static_cast<int>(points.size()), static_cast<int>(bar.mass.size()));
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

// Q with M^power Q M^-power: 0 as it acts on velocities, 1/2 symmetric.
Real sharpening(const MapScheme& scheme, const Bar& bar, double power) {
  const int nodes = static_cast<int>(bar.mass.size());
  const double theta = scheme.sharpening * blur(scheme.shape).value;
  Real q = selection<double>(nodes, nodes, 0);
  for (int i = 0; i < nodes; ++i) {
    for (int j = 0; j < nodes; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      if (std::abs(bar.node[a] - bar.node[b]) != 1) continue;
      const double own = bar.mass[a], other = bar.mass[b], share = theta * 2 * other / (own + other);
      q(i, i) += share;
      q(i, j) -= share * std::pow(own / other, power);
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

// B of [Stability 4].
Real kept(const MapScheme& scheme, const Bar& bar, double spacing) {
  const Real scale = mass_to(bar, -0.5);
  Real sum = adjoint(bar.weight) * bar.weight;
  if (scheme.transfer == GridTransfer::apic) sum = sum + adjoint(bar.arm) * bar.affine;
  return spacing * (scale * sum * scale);
}

// A function of a symmetric matrix whose eigenvalues are known to be between 0 and 1.
Real weight_matrix(const MapScheme& scheme, const Real& b) {
  const SymmetricPairs pairs = symmetric_pairs(b);
  std::vector<double> values;
  for (double value : pairs.values) values.push_back(stiffness_weight(scheme, std::clamp(value, 0.0, 1.0)));
  return pairs.vectors * diagonal(values) * adjoint(pairs.vectors);
}

// How much W can change with B: its derivative is at most the order of the filter, and Frobenius norms keep that.
double steepest(const MapScheme& scheme) {
  const bool filters = scheme.transfer == GridTransfer::xpic || scheme.transfer == GridTransfer::fmpm;
  return filters ? scheme.order : 1;
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
  const GridMaps<double> maps{bar.weight,       bar.gradient,       bar.arm, bar.affine, mass_to(bar, -1),
                              sharpening(scheme, bar, 0), spacing};
  return LinearStep<double>(scheme, maps, courant).matrix();
}

Bounded free_bar_courant_limit(const MapScheme& scheme, const std::vector<double>& points, double spacing) {
  check_bar(scheme, points, spacing);
  const Bar bar = bar_of(scheme, points, spacing);
  const Real b = kept(scheme, bar, spacing), w = weight_matrix(scheme, b);
  const Real strains = std::sqrt(spacing) * (bar.gradient * mass_to(bar, -0.5) * sharpening(scheme, bar, 0.5));
  const Real burden = strains * w * adjoint(strains);
  const std::vector<double> values = symmetric_pairs(burden).values;
  const double largest = *std::max_element(values.begin(), values.end());  // [Stability 5]
  if (!(largest > 0)) return rounding::infinity;
  // Ten roundings for each row of an eigenproblem or a product, of the matrices' own norms; masses enter B and K twice
  // by their square roots, weights and gradients by as much.
  const double size = static_cast<double>(std::max(bar.mass.size(), points.size())), ten = 10 * size * rounding::unit;
  const double stretch = std::pow(frobenius(strains), 2), input = ten + 2 * bar.uncertain;
  const double wrong =
      stretch * input * (steepest(scheme) * frobenius(b) + 2 * frobenius(w)) + ten * frobenius(burden);
  return Bounded(1) / sqrt(Bounded(largest, wrong));
}

}  // namespace plumbline::reference
