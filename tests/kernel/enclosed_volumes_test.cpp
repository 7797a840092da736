// How much of what a polygon encloses belongs to each node. [Coupling 4]
#include "kernel/enclosed_volumes.hpp"

#include <algorithm>
#include <numbers>

#include "kernel/cell_volumes.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "kernel/walls.hpp"
#include "tests/kernel/coupled_scenes.hpp"

namespace plumbline::enclosed_volumes_test {
namespace {

using scenes::Place;
using scenes::Space;
using Corners = std::vector<std::array<double, 2>>;

template <class Shape>
class EnclosedVolumes : public testing::Test {};
using AllShapes = testing::Types<Linear, Quadratic, Cubic, Gimp>;
TYPED_TEST_SUITE(EnclosedVolumes, AllShapes);

constexpr double h = 0.1;
const GridSpec grids[] = {scenes::plane(20, 18, h), scenes::box(Space::axisymmetric, {20, 18, 1}, h)};

Columns chain_of(const Corners& corners) {
  Columns points(static_cast<int>(corners.size()));
  points.add(column::position, 2);
  for (std::size_t p = 0; p < corners.size(); ++p) {
    for (std::size_t d = 0; d < 2; ++d) points(column::position, static_cast<int>(d))[p] = corners[p][d];
  }
  return points;
}

// Star-shaped about (1, 0.9), counter-clockwise.
Corners random_polygon(int corners, unsigned long seed) {
  scenes::Random random(seed);
  Corners all;
  for (int k = 0; k < corners; ++k) {
    const double a = 2 * std::numbers::pi * (k + random(0, 0.8)) / corners, r = random(0.3, 0.75);
    all.push_back({1 + r * std::cos(a), 0.9 + r * std::sin(a)});
  }
  return all;
}

// Each edge cut in equal parts: the same polygon.
Corners refined(const Corners& polygon, int parts) {
  Corners all;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    for (int j = 0; j < parts; ++j) {
      const double t = 1.0 * j / parts;
      all.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  return all;
}

// Of the area, or of the ring's volume per radian, int r dA, by the corners.
double content(const Corners& polygon, bool rings) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double cross = a[0] * b[1] - b[0] * a[1];
    sum += rings ? cross * (a[0] + b[0]) / 6 : cross / 2;
  }
  return sum;
}

template <class Shape>
std::vector<double> volumes(const GridSpec& grid, const Corners& chain, const Corners& corners = {}) {
  std::vector<double> v;
  enclosed_volumes<Shape>(Grid<2>(grid), chain_of(chain), corners, v);
  return v;
}
double total(const std::vector<double>& v) {
  double sum = 0;
  for (double each : v) sum += each;
  return sum;
}

// The nodes share all there is inside, to the rounding of a few thousand terms; the other way round it is negative; and
// it does not matter which of the corners are points of the chain. [Coupling 4]
TYPED_TEST(EnclosedVolumes, AddUpToThePolygon) {
  for (const GridSpec& grid : grids) {
    for (const int corners : {3, 4, 7, 40, 300}) {
      for (const unsigned long seed : {1, 2, 3}) {
        const Corners polygon = random_polygon(corners, seed);
        const double exact = content(polygon, grid.axisymmetric);
        EXPECT_NEAR(total(volumes<TypeParam>(grid, polygon)), exact, 1e-13);
        const Corners back(polygon.rbegin(), polygon.rend());
        EXPECT_NEAR(total(volumes<TypeParam>(grid, back)), -exact, 1e-13);
        const auto middle = polygon.begin() + 2;
        const auto halves = volumes<TypeParam>(grid, {polygon.begin(), middle}, {middle, polygon.end()});
        const auto whole = volumes<TypeParam>(grid, polygon);
        for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(halves[i], whole[i], 1e-15);
      }
    }
  }
}

// A node whose shape lies inside has a whole cell, h^2 or r h^2, but for int N_j dy by one or two points on each piece
// of s: the midpoint rule is off by at most s^2/8 times all that N_j' goes up and down, 4/h, times h. One whose shape
// lies outside has nothing.
TYPED_TEST(EnclosedVolumes, WholeCellsInsideAndNoneOutside) {
  Corners circle;
  for (int k = 0; k < 200; ++k) {
    const double a = 2 * std::numbers::pi * k / 200;
    circle.push_back({1 + 0.6 * std::cos(a), 0.9 + 0.6 * std::sin(a)});
  }
  const double s = 1.2 * std::sin(std::numbers::pi / 200);
  for (const GridSpec& grid : grids) {
    const Grid<2> nodes(grid);
    const auto v = volumes<TypeParam>(grid, circle);
    int inside = 0, outside = 0;
    for (int i = 0; i < nodes.node_count(); ++i) {
      const auto x = nodes.position(i);
      const double reach = TypeParam::support * h / std::numbers::sqrt2, away = std::hypot(x[0] - 1, x[1] - 0.9);
      const double found = v[static_cast<std::size_t>(i)], cell = h * h * (grid.axisymmetric ? x[0] : 1);
      if (away < 0.599 - reach) {
        EXPECT_NEAR(found, cell, s * s / 2 * cell / (h * h));
        ++inside;
      }
      if (away > 0.6 + reach) {
        EXPECT_NEAR(found, 0, 1e-15);
        ++outside;
      }
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(outside, 100);
  }
}

// N at `x` cells from the node, by the shape's own weights.
template <class Shape>
double shape_at(double x) {
  double local, n[Shape::support];
  const int anchor = Shape::anchor(x + 10, 20, local);
  Shape::weights(local, n);
  const int k = 10 - anchor - Shape::first;
  return k >= 0 && k < Shape::support ? n[k] : 0.0;
}

// int N_i (r) dx from the far left to x on a line: what the polygon's scan lines are made of; a table by the midpoint
// rule.
template <class Shape>
class Row {
 public:
  explicit Row(bool rings) {
    for (int k = 0; k < steps; ++k) {
      const double x = -reach + (k + 0.5) * 2 * reach / steps, n = shape_at<Shape>(x) * 2 * reach / steps;
      mass_[k + 1] = mass_[k] + n;
      moment_[k + 1] = moment_[k] + n * x;
    }
    rings_ = rings;
  }
  double operator()(double x, double node) const {
    const double at = std::clamp((x - node) / h + reach, 0.0, 2 * reach) * steps / (2 * reach);
    const int k = std::min(static_cast<int>(at), steps - 1);
    const auto between = [&](const std::vector<double>& table) {
      return table[static_cast<std::size_t>(k)] +
             (at - k) * (table[static_cast<std::size_t>(k) + 1] - table[static_cast<std::size_t>(k)]);
    };
    return h * (rings_ ? node * between(mass_) + h * between(moment_) : between(mass_));
  }

 private:
  static constexpr int steps = 4000;
  static constexpr double reach = 2;
  std::vector<double> mass_ = std::vector<double>(steps + 1), moment_ = std::vector<double>(steps + 1);
  bool rings_;
};

// By scan lines: each cuts the polygon in a few points, between which N_i is summed up; 3000 lines over the height.
template <class Shape>
std::vector<double> by_scan_lines(const GridSpec& spec, const Corners& polygon) {
  const Grid<2> grid(spec);
  const Row<Shape> row(spec.axisymmetric);
  std::vector<double> v(static_cast<std::size_t>(grid.node_count()), 0.0);
  const int lines = 3000;
  const double step = spec.cells[1] * h / lines;
  for (int k = 0; k < lines; ++k) {
    const double y = (k + 0.5) * step;
    for (std::size_t c = 0; c < polygon.size(); ++c) {
      const auto &a = polygon[c], &b = polygon[(c + 1) % polygon.size()];
      if ((a[1] < y) == (b[1] < y)) continue;
      const double x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]), sign = b[1] > a[1] ? 1 : -1;
      for (int i = 0; i < grid.node_count(); ++i) {
        const auto node = grid.position(i);
        if (std::abs(y - node[1]) >= 2 * h) continue;
        v[static_cast<std::size_t>(i)] += sign * step * shape_at<Shape>((y - node[1]) / h) * row(x, node[0]);
      }
    }
  }
  return v;
}

