// The rod of Taylor's test, and what is measured of it.
#include "cases/catalog/solid/taylor_rod.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/catalog/solid/rod_points.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "kernel/shapes/domain_columns.hpp"
#include "reference/plate_impact.hpp"

namespace plumbline::taylor_rod_test {
namespace {

RunResult run_with(const std::vector<std::string>& typed) {
  const Case& entry = find_case("taylor-bar");
  return run_experiment(entry, "default", entry.settings("default", {}, typed));
}
double value(const RunResult& run, const std::string& measure) { return *run.find(measure)->value; }

TEST(TaylorRod, IsThatOfTheSettings) {
  const Case& entry = find_case("taylor-bar");
  const auto problem = entry.problem(entry.settings("default", {}, {"cells=4", "yield_stress=3e8", "t_end=1e-6"}));
  const Scene scene = problem->scene();
  const Body& rod = scene.bodies[0];
  EXPECT_EQ(dynamic_cast<const J2Plasticity&>(*rod.material).yield_stress, 3e8);
  EXPECT_EQ(rod.points.points(), 8 * 81);
  EXPECT_EQ(scene.grid.walls[1][0], Wall::symmetry);
  EXPECT_EQ(problem->end_time(), 1e-6);
  double mass = 0;
  for (int p = 0; p < rod.points.points(); ++p) {
    mass += rod.points(column::mass)[p];
    EXPECT_EQ(rod.points(column::velocity, 1)[p], -227);
  }
  EXPECT_NEAR(mass, 8930 * 0.5 * 3.2e-3 * 3.2e-3 * 32.4e-3, 1e-12 * mass);  // per radian
}

TEST(TaylorRod, RefusesARodWithoutARow) {
  const Case& entry = find_case("taylor-bar");
  EXPECT_THROW(entry.problem(entry.settings("default", {}, {"cells=4", "length=1e-4"})), UsageError);
}

constexpr RodLaw law{130e9, 43e9, 8930, 400e6, 100e6};

Body one_point() {
  auto material = std::make_shared<J2Plasticity>();
  material->youngs_modulus = 117e9;
  material->density = 8930;
  material->yield_stress = 400e6;
  return rod_points(material, 1e-3, 1e-3, 1e-3, 8930);
}

// A point that is squashed to half its height and as much wider as keeps its volume: plastic strain ln 2, all of it flow.
TEST(TaylorRod, LinesAreStretchedByTheirFlow) {  // [Taylor 1], [Taylor 2]
  Body body = one_point();
  Columns& points = body.points;
  points(column::deformation, 0)[0] = points(column::deformation, 4)[0] = std::sqrt(2.0);
  points(column::deformation, 3)[0] = 0.5;
  points(column::plastic_strain)[0] = std::log(2.0);
  const RodPoints at(body, law);
  EXPECT_NEAR(at.stretch(0), 0.5, 1e-15);
  EXPECT_NEAR(at.excess_of_lines(), 0, 1e-15);
  EXPECT_NEAR(at.volume_off(0), 0, 1e-15);
  EXPECT_NEAR(at.sums().heat, 0.5e-9 * 400e6 * std::log(2.0), 1e-12);
  EXPECT_NEAR(at.sums().hardening, 0.5e-9 * 50e6 * std::pow(std::log(2.0), 2), 1e-12);
  // An elastic shortening by e more is no flow; an elastic strain that the stretch does not have is seen as volume and line.
  const double e = 0.01;
  points(column::deformation, 3)[0] *= std::exp(-e);
  EXPECT_NEAR(at.excess_of_lines(), e, 1e-12);
  points(column::elastic_strain, 1)[0] = -e;
  EXPECT_NEAR(at.excess_of_lines(), 0, 1e-12);
  EXPECT_NEAR(at.volume_off(0), 0, 1e-12);
  const double q = 2 * law.shear * e;  // of uniaxial strain
  EXPECT_NEAR(at.beyond_yield(0), (q - 400e6 - 100e6 * std::log(2.0)) / 400e6, 1e-12);
  EXPECT_NEAR(at.axial_stress(0), -(law.bulk + 4.0 / 3 * law.shear) * e * std::exp(e), 1e-3);
  const RodShape shape = at.shape();
  EXPECT_NEAR(shape.length, 0.5e-3 + 0.25e-3 * std::exp(-e), 1e-15);
  EXPECT_NEAR(shape.radius, 0.5e-3 + 0.5e-3 * std::sqrt(2.0), 1e-15);
}

TEST(TaylorRod, EnergyAtTheStartBoundsWhatLinesKeep) {  // [Taylor 1]
  const RunResult run = run_with({"cells=2", "t_end=1e-8", "hardening_modulus=0"});
  const double least = std::exp(-8930 * 227.0 * 227 / 2 / 400e6);
  EXPECT_NEAR(value(run, "lines_kept"), 1 / least, 1e-3 / least);
  EXPECT_NEAR(value(run, "estimate"), 32.4e-3 * least, 1e-12);
  const RunResult hardens = run_with({"cells=2", "t_end=1e-8", "hardening_modulus=1e9"});
  const double strain = -std::log(1 / value(hardens, "lines_kept"));
  EXPECT_NEAR(400e6 * strain + 0.5e9 * strain * strain, 0.5 * 8930 * 227 * 227, 1e-2 * 0.5 * 8930 * 227 * 227);
}

TEST(TaylorRod, FaceIsJudgedWhileNothingHasComeFromTheSide) {
  const RunResult soon = run_with({"cells=8", "t_end=3.4e-7", "length=2e-3"}),
                  later = run_with({"cells=2", "t_end=4e-7"});
  EXPECT_NEAR(*soon.find("face_plateau")->reference, reference::PlateImpact({}).plateau().stress.value, 1);
  EXPECT_GT(soon.find("face_velocity.L1")->error, 1);
  for (const std::string norm : {"face_velocity.L1", "face_stress.L1", "face_plastic_strain.L1", "face_plateau"}) {
    EXPECT_TRUE(std::isfinite(soon.find(norm)->error)) << norm;
    EXPECT_TRUE(std::isnan(later.find(norm)->error)) << norm;
  }
}

// Published figures stand beside the published rod alone.
TEST(TaylorRod, OtherRodsHaveNoPublishedLength) {
  EXPECT_EQ(*run_with({"cells=2", "t_end=1e-8"}).find("length")->reference, 0);
  EXPECT_EQ(*run_with({"cells=2", "velocity=1"}).find("radius")->reference, 0);
  EXPECT_NEAR(*run_with({"cells=2", "viscosity_linear=0"}).find("length")->reference, 21.45e-3, 1e-12);
}

TEST(TaylorRod, SlicesFollowTheOutline) {
  const RunResult run = run_with({"cells=2", "t_end=2e-5"});
  const auto column = [&](const std::string& name) { return run.profile.find(name)->values; };
  const std::vector<double> z = column("z"), radius = column("radius"), axis = column("plastic_strain_axis"),
                            most = column("plastic_strain_largest");
  ASSERT_GT(z.size(), 10u);
  EXPECT_GT(radius.front(), 1.3 * radius.back());
  EXPECT_NEAR(radius.back(), 3.2e-3, 1e-5);
  for (std::size_t k = 0; k < z.size(); ++k) EXPECT_GE(most[k], axis[k]);
  EXPECT_TRUE(std::is_sorted(z.begin(), z.end()));
  EXPECT_EQ(axis.back(), 0);
  EXPECT_NEAR(*run.find("radius")->value, *std::max_element(radius.begin(), radius.end()), 1e-15);
}

TEST(TaylorRod, PressureThatAlternatesIsMeasuredByItsAmplitude) {
  auto material = std::make_shared<J2Plasticity>();
  material->youngs_modulus = 117e9;
  material->density = 8930;
  material->yield_stress = 400e6;
  Body body = rod_points(material, 4e-3, 2e-3, 1e-3, 8930);
  ASSERT_EQ(body.points.points(), 8);
  for (int p = 0; p < 8; ++p) {
    body.points(column::elastic_strain, 0)[p] = 1e-3 * (p / 2) + ((p / 2) % 2 == 0 ? 1e-5 : -1e-5);
  }
  EXPECT_NEAR(RodPoints(body, law).alternation(2), law.bulk * 1e-5, 1e-6 * law.bulk * 1e-5);
}

}  // namespace
}  // namespace plumbline::taylor_rod_test
