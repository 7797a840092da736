// The smoothing of the maps undone on the nodes, against its theory. [Sharpening 1]
#include "kernel/sharpening.hpp"
#include "kernel/rotations.hpp"

#include <Eigen/Core>
#include <numbers>

#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::sharpening_test {
namespace {

using scenes::Space;

// --- theta ----------------------------------------------------------------------------------------------------------

// Fourier transform of a shape by the midpoint rule over its support, in cells; the rule's own error is that of 400 points
// a cell, of pieces of degree three: below 1e-6 of k^2.
template <class Shape>
double transform(double k) {
  constexpr int per_cell = 400, half = 2 * per_cell;
  double sum = 0;
  for (int j = -half; j < half; ++j) {
    const double u = (j + 0.5) / per_cell, place = 2 - u;  // node 2 seen from the place
    double local, n[Shape::support];
    const int anchor = Shape::anchor(place, 4, local);
    Shape::weights(local, n);
    const int own = 2 - anchor - Shape::first;
    if (own >= 0 && own < Shape::support) sum += n[own] * std::cos(k * u) / per_cell;
  }
  return sum;
}

// A map damps a wave by the transform S(k) of its shape, and 1 + theta (2 - 2 cos k) takes the leading term away: what is left
// of the product is of order k^4, so halving k divides it by 16 (to some 2 k^2 of it, from the k^6 terms). [Sharpening 1]
template <class Shape>
void expect_leading_term_undone() {
  const auto left = [](double k) { return transform<Shape>(k) * (1 + Shape::blur * (2 - 2 * std::cos(k))) - 1; };
  EXPECT_NEAR(left(0.4) / left(0.2), 16, 0.5);
  EXPECT_NEAR((1 - transform<Shape>(0.1)) / 0.01, Shape::blur, 1e-3 * Shape::blur);
}
TEST(Sharpening, UndoesTheLeadingTermOfTheSmoothing) {
  expect_leading_term_undone<Linear>();
  expect_leading_term_undone<Quadratic>();
  expect_leading_term_undone<Cubic>();
}

// --- the operator on nodes ------------------------------------------------------------------------------------------

// Of powers of the Laplacians along the axes: the first alone, and all three; kept everywhere, or not.
using Amounts = std::array<double, 3>;
struct Operator {
  Amounts amounts;
  bool limited;
};
constexpr Operator operators[] = {{{1, 0, 0}, false}, {{1, 0.5, 2}, false}, {{1, 0, 0}, true}, {{1, 0.5, 2}, true}};

// A grid all of whose nodes are touched, or but for a hole, with random masses.
template <int dim>
struct Nodes {
  using Vec = Eigen::Matrix<double, dim, 1>;
  Grid<dim> grid;
  Walls<dim> walls;
  VelocityField<dim> field;
  scenes::Random random{17};

  explicit Nodes(const GridSpec& spec, bool even = false) : grid(spec), walls(grid), field(grid) {
    for (auto& row : field.touched) row = {0, grid.row_length()};
    for (double& mass : field.mass) mass = even ? 2 : random(0.1, 1);
    walls.fold_mass(field);
  }
  // Of what is sharpened each node keeps another share along each axis. [Limiter 2]
  void keep_shares_at_random() {
    for (Vec& share : field.held(field.corrected.kept)) {
      for (int d = 0; d < dim; ++d) share[d] = random(0, 1);
    }
  }
  std::vector<Vec> random_velocity() {
    std::vector<Vec> v(field.mass.size());
    for (Vec& one : v) {
      for (int d = 0; d < dim; ++d) one[d] = random(-1, 1);
    }
    walls.extend(field, v);
    return v;
  }
  std::vector<Vec> sharpened(const std::vector<Vec>& v, double theta = 0.125,
                             const Amounts& amounts = {1, 0, 0}) const {
    std::vector<Vec> to(v.size(), Vec::Zero());
    VelocityField<dim> scratch = field;
    Sharpening<dim>(grid, theta, amounts).apply(scratch, v, to, 1);
    walls.extend(field, to);
    return to;
  }
  // sum_i M_i a_i . b_i without the ghosts of walls.
  bool own(int i) const {
    for (int d = 0; d < dim; ++d) {
      const int k = grid.index(i, d), last = grid.nodes(d) - 1;
      if ((k == 0 && grid.wall(d, 0) != Wall::free) || (k == last && grid.wall(d, 1) != Wall::free)) return false;
    }
    return true;
  }
  double product(const std::vector<Vec>& a, const std::vector<Vec>& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (own(static_cast<int>(i))) sum += field.mass[i] * a[i].dot(b[i]);
    }
    return sum;
  }
  Vec momentum(const std::vector<Vec>& v) const {
    Vec sum = Vec::Zero();
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (own(static_cast<int>(i))) sum += field.mass[i] * v[i];
    }
    return sum;
  }
  Spin<dim> spin(const std::vector<Vec>& v) const {
    Spin<dim> sum = Spin<dim>::Zero();
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (own(static_cast<int>(i))) sum += cross<dim>(grid.position(static_cast<int>(i)), Vec(field.mass[i] * v[i]));
    }
    return sum;
  }
};

