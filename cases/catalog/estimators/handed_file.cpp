#include "cases/catalog/estimators/handed_file.hpp"

#include <cmath>
#include <functional>

#include "cases/harness/exchange/result_file.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {

void HandedFile::write(const std::string& path) const {
  Hdf5Writer file(path);
  for (const auto& [name, text] : texts) file.attribute("/", name, text);
  for (const auto& [name, number] : numbers) file.real_attribute("/", name, number);
  for (const auto& [name, table] : tables) file.array<double>("/bodies/" + name, table.values, table.columns);
  file.commit();
}

Scene scene_of_handed(const std::string& name, const std::shared_ptr<const Material>& material, int dim, bool rings) {
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.axisymmetric = rings;
  scene.grid.h = 0.5;
  scene.grid.origin = {1, -1, 0};
  scene.grid.cells = {4, dim > 1 ? 6 : 1, dim > 2 ? 8 : 1};
  scene.bodies.push_back(make_body(name, material, 2, dim, rings));
  return scene;
}

HandedFile gas_file() {
  HandedFile file;
  file.tables = {{"gas/position", {2, {0.5, 2.5, 3.5, -1.5}}},
                 {"gas/velocity", {2, {1, 2, 3, 4}}},
                 {"gas/mass", {0, {0.5, 3}}},
                 {"gas/density", {0, {2, 4}}},
                 {"gas/energy", {1, {10, 0}}}};
  return file;
}

Scene scene_of_gas() {
  auto law = std::make_shared<IdealGas>();
  law->gamma = 1.5;
  return scene_of_handed("gas", law, 2, false);
}

namespace {

// Of files that differ from the gas's in one thing.
class RefusedStates {
 public:
  explicit RefusedStates(KnownAnswers& all) : all_(all) {}
  void changed(const std::string& name, const std::function<void(HandedFile&)>& change, bool refused = true) {
    HandedFile file = gas_file();
    change(file);
    file.write(folder_ / "changed.h5");
    const bool found = refuses([&] { ResultFile(folder_ / "changed.h5").points(scene_of_gas()); });
    all_.push_back({"refused." + name, found ? 1.0 : 0.0, refused ? 1.0 : 0.0});
  }
  void number(const std::string& name, const std::string& of, double value, bool refused = true) {
    changed(
        name, [&](HandedFile& file) { file.numbers[of] = value; }, refused);
  }
  void table(const std::string& name, const std::string& of, const HandedTable& table, bool refused = true) {
    changed(
        name, [&](HandedFile& file) { file.tables["gas/" + of] = table; }, refused);
  }

 private:
  TrialFolder folder_;
  KnownAnswers& all_;
};

void add_refused_attributes(RefusedStates& states) {
  for (const char* name : {"kind", "case", "start"}) {
    states.changed(std::string("no_") + name, [&](HandedFile& file) { file.texts.erase(name); });
  }
  for (const char* name : {"exchange_format", "time", "cells"}) {
    states.changed(std::string("no_") + name, [&](HandedFile& file) { file.numbers.erase(name); });
  }
  states.changed("start", [](HandedFile& file) { file.texts["kind"] = "initial-state"; });
  states.number("format", "exchange_format", 2);
  states.number("no_cells", "cells", 0);
  states.number("one_cell", "cells", 1, false);
  states.number("half_a_cell", "cells", 20.5);
  states.number("most_cells", "cells", 1e9, false);
  states.number("too_many_cells", "cells", 1e9 + 1);
  states.number("fewer_steps_than_none", "steps", -1);
  states.number("endless", "wall_s", HUGE_VAL);
}

void add_refused_datasets(RefusedStates& states) {
  states.changed("no_body", [](HandedFile& file) { file.tables = {{"other/mass", {0, {1, 1}}}}; });
  states.changed("another_body", [](HandedFile& file) { file.tables["other/mass"] = {0, {1, 1}}; });
  for (const char* name : {"position", "velocity", "mass", "density", "energy"}) {
    states.changed(std::string("no_") + name, [&](HandedFile& file) { file.tables.erase(std::string("gas/") + name); });
  }
  states.table("no_rows", "position", {2, {}});
  states.table("flat_vector", "velocity", {0, {1, 2}});
  states.table("more_rows", "velocity", {2, {1, 2, 3, 4, 5, 6}});
  states.table("longer_list", "mass", {0, {1, 2, 3}});
  states.table("wide_list", "mass", {2, {1, 2, 3, 4}});
  states.table("no_number", "velocity", {2, {1, NAN, 3, 4}});
  states.table("without_mass", "mass", {0, {1, 0}});
  states.table("cold", "energy", {0, {0, 0}}, false);
  states.table("colder", "energy", {0, {0, -1}});
  states.table("backwards", "velocity", {2, {-1, -2, -3, -4}}, false);
  constexpr double low[] = {0.5, -1.5}, high[] = {3.5, 2.5}, little = 1e-3;
  for (std::size_t d = 0; d < 2; ++d) {
    const std::string axis = d == 0 ? "x" : "y";
    std::vector<double> below{1, 1, 1, 1}, above{1, 1, 1, 1};
    below[2 + d] = low[d] - little;
    above[2 + d] = high[d] + little;
    states.table("below_in_" + axis, "position", {2, below});
    states.table("above_in_" + axis, "position", {2, above});
  }
}

}  // namespace

void add_refused_states(KnownAnswers& all) {
  RefusedStates states(all);
  states.changed(
      "as_it_is", [](HandedFile&) {}, false);
  add_refused_attributes(states);
  add_refused_datasets(states);
  // Of a solid the points of the start alone.
  HandedFile file;
  file.tables = {{"solid/position", {1, {1, 2, 3}}},
                 {"solid/velocity", {1, {1, 2, 3}}},
                 {"solid/mass", {0, {1, 2, 3}}},
                 {"solid/volume", {0, {1, 2, 3}}},
                 {"solid/stress", {0, {1, 2, 3}}}};
  const TrialFolder folder;
  file.write(folder / "solid.h5");
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = law->density = 1;
  const Scene two = scene_of_handed("solid", law, 1, false);
  Scene three = two;
  three.bodies[0] = make_body("solid", law, 3, 1);
  const ResultFile result(folder / "solid.h5");
  all.push_back(yes("refused.other_points", refuses([&] { result.points(two); })));
  all.push_back(no("refused.own_points", refuses([&] { result.points(three); })));
}

}  // namespace plumbline
