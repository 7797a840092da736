#include "cases/harness/laboratory/amplification.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "cases/harness/description/measures.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {
namespace {

constexpr double pi = std::numbers::pi;

// What a number of the state is within its period, and in which period it lies.
struct Where {
  Patch::Period period{};
  int unknown = 0;
};

std::vector<Where> places_of(const Patch& patch, const StepMap& map) {
  std::map<std::array<int, 3>, int> unknown_of;  // body, member, slot
  std::vector<Where> where(map.size());
  for (std::size_t k = 0; k < map.size(); ++k) {
    const StepMap::Entry& entry = map.entry(k);
    const Patch::Place& place = patch.places[entry.body][static_cast<std::size_t>(entry.point)];
    const std::array<int, 3> key{static_cast<int>(entry.body), place.member, entry.slot};
    where[k] = {place.period, unknown_of.emplace(key, static_cast<int>(unknown_of.size())).first->second};
  }
  return where;
}

std::vector<double> combination(double f, const std::vector<double>& a, double g, const std::vector<double>& b) {
  std::vector<double> sum(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) sum[j] = f * a[j] + g * b[j];
  return sum;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = larger(largest, std::abs(a[j] - b[j]));
  return largest;
}

StepMap step_of_rest(const Patch& patch, const IntegratorChoice& integrator, Positions positions, double dt) {
  try {
    return StepMap(patch.scene, patch.units, integrator, positions, dt);
  } catch (const InadmissibleState& state) {  // at its ends a patch need not be at rest
    throw NotStepped(std::string("the patch itself takes no such step: ") + state.what());
  }
}

}  // namespace

Amplification::Amplification(const Patch& patch, const IntegratorChoice& integrator, Positions positions, double dt)
    : directions_(patch.directions) {
  StepMap map = step_of_rest(patch, integrator, positions, dt);
  const std::vector<double> rest = map.state();
  // Large changes round least, small ones see least of what is not linear, and least often cross a switch.
  constexpr double good_enough = 1e-9;
  std::string stopped;
  for (const double size : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
    Differences tried{size, 0};
    Blocks blocks;
    try {
      blocks = differentiate(patch, map, tried);
    } catch (const InadmissibleState& state) {  // where nodes are all but massless, a large change moves points too far
      map.set_state(rest);
      stopped = state.what();
      continue;
    }
    if (std::isnan(tried.error)) continue;
    if (!blocks_.empty() && !(tried.error < differences_.error)) continue;
    differences_ = tried;
    blocks_ = std::move(blocks);
    if (tried.error <= good_enough) break;
  }
  if (blocks_.empty()) throw NotStepped("no change of the state is small enough to be stepped: " + stopped);
  unknowns_ = static_cast<int>(blocks_.at({0, 0}).rows());
  drop_idle();
  int outermost = 0;
  for (const auto& [period, block] : blocks_)
    outermost = std::max({outermost, std::abs(period[0]), std::abs(period[1])});
  for (const auto& [period, block] : blocks_) {
    if (directions_ == 0 || block.size() == 0) continue;
    if (std::max(std::abs(period[0]), std::abs(period[1])) == outermost) {
      tail_ = std::max(tail_, block.cwiseAbs().maxCoeff());
    }
  }
}

// Central differences with changes of three sizes, extrapolated; a step that is linear shows none between the first two.
auto Amplification::differentiate(const Patch& patch, StepMap& map, Differences& differences) -> Blocks {
  constexpr double linear = 1e-10;
  const double size = differences.size;
  const std::vector<Where> where = places_of(patch, map);
  int unknowns = 0;
  for (const Where& w : where) unknowns = std::max(unknowns, w.unknown + 1);
  const std::vector<double> base = map.state();
  const auto stepped = [&](std::size_t k, double change) {
    std::vector<double> state = base;
    state[k] += change;
    map.set_state(state);
    map.step();
    return map.state();
  };
  const auto difference = [&](std::size_t k, double change) {
    return combination(0.5 / change, stepped(k, change), -0.5 / change, stepped(k, -change));
  };
  Blocks blocks;
  differences.error = 0;
  for (std::size_t k = 0; k < where.size(); ++k) {
    if (where[k].period != Patch::Period{0, 0}) continue;
    std::vector<double> slope = difference(k, 2 * size);
    const std::vector<double> finer = difference(k, size);
    double error = largest_difference(slope, finer);
    if (error > linear) {
      const std::vector<double> coarser = difference(k, 4 * size);
      const std::vector<double> fourth = combination(4.0 / 3, finer, -1.0 / 3, slope);
      const std::vector<double> coarse_fourth = combination(4.0 / 3, slope, -1.0 / 3, coarser);
      error = largest_difference(fourth, coarse_fourth) / 15;
      slope = combination(16.0 / 15, fourth, -1.0 / 15, coarse_fourth);
    }
    differences.error = larger(differences.error, error);
    for (std::size_t j = 0; j < slope.size(); ++j) {
      auto& block = blocks[where[j].period];
      if (block.size() == 0) block = Eigen::MatrixXd::Zero(unknowns, unknowns);
      block(where[j].unknown, where[k].unknown) = slope[j];
    }
  }
  map.set_state(base);
  return blocks;
}

