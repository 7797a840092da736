#include "cases/harness/laboratory/step_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/harness/files/signals.hpp"
#include "kernel/engine/stage_queue.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/materials/shared_dilatation.hpp"

namespace plumbline {
namespace {

// What a step may hand to the next. Masses and the sizes at rest never change; boxes and body forces are found anew in
// every step, from what stands here. Tangents are those of the last step where that evaluated its stress last.
const std::vector<ColumnId>& carried_columns() {
  static const std::vector<ColumnId> all{
      column::position,    column::velocity, column::affine,     column::strain,          column::deformation,
      column::density,     column::energy,   column::volume,     column::pressure,        column::stress,
      column::strain_rate, column::tangent,  column::dilatation, column::dilatation_rate, column::mean_dilatation};
  return all;
}

}  // namespace

StepMap::StepMap(Scene scene, const Units& units, const IntegratorChoice& integrator, Positions positions, double dt)
    : scene_(std::make_unique<Scene>(std::move(scene))),
      ledger_(std::make_unique<Ledger>()),
      units_(units),
      positions_(positions),
      dt_(dt) {
  const IntegratorEntry* entry = find_integrator(integrator.name);
  if (!entry) throw std::invalid_argument("no integrator " + integrator.name);
  integrator_ = entry->make();
  if (auto missing = lacks(*entry, *scene_); !missing.empty()) throw CannotWork(std::move(missing));
  set_parameters(*integrator_, integrator.parameters);
  engine_ = make_engine(*scene_, *ledger_, engine_options(*entry));
  engine_->initialise();
  ledger_->open(engine_->totals());
  add_slots();
  const std::vector<double> start = state();
  take_step(*integrator_, *engine_, dt_);
  add_memory_slots();
  // What the step left in stresses and volumes is what steps of this integrator leave there; positions and velocities, and
  // what advances with them, are the scene's again.
  std::vector<double> now = state();
  for (std::size_t k = 0; k < start.size(); ++k) {
    const std::string& name = slots_[static_cast<std::size_t>(entries_[k].slot)].column.name();
    const bool derived = name == column::stress.name() || name == column::strain_rate.name() ||
                         name == column::volume.name() || name == column::pressure.name();
    if (!derived) now[k] = start[k];
  }
  set_state(now);
}

double StepMap::unit_of(const ColumnId& column) const {
  const std::string& unit = column.unit();
  if (unit == "m") return units_.length;
  if (unit == "m/s") return units_.speed;
  if (unit == "1/s") return 1 / units_.time();
  if (unit == "Pa") return units_.density * units_.speed * units_.speed;
  if (unit == "J/kg") return units_.speed * units_.speed;
  if (unit == "kg/m^3") return units_.density;
  if (unit == "m^3") return std::pow(units_.length, scene_->grid.dim);
  return 1;
}

void StepMap::add_slot(Slot slot) {
  const int points = scene_->bodies[slot.body].points.points();
  for (int p = 0; p < points; ++p) entries_.push_back({slot.body, p, static_cast<int>(slots_.size())});
  slots_.push_back(std::move(slot));
}

void StepMap::add_slots() {
  for (std::size_t b = 0; b < scene_->bodies.size(); ++b) {
    const Body& body = scene_->bodies[b];
    resting_.push_back(body.points);
    std::vector<int> order(body.id.size());
    for (std::size_t p = 0; p < body.id.size(); ++p) order[static_cast<std::size_t>(body.id[p])] = static_cast<int>(p);
    resting_.back().reorder(order);
    place_.emplace_back(body.id.size());
    for (const ColumnId& column : carried_columns()) {
      if (column.name() == column::position.name() && positions_ == Positions::frozen) continue;
      for (int k = 0; k < body.points.components(column); ++k) add_slot({b, column, k, unit_of(column)});
    }
  }
}

// A state of the integrator's memory holds, body by body, positions, velocities and the internal variables of the points.
void StepMap::add_memory_slots() {
  const MaterialContext context{scene_->grid.dim,
                                scene_->grid.h,
                                scene_->density == DensityMethod::continuity,
                                0,
                                scene_->density == DensityMethod::grid,
                                false};
  const std::vector<State*> memory = integrator_->memory();
  for (std::size_t m = 0; m < memory.size(); ++m) {
    std::size_t offset = 0;
    for (std::size_t b = 0; b < scene_->bodies.size(); ++b) {
      const Columns& points = scene_->bodies[b].points;
      std::vector<ColumnId> columns{column::position, column::velocity};
      for (const ColumnId* id : scene_->bodies[b].material->internal_variables(context)) columns.push_back(*id);
      if (points.has(column::dilatation)) columns.push_back(column::dilatation);
      for (const ColumnId& column : columns) {
        for (int k = 0; k < points.components(column); ++k) {
          add_slot({b, column, k, unit_of(column) / units_.time(), static_cast<int>(m), offset});
          offset += static_cast<std::size_t>(points.points());
        }
      }
    }
    if (offset != memory[m]->values.size()) {
      throw std::logic_error("a state in the integrator's memory has " + std::to_string(memory[m]->values.size()) +
                             " numbers; that of the points has " + std::to_string(offset));
    }
  }
}

bool StepMap::is_velocity(std::size_t k) const {
  const Slot& slot = slots_[static_cast<std::size_t>(entries_[k].slot)];
  return slot.memory < 0 && slot.column.index() == column::velocity.index();
}

int StepMap::position_direction(std::size_t k) const {
  const Slot& slot = slots_[static_cast<std::size_t>(entries_[k].slot)];
  return slot.memory < 0 && slot.column.index() == column::position.index() ? slot.component : -1;
}

std::string StepMap::name(std::size_t k) const {
  const Entry& entry = entries_[k];
  const Slot& slot = slots_[static_cast<std::size_t>(entry.slot)];
  return scene_->bodies[entry.body].name + " " + std::to_string(entry.point) + " " + slot.column.name() + " " +
         std::to_string(slot.component) + (slot.memory < 0 ? "" : " (memory)");
}

double* StepMap::values(const Slot& slot) const {
  if (slot.memory >= 0) {
    return integrator_->memory()[static_cast<std::size_t>(slot.memory)]->values.data() + slot.offset;
  }
  return scene_->bodies[slot.body].points(slot.column, slot.component);
}

void StepMap::remember_order() const {
  for (std::size_t b = 0; b < place_.size(); ++b) {
    const std::vector<int>& id = scene_->bodies[b].id;
    for (std::size_t p = 0; p < id.size(); ++p) place_[b][static_cast<std::size_t>(id[p])] = static_cast<int>(p);
  }
}

std::vector<double> StepMap::state() const {
  remember_order();
  std::vector<double> state;
  state.reserve(entries_.size());
  for (const Slot& slot : slots_) {
    const double* from = values(slot);
    for (const int p : place_[slot.body]) state.push_back(from[p] / slot.unit);
  }
  return state;
}

void StepMap::set_state(const std::vector<double>& state) {
  remember_order();
  auto next = state.begin();
  for (const Slot& slot : slots_) {
    double* to = values(slot);
    for (const int p : place_[slot.body]) to[p] = *next++ * slot.unit;
  }
  for (std::size_t b = 0; positions_ == Positions::frozen && b < place_.size(); ++b) {
    for (int d = 0; d < scene_->grid.dim; ++d) {
      double* to = scene_->bodies[b].points(column::position, d);
      const double* from = resting_[b](column::position, d);
      for (std::size_t id = 0; id < place_[b].size(); ++id) to[place_[b][id]] = from[id];
    }
  }
  engine_->points_changed(0);
}

void StepMap::step() {
  throw_if_interrupted();
  engine_->set_time(0);
  take_step(*integrator_, *engine_, dt_);
}

}  // namespace plumbline
