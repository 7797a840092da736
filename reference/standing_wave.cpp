// The entropy is uniform, so that r+- = u +- 2 (c - c0)/(gamma - 1) stay the same along curves of speed u +- c. At t = 0 both
// are f = U sin(k x). With xi = x - c0 t and eta = x + c0 t these curves come from xi - a and eta - b,
//   a = (gamma + 1)/4 t f(xi) + (3 - gamma)/4 g,  b = (gamma + 1)/4 t f(eta) + (3 - gamma)/4 g,
//   g = U (cos k xi - cos k eta)/(2 k c0),
// the integrals of what their speeds differ from +-c0 by, (gamma + 1)/4 of the own and (3 - gamma)/4 of the other
// invariant, each of first order. What is left out: a curve leaves that of speed +-c0 by at most (gamma + 1)/2 U t, by
// which f changes by at most s U, s = (gamma + 1)/2 U k t. So in these integrals the own invariant is off by s U and the
// other, whose own curve is displaced as well, by 2 s U; a and b by t s U ((gamma + 1)/4 + |3 - gamma|/2); and r+- by U k
// times that. u is off by as much at most, c by (gamma - 1)/2 of it. Density, pressure and energy follow from c at that entropy;
// for c within a hundredth of c0 their slopes are within a tenth of those at c0.
#include "reference/standing_wave.hpp"

#include "reference/widened.hpp"

namespace plumbline::reference {

StandingWave::StandingWave(const StandingWaveProblem& problem) : problem_(problem) {
  check_finite("amplitude", problem.amplitude);
  check_positive("wavenumber", problem.wavenumber);
  check_positive("density", problem.density);
  check_positive("pressure", problem.pressure);
  check_gamma(problem.gamma);
  sound_speed_ = sqrt(Bounded(problem.gamma) * problem.pressure / problem.density);
  if (std::abs(problem.amplitude) > 0.01 * sound_speed_.value) {
    throw ParameterError("amplitude", problem.amplitude, "at most a hundredth of the speed of sound");
  }
}

Bounded StandingWave::period() const { return Bounded(2 * M_PI) / (sound_speed_ * problem_.wavenumber); }

Sample StandingWave::sample(double position, double time) const {
  check_finite("position", position);
  check_not_negative("time", time);
  const Bounded gamma(problem_.gamma), k(problem_.wavenumber), amplitude(problem_.amplitude), c0 = sound_speed_;
  const Bounded xi = Bounded(position) - c0 * time, eta = Bounded(position) + c0 * time;
  const auto f = [&](Bounded x) { return amplitude * sin(k * x); };
  const Bounded own = Bounded(0.25) * (gamma + 1.0) * time;
  const Bounded other = Bounded(0.25) * (Bounded(3) - gamma) * amplitude * (cos(k * xi) - cos(k * eta)) /
                        (Bounded(2) * k * c0);
  const Bounded up = f(xi - (own * f(xi) + other)), down = f(eta - (own * f(eta) + other));

  const double g = problem_.gamma, largest = std::abs(problem_.amplitude);
  const double turned = largest * problem_.wavenumber * time * (1 + 1e-12), s = (g + 1) / 2 * turned;
  if (!(s < 0.5)) throw ParameterError("time", time, "long before the wave breaks");
  const double neglected = largest * s * turned * ((g + 1) / 4 + std::abs(3 - g) / 2);

  const Bounded c = c0 + Bounded(0.25) * (gamma - 1.0) * (up - down);
  const double relative = 1.1 * neglected / c0.value;
  const Bounded ratio = c / c0, rise = Bounded(2) / (gamma - 1.0);
  const Bounded density = Bounded(problem_.density) * pow(ratio, rise);
  const Bounded pressure = Bounded(problem_.pressure) * pow(ratio, gamma * rise);
  const Bounded energy = Bounded(problem_.pressure) / ((gamma - 1.0) * problem_.density) * ratio * ratio;
  return {widened(density, density.value * relative), widened(Bounded(0.5) * (up + down), neglected),
          widened(pressure, pressure.value * g * relative), widened(energy, energy.value * (g - 1) * relative)};
}

}  // namespace plumbline::reference