// The formula, node by node, two and more nodes away from the sides. [Sharpening 1]
template <int dim>
void expect_formula_inside(Space space, Wall wall) {
  const Nodes<dim> nodes(scenes::box(space, {8, 8, 8}, 0.5, scenes::walls_everywhere(wall)));
  Nodes<dim> copy = nodes;
  const auto u = copy.random_velocity(), sharpened = nodes.sharpened(u);
  const Grid<dim>& grid = nodes.grid;
  int seen = 0;
  for (int i = 0; i < grid.node_count(); ++i) {
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const int k = grid.index(i, d) - Grid<dim>::ghosts;
      inside = inside && k >= 2 && k <= 6;
    }
    if (!inside) continue;
    const auto at = [](int node) { return static_cast<std::size_t>(node); };
    Eigen::Matrix<double, dim, 1> expected = u[at(i)];
    for (int d = 0; d < dim; ++d) {
      for (const int j : {i - grid.stride(d), i + grid.stride(d)}) {
        const double mass = nodes.field.mass[at(i)], other = nodes.field.mass[at(j)];
        expected += 0.125 * 2 * other / (mass + other) * (u[at(i)] - u[at(j)]);
      }
    }
    EXPECT_LT((sharpened[at(i)] - expected).norm(), 1e-14) << i;  // some ten roundings of numbers of size 1
    ++seen;
  }
  EXPECT_EQ(seen, dim == 1 ? 5 : dim == 2 ? 25 : 125);
}
TEST(Sharpening, FollowsItsFormulaInside) {
  for (const Wall wall : {Wall::free, Wall::symmetry, Wall::no_slip}) {
    expect_formula_inside<1>(Space::line, wall);
    expect_formula_inside<2>(Space::plane, wall);
    expect_formula_inside<3>(Space::solid, wall);
  }
}

GridSpec mixed_walls(int dim, bool walled) {
  const Wall s = Wall::symmetry, n = Wall::no_slip, f = Wall::free;
  return scenes::box(scenes::space_of(dim), {7, 5, 6}, 0.5,
                     walled ? scenes::walls(s, n, f, s, n, f) : scenes::walls_everywhere(f));
}

// Where all masses are alike, a plane wave cos(k . x) is multiplied by 1 + 2 theta sum_d (1 - cos k_d h), away from free sides,
// whose nodes have no neighbour beyond. [Sharpening 1]
template <int dim>
void expect_multiplier() {
  Nodes<dim> nodes(mixed_walls(dim, false), true);
  const Eigen::Vector3d k(1.7, -2.3, 0.9);
  const double theta = 0.125, h = 0.5;
  typename Nodes<dim>::Vec amplitude;
  double multiplier = 1;
  for (int d = 0; d < dim; ++d) {
    amplitude[d] = 1 - 0.4 * d;
    multiplier += 2 * theta * (1 - std::cos(k[d] * h));
  }
  std::vector<typename Nodes<dim>::Vec> wave(nodes.field.mass.size());
  for (int i = 0; i < nodes.grid.node_count(); ++i) {
    wave[static_cast<std::size_t>(i)] = amplitude * std::cos(k.head<dim>().dot(nodes.grid.position(i)));
  }
  const auto q = nodes.sharpened(wave, theta);
  int seen = 0;
  for (int i = 0; i < nodes.grid.node_count(); ++i) {
    bool inner = true;
    for (int d = 0; d < dim; ++d)
      inner &= nodes.grid.index(i, d) > 0 && nodes.grid.index(i, d) < nodes.grid.nodes(d) - 1;
    if (!inner) continue;
    ++seen;
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LE((q[at] - multiplier * wave[at]).norm(), 1e-14);
  }
  EXPECT_GE(seen, 6);
}
TEST(Sharpening, MultipliesAPlaneWave) {
  expect_multiplier<1>();
  expect_multiplier<2>();
  expect_multiplier<3>();
}

