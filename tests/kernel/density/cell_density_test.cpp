// The four densities, through the engine that chooses among them.
#include "kernel/density/cell_density.hpp"
#include "kernel/shapes/shape.hpp"

#include <algorithm>

#include "tests/kernel/scenes.hpp"

namespace plumbline::cell_density_test {
namespace {

constexpr DensityMethod by_mass[] = {DensityMethod::cell, DensityMethod::quadratic, DensityMethod::grid};

// Sums of some twenty products of numbers of order one.
constexpr double rounding = 2e-14;

GridSpec walled(int dim, Wall kind) {
  return scenes::box(scenes::space_of(dim), {6, 5, 4}, 0.25, scenes::walls_everywhere(kind));
}

Scene gas_scene(const GridSpec& grid, int per_cell, const std::string& shape, const scenes::GasField& field) {
  return scenes::scene_of(
      grid,
      {scenes::gas_body({}, grid.dim, scenes::lattice(grid, per_cell), scenes::lattice_volume(grid, per_cell), field)},
      shape, "flip");
}

std::vector<double> densities_of(Scene scene, DensityMethod method) {
  scene.density = method;
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  std::fill_n(scene.bodies[0].points(column::density), scene.bodies[0].points.points(), -1.0);
  engine->initialise();
  return scenes::by_id(scene.bodies[0], column::density);
}

// Walls or not inside, a gas that fills walled cells evenly has one density. [York 4.5, 4.6] [EC-APIC 2]
TEST(Density, AUniformGasIsUniformUpToTheWalls) {
  for (int dim : {1, 2, 3}) {
    for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
      for (DensityMethod method : by_mass) {
        for (const Choice& shape : scenes::shapes_in_space()) {
          for (int per_cell : {1, 2, 3}) {
            const auto field = [](auto&) { return scenes::GasState{1.7, 1, {0, 0}}; };
            for (double rho : densities_of(gas_scene(walled(dim, kind), per_cell, shape.name, field), method)) {
              EXPECT_NEAR(rho, 1.7, rounding) << shape.name;
            }
          }
        }
      }
    }
  }
}

// Rings of one density in cells up to the axis: the mean radius of even points is that of their cell. [York 4.5]
TEST(Density, CellsOfRingsHaveTheDensityOfTheirRings) {
  const GridSpec grid = scenes::box(scenes::Space::axisymmetric, {6, 5, 1}, 0.25,
                                    scenes::walls_everywhere(Wall::symmetry));
  for (int per_cell : {1, 2, 3}) {
    const Scene scene = scenes::scene_of(
        grid,
        {scenes::gas_body({}, scenes::Space::axisymmetric, scenes::lattice(grid, per_cell),
                          scenes::lattice_volume(grid, per_cell), [](auto&) { return scenes::GasState{1.7}; })},
        "linear", "flip");
    for (double rho : densities_of(scene, DensityMethod::cell)) EXPECT_NEAR(rho, 1.7, rounding);
  }
}

// A ramp rho = 1 + x + y/2: cells take its value at their centre, [York 4.5] as the mean of its points, [York
// 4.6] because symmetric weights keep a linear field; nodes keep it for the same reason and shapes interpolate
// it, [EC-APIC 2].
TEST(Density, ARampAwayFromTheEdges) {
  for (int dim : {1, 2, 3}) {
    const GridSpec grid = scenes::box(scenes::space_of(dim), {8, 8, 8}, 0.25);
    const auto ramp = [](const scenes::Place& x) { return 1 + x[0] + x[1] / 2 - x[2] / 4; };
    const auto places = scenes::lattice(grid, 2);
    for (const Choice& shape : scenes::shapes_in_space()) {
      for (DensityMethod method : by_mass) {
        const auto rho = densities_of(gas_scene(grid, 2, shape.name,
                                                [&](const scenes::Place& x) {
                                                  return scenes::GasState{ramp(x), 1, {0, 0}};
                                                }),
                                      method);
        for (std::size_t p = 0; p < places.size(); ++p) {
          scenes::Place where = places[p];
          bool inside = true;
          for (int d = 0; d < dim; ++d) {
            inside = inside && where[d] > 0.75 && where[d] < 1.25;
            if (method != DensityMethod::grid) where[d] = (std::floor(where[d] / 0.25) + 0.5) * 0.25;
          }
          if (inside) {
            EXPECT_NEAR(rho[p], ramp(where), scenes::terms(shape.name, dim) * rounding) << shape.name;
          }
        }
      }
    }
  }
}

// At a free edge half the kernel is empty; the cell methods know nothing beyond the cell or its neighbours.
TEST(Density, AtAFreeEdge) {
  const GridSpec grid = scenes::line(6, 0.25);
  const Scene scene = gas_scene(grid, 2, "quadratic", [](auto&) { return scenes::GasState{2, 1, {0, 0}}; });
  EXPECT_NEAR(densities_of(scene, DensityMethod::cell)[0], 2, rounding);
  // Quadratic weights of the edge cell: its own two points 11/16 each, two neighbours (9 + 1)/32. [York 4.6]
  EXPECT_NEAR(densities_of(scene, DensityMethod::quadratic)[0], 2 * (2 * 11.0 / 16 + 10.0 / 32) / 2, rounding);
}

// Every point of a cell has the cell's density: 3 and 1 points of the same mass. [York 4.5]
TEST(Density, CellsCountTheirOwnPoints) {
  const GridSpec grid = scenes::line(2, 0.5);
  Scene scene = scenes::scene_of(grid,
                                 {scenes::gas_body({}, 1, {{0.1, 0}, {0.2, 0}, {0.45, 0}, {0.9, 0}}, 0.25,
                                                   [](auto&) { return scenes::GasState{}; })},
                                 "linear", "flip");
  const auto rho = densities_of(scene, DensityMethod::cell);
  for (std::size_t p = 0; p < 3; ++p) EXPECT_NEAR(rho[p], 1.5, rounding);
  EXPECT_NEAR(rho[3], 0.5, rounding);
}

// The quadratic weights of a point off centre, mirrored at the wall: 1/2 (1/2 - f)^2 beyond it falls back into
// the cell. [York 4.6]
TEST(Density, QuadraticWeightsMirrorAtWalls) {
  for (Wall kind : {Wall::free, Wall::symmetry}) {
    const GridSpec grid = scenes::line(3, 1, scenes::walls_everywhere(kind));
    const Scene scene = scenes::scene_of(
        grid, {scenes::gas_body({}, 1, {{0.3, 0}}, 1, [](auto&) { return scenes::GasState{}; })}, "linear", "flip");
    const double own = 0.75 - 0.04, beyond = kind == Wall::free ? 0 : 0.5 * 0.49;
    EXPECT_NEAR(densities_of(scene, DensityMethod::quadratic)[0], own + beyond, rounding);
  }
}

// A second gas in the same cells, in the same velocity field or its own, before the motion and after it, adds
// nothing.
TEST(Density, OnlyABodysOwnMassCounts) {
  const GridSpec grid = walled(2, Wall::symmetry);
  const auto places = scenes::lattice(grid, 2);
  for (const std::string& other_field : {std::string("common"), std::string("other")}) {
    for (DensityMethod method : by_mass) {
      Scene scene = gas_scene(grid, 2, "quadratic", [](auto&) { return scenes::GasState{1.5, 1, {0.1, 0.2}}; });
      Body other = scenes::gas_body({}, 2, places, scenes::lattice_volume(grid, 2), [](auto&) {
        return scenes::GasState{40, 1, {0.1, 0.2}};
      });
      other.field = other_field;
      scene.bodies.push_back(other);
      scene.density = method;
      const auto expect_own = [&] {
        for (double rho : scenes::densities_in_use(scene.bodies[0])) EXPECT_NEAR(rho, 1.5, rounding);
        for (double rho : scenes::densities_in_use(scene.bodies[1])) EXPECT_NEAR(rho, 40, 40 * rounding);
      };
      Ledger ledger;
      const auto engine = make_engine(scene, ledger, {});
      engine->initialise();
      expect_own();
      engine->locate_points();
      engine->map_mass_and_momentum();
      engine->map_forces();
      engine->advance_momentum(0);
      engine->move_points(0);
      engine->evaluate_stress(NodalVelocity::end);
      expect_own();
    }
  }
}

// After the points moved, the density is that of their new places, although the step's weights are frozen.
// [EC-APIC 2]
TEST(Density, GridDensityFollowsThePoints) {
  Scene scene = scenes::rough_gas(2, "quadratic", "apic");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->map_forces();
  engine->advance_momentum(0.01);
  engine->move_points(0.01);
  engine->evaluate_stress(NodalVelocity::end);
  const auto moved = scenes::densities_in_use(scene.bodies[0]);
  const auto expected = densities_of(scene, DensityMethod::grid);
  for (std::size_t p = 0; p < moved.size(); ++p) EXPECT_NEAR(moved[p], expected[p], rounding);
}

// [York 4.7] Cold gas with v = -k x shrinks to (1 - k dt) x in a step, and the grid sees div v exactly. On a
// line continuity divides rho by 1 - k dt: exact. In the plane by 1 - 2 k dt, where the area shrinks by (1 - k
// dt)^2: rho k^2 dt^2 too much.
TEST(Density, ContinuityUnderUniformCompression) {
  const double k = 2;
  for (int dim : {1, 2}) {
    for (double dt : {0.001, 0.01, 0.05}) {
      const GridSpec grid = dim == 1 ? scenes::line(8, 0.25) : scenes::plane(8, 8, 0.25);
      const auto places = scenes::lattice(grid, 2, {1, 1}, {7, 7});
      const auto closing = [&](const scenes::Place& x) { return scenes::GasState{3, 0, {-k * x[0], -k * x[1]}}; };
      Scene scene = scenes::scene_of(
          grid, {scenes::gas_body({}, dim, places, scenes::lattice_volume(grid, 2), closing)}, "quadratic", "apic");
      scene.density = DensityMethod::continuity;
      Columns& points = scene.bodies[0].points;
      points.add(column::affine, dim * dim);
      for (int d = 0; d < dim; ++d) std::fill_n(points(column::affine, d * dim + d), places.size(), -k);
      Simulation run(std::move(scene), "usl", {0.3, dt});
      run.step(1);
      const double exact = 3 / std::pow(1 - k * dt, dim), error = dim == 1 ? 0 : 3 / (1 - 2 * k * dt) - exact;
      for (double rho : scenes::by_id(run.scene().bodies[0], column::density))
        EXPECT_NEAR(rho, exact + error, 3 * rounding);
      // error = rho k^2 dt^2 / ((1 - 2 k dt)(1 - k dt)^2)
      EXPECT_NEAR(error, dim == 1 ? 0 : exact * k * k * dt * dt / (1 - 2 * k * dt), rounding);
    }
  }
}

// Refreshed for a measure, densities are those of the places where the points stand.
TEST(Density, RefreshTakesTheLastPlaces) {
  Simulation run(scenes::rough_gas(2, "quadratic", "apic"), "energy", {0.3, {}});
  for (int k = 0; k < 3; ++k) run.step(1);
  const auto expected = densities_of(run.scene(), DensityMethod::grid);
  run.refresh_density();
  const auto rho = scenes::by_id(run.scene().bodies[0], column::density);
  for (std::size_t p = 0; p < rho.size(); ++p) EXPECT_NEAR(rho[p], expected[p], rounding);
}

}  // namespace
}  // namespace plumbline::cell_density_test
