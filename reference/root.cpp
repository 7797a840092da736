#include "reference/root.hpp"

#include <gsl/gsl_errno.h>

#include <stdexcept>

#include "reference/gsl_owned.hpp"

namespace plumbline::reference {
namespace {

double call(double x, void* f) { return (*static_cast<const std::function<double(double)>*>(f))(x); }

constexpr int most_iterations = 200;  // about ten are usual; callers polish and certify the result anyway

}  // namespace

double brent_root(const std::function<double(double)>& f, double low, double high) {
  // GSL reports a bad bracket or value through a process-wide handler that aborts: it never gets to see one.
  if (!(f(low) < 0) || !(f(high) > 0)) throw std::domain_error("brent_root: the function does not change sign");
  auto checked = [&f](double x) {
    const double value = f(x);
    if (!std::isfinite(value)) throw std::domain_error("brent_root: the function is not finite");
    return value;
  };
  std::function<double(double)> target = checked;
  gsl_function function{&call, &target};
  const Owned<gsl_root_fsolver> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  gsl_root_fsolver_set(solver.get(), &function, low, high);
  for (int i = 0; i < most_iterations; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    const double a = gsl_root_fsolver_x_lower(solver.get()), b = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(a, b, 0, 4 * rounding::unit) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

Bounded enclose_root(const std::function<Bounded(double)>& f, double guess, double slope, double least,
                     double greatest) {
  const Bounded residual = f(guess);
  double radius = (std::abs(residual.value) + residual.bound) / slope * 1.125;
  if (!(radius > 0) || !std::isfinite(radius)) radius = 0;
  radius = std::max(radius, rounding::unit * std::abs(guess) + std::numeric_limits<double>::denorm_min());
  for (int i = 0; i < 1200 && std::isfinite(radius); ++i, radius *= i < 8 ? 1.25 : 4) {
    const double low = guess - radius, high = guess + radius;
    const bool below = low <= least || certainly_below(f(low), 0.0);
    const bool above = high >= greatest || certainly_below(0.0, f(high));
    if (below && above) return {guess, radius * rounding::inflate + rounding::unit * std::abs(guess)};
  }
  throw std::domain_error("enclose_root: no error bound can be certified");
}

}  // namespace plumbline::reference
