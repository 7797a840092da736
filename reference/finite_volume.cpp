#include "reference/finite_volume.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/parameter.hpp"

namespace plumbline::reference {
namespace {

/// Density, momentum and energy by volume, or their fluxes.
struct Conserved {
  double mass = 0, momentum = 0, energy = 0;
};

Conserved operator+(const Conserved& a, const Conserved& b) {
  return {a.mass + b.mass, a.momentum + b.momentum, a.energy + b.energy};
}
Conserved operator-(const Conserved& a, const Conserved& b) {
  return {a.mass - b.mass, a.momentum - b.momentum, a.energy - b.energy};
}
Conserved operator*(double s, const Conserved& a) { return {s * a.mass, s * a.momentum, s * a.energy}; }

Conserved conserved(const GasState& gas, double gamma) {
  const double momentum = gas.density * gas.velocity;
  return {gas.density, momentum, gas.pressure / (gamma - 1) + momentum * gas.velocity / 2};
}

GasState primitive(const Conserved& u, double gamma) {
  const double velocity = u.momentum / u.mass;
  return {u.mass, velocity, (gamma - 1) * (u.energy - u.momentum * velocity / 2)};
}

double sound_speed(const GasState& gas, double gamma) { return std::sqrt(gamma * gas.pressure / gas.density); }

Conserved flux(const GasState& gas, double gamma) {
  const Conserved u = conserved(gas, gamma);
  return {u.momentum, u.momentum * gas.velocity + gas.pressure, gas.velocity * (u.energy + gas.pressure)};
}

/// Pressure estimate for the wave speeds: linear where the sides are alike, two rarefactions or two shocks else.
double estimated_pressure(const GasState& l, const GasState& r, double gamma) {
  const double a_l = sound_speed(l, gamma), a_r = sound_speed(r, gamma), du = r.velocity - l.velocity;
  const double linear = (l.pressure + r.pressure) / 2 - du * (l.density + r.density) * (a_l + a_r) / 8;  // [Toro 9.20]
  const double low = std::min(l.pressure, r.pressure), high = std::max(l.pressure, r.pressure);
  if (high <= 2 * low && linear >= low && linear <= high) return linear;
  if (linear < low) {  // the closed form of two rarefactions, [Toro 9.32]
    const double z = (gamma - 1) / (2 * gamma), above = a_l + a_r - (gamma - 1) / 2 * du;
    if (above <= 0) return 0;
    return std::pow(above / (a_l / std::pow(l.pressure, z) + a_r / std::pow(r.pressure, z)), 1 / z);
  }
  auto g = [=](const GasState& gas) {
    const double A = 2 / ((gamma + 1) * gas.density), B = (gamma - 1) / (gamma + 1) * gas.pressure;
    return std::sqrt(A / (std::max(linear, 0.0) + B));
  };
  return (g(l) * l.pressure + g(r) * r.pressure - du) / (g(l) + g(r));  // [Toro 9.42]
}

Conserved hllc_flux(const GasState& l, const GasState& r, double gamma) {
  const double p = estimated_pressure(l, r, gamma);
  auto reach = [=](const GasState& gas) {  // sound speed times q, [Toro 10.59, 10.60]
    const double ratio = p / gas.pressure;
    return sound_speed(gas, gamma) * (ratio > 1 ? std::sqrt(1 + (gamma + 1) / (2 * gamma) * (ratio - 1)) : 1);
  };
  const double s_l = l.velocity - reach(l), s_r = r.velocity + reach(r);
  if (s_l >= 0) return flux(l, gamma);
  if (s_r <= 0) return flux(r, gamma);
  const double m_l = l.density * (s_l - l.velocity), m_r = r.density * (s_r - r.velocity);
  const double s = (r.pressure - l.pressure + l.velocity * m_l - r.velocity * m_r) / (m_l - m_r);  // [Toro 10.37]
  auto beside_contact = [=](const GasState& gas, double m, double edge) {
    const Conserved u = conserved(gas, gamma);
    const double density = m / (edge - s);
    const double energy = u.energy / gas.density + (s - gas.velocity) * (s + gas.pressure / m);
    const Conserved star{density, density * s, density * energy};  // [Toro 10.39]
    return flux(gas, gamma) + edge * (star - u);                   // [Toro 10.38]
  };
  return s >= 0 ? beside_contact(l, m_l, s_l) : beside_contact(r, m_r, s_r);
}

/// The harmonic mean of the two neighbouring differences (B. van Leer, J. Comput. Phys. 14 (1974) 361)
double limited(double back, double front) {
  const double product = back * front;
  return product > 0 ? 2 * product / (back + front) : 0;
}

GasState limited_slope(const GasState& a, const GasState& b, const GasState& c) {
  return {limited(b.density - a.density, c.density - b.density),
          limited(b.velocity - a.velocity, c.velocity - b.velocity),
          limited(b.pressure - a.pressure, c.pressure - b.pressure)};
}

/// The states at both faces of a cell after half a time step (Toro, section 14.4).
struct Faces {
  GasState left, right;
};

Faces half_step(const GasState& gas, const GasState& slope, double gamma, double ratio) {
  auto face = [&](double side) {
    return GasState{gas.density + side * slope.density, gas.velocity + side * slope.velocity,
                    gas.pressure + side * slope.pressure};
  };
  const GasState l = face(-0.5), r = face(0.5);
  const Conserved change = (0.5 * ratio) * (flux(l, gamma) - flux(r, gamma));
  const Faces evolved{primitive(conserved(l, gamma) + change, gamma), primitive(conserved(r, gamma) + change, gamma)};
  const bool positive = evolved.left.density > 0 && evolved.left.pressure > 0 && evolved.right.density > 0 &&
                        evolved.right.pressure > 0;
  return positive ? evolved : Faces{gas, gas};  // beside a vacuum the first-order scheme, which stays positive
}

class Tube {
 public:
  Tube(const GasProblem& problem, int cells) : problem_(problem), gamma_(problem.gamma) {
    width_ = (problem.high - problem.low) / cells;
    for (int i = 0; i < cells; ++i) {
      const double end = i + 1 < cells ? problem.low + (i + 1) * width_ : problem.high;
      gas_.push_back(mean_state(problem, problem.low + i * width_, end));
      means_.push_back(conserved(gas_.back(), gamma_));
    }
  }

