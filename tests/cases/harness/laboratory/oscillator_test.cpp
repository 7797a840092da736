#include "cases/harness/laboratory/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/catalog/stability/orders_in_time.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/laboratory/claims.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "reference/oscillator_limits.hpp"
#include "reference/spectral_radius.hpp"

namespace plumbline::oscillator_test {
namespace {

using reference::OscillatorMethod;

// Every stage as its documentation says, with numbers that no two stages share.
TEST(OneMass, StagesDoWhatTheySay) {
  OneMass mass(0.5, 2, 0);
  mass.locate_points();
  mass.map_mass_and_momentum();
  mass.map_forces();  // -0.5, as at the start
  mass.advance_momentum(0.4);
  EXPECT_EQ(mass.velocity(), 2);  // of the point: not before it is moved or kicked
  mass.strain_points(0.1, NodalVelocity::start);
  EXPECT_NEAR(mass.displacement(), 0.7, 1e-15);
  mass.strain_points(0.1, NodalVelocity::end);
  EXPECT_NEAR(mass.displacement(), 0.88, 1e-15);
  mass.strain_points(0.1, NodalVelocity::midpoint);
  EXPECT_NEAR(mass.displacement(), 1.07, 1e-15);
  mass.strain_points(0.1, NodalVelocity::current);  // the newest: of the end
  EXPECT_NEAR(mass.displacement(), 1.25, 1e-15);
  EXPECT_EQ(mass.place(), 0.5);
  mass.drift_points(7);
  EXPECT_EQ(mass.place(), 14.5);
  EXPECT_NEAR(mass.displacement(), 1.25, 1e-15);
  mass.kick_points(0.4);
  EXPECT_NEAR(mass.velocity(), 1.8, 1e-15);
  mass.map_momentum();
  mass.strain_points(1, NodalVelocity::remapped);
  EXPECT_NEAR(mass.displacement(), 3.05, 1e-15);
  mass.map_forces();  // the stress was not evaluated since
  mass.advance_momentum(1);
  mass.move_points(1, NodalVelocity::end);
  EXPECT_NEAR(mass.velocity(), 1.5, 1e-15);
  EXPECT_NEAR(mass.place(), 16, 1e-14);
  mass.predict_stress(0.1, NodalVelocity::start);
  EXPECT_NEAR(mass.carried()[2], -(3.05 + 0.1 * 2), 1e-15);
  EXPECT_NEAR(mass.displacement(), 3.05, 1e-15);  // predicted alone
}

TEST(OneMass, StatesAndRates) {
  OneMass mass(0.5, 2, 0.1);
  EXPECT_EQ(mass.state().values, (std::vector<double>{0.5, 2, 0.5}));
  EXPECT_NEAR(mass.rate().values[0], 2, 0);
  EXPECT_NEAR(mass.rate().values[1], -0.5 - 0.2 * 2, 1e-15);
  EXPECT_NEAR(mass.rate().values[2], 2, 0);
  mass.set_state({{7, 4, 3}});
  EXPECT_EQ(mass.place(), 7);
  EXPECT_EQ(mass.displacement(), 3);
  EXPECT_EQ(mass.velocity(), 4);
  EXPECT_EQ(mass.velocities_of({{5, 6, 7}}).values, (std::vector<double>{0, 6, 0}));
}

TEST(OneMass, AnySpringAndGravity) {
  OneMass mass(0.5, 2, Spring{[](double u) { return -u * u; }, 0, 0.125});
  mass.map_mass_and_momentum();
  mass.map_forces();
  mass.advance_momentum(1);
  mass.kick_points(1);
  EXPECT_EQ(mass.velocity(), 2 - 0.25 + 0.125);
  EXPECT_EQ(OneMass(0.5, 2, Spring{[](double u) { return -u * u; }, 0, 0.125}).rate().values[1], -0.125);
}

// A damper that pulls along with the midpoint velocity is given that velocity instead.
TEST(OneMass, ADamperMayNotPush) {
  OneMass mass(10, 1, 0.25);
  mass.map_mass_and_momentum();
  mass.evaluate_stress(NodalVelocity::start);
  mass.map_forces();
  EXPECT_NEAR(mass.carried()[2], -10.5, 1e-15);
  mass.advance_momentum(0.1);
  EXPECT_FALSE(mass.reverse_cooling());
  mass.advance_momentum(1);  // to -9.5, the middle at -4.25
  EXPECT_TRUE(mass.reverse_cooling());
  EXPECT_NEAR(mass.carried()[2], -10 + 0.5 * 4.25, 1e-14);
  EXPECT_FALSE(mass.reverse_cooling());
  OneMass spring(10, 1, 0);
  spring.map_mass_and_momentum();
  spring.map_forces();
  spring.advance_momentum(1);
  EXPECT_FALSE(spring.reverse_cooling());
}

double radius_by_gsl(const Eigen::MatrixXd& matrix) {
  reference::SquareMatrix copy(static_cast<int>(matrix.rows()));
  for (int i = 0; i < copy.size; ++i) {
    for (int j = 0; j < copy.size; ++j) copy(i, j) = matrix(i, j);
  }
  return reference::spectral_radius(copy).value;
}

// What integrators are where no maps filter velocities.
const struct {
  const char* integrator;
  OscillatorMethod method;
} of_textbooks[] = {{"usf", OscillatorMethod::symplectic_euler},
                    {"usl", OscillatorMethod::symplectic_euler},
                    {"musl", OscillatorMethod::symplectic_euler},
                    {"usavg", OscillatorMethod::leapfrog},
                    {"leapfrog", OscillatorMethod::leapfrog},
                    {"central-difference", OscillatorMethod::leapfrog},
                    {"ssp-rk3", OscillatorMethod::ssp_rk3},
                    {"rk4", OscillatorMethod::rk4},
                    {"implicit-midpoint", OscillatorMethod::newmark_trapezoid}};

TEST(Oscillator, ClaimsAreThoseOfTheTextbooks) {
  for (const auto& [integrator, method] : of_textbooks) {
    const Claims claims = claims_of({integrator});
    ASSERT_TRUE(claims.limit) << integrator;
    EXPECT_DOUBLE_EQ(*claims.limit, reference::oscillator_limit(method).value) << integrator;
    EXPECT_EQ(claimed_order(claims, "oscillator", "displacement"), reference::oscillator_order(method)) << integrator;
  }
  for (const double rho_b : {0.0, 0.5, 1.0}) {
    EXPECT_DOUBLE_EQ(claims_of({"generalized-alpha", {{"rho_b", rho_b}}}).limit.value(),
                     reference::generalized_alpha_stability_limit(rho_b).value);
  }
}

// Against GSL's eigenvalues of the textbooks' matrices, which know no stages. Numbers that are carried or remembered beside
// these only add the eigenvalue 0 and, of generalized-alpha's zeros, -alpha_m/(1 - alpha_m), no larger than one. Where two
// roots meet each is known to the root of the rounding.
TEST(Oscillator, MatricesHaveTheRadiiOfTheTextbooks) {
  for (const auto& [integrator, method] : of_textbooks) {
    for (const double dt : {0.1, 0.9, 1.8, 2.5, 3.5}) {
      const Eigen::MatrixXd matrix = step_matrix({integrator, {}}, 0, dt);
      const double expected = reference::spectral_radius(reference::oscillator_amplification(method, dt)).value;
      EXPECT_NEAR(spectral_radius(matrix), expected, 1e-9) << integrator << " " << dt;
      EXPECT_NEAR(radius_by_gsl(matrix), expected, 1e-9) << integrator << " " << dt;
    }
  }
  for (const double rho_b : {0.0, 0.4, 0.8}) {
    const double alpha_m = (2 * rho_b - 1) / (1 + rho_b);
    for (const double dt : {0.1, 0.9, 1.9, 2.5}) {
      const Eigen::MatrixXd matrix = step_matrix({"generalized-alpha", {{"rho_b", rho_b}}}, 0, dt);
      const double expected = std::max(reference::spectral_radius(reference::oscillator_amplification(
                                                                      OscillatorMethod::generalized_alpha, dt, rho_b))
                                           .value,
                                       std::abs(alpha_m / (1 - alpha_m)));
      EXPECT_NEAR(spectral_radius(matrix), expected, 1e-9) << rho_b << " " << dt;
    }
  }
}

// A damped oscillator: exact decay, u = e^{-zeta t} (cos w t + zeta/w sin w t), w^2 = 1 - zeta^2.
TEST(Oscillator, ExactMotion) {
  for (const double zeta : {0.0, 0.3}) {
    const double w = std::sqrt(1 - zeta * zeta), t = 1.7;
    const Eigen::Vector2d u = exact_oscillation(zeta, {1, 0}, t);
    EXPECT_NEAR(u[0], std::exp(-zeta * t) * (std::cos(w * t) + zeta / w * std::sin(w * t)), 1e-15);
    EXPECT_NEAR(u[1], -std::exp(-zeta * t) / w * std::sin(w * t), 1e-15);
  }
}

// A damper on velocities of the start takes from the limit: musl's matrix has the determinant 1 - 2 zeta dt and the trace 2 -
// dt^2 - 2 zeta dt, an eigenvalue -1 at dt^2 + 4 zeta dt = 4. Its force was evaluated with the velocities of the end of
// the step before, the start of this.
TEST(Oscillator, ADamperTakesFromTheLimit) {
  const StabilityProblem& oscillator = find_stability_problem("oscillator");
  for (const double zeta : {0.1, 0.5}) {
    const Settings settings = stability_settings(oscillator, "default", {{"damping", zeta}});
    EXPECT_NEAR(oscillator.predicted(settings, 1e-9).limit(), 2 * (std::sqrt(zeta * zeta + 1) - zeta), 1e-6);
    EXPECT_FALSE(oscillator.closed_form(settings).has_value());
  }
}

TEST(Oscillator, HasNoGridAndSoNoMapsToChoose) {
  const StabilityProblem& oscillator = find_stability_problem("oscillator");
  const Settings settings = stability_settings(oscillator, "york1997", {{"integrator", "energy"}});
  EXPECT_FALSE(settings.has("shape"));
  EXPECT_FALSE(settings.has("transfer"));
  EXPECT_FALSE(settings.has("positions"));
  EXPECT_TRUE(settings.has("rho_b"));
  EXPECT_TRUE(settings.has("damping"));
  EXPECT_THROW(stability_settings(oscillator, "default", {}, {"shape=linear"}), UsageError);
  EXPECT_THROW(oscillator.patch(settings, {}), std::logic_error);
  EXPECT_EQ(oscillator.unit(), "1/omega");
}

// Orders of errors that are powers of the step, and of one that rounding stops.
TEST(OrdersInTime, FitsPowers) {
  const auto orders = orders_in_time({"two", "four"}, 2, 16, 6, 1e-15, [](int steps) -> std::vector<double> {
    return {3 * std::pow(steps, -2), 1e-6 * std::pow(steps, -4) + 1e-17};
  });
  EXPECT_NEAR(orders.at("two").order, 2, 1e-12);
  EXPECT_NEAR(orders.at("two").high - orders.at("two").low, 0, 1e-10);
  ASSERT_EQ(orders.size(), 2U);
}

}  // namespace
}  // namespace plumbline::oscillator_test
