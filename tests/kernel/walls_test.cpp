// Walls against mirror images written out node by node. [EC-APIC walls]
#include "kernel/walls.hpp"
#include "kernel/rotations.hpp"

#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "kernel/stencil.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::walls_test {
namespace {

// Sums of up to four numbers of order one.
constexpr double rounding = 2e-15;

// A full grid of random masses and vectors, and the image of each node, by index arithmetic alone.
template <int dim>
struct Mirrors {
  using Vec = Eigen::Matrix<double, dim, 1>;
  Grid<dim> grid;
  Walls<dim> walls;
  VelocityField<dim> field;
  std::vector<Vec> values;

  explicit Mirrors(const GridSpec& spec) : grid(spec), walls(grid), field(grid) {
    for (auto& row : field.touched) row = {0, grid.row_length()};
    scenes::Random random(11);
    values.resize(field.mass.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      field.mass[i] = random(0.1, 1);
      for (int d = 0; d < dim; ++d) values[i][d] = random(-1, 1);
    }
  }
  // From the counts of nodes alone.
  int stride(int d) const { return d == 0 ? 1 : stride(d - 1) * grid.nodes(d - 1); }
  int index(int node, int d) const { return node / stride(d) % grid.nodes(d); }

  struct Image {
    int node;
    Vec sign;
  };
  // The node itself, or where its mirrors send it, with the sign that each component takes on the way.
  Image image(int node) const {
    Image at{node, Vec::Ones()};
    for (int d = 0; d < dim; ++d) {
      const int last = grid.nodes(d) - 1, k = index(node, d);
      const Wall wall = grid.wall(d, k == 0 ? 0 : 1);
      if ((k != 0 && k != last) || wall == Wall::free) continue;
      at.node += (k == 0 ? 2 : -2) * stride(d);
      if (wall == Wall::no_slip) at.sign = -at.sign;
      if (wall == Wall::symmetry) at.sign[d] = -at.sign[d];
    }
    return at;
  }
  bool ghost(int node) const { return image(node).node != node; }
  // What stands on a wall loses its odd components.
  Vec held(int node, Vec value) const {
    for (int d = 0; d < dim; ++d) {
      const int k = index(node, d);
      const bool low = k == 1, high = k == grid.nodes(d) - 2;
      for (int side = 0; side < 2; ++side) {
        if (!(side == 0 ? low : high) || grid.wall(d, side) == Wall::free) continue;
        if (grid.wall(d, side) == Wall::no_slip) value.setZero();
        if (grid.wall(d, side) == Wall::symmetry) value[d] = 0;
      }
    }
    return value;
  }
};

std::vector<GridSpec> walled_lines() {
  std::vector<GridSpec> all;
  for (Wall low : {Wall::free, Wall::symmetry, Wall::no_slip}) {
    for (Wall high : {Wall::free, Wall::symmetry, Wall::no_slip})
      all.push_back(scenes::line(4, 0.5, scenes::walls(low, high)));
  }
  return all;
}

// All kinds of corners.
std::vector<GridSpec> walled_planes() {
  std::vector<GridSpec> all;
  for (Wall a : {Wall::free, Wall::symmetry, Wall::no_slip}) {
    for (Wall b : {Wall::free, Wall::symmetry, Wall::no_slip}) {
      all.push_back(scenes::plane(4, 3, 0.5, scenes::walls(a, Wall::symmetry, b, Wall::no_slip)));
      all.push_back(scenes::plane(3, 4, 0.5, scenes::walls(Wall::no_slip, a, Wall::symmetry, b)));
    }
  }
  return all;
}

// In space: each kind of wall at each of the six sides, so that all kinds of edges and corners occur.
std::vector<GridSpec> walled_boxes() {
  std::vector<GridSpec> all;
  const Wall kinds[] = {Wall::free, Wall::symmetry, Wall::no_slip};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) {
        const Wall x = kinds[a], y = kinds[b], z = kinds[c];
        const Wall other_x = kinds[(a + b) % 3], other_y = kinds[(b + c) % 3], other_z = kinds[(c + a + 1) % 3];
        all.push_back(
            scenes::box(scenes::Space::solid, {3, 2, 4}, 0.5, scenes::walls(x, other_x, y, other_y, z, other_z)));
      }
    }
  }
  return all;
}