// The one or two Gauss points on pieces of s <= h/4 leave at most s^2/8 times all that the slope of f = Phi_i N_j goes
// up and down along the line: no more than 10 on a way through the 3 h by 3 h that a shape covers, and of this polygon
// no more than four edges go there. As s^2 goes, so does the difference. The scan lines are off by the same of their
// own 6e-4 h. Phi of boxes has steps in its third derivative, 2/h^2 high, where three Gauss points leave no more than
// 1e-3 h. [Coupling 4]
TYPED_TEST(EnclosedVolumes, AgreeWithScanLines) {
  const Corners polygon = random_polygon(7, 5);
  for (const GridSpec& grid : grids) {
    const auto exact = by_scan_lines<TypeParam>(grid, polygon);
    for (const int parts : {1, 100, 2000}) {
      const Corners cut = refined(polygon, parts);
      double s = 0, largest = 0;
      for (std::size_t k = 0; k < cut.size(); ++k) {
        const auto &a = cut[k], &b = cut[(k + 1) % cut.size()];
        s = std::max(s, std::hypot(b[0] - a[0], b[1] - a[1]));
      }
      s = std::min(s, h / 4);
      const auto v = volumes<TypeParam>(grid, cut);
      for (std::size_t i = 0; i < v.size(); ++i) largest = std::max(largest, std::abs(v[i] - exact[i]));
      const double widest = grid.axisymmetric ? 2 : 1;  // the largest radius
      EXPECT_LE(largest, widest * (5 * s * s + 2e-6 + (TypeParam::boxes ? 1e-3 * h * h : 0))) << parts;
    }
  }
}

