// The semi-discrete equations: the state of all points in one vector, and its rate of change.
#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernel/engine/layout.hpp"
#include "kernel/materials/shared_dilatation.hpp"

namespace plumbline {

// visit(body, column) for each that time integration advances.
template <class Visit>
void for_state_columns(std::vector<Body>& bodies, const MaterialContext& context, Visit&& visit) {
  for (Body& body : bodies) {
    visit(body, column::position);
    visit(body, column::velocity);
    for (const ColumnId* id : body.material->internal_variables(context)) visit(body, *id);
    if (body.points.has(column::dilatation)) visit(body, column::dilatation);
  }
}

inline State state_of(std::vector<Body>& bodies, const MaterialContext& context) {
  State state;
  for_state_columns(bodies, context, [&](const Body& body, const ColumnId& id) {
    const auto values = body.points.values(id);
    state.values.insert(state.values.end(), values.begin(), values.end());
  });
  return state;
}

// visit(body, column, its values) for each part of a state. Throws std::invalid_argument for one of another size.
template <class AnyState, class Visit>
void for_parts(AnyState& state, std::vector<Body>& bodies, const MaterialContext& context, Visit&& visit) {
  std::size_t wanted = 0;
  for_state_columns(bodies, context,
                    [&](const Body& body, const ColumnId& id) { wanted += body.points.values(id).size(); });
  if (state.values.size() != wanted) {
    throw std::invalid_argument("a state of " + std::to_string(state.values.size()) + " numbers where the scene has " +
                                std::to_string(wanted));
  }
  auto next = state.values.begin();
  for_state_columns(bodies, context, [&](Body& body, const ColumnId& id) {
    const std::size_t size = std::as_const(body.points).values(id).size();
    visit(body, id, std::span(next, size));
    next += static_cast<std::ptrdiff_t>(size);
  });
}

// Of points whose strain rates are known; `end` of the fields holds accelerations.
template <class G>
State state_rate(const Discretisation<G>& space, Layout<G::dim>& at) {
  constexpr int dim = G::dim;
  State rate;
  for (std::size_t b = 0; b < at.bodies.size(); ++b) {
    const Body& body = at.bodies[b];
    const auto& field = at.field(b);
    const auto n = static_cast<std::size_t>(body.points.points());
    const std::size_t start = rate.values.size();
    rate.values.resize(start + 2 * dim * n);
    std::array<typename PointLoops<G>::Gather, 2 * dim> rates;
    for (std::size_t k = 0; k < 2 * dim; ++k) {
      const int d = static_cast<int>(k) % dim;
      rates[k] = {component(k < dim ? field.start : field.end, d), dim, rate.values.data() + start + k * n};
    }
    space.gather(body.points, at.weights[b], rates);
    const std::vector<double> internal = body.material->rates(body.points, space.context);
    rate.values.insert(rate.values.end(), internal.begin(), internal.end());
    if (!body.points.has(column::dilatation)) continue;
    const auto shared = body.points.values(column::dilatation_rate);  // [Dilatation 1]
    rate.values.insert(rate.values.end(), shared.begin(), shared.end());
  }
  return rate;
}

}  // namespace plumbline