template <int dim>
void expect_mass_folds(const GridSpec& spec) {
  Mirrors<dim> m(spec);
  std::vector<double> expected = m.field.mass;
  for (int i = 0; i < m.grid.node_count(); ++i) {
    if (m.ghost(i)) expected[m.image(i).node] += m.field.mass[i];
  }
  m.walls.fold_mass(m.field);
  for (int i = 0; i < m.grid.node_count(); ++i) {
    if (m.ghost(i)) continue;
    EXPECT_NEAR(m.field.mass[i], expected[i], rounding);
  }
}

// What the walls did is what changed: sums over up to 42 nodes, in space 210, that grow like the root of their number.
template <int dim>
void expect_action(const WallAction<dim>& action, const Eigen::Matrix<double, dim, 1>& linear,
                   const Spin<dim>& angular) {
  EXPECT_LE((action.linear - linear).norm(), 20 * dim * rounding);
  for (int k = 0; k < angular.size(); ++k) EXPECT_NEAR(action.angular[k], angular[k], 40 * dim * rounding);
}

template <int dim>
void expect_vectors_fold(const GridSpec& spec) {
  Mirrors<dim> m(spec);
  using Vec = typename Mirrors<dim>::Vec;
  const std::vector<Vec> before = m.values;
  std::vector<Vec> expected = before;
  for (int i = 0; i < m.grid.node_count(); ++i) {
    if (m.ghost(i)) expected[m.image(i).node] += m.image(i).sign.cwiseProduct(before[i]);
  }
  const WallAction<dim> action = m.walls.fold(m.field, m.values);
  Vec linear = Vec::Zero();
  Spin<dim> angular = Spin<dim>::Zero();
  for (int i = 0; i < m.grid.node_count(); ++i) {
    const Vec after = m.ghost(i) ? Vec(Vec::Zero()) : m.held(i, expected[i]);
    EXPECT_LE((m.values[i] - after).norm(), rounding);
    linear += after - before[i];
    angular += cross<dim>(m.grid.position(i), after) - cross<dim>(m.grid.position(i), before[i]);
  }
  expect_action(action, linear, angular);
}

template <int dim>
void expect_velocities_extend(const GridSpec& spec) {
  Mirrors<dim> m(spec);
  const auto before = m.values;
  m.walls.extend(m.field, m.values);
  for (int i = 0; i < m.grid.node_count(); ++i) {
    const auto image = m.image(i);
    const typename Mirrors<dim>::Vec expected = image.sign.cwiseProduct(m.held(image.node, before[image.node]));
    EXPECT_EQ(m.values[i], expected);
  }
}

template <int dim>
void expect_scalars_extend(const GridSpec& spec) {
  Mirrors<dim> m(spec);
  const std::vector<double> before = m.field.mass;
  m.walls.extend_even(m.field, m.field.mass);
  for (int i = 0; i < m.grid.node_count(); ++i) EXPECT_EQ(m.field.mass[i], before[m.image(i).node]);
}

// What the map back gives to points beyond what the inner nodes hold: sum over ghosts of their own M_g (u_g -
// u_image).
template <int dim>
void expect_extension_impulse(const GridSpec& spec) {
  Mirrors<dim> m(spec);
  using Vec = typename Mirrors<dim>::Vec;
  const std::vector<double> own = m.field.mass;
  m.walls.fold_mass(m.field);
  m.walls.extend(m.field, m.values);
  const WallAction<dim> action = m.walls.extension_impulse(m.field, m.values);
  Vec linear = Vec::Zero();
  Spin<dim> angular = Spin<dim>::Zero();
  for (int i = 0; i < m.grid.node_count(); ++i) {
    if (!m.ghost(i)) continue;
    const int k = m.image(i).node;
    linear += own[i] * (m.values[i] - m.values[k]);
    angular += own[i] * (cross<dim>(m.grid.position(i), m.values[i]) - cross<dim>(m.grid.position(k), m.values[k]));
  }
  expect_action(action, linear, angular);
}

