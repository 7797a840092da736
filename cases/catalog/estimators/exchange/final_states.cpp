// Final states that a program hands in: what is read of them, what is worked out of it, and what is refused.
#include <memory>
#include <utility>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/given_stress.hpp"
#include "cases/catalog/estimators/exchange/handed_file.hpp"
#include "cases/harness/exchange/result_file.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {
namespace {

// Two points of a body as they are handed in, and the columns that come of them, component by component.
struct HandedBody {
  std::string name;
  std::shared_ptr<const Material> material;
  HandedTables tables;
  std::vector<std::pair<ColumnId, std::vector<double>>> exact;
};

void add_handed_in(const ScratchFolder& folder, int dim, bool rings, const std::vector<HandedBody>& bodies,
                   KnownAnswers& all) {
  HandedFile file;
  Scene scene = scene_without_bodies(dim, rings);
  for (const HandedBody& body : bodies) {
    file.bodies[body.name] = body.tables;
    scene.bodies.push_back(make_body(body.name, body.material, 2, dim, rings));
  }
  file.write(folder / "bodies.h5");
  const std::vector<HandedIn> found = ResultFile(folder / "bodies.h5").points(scene);
  all.push_back(yes(bodies.front().name + ".bodies", found.size() == bodies.size()));
  for (std::size_t b = 0; b < std::min(found.size(), bodies.size()); ++b) {
    all.push_back({bodies[b].name + ".points", static_cast<double>(found[b].points), 2});
    for (const auto& [id, values] : bodies[b].exact) {
      const bool there = found[b].columns.has(id);
      all.push_back(yes(bodies[b].name + "." + id.name() + ".there", there));
      if (!there) continue;
      const auto kept = found[b].columns.values(id);
      all.push_back(
          {bodies[b].name + "." + id.name(), farthest(std::vector<double>(kept.begin(), kept.end()), values), 0});
    }
  }
}

// What is missing follows from the mass, and p = rho e / 2; what is there stays, even where it does not fit.
std::vector<HandedBody> handed_gases() {
  HandedTables instead = gas_tables(), everything = gas_tables();
  instead.erase("density");
  instead.erase("energy");
  instead["volume"] = {0, {0.25, 0.5}};
  instead["pressure"] = {0, {3, 0}};
  everything["volume"] = {0, {7, 8}};
  everything["pressure"] = {0, {5, 6}};
  return {
      {"gas",
       handed_gas(),
       gas_tables(),
       {{column::position, {0.5, 3.5, 2.5, -1.5}},
        {column::velocity, {1, 3, 2, 4}},
        {column::mass, {0.5, 3}},
        {column::density, {2, 4}},
        {column::volume, {0.25, 0.75}},
        {column::energy, {10, 0}},
        {column::pressure, {10, 0}}}},
      {"instead",
       handed_gas(),
       instead,
       {{column::density, {2, 6}},
        {column::volume, {0.25, 0.5}},
        {column::energy, {3, 0}},
        {column::pressure, {3, 0}}}},
      {"everything",
       handed_gas(),
       everything,
       {{column::density, {2, 4}}, {column::volume, {7, 8}}, {column::energy, {10, 0}}, {column::pressure, {5, 6}}}}};
}

// The second point has twice as much as the first.
std::vector<double> row_and_twice(std::vector<double> row) {
  for (std::size_t k = 0, size = row.size(); k < size; ++k) row.push_back(2 * row[k]);
  return row;
}
std::vector<double> by_component(const std::vector<double>& row) {
  std::vector<double> all;
  for (const double value : row) all.insert(all.end(), {value, 2 * value});
  return all;
}

HandedTables solid_tables(int dim, const std::string& state, const std::vector<double>& row) {
  const auto n = static_cast<std::size_t>(dim);
  return {{"position", {n, std::vector<double>(2 * n, 1.5)}},
          {"velocity", {n, row_and_twice(std::vector<double>(n, 0.25))}},
          {"mass", {0, {3, 4}}},
          {"volume", {1, {5, 6}}},
          {state, {row.size(), row_and_twice(row)}}};
}

// With E = 2.5 Pa and nu = 1/4, so that lambda = mu = 1 Pa; in plane stress lambda = 2/3 Pa, and on a line E counts.
HandedBody hooke(const std::string& name, int dim, const std::vector<double>& stress, const std::vector<double>& strain,
                 bool plane_stress = false) {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = 2.5;
  law->poissons_ratio = 0.25;
  law->density = 1;
  law->plane_stress = plane_stress;
  return {name,
          law,
          solid_tables(dim, "stress", stress),
          {{column::stress, by_component(stress)},
           {column::strain, by_component(strain)},
           {column::mass, {3, 4}},
           {column::volume, {5, 6}}}};
}

void add_bodies(const ScratchFolder& folder, KnownAnswers& all) {
  std::vector<HandedBody> plane = handed_gases();
  plane.push_back(hooke("plane", 2, {3 + 2, 3 + 4, 7}, {1, 2, 7}));
  plane.push_back(hooke("plane_stress", 2, {2 + 2, 2 + 4, 7}, {1, 2, 7}, true));
  const std::vector<double> stretched{2, 0.5, 0.25, 1, 3};
  const HandedBody finite{"finite",
                          std::make_shared<NeoHookean>(),
                          solid_tables(2, "deformation", stretched),
                          {{column::deformation, by_component(stretched)}}};
  add_handed_in(folder, 2, false, plane, all);
  add_handed_in(folder, 1, false, {hooke("line", 1, {5}, {2})}, all);
  add_handed_in(folder, 2, true, {hooke("rings", 2, {8 + 2, 8 + 4, 8 + 10, 7}, {1, 2, 5, 7}), finite}, all);
  add_handed_in(folder, 3, false, {hooke("space", 3, {8 + 2, 8 + 4, 8 + 10, 7, -3, 4}, {1, 2, 5, 7, -3, 4})}, all);
}

void add_attributes(const ScratchFolder& folder, KnownAnswers& all) {
  HandedFile whole, least, most;
  whole.write(folder / "whole.h5");
  const ResultFile file(folder / "whole.h5");
  all.push_back(yes("says.path", file.path() == folder / "whole.h5"));
  all.push_back(yes("says.case", file.case_name == "sod"));
  all.push_back(yes("says.program", file.program == "my_MPM+1.2"));
  all.push_back(yes("says.version", file.version == "7"));
  all.push_back(yes("says.start", file.start == "abc" && file.problem == "def"));
  all.push_back({"says.cells", static_cast<double>(file.cells), 20});
  all.push_back({"says.time", file.time, 0.75});
  all.push_back({"says.steps", static_cast<double>(file.steps), 30});
  all.push_back({"says.wall_s", file.wall_s, 1.5});

  for (const char* name : {"program", "version", "problem"}) least.texts.erase(name);
  for (const char* name : {"steps", "wall_s"}) least.numbers.erase(name);
  least.numbers["cells"] = 1;
  least.write(folder / "least.h5");
  const ResultFile short_file(folder / "least.h5");
  all.push_back(yes("least.program", short_file.program == "unnamed"));
  all.push_back(yes("least.texts", short_file.version.empty() && short_file.problem.empty()));
  all.push_back({"least.cells", static_cast<double>(short_file.cells), 1});
  all.push_back({"least.steps", static_cast<double>(short_file.steps), 0});
  all.push_back({"least.wall_s", short_file.wall_s, 0});

  most.texts["program"] = "azAZ09._-+ /@[`{:" + std::string(40, 'q');  // what stands beside letters and digits, too
  most.numbers["steps"] = 1e300;
  most.numbers["cells"] = 1e9;
  most.write(folder / "most.h5");
  const ResultFile long_file(folder / "most.h5");
  all.push_back(yes("most.program", long_file.program == "azAZ09._-+_______" + std::string(23, 'q')));
  all.push_back({"most.cells", static_cast<double>(long_file.cells), 1e9, 1e9});
  all.push_back({"most.steps", static_cast<double>(long_file.steps), 1e15, 1e15});
}

}  // namespace

KnownAnswers final_state_answers() {
  KnownAnswers all;
  const ScratchFolder folder;
  add_attributes(folder, all);
  add_bodies(folder, all);
  add_refused_states(all);
  return all;
}

}  // namespace plumbline
