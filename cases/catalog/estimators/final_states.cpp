// Final states that a program hands in: what is read of them, what is worked out of it, and what is refused.
#include <functional>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/given_stress.hpp"
#include "cases/catalog/estimators/handed_file.hpp"
#include "cases/harness/exchange/result_file.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {
namespace {

void add_handed_columns(const std::string& name, const HandedIn& found,
                        const std::vector<std::pair<ColumnId, std::vector<double>>>& exact, KnownAnswers& all) {
  for (const auto& [id, values] : exact) {  // component by component
    const bool there = found.columns.has(id);
    all.push_back(yes(name + "." + id.name() + ".there", there));
    if (!there) continue;
    const auto kept = found.columns.values(id);
    all.push_back({name + "." + id.name(), farthest(std::vector<double>(kept.begin(), kept.end()), values), 0});
  }
}

using HandedChange = std::function<void(HandedFile&)>;
void add_gas_handed_in(const TrialFolder& folder, KnownAnswers& all) {
  const auto handed = [&](const std::string& name, const HandedChange& change,
                          const std::vector<std::pair<ColumnId, std::vector<double>>>& exact) {
    HandedFile file = gas_file();
    change(file);
    file.write(folder / "gas.h5");
    const std::vector<HandedIn> bodies = ResultFile(folder / "gas.h5").points(scene_of_gas());
    all.push_back({name + ".bodies", static_cast<double>(bodies.size()), 1});
    all.push_back({name + ".points", static_cast<double>(bodies.at(0).points), 2});
    add_handed_columns(name, bodies.at(0), exact, all);
  };
  handed("gas", [](HandedFile&) {},
         {{column::position, {0.5, 3.5, 2.5, -1.5}},
          {column::velocity, {1, 3, 2, 4}},
          {column::mass, {0.5, 3}},
          {column::density, {2, 4}},
          {column::volume, {0.25, 0.75}},
          {column::energy, {10, 0}},
          {column::pressure, {10, 0}}});
  const auto instead = [](HandedFile& file) {
    file.tables["gas/volume"] = {0, {0.25, 0.5}};
    file.tables["gas/pressure"] = {0, {3, 0}};
    file.tables.erase("gas/density");
    file.tables.erase("gas/energy");
  };
  handed(
      "instead", instead,
      {{column::density, {2, 6}}, {column::volume, {0.25, 0.5}}, {column::energy, {3, 0}}, {column::pressure, {3, 0}}});
  const auto everything = [](HandedFile& file) {
    file.tables["gas/volume"] = {0, {7, 8}};
    file.tables["gas/pressure"] = {0, {5, 6}};
  };
  handed("everything", everything,
         {{column::density, {2, 4}}, {column::volume, {7, 8}}, {column::energy, {10, 0}}, {column::pressure, {5, 6}}});
}

struct HookeByHand {
  std::string name;
  int dim;
  bool rings, plane_stress;
  std::vector<double> stress, strain;  // of a point
};

// With E = 2.5 Pa and nu = 1/4, so that lambda = mu = 1 Pa, in plane stress lambda = 2/3 Pa.
const std::vector<HookeByHand> hooke_by_hand{
    {"line", 1, false, false, {5}, {2}},
    {"plane", 2, false, false, {3 + 2, 3 + 4, 7}, {1, 2, 7}},
    {"plane_stress", 2, false, true, {2 + 2, 2 + 4, 7}, {1, 2, 7}},
    {"rings", 2, true, false, {8 + 2, 8 + 4, 8 + 10, 7}, {1, 2, 5, 7}},
    {"space", 3, false, false, {8 + 2, 8 + 4, 8 + 10, 7, -3, 4}, {1, 2, 5, 7, -3, 4}}};

HandedFile solid_file(int dim, const std::string& last, const std::vector<double>& of_point) {
  HandedFile file;
  const auto n = static_cast<std::size_t>(dim);
  const auto twice = [](std::vector<double> row) {  // and the second point has twice as much
    for (std::size_t k = 0, size = row.size(); k < size; ++k) row.push_back(2 * row[k]);
    return row;
  };
  file.tables = {{"solid/position", {n, std::vector<double>(2 * n, 1.5)}},
                 {"solid/velocity", {n, twice(std::vector<double>(n, 0.25))}},
                 {"solid/mass", {0, {3, 4}}},
                 {"solid/volume", {1, {5, 6}}},
                 {"solid/" + last, {of_point.size(), twice(of_point)}}};
  return file;
}

// Component by component of both points.
std::vector<double> of_both_points(const std::vector<double>& row) {
  std::vector<double> all;
  for (const double value : row) all.insert(all.end(), {value, 2 * value});
  return all;
}

void add_solids_handed_in(const TrialFolder& folder, KnownAnswers& all) {
  const auto points_of = [&](const HandedFile& file, const Scene& scene) {
    file.write(folder / "solid.h5");
    return ResultFile(folder / "solid.h5").points(scene).at(0);
  };
  for (const HookeByHand& one : hooke_by_hand) {
    auto law = std::make_shared<LinearElastic>();
    law->youngs_modulus = 2.5;
    law->poissons_ratio = 0.25;
    law->density = 1;
    law->plane_stress = one.plane_stress;
    const HandedIn in = points_of(solid_file(one.dim, "stress", one.stress),
                                  scene_of_handed("solid", law, one.dim, one.rings));
    add_handed_columns(one.name, in,
                       {{column::stress, of_both_points(one.stress)},
                        {column::strain, of_both_points(one.strain)},
                        {column::mass, {3, 4}},
                        {column::volume, {5, 6}}},
                       all);
  }
  const std::vector<double> stretched{2, 0.5, 0.25, 1, 3};
  const HandedIn in = points_of(solid_file(2, "deformation", stretched),
                                scene_of_handed("solid", std::make_shared<NeoHookean>(), 2, true));
  add_handed_columns("finite", in, {{column::deformation, of_both_points(stretched)}}, all);
}

void add_attributes(const TrialFolder& folder, KnownAnswers& all) {
  gas_file().write(folder / "gas.h5");
  const ResultFile file(folder / "gas.h5");
  all.push_back(yes("says.path", file.path() == folder / "gas.h5"));
  all.push_back(yes("says.case", file.case_name == "sod"));
  all.push_back(yes("says.program", file.program == "my_MPM+1.2"));
  all.push_back(yes("says.version", file.version == "7"));
  all.push_back(yes("says.start", file.start == "abc" && file.problem == "def"));
  all.push_back({"says.cells", static_cast<double>(file.cells), 20});
  all.push_back({"says.time", file.time, 0.75});
  all.push_back({"says.steps", static_cast<double>(file.steps), 30});
  all.push_back({"says.wall_s", file.wall_s, 1.5});
  HandedFile short_file = gas_file();
  for (const char* name : {"program", "version", "problem"}) short_file.texts.erase(name);
  for (const char* name : {"steps", "wall_s"}) short_file.numbers.erase(name);
  short_file.write(folder / "short.h5");
  const ResultFile least(folder / "short.h5");
  all.push_back(yes("least.program", least.program == "unnamed" && least.version.empty() && least.problem.empty()));
  all.push_back({"least.steps", static_cast<double>(least.steps), 0});
  all.push_back({"least.wall_s", least.wall_s, 0});
  short_file.texts["program"] = std::string("azAZ09._-+ /@[`{:") + std::string(40, 'q');
  short_file.numbers["steps"] = 1e300;
  short_file.write(folder / "short.h5");
  const ResultFile most(folder / "short.h5");
  all.push_back(yes("most.program", most.program == "azAZ09._-+_______" + std::string(23, 'q')));
  all.push_back({"most.steps", static_cast<double>(most.steps), 1e15, 1e15});
}

}  // namespace

KnownAnswers final_state_answers() {
  KnownAnswers all;
  const TrialFolder folder;
  add_attributes(folder, all);
  add_gas_handed_in(folder, all);
  add_solids_handed_in(folder, all);
  add_refused_states(all);
  return all;
}

}  // namespace plumbline
