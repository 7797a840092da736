// A time integrator: one self-registering source file that composes stages. Nothing else is touched to add one.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/plugin_stamp.hpp"
#include "kernel/stages.hpp"

namespace plumbline {

// A number that users of an integrator may choose; a key of every case by its name.
struct IntegratorParameter {
  std::string name;
  double* value;  // in the integrator; what it holds when made is the default
  double low, high;
  std::string description;
};

// What a user may rely on. Each claim is optional, and `plumbline verify --integrator` judges it; none is needed to be
// judged. They speak of one linear oscillator without damping, behind no maps, unless they say otherwise.
struct OrderClaim {
  double order = 0;  // in dt
  // oscillator; or "fixed mesh": a standing wave under FLIP, the mesh held; or "h and dt": mesh and step refined together
  std::string of = "oscillator";
  std::string field = "displacement";  // or velocity; of a fixed mesh strain or velocity
};
enum class EnergyBehaviour {
  conserved,  // to rounding
  bounded,    // neither grows nor decays in the mean
  decaying    // never rises from one period to the next
};
// A gate of `plumbline verify --integrator` that is known to be missed: how it fails, and the band of the wrong value.
struct KnownFailure {
  std::string gate;  // its id: "stability/oscillator/growth"
  std::string cause;
  double low = 0, high = 0;
};
struct Claims {
  std::vector<OrderClaim> orders = {};
  std::optional<EnergyBehaviour> energy = {};
  std::optional<double> limit = {};  // of omega dt; infinite: none
  bool reversible = false;           // a step of -dt takes back a step of dt
  std::vector<KnownFailure> known_failures = {};
};

// The stages that step() calls tell what it needs of shapes and transfers, and what it offers: kernel/integrator_traits.hpp.
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

  // Those numbers: what it keeps from step to step beside memory(), such as the size of the last step. A run that is resumed
  // from a file gets memory(), these and the parameters back, and nothing else.
  virtual std::vector<double*> kept() { return {}; }

  // What it promises, with its parameters as they are.
  virtual Claims claims() const { return {}; }
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

// Of the file that includes this, one in each object that registers an integrator: hence `static`.
[[gnu::section(PLUMBLINE_STAMP_SECTION)]] static constexpr PluginStamp stamp_of_this_file = plugin_stamp(
    "integrators", PLUMBLINE_INTEGRATOR_HEADERS,
    {sizeof(std::size_t), sizeof(std::string), sizeof(State), sizeof(NodalVelocity), sizeof(Stages),
     sizeof(IntegratorParameter), sizeof(OrderClaim), sizeof(KnownFailure), sizeof(Claims), sizeof(TimeIntegrator),
     sizeof(IntegratorEntry), alignof(IntegratorEntry)});

// Registers at start, or when a plug-in is loaded. A name that is taken already or malformed, an entry without `make` or `copy`,
// or a stamp other than the kernel's throws std::logic_error, but for what is registered under collect_registrations().
struct RegisterIntegrator {
  explicit RegisterIntegrator(IntegratorEntry entry, const PluginStamp& built_against = stamp_of_this_file);
};

// Calls `load` and returns what was to be registered meanwhile, unchecked and in its order, and registers nothing: where a shared
// library is loaded, an exception would end the program. Not for several threads at once.
std::vector<IntegratorEntry> collect_registrations(const std::function<void()>& load);

// What the kernel itself was built against.
const PluginStamp& kernel_stamp();

}  // namespace plumbline

// Registers integrator class Type under a name, with a one-line title and its source.
#define PLUMBLINE_INTEGRATOR(Type, name, title, source)                                                                \
  static const ::plumbline::RegisterIntegrator register_##Type {                                                       \
    {                                                                                                                  \
      name, title, source, [] { return std::make_unique<Type>(); },                                                    \
          [](const ::plumbline::TimeIntegrator& now) { return std::make_unique<Type>(static_cast<const Type&>(now)); } \
    }                                                                                                                  \
  }
