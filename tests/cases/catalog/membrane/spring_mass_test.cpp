// The spring's points, York's and those of the refinement study, and what is measured of their swing.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "reference/heavy_spring.hpp"
#include "tests/cases/catalog/run_by_name.hpp"

namespace plumbline::spring_mass_test {
namespace {

const Case& spring() { return find_case("spring-mass"); }

struct Hung {
  explicit Hung(const std::string& scheme, const std::vector<std::string>& typed = {})
      : settings(spring().settings(scheme, {}, typed)),
        scene(spring().problem(settings)->scene()) {}
  const Columns& points() const { return scene.bodies.front().points; }
  double at(const ColumnId& id, int p) const { return points()(id)[p]; }
  double sum(const ColumnId& id) const {
    double total = 0;
    for (const double value : points().values(id)) total += value;
    return total;
  }
  Settings settings;
  Scene scene;
};

// Ten points from y = 1.99 to 1.69, a thirtieth apart: nine of the spring and the mass. [York section 5.5]
TEST(SpringMass, YorksTenPoints) {
  const Hung york("york1997");
  ASSERT_EQ(york.points().points(), 10);
  for (int p = 0; p < 10; ++p) {
    EXPECT_NEAR(york.at(column::position, p), 1.99 - 0.3 * p / 9, 1e-14) << p;
    EXPECT_NEAR(york.at(column::volume, p), 0.1 * 0.3 / 9, 1e-16) << p;
    EXPECT_NEAR(york.at(column::mass, p), p < 9 ? 0.1 * 0.1 * 0.3 / 9 : 3.33, 1e-15) << p;
  }
  EXPECT_DOUBLE_EQ(york.scene.grid.h, 0.1);
}

TEST(SpringMass, YorksStep) {
  EXPECT_DOUBLE_EQ(spring().settings("york1997", {}).number("dt"), 1.8e-6);
  EXPECT_DOUBLE_EQ(spring().settings("york1997", {{"cells", 20.0}}).number("dt"), 0.9e-6);
  EXPECT_EQ(spring().settings("york1997", {}, {"dt=1e-6"}).number("dt"), 1e-6);
  EXPECT_EQ(spring().settings("york1997", {}).text("reference"), "massless");
  EXPECT_FALSE(spring().settings("default", {}).is_set("dt"));
}

// Points at both ends with half a spacing's share: volume and mass of the spring are exact, and the mass hangs at L.
TEST(SpringMass, PointsWithEnds) {
  for (const std::vector<std::string>& typed :
       {std::vector<std::string>{}, {"cells=40"}, {"cells=37", "ppc=3", "length=0.71"}}) {
    const Hung hung("default", typed);
    const double length = hung.settings.number("length");
    const int last = hung.points().points() - 1;
    EXPECT_EQ(hung.at(column::position, 0), 2.0);
    EXPECT_NEAR(hung.at(column::position, last), 2.0 - length, 1e-14);
    EXPECT_NEAR(hung.sum(column::volume), 0.1 * length, 1e-15);
    EXPECT_NEAR(hung.sum(column::mass), 3.33 + 0.1 * 0.1 * length, 1e-14);
    const double spacing = length / last;
    EXPECT_NEAR(hung.at(column::volume, 0), 0.1 * spacing / 2, 1e-16);
    EXPECT_NEAR(hung.at(column::volume, last), 0.1 * spacing / 2, 1e-16);
    EXPECT_NEAR(hung.at(column::mass, last), 3.33 + 0.1 * 0.1 * spacing / 2, 1e-15);
    for (int p = 1; p < last; ++p) {
      EXPECT_NEAR(hung.at(column::position, p), 2.0 - p * spacing, 1e-14);
      EXPECT_NEAR(hung.at(column::volume, p), 0.1 * spacing, 1e-16);
    }
  }
  EXPECT_EQ(Hung("default", {"cells=40"}).points().points(), 1 + 12 * 4);  // four a cell over 0.3 of 40 cells
}

TEST(SpringMass, HangsFromAFixedNodeAndFalls) {
  const Hung hung("default");
  EXPECT_EQ(hung.scene.grid.walls[0][0], Wall::free);
  EXPECT_EQ(hung.scene.grid.walls[0][1], Wall::symmetry);
  EXPECT_NEAR(hung.scene.grid.h * hung.scene.grid.cells[0], 2.0, 1e-14);
  EXPECT_EQ(hung.scene.gravity[0], -250);
}

// Both signs of strain: a spring, not a string.
TEST(SpringMass, TheSpringPushesToo) {
  Hung hung("default", {"youngs_modulus=7e5"});
  Body& body = hung.scene.bodies[0];
  body.points(column::strain)[1] = -0.01;
  body.points(column::strain)[2] = 0.02;
  body.material->evaluate_stress(body.points, all_points(body.points), {.dim = 1, .h = 0.1});
  EXPECT_NEAR(body.points(column::stress)[1], -7e3, 1e-9);
  EXPECT_NEAR(body.points(column::stress)[2], 1.4e4, 1e-9);
}

// --- after a run ------------------------------------------------------------------------------------------------------

RunResult run(const std::string& scheme, const std::vector<std::string>& typed) {
  const RunResult result = run_experiment(spring(), scheme, spring().settings(scheme, {}, typed));
  EXPECT_TRUE(result.finished);
  return result;
}

// The displacement is counted from rest, positive along gravity: after t it is g t^2 / 2 as long as the spring is slack,
// t << sqrt(m/k); the spring and the kernel's added inertia (under 2 % of the mass at h = 0.1) may change 5 % of it.
TEST(SpringMass, DisplacementCountsFromRestAndDownwards) {
  const RunResult result = run("default", {"t_end=2e-4"});
  const auto &t = column_of(result, "time"), &u = column_of(result, "displacement");
  ASSERT_GT(t.size(), 3u);
  for (std::size_t k = 2; k < t.size(); ++k) {
    EXPECT_GT(u[k], 0);
    // A step centred in time falls by g t^2 / 2; the spring takes (w t)^2 / 12 of that, 3.3e-4 at the end.
    const double exact = 250 * t[k] * t[k] / 2;
    EXPECT_NEAR(u[k], exact, 1e-3 * exact) << k;
  }
}

TEST(SpringMass, MeasuresAgainstTheReferenceThatIsAsked) {
  reference::SpringProblem given;
  given.gravity = 0.0025;
  const reference::HeavySpring heavy(given);
  const reference::MasslessSpring massless(given);
  const RunResult with_mass = run("default", {"gravity=0.0025"});
  const RunResult without = run("default", {"gravity=0.0025", "reference=massless"});
  EXPECT_EQ(measure(with_mass, "period").reference, heavy.period().value);
  EXPECT_EQ(measure(with_mass, "max_displacement").reference, heavy.max_displacement().value);
  EXPECT_EQ(measure(without, "period").reference, massless.period().value);
  EXPECT_EQ(measure(without, "max_displacement").reference, massless.max_displacement().value);
  EXPECT_GT(measure(with_mass, "period").reference_bound, 0);
  EXPECT_EQ(measure(with_mass, "period").value, measure(without, "period").value);
  EXPECT_EQ(with_mass.profile.find("kinetic_energy_reference"), nullptr);
  ASSERT_NE(without.profile.find("kinetic_energy_reference"), nullptr);
}

// Reference and points move together: twice the mass, another modulus, another length.
TEST(SpringMass, TheReferenceMovesWithTheSettings) {
  for (const std::vector<std::string>& typed : {std::vector<std::string>{"mass=6.66"},
                                                {"youngs_modulus=4e6"},
                                                {"area=0.2"},
                                                {"spring_density=50"},
                                                {"length=0.6"}}) {
    auto all = typed;
    all.insert(all.end(), {"gravity=0.0025", "cells=20"});
    const RunResult result = run("default", all);
    // The period is too long by h^2/(8 L^2) at least, 0.35 % at h = L/6; a bar of 0.45 of the mass adds its own smearing.
    EXPECT_NEAR(*measure(result, "period").value / *measure(result, "period").reference, 1, 0.02) << typed.front();
    EXPECT_NEAR(*measure(result, "max_displacement").value / *measure(result, "max_displacement").reference, 1, 0.02)
        << typed.front();
  }
}

TEST(SpringMass, TheProfileIsAHistoryOfModestLength) {
  const RunResult result = run("york1997", {});
  EXPECT_EQ(result.steps, 55556);
  EXPECT_EQ(result.profile.kind, "history");
  EXPECT_EQ(result.profile.abscissa, "time");
  const std::size_t rows = column_of(result, "time").size();
  EXPECT_LE(rows, 1500u);
  EXPECT_GT(rows, 700u);
  for (const ProfileColumn& column : result.profile.columns) EXPECT_EQ(column.values.size(), rows) << column.name;
  // York sees no difference in his figure, here 1 % of the amplitude of 0.005.
  for (std::size_t k = 0; k < rows; ++k) {
    EXPECT_NEAR(column_of(result, "displacement")[k], column_of(result, "displacement_reference")[k], 0.01 * 0.005);
  }
}

// What is left out of the ledger's residual is shown: energy lost by moving stress once a step and by the maps.
TEST(SpringMass, EnergyDriftIsIntegrationAndTransferOverTheScale) {
  for (const char* scheme : {"default", "york1997"}) {
    const RunResult result = run(scheme, {"t_end=0.01"});
    const Account& energy = result.ledger.energy;
    const double drift = (energy.flow(Flow::integration) + energy.flow(Flow::transfer)) / energy.scale();
    EXPECT_EQ(*measure(result, "energy_drift").value, drift) << scheme;
    EXPECT_EQ(measure(result, "energy_drift").scale, 1);
    EXPECT_NE(energy.flow(Flow::transfer), 0) << scheme;
  }
}

// Too short for one period: no period, and that is not a small error.
TEST(SpringMass, WithoutAWholePeriodThereIsNone) {
  const RunResult result = run("default", {"t_end=0.001"});
  EXPECT_ANY_THROW(measure(result, "period"));
  EXPECT_ANY_THROW(measure(result, "max_displacement"));
}

}  // namespace
}  // namespace plumbline::spring_mass_test
