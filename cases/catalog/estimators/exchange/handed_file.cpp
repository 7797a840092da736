#include "cases/catalog/estimators/exchange/handed_file.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include "cases/harness/exchange/result_file.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {

void HandedFile::write(const std::string& path) const {
  Hdf5Writer file(path);
  for (const auto& [name, text] : texts) file.attribute("/", name, text);
  for (const auto& [name, number] : numbers) file.real_attribute("/", name, number);
  for (const auto& [body, tables] : bodies) {
    for (const auto& [name, table] : tables) {
      file.array<double>("/bodies/" + body + "/" + name, table.values, table.columns);
    }
  }
  file.commit();
}

Scene scene_without_bodies(int dim, bool rings) {
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.axisymmetric = rings;
  scene.grid.h = 0.5;
  scene.grid.origin = {1, -1, 0};
  scene.grid.cells = {4, dim > 1 ? 6 : 1, dim > 2 ? 8 : 1};
  return scene;
}

HandedTables gas_tables() {
  return {{"position", {2, {0.5, 2.5, 3.5, -1.5}}},
          {"velocity", {2, {1, 2, 3, 4}}},
          {"mass", {0, {0.5, 3}}},
          {"density", {0, {2, 4}}},
          {"energy", {1, {10, 0}}}};
}

std::shared_ptr<const Material> handed_gas() {
  auto law = std::make_shared<IdealGas>();
  law->gamma = 1.5;
  return law;
}

namespace {

std::string refusal_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

// Bodies in one file, each of them the gas with one thing changed. Where nothing is wrong with one it is the others that are
// refused: the scene has none of them.
class ChangedBodies {
 public:
  void add(const std::string& name, HandedTables tables, bool refused) {
    file_.bodies[name] = std::move(tables);
    expected_.emplace_back(name, refused);
  }
  void without(const std::string& dataset) {
    HandedTables tables = gas_tables();
    tables.erase(dataset);
    add("no_" + dataset, std::move(tables), true);
  }
  void with(const std::string& name, const std::string& dataset, const HandedTable& table, bool refused = true) {
    HandedTables tables = gas_tables();
    tables[dataset] = table;
    add(name, std::move(tables), refused);
  }

  void ask(KnownAnswers& all) const {
    const ScratchFolder folder;
    file_.write(folder / "changed.h5");
    const ResultFile result(folder / "changed.h5");
    const auto refused = [&](const std::string& name) {
      Scene scene = scene_without_bodies(2, false);
      scene.bodies.push_back(make_body(name, handed_gas(), 2, 2));
      const std::string why = refusal_of([&] { result.points(scene); });
      return why.find("the case has no such body") == std::string::npos;
    };
    for (const auto& [name, exact] : expected_) {
      all.push_back(whether("refused." + name, refused(name), exact));
    }
    all.push_back(yes("refused.no_body", refused("no_body")));
  }

 private:
  HandedFile file_;
  std::vector<std::pair<std::string, bool>> expected_;
};

void add_refused_datasets(KnownAnswers& all) {
  ChangedBodies bodies;
  bodies.add("as_it_is", gas_tables(), false);
  for (const char* dataset : {"position", "velocity", "mass", "density", "energy"}) bodies.without(dataset);
  bodies.with("no_rows", "position", {2, {}});
  bodies.with("flat_vector", "velocity", {0, {1, 2}});
  bodies.with("more_rows", "velocity", {2, {1, 2, 3, 4, 5, 6}});
  bodies.with("longer_list", "mass", {0, {1, 2, 3}});
  bodies.with("wide_list", "mass", {2, {1, 2, 3, 4}});
  bodies.with("no_number", "velocity", {2, {1, NAN, 3, 4}});
  bodies.with("without_mass", "mass", {0, {1, 0}});
  bodies.with("cold", "energy", {0, {0, 0}}, false);
  bodies.with("colder", "energy", {0, {0, -1}});
  bodies.with("backwards", "velocity", {2, {-1, -2, -3, -4}}, false);
  constexpr double low[] = {0.5, -1.5}, high[] = {3.5, 2.5}, little = 1e-3;
  for (std::size_t d = 0; d < 2; ++d) {
    const std::string axis = d == 0 ? "x" : "y";
    std::vector<double> below{1, 1, 1, 1}, above{1, 1, 1, 1};
    below[d] = low[d] - little;
    above[2 + d] = high[d] + little;
    bodies.with("below_in_" + axis, "position", {2, below});
    bodies.with("above_in_" + axis, "position", {2, above});
  }
  bodies.ask(all);
}

// Files of which an attribute is not there, or out of its range.
void add_refused_attributes(KnownAnswers& all) {
  const ScratchFolder folder;
  const auto changed = [&](const std::string& name, const std::function<void(HandedFile&)>& change) {
    HandedFile file;
    change(file);
    file.write(folder / "changed.h5");
    all.push_back(yes("refused." + name, refuses([&] { ResultFile{folder / "changed.h5"}; })));
  };
  const auto number = [&](const std::string& name, const std::string& of, double value) {
    changed(name, [&](HandedFile& file) { file.numbers[of] = value; });
  };
  changed("no_start", [](HandedFile& file) { file.texts.erase("start"); });
  changed("no_time", [](HandedFile& file) { file.numbers.erase("time"); });
  changed("kind", [](HandedFile& file) { file.texts["kind"] = "initial-state"; });
  number("format", "exchange_format", 2);
  number("no_cells", "cells", 0);
  number("half_a_cell", "cells", 20.5);
  number("too_many_cells", "cells", 1e9 + 1);
  number("fewer_steps_than_none", "steps", -1);
  number("endless", "wall_s", HUGE_VAL);
}

}  // namespace

void add_refused_states(KnownAnswers& all) {
  add_refused_attributes(all);
  add_refused_datasets(all);
  // Of a solid the points of the start alone.
  HandedFile file;
  for (const char* name : {"position", "velocity"}) file.bodies["solid"][name] = {1, {1, 2, 3}};
  for (const char* name : {"mass", "volume", "stress"}) file.bodies["solid"][name] = {0, {1, 2, 3}};
  const ScratchFolder folder;
  file.write(folder / "solid.h5");
  const ResultFile result(folder / "solid.h5");
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = law->density = 1;
  const auto refused = [&](int points) {
    Scene scene = scene_without_bodies(1, false);
    scene.bodies.push_back(make_body("solid", law, points, 1));
    return refuses([&] { result.points(scene); });
  };
  all.push_back(yes("refused.other_points", refused(2)));
  all.push_back(no("refused.own_points", refused(3)));
}

}  // namespace plumbline
