#pragma once
// Roots of one increasing function, bracketed by sign and therefore certain.
#include <functional>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Brent's method (gsl_root_fsolver_brent) for a continuous f with f(low) < 0 < f(high), down to rounding.
/// Throws std::runtime_error if the signs are not so, or f stops being finite.
double brent_root(const std::function<double(double)>& f, double low, double high);

/// The root of an increasing f near `guess`, enclosed: the bound is the smallest one tried for which
/// f(value - bound) is certainly negative and f(value + bound) certainly positive, f's own rounding included.
/// The first try is |f| plus its rounding over `slope`, the derivative there (it need only be roughly right).
/// The root is known to lie in [least, greatest]: no sign is needed where the interval reaches either.
/// Throws std::runtime_error if no bound can be certified.
Bounded enclose_root(const std::function<Bounded(double)>& f, double guess, double slope, double least,
                     double greatest);

}  // namespace plumbline::reference
