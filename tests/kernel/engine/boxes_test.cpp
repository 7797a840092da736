// The boxes of points: how they start, how they follow the deformation, and what that does to the ledger.
#include <Eigen/Geometry>

#include "tests/kernel/solids.hpp"

namespace plumbline::boxes_test {
namespace {

using scenes::Space;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

// Two points far from each other in a large grid of cells of 1, with boxes of `spacing`.
Scene two_points(Space space, const std::string& shape, double spacing, scenes::Law law = scenes::Law::neo_hookean) {
  const GridSpec grid = scenes::box(space, {12, 12, 12}, 1);
  Scene scene = scenes::scene_of(grid, {scenes::solid_body(law, space, {{4.3, 4.4, 4.6}, {8.2, 8.1, 8.7}}, 0.3)}, shape,
                                 "apic");
  scene.bodies[0].spacing = spacing;
  return scene;
}

void deform(Scene& scene, const Matrix& f, double hoop = 1) {
  Columns& points = scene.bodies[0].points;
  const int dim = scene.grid.dim;
  for (int p = 0; p < points.points(); ++p) {
    for (int k = 0; k < dim * dim; ++k) points(column::deformation, k)[p] = f(k / dim, k % dim);
    if (scene.grid.axisymmetric) points(column::deformation, 4)[p] = hoop;
  }
}

std::vector<double> half_sizes(Scene scene) {
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  std::vector<double> sizes;
  for (int d = 0; d < scene.grid.dim; ++d) sizes.push_back(scene.bodies[0].points(column::half_size, d)[1]);
  return sizes;
}

class Boxes : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Boxes, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// Cubes as wide as the points stand apart, or of the points' volume where nothing says how far that is.
TEST_P(Boxes, StartAsCubesOfTheSpacing) {
  for (const char* shape : {"gimp", "contiguous-gimp"}) {
    for (double size : half_sizes(two_points(GetParam(), shape, 0.7))) EXPECT_NEAR(size, 0.35, 1e-15);
    const double edge = std::pow(0.3, 1.0 / scenes::dim_of(GetParam()));
    for (double size : half_sizes(two_points(GetParam(), shape, 0))) EXPECT_NEAR(size, edge / 2, 1e-15);
  }
  for (const char* shape : {"linear", "quadratic", "cubic"}) {
    Scene scene = two_points(GetParam(), shape, 0.7);
    Ledger ledger;
    make_engine(scene, ledger, {});
    EXPECT_FALSE(scene.bodies[0].points.has(column::half_size)) << shape;
  }
}

// The half size along an axis is the root of three times the second moment of what became of the box along it, here summed
// over a fine lattice of its pieces: the midpoint rule of n pieces lacks 1/n^2 of a second moment. A stretch scales,
// a rotation by itself leaves a box what it is. [GIMP 2]
TEST_P(Boxes, KeepTheSecondMomentsOfTheirDeformation) {
  const int dim = scenes::dim_of(GetParam()), pieces = 60;
  Matrix f;
  f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  Scene scene = two_points(GetParam(), "contiguous-gimp", 0.6);
  deform(scene, f, 1.3);
  const auto sizes = half_sizes(scene);
  for (int d = 0; d < dim; ++d) {
    double moment = 0;
    const auto at = [&](int k) { return 0.3 * (2 * (k + 0.5) / pieces - 1); };
    const int each[3] = {pieces, dim > 1 ? pieces : 1, dim > 2 ? pieces : 1};
    for (int i = 0; i < each[0]; ++i) {
      for (int j = 0; j < each[1]; ++j) {
        for (int k = 0; k < each[2]; ++k) {
          const double y = f(d, 0) * at(i) + (dim > 1 ? f(d, 1) * at(j) : 0) + (dim > 2 ? f(d, 2) * at(k) : 0);
          moment += y * y / (each[0] * each[1] * each[2]);
        }
      }
    }
    EXPECT_NEAR(sizes[static_cast<std::size_t>(d)], std::sqrt(3 * moment), 0.3 / (pieces * pieces)) << d;
  }
  Matrix stretch = Matrix::Identity();
  stretch.diagonal() << 1.5, 0.7, 1.1;
  deform(scene, stretch);
  const auto stretched = half_sizes(scene);
  for (int d = 0; d < dim; ++d) EXPECT_NEAR(stretched[static_cast<std::size_t>(d)], 0.3 * stretch(d, d), 1e-15);
  if (dim == 1) return;
  const Vector axis = dim == 2 ? Vector(0, 0, 1) : Vector(1, 2, -2) / 3;
  deform(scene, Eigen::AngleAxisd(0.7, axis).toRotationMatrix());
  for (double size : half_sizes(scene)) EXPECT_NEAR(size, 0.3, 1e-15);
}

// Uniform boxes stay, and so do those of bodies whose law knows no deformation gradient.
TEST_P(Boxes, OthersStay) {
  Matrix f = 1.2 * Matrix::Identity();
  Scene uniform = two_points(GetParam(), "gimp", 0.6);
  deform(uniform, f);
  for (double size : half_sizes(uniform)) EXPECT_EQ(size, 0.3);
  for (double size : half_sizes(two_points(GetParam(), "contiguous-gimp", 0.6, scenes::Law::hooke)))
    EXPECT_EQ(size, 0.3);
}

// Beyond half a cell a box is cut: wider ones do bit for bit what that one does.
TEST_P(Boxes, AreCutAtHalfACell) {
  const auto run = [&](double spacing) {
    Scene scene = scenes::rough_solid(scenes::Law::hooke,
                                      scenes::rough_gas_in_space(GetParam(), "gimp", "apic", scenes::no_gravity));
    scene.bodies[0].spacing = spacing;
    Simulation one(std::move(scene), "usl", {0.3, 0.01});
    for (int k = 0; k < 3; ++k) one.step(1);
    return scenes::by_id(one.scene().bodies[0], column::velocity);
  };
  const auto half_a_cell = run(0.1);
  EXPECT_EQ(run(0.3), half_a_cell);
  EXPECT_NE(run(0.05), half_a_cell);
}

// With the box its inertia changes, and with that the energy and the spin of the affine velocity: every account closes, for
// every law, step and transfer. Ten steps of a thousand terms: 1e-13. [GIMP 1, 2]
TEST_P(Boxes, TheLedgerCloses) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator.starts_with("test_") || !scenes::runs_in(c, GetParam())) continue;
    for (scenes::Law law : scenes::laws) {
      if (!scenes::lives_in(law, GetParam())) continue;
      for (const bool walled : {false, true}) {
        SCOPED_TRACE(testing::Message() << c << ", " << law << (walled ? ", walls" : ""));
        const scenes::Place gravity{3, -9, GetParam() == Space::solid ? 5.0 : 0.0};
        const Scene gas = walled ? scenes::rough_gas(GetParam(), c.shape, c.transfer, gravity)
                                 : scenes::rough_gas_in_space(GetParam(), c.shape, c.transfer, gravity);
        Simulation run(scenes::rough_solid(law, gas), c.integrator, {0.2, {}});
        const int steps = c.shape == "linear" ? 3 : 10;
        for (int k = 0; k < steps; ++k) run.step(1);
        scenes::expect_ledger_closes(run.ledger(), 1e-13);
      }
    }
  }
}