// As an engine uses it: folded at walls.
template <class Shape>
std::vector<double> folded(const GridSpec& spec, const Corners& chain, const Corners& corners) {
  const Grid<2> grid(spec);
  auto v = volumes<Shape>(spec, chain, corners);
  VelocityField<2> field(grid);
  std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, grid.row_length()});
  Walls<2>(grid).fold_even(field, v);
  return v;
}

// A closed box full: each node has the cell that it has in a closed box, half of one at a wall, a quarter in a corner,
// with rings at the axis what is there. [Coupling 4] [EC-APIC 2] Even steps of a quarter of a cell sum splines exactly.
TYPED_TEST(EnclosedVolumes, AFullBoxHasTheCellsOfTheBox) {
  if (TypeParam::boxes) return;  // boxes have kinks in between
  for (const Space space : {Space::plane, Space::axisymmetric}) {
    const GridSpec spec = scenes::box(space, {6, 5, 1}, h, scenes::walls_everywhere(Wall::symmetry));
    const Grid<2> grid(spec);
    const auto v = folded<TypeParam>(spec, {{0.6, 0}, {0.6, 0.5}, {0, 0.5}}, {{0, 0}});
    const auto inverse = inverse_cell_volumes<TypeParam>(grid);
    for (int i = 0; i < grid.node_count(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(v[k] * inverse[k], inverse[k] > 0 ? 1 : 0, 1e-13) << i;
    }
  }
}

// A quarter of a body between symmetry walls, closed through the corner, against the whole body on a grid without
// walls: node for node the same, half of it on a wall, a quarter in the corner. Of rings half a body, the axis as it
// is. Edges are cut so fine that two sums of points on pieces of s < 2e-3 differ by no more than 10 s^2 (see above).
// [Coupling 4]
TYPED_TEST(EnclosedVolumes, AQuarterHasAQuarter) {
  Corners quarter, whole;
  const int n = 800;
  const double tolerance = 10 * 4e-6;
  for (int k = 0; k <= n; ++k) {
    const double a = std::numbers::pi / 2 * k / n, r = 0.61 + 0.1 * std::cos(4 * a);
    quarter.push_back({k == n ? 0 : r * std::cos(a), k == 0 ? 0 : r * std::sin(a)});
  }
  for (int turn = 0; turn < 4; ++turn) {
    for (int k = 0; k < n; ++k) {
      const auto& c = quarter[static_cast<std::size_t>(turn % 2 ? n - k : k)];
      whole.push_back({turn == 0 || turn == 3 ? c[0] : -c[0], turn < 2 ? c[1] : -c[1]});
    }
  }
  Corners centre;  // from the last point to the corner, and on towards the first
  for (int k = 1; k <= 2 * n; ++k) {
    const double t = 0.71 * std::abs(n - k) / n;
    if (t < quarter.back()[1] || k > n) centre.push_back({k > n ? t : 0.0, k > n ? 0.0 : t});
  }
  GridSpec around = scenes::plane(20, 20, h);
  around.origin = {-1, -1, 0};
  const GridSpec corner = scenes::plane(10, 10, h,
                                        scenes::walls(Wall::symmetry, Wall::free, Wall::symmetry, Wall::free));
  const auto all = volumes<TypeParam>(around, whole);
  const auto part = folded<TypeParam>(corner, quarter, centre);
  const Grid<2> big(around), small(corner);
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) {
      const double share = (i == 0 ? 0.5 : 1) * (j == 0 ? 0.5 : 1);
      const auto here = static_cast<std::size_t>(small.stride(1) * (j + 1) + i + 1);
      const auto there = static_cast<std::size_t>(big.stride(1) * (j + 11) + i + 11);
      EXPECT_NEAR(part[here], share * all[there], tolerance) << i << ' ' << j;
    }
  }
  GridSpec half = scenes::box(Space::axisymmetric, {10, 20, 1}, h, scenes::walls(Wall::symmetry, Wall::free));
  half.origin = {0, -1, 0};
  GridSpec upper = scenes::box(Space::axisymmetric, {10, 10, 1}, h,
                               scenes::walls(Wall::symmetry, Wall::free, Wall::symmetry, Wall::free));
  Corners right(whole.end() - n, whole.end());
  right.insert(right.end(), quarter.begin(), quarter.end());
  const auto ring_all = folded<TypeParam>(half, right, {});
  const auto ring_part = folded<TypeParam>(upper, quarter, centre);
  const Grid<2> tall(half);
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) {
      const auto here = static_cast<std::size_t>(small.stride(1) * (j + 1) + i + 1);
      const auto there = static_cast<std::size_t>(tall.stride(1) * (j + 11) + i + 1);
      EXPECT_NEAR(ring_part[here], (j == 0 ? 0.5 : 1) * ring_all[there], tolerance) << i << ' ' << j;
    }
  }
}

