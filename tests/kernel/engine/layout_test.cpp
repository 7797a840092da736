// What an engine refuses before it makes any part.
#include <gmock/gmock.h>

#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/simulation.hpp"

namespace plumbline::layout_test {
namespace {

// One point in the middle of four cells each way, of a body made for `made` dimensions.
Scene one_point(int dim, int made, std::shared_ptr<const Material> material, bool axisymmetric = false) {
  Scene scene;
  scene.grid.dim = dim;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) scene.grid.cells[d] = 4;
  Body body = make_body("lump", std::move(material), 1, made, axisymmetric);
  for (int d = 0; d < made; ++d) body.points(column::position, d)[0] = 2.5;
  body.points(column::mass)[0] = body.points(column::volume)[0] = 1;
  if (body.points.has(column::energy)) body.points(column::energy)[0] = 1;
  if (body.points.has(column::density)) body.points(column::density)[0] = 1;
  scene.bodies.push_back(std::move(body));
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    Simulation run(scene, "musl", {0.1, 1e-3});
    return "none";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(Layout, BodiesOfAnotherGeometryAreRefusedByTheFirstColumnThatDiffers) {
  const auto gas = std::make_shared<IdealGas>();
  const auto solid = std::make_shared<LinearElastic>();
  EXPECT_EQ(refusal(one_point(2, 2, gas)), "none");
  EXPECT_EQ(refusal(one_point(1, 2, gas)),
            "body lump has 2 components of position; its material and the grid's geometry want 1");
  EXPECT_EQ(refusal(one_point(3, 2, gas)),
            "body lump has 2 components of position; its material and the grid's geometry want 3");
  EXPECT_EQ(refusal(one_point(2, 2, solid, true)),
            "body lump has 4 components of stress; its material and the grid's geometry want 3");
}

}  // namespace
}  // namespace plumbline::layout_test
