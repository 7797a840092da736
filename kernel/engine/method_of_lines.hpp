// The semi-discrete equations: state, and its rate of change.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
template <class Visit>
void Mechanics<G>::for_state_columns(Visit&& visit) const {
  for (std::size_t b = 0; b < bodies(); ++b) {
    visit(b, column::position);
    visit(b, column::velocity);
    for (const ColumnId* id : scene_.bodies[b].material->internal_variables(context())) visit(b, *id);
  }
}

template <class G>
State Mechanics<G>::state() const {
  State state;
  for_state_columns([&](std::size_t b, const ColumnId& id) {
    const auto values = std::as_const(scene_.bodies[b].points).values(id);
    state.values.insert(state.values.end(), values.begin(), values.end());
  });
  return state;
}

template <class G>
void Mechanics<G>::want_size(const State& state) const {
  std::size_t wanted = 0;
  for_state_columns(
      [&](std::size_t b, const ColumnId& id) { wanted += std::as_const(scene_.bodies[b].points).values(id).size(); });
  if (state.values.size() == wanted) return;
  throw std::invalid_argument("a state of " + std::to_string(state.values.size()) + " numbers where the scene has " +
                              std::to_string(wanted));
}

template <class G>
void Mechanics<G>::set_state(const State& state) {
  want_size(state);
  for (Weights<dim>& at : layout_.weights) at.positions_changed();
  const Totals before = totals();
  auto next = state.values.begin();
  for_state_columns([&](std::size_t b, const ColumnId& id) {
    const auto values = scene_.bodies[b].points.values(id);
    std::copy_n(next, values.size(), values.begin());
    next += static_cast<std::ptrdiff_t>(values.size());
  });
  survey_.reset();
  const Totals after = totals();
  for (std::size_t d = 0; d < 3; ++d) {
    ledger_.momentum[d].book(Flow::integration, after.momentum[d] - before.momentum[d]);
    ledger_.angular_momentum[d].book(Flow::integration, after.angular_momentum[d] - before.angular_momentum[d]);
  }
  // Two terms: their sum is kept beyond double precision, which their difference, of states far from the last, is not.
  ledger_.energy.book(Flow::integration, after.energy.total());
  ledger_.energy.book(Flow::integration, -before.energy.total());
}

template <class G>
State Mechanics<G>::velocities_of(State state) const {
  want_size(state);
  auto next = state.values.begin();
  for_state_columns([&](std::size_t b, const ColumnId& id) {
    const auto end = next + static_cast<std::ptrdiff_t>(scene_.bodies[b].points.values(id).size());
    if (&id != &column::velocity) std::fill(next, end, 0.0);
    next = end;
  });
  return state;
}

template <class G>
State Mechanics<G>::rate() {
  if (space_.transfer.keep != 1) {
    throw std::logic_error("rates of change want the transfer flip: other transfers filter velocities once a step");
  }
  sorting_ = false;  // a State names points by their place
  locate_points();
  map_mass_and_momentum();
  evaluate_stress(NodalVelocity::start);
  map_forces();
  advance_momentum(0.0);
  step_.power.emplace();  // of no step
  for (Field& field : layout_.fields) momentum_.find_acceleration(field);
  find_all_strain_rates(NodalVelocity::start);
  State rate;
  for (std::size_t b = 0; b < bodies(); ++b) {
    const Body& body = scene_.bodies[b];
    const Field& field = field_of(b);
    const auto n = static_cast<std::size_t>(body.points.points());
    const std::size_t start = rate.values.size();
    rate.values.resize(start + 2 * dim * n);
    std::array<typename Loops::Gather, 2 * dim> rates;
    for (std::size_t k = 0; k < 2 * dim; ++k) {
      const int d = static_cast<int>(k) % dim;
      rates[k] = {component(k < dim ? field.start : field.end, d), dim, rate.values.data() + start + k * n};
    }
    space_.gather(body.points, layout_.weights[b], rates);
    const std::vector<double> internal = body.material->rates(body.points, context());
    rate.values.insert(rate.values.end(), internal.begin(), internal.end());
  }
  return rate;
}

}  // namespace plumbline
