#pragma once
// Integrals with an error taken from the comparison of two rules.
#include <functional>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Integral of f over [low, high] by Gauss-Legendre rules of 32 points (gsl_integration_glfixed), panels halved where
/// needed. f must be smooth inside and finite; weak singularities of derivatives at the ends are found by the halving.
/// The bound is the sum over panels of |one rule over the panel - one over each half|, of which the second is
/// answered and far better, plus f's own bounds and the rounding of the sums.
Bounded integrate(const std::function<Bounded(double)>& f, double low, double high);

}  // namespace plumbline::reference
