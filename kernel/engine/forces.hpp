// Forces of stresses and loads on the nodes. [York 3.17, 3.18] [EC-APIC 4]
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/density/read_off.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/engine/step_record.hpp"
#include "kernel/surface_neighbours.hpp"  // the column clamped

namespace plumbline {

template <class Geometry>
class Forces {
 public:
  static constexpr int dim = Geometry::dim;
  static constexpr int rotations = Geometry::rotations;
  using Space = Discretisation<Geometry>;
  using Record = StepRecord<dim, rotations>;
  using Bodies = Layout<dim>;
  using Field = typename Space::Field;

  // shares: what gases map beside their forces. sharpening: how much of the maps' smoothing of densities is undone.
  Forces(const Space& space, Shares shares, double sharpening)
      : space_(space),
        shares_(shares),
        read_off_(space.grid, sharpening * space.shape.blur) {}

  void clear(Bodies& at, Record& step) const {
    step.forces.emplace();
    for (Field& field : at.fields) {
      clear(field, field.force);
      if (!field.body_force.empty()) clear(field, field.body_force);
    }
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Field& field = at.field(b);
      if (space_.acts_at_nodes(at.bodies[b])) clear(field, field.held(field.gas.pressure));
      if (shares_ == Shares::none || !at.bodies[b].material->takes_heat()) continue;
      clear(field, field.held(field.gas.heat));
      clear(field, field.held(field.gas.exchange));
      if (shares_ == Shares::heat_and_sound) clear(field, field.held(field.gas.kept));
    }
  }

  // Of the stresses of a chunk of body b's points; returns what hoop stress adds to the radial momentum, N.
  double map(Bodies& at, std::size_t b, const Chunk& chunk) const {
    const Body& body = at.bodies[b];
    const Shares shares = body.material->takes_heat() ? shares_ : Shares::none;
    return space_.loops->map_forces(body, at.weights[b], chunk, shares, at.field(b));
  }

  // What else body b does to the nodes once its stresses are mapped.
  void complete(Bodies& at, std::size_t b, Record& step, const StepClock& clock) {
    if constexpr (dim > 1) {
      if (at.corrected(space_, b)) correct(at.bodies[b], at.weights[b], at.field(b));
    }
    add_stress_turn(at.bodies[b], at.weights[b], step.forces->turn);
    add_clamp(at.bodies[b], at.weights[b], step.forces->clamp);
    map_load(at.bodies[b], at.weights[b], clock.start + step.stress_ahead, at.field(b));
  }

