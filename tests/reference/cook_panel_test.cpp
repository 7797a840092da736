// Cook's panel by finite elements: published values, what is linear in what, and its limits.
#include "reference/cook_panel.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::cook_panel_test {
namespace {

// Plane stress with E = 1, nu = 1/3 and a load of 1 moves the middle of the loaded side by 23.96 (the value in common use, as in P. G.
// Bergan, C. A. Felippa, Comput. Methods Appl. Mech. Eng. 50 (1985) 25). With the same mu and, in the plane, the same lambda: plane strain with E = 15/16 and
// nu = 1/4. The mean of the side differs from its middle by what the side bends, a percent at most.
TEST(CookPanel, MeanOfTheLoadedSideIsNearThePublishedMiddle) {
  const CookPanel panel = cook_panel({15.0 / 16, 0.25, 1});
  EXPECT_NEAR(2 * panel.work.value, 23.96, 0.01 * 23.96);
}

TEST(CookPanel, MeshesConvergeFromBelow) {
  const CookPanelProblem problem;
  const CookPanel limit = cook_panel(problem);
  double before = 0;
  for (const int elements : {4, 8, 16, 32, 64}) {
    const double here = cook_panel_on(problem, elements).corner.value;
    EXPECT_GT(here, before);
    before = here;
  }
  EXPECT_LT(before, limit.corner.value - limit.corner.bound);
}

// What the load does is linear in it, and goes as 1/E.
TEST(CookPanel, IsLinear) {
  const CookPanel one = cook_panel({200, 0.3, 10}), other = cook_panel({400, 0.3, 60});
  EXPECT_NEAR(other.corner.value, 3 * one.corner.value, 1e-9 * other.corner.value);
  EXPECT_NEAR(other.work.value, 18 * one.work.value, 1e-9 * other.work.value);
}

TEST(CookPanel, WrongProblemsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { cook_panel({0, 0.3, 1}); }), "youngs_modulus");
  EXPECT_EQ(refused_key([] { cook_panel({1, 0.5, 1}); }), "poisson");
  EXPECT_EQ(refused_key([] { cook_panel({1, -0.1, 1}); }), "poisson");
  EXPECT_EQ(refused_key([] { cook_panel({1, 0.3, -1}); }), "load");
  EXPECT_EQ(refused_key([] { cook_panel_on({}, 1); }), "elements");
  EXPECT_EQ(refused_key([] { cook_panel_on({}, 200); }), "elements");
}

}  // namespace
}  // namespace plumbline::reference::cook_panel_test
