#include "cases/harness/description/schemes.hpp"

#include <limits>

#include "cases/harness/files/errors.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/normals/normals.hpp"
#include "kernel/scene.hpp"

namespace plumbline {
namespace {

std::vector<std::string> names(const std::vector<Choice>& choices) {
  std::vector<std::string> all;
  for (const Choice& choice : choices) all.push_back(choice.name);
  return all;
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> all;
  for (const IntegratorEntry& entry : integrators()) all.push_back(entry.name);
  return all;
}

// What registered integrators let their users choose. An integrator that is not chosen has no use for its keys.
void add_integrator_keys(std::vector<Key>& keys) {
  for (const IntegratorEntry& entry : integrators()) {
    const auto integrator = entry.make();
    for (const IntegratorParameter& parameter : integrator->parameters()) {
      keys.push_back({.name = parameter.name,
                      .value = *parameter.value,
                      .low = parameter.low,
                      .high = parameter.high,
                      .description = parameter.description});
    }
  }
}

constexpr double infinite = std::numeric_limits<double>::infinity();

Key number(std::string name, double value, std::string unit, double low, double high, bool open,
           std::string description) {
  return {.name = std::move(name),
          .value = value,
          .unit = std::move(unit),
          .low = low,
          .high = high,
          .low_open = open,
          .description = std::move(description)};
}

Key choice(std::string name, std::string value, std::vector<std::string> choices, std::string description) {
  return {.name = std::move(name),
          .value = std::move(value),
          .choices = std::move(choices),
          .description = std::move(description)};
}

}  // namespace

std::string name(Kind kind) {
  switch (kind) {
    case Kind::gas:
      return "gas";
    case Kind::membrane:
      return "membrane";
    case Kind::solid:
      return "solid";
    default:
      return "coupled";
  }
}

std::vector<std::string> scheme_names() { return {"default", "york1997"}; }

std::string scheme_title(const std::string& scheme) {
  return scheme == "york1997"
             ? "York's own choices throughout: linear, FLIP, MUSL, his density, viscosity, step and points"
             : "the project's best, one definition per kind of scene";
}

std::string scheme_source(const std::string& scheme) {
  return scheme == "york1997" ? "York 1997, SAND97-1893" : "kernel/README.md";
}

namespace {

void add_gas_keys(Kind kind, std::vector<Key>& keys) {
  if (kind == Kind::gas) {
    keys.push_back({.name = "offset",
                    .value = 0.0,
                    .low = 0,
                    .high = 1,
                    .high_open = true,
                    .description = "shift of the grid in cells"});
  }
  keys.push_back(choice("density", "grid", names(densities()), "how points get their density"));
  keys.push_back(choice("points", "equal-mass", {"equal-mass", "equal-volume"}, "what all points have alike"));
  keys.push_back(number("sharpening", 1.0, "1", 0, 1, false,
                        "how much of the maps' smoothing of forces and strain rates is undone on the nodes"));
  keys.push_back(number("heat_exchange", 1.0, "1", 0, infinite, false,
                        "kappa: how fast points of a gas under compression share their heat"));
  if (kind == Kind::gas) {
    keys.push_back(number("split", 1.3, "1", 0, infinite, false,
                          "points that have grown to more cells than this are split in two, 0.1 at least; 0: none"));
  }
  keys.push_back(number("viscosity.linear", 0.0, "1", 0, infinite, false, "c_L of the artificial viscosity"));
  keys.push_back(number("viscosity.quadratic", 0.5, "1", 0, infinite, false, "c_Q of the artificial viscosity"));
}

void add_coupling_keys(std::vector<Key>& keys) {
  keys.push_back({.name = "membrane.ppc",
                  .value = 4.0,
                  .low = 1,
                  .high = 1e3,
                  .description = "points per cell along the membrane"});
  keys.push_back(
      {.name = "membrane.strain",
       .value = std::monostate{},
       .choices = {"accumulated", "segments"},
       .description = "the stretch of the segments between points, which is what follows if not set, or summed "
                      "from rates at the points, which is what follows from normals without connectivity"});
  keys.push_back(
      choice("membrane.loss", "gas", {"booked", "gas"},
             "what maps and strains take from membranes heats the gas at their nodes, or is booked as lost"));
  keys.push_back(number("membrane.relaxation", 0.5, "1", 0, 1, false,
                        "theta: how much of what no node sees of the segments' motion is taken out each step"));
  keys.push_back(number("membrane.smoothing", 0.01, "1", 0, infinite, false,
                        "kappa: how fast what no node sees of accumulated strains is taken out"));
  keys.push_back(choice("normals", "connectivity", names(normals_methods()),
                        "how membranes with accumulated strain know their tangents"));
}

}  // namespace

// Gas: the energy-conserving leapfrog. Membrane: symplectic stress update, because a stress evaluated at the start of the
// step and strained with the midpoint velocity amplifies an elastic oscillation by 1 + (omega dt)^2 / 4 a step. Solid: the
// midpoint step, which raises no energy even in contact, on shapes whose boxes deform with the points. Coupled: the gas's
// step, which neither damps nor amplifies membranes below omega dt = 2, and gives what they lose to the gas.
std::vector<Key> kind_keys(Kind kind) {
  const bool gas = kind == Kind::gas || kind == Kind::coupled, solid = kind == Kind::solid;
  std::vector<Key> keys{
      {.name = "cells",
       .value = 100.0,
       .low = 2,
       .high = 1e6,
       .integer = true,
       .description = "cells along the case's reference length"},
      choice("shape",
             gas     ? "cubic"
             : solid ? "contiguous-gimp"
                     : "quadratic",
             names(shapes()), "shape functions"),
      choice("transfer", "apic", names(transfers()), "what goes back and forth between points and grid"),
      {.name = "transfer_order",
       .value = 2.0,
       .low = 1,
       .high = 100,
       .integer = true,
       .description = "m of the transfers xpic and fmpm"},
      choice("integrator",
             gas     ? "leapfrog"
             : solid ? "midpoint"
                     : "musl",
             integrator_names(), "time integrator"),
      {.name = "cfl",
       .value = kind == Kind::coupled ? 0.9 : 0.5,
       .low = 0,
       .high = infinite,
       .low_open = true,
       .optional = true,
       .description =
           "dt = cfl min_p h / (c_p + |v_p|), below the viscous limit too; auto: what the laboratory finds safe",
       .words = {"auto"}},
      {.name = "dt",
       .value = std::monostate{},
       .unit = "s",
       .low = 0,
       .low_open = true,
       .optional = true,
       .description = "fixed step; overrides cfl"},
      {.name = "ppc",
       .value = gas     ? 8.0
                : solid ? 2.0
                        : 4.0,
       .low = 1,
       .high = 1e4,
       .integer = true,
       .description = kind == Kind::gas ? "points per cell, in the densest gas where points have equal mass"
                      : gas             ? "points per cell of the gas"
                      : solid           ? "points per cell and direction"
                                        : "points per cell along the membrane"}};
  if (solid || kind == Kind::coupled) {
    keys.push_back(choice("contact", "default", {"none", "york-9.7", "york-9.8", "york-9.9", "default"},
                          "between bodies: none (one velocity for all), York's criteria, or where points touch"));
  }
  if (gas) add_gas_keys(kind, keys);
  if (kind == Kind::coupled) add_coupling_keys(keys);
  add_integrator_keys(keys);
  return keys;
}

std::map<std::string, double> integrator_parameters(const Settings& settings) {
  std::map<std::string, double> chosen;
  const IntegratorEntry* entry = find_integrator(settings.text("integrator"));
  const auto integrator = entry ? entry->make() : nullptr;
  if (!integrator) return chosen;
  for (const IntegratorParameter& parameter : integrator->parameters()) {
    if (settings.has(parameter.name)) chosen[parameter.name] = settings.number(parameter.name);
  }
  return chosen;
}

void apply_choices(const Settings& settings, Scene& scene) {
  scene.shape = settings.text("shape");
  scene.transfer = settings.text("transfer");
  scene.transfer_order = settings.integer("transfer_order");
  const bool coupled = settings.has("membrane.loss");
  if (settings.has("contact")) {
    const std::string& contact = settings.text("contact");
    scene.contact = contact == "default" ? "touching" : contact;
    for (Body& body : scene.bodies) {
      if (contact == "none") body.field = "common";
      if (contact != "none" && !coupled) body.field = body.name;
    }
  }
  if (!coupled) return;
  scene.density = density_method(settings.text("density"));
  scene.sharpening = settings.number("sharpening");
  scene.heat_exchange = settings.number("heat_exchange");
  scene.loss_to_gas = settings.text("membrane.loss") == "gas";
  scene.chain_relaxation = settings.number("membrane.relaxation");
  scene.strain_smoothing = settings.number("membrane.smoothing");
  scene.normals = settings.text("normals");
}

void refuse_lacks(const IntegratorEntry& integrator, const Settings& settings) {
  const std::string &shape = settings.text("shape"), &transfer = settings.text("transfer");
  const std::vector<Lack> missing = lacks(integrator, shape, transfer);
  if (missing.empty()) return;
  throw MissingTraits("integrator", integrator.name, "another integrator, shape or transfer",
                      "shape=" + shape + ", transfer=" + transfer, missing);
}

std::vector<Override> scheme_choices(const std::string& scheme, Kind kind) {
  if (scheme != "york1997") return {};
  std::vector<Override> york{{"shape", "linear"},
                             {"transfer", "flip"},
                             {"integrator", "musl"},
                             {"cfl", std::monostate{}}};  // the case derives his fixed step
  if (kind == Kind::solid) york.push_back({"contact", "york-9.7"});
  if (kind == Kind::gas || kind == Kind::coupled) {
    york.insert(york.end(), {{"density", "quadratic"},
                             {"points", "equal-volume"},
                             {"sharpening", 0.0},
                             {"heat_exchange", 0.0},
                             {"viscosity.linear", kind == Kind::gas ? 1.0 : 0.0},
                             {"viscosity.quadratic", kind == Kind::gas ? 1.0 : 0.0}});
  }
  if (kind == Kind::gas) york.push_back({"split", 0.0});
  if (kind == Kind::coupled) {
    york.insert(york.end(), {{"contact", "none"},
                             {"membrane.strain", "accumulated"},
                             {"membrane.loss", "booked"},
                             {"membrane.relaxation", 0.0},
                             {"membrane.smoothing", 0.0}});
  }
  return york;
}

}  // namespace plumbline
