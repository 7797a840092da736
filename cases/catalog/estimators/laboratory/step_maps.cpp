// A step as a map of one vector of numbers: which number stands for what of which point, and in which unit.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/laboratory/step_map.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

// A column that a step hands to the next, and what its numbers are divided by.
struct HandedOn {
  const ColumnId* id;
  int components;
  double unit;
};
using AllHandedOn = std::vector<HandedOn>;

// With a length of 2 m, a speed of 3 m/s and a density of 5 kg/m^3: a time of 2/3 s, a stress of 45 Pa.
constexpr Units odd_units{2, 3, 5};
constexpr double of_length = 2, of_speed = 3, of_density = 5, of_rate = 1.5, of_stress = 45, of_heat = 9, of_area = 4;

constexpr int mapped_points = 6;
constexpr double small_step = 1e-3;  // s

struct MappedBody {
  const char* name;
  std::function<std::shared_ptr<Material>()> material;
  AllHandedOn columns;  // beside places, velocities and C_p
};

// In the plane. The pressure of a gas is all of its stress.
const std::vector<MappedBody>& mapped_bodies() {
  static const std::vector<MappedBody> all{{"rubber",
                                            [] {
                                              auto law = std::make_shared<NeoHookean>();
                                              law->density = law->youngs_modulus = 1;
                                              law->poissons_ratio = 0.49;
                                              return law;
                                            },
                                            {{&column::deformation, 4, 1},
                                             {&column::volume, 1, of_area},
                                             {&column::stress, 4, of_stress},
                                             {&column::strain_rate, 4, of_rate},
                                             {&column::dilatation, 1, 1},
                                             {&column::dilatation_rate, 1, of_rate},
                                             {&column::mean_dilatation, 1, 1}}},
                                           {"gas",
                                            [] { return std::make_shared<IdealGas>(); },
                                            {{&column::density, 1, of_density},
                                             {&column::energy, 1, of_heat},
                                             {&column::volume, 1, of_area},
                                             {&column::pressure, 1, of_stress},
                                             {&column::stress, 1, of_stress},
                                             {&column::strain_rate, 1, of_rate}}},
                                           {"string",
                                            [] {
                                              auto law = std::make_shared<UniaxialMembrane>();
                                              law->density = law->youngs_modulus = 1;
                                              return law;
                                            },
                                            {{&column::strain, 1, 1},
                                             {&column::volume, 1, of_area},
                                             {&column::stress, 3, of_stress},
                                             {&column::strain_rate, 3, of_rate},
                                             {&column::tangent, 2, 1}}}};
  return all;
}

// Points in a row, numbered against the order in which they are sorted, all with one velocity.
Body row_of_points(const MappedBody& mapped, double height) {
  Body body = make_body(mapped.name, mapped.material(), mapped_points, 2);
  body.spacing = 0.5;
  Columns& points = body.points;
  for (int p = 0; p < mapped_points; ++p) {
    points(column::position, 0)[p] = 5.25 - 0.5 * p;
    points(column::position, 1)[p] = height;
    points(column::velocity, 0)[p] = 0.5;
    points(column::velocity, 1)[p] = -0.25;
    points(column::mass)[p] = points(column::volume)[p] = 0.25;
    if (points.has(column::density)) points(column::density)[p] = points(column::energy)[p] = 1;
  }
  return body;
}

Scene rows_of_points(const std::string& transfer) {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {8, 12, 1};
  scene.transfer = transfer;
  scene.mean_dilatation = true;
  for (const MappedBody& mapped : mapped_bodies()) {
    scene.bodies.push_back(row_of_points(mapped, 2.75 + 3 * static_cast<double>(scene.bodies.size())));
  }
  return scene;
}

// As StepMap calls the numbers of the column of this body.
std::string name_of_number(const std::string& body, const HandedOn& one, int component, int point) {
  return body + " " + std::to_string(point) + " " + one.id->name() + " " + std::to_string(component);
}

std::map<std::string, std::size_t> numbers_by_name(const StepMap& map) {
  std::map<std::string, std::size_t> all;
  for (std::size_t k = 0; k < map.size(); ++k) all[map.name(k)] = k;
  return all;
}

double number_of(const std::vector<double>& state, const std::map<std::string, std::size_t>& numbers,
                 const std::string& name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? NAN : state[found->second];
}

// How far what the points of a body have of a column is from their numbers in the state; 1 where either lacks it.
double off_in(const Body& body, const std::vector<double>& state, const std::map<std::string, std::size_t>& numbers,
              const HandedOn& one) {
  if (body.points.components(*one.id) != one.components) return 1;
  double off = 0;
  for (int e = 0; e < one.components; ++e) {
    for (int p = 0; p < mapped_points; ++p) {
      const int number = body.id[static_cast<std::size_t>(p)];
      const double wanted = number_of(state, numbers, name_of_number(body.name, one, e, number));
      off = larger(off, std::abs(body.points(*one.id, e)[p] / one.unit - wanted));
    }
  }
  return std::isnan(off) ? 1 : off;
}

