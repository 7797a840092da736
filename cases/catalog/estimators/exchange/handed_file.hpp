// Final states as programs write them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/estimators/exchange/trial_files.hpp"

namespace plumbline {

struct HandedTable {
  std::size_t columns = 0;  // 0: a list
  std::vector<double> values;
};
using HandedTables = std::map<std::string, HandedTable>;  // by the names of datasets

// To be changed before it is written.
struct HandedFile {
  std::map<std::string, std::string> texts{{"kind", "final-state"},   {"case", "sod"},  {"start", "abc"},
                                           {"program", "my MPM+1.2"}, {"version", "7"}, {"problem", "def"}};
  std::map<std::string, double> numbers{
      {"exchange_format", 1}, {"time", 0.75}, {"cells", 20}, {"steps", 30}, {"wall_s", 1.5}};
  std::map<std::string, HandedTables> bodies{};

  void write(const std::string& path) const;
};

// A grid from 1 m, -1 m, 0 m on with cells of half a metre.
Scene scene_without_bodies(int dim, bool rings);

// Two points of a gas with gamma = 3/2 in the plane, at the very ends of a cell around the grid.
HandedTables gas_tables();
std::shared_ptr<const Material> handed_gas();

// Files that are no final state, or not of the scene.
void add_refused_states(KnownAnswers& all);

}  // namespace plumbline
