#include "kernel/cell_volumes.hpp"

#include "kernel/engine/loops/list_volumes.hpp"
#include "kernel/shapes/cpdi.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::cell_volumes_test {
namespace {

using scenes::Space;

// Sums of some thirty terms of order one.
constexpr double rounding = 1e-14;

template <class Shape>
std::vector<double> along(const GridSpec& spec, int d) {
  return spec.dim == 1 ? line_volumes<Shape>(Grid<1>(spec), d) : line_volumes<Shape>(Grid<2>(spec), d);
}

// Integral of N over the space between walls: h inside, h/2 on a wall, and the ghosts' share is their mirrors'. [EC-APIC 2]
template <class Shape>
void expect_half_cells_at_walls() {
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    const auto v = along<Shape>(scenes::line(6, 0.5, scenes::walls_everywhere(kind)), 0);
    ASSERT_EQ(v.size(), 9u);
    for (std::size_t i = 1; i < 8; ++i) EXPECT_NEAR(v[i], i == 1 || i == 7 ? 0.25 : 0.5, rounding);
    EXPECT_EQ(v[0], 0);
    EXPECT_EQ(v[8], 0);
  }
}
TEST(CellVolumes, NodesOnWallsHaveHalfCells) {
  expect_half_cells_at_walls<Linear>();
  expect_half_cells_at_walls<Quadratic>();
  expect_half_cells_at_walls<Cubic>();
}

// On a free side the space goes on: every node that a point can reach, ghosts among them, has a whole cell. [EC-APIC 2]
template <class Shape>
void expect_whole_cells_at_free_sides() {
  for (double v : along<Shape>(scenes::line(6, 0.5), 0)) EXPECT_NEAR(v, 0.5, rounding);
  const auto mixed = along<Shape>(scenes::line(6, 0.5, scenes::walls(Wall::free, Wall::symmetry)), 0);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(mixed[i], 0.5, rounding);
  EXPECT_NEAR(mixed[7], 0.25, rounding);
}
TEST(CellVolumes, NodesOfFreeSidesHaveWholeCells) {
  expect_whole_cells_at_free_sides<Linear>();
  expect_whole_cells_at_free_sides<Quadratic>();
  expect_whole_cells_at_free_sides<Cubic>();
}

// Integral of N |r| per radian, h = 1, by hand. m = integral over u > 0 of N(u) u, q = the same of N(1 + u) u: what
// reaches across the axis, or across the outer wall from the other side. [EC-APIC 2]
//   on the axis m; next to it 1 + 2 q; inside r_i; next to the outer wall R - 1 - 2 q; on it R/2 - m
template <class Shape>
void expect_ring_volumes(double m, double q) {
  const auto walled = along<Shape>(
      scenes::box(Space::axisymmetric, {6, 4, 1}, 0.5, scenes::walls_everywhere(Wall::symmetry)), 0);
  const double expected[7] = {m, 1 + 2 * q, 2, 3, 4, 5 - 2 * q, 3 - m};
  double total = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(walled[i + 1], 0.25 * expected[i], rounding) << i;
    total += walled[i + 1];
  }
  EXPECT_NEAR(total, 3 * 3 / 2.0, 4 * rounding);  // R^2 / 2: no space is lost or counted twice
  GridSpec off_axis = scenes::box(Space::axisymmetric, {6, 4, 1}, 0.5);
  off_axis.origin[0] = 2;
  const auto free = along<Shape>(off_axis, 0);
  for (std::size_t i = 0; i < free.size(); ++i)
    EXPECT_NEAR(free[i], 0.5 * (2 + 0.5 * (static_cast<double>(i) - 1)), rounding);
  for (double v : along<Shape>(off_axis, 1)) EXPECT_NEAR(v, 0.5, rounding);  // along the axis as elsewhere
}
TEST(CellVolumes, OfRings) {
  expect_ring_volumes<Linear>(1.0 / 6, 0);
  expect_ring_volumes<Quadratic>(13.0 / 64, 1.0 / 384);
  expect_ring_volumes<Cubic>(7.0 / 30, 1.0 / 120);
}

// Of a shape that is listed, by quadrature that is exact for its pieces: on free sides every node has a whole cell, ghosts
// among them; a wall halves those on it and gives the ghosts' share to their mirrors. [EC-APIC 2]
TEST(CellVolumes, OfListedShapesAreWholeCellsToo) {
  constexpr double h = 0.5;
  const MakeListed<2> make = +[](const Grid<2>& on) -> std::unique_ptr<const ListedShape<2>> {
    return std::make_unique<Cpdi<2>>(on);
  };
  for (double inverse : inverse_listed_volumes<2>(scenes::box(Space::plane, {6, 5, 1}, h), make))
    EXPECT_NEAR(inverse, 1 / (h * h), 100 * rounding);
  const GridSpec walled = scenes::box(Space::plane, {6, 5, 1}, h, scenes::walls_everywhere(Wall::symmetry));
  const Grid<2> grid(walled);
  const auto inverse = inverse_listed_volumes<2>(walled, make);
  for (int i = 0; i < grid.node_count(); ++i) {
    double expected = 1 / (h * h);
    for (int d = 0; d < 2; ++d) {
      const int k = grid.index(i, d), last = grid.nodes(d) - 1;
      expected *= k == 0 || k == last ? 0 : k == 1 || k == last - 1 ? 2 : 1;
    }
    EXPECT_NEAR(inverse[static_cast<std::size_t>(i)], expected, 100 * rounding) << i;
  }
}

