#include "cases/catalog/stability/plate_waves.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "reference/grid_maps.hpp"

namespace plumbline {
namespace {

using Complex = std::complex<double>;

// The lattice's factors along one direction for a wave of the phase theta a cell.
struct Factors {
  double kept = 0, stiffness = 0;  // B, K
  Complex turned{};                // R
};

Factors factors(reference::GridShape shape, int ppc, double place, double theta) {
  Factors sum;
  const double mass = 1.0 / ppc;
  for (int k = 0; k < ppc; ++k) {
    const reference::PointWeights at = reference::point_weights(shape, (k + place) / ppc, mass);
    Complex weight{}, gradient{};
    for (std::size_t j = 0; j < reference::PointWeights::nodes; ++j) {
      const Complex phase = std::polar(1.0, theta * static_cast<double>(j));
      weight += phase * at.weight[j].value;
      gradient += phase * at.gradient[j].value;
    }
    sum.kept += mass * std::norm(weight);
    sum.stiffness += mass * std::norm(gradient);
    sum.turned += mass * std::conj(gradient) * weight;
  }
  return sum;
}

// [Stability 5] for flip and pic.
double share(const reference::MapScheme& scheme, double kept) {
  const double alpha = scheme.transfer == reference::GridTransfer::flip ? 1 : kept;
  return (scheme.update == reference::StressUpdate::last ? 1 + alpha - kept : kept) / (2 * (1 + alpha));
}

// Of a function of both wave numbers of period 2 pi, on a grid that is made finer about the best.
double greatest(const std::function<double(double, double)>& at, int waves) {
  const int count = waves > 0 ? waves : 180;
  double step = 2 * std::numbers::pi / count, best = 0, best_x = 0, best_y = 0;
  const auto look = [&](double x, double y) {
    const double here = at(x, y);
    if (here > best) best = here, best_x = x, best_y = y;
  };
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) look(i * step, j * step);
  }
  for (; waves == 0 && step > 1e-7; step /= 2) {
    const double x = best_x, y = best_y;
    for (int k = 0; k < 25; ++k) look(x + (k % 5 - 2) * step / 2, y + (k / 5 - 2) * step / 2);
  }
  return best;
}

}  // namespace

double plate_limit(const reference::MapScheme& scheme, const PlateLattice& lattice, double nu) {
  const double k = (1 - 2 * nu) / (2 - 2 * nu), l = 1 - 2 * k;
  const auto burden = [&](double theta_x, double theta_y) {
    const Factors x = factors(scheme.shape, lattice.ppc, lattice.place_x, theta_x);
    const Factors y = factors(scheme.shape, lattice.ppc, lattice.place_y, theta_y);
    const double along_x = x.stiffness * y.kept, along_y = x.kept * y.stiffness;
    const Complex c = x.turned * std::conj(y.turned);
    const double mean = 0.5 * (1 + k) * (along_x + along_y), half = 0.5 * (1 - k) * (along_x - along_y);
    const double largest = mean + std::hypot(half, std::abs(l * c + k * std::conj(c)));  // [Plate 1]
    return share(scheme, x.kept * y.kept) * largest;
  };
  return 1 / std::sqrt(greatest(burden, 0));
}

double scalar_plate_limit(const reference::MapScheme& scheme, const PlateLattice& lattice, int waves) {
  const auto burden = [&](double theta_x, double theta_y) {
    const Factors x = factors(scheme.shape, lattice.ppc, lattice.place_x, theta_x);
    const Factors y = factors(scheme.shape, lattice.ppc, lattice.place_y, theta_y);
    return share(scheme, x.kept * y.kept) * (x.stiffness * y.kept + x.kept * y.stiffness);
  };
  return 1 / std::sqrt(greatest(burden, waves));
}

}  // namespace plumbline
