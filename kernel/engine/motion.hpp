// Velocities and places of the points from the grid's motion, the heat that goes with them, and its booking.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/engine/loss_to_gas.hpp"
#include "kernel/engine/reflection.hpp"
#include "kernel/engine/strain.hpp"
#include "kernel/engine/velocity_filter.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {

template <class Geometry>
class Motion {
 public:
  static constexpr int dim = Geometry::dim;
  using Space = Discretisation<Geometry>;
  using Record = StepRecord<dim, Geometry::rotations>;
  using Bodies = Layout<dim>;
  using Field = typename Space::Field;
  using Straining = typename Space::Loops::Straining;

  // keep_loss: of the integrator, see EngineOptions.
  Motion(const Space& space, const Scene& scene, bool keep_loss, Ledger& ledger)
      : space_(space),
        chains_(space, scene.chain_relaxation, scene.strain_smoothing),
        dilatation_(space),
        reflection_(space),
        filter_(space),
        loss_to_gas_(space, scene.loss_to_gas && keep_loss),
        exchange_(scene.heat_exchange > 0 && keep_loss),
        contact_(scene.contact != "none"),
        keep_loss_(keep_loss),
        sharpened_motion_(scene.sharpened_motion),
        ledger_(ledger) {}

  // For what the maps take from points that give it back, or to the gas of their field.
  void add_columns(Body& body, const Field& field) const {
    const bool gives = loss_to_gas_.gives(body, field);
    if (gives || (keep_loss_ && body.material->takes_heat())) body.points.add(column::transfer_loss);
    if (gives) body.points.add(column::kept_loss);
  }

