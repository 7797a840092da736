// Set-ups of the cases of normals, and what every such case must have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/catalog/normals/marked_points.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/experiment.hpp"
#include "kernel/normals/normals.hpp"

namespace plumbline::normals_cases_test {
namespace {

class NormalsCases : public testing::TestWithParam<std::string> {};

TEST_P(NormalsCases, NothingMoves) {
  const Case& entry = find_case(GetParam());
  for (const char* scheme : {"default", "york1997"}) {
    const Settings settings = entry.settings(scheme, {});
    const Scene start = entry.problem(settings)->scene();
    const RunResult run = run_experiment(entry, scheme, settings);
    EXPECT_TRUE(run.finished);
    EXPECT_EQ(run.steps, 1);
    const Columns& points = start.bodies.front().points;
    for (int p = 0; p < points.points(); ++p) {
      EXPECT_EQ(run.profile.find("x")->values[static_cast<std::size_t>(p)], points(column::position)[p]);
    }
    for (const Choice& method : normals_methods()) {
      for (const char* what : {".max_angle_error_deg", ".mean_angle_error_deg"}) {
        ASSERT_NE(run.find(method.name + what), nullptr) << method.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, NormalsCases, testing::Values("normals-first-step", "normals-cell"), [](const auto& p) {
  std::string name = p.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

RunResult run(const std::string& name, const std::vector<std::string>& typed) {
  const Case& entry = find_case(name);
  return run_experiment(entry, "default", entry.settings("default", {}, typed));
}

TEST(MarkedPoints, AnglesHaveNoSign) {
  EXPECT_NEAR(angle_between(1, 0, 0.5, std::sqrt(0.75)), 60, 1e-13);
  EXPECT_NEAR(angle_between(-1, 0, 0.5, std::sqrt(0.75)), 60, 1e-13);
  EXPECT_EQ(angle_between(0, -2, 0, 1), 0);
  EXPECT_EQ(angle_between(0, 0, 0, 1), 90);
  EXPECT_TRUE(std::isnan(angle_between(std::nan(""), 0, 0, 1)));
}

TEST(NormalsFirstStep, YorksCircleAndItsEllipse) {
  const RunResult circle = run("normals-first-step", {});
  const auto &x = circle.profile.find("x")->values, &y = circle.profile.find("y")->values;
  ASSERT_EQ(x.size(), 179u);
  for (std::size_t p = 0; p < x.size(); ++p) {
    EXPECT_NEAR(std::hypot(x[p], y[p]), 1, 1e-15);
    EXPECT_NEAR(circle.profile.find("normal_x")->values[p], x[p], 1e-15);
  }
  // The normal of an ellipse turns by 90 degrees with the tangent (-sin a, b cos a).
  const RunResult ellipse = run("normals-first-step", {"aspect=0.5", "membrane_points=none", "ppc=3"});
  const auto &ex = ellipse.profile.find("x")->values, &ey = ellipse.profile.find("y")->values;
  ASSERT_EQ(ex.size(), 47u);  // 30 pi/2
  for (std::size_t p = 0; p < ex.size(); ++p) {
    EXPECT_NEAR(-2 * ey[p] * ellipse.profile.find("normal_x")->values[p] +
                    0.5 * ex[p] * ellipse.profile.find("normal_y")->values[p],
                0, 1e-15);
  }
}

// More gas inside helps the gradients of colour and nobody else.
TEST(NormalsFirstStep, TheInteriorIsSeenByColoursAlone) {
  const RunResult empty = run("normals-first-step", {}), gas = run("normals-first-step", {"interior=16"});
  for (const Choice& method : normals_methods()) {
    const std::string measure = method.name + ".mean_angle_error_deg";
    const bool colour = method.name == "york-simple" || method.name == "york-quadratic" || method.name == "york-cubic";
    if (colour) {
      EXPECT_LT(gas.find(measure)->error, 0.5 * empty.find(measure)->error) << method.name;
    } else {
      EXPECT_EQ(gas.find(measure)->error, empty.find(measure)->error) << method.name;
    }
  }
}

// The ordinates he prints, to their last place.
TEST(NormalsCell, TheUprightArcHasYorksOrdinates) {
  const RunResult arc = run("normals-cell", {"curve=arc-90"});
  std::vector<double> y = arc.profile.find("y")->values;
  ASSERT_EQ(y.size(), 8u);
  std::sort(y.rbegin(), y.rend());
  const double printed[] = {0.7984, 0.7853, 0.7598};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(y[2 * k], printed[k], 1e-4);
    EXPECT_NEAR(y[2 * k], y[2 * k + 1], 1e-15);
  }
}

TEST(NormalsCell, EveryCurveStandsInItsCellWithItsNormals) {
  for (const char* curve :
       {"line-45", "line-80", "hyperbola", "arc-45", "arc-60", "arc-75", "arc-90", "vertical", "perturbed"}) {
    const RunResult cell = run("normals-cell", {std::string("curve=") + curve});
    const auto &x = cell.profile.find("x")->values, &y = cell.profile.find("y")->values;
    const auto &nx = cell.profile.find("normal_x")->values, &ny = cell.profile.find("normal_y")->values;
    ASSERT_EQ(x.size(), 8u) << curve;
    for (std::size_t p = 0; p < 8; ++p) {
      EXPECT_TRUE(x[p] > 0 && x[p] < 1 && y[p] > 0 && y[p] < 1) << curve;
      EXPECT_NEAR(std::hypot(nx[p], ny[p]), 1, 1e-15) << curve;
    }
    // Chords between points stand nearly upright on the mean of their ends' normals: exactly on lines and circles.
    if (std::string(curve) == "hyperbola" || std::string(curve) == "perturbed") continue;
    for (std::size_t p = 1; p < 8; ++p) {
      EXPECT_NEAR((x[p] - x[p - 1]) * (nx[p] + nx[p - 1]) + (y[p] - y[p - 1]) * (ny[p] + ny[p - 1]), 0, 1e-14) << curve;
    }
  }
}

TEST(NormalsCell, TheSinglePointIsAloneInItsCell) {
  const RunResult cell = run("normals-cell", {"curve=single"});
  const auto &x = cell.profile.find("x")->values, &y = cell.profile.find("y")->values;
  const auto& judged = cell.profile.find("judged")->values;
  int inside = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const bool here = x[p] > 0 && x[p] < 1 && y[p] > 0 && y[p] < 1;
    inside += here ? 1 : 0;
    EXPECT_EQ(judged[p], here ? 1 : 0);
  }
  EXPECT_EQ(inside, 1);
}

}  // namespace
}  // namespace plumbline::normals_cases_test
