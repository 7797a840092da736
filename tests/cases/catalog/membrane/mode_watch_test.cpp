// The coordinate of a mode, its period between zeros and what it loses, on motions whose answers are known.
#include "cases/catalog/membrane/mode_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/string.hpp"

namespace plumbline::mode_watch_test {
namespace {

constexpr double pi = std::numbers::pi;

// Five points on a line across x = 0, 0.25 ... 1; the watch reads their second component.
struct Model {
  explicit Model(double start = 0.01) : watch(shape(), 2.0, 1, start) {}

  static std::vector<double> shape() {
    std::vector<double> phi;
    for (int p = 0; p < 5; ++p) phi.push_back(std::sin(pi * p / 4));
    return phi;
  }

  // A run of one step that ends at `time` with points displaced as asked.
  void look(double time, double first, double second) {
    StringState state = straight_string({0.5, 2}, {1.5, 2}, 5);
    for (int p = 0; p < 5; ++p) {
      state.place[static_cast<std::size_t>(p)][1] += first * std::sin(pi * p / 4) + second * std::sin(2 * pi * p / 4);
    }
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.cells = {4, 4, 1};
    scene.bodies.push_back(string_body("string", "accumulated", {1, 1, 1, true}, state, 2));
    Simulation simulation(std::move(scene), "musl", {.cfl = 0.5, .dt = time, .threads = 1});
    simulation.run_until(time);
    watch.observe(simulation);
  }

  ModeWatch watch;
};

TEST(ModeWatch, FindsTheModeAndNothingElse) {
  Model model;
  model.look(0.1, 0.007, 0.0);
  EXPECT_NEAR(model.watch.coordinate().back(), 0.007, 1e-15);
  EXPECT_NEAR(model.watch.impurity(), 0, 1e-13);
  // sin 2x is orthogonal to sin x over the five points, and as large where their weights are equal.
  model.look(0.2, 0.005, 0.002);
  EXPECT_NEAR(model.watch.coordinate().back(), 0.005, 1e-14);
  EXPECT_NEAR(model.watch.impurity(), 0.2, 1e-12);
}

TEST(ModeWatch, PeriodFromTheFirstToTheThirdZero) {
  Model model;
  const double period = 0.8;
  for (int k = 1; k <= 100; ++k) {
    const double t = 0.0104 * k, decay = std::exp(-0.1 * t / period);
    model.look(t, 0.01 * decay * std::cos(2 * pi * t / period), 0);
  }
  // Straight lines between samples miss a zero of the decaying cosine by less than a hundredth of a step squared.
  ASSERT_TRUE(model.watch.period().has_value());
  EXPECT_NEAR(*model.watch.period(), period, 1e-5);
  // The top of exp(-a t) cos(w t) stands at tan(w t) = -a/w: earlier than a period by 0.4 % and lower by exp(-0.1).
  ASSERT_TRUE(model.watch.amplitude_loss().has_value());
  EXPECT_NEAR(*model.watch.amplitude_loss(), 1 - std::exp(-0.1), 3e-4);
}

TEST(ModeWatch, TooShortForAPeriodHasNone) {
  Model model;
  for (int k = 1; k < 5; ++k) model.look(0.1 * k, 0.01 * std::cos(pi * k / 5), 0);
  EXPECT_FALSE(model.watch.period().has_value());
  EXPECT_FALSE(model.watch.amplitude_loss().has_value());
}

TEST(ModeWatch, RowsForAProfile) {
  EXPECT_EQ(thinned_rows(3, 10), (std::vector<std::size_t>{0, 1, 2}));
  const auto rows = thinned_rows(1000, 100);
  EXPECT_LE(rows.size(), 101u);
  EXPECT_GE(rows.size(), 50u);
  EXPECT_EQ(rows[0], 0u);
  EXPECT_EQ(rows[1] - rows[0], rows[2] - rows[1]);
}

}  // namespace
}  // namespace plumbline::mode_watch_test
