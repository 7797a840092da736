#pragma once
// What the tests of the exact gas flows share.
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "reference/gas_flow.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference {

inline void expect_same(const Sample& a, const Sample& b) {
  expect_same(a.density, b.density);
  expect_same(a.velocity, b.velocity);
  expect_same(a.pressure, b.pressure);
  expect_same(a.energy, b.energy);
}

/// Jumps of mass, momentum and energy in the frame of a shock of that speed (Toro, section 3.1.3).
inline void expect_rankine_hugoniot(const Sample& ahead, const Sample& behind, Bounded speed) {
  const Bounded w1 = ahead.velocity - speed, w2 = behind.velocity - speed;
  const double flux = std::abs((ahead.density * w1).value), scale = std::abs(w1.value);
  expect_zero(ahead.density * w1 - behind.density * w2, flux, "mass");
  expect_zero(ahead.density * w1 * w1 + ahead.pressure - behind.density * w2 * w2 - behind.pressure,
              flux * scale + ahead.pressure.value, "momentum");
  auto total = [](const Sample& s, Bounded w) { return s.energy + s.pressure / s.density + Bounded(0.5) * w * w; };
  expect_zero(total(ahead, w1) - total(behind, w2), std::abs(total(behind, w2).value), "energy");
}

/// Integral of f(r) times the measure of the sphere of radius r.
inline double over_body(int dimension, double low, double high, const std::function<double(double)>& f) {
  struct Context {
    const std::function<double(double)>& f;
    int dimension;
  } context{f, dimension};
  gsl_function function{[](double r, void* at) {
                          const Context& c = *static_cast<Context*>(at);
                          return c.f(r) * std::pow(r, c.dimension - 1);
                        },
                        &context};
  gsl_integration_cquad_workspace* space = gsl_integration_cquad_workspace_alloc(400);
  double result = 0, error = 0;
  gsl_integration_cquad(&function, low, high, 0, 1e-11, space, &result, &error, nullptr);
  gsl_integration_cquad_workspace_free(space);
  return sphere_measure(dimension).value * result;
}

}  // namespace plumbline::reference
