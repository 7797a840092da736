// Densities by the scene's method, then stresses, then their forces. [York 4.1] [EC-APIC 2, 3] [Leapfrog 2]
#pragma once

#include "kernel/engine/densities.hpp"
#include "kernel/engine/forces.hpp"
#include "kernel/engine/mean_dilatation.hpp"
#include "kernel/engine/pair_forces.hpp"

namespace plumbline {

template <class Geometry>
class Stress {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Record = StepRecord<dim, Geometry::rotations>;
  using Bodies = Layout<dim>;

  // shares: see Forces.
  Stress(const Space& space, const Scene& scene, Shares shares)
      : space_(space),
        densities_(space, scene.density, scene.sharpened_density ? scene.sharpening : 0),
        dilatation_(space),
        forces_(space, shares, scene.sharpened_density ? scene.sharpening : 0),
        pairs_(space, scene) {}

  void add_columns(Body& body) const { pairs_.add_columns(body); }

  // Which points of other bodies are near, once the points are located.
  void find_pairs(Bodies& at) { pairs_.find(at); }

  // Stresses of the step's start and `ahead` s more, with the strain rates of a nodal velocity; sums what the map lost, if
  // that is not known yet, and maps the forces too where these are wanted, while the points stand where they were located. Point forces
  // are those of places, which may have drifted.
  void evaluate(Bodies& at, Record& step, const StepClock& clock, double ahead, NodalVelocity velocity,
                bool and_forces) {
    const bool forces_known = step.forces.has_value();
    if (and_forces) forces_.clear(at, step);
    step.stress_ahead = ahead;
    velocity = step.resolved(velocity);
    pairs_.press(at, ahead == 0 ? 0 : ahead - clock.drifted, velocity);
    StartSums all;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      auto& field = at.field(b);
      const Weights<dim>& places = at.weights[b];
      const bool of_places = body.material->measure() == StressMeasure::point_force;
      MaterialContext then = space_.context;
      then.ahead = of_places && ahead != 0 ? ahead - clock.drifted : ahead;
      const auto source = densities_.find(at.bodies, body, places, field, at.own_mass[b]);
      typename Space::Loops::Wanted wanted;
      if (!step.map_loss) wanted.loss = &field.start;
      if (velocity != step.rates_of) {
        const auto& straining = space_.straining_velocity(field, at.velocity(field, velocity));
        wanted.rates = space_.straining(body, places, field, straining, forces_known && at.corrected(space_, b));
        wanted.closing = space_.closing(body, field, straining);
      }
      if (!source.elsewhere) wanted.density = source.nodes;
      wanted.specific = source.specific;
      if ((of_places || dilatation_.of(body)) && wanted.rates) {  // those of all points before any looks at others'
        space_.for_chunks(places, [&](const Chunk& chunk) {
          space_.loops->gather_start(body, places, chunk, {.rates = wanted.rates});
        });
        dilatation_.average_rates(body, places);
        wanted.rates = {};
      }
      dilatation_.average_dilatation(body, places);
      if (of_places) {
        space_.for_chunks(places, [&](const Chunk& chunk) {
          body.material->prepare_stress(body.points, {chunk.first, chunk.last}, then);
        });
      }
      const auto evaluate_here = [&](const Chunk& chunk) {
        const double lost = wanted.none() ? 0.0 : space_.loops->gather_start(body, places, chunk, wanted);
        if (!source.elsewhere) body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
        return lost;
      };
      if (and_forces) {
        all += space_.template sum_over_chunks_writing_nodes<StartSums>(places, [&](const Chunk& chunk) {
          const double lost = evaluate_here(chunk);
          return StartSums{lost, forces_.map(at, b, chunk)};
        });
        forces_.complete(at, b, step, clock);
      } else {
        all.lost += space_.template sum_over_chunks<double>(places, evaluate_here);
      }
      if (!source.elsewhere) continue;
      space_.for_chunks(*source.elsewhere, [&](const Chunk& chunk) {
        space_.loops->gather_start(body, *source.elsewhere, chunk,
                                   {.density = source.nodes, .specific = source.specific});
        body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      });
    }
    if (and_forces) {
      pairs_.map(at, *step.forces);
      step.forces->hoop = all.hoop_force;
    }
    if (!step.map_loss) step.map_loss = all.lost;
    step.rates_of = velocity;
    if (and_forces) forces_.forget_rates(at, step);
  }

  // Of the stresses as they are.
  void map_forces(Bodies& at, Record& step, const StepClock& clock) {
    forces_.map_all(at, step, clock);
    pairs_.map(at, *step.forces);
  }

  // Work of contact between points over dt, once the nodes have been advanced, J.
  double work_of_pairs(Bodies& at, double dt) const { return dt * pairs_.power(at, NodalVelocity::midpoint); }

 private:
  const Space& space_;
  Densities<Geometry> densities_;
  MeanDilatation<Geometry> dilatation_;
  Forces<Geometry> forces_;
  PairForces<Geometry> pairs_;
};

}  // namespace plumbline