// A number that nothing depends on, or that depends on nothing, belongs to the eigenvalue 0; one that always stays as it is,
// or that changes nothing but itself, to 1. Leaving one out may make the next idle.
void Amplification::drop_idle() {
  constexpr double rounding = 1e-11;
  const Patch::Period here{0, 0};
  std::vector<int> kept(static_cast<std::size_t>(unknowns_));
  for (int k = 0; k < unknowns_; ++k) kept[static_cast<std::size_t>(k)] = k;
  const auto idle = [&](int u) {
    double row = 0, column = 0;  // largest entry but for the own
    for (const auto& [period, block] : blocks_) {
      for (const int v : kept) {
        if (period == here && v == u) continue;
        row = std::max(row, std::abs(block(u, v)));
        column = std::max(column, std::abs(block(v, u)));
      }
    }
    const double own = blocks_.at(here)(u, u);
    const bool trivial = std::abs(own) <= rounding || std::abs(own - 1) <= rounding;
    return trivial && (row <= rounding || column <= rounding);
  };
  for (bool changed = true; changed;) {
    const auto end = std::remove_if(kept.begin(), kept.end(), idle);
    changed = end != kept.end();
    kept.erase(end, kept.end());
  }
  unknowns_ = static_cast<int>(kept.size());
  for (auto& [period, block] : blocks_) {
    Eigen::MatrixXd small(unknowns_, unknowns_);
    for (int i = 0; i < unknowns_; ++i) {
      for (int j = 0; j < unknowns_; ++j) {
        small(i, j) = block(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
      }
    }
    block = small;
  }
}

Eigen::MatrixXcd Amplification::at(const WaveNumber& theta) const {
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(unknowns_, unknowns_);
  for (const auto& [period, block] : blocks_) {
    sum += std::polar(1.0, -(theta[0] * period[0] + theta[1] * period[1])) * block;
  }
  return sum;
}

double Amplification::spectral_radius(const WaveNumber& theta) const {
  if (unknowns_ == 0) return 0;
  return directions_ == 0 ? plumbline::spectral_radius(blocks_.at({0, 0})) : plumbline::spectral_radius(at(theta));
}

namespace {

constexpr int line_samples = 40, plane_samples = 8;  // from 0 to pi

// Real matrices have the same radius at -theta: half of all wave numbers will do. Rigid motion, theta = 0, is left out.
std::vector<WaveNumber> samples(int directions) {
  std::vector<WaveNumber> all;
  if (directions == 0) return {{0, 0}};
  if (directions == 1) {
    for (int k = line_samples; k >= 1; --k) all.push_back({pi * k / line_samples, 0});
    return all;
  }
  constexpr int count = plane_samples;
  for (int i = count; i >= 0; --i) {
    for (int j = count; j > -count; --j) {
      if (i == 0 && j <= 0) continue;
      all.push_back({pi * i / count, pi * j / count});
    }
  }
  return all;
}

// The best wave along one direction of the lattice after the other, within one spacing of the samples of `from`.
WorstWave climb(const Amplification& amplification, int directions, WorstWave from) {
  const double spacing = directions == 1 ? pi / line_samples : pi / plane_samples;
  for (int sweep = 0; sweep < directions; ++sweep) {
    for (std::size_t d = 0; d < static_cast<std::size_t>(directions); ++d) {
      const auto lower = [&](double t) {
        WaveNumber theta = from.theta;
        theta[d] = t;
        return -amplification.spectral_radius(theta);
      };
      const double low = from.theta[d] - spacing, high = from.theta[d] + spacing;
      const auto [t, value] = boost::math::tools::brent_find_minima(
          lower, directions == 1 ? std::max(low, 0.5 * spacing) : low, high, 24);
      if (-value > from.radius) {
        from.radius = -value;
        from.theta[d] = t;
      }
    }
  }
  return from;
}

}  // namespace

WorstWave worst_wave(const Amplification& amplification, int directions, const std::vector<WaveNumber>& hints) {
  std::vector<WorstWave> found;
  const auto look = [&](const WaveNumber& theta) { found.push_back({amplification.spectral_radius(theta), theta}); };
  for (const WaveNumber& theta : samples(directions)) look(theta);
  if (directions == 0) return found.front();
  const std::size_t sampled = found.size();
  for (const WaveNumber& theta : hints) look(theta);
  std::vector<WorstWave> tops(found.begin() + static_cast<std::ptrdiff_t>(sampled), found.end());
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.radius > b.radius; });
  tops.push_back(found[0]);
  tops.push_back(found[1]);
  WorstWave best = found.front();
  for (const WorstWave& top : tops) {
    const WorstWave here = climb(amplification, directions, top);
    if (here.radius > best.radius) best = here;
  }
  return best;
}

}  // namespace plumbline
