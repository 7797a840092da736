// A step of any time integrator on any scene, as a map of one vector of numbers to another.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cases/harness/laboratory/patch.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/points/column_names.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// Whether points stay where they are between steps: then positions are no part of the state.
enum class Positions { frozen, moving };

// Which integrator, and the values of its parameters by name.
struct IntegratorChoice {
  std::string name;
  std::map<std::string, double> parameters = {};
};

// The state is everything that one step hands to the next: columns of the points, and what the integrator remembers. All
// in the units given; points by their numbers, whatever order the engine keeps them in.
class StepMap {
 public:
  // One number of the state.
  struct Entry {
    std::size_t body = 0;
    int point = 0;  // by number
    int slot = 0;   // which column and component, or which part of the memory
  };

  // The integrator takes a first step of dt (s, > 0) from the scene as it is, so that it remembers what it would in a run of
  // equal steps; the state is then the scene's again. Throws as Simulation does, and InadmissibleState.
  StepMap(Scene scene, const Units& units, const IntegratorChoice& integrator, Positions positions, double dt);

  std::size_t size() const { return entries_.size(); }
  const Entry& entry(std::size_t k) const { return entries_[k]; }
  // Whether the entry is a velocity; a position (along which direction), -1 if it is none.
  bool is_velocity(std::size_t k) const;
  int position_direction(std::size_t k) const;
  std::string name(std::size_t k) const;

  std::vector<double> state() const;
  void set_state(const std::vector<double>& state);
  // One step of the dt given at the start. Throws InadmissibleState.
  void step();

  const Scene& scene() const { return *scene_; }

 private:
  struct Slot {
    std::size_t body;
    ColumnId column;
    int component;
    double unit;
    int memory = -1;         // which state of the memory; -1: a column
    std::size_t offset = 0;  // of a memory, where the values of its points begin
  };

  void add_slots();
  void add_memory_slots();
  void add_slot(Slot slot);
  double unit_of(const ColumnId& column) const;
  void remember_order() const;
  double* values(const Slot& slot) const;

  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Ledger> ledger_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::unique_ptr<Engine> engine_;
  Units units_;
  Positions positions_;
  double dt_;
  std::vector<Slot> slots_;
  std::vector<Entry> entries_;
  std::vector<Columns> resting_;                 // the points as the scene has them, in the order of their numbers
  mutable std::vector<std::vector<int>> place_;  // where the point of each number stands now, of each body
};

}  // namespace plumbline
