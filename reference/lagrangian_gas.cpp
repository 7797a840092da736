#include "reference/lagrangian_gas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/parameter.hpp"

namespace plumbline::reference {
namespace {

double area(double r, int dimension) { return dimension == 1 ? 1 : dimension == 2 ? r : r * r; }

/// Mean area of an edge that moves from r to s, such that area * (s - r) is the volume swept.
double swept_area(double r, double s, int dimension) {
  return dimension == 1 ? 1 : dimension == 2 ? (r + s) / 2 : (r * r + r * s + s * s) / 3;
}

/// Pressure and velocity of a contact.
struct Contact {
  double pressure = 0, velocity = 0;
};

/// Velocity gained through the wave into `gas` for the pressure p behind it, and its derivative.
struct Change {
  double velocity, slope;
};

Change change(const GasState& gas, double p, double gamma) {
  if (p > gas.pressure) {
    const double A = 2 / ((gamma + 1) * gas.density), B = (gamma - 1) / (gamma + 1) * gas.pressure;  // [Toro 4.8]
    const double root = std::sqrt(A / (p + B)), jump = p - gas.pressure;
    return {jump * root, root * (1 - jump / (2 * (p + B)))};  // [Toro 4.6, 4.37]
  }
  const double a = std::sqrt(gamma * gas.pressure / gas.density), z = (gamma - 1) / (2 * gamma);
  const double ratio = p / gas.pressure, power = std::pow(ratio, z);
  return {2 * a / (gamma - 1) * (power - 1), power / (ratio * gas.density * a)};  // [Toro 4.6, 4.37]
}

/// The contact of the Riemann problem [Toro 4.5, 4.9] by Newton's method from the pressure `p`.
Contact strong_contact(const GasState& l, const GasState& r, double p, double gamma) {
  const double closing = l.velocity - r.velocity, ram = std::min(l.density, r.density) * closing * closing;
  const double scale = std::max({l.pressure, r.pressure, closing > 0 ? ram : 0.0});
  if (scale == 0) return {0, (l.density * l.velocity + r.density * r.velocity) / (l.density + r.density)};
  p = std::max(p, closing > 0 ? 0.1 * ram : 1e-3 * std::min(l.pressure, r.pressure));
  if (!(p > 0)) p = 1e-6 * scale;
  for (int i = 0; i < 60; ++i) {
    const Change left = change(l, p, gamma), right = change(r, p, gamma);
    const double step = (left.velocity + right.velocity - closing) / (left.slope + right.slope), before = p;
    p = std::clamp(p - step, 0.05 * p, 20 * p);
    if (std::abs(p - before) < 1e-10 * p || p < 1e-12 * scale) break;
  }
  return {p, (l.velocity + r.velocity + change(r, p, gamma).velocity - change(l, p, gamma).velocity) / 2};
}

/// The contact between two faces; `z` is density times sound speed of their cells. The linear solution (Toro,
/// section 9.3) is taken as it is where the waves are weak: its error is of third order in their strength.
Contact contact(const GasState& l, const GasState& r, double z_l, double z_r, double gamma) {
  const double share = 1 / (z_l + z_r), closing = l.velocity - r.velocity, excess = l.pressure - r.pressure;
  const double p = (z_r * l.pressure + z_l * r.pressure + z_l * z_r * closing) * share;
  const double weak = 3e-3;
  if (std::abs(p - l.pressure) < weak * l.pressure && std::abs(p - r.pressure) < weak * r.pressure) {
    return {p, (z_l * l.velocity + z_r * r.velocity + excess) * share};
  }
  return strong_contact(l, r, p, gamma);
}

/// The two neighbouring gradients' harmonic mean (B. van Leer, J. Comput. Phys. 14 (1974) 361) times
/// half a cell; never beyond a neighbour's mean.
double limited(double a, double b, double c, double back, double front, double half) {
  const double left = b - a, right = c - b;
  if (!(left * right > 0)) return 0;
  const double slope = 2 * left * right / (left * front + right * back);
  const double most = std::min(std::abs(left), std::abs(right));
  return std::clamp(slope * half, -most, most);
}

class Gas {
 public:
  Gas(const GasProblem& problem, const std::vector<double>& mesh)
      : problem_(problem),
        gamma_(problem.gamma),
        d_(problem.dimension),
        edges_(mesh) {
    const std::size_t cells = mesh.size() - 1;
    for (std::size_t j = 0; j < cells; ++j) {
      const GasState gas = mean_state(problem, mesh[j], mesh[j + 1]);
      gas_.push_back(gas);
      masses_.push_back(gas.density * shell_volume(mesh[j], mesh[j + 1], d_));
      total_.push_back(gas.pressure / ((gamma_ - 1) * gas.density) + gas.velocity * gas.velocity / 2);
      adiabat_.push_back(gas.pressure / std::pow(gas.density, gamma_));
      impedance_.push_back(std::sqrt(gamma_ * gas.pressure * gas.density));
    }
    left_.resize(cells);
    right_.resize(cells);
    contacts_.resize(cells + 1);
    areas_.resize(cells + 1);
  }