// Each number of a state set by hand is found in its column, in its unit, at the point of its number, and read back as it was.
void add_set_state(KnownAnswers& all) {
  StepMap map(rows_of_points("apic"), odd_units, {"musl", {}}, Positions::moving, small_step);
  map.step();
  std::vector<double> state(map.size());
  for (std::size_t k = 0; k < state.size(); ++k) state[k] = 1 + static_cast<double>(k) / 1024;
  map.set_state(state);
  const std::vector<double> read = map.state();
  double off = 0;
  for (std::size_t k = 0; k < state.size(); ++k) off = larger(off, std::abs(read[k] - state[k]));
  all.push_back({"set.read", off, 0});
  const auto numbers = numbers_by_name(map);
  int count = 0;
  for (std::size_t b = 0; b < mapped_bodies().size(); ++b) {
    const MappedBody& mapped = mapped_bodies()[b];
    AllHandedOn columns{
        {&column::position, 2, of_length}, {&column::velocity, 2, of_speed}, {&column::affine, 4, of_rate}};
    columns.insert(columns.end(), mapped.columns.begin(), mapped.columns.end());
    for (const HandedOn& one : columns) {
      all.push_back(
          {std::string(mapped.name) + "." + one.id->name(), off_in(map.scene().bodies[b], state, numbers, one), 0});
      count += one.components * mapped_points;
    }
  }
  all.push_back({"set.count", static_cast<double>(map.size()), static_cast<double>(count)});
  const double points = mapped_points * static_cast<double>(mapped_bodies().size());
  double velocities = 0;
  std::array<double, 3> places{};
  for (std::size_t k = 0; k < map.size(); ++k) {
    velocities += map.is_velocity(k) ? 1 : 0;
    if (map.position_direction(k) >= 0) ++places.at(static_cast<std::size_t>(map.position_direction(k)));
  }
  all.push_back({"set.velocities", velocities, 2 * points});
  for (std::size_t d = 0; d < places.size(); ++d) all.push_back({"set.places", places[d], d < 2 ? points : 0});
}

// Gas without pressure falls, and generalized-alpha remembers its acceleration, beside rates of place and energy that it has no use
// for: in units of a speed over a time, 4.5 m/s^2.
void add_memory(KnownAnswers& all) {
  Scene falling = rows_of_points("flip");
  falling.bodies.erase(falling.bodies.begin());  // a string and a gas that nothing strains
  for (double& e : falling.bodies[0].points.values(column::energy)) e = 0;
  falling.gravity = {0.9, -0.45, 0};
  const StepMap map(falling, odd_units, {"generalized-alpha", {}}, Positions::moving, small_step);
  const auto numbers = numbers_by_name(map);
  const std::vector<double> state = map.state();
  double remembered = 0;
  for (const auto& [name, k] : numbers) remembered += name.ends_with(" (memory)") ? 1 : 0;
  all.push_back({"memory.count", remembered, 2 * 5 * mapped_points});
  for (const auto& [body, variable] : {std::pair{"gas", &column::energy}, std::pair{"string", &column::strain}}) {
    for (int p = 0; p < mapped_points; ++p) {
      const auto row = [&](const ColumnId& id, int component, double exact) {
        const std::string name = name_of_number(body, {&id, 1, 1}, component, p) + " (memory)";
        all.push_back({"memory." + id.name(), number_of(state, numbers, name), exact});
      };
      row(column::velocity, 0, 0.2);
      row(column::velocity, 1, -0.1);
      for (int d = 0; d < 2; ++d) row(column::position, d, 0);
      row(*variable, 0, 0);
    }
  }
}

// Points that are held stand where they stood whatever a step does to them, and their places are no part of the state.
void add_held(KnownAnswers& all) {
  const Scene start = rows_of_points("flip");
  StepMap held(start, odd_units, {"musl", {}}, Positions::frozen, small_step),
      free(start, odd_units, {"musl", {}}, Positions::moving, small_step);
  all.push_back({"held.count", static_cast<double>(held.size()),
                 static_cast<double>(free.size()) - 2 * 3 * static_cast<double>(mapped_points)});
  held.step();
  held.set_state(held.state());
  for (std::size_t b = 0; b < start.bodies.size(); ++b) {
    const Body& now = held.scene().bodies[b];
    for (int d = 0; d < 2; ++d) {
      for (int p = 0; p < mapped_points; ++p) {
        const int number = now.id[static_cast<std::size_t>(p)];
        all.push_back(
            {"held.place", now.points(column::position, d)[p], start.bodies[b].points(column::position, d)[number]});
      }
    }
  }
}

}  // namespace

KnownAnswers step_map_answers() {
  KnownAnswers all;
  add_set_state(all);
  add_memory(all);
  add_held(all);
  return all;
}

}  // namespace plumbline
