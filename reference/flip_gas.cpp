#include "reference/flip_gas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

using Field = std::vector<double>;

double dot(const Field& a, const Field& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

// Bilinear shapes of the vertices of a point's cell, or quadratic ones of the nine cells about it.
template <std::size_t N>
struct Shapes {
  std::array<std::size_t, N> at;
  std::array<double, N> weight;
};

class Flip {
 public:
  Flip(const FlipGas& gas, std::vector<FlipPoint> points)
      : gas_(gas), side_(static_cast<std::size_t>(gas.cells)), points_(std::move(points)) {}

  FlipState run() {
    for (double time = 0; gas_.end_time - time > 1e-12 * gas_.end_time;) {
      const double dt = std::min(gas_.step, gas_.end_time - time);
      advance(dt);
      time += dt;
    }
    to_grid();
    return {std::move(points_), std::move(pressure_)};
  }

 private:
  std::size_t vertices() const { return (side_ + 1) * (side_ + 1); }
  std::size_t cells() const { return side_ * side_; }
  std::size_t clamped(double at) const {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(side_ - 1)));
  }

  Shapes<4> at_vertices(const FlipPoint& p) const {
    Shapes<4> s{};
    const double x = p.place[0] / gas_.h, y = p.place[1] / gas_.h;
    const std::size_t i = clamped(std::floor(x)), j = clamped(std::floor(y));
    const double r = x - static_cast<double>(i), q = y - static_cast<double>(j);
    const std::size_t v = j * (side_ + 1) + i;
    s.at = {v, v + 1, v + side_ + 1, v + side_ + 2};
    s.weight = {(1 - r) * (1 - q), r * (1 - q), (1 - r) * q, r * q};
    return s;
  }

  // A cell beyond a side is the mirror image of the one within.
  Shapes<9> at_cells(const FlipPoint& p) const {
    std::array<std::array<std::size_t, 3>, 2> cell{};
    std::array<std::array<double, 3>, 2> weight{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double x = p.place[d] / gas_.h;
      const std::size_t middle = clamped(std::floor(x));
      const double r = x - static_cast<double>(middle) - 0.5;
      cell[d] = {middle > 0 ? middle - 1 : 0, middle, std::min(middle + 1, side_ - 1)};
      weight[d] = {0.5 * (0.5 - r) * (0.5 - r), 0.75 - r * r, 0.5 * (0.5 + r) * (0.5 + r)};
    }
    Shapes<9> s{};
    for (std::size_t k = 0; k < 9; ++k) {
      s.at[k] = cell[1][k / 3] * side_ + cell[0][k % 3];
      s.weight[k] = weight[1][k / 3] * weight[0][k % 3];
    }
    return s;
  }

  void to_grid() {
    mass_.assign(vertices(), 0);
    velocity_.assign(2 * vertices(), 0);
    cell_mass_.assign(cells(), 0);
    energy_.assign(cells(), 0);
    for (const FlipPoint& p : points_) {
      const Shapes<4> at_v = at_vertices(p);
      for (std::size_t k = 0; k < 4; ++k) {
        const double m = p.mass * at_v.weight[k];
        mass_[at_v.at[k]] += m;
        for (std::size_t d = 0; d < 2; ++d) velocity_[2 * at_v.at[k] + d] += m * p.velocity[d];
      }
      const Shapes<9> at_c = at_cells(p);
      for (std::size_t k = 0; k < 9; ++k) {
        cell_mass_[at_c.at[k]] += p.mass * at_c.weight[k];
        energy_[at_c.at[k]] += p.mass * at_c.weight[k] * p.energy;
      }
    }
    pressure_.assign(cells(), 0);
    for (std::size_t c = 0; c < cells(); ++c) {
      pressure_[c] = (gas_.gamma - 1) * energy_[c] / (gas_.h * gas_.h);  // [York 4.4] of (gamma - 1) rho i
    }
    for (std::size_t v = 0; v < vertices(); ++v) {
      for (std::size_t d = 0; d < 2; ++d) velocity_[2 * v + d] = mass_[v] > 0 ? velocity_[2 * v + d] / mass_[v] : 0;
    }
    hold(velocity_);
  }

  // No gas crosses a side.
  void hold(Field& at) const {
    for (std::size_t k = 0; k <= side_; ++k) {
      for (const std::size_t v : {k * (side_ + 1), k * (side_ + 1) + side_}) at[2 * v] = 0;
      for (const std::size_t v : {k, side_ * (side_ + 1) + k}) at[2 * v + 1] = 0;
    }
  }

  // Of a bilinear shape the integral of its gradient over a cell is h/2, with the sign of the corner.
  template <class Visit>
  void over_corners(std::size_t c, Visit&& visit) const {
    const std::size_t v = (c / side_) * (side_ + 1) + c % side_;
    const double g = gas_.h / 2;
    visit(v, -g, -g);
    visit(v + 1, g, -g);
    visit(v + side_ + 1, -g, g);
    visit(v + side_ + 2, g, g);
  }

  // div u of each cell times its volume.
  Field flow_out(const Field& u) const {
    Field out(cells(), 0);
    for (std::size_t c = 0; c < cells(); ++c) {
      over_corners(c, [&](std::size_t v, double gx, double gy) { out[c] += gx * u[2 * v] + gy * u[2 * v + 1]; });
    }
    return out;
  }

  Field forces(const Field& pressure) const {
    Field f(2 * vertices(), 0);
    for (std::size_t c = 0; c < cells(); ++c) {
      over_corners(c, [&](std::size_t v, double gx, double gy) {
        f[2 * v] += gx * pressure[c];
        f[2 * v + 1] += gy * pressure[c];
      });
    }
    hold(f);
    for (std::size_t v = 0; v < vertices(); ++v) {
      if (mass_[v] == 0) f[2 * v] = f[2 * v + 1] = 0;
    }
    return f;
  }

  // p at the end of an adiabatic step, p - gamma p dt div u.
  Field pressure_after(const Field& u, double dt) const {
    Field p = flow_out(u);
    for (std::size_t c = 0; c < cells(); ++c) {
      p[c] = pressure_[c] * (1 - gas_.gamma * dt * p[c] / (gas_.h * gas_.h));
    }
    return p;
  }

  // M u + dt^2 B^T (gamma p/V) B u, symmetric and positive: what stands left of the implicit momentum balance.
  Field inertia(const Field& u, double dt) const {
    Field p = flow_out(u);
    for (std::size_t c = 0; c < cells(); ++c) p[c] *= -gas_.gamma * pressure_[c] * dt / (gas_.h * gas_.h);
    Field f = forces(p);
    for (std::size_t k = 0; k < f.size(); ++k) f[k] = mass_[k / 2] * u[k] - dt * f[k];
    return f;
  }

  // Conjugate gradients, scaled by the masses.
  Field implicit_velocity(double dt) const {
    const Field start = inertia(velocity_, dt), push = forces(pressure_);
    Field u = velocity_, r(u.size()), z(u.size());
    for (std::size_t k = 0; k < u.size(); ++k) r[k] = mass_[k / 2] * u[k] + dt * push[k] - start[k];
    const auto scaled = [&](const Field& of) {
      for (std::size_t k = 0; k < of.size(); ++k) z[k] = mass_[k / 2] > 0 ? of[k] / mass_[k / 2] : 0;
    };
    scaled(r);
    Field along = z;
    double size = dot(r, z);
    const double enough = 1e-24 * size;
    for (int k = 0; size > enough; ++k) {
      if (k == 10000) throw std::runtime_error("an implicit FLIP step was not solved in 10000 iterations");
      const Field image = inertia(along, dt);
      const double step = size / dot(along, image);
      for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] += step * along[i];
        r[i] -= step * image[i];
      }
      scaled(r);
      const double next = dot(r, z);
      for (std::size_t i = 0; i < u.size(); ++i) along[i] = z[i] + next / size * along[i];
      size = next;
    }
    return u;
  }

  void advance(double dt) {
    to_grid();
    Field after = velocity_, pressure = pressure_;
    if (gas_.implicit) {
      after = implicit_velocity(dt);
      pressure = pressure_after(after, dt);
    } else {
      const Field push = forces(pressure_);
      for (std::size_t k = 0; k < after.size(); ++k) after[k] += mass_[k / 2] > 0 ? dt * push[k] / mass_[k / 2] : 0;
    }
    Field middle(after.size()), change(after.size());
    for (std::size_t k = 0; k < after.size(); ++k) {
      middle[k] = 0.5 * (velocity_[k] + after[k]);
      change[k] = after[k] - velocity_[k];
    }
    Field heating = flow_out(middle);  // of specific internal energy
    for (std::size_t c = 0; c < cells(); ++c) {
      heating[c] *= cell_mass_[c] > 0 ? -dt * pressure[c] / cell_mass_[c] : 0;
    }
    move(after, change, heating, dt);
  }

  void move(const Field& velocity, const Field& change, const Field& heating, double dt) {
    const double end = gas_.h * gas_.cells;
    for (FlipPoint& p : points_) {
      const Shapes<9> at_c = at_cells(p);
      for (std::size_t k = 0; k < 9; ++k) p.energy += at_c.weight[k] * heating[at_c.at[k]];
      const Shapes<4> at_v = at_vertices(p);
      for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t k = 0; k < 4; ++k) {
          p.velocity[d] += at_v.weight[k] * change[2 * at_v.at[k] + d];
          p.place[d] += dt * at_v.weight[k] * velocity[2 * at_v.at[k] + d];
        }
        p.place[d] = std::clamp(p.place[d], 0.0, end);
      }
    }
  }

  FlipGas gas_;
  std::size_t side_;
  std::vector<FlipPoint> points_;
  Field mass_, velocity_;                  // of vertices
  Field cell_mass_, energy_, pressure_;    // of cells
};

}  // namespace

FlipState flip_gas(const FlipGas& gas, std::vector<FlipPoint> points) {
  check({"cells", 0, 2, 1e4, false, false, "", ""}, gas.cells);
  check_positive("h", gas.h);
  check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, gas.gamma);
  check_positive("step", gas.step);
  check_not_negative("end_time", gas.end_time);
  return Flip(gas, std::move(points)).run();
}

}  // namespace plumbline::reference
