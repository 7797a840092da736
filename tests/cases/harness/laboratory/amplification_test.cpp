#include "cases/harness/laboratory/amplification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "cases/harness/laboratory/bar_patch.hpp"
#include "reference/mpm_amplification.hpp"
#include "reference/spectral_radius.hpp"
#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

namespace plumbline::amplification_test {
namespace {

constexpr double pi = std::numbers::pi;

Amplification of_bar(const std::string& integrator, const MapChoice& maps, int ppc, double place, double dt) {
  return {bar_patch(maps, ppc, place, {1, 10}), {integrator, {}}, Positions::frozen, dt};
}

reference::ComplexMatrix for_gsl(const Eigen::MatrixXcd& matrix) {
  reference::ComplexMatrix copy(static_cast<int>(matrix.rows()));
  for (int i = 0; i < copy.size; ++i) {
    for (int j = 0; j < copy.size; ++j) copy(i, j) = matrix(i, j);
  }
  return copy;
}

// One point a cell at N = 1/2 by hand: v_p' = v_p + dt/2 (s_{p+1} - s_{p-1}), s_p' = s_p + dt/2 (v_{p+1} - v_{p-1}), so a
// wave e^{i theta p} meets the matrix ((1, i dt sin theta), (i dt sin theta, 1)).
TEST(Amplification, OfForwardEulerOnABar) {
  const double dt = 0.7;
  const Amplification a = of_bar(made_up::forward_euler, {}, 1, 0.5, dt);
  EXPECT_EQ(a.unknowns(), 2);  // velocity and strain; stresses are found anew
  EXPECT_LE(a.tail(), 1e-12);
  EXPECT_LE(a.differences().error, 1e-8);
  for (const double theta : {0.3, 1.0, pi / 2, 2.9, -1.2}) {
    const Eigen::MatrixXcd m = a.at({theta, 0});
    const std::complex<double> off(0, dt * std::sin(theta));
    ASSERT_EQ(m.rows(), 2);
    EXPECT_LE(std::abs(m(0, 0) - 1.0), 1e-9);
    EXPECT_LE(std::abs(m(1, 1) - 1.0), 1e-9);
    EXPECT_LE(std::abs(m(0, 1) - off), 1e-9);
    EXPECT_LE(std::abs(m(1, 0) - off), 1e-9);
    EXPECT_NEAR(a.spectral_radius({theta, 0}), std::hypot(1, dt * std::sin(theta)), 1e-9);
  }
  const WorstWave worst = worst_wave(a, 1);
  EXPECT_NEAR(worst.radius, std::hypot(1, dt), 1e-9);
  EXPECT_NEAR(worst.theta[0], pi / 2, 1e-3);
}

// Eigen's eigenvalues against GSL's, of the same matrices. Both know the eigenvalues that meet at one to the root of the
// rounding.
TEST(Amplification, SpectralRadiusAsByGsl) {
  for (const char* integrator : {"usl", "musl", "rk4"}) {
    for (const char* shape : {"linear", "quadratic"}) {
      const Amplification a = of_bar(integrator, {shape, "flip", 2}, 2, 0.3, 1.1);
      for (const double theta : {0.4, 1.9, pi}) {
        const reference::Bounded radius = reference::spectral_radius(for_gsl(a.at({theta, 0})));
        EXPECT_NEAR(a.spectral_radius({theta, 0}), radius.value, radius.bound + 1e-7) << integrator << " " << shape;
      }
    }
  }
}

// Against the matrix that linear algebra makes of the maps, without a kernel. Differences of a step that is linear know it
// to the rounding of a state over the size of a change, 1e-12, and its eigenvalues where they meet to the root of that.
TEST(Amplification, RadiiAsByLinearAlgebra) {
  const struct {
    const char* integrator;
    reference::StressUpdate update;
  } updates[] = {{"usf", reference::StressUpdate::first},
                 {"usl", reference::StressUpdate::last},
                 {"musl", reference::StressUpdate::modified_last},
                 {"usavg", reference::StressUpdate::averaged}};
  const struct {
    MapChoice maps;
    reference::GridShape shape;
    reference::GridTransfer transfer;
  } maps[] = {{{"linear", "flip", 2}, reference::GridShape::linear, reference::GridTransfer::flip},
              {{"quadratic", "apic", 2}, reference::GridShape::quadratic, reference::GridTransfer::apic},
              {{"cubic", "pic", 2}, reference::GridShape::cubic, reference::GridTransfer::pic}};
  for (const auto& u : updates) {
    for (const auto& m : maps) {
      const double courant = 2.2, place = 0.3;
      const Amplification a = of_bar(u.integrator, m.maps, 2, place, courant);
      EXPECT_LE(a.tail(), 1e-10);
      for (const double theta : {0.7, 2.1, pi}) {
        const double radius = reference::spectral_radius(
                                  reference::amplification_matrix({u.update, m.shape, m.transfer},
                                                                  {place / 2, (1 + place) / 2}, theta, courant))
                                  .value;
        EXPECT_NEAR(std::max(1.0, a.spectral_radius({theta, 0})), std::max(1.0, radius), 2e-6)
            << u.integrator << " " << m.maps.shape << " " << m.maps.transfer << " " << theta;
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::amplification_test