  void map_all(Bodies& at, Record& step, const StepClock& clock) {
    clear(at, step);
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      step.forces->hoop += space_.template sum_over_chunks_writing_nodes<double>(
          at.weights[b], [&](const Chunk& chunk) { return map(at, b, chunk); });
      complete(at, b, step, clock);
    }
    forget_rates(at, step);
  }

  // With what a correction knows now, strain rates are others.
  void forget_rates(const Bodies& at, Record& step) const {
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (at.corrected(space_, b)) step.rates_of.reset();
    }
  }

 private:
  // [Quadrature 1, 2]
  void correct(const Body& body, const Weights<dim>& at, Field& field) {
    std::vector<double>& even = field.held(field.gas.even_part);
    std::fill(even.begin(), even.end(), 0.0);
    const std::array<typename Space::Loops::Spread, 1> sums{
        {{body.points(column::stress), body.points(column::volume), even.data(), 1}}};
    space_.spread(body.points, at, sums);
    space_.walls.fold_even(field, even);
    for_each_index(static_cast<int>(even.size()), space_.threads, [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      even[i] *= -space_.inverse_volumes[i];
    });
    mapped_ = even;
    read_off_.apply(field, even, space_.threads);
    space_.quadrature.find_shares(field, mapped_, even, space_.threads);
    space_.quadrature.add_forces(field, even, space_.inverse_volumes, space_.threads);
    space_.walls.extend_even(field, even);
    space_.for_chunks_writing_nodes(
        at, [&](const Chunk& chunk) { space_.loops->take_pressure(body.points, at, chunk, even, field); });
  }

  template <class Value>
  void clear(const Field& field, std::vector<Value>& values) const {
    field.for_touched(
        space_.grid, [&](std::size_t i) { values[i] = Field::template zero<Value>(); }, space_.threads);
  }

  // sum_p F_p of a body that is clamped.
  void add_clamp(const Body& body, const Weights<dim>& at, typename Space::Vec& clamp) const {
    if (!body.points.has(column::clamped)) return;
    const double* volume = body.points(column::volume);
    for (int d = 0; d < dim; ++d) {
      const double* stress = body.points(column::stress, d);
      clamp[d] -= space_.template sum_over_chunks<double>(at, [&](const Chunk& chunk) {
        double sum = 0;
        for (int p = chunk.first; p < chunk.last; ++p) sum += volume[p] * stress[p];
        return sum;
      });
    }
  }

  // Stresses of another instant than the points' places turn a body: sum_i x_i x f_i is -sum_p V_p (sigma_ba - sigma_ab) of
  // a stress that is not symmetric, and sum_p x_p x F_p of forces between points where they will be.
  void add_stress_turn(const Body& body, const Weights<dim>& at, Spin<dim>& turn) const {
    const StressMeasure measure = body.material->measure();
    const bool full = measure == StressMeasure::full;
    if (rotations == 0 || (!full && measure != StressMeasure::point_force)) return;
    if (body.points.has(column::inverse_deformation)) return add_turn_at_start(body, at, turn);
    const Places<dim> places = at.places(body.points, false);
    const double* volume = body.points(column::volume);
    for (int k = 0; k < rotations; ++k) {
      const int d = rotation_axis<dim>(k, 0), e = rotation_axis<dim>(k, 1);
      const double *low = body.points(column::stress, full ? d * dim + e : d),
                   *high = body.points(column::stress, full ? e * dim + d : e);
      turn[k] -= space_.template sum_over_chunks<double>(at, [&](const Chunk& chunk) {
        Pack sums = 0.0;
        for_packs(chunk.first, chunk.last, [&](int p, int count) {
          const Pack s = load(low + p), t = load(high + p);
          sums += kept(load(volume + p) * (full ? t - s : load(places.x[d] + p) * t - load(places.x[e] + p) * s),
                       count);
        });
        return sum(sums);
      });
    }
  }

  // The same with nodes where they stand and weights of the points' places at the start: -sum_p V_p (T_ba - T_ab), T = sigma F^-T.
  // [Lagrangian 3]
  void add_turn_at_start(const Body& body, const Weights<dim>& at, Spin<dim>& turn) const {
    const double* volume = body.points(column::volume);
    for (int k = 0; k < rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      const double *stress[2][dim], *inverse[2][dim];
      for (int c = 0; c < dim; ++c) {
        stress[0][c] = body.points(column::stress, a * dim + c);
        stress[1][c] = body.points(column::stress, b * dim + c);
        inverse[0][c] = body.points(column::inverse_deformation, a * dim + c);
        inverse[1][c] = body.points(column::inverse_deformation, b * dim + c);
      }
      turn[k] -= space_.template sum_over_chunks<double>(at, [&](const Chunk& chunk) {
        double sum = 0;
        for (int p = chunk.first; p < chunk.last; ++p) {
          for (int c = 0; c < dim; ++c)
            sum += volume[p] * (stress[1][c][p] * inverse[0][c][p] - stress[0][c][p] * inverse[1][c][p]);
        }
        return sum;
      });
    }
  }

  // sum_p m_p b_p N_ip of what a body's load gives its points at the time of the stresses. [York 3.18]
  void map_load(Body& body, const Weights<dim>& at, double time, Field& field) const {
    if (!body.load) return;
    body.points.add(column::body_force, dim);
    body.load(time, body.points, body.id);
    std::array<typename Space::Loops::Spread, dim> forces;
    for (int d = 0; d < dim; ++d) {
      forces[static_cast<std::size_t>(d)] = {body.points(column::body_force, d), body.points(column::mass),
                                             component(field.held(field.body_force), d), dim};
    }
    space_.spread(body.points, at, forces);
  }

  const Space& space_;
  Shares shares_;
  ReadOff<dim> read_off_;
  std::vector<double> mapped_;  // p_i of [Quadrature 1]
};

}  // namespace plumbline
