#include "cases/harness/description/schemes.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "cases/harness/files/errors.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/normals/normals.hpp"
#include "kernel/scene.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

template <class Entry>
std::vector<std::string> names(const std::vector<Entry>& choices) {
  std::vector<std::string> all;
  for (const Choice& choice : choices) all.push_back(choice.name);
  return all;
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> all;
  for (const IntegratorEntry& entry : integrators()) all.push_back(entry.name);
  return all;
}

// The law where points touch is called "default" in cases.
std::vector<std::string> contact_names() {
  std::vector<std::string> all = names(contacts());
  std::replace(all.begin(), all.end(), std::string("touching"), std::string("default"));
  return all;
}

// Of all registered integrators. One that is not chosen has no use for its keys.
void add_integrator_keys(std::vector<Key>& keys) {
  for (const IntegratorEntry& entry : integrators()) {
    for (Key& key : integrator_keys(entry)) keys.push_back(std::move(key));
  }
}

constexpr double infinite = std::numeric_limits<double>::infinity();

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
  return scheme == "york1997" ? "York 1997, SAND97-1893" : "reports/docs/theory";
}

namespace {

Key choice(std::string name, std::vector<std::string> choices, std::string description) {
  return {.name = std::move(name), .choices = std::move(choices), .description = std::move(description)};
}

Key number(std::string name, std::string description, double high = infinite) {
  return {.name = std::move(name), .low = 0, .high = high, .description = std::move(description)};
}

Key count(std::string name, std::string description, double low, double high) {
  return {.name = std::move(name), .low = low, .high = high, .integer = true, .description = std::move(description)};
}

// What the keys mean; their values are in the table below.
std::vector<Key> described_keys() {
  std::vector<Key> keys{
      count("cells", "cells along the case's reference length", 2, 1e6),
      choice("shape", names(shapes()), "shape functions"),
      choice("transfer", names(transfers()), "what goes back and forth between points and grid"),
      count("transfer_order", "m of the transfers xpic and fmpm", 1, 100),
      choice("integrator", integrator_names(), "time integrator"),
      number("cfl",
             "dt = cfl min_p h / (c_p + |v_p|), below the viscous limit too; auto: what the laboratory finds safe"),
      number("dt", "fixed step; overrides cfl"),
      count("ppc",
            "points per cell: of a gas (where points have equal mass, in the densest), of solids in each direction, of "
            "membranes along them",
            1, 1e4),
      choice("contact", contact_names(),
             "between bodies: none (one velocity for all), York's criteria, or where points touch (default)"),
      number("offset", "shift of the grid in cells", 1),
      choice("density", names(densities()), "how points get their density"),
      choice("dilatation", {"point", "cell"},
             "how solids with nu > 1/3 bear pressure: each point by its own dilatation, or by one shared in its cell"),
      choice("points", {"equal-mass", "equal-volume"}, "what all points have alike"),
      number("sharpening", "how much of the maps' smoothing of forces and strain rates is undone on the nodes", 1),
      number("sharpening.second", "s_2: and of its square along each axis"),
      number("sharpening.third", "s_3: and of its cube"),
      number("sharpening.expansion",
             "how much of all that stays where a gas of uneven density expands and its flow is not linear", 1),
      choice("motion", {"own", "sharpened"},
             "what points move with: their own velocity, or with it what sharpening adds to the one that strains them"),
      choice("read_off", {"mapped", "sharpened"},
             "the nodal densities that points read off: as mapped, or with the maps' smoothing undone where that is "
             "monotone"),
      choice("pressure_at", {"points", "nodes"},
             "where pressures of gases act: at points, by gradients of their shape functions, or at nodes, by "
             "differences; in rings and with physical viscosity at points"),
      number("quadrature",
             "eps: sums over points of pressures of gases that differ by less than this share over three cells are "
             "corrected to integrals, in the plane and in space, with B-splines and density=grid; 0: none",
             1),
      number("filter.sound",
             "k_f: maps take what nodes do not carry at k_f times the speed of sound over the cell size"),
      number("filter.compression",
             "b_f: and at b_f times the rate of compression; both 0: all of it in each step, however short"),
      number(
          "heat_exchange",
          "kappa: how fast points of a gas under compression share heat that stands out; a quarter as fast elsewhere"),
      choice("viscosity.closing", {"divergence", "limited"},
             "what the artificial viscosity acts on: compression, or what of it is not linear in the flow"),
      number("split", "points that have grown to more cells than this are split in two, 0.1 at least; 0: none"),
      number("viscosity.linear", "c_L of the artificial viscosity"),
      number("viscosity.quadratic", "c_Q of the artificial viscosity"),
      number("membrane.ppc", "points per cell along the membrane", 1e3),
      choice(
          "membrane.strain", {"accumulated", "segments"},
          "the stretch of the segments between points, which is what follows if not set, or summed from rates at the "
          "points, which is what follows from normals without connectivity"),
      choice("membrane.loss", {"booked", "gas"},
             "what maps and strains take from membranes heats the gas at their nodes, or is booked as lost"),
      number("membrane.relaxation",
             "theta: how much of the segments' null-space modes of motion is taken out each step", 1),
      number("membrane.smoothing", "kappa: how fast null-space modes of accumulated strains are taken out"),
      choice("normals", names(normals_methods()), "how membranes with accumulated strain know their tangents")};
  const auto key = [&](const char* name) -> Key& {
    return *std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
  };
  key("cfl").low_open = key("cfl").optional = key("dt").low_open = key("dt").optional = true;
  key("cfl").words = {"auto"};
  key("dt").unit = "s";
  key("offset").high_open = true;
  key("membrane.ppc").low = 1;
  return keys;
}

// Values by `default` and in `york1997`. Scenes of a kind without them have no such key.
struct Values {
  std::optional<Value> by_default = {}, york = {};
};
struct Row {
  const char* key;
  Values gas, membrane, solid, coupled;

