// A time integrator: one self-registering source file that composes stages. Nothing else is touched to add one.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kernel/stages.hpp"

namespace plumbline {

// A number that users of an integrator may choose; a key of every case by its name.
struct IntegratorParameter {
  std::string name;
  double* value;  // in the integrator; what it holds when made is the default
  double low, high;
  std::string description;
};

class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;

  // Advances the scene by dt (s, > 0).
  virtual void step(Stages& mpm, double dt) = 0;

  virtual std::vector<IntegratorParameter> parameters() { return {}; }

  // States that the integrator keeps from step to step beside the points, each of the size of Stages::state(); empty
  // before the first step. Together with the points they say how a run goes on, but for numbers that equal steps leave as
  // they are.
  virtual std::vector<State*> memory() { return {}; }

  // Why this integrator cannot work with the named shape and transfer; empty if it can.
  virtual std::string refusal(const std::string& /*shape*/, const std::string& /*transfer*/) const { return {}; }

  // Whether step() calls return_transfer_loss(): the bodies then carry a column for it.
  virtual bool returns_transfer_loss() const { return false; }

  // Whether every step() evaluates the stress before anything uses it: stresses then need not follow sorted points.
  virtual bool evaluates_stress_first() const { return false; }
};

struct IntegratorEntry {
  std::string name, title, source;
  std::function<std::unique_ptr<TimeIntegrator>()> make;
  std::function<std::unique_ptr<TimeIntegrator>(const TimeIntegrator&)> copy = {};  // one as it is now, memory included
};

// All registered integrators in the order of their names.
const std::vector<IntegratorEntry>& integrators();

// The entry of that name, nullptr if there is none.
const IntegratorEntry* find_integrator(const std::string& name);

// Gives an integrator's parameters the values chosen by name; others are left alone. Throws std::invalid_argument for a value
// out of range.
void set_parameters(TimeIntegrator& integrator, const std::map<std::string, double>& chosen);

// Registers at start, or when a plug-in is loaded. A name that is taken already, or an entry without `make` or `copy`, throws std::logic_error.
struct RegisterIntegrator {
  explicit RegisterIntegrator(IntegratorEntry entry);
};

}  // namespace plumbline

// Registers integrator class Type under a name, with a one-line title and its source.
#define PLUMBLINE_INTEGRATOR(Type, name, title, source)                                                                \
  static const ::plumbline::RegisterIntegrator register_##Type {                                                       \
    {                                                                                                                  \
      name, title, source, [] { return std::make_unique<Type>(); },                                                    \
          [](const ::plumbline::TimeIntegrator& now) { return std::make_unique<Type>(static_cast<const Type&>(now)); } \
    }                                                                                                                  \
  }