  double stable_step() const {
    double fastest = 0;
    for (const GasState& gas : gas_) fastest = std::max(fastest, std::abs(gas.velocity) + sound_speed(gas, gamma_));
    return width_ / fastest;
  }

  void step(double dt) {
    const int cells = static_cast<int>(gas_.size());
    faces_.resize(gas_.size() + 2);  // one cell beyond each end
    for (int i = -1; i <= cells; ++i) {
      const GasState slope = limited_slope(cell(i - 1), cell(i), cell(i + 1));
      faces_[static_cast<std::size_t>(i + 1)] = half_step(cell(i), slope, gamma_, dt / width_);
    }
    Conserved inflow = hllc_flux(faces_[0].right, faces_[1].left, gamma_);
    for (std::size_t i = 0; i < gas_.size(); ++i) {
      const Conserved outflow = hllc_flux(faces_[i + 1].right, faces_[i + 2].left, gamma_);
      means_[i] = means_[i] + (dt / width_) * (inflow - outflow);
      gas_[i] = primitive(means_[i], gamma_);
      if (!(gas_[i].density > 0 && gas_[i].pressure > 0)) {
        throw std::domain_error("finite volumes: density or energy is no longer positive");
      }
      inflow = outflow;
    }
  }

  const std::vector<GasState>& gas() const { return gas_; }

 private:
  /// Cell i, two cells beyond each end included: mirrored at a wall, the last one repeated at an outflow.
  GasState cell(int i) const {
    const int cells = static_cast<int>(gas_.size());
    if (i >= 0 && i < cells) return gas_[static_cast<std::size_t>(i)];
    const bool wall = (i < 0 ? problem_.left : problem_.right) == GasBoundary::reflecting;
    const int image = i < 0 ? (wall ? -1 - i : 0) : (wall ? 2 * cells - 1 - i : cells - 1);
    GasState gas = gas_[static_cast<std::size_t>(image)];
    if (wall) gas.velocity = -gas.velocity;
    return gas;
  }

  const GasProblem& problem_;
  double gamma_, width_;
  std::vector<GasState> gas_;
  std::vector<Conserved> means_;
  std::vector<Faces> faces_;
};

void check_request(const GasProblem& problem, int cells, double courant) {
  check_problem(problem);
  check({"dimension", 0, 1, 1, false, false, "1", ""}, problem.dimension);
  check({"cells", 0, 2, 1e7, false, false, "1", ""}, cells);
  check({"courant", 0, 0, 1, true, true, "1", ""}, courant);
  if (problem.left == GasBoundary::vacuum || problem.right == GasBoundary::vacuum) {
    throw std::invalid_argument("finite volumes: no free surface");
  }
}

}  // namespace

FiniteVolumeSolution solve_finite_volume(const GasProblem& problem, int cells, double courant) {
  check_request(problem, cells, courant);
  Tube tube(problem, cells);
  FiniteVolumeSolution solution{problem.low, problem.high, problem.gamma, {}, 0};
  for (double time = 0; time < problem.end_time; ++solution.steps) {
    // The speeds of the first steps are not known before the jumps break up (Toro, section 6.3.2).
    double dt = (solution.steps < 5 ? 0.2 : 1) * courant * tube.stable_step();
    if (!(dt > 0)) throw std::domain_error("finite volumes: no stable step");
    if (time + dt >= problem.end_time * (1 - 1e-14)) dt = problem.end_time - time;
    tube.step(dt);
    time = dt == problem.end_time - time ? problem.end_time : time + dt;
  }
  solution.cells = tube.gas();
  return solution;
}

GasFields mean_errors(const FiniteVolumeSolution& solution, const std::function<GasState(double)>& exact) {
  GasFields sum;
  const double weight = 1 / static_cast<double>(solution.cells.size());
  for (std::size_t i = 0; i < solution.cells.size(); ++i) {
    const GasState &a = solution.cells[i], b = exact(solution.centre(i));
    sum.density += weight * std::abs(a.density - b.density);
    sum.velocity += weight * std::abs(a.velocity - b.velocity);
    sum.pressure += weight * std::abs(a.pressure - b.pressure);
    sum.energy += weight * std::abs(a.pressure / a.density - b.pressure / b.density) / (solution.gamma - 1);
  }
  return sum;
}

}  // namespace plumbline::reference