// Without that entry it would not: of a body that stretches as it spins, the boxes' share is far beyond rounding. [GIMP 2]
TEST(DeformingBoxes, BookWhatTheirInertiaGains) {
  Scene scene = scenes::rough_solid(scenes::Law::neo_hookean,
                                    scenes::rough_gas_in_space(2, "contiguous-gimp", "apic", scenes::no_gravity));
  Scene still = scene;
  still.shape = "gimp";
  Simulation one(scene, "usl", {0.3, 0.01}), other(still, "usl", {0.3, 0.01});
  for (int k = 0; k < 10; ++k) {
    one.step(1);
    other.step(1);
  }
  scenes::expect_ledger_closes(one.ledger(), 1e-13);
  const Account &deforming = one.ledger().energy, &uniform = other.ledger().energy;
  EXPECT_GT(std::abs(deforming.flow(Flow::transfer) - uniform.flow(Flow::transfer)), 1e-6 * deforming.scale());
  // Momenta stay: what boxes do to spin is booked as transfer.
  const Account& turning = one.ledger().angular_momentum[2];
  EXPECT_NEAR(turning.store() - turning.initial(), turning.flow(Flow::transfer) + turning.flow(Flow::integration),
              1e-13 * turning.scale());
  for (std::size_t d = 0; d < 2; ++d) {
    const Account& momentum = one.ledger().momentum[d];
    EXPECT_NEAR(momentum.store(), momentum.initial(), 1e-14 * momentum.scale());
  }
}

}  // namespace
}  // namespace plumbline::boxes_test
