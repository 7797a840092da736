#include "cases/catalog/stability/york_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/files/whole.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/step_map.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {

std::vector<double> york_steps(const std::string& at) {
  if (at == "centres") return {0.9, 1, 1.1, 1.5, 1.9, 2};
  return {0.25, 0.5, 0.9, 1, 1.1};
}

double york_offset(const std::string& at) { return at == "centres" ? 0.5 : 1e-4; }

Patch YorkBar::patch() const {
  Patch patch;
  patch.units = {1, wave_speed, density};
  patch.scene.shape = "linear";
  patch.scene.transfer = "flip";
  patch.scene.grid.cells[0] = points;
  if (held) patch.scene.grid.walls[0] = {Wall::no_slip, Wall::no_slip};
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = youngs_modulus;
  law->density = density;
  Body body = make_body("bar", law, points, 1);
  body.spacing = 1;
  patch.places.emplace_back();
  for (int p = 0; p < points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    body.points(column::position)[at] = p + offset;
    body.points(column::mass)[at] = density;
    body.points(column::volume)[at] = 1;
    patch.places[0].push_back({{}, p});
  }
  patch.scene.bodies.push_back(std::move(body));
  return patch;
}

namespace {

int step_count(double courant) {
  return whole(std::ceil(YorkBar::end_time / (courant * YorkBar::courant_step) - 1e-9));
}

// v and sigma as StepMap orders them, each in units of c and rho c^2.
double energy_of(const StepMap& map, const std::vector<double>& state) {
  double twice = 0;
  for (std::size_t k = 0; k < state.size(); ++k) {
    const std::string name = map.name(k);
    const bool counts = map.is_velocity(k) || name.find(" stress ") != std::string::npos;
    if (counts) twice += state[k] * state[k];
  }
  return twice;
}

}  // namespace

std::vector<double> energy_history(const YorkBar& bar, double courant) {
  const Patch patch = bar.patch();
  StepMap map(patch.scene, patch.units, {"musl", {}}, Positions::moving, courant * YorkBar::courant_step);
  std::vector<double> state = map.state();
  for (std::size_t k = 0; k < state.size(); ++k) {
    if (map.is_velocity(k) && map.entry(k).point == YorkBar::kicked) state[k] = YorkBar::kick / YorkBar::wave_speed;
  }
  map.set_state(state);
  const double start = energy_of(map, state);
  std::vector<double> history{1};
  for (int k = 0; k < step_count(courant); ++k) {
    map.step();
    history.push_back(energy_of(map, map.state()) / start);
  }
  return history;
}

std::vector<double> LateHeldBar::step(const std::vector<double>& state) const {
  constexpr int nodes = YorkBar::points + 1;
  const double f = offset_;
  const auto to_nodes = [&](const auto& of_point) {
    std::vector<double> at(nodes);
    for (std::size_t p = 0; p < YorkBar::points; ++p) {
      at[p] += (1 - f) * of_point(p);
      at[p + 1] += f * of_point(p);
    }
    return at;
  };
  const auto hold = [](std::vector<double>& velocity) { velocity.front() = velocity.back() = 0; };
  std::vector<double> next = state;
  const std::vector<double> mass = to_nodes([](std::size_t) { return 1.0; });
  const auto mapped = [&] {
    std::vector<double> velocity = to_nodes([&](std::size_t p) { return next[p]; });  // [York 3.15, 3.16]
    for (std::size_t i = 0; i < nodes; ++i) velocity[i] /= mass[i];
    return velocity;
  };
  const std::vector<double> before = mapped();
  std::vector<double> after = before;
  for (std::size_t p = 0; p < YorkBar::points; ++p) {
    const double stress = state[YorkBar::points + p];
    after[p] += courant_ * stress / mass[p];  // [York 3.17, 3.20]
    after[p + 1] -= courant_ * stress / mass[p + 1];
  }
  hold(after);
  for (std::size_t p = 0; p < YorkBar::points; ++p) {
    next[p] += (1 - f) * (after[p] - before[p]) + f * (after[p + 1] - before[p + 1]);  // [York 3.22]
  }
  std::vector<double> again = mapped();  // [York 3.24]
  hold(again);
  for (std::size_t p = 0; p < YorkBar::points; ++p) {
    next[YorkBar::points + p] += courant_ * (again[p + 1] - again[p]);  // [York 3.23]
  }
  return next;
}

double LateHeldBar::spectral_radius() const {
  constexpr int size = 2 * YorkBar::points;
  Eigen::MatrixXd matrix(size, size);
  for (int k = 0; k < size; ++k) {
    std::vector<double> unit(size);
    unit[static_cast<std::size_t>(k)] = 1;
    const std::vector<double> column = step(unit);
    for (int j = 0; j < size; ++j) matrix(j, k) = column[static_cast<std::size_t>(j)];
  }
  return plumbline::spectral_radius(matrix);
}

std::vector<double> LateHeldBar::energy_history() const {
  std::vector<double> state(2 * YorkBar::points), history{1};
  state[YorkBar::kicked] = 1;
  for (int k = 0; k < step_count(courant_); ++k) {
    state = step(state);
    double twice = 0;
    for (const double value : state) twice += value * value;
    history.push_back(twice);
  }
  return history;
}

Profile energy_profile(const std::vector<double>& courants, const std::vector<std::vector<double>>& histories) {
  constexpr int times = 241;
  constexpr double axis_end = 1e-15, start = 0.5 * YorkBar::density * YorkBar::kick * YorkBar::kick;
  Profile profile{"history", "time", {{"time", "s", "time", {}}}};
  for (int k = 0; k < times; ++k) profile.columns[0].values.push_back(YorkBar::end_time * k / (times - 1));
  for (std::size_t c = 0; c < courants.size(); ++c) {
    const std::string factor = fmt::format("{:g}", courants[c]);
    ProfileColumn column{"energy_" + factor, "J", "total energy, Δt = " + factor + " h/c", {}};
    for (const double t : profile.columns[0].values) {
      const double steps = t / (courants[c] * YorkBar::courant_step);
      const auto below = std::min(static_cast<std::size_t>(steps), histories[c].size() - 2);
      const double part = steps - static_cast<double>(below);
      const double energy = start * ((1 - part) * histories[c][below] + part * histories[c][below + 1]);
      column.values.push_back(std::min(energy, axis_end));
    }
    profile.columns.push_back(std::move(column));
  }
  return profile;
}

}  // namespace plumbline