  double stable_step() const;
  void step(double dt);
  LagrangianSolution solution() const;

 private:
  void half_step(std::size_t j, double dt);
  void solve_edges();
  bool keeps_entropy(std::size_t j) const;
  Contact end(const GasState& gas, GasBoundary boundary, double outward) const;

  const GasProblem& problem_;
  double gamma_;
  int d_;
  std::vector<double> edges_, masses_, areas_;
  std::vector<double> total_, adiabat_;       // specific total energy; p/rho^gamma at t = 0
  std::vector<double> impedance_;             // density times sound speed
  std::vector<GasState> gas_, left_, right_;  // cell means; values at both faces after half a step
  std::vector<Contact> contacts_;
};

/// The least mass over what a signal sweeps in unit time (at the outer edge, which for the cell on the axis is the
/// only one); the signal may be a shock driven by a neighbour's pressure or by collision.
double Gas::stable_step() const {
  double step = std::numeric_limits<double>::infinity();
  const std::size_t cells = gas_.size();
  for (std::size_t j = 0; j < cells; ++j) {
    const GasState &g = gas_[j], &a = gas_[j > 0 ? j - 1 : 0], &b = gas_[std::min(j + 1, cells - 1)];
    const double p = std::max({a.pressure, g.pressure, b.pressure});
    const double driven = ((gamma_ + 1) * p + (gamma_ - 1) * g.pressure) / 2 * g.density;  // [Toro 4.52], squared
    double du = std::max(std::abs(g.velocity - a.velocity), std::abs(b.velocity - g.velocity));
    if (j == 0 && problem_.left == GasBoundary::reflecting) du = std::max(du, 2 * std::abs(g.velocity));
    if (j + 1 == cells && problem_.right == GasBoundary::reflecting) du = std::max(du, 2 * std::abs(g.velocity));
    const double signal = std::sqrt(driven) + (gamma_ + 1) / 2 * du * g.density;  // mass by area and time
    step = std::min(step, masses_[j] / (area(edges_[j + 1], d_) * signal));
  }
  return step;
}

/// Both faces of cell j, half a time step later: limited slopes, then the equations in the cell's own frame.
void Gas::half_step(std::size_t j, double dt) {
  const GasState& g = gas_[j];
  left_[j] = right_[j] = g;
  const std::size_t last = gas_.size() - 1;
  const bool wall_a = j == 0 && problem_.left == GasBoundary::reflecting;
  const bool wall_b = j == last && problem_.right == GasBoundary::reflecting;
  if ((j == 0 && !wall_a) || (j == last && !wall_b)) return;
  GasState a = gas_[j > 0 ? j - 1 : 0], b = gas_[j < last ? j + 1 : last];
  const double back = (masses_[j] + masses_[j > 0 ? j - 1 : 0]) / 2;
  const double front = (masses_[j] + masses_[j < last ? j + 1 : last]) / 2, half = masses_[j] / 2;
  if (wall_a) a.velocity = -g.velocity;
  if (wall_b) b.velocity = -g.velocity;
  const GasState delta{limited(a.density, g.density, b.density, back, front, half),
                       limited(a.velocity, g.velocity, b.velocity, back, front, half),
                       limited(a.pressure, g.pressure, b.pressure, back, front, half)};
  const double A_l = area(edges_[j], d_), A_r = area(edges_[j + 1], d_), rate = dt / (2 * masses_[j]);
  const double growth = rate * (A_r * (g.velocity + delta.velocity) - A_l * (g.velocity - delta.velocity));
  const double du = -rate * (A_l + A_r) * delta.pressure;       // Du/Dt = -A dp/dm
  const double dp = -gamma_ * g.pressure * g.density * growth;  // Dp/Dt = -gamma p rho d(A u)/dm
  const double drho = -g.density * g.density * growth;          // D(1/rho)/Dt = d(A u)/dm
  const GasState l{g.density - delta.density + drho, g.velocity - delta.velocity + du,
                   g.pressure - delta.pressure + dp};
  const GasState r{g.density + delta.density + drho, g.velocity + delta.velocity + du,
                   g.pressure + delta.pressure + dp};
  if (std::min(l.density, r.density) <= 0 || std::min(l.pressure, r.pressure) < 0) return;
  left_[j] = l;
  right_[j] = r;
}

/// `outward` -1 at the left end, +1 at the right one.
Contact Gas::end(const GasState& gas, GasBoundary boundary, double outward) const {
  if (boundary == GasBoundary::outflow) return {gas.pressure, gas.velocity};
  const double z = std::sqrt(gamma_ * gas.pressure * gas.density);
  if (boundary == GasBoundary::vacuum) {
    const double a = z / gas.density;
    return {0, gas.velocity + outward * 2 * a / (gamma_ - 1)};  // Toro, section 4.6
  }
  GasState image = gas;
  image.velocity = -gas.velocity;
  return {outward < 0 ? contact(image, gas, z, z, gamma_).pressure : contact(gas, image, z, z, gamma_).pressure, 0};
}

void Gas::solve_edges() {
  contacts_.front() = end(left_.front(), problem_.left, -1);
  for (std::size_t j = 1; j < gas_.size(); ++j) {
    contacts_[j] = contact(right_[j - 1], left_[j], impedance_[j - 1], impedance_[j], gamma_);
  }
  contacts_.back() = end(right_.back(), problem_.right, +1);
}

/// Beside a vacuum the velocity varies within a cell by several times the sound speed; its kinetic energy is not heat.
bool Gas::keeps_entropy(std::size_t j) const {
  return problem_.isentropic || (j == 0 && problem_.left == GasBoundary::vacuum) ||
         (j + 1 == gas_.size() && problem_.right == GasBoundary::vacuum);
}

void Gas::step(double dt) {
  for (std::size_t j = 0; j < gas_.size(); ++j) half_step(j, dt);
  solve_edges();
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const double moved = edges_[k] + dt * contacts_[k].velocity;
    areas_[k] = swept_area(edges_[k], moved, d_);
    edges_[k] = moved;
  }
  for (std::size_t j = 0; j < gas_.size(); ++j) {
    const Contact &l = contacts_[j], &r = contacts_[j + 1];
    const double rate = dt / masses_[j], A_l = areas_[j], A_r = areas_[j + 1];
    GasState& g = gas_[j];
    g.velocity -= rate * (A_l + A_r) / 2 * (r.pressure - l.pressure);
    total_[j] -= rate * (A_r * r.pressure * r.velocity - A_l * l.pressure * l.velocity);
    const double volume = shell_volume(edges_[j], edges_[j + 1], d_);
    if (!(volume > 0)) throw std::domain_error("Lagrangian gas: a cell turned inside out");
    g.density = masses_[j] / volume;
    g.pressure = keeps_entropy(j) ? adiabat_[j] * std::pow(g.density, gamma_)
                                  : (gamma_ - 1) * g.density * std::max(total_[j] - g.velocity * g.velocity / 2, 0.0);
    impedance_[j] = std::sqrt(gamma_ * g.pressure * g.density);
  }
}

LagrangianSolution Gas::solution() const {
  LagrangianSolution s;
  s.edges = edges_;
  s.masses = masses_;
  for (const GasState& g : gas_) {
    s.density.push_back(g.density);
    s.velocity.push_back(g.velocity);
    s.pressure.push_back(g.pressure);
    s.energy.push_back(g.pressure / ((gamma_ - 1) * g.density));
  }
  return s;
}

}  // namespace

