// What is common to the files by which other programs take a case's start and hand in their final state: reports/docs/how-to/score-another-code.md.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

inline constexpr int exchange_format = 1;

// 12 hex digits: the case and the values of its own keys, whatever the mesh and the scheme.
std::string problem_id(const Case& entry, const Settings& settings);

// 12 hex digits: the problem on one mesh. A final state hands on that of its start, so that its `cells` cannot be mistaken.
std::string start_id(const Case& entry, const Settings& settings);

// "x", "y", "z"; of an axisymmetric scene too, where x is the radius.
std::string axis_name(int direction);

// What a body's final state must hold.
struct WantedDataset {
  std::string name, unit;
  int components = 1;                     // columns; with one, the dataset may have one dimension
  bool vector = false;                    // one component a dimension of space: in 1-D two dimensions are allowed, too
  bool positive = false;                  // > 0
  bool not_negative = false;              // >= 0
  std::vector<std::string> instead = {};  // any one of these and `name` is enough, the others are worked out
  std::string what = {};                  // for people
};

// Empty for materials whose points cannot be handed in (membranes: their cases are judged on the way).
std::vector<WantedDataset> wanted_datasets(const Material& material, int dim, bool axisymmetric);

// Of gas any points will do; solids are judged particle by particle: the points of the export, known by their numbers.
bool any_points_will_do(const Material& material);

}  // namespace plumbline
