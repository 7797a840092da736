// A body names the velocity field it moves with: bodies of one field move together, of two they do not know of
// each other.
#include "kernel/velocity_field.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline::velocity_field_test {
namespace {

Body block(const GridSpec& grid, int first_cell, double speed, const std::string& field) {
  const auto places = scenes::jittered(scenes::lattice(grid, 2, {first_cell, 1}, {first_cell + 3, 4}), 0.01, grid.dim);
  Body body = scenes::gas_body({}, grid.dim, places, scenes::lattice_volume(grid, 2), [&](const scenes::Place& x) {
    return scenes::GasState{1 + x[1], 0.01, {speed, 0.1 * x[0]}};
  });
  body.field = field;
  return body;
}

std::vector<double> places_after(const std::vector<Body>& bodies, const GridSpec& grid, std::size_t which) {
  Simulation run(scenes::scene_of(grid, bodies, "quadratic", "apic"), "energy", {0.3, 0.01});
  for (int k = 0; k < 40; ++k) run.step(1);  // 0.4 s at relative speed 2: through each other
  return scenes::by_id(run.scene().bodies[which], column::position);
}

TEST(VelocityField, BodiesOfTwoFieldsPassThroughEachOther) {
  for (const GridSpec& grid : {scenes::line(10, 0.1), scenes::plane(10, 5, 0.1)}) {
    const Body left = block(grid, 1, 1, "left"), right = block(grid, 5, -1, "right");
    const auto alone = places_after({left}, grid, 0), other_alone = places_after({right}, grid, 0);
    EXPECT_EQ(places_after({left, right}, grid, 0), alone);  // bit for bit
    EXPECT_EQ(places_after({left, right}, grid, 1), other_alone);
    EXPECT_GT(*std::min_element(alone.begin(), alone.end()),
              *std::max_element(other_alone.begin(), other_alone.end()) - 0.2);
  }
}

TEST(VelocityField, BodiesOfOneFieldMeet) {
  for (const GridSpec& grid : {scenes::line(10, 0.1), scenes::plane(10, 5, 0.1)}) {
    const Body left = block(grid, 1, 1, "common"), right = block(grid, 5, -1, "common");
    const auto alone = places_after({left}, grid, 0), together = places_after({left, right}, grid, 0);
    const auto other = places_after({left, right}, grid, 1);
    EXPECT_LT(*std::max_element(together.begin(), together.end()), *std::max_element(alone.begin(), alone.end()) - 0.1);
    if (grid.dim == 1) {
      EXPECT_LT(*std::max_element(together.begin(), together.end()), *std::min_element(other.begin(), other.end()));
    }
  }
}

TEST(VelocityField, VisitsTouchedNodesOnly) {
  const Grid<2> grid(scenes::plane(3, 2, 1));
  VelocityField<2> field(grid);
  field.touched[1] = {2, 4};
  field.touched[3] = {0, 1};
  std::vector<std::size_t> seen;
  field.for_touched(grid, [&](std::size_t i) { seen.push_back(i); });
  EXPECT_EQ(seen, (std::vector<std::size_t>{8, 9, 18}));
}

}  // namespace
}  // namespace plumbline::velocity_field_test
