// Names of integrators whose limits only the tests know; made_up_integrators_test.cpp registers them.
#pragma once

#include <cmath>

namespace plumbline::made_up {

// y' = y + dt f(y): grows by sqrt(1 + (omega dt)^2) at every step.
inline constexpr const char* forward_euler = "test-forward-euler";

// Stress last, with all forces taken 1.37^2 times: an oscillation is faster by 1.37 than its springs are.
inline constexpr const char* stiff = "test-stiff";
inline constexpr double stiffer = 1.37;
inline constexpr double stiff_limit = 2 / stiffer;  // of omega dt

// A Runge-Kutta method of three stages and second order, R(z) = 1 + z + z^2/2 + z^3/5. |R(iy)|^2 = 1 + y^4 (1/4 - 2/5) +
// y^6/25: one at y^2 = 15/4.
inline constexpr const char* three_stages = "test-three-stages";
inline const double three_stages_limit = std::sqrt(3.75);  // of omega dt

}  // namespace plumbline::made_up
