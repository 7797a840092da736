// The start of a manufactured motion on points, and its load and errors.
#include "cases/catalog/solid/manufactured_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "cases/harness/run/experiment.hpp"

namespace plumbline::manufactured_problem_test {
namespace {

using reference::Tensor;
using reference::Vector;

Scene scene_of(const std::string& name, const std::vector<std::string>& typed = {}) {
  const Case& entry = find_case(name);
  return entry.problem(entry.settings("default", {}, typed))->scene();
}

// In the cube u is not zero at t = 0, so dv/dx differs from dv/dX: by hand from the motion's own formula.
TEST(ManufacturedProblem, VelocityGradientsAreThoseOfTheDisplacedPlace) {
  const auto cube = reference::mms_axis_aligned(reference::mms_cube_problem());
  const Vector<double> x{0.21, 0.55, 0.83};
  const Tensor<double> gradient = initial_velocity_gradient(*cube, x, 1);
  const double pi = std::acos(-1.0), phase[] = {0, 2 * pi / 3, 4 * pi / 3};
  for (std::size_t d = 0; d < 3; ++d) {
    const double slope = 0.1 * pi * std::cos(pi * x[d]);
    const double expected = slope * 100 * pi * std::cos(phase[d]) / (1 + slope * std::sin(phase[d]));
    for (std::size_t e = 0; e < 3; ++e) {
      EXPECT_NEAR(gradient[3 * d + e], d == e ? expected : 0.0, 1e-7 * 100) << d << e;  // 1e-9 of v = 31 over 1
    }
  }
}

// The vortex turns and shears: grad v at the start is alpha' r x e_r e_theta plus the spin; its trace is zero.
TEST(ManufacturedProblem, TheVortexStartsWithoutAChangeOfVolume) {
  const auto vortex = reference::mms_vortex();
  for (const Vector<double>& x : {Vector<double>{0.9, 0.1, 0}, Vector<double>{-0.4, 0.8, 0}}) {
    const Tensor<double> gradient = initial_velocity_gradient(*vortex, x, 0.5);
    EXPECT_NEAR(gradient[0] + gradient[3], 0, 1e-6);
    EXPECT_GT(std::abs(gradient[1] - gradient[2]), 1);
  }
}

TEST(ManufacturedProblem, PointsStartDisplacedDeformedAndMoving) {
  const auto ring = reference::mms_ring();
  auto material = material_of(*ring);
  Body body = make_body("ring", material, 1, 2);
  body.points(column::position, 0)[0] = 0.6;
  body.points(column::position, 1)[0] = 0.3;
  start_motion(*ring, true, body);
  const double at[] = {0.6, 0.3};
  const auto exact = ring->values(at, 0);
  for (int d = 0; d < 2; ++d) {
    const auto k = static_cast<std::size_t>(d);
    EXPECT_DOUBLE_EQ(body.points(column::position, d)[0], at[k] + exact.displacement[k]);
    EXPECT_EQ(body.points(column::velocity, d)[0], exact.velocity[k]);
  }
  EXPECT_NE(exact.displacement[0], 0);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(body.points(column::deformation, k)[0], exact.deformation[static_cast<std::size_t>(k)]);
    EXPECT_NEAR(body.points(column::affine, k)[0], 0, 1e-12);  // at rest
  }
  EXPECT_EQ(material->youngs_modulus, 1e4);
  EXPECT_EQ(material->poissons_ratio, 0);
  EXPECT_EQ(material->density, 1);
}

TEST(ManufacturedProblem, OnlyTheAffineTransferCarriesGradients) {
  EXPECT_TRUE(scene_of("mms-bar").bodies[0].points.has(column::affine));
  EXPECT_FALSE(scene_of("mms-bar", {"transfer=flip"}).bodies[0].points.has(column::affine));
}

// By number, not by place in the arrays; at the time asked.
TEST(ManufacturedProblem, TheLoadFollowsThePointsNumbers) {
  Scene scene = scene_of("mms-bar", {"cells=8"});
  Body& body = scene.bodies[0];
  body.points.add(column::body_force);
  std::vector<int> turned(body.id.rbegin(), body.id.rend());
  body.load(0.003, body.points, turned);
  const auto bar = reference::mms_axis_aligned(reference::mms_bar_problem());
  for (int p = 0; p < body.points.points(); ++p) {
    const double x = (turned[static_cast<std::size_t>(p)] + 0.5) / 16;
    EXPECT_DOUBLE_EQ(body.points(column::body_force)[p], bar->body_force({&x, 1}, 0.003)[0]) << p;
  }
}

// The error is the norm over the body, in volume, of what the points are off: after one step of almost nothing it is that
// of the first step; the largest over time is at least that of the end.
TEST(ManufacturedProblem, TheWorstErrorIsTheNormOverTheBody) {
  const Case& bar = find_case("mms-bar");
  const RunResult run = run_experiment(bar, "default", bar.settings("default", {}, {"cells=16", "t_end=0.02"}));
  ASSERT_TRUE(run.finished);
  const Measure *worst = run.find("displacement.worst"), *end = run.find("displacement.L2");
  ASSERT_TRUE(worst && end);
  EXPECT_GE(worst->error, end->error * 0.999);  // over a length of 1 both are the same norm at the end
  EXPECT_LT(worst->error, 2 * end->error);
  EXPECT_NEAR(worst->scale, 0.05 / std::sqrt(2.0), 0.02 * 0.05);  // of A sin(pi X) sin(omega t) at its largest
  EXPECT_EQ(run.profile.find("time")->values.size(), run.profile.find("displacement_error")->values.size());
  EXPECT_DOUBLE_EQ(run.profile.find("time")->values.back(), 0.02);
}

}  // namespace
}  // namespace plumbline::manufactured_problem_test
