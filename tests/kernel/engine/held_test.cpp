// What a scene does not need it does not pay for: bytes held for each node and for each point, by kind of scene.
#include <malloc.h>

#include "kernel/grid.hpp"
#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::held_test {
namespace {

using scenes::Space;

double bytes_in_use() {
  const auto now = mallinfo2();
  return static_cast<double>(now.uordblks) + static_cast<double>(now.hblkhd);
}

double bytes_after_steps(const Scene& scene, const std::string& integrator) {
  const double before = bytes_in_use();
  Simulation run(scene, integrator, {0.3, 1e-3});
  for (int k = 0; k < 2; ++k) run.step(1);
  return bytes_in_use() - before;
}

// Of a node more, where no point is: the grid is made wider by many columns of nodes, the number of rows stays. Large blocks
// are whole pages, so that the last bytes are not told.
double bytes_per_node(Scene scene, const std::string& integrator) {
  const double narrow = bytes_after_steps(scene, integrator);
  constexpr int wider = 20000;
  scene.grid.cells[0] += wider;
  const int rows = scene.grid.cells[1] + 1 + 2 * Grid<2>::ghosts;
  return std::round((bytes_after_steps(scene, integrator) - narrow) / (1.0 * wider * rows));
}

// In the plane. Arrays of every field: M_i twice, P_i, v_i, f_i, v~_i and the midpoint's.
constexpr double scalar = 8, vector = 16, every_field = 2 * scalar + 5 * vector, order = 4;  // of sorted points
constexpr double densities = 2 * scalar;                                                     // rho_i and 1 / |cell_i|

Scene gas(const std::string& transfer = "apic") {
  return scenes::rough_gas_in_space(Space::plane, "quadratic", transfer, {0, 0, 0}, scenes::inviscid_law());
}
Scene solid(scenes::Law law) { return scenes::rough_solid(law, gas()); }

TEST(Held, PerNode) {
  if (bytes_in_use() == 0) GTEST_SKIP() << "this allocator tells nothing";
  const double plain = every_field + order + densities;
  EXPECT_EQ(bytes_per_node(gas(), "leapfrog"), plain);
  EXPECT_EQ(bytes_per_node(gas(), "energy"), plain);
  const double elsewhere = 2 * scalar;  // mass and density of points where they have moved to
  EXPECT_EQ(bytes_per_node(gas(), "usl"), plain + elsewhere);
  EXPECT_EQ(bytes_per_node(gas(), "musl"), plain + elsewhere + vector) << "velocities mapped again";
  Scene exchanging = gas();
  exchanging.heat_exchange = 1;
  EXPECT_EQ(bytes_per_node(exchanging, "leapfrog"), plain + 2 * scalar) << "E_i and alpha_i";
  EXPECT_EQ(bytes_per_node(exchanging, "usl"), plain + elsewhere) << "an integrator that exchanges no heat";
  Scene heavy = gas();
  heavy.gravity = {0, -9, 0};
  EXPECT_EQ(bytes_per_node(heavy, "leapfrog"), plain + vector) << "body forces";
  Scene sharpened = gas();
  sharpened.sharpening = 1;
  EXPECT_EQ(bytes_per_node(sharpened, "leapfrog"), plain + vector) << "straining velocities";
  Scene cells = gas();
  cells.density = DensityMethod::continuity;
  EXPECT_EQ(bytes_per_node(cells, "leapfrog"), plain - densities);
  for (const scenes::Law law : {scenes::Law::hooke, scenes::Law::neo_hookean}) {
    EXPECT_EQ(bytes_per_node(solid(law), "midpoint"), every_field + order) << "no gas";
  }
  Scene filtered = solid(scenes::Law::hooke);
  filtered.transfer = "xpic";
  filtered.bodies[0].points.add(column::affine, 4);
  EXPECT_EQ(bytes_per_node(filtered, "midpoint"), every_field + order + vector) << "filtered velocities";
  EXPECT_EQ(bytes_per_node(solid(scenes::Law::segments), "leapfrog"), every_field) << "a chain is not sorted";
}

// x, v, m, V, then stress and strain rate of one component of an inviscid gas, of three of a viscous gas or a solid, of four
// of finite strains, two of segments; rho, e, p; the strain; the affine part; the loss.
TEST(Held, ColumnsOfAPoint) {
  const auto columns = [](const Scene& scene, const std::string& integrator) {
    return Simulation(scene, integrator, {0.3, 1e-3}).scene().bodies[0].points.doubles_per_point();
  };
  constexpr int every_point = 6, affine = 4, thermal = 3, loss = 1;
  const auto tensors = [](int components) { return 2 * components; };
  EXPECT_EQ(columns(gas("flip"), "musl"), every_point + tensors(1) + thermal);
  EXPECT_EQ(columns(gas("apic"), "musl"), every_point + tensors(1) + thermal + affine);
  EXPECT_EQ(columns(gas("apic"), "leapfrog"), every_point + tensors(1) + thermal + affine + loss);
  const Scene viscous = scenes::rough_gas_in_space(Space::plane, "quadratic", "apic", {0, 0, 0}, scenes::rough_law());
  EXPECT_EQ(columns(viscous, "leapfrog"), every_point + tensors(3) + thermal + affine + loss);
  EXPECT_EQ(columns(solid(scenes::Law::hooke), "leapfrog"), every_point + tensors(3) + affine + 3) << "strain";
  EXPECT_EQ(columns(solid(scenes::Law::neo_hookean), "leapfrog"), every_point + tensors(4) + affine + 4)
      << "deformation";
  EXPECT_EQ(columns(solid(scenes::Law::segments), "leapfrog"), every_point + tensors(2) + affine + 2 + 4)
      << "strain and rest length, and the force of the segment at both ends";
}

}  // namespace
}  // namespace plumbline::held_test