  const Values& of(Kind kind) const {
    const Values* const by_kind[] = {&gas, &membrane, &solid, &coupled};
    return *by_kind[static_cast<std::size_t>(kind)];
  }
};

// Gas, membrane and both together: the energy-conserving leapfrog, centred in time, which neither damps nor amplifies an elastic
// oscillation below omega dt = 2; coupled, it gives what membranes lose to the gas. Solid: the midpoint step, which raises no energy
// even in contact, on shapes whose boxes deform with the points. York's steps are fixed, and follow from the case.
const std::vector<Row>& schemes_table() {
  static const Value none;
  // clang-format off
  static const std::vector<Row> rows{
      // key                    gas                       membrane                 solid                          coupled
      {"cells",               {100.0, 100.0},           {100.0, 100.0},          {100.0, 100.0},                {100.0, 100.0}},
      {"shape",               {"cubic", "linear"},      {"quadratic", "linear"}, {"contiguous-gimp", "linear"}, {"cubic", "linear"}},
      {"transfer",            {"apic", "flip"},         {"apic", "flip"},        {"apic", "flip"},              {"apic", "flip"}},
      {"transfer_order",      {2.0, 2.0},               {2.0, 2.0},              {2.0, 2.0},                    {2.0, 2.0}},
      {"integrator",          {"leapfrog", "musl"},     {"leapfrog", "musl"},    {"midpoint", "musl"},          {"leapfrog", "musl"}},
      {"cfl",                 {0.5, none},              {0.5, none},             {0.5, none},                   {0.9, none}},
      {"dt",                  {none, none},             {none, none},            {none, none},                  {none, none}},
      {"ppc",                 {8.0, 8.0},               {4.0, 4.0},              {2.0, 2.0},                    {8.0, 8.0}},
      {"contact",             {},                       {},                      {"default", "york-9.7"},       {"default", "none"}},
      {"offset",              {0.0, 0.0},               {},                      {},                            {}},
      {"density",             {"grid", "quadratic"},    {},                      {},                            {"grid", "quadratic"}},
      {"dilatation",          {},                       {},                      {"cell", "point"},             {}},
      {"points",              {"equal-mass", "equal-volume"}, {},                {},                            {"equal-mass", "equal-volume"}},
      {"sharpening",          {1.0, 0.0},               {},                      {},                            {1.0, 0.0}},
      {"sharpening.second",   {1.0, 0.0},               {},                      {},                            {0.0, 0.0}},
      {"sharpening.third",    {0.0, 0.0},               {},                      {},                            {0.0, 0.0}},
      {"sharpening.expansion", {0.5, 1.0},              {},                      {},                            {1.0, 1.0}},
      {"motion",              {"sharpened", "own"},     {},                      {},                            {"sharpened", "own"}},
      {"read_off",            {"sharpened", "mapped"},  {},                      {},                            {"sharpened", "mapped"}},
      {"pressure_at",         {"points", "points"},     {},                      {},                            {}},
      {"quadrature",          {0.1, 0.0},               {},                      {},                            {}},
      {"filter.sound",        {2.0, 0.0},               {},                      {},                            {2.0, 0.0}},
      {"filter.compression",  {4.0, 0.0},               {},                      {},                            {4.0, 0.0}},
      {"heat_exchange",       {4.0, 0.0},               {},                      {},                            {4.0, 0.0}},
      {"split",               {1.3, 0.0},               {},                      {},                            {}},
      {"viscosity.closing",   {"limited", "divergence"}, {},                     {},                            {"limited", "divergence"}},
      {"viscosity.linear",    {0.0, 1.0},               {},                      {},                            {0.0, 0.0}},
      {"viscosity.quadratic", {0.25, 1.0},              {},                      {},                            {0.25, 0.0}},
      {"membrane.ppc",        {},                       {},                      {},                            {4.0, 4.0}},
      {"membrane.strain",     {},                       {},                      {},                            {none, "accumulated"}},
      {"membrane.loss",       {},                       {},                      {},                            {"gas", "booked"}},
      {"membrane.relaxation", {},                       {},                      {},                            {0.5, 0.0}},
      {"membrane.smoothing",  {},                       {},                      {},                            {0.01, 0.0}},
      {"normals",             {},                       {},                      {},                            {"connectivity", "connectivity"}},
  };
  // clang-format on
  return rows;
}

}  // namespace