TEST(Walls, MassFolds) {
  for (const GridSpec& spec : walled_lines()) expect_mass_folds<1>(spec);
  for (const GridSpec& spec : walled_planes()) expect_mass_folds<2>(spec);
  for (const GridSpec& spec : walled_boxes()) expect_mass_folds<3>(spec);
}
TEST(Walls, MomentaFoldWithTheirSigns) {
  for (const GridSpec& spec : walled_lines()) expect_vectors_fold<1>(spec);
  for (const GridSpec& spec : walled_planes()) expect_vectors_fold<2>(spec);
  for (const GridSpec& spec : walled_boxes()) expect_vectors_fold<3>(spec);
}
TEST(Walls, VelocitiesExtend) {
  for (const GridSpec& spec : walled_lines()) expect_velocities_extend<1>(spec);
  for (const GridSpec& spec : walled_planes()) expect_velocities_extend<2>(spec);
  for (const GridSpec& spec : walled_boxes()) expect_velocities_extend<3>(spec);
}
TEST(Walls, DensitiesExtend) {
  for (const GridSpec& spec : walled_lines()) expect_scalars_extend<1>(spec);
  for (const GridSpec& spec : walled_planes()) expect_scalars_extend<2>(spec);
  for (const GridSpec& spec : walled_boxes()) expect_scalars_extend<3>(spec);
}
TEST(Walls, ImpulseOfTheMapBack) {
  for (const GridSpec& spec : walled_lines()) expect_extension_impulse<1>(spec);
  for (const GridSpec& spec : walled_planes()) expect_extension_impulse<2>(spec);
  for (const GridSpec& spec : walled_boxes()) expect_extension_impulse<3>(spec);
}

// Interpolated at places on the wall, the odd components are zero: exactly where mirror weights are the same
// numbers.
template <class Shape>
void expect_still_wall(Wall kind) {
  Mirrors<2> m(scenes::plane(6, 5, 0.5, scenes::walls(kind, Wall::free, Wall::free, Wall::free)));
  m.walls.extend(m.field, m.values);
  for (double y : {0.7, 1.0, 1.63, 2.2}) {
    double local[2];
    const int i = Shape::anchor(0.0, 6, local[0]), j = Shape::anchor(y / 0.5, 5, local[1]);
    Footprint<2> print;
    print.lowest = (j + Shape::first + 1) * m.grid.row_length() + i + Shape::first + 1;
    print.stride[0] = 1;
    print.stride[1] = m.grid.row_length();
    Eigen::Vector2d v;
    for (int d = 0; d < 2; ++d) {
      v[d] = Stencil<2, Shape, double>(local, 0.5)
                 .gather(print, [&](std::size_t node) { return m.values[node][d]; })
                 .value;
    }
    EXPECT_NEAR(v[0], 0, 1e-16);
    EXPECT_EQ(std::abs(v[1]) <= 1e-16, kind == Wall::no_slip);
  }
}
TEST(Walls, StandStill) {
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    expect_still_wall<Quadratic>(kind);
    expect_still_wall<Cubic>(kind);
  }
}

TEST(Walls, MirrorsOfTouchedGhostsAreTouched) {
  const Grid<2> grid(scenes::plane(4, 3, 0.5, scenes::walls_everywhere(Wall::symmetry)));
  const Walls<2> walls(grid);
  std::vector<std::pair<int, int>> touched(6, {0, 0});
  touched[0] = {0, 1};  // a corner ghost alone
  walls.include_mirrors(touched);
  EXPECT_EQ(touched[0], (std::pair{0, 3}));
  EXPECT_EQ(touched[1], (std::pair{0, 0}));
  EXPECT_EQ(touched[2], (std::pair{0, 3}));
  std::vector<std::pair<int, int>> other(6, {0, 0});
  other[5] = {6, 7};
  walls.include_mirrors(other);
  EXPECT_EQ(other[5], (std::pair{4, 7}));
  EXPECT_EQ(other[3], (std::pair{4, 7}));
  // In space the mirrors of a corner ghost are eight: rows are y + 6 z.
  const Grid<3> box(scenes::box(scenes::Space::solid, {4, 3, 2}, 0.5, scenes::walls_everywhere(Wall::symmetry)));
  std::vector<std::pair<int, int>> deep(30, {0, 0});
  deep[5 + 6 * 4] = {6, 7};
  Walls<3>(box).include_mirrors(deep);
  for (int row = 0; row < 30; ++row) {
    const bool mirrored = (row % 6 == 5 || row % 6 == 3) && (row / 6 == 4 || row / 6 == 2);
    EXPECT_EQ(deep[static_cast<std::size_t>(row)], mirrored ? std::pair(4, 7) : std::pair(0, 0)) << row;
  }
}

}  // namespace
}  // namespace plumbline::walls_test
