// Forces and strain rates are adjoint: what the forces do on the grid is what the stresses take from the points, for every
// velocity, in all geometries.
#include "kernel/shapes/shape.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::adjoint_test {
namespace {

using scenes::Space;

class Adjoint : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Adjoint, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// With FLIP, v_p' - v_p = dt sum_i N_ip f_i / M_i, so that sum_p m_p v_p . (v_p' - v_p) / dt = sum_i f_i . v_i, with v_i the
// velocity that the points map to the nodes; and that is minus sum_p V_p sigma_p : e_p, e_p the strain rate of v_i. Walls and
// sharpening change both sides alike. Sums of some thousand terms: 1e-13 of the larger half of either.
// [York 3.17, 3.23] [EC-APIC 4, walls] [Sharpening 1]
void expect_adjoint(Scene scene) {
  Ledger ledger;
  const double dt = 1e-3;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->evaluate_stress(NodalVelocity::start);
  const Columns before = scene.bodies[0].points;
  double stress_power = 0, scale = 0;
  for (int k = 0; k < before.components(column::stress); ++k) {
    for (int p = 0; p < before.points(); ++p) {
      const double power = before(column::volume)[p] * before(column::stress, k)[p] * before(column::strain_rate, k)[p];
      stress_power += power;
      scale += std::abs(power);
    }
  }
  engine->map_forces();
  engine->advance_momentum(dt);
  engine->kick_points(dt);
  const Columns& after = scene.bodies[0].points;
  double force_power = 0;
  for (int d = 0; d < scene.grid.dim; ++d) {
    for (int p = 0; p < after.points(); ++p) {
      const double v = before(column::velocity, d)[p];
      force_power += before(column::mass)[p] * v * (after(column::velocity, d)[p] - v) / dt;
    }
  }
  EXPECT_NEAR(force_power, -stress_power, 1e-12 * scale);  // of which the difference over dt loses three digits of v^2
  EXPECT_GT(std::abs(stress_power), 1e-3 * scale);
}

TEST_P(Adjoint, ForcesDoWhatStressesTake) {
  for (const Choice& shape : scenes::shapes_in_space()) {
    for (const IdealGas& gas : {scenes::rough_law(), scenes::inviscid_law()}) {
      for (const double sharpening : {0.0, 1.0}) {
        SCOPED_TRACE(testing::Message() << shape.name << ", sharpening " << sharpening);
        for (const bool walled : {true, false}) {
          const auto make = [&](auto&&... choice) {
            return walled ? scenes::rough_gas(choice...) : scenes::rough_gas_in_space(choice...);
          };
          Scene scene = make(GetParam(), shape.name, "flip", scenes::no_gravity, gas);
          scene.sharpening = sharpening;
          expect_adjoint(std::move(scene));
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::adjoint_test
