#include "reference/wave_curve.hpp"

namespace plumbline::reference {

WaveCurve::WaveCurve(const GasState& gas, double gamma, int direction)
    : gas_(gas),
      direction_(direction),
      gamma_(gamma),
      gamma_minus_(gamma_ - 1.0),
      gamma_plus_(gamma_ + 1.0) {
  A_ = Bounded(2) / (gamma_plus_ * gas.density);              // [Toro 4.8]
  B_ = gamma_minus_ / gamma_plus_ * gas.pressure;             // [Toro 4.8]
  a_ = sqrt(gamma_ * gas.pressure / gas.density);             // ideal gas: a^2 = gamma p/rho
  e_ = Bounded(gas.pressure) / (gamma_minus_ * gas.density);  // ideal gas: p = (gamma - 1) rho e
  escape_ = Bounded(2) * a_ / gamma_minus_;
  if (gas.pressure == 0) B_ = a_ = e_ = escape_ = 0.0;  // a cold gas, exactly
}

Bounded WaveCurve::velocity_change(double p) const {
  if (is_shock(p)) return (Bounded(p) - gas_.pressure) * sqrt(A_ / (Bounded(p) + B_));  // [Toro 4.6]
  if (p == 0) return -escape_;
  const Bounded z = gamma_minus_ / (Bounded(2) * gamma_);
  return escape_ * expm1(z * log(Bounded(p) / gas_.pressure));  // [Toro 4.6], (p/p_K)^z - 1 without cancellation
}

double WaveCurve::slope(double p) const {
  const double gamma = gamma_.value, B = B_.value;
  if (is_shock(p)) return std::sqrt(A_.value / (p + B)) * (1 - (p - gas_.pressure) / (2 * (p + B)));  // [Toro 4.37]
  return std::pow(p / gas_.pressure, -(gamma + 1) / (2 * gamma)) / (gas_.density * a_.value);         // [Toro 4.37]
}

Bounded WaveCurve::density(double p) const {
  if (is_shock(p)) {
    const Bounded g = gamma_minus_ / gamma_plus_;
    return Bounded(gas_.density) * (Bounded(p) + g * gas_.pressure) / (g * p + gas_.pressure);  // [Toro 4.50]
  }
  if (p == 0) return 0.0;
  return Bounded(gas_.density) * pow(Bounded(p) / gas_.pressure, Bounded(1) / gamma_);  // [Toro 4.53]
}

Bounded WaveCurve::energy(double p) const {
  if (is_shock(p)) return Bounded(p) / (gamma_minus_ * density(p));  // ideal gas
  if (p == 0) return 0.0;
  return e_ * pow(Bounded(p) / gas_.pressure, gamma_minus_ / gamma_);  // with [Toro 4.53]
}

Bounded WaveCurve::sound_speed(double p) const {
  if (is_shock(p)) return sqrt(gamma_ * p / density(p));  // ideal gas
  if (p == 0) return 0.0;
  return a_ * pow(Bounded(p) / gas_.pressure, gamma_minus_ / (Bounded(2) * gamma_));  // [Toro 4.54]
}

Bounded WaveCurve::mass_flux(double p) const {
  return sqrt((Bounded(p) + B_) / A_);
}  // rho_K a_K sqrt(...) of [Toro 4.52]

Bounded WaveCurve::velocity_behind(Bounded p) const {
  const Bounded change = over_interval([this](double q) { return velocity_change(q); }, p);
  return Bounded(gas_.velocity) + Bounded(direction_) * change;  // [Toro 4.9]
}

Bounded WaveCurve::shock_speed(Bounded p) const {
  const Bounded flux = over_interval([this](double q) { return mass_flux(q); }, p);
  return Bounded(gas_.velocity) + Bounded(direction_) * flux / gas_.density;  // [Toro 4.52]
}

Bounded WaveCurve::head(Bounded p) const {
  const Bounded rarefaction = Bounded(gas_.velocity) + Bounded(direction_) * a_;  // [Toro 4.55]
  if (lowest(p) > gas_.pressure) return shock_speed(p);
  if (highest(p) < gas_.pressure || (p.value == 0 && p.bound == 0)) return rarefaction;
  return is_shock(p.value) ? hull(shock_speed(p), rarefaction) : hull(rarefaction, shock_speed(p));
}

Bounded WaveCurve::tail(Bounded p, Bounded velocity) const {
  const Bounded a = over_interval([this](double q) { return sound_speed(q); }, p);
  const Bounded rarefaction = velocity + Bounded(direction_) * a;  // [Toro 4.55]
  if (lowest(p) > gas_.pressure) return shock_speed(p);
  if (highest(p) < gas_.pressure || (p.value == 0 && p.bound == 0)) return rarefaction;
  return is_shock(p.value) ? hull(shock_speed(p), rarefaction) : hull(rarefaction, shock_speed(p));
}

WaveCurve::Ray WaveCurve::ray(double xi) const {
  const Bounded out(direction_), u(gas_.velocity);
  const Bounded ratio = (Bounded(2) - out * gamma_minus_ * (u - xi) / a_) / gamma_plus_;  // a / a_K
  const Bounded thinning = pow(ratio, Bounded(2) / gamma_minus_);
  const Bounded cooling = ratio * ratio;
  return {Bounded(gas_.density) * thinning,                                                       // [Toro 4.56]
          Bounded(2) / gamma_plus_ * (Bounded(xi) - out * a_ + Bounded(0.5) * gamma_minus_ * u),  // [Toro 4.56]
          Bounded(gas_.pressure) * thinning * cooling,                                            // [Toro 4.56]
          e_ * cooling};                                                                          // e goes as a^2
}

}  // namespace plumbline::reference
