#pragma once
// Bessel functions of whole order and their zeros: GSL's values, with bounds certified by Bessel's integral
// J_n(x) = 1/pi int_0^pi cos(x sin t - n t) dt [DLMF 10.9.2], whose trapezoidal sum converges faster than any power.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// |x| at most 1e4 (the sum grows with x); throws ParameterError "x" beyond. The bound grows as rounding times |x|.
Bounded bessel_J0(Bounded x);
Bounded bessel_J1(Bounded x);

/// The same of order 0 to 100; ParameterError "order".
Bounded bessel_J(int order, Bounded x);

/// The n-th positive zero of J_order, order up to 100, 1 <= n <= 1000. Throws ParameterError "order", "mode".
Bounded bessel_zero_J(int order, int n);

/// The n-th positive zero of J0, 1 <= n <= 1000. Throws ParameterError "mode".
Bounded bessel_zero_J0(int n);

}  // namespace plumbline::reference
