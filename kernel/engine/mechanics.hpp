// One step: each stage asks the parts of the engine for it and passes on what the step has come to know. Included only by files
// that instantiate it for a geometry; shape and transfer are the loops' (point_loops.hpp).
#pragma once

#include <stdexcept>

#include "kernel/engine/finish.hpp"
#include "kernel/engine/holding.hpp"
#include "kernel/engine/locating.hpp"
#include "kernel/engine/method_of_lines.hpp"
#include "kernel/engine/pressures.hpp"
#include "kernel/engine/stress.hpp"
#include "kernel/engine/to_grid.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {

inline int threads_for(const Scene& scene, int wanted) {
  constexpr long fewest_shared = 2048;  // points below which waking a thread costs more than it does
  long points = 0;
  for (const Body& body : scene.bodies) points += body.points.points();
  return points < fewest_shared ? 1 : wanted;
}

// What gases map beside their forces.
inline Shares shares_of(const Scene& scene, bool filters_at_rate, bool keep_loss) {
  if (filters_at_rate) return Shares::heat_and_sound;
  return scene.heat_exchange > 0 && keep_loss ? Shares::heat : Shares::none;
}

template <class Geometry>
class Mechanics final : public Engine {
 public:
  static constexpr int dim = Geometry::dim;

  Mechanics(Scene& scene, Ledger& ledger, const EngineOptions& options)
      : ledger_(ledger),
        space_(scene, threads_for(scene, options.threads)),
        layout_(layout_of(scene.bodies, space_.grid)),
        locating_(space_, scene, options, ledger),
        to_grid_(space_),
        holding_(space_, scene),
        momentum_(space_, scene, layout_.field_of_body),
        strain_(space_, scene.strain_smoothing, ledger),
        stress_(space_, scene, shares_of(scene, space_.filters_at_rate(scene), options.keep_loss)),
        motion_(space_, scene, options.keep_loss, ledger),
        pressures_(space_, scene.density, scene.sharpened_density ? scene.sharpening : 0) {
    refuse_what_cannot_work(scene, space_);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      Body& body = scene.bodies[b];
      if (space_.transfer.affine) body.points.add(column::affine, dim * dim);
      if (space_.shape.boxes) add_boxes<Geometry>(body, shape_named(scene.shape).boxes_deform);
      if (space_.shape.at_start) add_places_at_start(body.points);
      if (space_.filters_at_rate(scene) && body.material->takes_heat()) {
        if (momentum_.contact_changes_start()) {  // what the points keep would not be what the map put on the nodes
          throw std::invalid_argument("a filter at a rate cannot work with the contact law " + scene.contact +
                                      ", which changes velocities of the start");
        }
        body.points.add(column::sound_speed);
      }
      motion_.add_columns(body, layout_.field(b));
      stress_.add_columns(body);
      if (scene.mean_dilatation) MeanDilatation<Geometry>::add_columns(body);
    }
  }

  void locate_points() override {
    locating_.locate(layout_);
    step_.begin();
    stress_.find_pairs(layout_);
  }

  void map_mass_and_momentum() override {
    layout_.want_places("map_mass_and_momentum");
    to_grid_.map_mass_and_momentum(layout_, momentum_, step_);
    holding_.hold_start(layout_, step_);
  }

  void map_forces() override {
    layout_.want_places("map_forces");
    strain_.settle_early(layout_, step_);
    stress_.map_forces(layout_, step_, clock_);
  }

  void advance_momentum(double dt) override {
    layout_.want_places("advance_momentum");
    if (momentum_.contact_changes_start()) to_grid_.settle_loss(layout_, step_);
    const bool first = !step_.advance;
    step_.advance = momentum_.advance(layout_.fields, step_.forces.value_or(MappedForces<dim>{}), dt, first);
    step_.advance->contact.work += stress_.work_of_pairs(layout_, dt);
    holding_.hold_advanced(layout_, *step_.advance);
    step_.power.reset();
    step_.rates_of.reset();
    step_.newest = NodalVelocity::end;
  }

  void move_points(double dt, NodalVelocity carrying) override { carry_points(dt, {}, carrying); }

  void drift_points(double dt) override {
    survey_.reset();
    for (Weights<dim>& at : layout_.weights) at.positions_changed();
    clock_.drifted += dt;
    motion_.drift(layout_, step_, dt);
  }

  void kick_points(double dt) override { carry_points(dt, 0.0, NodalVelocity::end); }

  void map_momentum() override {
    layout_.want_places("map_momentum");
    to_grid_.map_momentum(layout_, momentum_, step_);
    holding_.hold_remapped(layout_);
  }

  void strain_points(double dt, NodalVelocity velocity) override {
    layout_.want_places("strain_points");
    strain_.settle_power(layout_, step_);
    survey_.reset();
    strain_.advance(layout_, step_, dt, velocity);
  }

  void evaluate_stress(NodalVelocity velocity) override { predict_stress(0, velocity); }

  void predict_stress(double ahead, NodalVelocity velocity) override {
    layout_.want_places(ahead == 0 ? "evaluate_stress" : "predict_stress");
    strain_.settle_power(layout_, step_);
    survey_.reset();
    stress_.evaluate(layout_, step_, clock_, ahead, velocity, false);
  }

  bool reverse_cooling() override {
    layout_.want_places("reverse_cooling");
    return strain_.reverse_cooling(layout_, step_);
  }

  void return_transfer_loss() override {
    layout_.want_places("return_transfer_loss");
    survey_.reset();
    motion_.return_loss(layout_);
  }

  void predict_stress_and_map_forces(double ahead) override {
    if (layout_.places_kept()) {  // points have moved: their densities are those of where they stand
      predict_stress(ahead, NodalVelocity::start);
      return map_forces();
    }
    layout_.want_places("predict_stress");
    strain_.settle_early(layout_, step_);
    strain_.settle_power(layout_, step_);
    survey_.reset();
    stress_.evaluate(layout_, step_, clock_, ahead, NodalVelocity::start, true);
  }

  void finish_points(double dt, std::optional<double> drift) override {
    layout_.want_places(drift ? "kick_points" : "move_points");
    to_grid_.settle_loss(layout_, step_);
    survey_ = completed(motion_.finish(layout_, step_, dt, drift), step_.grid_mass, space_.grid.h(), dim);
    momentum_.pass_time(dt);
  }

  State state() const override { return state_of(layout_.bodies, space_.context); }

  State velocities_of(State state) const override {
    for_parts(state, layout_.bodies, space_.context, [](const Body&, const ColumnId& id, std::span<double> values) {
      if (&id != &column::velocity) std::fill(values.begin(), values.end(), 0.0);
    });
    return state;
  }

  void set_state(const State& state) override {
    const Totals before = totals();
    for_parts(state, layout_.bodies, space_.context,
              [](Body& body, const ColumnId& id, std::span<const double> values) {
                std::copy(values.begin(), values.end(), body.points.values(id).begin());
              });
    for (Weights<dim>& at : layout_.weights) at.positions_changed();
    survey_.reset();
    const Totals& after = totals();
    for (std::size_t d = 0; d < 3; ++d) {
      ledger_.momentum[d].book(Flow::integration, after.momentum[d] - before.momentum[d]);
      ledger_.angular_momentum[d].book(Flow::integration, after.angular_momentum[d] - before.angular_momentum[d]);
    }
    // Two terms: their sum is kept beyond double precision, which their difference, of states far from the last, is not.
    ledger_.energy.book(Flow::integration, after.energy.total());
    ledger_.energy.book(Flow::integration, -before.energy.total());
  }

  State rate() override {
    if (space_.transfer.keep != 1) {
      throw std::logic_error("rates of change want the transfer flip: other transfers filter velocities once a step");
    }
    locating_.locate(layout_, false);  // a State names points by their place
    step_ = {};
    map_mass_and_momentum();
    evaluate_stress(NodalVelocity::start);
    map_forces();
    advance_momentum(0.0);
    step_.power.emplace();  // of no step
    for (auto& field : layout_.fields) momentum_.find_acceleration(field);
    strain_.find_rates(layout_, step_, NodalVelocity::start);
    return state_rate(space_, layout_);
  }

  void initialise() override {
    survey_.reset();
    locating_.clear_stale_rates(layout_);
    locate_points();
    map_mass_and_momentum();
    step_.rates_of = NodalVelocity::start;  // the rates that the points carry serve
    step_.map_loss = 0;
    evaluate_stress(NodalVelocity::start);
    for (std::size_t b = 0; b < layout_.bodies.size(); ++b) {
      Body& body = layout_.bodies[b];
      body.material->describe(body.points);
      pressures_.read(body, layout_.weights[b], layout_.field(b));
    }
  }

  const Survey& survey() const override {
    if (survey_) return *survey_;
    Survey all;
    for (std::size_t b = 0; b < layout_.bodies.size(); ++b) {
      if (layout_.bodies[b].points.points() == 0) continue;
      all += space_.template sum_over_chunks<Survey>(layout_.weights[b], [&](const Chunk& chunk) {
        return space_.loops->survey(layout_.bodies[b], {chunk.first, chunk.last});
      });
    }
    return survey_.emplace(completed(all, step_.grid_mass, space_.grid.h(), dim));
  }

  void set_time(double time) override {
    clock_ = {time};
    step_.begin();
  }

  void points_changed(std::optional<double> time) override {
    survey_.reset();
    if (time) momentum_.set_time(*time);
    locating_.forget(layout_);
  }

 private:
  void carry_points(double dt, std::optional<double> drift, NodalVelocity carrying) {
    layout_.want_places(drift ? "kick_points" : "move_points");
    to_grid_.settle_loss(layout_, step_);
    survey_.reset();
    motion_.carry(layout_, step_, dt, drift, carrying);
    momentum_.pass_time(dt);
  }

  Ledger& ledger_;
  Discretisation<Geometry> space_;
  Layout<dim> layout_;
  Locating<Geometry> locating_;
  ToGrid<Geometry> to_grid_;
  Holding<Geometry> holding_;
  NodalMomentum<Geometry> momentum_;
  Strain<Geometry> strain_;
  Stress<Geometry> stress_;
  Motion<Geometry> motion_;
  Pressures<Geometry> pressures_;
  StepRecord<dim, Geometry::rotations> step_;
  StepClock clock_;
  mutable std::optional<Survey> survey_;  // none: points have changed since the last
};

template <class Geometry>
std::unique_ptr<Engine> make_engine_of(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return std::make_unique<Mechanics<Geometry>>(scene, ledger, options);
}

}  // namespace plumbline