// --- in the engine --------------------------------------------------------------------------------------------------

// Uneven gas in a quarter of a bag, whose membrane ends on the walls. Gas also lies on the membrane, so that no node
// that has space is without.
Scene quarter_bag(Space space, const std::string& shape, bool another_gas) {
  const GridSpec grid = scenes::box(space, {9, 9, 1}, h, scenes::walls_everywhere(Wall::symmetry));
  std::vector<Place> ring, inside;
  for (int k = 0; k <= 32; ++k) {
    const double a = std::numbers::pi / 2 * k / 32;
    ring.push_back({k == 32 ? 0 : 0.57 * std::cos(a), k == 0 ? 0 : 0.57 * std::sin(a), 0});
  }
  for (const Place& place : scenes::jittered(scenes::lattice(grid, 4), 0.01, 2)) {
    if (std::hypot(place[0], place[1]) < 0.55) inside.push_back(place);
  }
  for (const Place& place : ring) inside.push_back({std::max(place[0], 1e-3), place[1], 0});
  scenes::Random random(8);
  const auto field = [&](auto&) { return scenes::GasState{random(0.5, 1.5), random(1, 2), {0, 0, 0}}; };
  std::vector<Body> bodies;
  bodies.push_back(scenes::gas_body(scenes::inviscid_law(), space, inside, h * h / 16, field));
  bodies[0].enclosure = Enclosure{"membrane", {{0, 0}}};
  bodies.push_back(scenes::skin_body(scenes::Skin::segments, space, ring, 0.02 * 0.028));
  if (space == Space::axisymmetric) bodies[1].points(column::mass)[32] = bodies[1].points(column::volume)[32] = 1e-6;
  if (another_gas) {
    bodies.push_back(
        scenes::gas_body(scenes::inviscid_law(), space, {inside.begin(), inside.begin() + 40}, h * h / 16, field));
    bodies[2].name = "another";
  }
  return scenes::scene_of(grid, std::move(bodies), shape, "apic");
}