// Products of the directions: an edge of two walls has a quarter, a corner of three an eighth.
TEST(CellVolumes, AreProducts) {
  const double h = 0.5;
  const Grid<3> grid(scenes::box(Space::solid, {4, 3, 2}, h, scenes::walls_everywhere(Wall::symmetry)));
  const auto inverse = inverse_cell_volumes<Quadratic>(grid);
  double total = 0;
  for (int i = 0; i < grid.node_count(); ++i) {
    double volume = h * h * h;
    bool beyond = false;
    for (int d = 0; d < 3; ++d) {
      const int k = grid.index(i, d), last = grid.nodes(d) - 1;
      if (k == 1 || k == last - 1) volume /= 2;
      beyond = beyond || k == 0 || k == last;
    }
    const double found = inverse[static_cast<std::size_t>(i)];
    EXPECT_NEAR(found, beyond ? 0 : 1 / volume, 100 * rounding);
    if (found > 0) total += 1 / found;
  }
  EXPECT_NEAR(total, 4 * 3 * 2 * h * h * h, 10 * rounding);
}

// --- densities of even rings ----------------------------------------------------------------------------------------

// What even points, `d` of a cell apart, put on the nodes beyond the integral of N |r|: the midpoint rule over half a lattice
// leaves d^2/24 and 7 d^4/5760 times jumps of derivatives (Euler-Maclaurin), at the axis with plus, at the outer
// wall with minus; its pieces must end between cells of the lattice, which they do for an even number of points.
template <class Shape>
struct Excess;
template <>
struct Excess<Linear> {
  static constexpr double m = 1.0 / 6, q = 0;
  static double on_axis(double d) { return d * d / 12; }
  static double next(double) { return 0; }
};
template <>
struct Excess<Quadratic> {
  static constexpr double m = 13.0 / 64, q = 1.0 / 384;
  static double on_axis(double d) { return d * d / 32; }
  static double next(double d) { return d * d / 96; }
};
template <>
struct Excess<Cubic> {
  static constexpr double m = 7.0 / 30, q = 1.0 / 120;
  static double on_axis(double d) { return d * d / 36 + 7 * std::pow(d, 4) / 720; }
  static double next(double d) { return d * d / 72 - 7 * std::pow(d, 4) / 720; }
};

// The density of rings between an axis and a wall at R = 8, interpolated from the nodes' by hand.
template <class Shape>
double ring_density(double r, double d) {
  using E = Excess<Shape>;
  const double m = E::m, q = E::q, R = 8;
  std::array<double, 9> node;
  node.fill(1);
  node[0] = 1 + E::on_axis(d) / m;
  node[1] = 1 + E::next(d) / (1 + 2 * q);
  node[7] = 1 - E::next(d) / (R - 1 - 2 * q);
  node[8] = 1 - E::on_axis(d) / (R / 2 - m);
  double local, n[Shape::support], rho = 0;
  const int anchor = Shape::anchor(r, 8, local);
  Shape::weights(local, n);
  for (int k = 0; k < Shape::support; ++k) {
    int i = std::abs(anchor + Shape::first + k);
    if (i > 8) i = 16 - i;
    rho += n[k] * node[static_cast<std::size_t>(i)];
  }
  return rho;
}

// So between walls the density of even rings is uniform to rounding away from the axis and the outer wall, and beside
// them off by the quadrature of the lattice alone, of second order in it. [EC-APIC 2]
template <class Shape>
void expect_ring_densities(const std::string& shape) {
  const GridSpec grid = scenes::box(Space::axisymmetric, {8, 4, 1}, 1.0, scenes::walls_everywhere(Wall::symmetry));
  for (int per_cell : {2, 4, 8}) {
    const auto places = scenes::lattice(grid, per_cell);
    Scene scene = scenes::scene_of(
        grid,
        {scenes::gas_body({}, Space::axisymmetric, places, scenes::lattice_volume(grid, per_cell),
                          [](auto&) { return scenes::GasState{1.7}; })},
        shape, "apic");
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {});
    engine->initialise();
    const auto rho = scenes::by_id(scene.bodies[0], column::density);
    for (std::size_t p = 0; p < rho.size(); ++p) {
      const double r = places[p][0];
      EXPECT_NEAR(rho[p], 1.7 * ring_density<Shape>(r, 1.0 / per_cell), 10 * rounding) << shape << ' ' << r;
      if (r > 3.5 && r < 4.5) {  // no shape reaches from there to a node beside the axis or the wall
        EXPECT_NEAR(rho[p], 1.7, 10 * rounding);
      }
    }
  }
}
TEST(CellVolumes, EvenRingsHaveOneDensityButForTheQuadrature) {
  expect_ring_densities<Linear>("linear");
  expect_ring_densities<Quadratic>("quadratic");
  expect_ring_densities<Cubic>("cubic");
}

}  // namespace
}  // namespace plumbline::cell_volumes_test