std::vector<Key> kind_keys(Kind kind) {
  std::vector<Key> keys;
  for (Key& key : described_keys()) {
    const auto row = std::find_if(schemes_table().begin(), schemes_table().end(),
                                  [&](const Row& r) { return r.key == key.name; });
    if (row == schemes_table().end()) throw std::logic_error("no scheme has a value of " + key.name);
    if (!row->of(kind).by_default) continue;
    keys.push_back(std::move(key));
    keys.back().value = *row->of(kind).by_default;
  }
  add_integrator_keys(keys);
  return keys;
}

std::vector<Key> integrator_keys(const IntegratorEntry& entry) {
  std::vector<Key> keys;
  const auto integrator = entry.make();
  for (const IntegratorParameter& parameter : integrator->parameters()) {
    keys.push_back({.name = parameter.name,
                    .value = *parameter.value,
                    .low = parameter.low,
                    .high = parameter.high,
                    .description = parameter.description});
  }
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
  const bool gas = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                               [](const Body& body) { return body.material->has_density(); });
  if (coupled || (gas && settings.has("density"))) {
    scene.density = density_method(settings.text("density"));
    scene.sharpening = settings.number("sharpening");
    scene.sharpening_second = settings.number("sharpening.second");
    scene.sharpening_third = settings.number("sharpening.third");
    scene.sharpening_in_expansion = settings.number("sharpening.expansion");
    scene.sharpened_motion = settings.text("motion") == "sharpened";
    scene.sharpened_density = settings.text("read_off") == "sharpened";
    scene.filter = {settings.number("filter.sound"), settings.number("filter.compression")};
    scene.heat_exchange = settings.number("heat_exchange");
    if (!coupled) scene.quadrature = settings.number("quadrature");
    scene.nodal_pressure = !coupled && settings.text("pressure_at") == "nodes";
  }
  if (settings.has("dilatation")) scene.mean_dilatation = settings.text("dilatation") == "cell";
  if (gas && settings.has("split")) scene.split = settings.number("split");
  if (!coupled) return;
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

std::vector<Override> scheme_values(const std::string& scheme, Kind kind) {
  std::vector<Override> all;
  for (const Row& row : schemes_table()) {
    const auto& value = scheme == "york1997" ? row.of(kind).york : row.of(kind).by_default;
    if (value) all.emplace_back(row.key, *value);
  }
  return all;
}

std::vector<Override> scheme_choices(const std::string& scheme, Kind kind) {
  std::vector<Override> all = scheme_values(scheme, kind);
  const std::vector<Override> by_default = scheme_values("default", kind);
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const Override& choice) {
                             return std::find(by_default.begin(), by_default.end(), choice) != by_default.end();
                           }),
            all.end());
  return all;
}

}  // namespace plumbline