// Waves that walls allow are multiplied up to the wall and on it: cos for what is even there, sin for what is odd.
// Masses on walls are half of those inside. [Sharpening 1] [EC-APIC walls]
TEST(Sharpening, MultipliesStandingWavesBetweenWalls) {
  const double h = 0.5, theta = 1.0 / 6;
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    const GridSpec spec = scenes::plane(8, 6, h, scenes::walls_everywhere(kind));
    Nodes<2> nodes(spec, true);
    const double k[2] = {3 * std::numbers::pi / 4, 2 * std::numbers::pi / 3};
    for (int i = 0; i < nodes.grid.node_count(); ++i) {  // what an even gas puts on nodes, ghosts folded
      double mass = 2;
      for (int d = 0; d < 2; ++d) {
        const int at = nodes.grid.index(i, d), last = nodes.grid.nodes(d) - 1;
        if (at == 1 || at == last - 1) mass /= 2;
        if (at == 0 || at == last) mass = 0.1;  // must not matter
      }
      nodes.field.mass[static_cast<std::size_t>(i)] = mass;
    }
    std::vector<Nodes<2>::Vec> wave(nodes.field.mass.size());
    for (int i = 0; i < nodes.grid.node_count(); ++i) {
      const auto x = nodes.grid.position(i);
      const double s0 = std::sin(k[0] * x[0]), c0 = std::cos(k[0] * x[0]), s1 = std::sin(k[1] * x[1]),
                   c1 = std::cos(k[1] * x[1]);
      wave[static_cast<std::size_t>(i)] = kind == Wall::no_slip ? Nodes<2>::Vec(s0 * s1, -s0 * s1)
                                                                : Nodes<2>::Vec(s0 * c1, c0 * s1);
    }
    const double multiplier = 1 + 2 * theta * (2 - std::cos(k[0] * h) - std::cos(k[1] * h));
    const auto q = nodes.sharpened(wave, theta);
    for (int i = 0; i < nodes.grid.node_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_LE((q[at] - multiplier * wave[at]).norm(), 1e-14) << i;
    }
  }
}

// A uniform velocity is its own, where walls allow it; and with nothing to undo Q is the identity.
TEST(Sharpening, KeepsWhatIsUniform) {
  Nodes<3> nodes(mixed_walls(3, false));
  const std::vector<Eigen::Vector3d> uniform(nodes.field.mass.size(), Eigen::Vector3d(0.3, -0.2, 0.7));
  for (const auto& v : nodes.sharpened(uniform)) EXPECT_LE((v - uniform[0]).norm(), 1e-15);
  EXPECT_TRUE(Sharpening<3>(nodes.grid, 0).none());
}