double enclosed(const Scene& scene) {
  Corners polygon;
  for (const Place& place : scenes::places_of(scene.bodies[1], 2)) polygon.push_back({place[0], place[1]});
  polygon.push_back({0, 0});
  return content(polygon, scene.grid.axisymmetric);
}

// The gas fills the bag, neither more nor less, from the start and as both move; other gases of the field do not count.
// [Coupling 4]
TEST(EnclosedGas, FillsTheBag) {
  for (const Space space : {Space::plane, Space::axisymmetric}) {
    for (const char* shape : {"quadratic", "cubic"}) {
      for (const bool another : {false, true}) {
        for (const char* integrator : {"leapfrog", "energy"}) {
          Simulation run(quarter_bag(space, shape, another), integrator, {0.3, 2e-3});
          for (int k = 0; k < 4; ++k) {
            if (k > 0) {
              run.step(1);
              run.refresh_density();
            }
            const double inside = enclosed(run.scene());
            EXPECT_NEAR(scenes::sum_of(run.scene().bodies[0], column::volume), inside, 1e-13)
                << space << ' ' << shape << ' ' << integrator << ' ' << another << ' ' << k;
          }
        }
      }
    }
  }
}

// In the step itself, where the weights are of the start and the stress of that place.
TEST(EnclosedGas, FillsTheBagInAStep) {
  Scene scene = quarter_bag(Space::plane, "quadratic", false);
  const double inside = enclosed(scene);
  Simulation run(scene, "energy", {0.3, 2e-3});
  run.step(1);
  EXPECT_NEAR(scenes::sum_of(run.scene().bodies[0], column::volume), inside, 1e-13);
  EXPECT_GT(std::abs(enclosed(run.scene()) - inside), 1e-9);
}

TEST(EnclosedGas, RefusesAnEnclosureWhereAChainEnclosesNothing) {
  for (const Space space : {Space::line, Space::solid}) {
    Scene scene = scenes::gas_and_skin(scenes::Skin::segments, space, "quadratic", "apic", true);
    scene.bodies[0].enclosure = Enclosure{"membrane", {}};
    EXPECT_THROW(Simulation(scene, "energy", {0.3, 2e-3}), std::invalid_argument) << space;
  }
}

TEST(EnclosedGas, RefusesAnEnclosureThatIsNotThere) {
  Scene scene = quarter_bag(Space::plane, "quadratic", false);
  scene.bodies[0].enclosure->chain = "bladder";
  try {
    const Simulation run(scene, "energy", {0.3, 2e-3});
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("bladder"), std::string::npos);
  }
}

}  // namespace
}  // namespace plumbline::enclosed_volumes_test