  // Moves points over dt with the nodal velocity `carrying`; with a drift they move with their own, for that long. The loss
  // of the map is known; the power of the forces is summed in the same pass, if it is not.
  void carry(Bodies& at, Record& step, double dt, std::optional<double> drift, NodalVelocity carrying) {
    const bool power_wanted = step.wants_power(), strained = !power_wanted || step.rates_of == NodalVelocity::midpoint;
    filter_velocities(at, step);
    Sums all;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      Field& field = at.field(b);
      at.weights[b].keep(body.points);
      const auto& carries = carrying == NodalVelocity::end ? field.end : at.velocity(field, step.resolved(carrying));
      typename Space::Loops::Motion motion{.dt = dt,
                                           .drift = drift,
                                           .straining = strained ? Straining{} : straining(at, b, step),
                                           .carrying = carrying == NodalVelocity::end ? nullptr : &carries,
                                           .exchange = exchanges_heat(body, field)};
      carry_sharpened(motion, body, field, carries);
      const Sums own = space_.template sum_over_chunks<Sums>(at.weights[b], [&](const Chunk& chunk) {
        Sums sums;
        sums.motion = space_.loops->gather_motion(body, at.weights[b], chunk, field, motion);
        if (power_wanted) sums.power = power_of(body, {chunk.first, chunk.last}, space_.context, step.advance->dt);
        return sums;
      });
      if (!strained) dilatation_.average_rates(body, at.weights[b]);
      stop_if_too_far(own.motion, body, dt);
      all += own;
    }
    if (power_wanted) step.power = all.power;
    const bool closes = std::any_of(at.bodies.begin(), at.bodies.end(),
                                    [](const Body& body) { return body.points.has(column::closing); });
    if (!strained && !closes)
      step.rates_of = NodalVelocity::midpoint;  // how fast the flow closes was not found with them
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (!drift) chains_.relax(at.bodies[b], at.weights[b], all.motion);
    }
    book(at, step, all.motion);
  }

  // x_p += dt v_p. [Leapfrog 1]
  void drift(Bodies& at, const Record& step, double dt) {
    MotionSums sums;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      const Weights<dim>& places = at.weights[b];
      const auto reflect = [&](const Chunk& chunk, MotionSums& one) {
        reflection_.apply(body.points, {chunk.first, chunk.last}, one);
      };
      MotionSums own = space_.template sum_over_chunks<MotionSums>(places, [&](const Chunk& chunk) {
        MotionSums one;
        drift(body.points, chunk, dt, one);
        if (!body.chain) reflect(chunk, one);
        return one;
      });
      stop_if_too_far(own, body, dt);
      if (body.chain) {  // all its points move before any looks where its neighbours stand
        if (step.advance && places.known()) chains_.relax(body, places, own);
        own += space_.template sum_over_chunks<MotionSums>(places, [&](const Chunk& chunk) {
          MotionSums one;
          reflect(chunk, one);
          return one;
        });
      }
      sums += own;
    }
    Record().book(ledger_, sums, false);  // walls and shifts; nothing else was exchanged
  }

  // [EC-APIC 6]
  void return_loss(Bodies& at) const {
    want_losses(at);
    hand_loss_over(at);
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      if (!body.material->takes_heat()) continue;
      loss_to_gas_.take(body, at.weights[b], at.field(b));
      const double returned = space_.template sum_over_chunks<double>(at.weights[b], [&](const Chunk& chunk) {
        return add_heat(body, {chunk.first, chunk.last});
      });
      ledger_.energy.book(Flow::transfer, returned);
    }
  }

  // carry, with a drift that too, strain with the midpoint velocity, return_loss: one pass over the points, whose survey
  // it returns. No later stage may use the points' weights.
  Survey finish(Bodies& at, Record& step, double dt, std::optional<double> drift);

 private:
  // Of one pass over some points.
  struct Sums {
    MotionSums motion;
    PowerSums power;
    Survey survey;
    double returned = 0;
    Sums& operator+=(const Sums& o) {
      motion += o.motion;
      power += o.power;
      survey += o.survey;
      returned += o.returned;
      return *this;
    }
    Sums operator+(const Sums& o) const { return Sums(*this) += o; }
  };

  void drift(Columns& points, const Chunk& chunk, double dt, MotionSums& sums) const {
    const double h = space_.grid.h();
    const auto too_far = [&](const Pack& step, int count) { return !(abs(step) <= h) && first_lanes(count); };
    for (int d = 0; d < dim; ++d) {
      double* x = points(column::position, d);
      const double* v = points(column::velocity, d);
      PackMask any_too_far = first_lanes(0);
      for_packs(
          chunk.first, chunk.last, [&](int p, int count) __attribute__((always_inline)) {
            const Pack step = dt * load(v + p);
            any_too_far = any_too_far || too_far(step, count);
            store(x + p, load(x + p) + step, count);  // [Leapfrog 1]
          });
      if (none_of(any_too_far)) continue;
      for_packs(chunk.first, chunk.last, [&](int p, int count) {
        if (sums.too_far < 0 && any_of(too_far(dt * load(v + p), count))) sums.too_far = p;
      });
    }
  }
  // By the midpoint velocity.
  Straining straining(Bodies& at, std::size_t b, const Record& step) const {
    Field& field = at.field(b);
    return space_.straining(at.bodies[b], at.weights[b], field, space_.straining_velocity(field, field.midpoint),
                            step.forces && at.corrected(space_, b));
  }
  // What moves points beside the nodal velocity that carries them, until forces are mapped again: of gases whose pressures act at
  // the nodes the flow that strains them [Pressure 4], of others what sharpening adds [Sharpening 2]. The last to be found.
  void carry_sharpened(typename Space::Loops::Motion& motion, const Body& body, Field& field,
                       const std::vector<typename Space::Vec>& carries) const {
    if (space_.acts_at_nodes(body)) {
      space_.find_flow(field, space_.straining_velocity(field, carries));
      motion.stretch = &field.gas.stretch;
      motion.faces = &field.gas.faces;
    } else if (!space_.sharpening.none() && sharpened_motion_) {
      motion.beyond = &space_.added_by_sharpening(field, carries);
    }
  }
  // Heat is exchanged as points move or are kicked, once forces were mapped, by integrators that give heat back. [Exchange 1]
  bool exchanges_heat(const Body& body, const Field& field) const {
    return exchange_ && body.material->takes_heat() && !field.gas.exchange.empty();
  }
  Sums finish_body(Bodies& at, std::size_t b, const Record& step, double dt, std::optional<double> drift);
  // Strains the points of a range and gives them what they lost.
  void strain_and_heat(Body& body, PointRange range, double dt, Sums& sums) const;
  // What ends a pass over a range: the walls, then the survey.
  void look_back(Body& body, PointRange range, bool at_walls, Sums& sums) const {
    if (at_walls) reflection_.apply(body.points, range, sums.motion);
    sums.survey = space_.loops->survey(body, range);
  }

  // Gives the points of a range what they lost; returns it, J.
  static double add_heat(Body& body, PointRange range) {
    const double* loss = body.points(column::transfer_loss);
    body.material->add_heat(body.points, range, loss);
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) sum += loss[p];
    return sum;
  }
  void hand_loss_over(Bodies& at) const {
    for (Field& field : at.fields) loss_to_gas_.clear(field);
    for (std::size_t b = 0; b < at.bodies.size(); ++b) loss_to_gas_.give(at.bodies[b], at.weights[b], at.field(b));
    for (Field& field : at.fields) loss_to_gas_.divide(field);
  }
  // Points carry what the maps take only for integrators that were seen to give it back.
  static void want_losses(const Bodies& at) {
    for (const Body& body : at.bodies) {
      if (!body.material->takes_heat() || body.points.has(column::transfer_loss)) continue;
      throw std::logic_error(
          "return_transfer_loss is called first in a later step than those that tell the integrator's traits");
    }
  }

  void filter_velocities(Bodies& at, Record& step) const {
    if (filter_.none()) return;
    if (!step.advance) step.advance.emplace();
    for (std::size_t f = 0; f < at.fields.size(); ++f) {
      typename VelocityFilter<Geometry>::Group group;
      for (std::size_t b = 0; b < at.bodies.size(); ++b) {
        if (at.field_of_body[b] == f) group.emplace_back(&at.bodies[b].points, &at.weights[b]);
      }
      filter_.apply(group, at.fields[f], step.advance->wall.linear, step.filter_turn);
    }
  }

  // The step's exchanges. What walls give to the points in a map back is among them. [EC-APIC walls]
  void book(const Bodies& at, Record& step, const MotionSums& sums) const {
    if (!step.advance) step.advance.emplace();
    WallAction<dim>& wall = step.advance->wall;
    for (const Field& field : at.fields) {
      WallAction<dim> action = space_.walls.extension_impulse(field, field.end);
      if (const double keep = space_.transfer.keep; keep > 0) {
        const WallAction<dim> before = space_.walls.extension_impulse(field, field.start);
        action.linear -= keep * before.linear;
        action.angular -= keep * before.angular;
      }
      if (!field.gas.kept.empty()) {  // of what points keep the walls saw nothing
        for (const WallAction<dim>& kept : kept_actions(field)) {
          action.linear -= kept.linear;
          action.angular -= kept.angular;
        }
      }
      wall.linear += action.linear;
      wall.angular += action.angular;
    }
    step.book(ledger_, sums, contact_);
  }

  // What the maps' folding and extension would give to what points keep of their own velocities and of the nodes'.
  std::array<WallAction<dim>, 2> kept_actions(const Field& field) const {
    std::vector<typename Space::Vec> own(field.unfolded.momentum), nodal(field.start);
    field.for_touched(space_.grid, [&](std::size_t i) {
      own[i] *= field.gas.kept[i];
      nodal[i] *= field.gas.kept[i];
    });
    return {space_.walls.fold(field, own), space_.walls.extension_impulse(field, nodal)};
  }

  void stop_if_too_far(const MotionSums& sums, const Body& body, double dt) const {
    if (sums.too_far < 0) return;
    for (int p = sums.too_far; p < body.points.points(); ++p) {
      for (int d = 0; d < dim; ++d) {
        const double v = body.points(column::velocity, d)[p];
        if (std::abs(dt * v) <= space_.grid.h() && p + 1 < sums.too_far + lanes) continue;
        throw InadmissibleState("a point moved more than one cell in a step", body.name,
                                body.id[static_cast<std::size_t>(p)], column::velocity.name(), v);
      }
    }
  }

  const Space& space_;
  Chains<Geometry> chains_;
  MeanDilatation<Geometry> dilatation_;
  Reflection<Geometry> reflection_;
  VelocityFilter<Geometry> filter_;
  LossToGas<Geometry> loss_to_gas_;
  bool exchange_, contact_, keep_loss_, sharpened_motion_;
  Ledger& ledger_;
};

}  // namespace plumbline
