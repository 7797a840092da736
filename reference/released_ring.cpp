#include "reference/released_ring.hpp"

#include "reference/argument.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

GasRingProblem rest_of(const ReleasedRingProblem& p) {
  GasRingProblem ring;
  ring.youngs_modulus = p.youngs_modulus;
  ring.poisson_ratio = p.poisson_ratio;
  ring.thickness = p.thickness;
  ring.gamma = p.gamma;
  const double elastic = p.youngs_modulus / (1 - p.poisson_ratio * p.poisson_ratio) * p.thickness;  // [York 5.12]
  auto pressure = [&](double stretch) { return p.pressure * std::pow(stretch, -2 * p.gamma); };
  auto pull = [&](double stretch) { return elastic * (stretch - 1) - pressure(stretch) * p.radius * stretch; };
  const double stretch = brent_root(pull, 1, 1 + 2 * p.pressure * p.radius / elastic);
  ring.radius = p.radius * stretch;
  ring.pressure = pressure(stretch);
  ring.gas_density = p.gas_density / (stretch * stretch);
  ring.line_mass = p.membrane_density * p.thickness / stretch;
  return ring;
}

void check_problem(const ReleasedRingProblem& p) {
  check_positive("youngs_modulus", p.youngs_modulus);
  check({"poisson_ratio", 0, 0, 0.5, false, true, "", ""}, p.poisson_ratio);
  check_positive("thickness", p.thickness);
  check_positive("membrane_density", p.membrane_density);
  check_positive("radius", p.radius);
  check_positive("pressure", p.pressure);
  check_positive("gas_density", p.gas_density);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, p.gamma);
}

}  // namespace

ReleasedRing::ReleasedRing(const ReleasedRingProblem& problem) : problem_(problem) {
  check_problem(problem);
  at_rest_ = rest_of(problem);
  const GasRing ring(at_rest_);
  const Bounded mu = Bounded(at_rest_.line_mass) / (Bounded(at_rest_.gas_density) * at_rest_.radius);
  const Bounded kappa = ring.ring_stiffness() * at_rest_.radius / (Bounded(at_rest_.gamma) * at_rest_.pressure);
  Bounded rest = 1;
  for (int n = 1; n <= modes; ++n) {
    const Bounded z = ring.wavenumber(n), q = mu * z - kappa / z;  // the equation of the frequencies
    const Bounded two = 2, disc = Bounded(1) + q * (q - two / z);
    const Bounded share = (two * mu + two * (two / z - q) / z) / (two * mu + disc);
    modes_.push_back({z * ring.sound_speed() / at_rest_.radius, share});
    rest = rest - share;
  }
  left_out_ = std::abs(rest.value) + rest.bound;  // a_n -> (4 + 2 kappa)/(mu^2 z^4) > 0: they only add
}

Bounded ReleasedRing::radius_change(double time) const {
  check_not_negative("time", time);
  Bounded sum;
  for (const Mode& mode : modes_) sum = sum + mode.share * cos(mode.omega * time);
  sum.bound += left_out_;
  return Bounded(at_rest_.radius - problem_.radius) * (Bounded(1) - sum);
}

}  // namespace plumbline::reference