// b . M Q a = a . M Q b, whatever the masses, walls or not: forces through Q do the work that strains through Q give back.
// Sums of 500 products of order one. [Sharpening 1]
template <int dim>
void expect_self_adjoint() {
  for (bool walled : {false, true}) {
    for (const auto& [amounts, limited] : operators) {
      Nodes<dim> nodes(mixed_walls(dim, walled));
      if (limited) nodes.keep_shares_at_random();
      const auto a = nodes.random_velocity(), b = nodes.random_velocity();
      const auto q = [&](const auto& v) { return nodes.sharpened(v, 0.125, amounts); };
      const double scale = std::sqrt(nodes.product(a, a) * nodes.product(b, b));
      EXPECT_NEAR(nodes.product(q(a), b), nodes.product(a, q(b)), 1e-14 * scale) << walled;
      EXPECT_GT(std::abs(nodes.product(q(a), b) - nodes.product(a, b)), 1e-4 * scale);
      EXPECT_GT(nodes.product(q(a), a), nodes.product(a, a));  // the Laplacians are positive
    }
  }
}
TEST(Sharpening, IsSelfAdjointUnderTheMasses) {
  expect_self_adjoint<1>();
  expect_self_adjoint<2>();
  expect_self_adjoint<3>();
}

// Of accelerations: what it adds to momentum is what walls take (nothing without walls), and what it adds to the angular
// momentum is what it says. [Sharpening 1]
template <int dim>
void expect_momenta_booked(bool walled, const Operator& of) {
  const auto& [amounts, limited] = of;
  SCOPED_TRACE(testing::Message() << dim << "-D, walls " << walled << ", third power " << amounts[2] << ", "
                                  << limited);
  Nodes<dim> nodes(mixed_walls(dim, walled));
  if (limited) nodes.keep_shares_at_random();
  const auto a = nodes.random_velocity();
  std::vector<typename Nodes<dim>::Vec> q(a.size(), Nodes<dim>::Vec::Zero());
  const auto added = Sharpening<dim>(nodes.grid, 0.125, amounts).apply_to_accelerations(nodes.field, a, q, 1);
  nodes.walls.extend(nodes.field, q);
  const typename Nodes<dim>::Vec gain = nodes.momentum(q) - nodes.momentum(a);
  const Spin<dim> turn = nodes.spin(q) - nodes.spin(a);
  EXPECT_LE((gain - added.walls.linear).norm(), 1e-13);
  for (int k = 0; k < rotation_count<dim>; ++k) EXPECT_NEAR(turn[k], added.turn[k] + added.walls.angular[k], 1e-12);
  if (walled) {
    EXPECT_GT(gain.norm(), 1e-3);
  } else {
    EXPECT_LE(added.walls.linear.norm(), 0);
  }
  if (dim > 1) {
    EXPECT_GT(added.turn.matrix().norm(), 1e-3);
  }
}
TEST(Sharpening, BooksWhatItAddsToTheMomenta) {
  for (bool walled : {false, true}) {
    for (const Operator& of : operators) {
      expect_momenta_booked<1>(walled, of);
      expect_momenta_booked<2>(walled, of);
      expect_momenta_booked<3>(walled, of);
    }
  }
}

// Nodes that no point reaches, and nodes without mass, are no neighbours: what stands in their arrays is not read.
TEST(Sharpening, ReadsTouchedNodesAlone) {
  Nodes<2> nodes(mixed_walls(2, true));
  auto a = nodes.random_velocity();
  auto& touched = nodes.field.touched;
  touched.front() = touched.back() = {0, 0};
  for (std::size_t row = 1; row + 1 < touched.size(); ++row) touched[row] = {2, 6};
  nodes.field.mass[static_cast<std::size_t>(3 * nodes.grid.row_length() + 4)] = 0;
  const auto q = nodes.sharpened(a);
  for (int i = 0; i < nodes.grid.node_count(); ++i) {
    const auto [first, last] = touched[static_cast<std::size_t>(nodes.grid.index(i, 1))];
    const int k = nodes.grid.index(i, 0);
    const bool massless = nodes.field.mass[static_cast<std::size_t>(i)] == 0;
    if (massless || k < first || k >= last) a[static_cast<std::size_t>(i)].setConstant(1e30);
  }
  const auto again = nodes.sharpened(a);
  for (int row = 2; row + 2 < nodes.grid.nodes(1); ++row) {
    for (int k = 2; k < 6; ++k) {
      const auto i = static_cast<std::size_t>(row * nodes.grid.row_length() + k);
      if (nodes.field.mass[i] == 0) continue;
      EXPECT_EQ(q[i], again[i]) << row << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace plumbline::sharpening_test