std::vector<double> lagrangian_mesh(const GasProblem& problem, int cells, int multiple, const CellPlacement& place) {
  check_problem(problem);
  check({"cells", 0, 1, 1e7, false, false, "1", ""}, cells);
  std::vector<double> ends = {problem.low};
  for (double jump : problem.jumps) {
    if (jump > problem.low && jump < problem.high) ends.push_back(jump);
  }
  ends.push_back(problem.high);
  std::sort(ends.begin(), ends.end());
  std::vector<double> edges = {problem.low};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double length = ends[i + 1] - ends[i], share = length / (problem.high - problem.low) * cells / multiple;
    const int parts = multiple * std::max(1, static_cast<int>(std::lround(share)));
    for (int k = 1; k < parts; ++k) {
      const double fraction = static_cast<double>(k) / parts;
      edges.push_back(ends[i] + length * (place ? place(fraction) : fraction));
    }
    edges.push_back(ends[i + 1]);
  }
  return edges;
}

std::size_t LagrangianSolution::cell_of(double x) const {
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, x);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

GasFields LagrangianSolution::value(std::size_t j) const { return {density[j], velocity[j], pressure[j], energy[j]}; }

GasFields LagrangianSolution::at(double x) const {
  const std::size_t j = cell_of(x);
  if (j == 0 || j + 1 == masses.size()) return value(j);
  auto centre = [this](std::size_t k) { return (edges[k] + edges[k + 1]) / 2; };
  const double offset = std::clamp(x, edges[j], edges[j + 1]) - centre(j), half = (edges[j + 1] - edges[j]) / 2;
  const double back = centre(j) - centre(j - 1), front = centre(j + 1) - centre(j);
  auto linear = [&](const std::vector<double>& f) {
    return f[j] + offset / half * limited(f[j - 1], f[j], f[j + 1], back, front, half);
  };
  return {linear(density), linear(velocity), linear(pressure), linear(energy)};
}

LagrangianSolution solve_lagrangian(const GasProblem& problem, const std::vector<double>& mesh, double courant) {
  check_problem(problem);
  check({"courant", 0, 0, 1, true, true, "1", ""}, courant);
  Gas gas(problem, mesh);
  double dt = 0.01 * courant * gas.stable_step();  // jumps break up in small steps first
  std::int64_t steps = 0;
  for (double time = 0; time < problem.end_time; ++steps) {
    dt = std::min(1.2 * dt, courant * gas.stable_step());
    if (!(dt > 0)) throw std::domain_error("Lagrangian gas: no stable step");
    const bool last = time + dt >= problem.end_time * (1 - 1e-14);
    if (steps > 100000 + 100 * static_cast<std::int64_t>(mesh.size())) {
      throw std::domain_error("Lagrangian gas: the stable step has become too small to go on");
    }
    gas.step(last ? problem.end_time - time : dt);
    time = last ? problem.end_time : time + dt;
  }
  LagrangianSolution solution = gas.solution();
  solution.steps = steps;
  return solution;
}

}  // namespace plumbline::reference
