// Masses and momenta of the points on the nodes. [York 3.15, 3.16, 3.24] [EC-APIC 1]
#pragma once

#include "kernel/engine/layout.hpp"
#include "kernel/engine/nodal_momentum.hpp"
#include "kernel/engine/step_record.hpp"

namespace plumbline {

template <class Geometry>
class ToGrid {
 public:
  using Space = Discretisation<Geometry>;
  using Record = StepRecord<Geometry::dim, Geometry::rotations>;
  using Bodies = Layout<Geometry::dim>;
  using Field = typename Space::Field;

  explicit ToGrid(const Space& space) : space_(space) {}

  void map_mass_and_momentum(Bodies& at, const NodalMomentum<Geometry>& momentum, Record& step) const {
    step.map_wall = {};
    step.map_wall_work = 0;
    step.advance.reset();
    for (Field& field : at.fields) momentum.clear_map(field);
    for (const bool gas : {true, false}) {  // gases first: where others share their nodes, their mass is wanted alone
      for (std::size_t b = 0; b < at.bodies.size(); ++b) {
        const Body& body = at.bodies[b];
        if (body.material->takes_heat() != gas) continue;
        space_.for_chunks_writing_nodes(at.weights[b], [&](const Chunk& chunk) {
          space_.loops->map_mass_and_momentum(body, at.weights[b], chunk, at.field(b));
        });
      }
      for (Field& field : at.fields) {
        if (!gas || !field.mixed()) continue;
        field.for_touched(space_.grid, [&](std::size_t i) { field.gas.mass[i] = field.mass[i]; });
        space_.walls.fold_even(field, field.gas.mass);
        space_.walls.extend_even(field, field.gas.mass);
      }
    }
    step.grid_mass = 0;
    for (Field& field : at.fields) step.grid_mass += momentum.start(field, step);
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (space_.acts_at_nodes(at.bodies[b])) space_.pressure.find_interpolation(at.field(b), space_.threads);
    }
    step.map_loss.reset();
    if (space_.transfer.keep == 1) step.map_loss = 0;
    step.newest = NodalVelocity::start;
  }

  // Sums what the map lost, if it is not known yet, from velocities as they were mapped.
  void settle_loss(Bodies& at, Record& step) const {
    if (step.map_loss) return;
    double loss = 0;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      const auto& places = at.weights[b];
      loss += space_.template sum_over_chunks<double>(places, [&](const Chunk& chunk) {
        return space_.loops->gather_start(at.bodies[b], places, chunk, {.loss = &at.field(b).start});
      });
    }
    step.map_loss = loss;
  }

  void map_momentum(Bodies& at, const NodalMomentum<Geometry>& momentum, Record& step) const {
    for (Field& field : at.fields) {
      field.for_touched(space_.grid, [&](std::size_t i) { field.momentum[i].setZero(); });
    }
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      space_.for_chunks_writing_nodes(at.weights[b], [&](const Chunk& chunk) {
        space_.loops->map_momentum(at.bodies[b], at.weights[b], chunk, at.field(b));
      });
    }
    momentum.start_again(at.fields);
    step.newest = NodalVelocity::remapped;
    if (step.rates_of == NodalVelocity::remapped) step.rates_of.reset();
  }

 private:
  const Space& space_;
};

}  // namespace plumbline
