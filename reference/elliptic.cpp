#include "reference/elliptic.hpp"

#include <gsl/gsl_sf_ellint.h>

#include "reference/circle.hpp"

namespace plumbline::reference {

Bounded gauss_mean(Bounded a, Bounded b) {
  for (int i = 0; i < 64 && std::abs(a.value - b.value) > 4 * rounding::unit * a.value; ++i) {
    const Bounded mean = Bounded(0.5) * (a + b);  // [DLMF 19.8.5]
    b = sqrt(a * b);
    a = mean;
  }
  return hull(a, b);
}

Bounded elliptic_K(Bounded k, Bounded complement) {
  const Bounded mean = pi / (Bounded(2) * gauss_mean(1.0, complement));  // [DLMF 19.8.5]
  if (!(std::abs(k.value) < 1 - 1e-10)) return mean;                     // GSL sees k alone
  return hull(Bounded(gsl_sf_ellint_Kcomp(k.value, GSL_PREC_DOUBLE)), mean);
}

}  // namespace plumbline::reference
