// What the laboratory makes of steps of a bar with one point a cell, linear shapes and FLIP: its matrices in closed form.
#include <cmath>
#include <complex>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/laboratory/amplification.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/safe_step.hpp"
#include "cases/harness/laboratory/wave.hpp"

namespace plumbline {
namespace {

constexpr double half_turn = std::numbers::pi;
const MapChoice linear_flip{"linear", "flip", 2};

// The frequency, in c/h, of a wave on points at `place` in their cells: nodes get (1 - N) v_p + N v_{p-1}, points the same of what
// nodes have, strains and forces differences between neighbours:
//   omega^2 = 4 s (1 - 4 N (1 - N) s), s = sin^2(theta/2).
double frequency(double theta, double place) {
  const double s = std::pow(std::sin(theta / 2), 2);
  return std::sqrt(std::max(0.0, 4 * s * (1 - 4 * place * (1 - place) * s)));
}

// Where it is highest.
double fastest_wave(double place) {
  const double s = 1 / (8 * place * (1 - place));
  return s < 1 ? 2 * std::asin(std::sqrt(s)) : half_turn;
}

// Of a step that takes stresses and velocities one after the other: the roots of l^2 - (2 - x^2) l + 1.
double radius_of_pair(double x) { return x <= 2 ? 1 : (x * x - 2 + x * std::sqrt(x * x - 4)) / 2; }

// Of the Runge-Kutta step of order four: |1 + z + z^2/2 + z^3/6 + z^4/24| at z = i x.
double radius_of_rk4(double x) { return std::hypot(1 - x * x / 2 + std::pow(x, 4) / 24, x - x * x * x / 6); }

void add_matrices(KnownAnswers& all) {
  for (const double place : {0.5, 0.3, 0.1}) {
    for (const double dt : {0.8, 2.6, 3.5}) {
      const Patch patch = bar_patch(linear_flip, 1, place, {1, 6});
      const auto row = [&](const char* name, double found, double exact) {
        all.push_back({name, found, exact, std::max(1.0, exact)});
      };
      const Amplification usf(patch, {"usf", {}}, Positions::frozen, dt),
          rk4(patch, {"rk4", {}}, Positions::frozen, dt);
      for (const double theta : {0.4, 1.3, 2.2, 2.9, -1.7}) {
        const double x = dt * frequency(theta, place);
        // Where both roots meet rounding is of the order of its square root.
        if (std::abs(x - 2) > 0.1 && x > 0.1) row("usf.radius", usf.spectral_radius({theta, 0}), radius_of_pair(x));
        row("rk4.radius", rk4.spectral_radius({theta, 0}), radius_of_rk4(x));
      }
      row("usf.tail", usf.tail(), 0);
      const double fastest = dt * frequency(fastest_wave(place), place);
      if (fastest < 2.1) continue;
      const WorstWave worst = worst_wave(usf, 1);
      row("usf.worst", worst.radius, radius_of_pair(fastest));
      // Radii are even about their top: its place is known to the square root of what they are.
      all.push_back({"usf.worst_wave", worst.theta[0], fastest_wave(place), 1e4});
    }
  }
}

// A plate is a bar for waves along either axis, and shears half as stiffly; strains across stay as they are. Of the step of order
// four, which is stable up to 2 sqrt(2).
void add_plate(KnownAnswers& all) {
  const double dt = 3.2;
  const Amplification plate(plate_patch(linear_flip, 1, 0.5, 0.3, 0, {1, 5}), {"rk4", {}}, Positions::frozen, dt);
  for (const double theta : {0.5, 1.3, 1.7}) {
    for (const bool up : {false, true}) {
      const double x = dt * frequency(theta, up ? 0.3 : 0.5), shear = x * std::sqrt(0.5);
      all.push_back({"plate.radius", plate.spectral_radius(up ? WaveNumber{0, theta} : WaveNumber{theta, 0}),
                     std::max({1.0, radius_of_rk4(x), radius_of_rk4(shear)})});
    }
  }
}

// With points in the middle of square cells a wave strains them as a plane wave with the wave numbers sin(x) cos^2(y/2) along x and
// sin(y) cos^2(x/2) along y: of all waves the one of four cells along either axis is the fastest.
void add_oblique(KnownAnswers& all) {
  const double dt = 3.2;
  const Amplification plate(plate_patch(linear_flip, 1, 0.5, 0.5, 0, {1, 5}), {"rk4", {}}, Positions::frozen, dt);
  const auto radius = [&](const WaveNumber& theta) {
    const double x = dt * std::hypot(std::sin(theta[0]) * std::pow(std::cos(theta[1] / 2), 2),
                                     std::sin(theta[1]) * std::pow(std::cos(theta[0] / 2), 2));
    return std::max({1.0, radius_of_rk4(x), radius_of_rk4(x * std::sqrt(0.5))});
  };
  for (const WaveNumber& theta : {WaveNumber{1.4, 0.3}, {0.2, -1.6}, {1.2, 0.6}, {-1.5, 0.4}}) {
    all.push_back({"oblique.radius", plate.spectral_radius(theta), radius(theta)});
  }
  const WorstWave worst = worst_wave(plate, 2);
  all.push_back({"oblique.worst", worst.radius, radius_of_rk4(dt)});
  // Along one axis or the other, and known to the square root of what radii are.
  const double along = std::max(std::abs(worst.theta[0]), std::abs(worst.theta[1])),
               across = std::min(std::abs(worst.theta[0]), std::abs(worst.theta[1]));
  all.push_back({"oblique.along", along, half_turn / 2, 1e4});
  all.push_back({"oblique.across", across, 0, 1e4});
}

// The least limit of points at different places in their cells, 2 over the highest frequency; to the relative width of 1e-4 at which
// bisections end.
void add_safe_step(KnownAnswers& all) {
  const SafeStep safe = safe_step_of_bar({"usf", "linear", "flip"}, 2, {}, 1, false);
  constexpr double coarsely = 1e5;
  const double least = 0.01;
  all.push_back({"safe.regular", safe.regular, 2, coarsely});
  all.push_back({"safe.limit", safe.limit, 2 / frequency(fastest_wave(least), least), coarsely});
  all.push_back({"safe.place", safe.place, least});
}

// Half a wave between two walls: velocities 0.8 of a sine and strains 0.6 of a cosine turn into each other.
void add_standing(KnownAnswers& all) {
  constexpr int cells = 6, steps = 5;
  constexpr double t = 3;
  const StandingWave wave(linear_flip, cells, 1);
  const double omega = frequency(half_turn / cells, 0.5);
  const std::complex<double> start(0.8, 0.6), z(0, omega * t / steps);
  const std::complex<double> exact = start * std::exp(static_cast<double>(steps) * z),
                             stepped = start *
                                       std::pow(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))), steps);
  const auto found = wave.exact(t), found_stepped = wave.stepped({"rk4", {}}, t, steps);
  for (int p = 0; p < cells; ++p) {
    const double phase = half_turn * (p + 0.5) / cells;
    const auto k = static_cast<std::size_t>(p);
    all.push_back({"standing.velocity", found.at(k), exact.real() * std::sin(phase)});
    all.push_back({"standing.strain", found.at(cells + k), exact.imag() * std::cos(phase)});
    all.push_back({"stepped.velocity", found_stepped.at(k), stepped.real() * std::sin(phase)});
    all.push_back({"stepped.strain", found_stepped.at(cells + k), stepped.imag() * std::cos(phase)});
  }
}

}  // namespace

KnownAnswers wave_answers() {
  KnownAnswers all;
  add_matrices(all);
  add_plate(all);
  add_oblique(all);
  add_safe_step(all);
  add_standing(all);
  return all;
}

}  // namespace plumbline
