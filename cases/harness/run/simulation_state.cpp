#include "cases/harness/run/simulation_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "kernel/points/column_registry.hpp"

namespace plumbline {
namespace {

static_assert(std::is_trivially_copyable_v<Ledger> && sizeof(Ledger) % sizeof(double) == 0,
              "the ledger is kept as it stands in memory, and holds nothing but numbers");

void archive_ledger(Archive& archive, Ledger& ledger) {
  auto image = std::bit_cast<std::array<double, sizeof(Ledger) / sizeof(double)>>(ledger);
  archive("ledger", image);
  if (archive.reads()) ledger = std::bit_cast<Ledger>(image);
}

// The columns of `points` points. Some come in the first steps, so that a new scene does not have them yet.
void archive_columns(Archive& archive, int points, Columns& columns) {
  constexpr int most = 16;  // components
  const std::vector<ColumnId> known = registered_columns();
  std::vector<int> components;
  for (const ColumnId& id : known) components.push_back(columns.components(id));
  archive("components", components);
  if (components.size() != known.size()) throw ArchiveError("other columns are known");
  Columns read(points);
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (components[k] == 0) continue;
    if (components[k] < 0 || components[k] > most) throw ArchiveError(known[k].name() + " has no such components");
    std::vector<double> values;
    if (!archive.reads()) {
      const auto own = columns.values(known[k]);
      values.assign(own.begin(), own.end());
    }
    archive(known[k].name(), values);
    if (!archive.reads()) continue;
    read.add(known[k], components[k]);
    const auto to = read.values(known[k]);
    if (values.size() != to.size()) {
      throw ArchiveError(fmt::format("{} has {} numbers for {} points", known[k].name(), values.size(), points));
    }
    std::copy(values.begin(), values.end(), to.begin());
  }
  if (!archive.reads()) return;
  for (const ColumnId& id : known) {
    if (columns.components(id) > 0 && columns.components(id) != read.components(id))
      throw ArchiveError(id.name() + " is not as the scene has it");
  }
  columns = std::move(read);
}

// Each number once: what watches a run finds points by them.
void require_numbers(const std::vector<int>& id, const std::vector<int>& split_from) {
  const auto count = static_cast<int>(id.size());
  std::vector<bool> seen(id.size());
  for (const int number : id) {
    const bool is_new = number >= 0 && number < count && !seen[static_cast<std::size_t>(number)];
    if (!is_new) throw ArchiveError(fmt::format("point number {} is out of range or there twice", number));
    seen[static_cast<std::size_t>(number)] = true;
  }
  for (const int from : split_from) {
    if (from < 0 || from >= count) throw ArchiveError(fmt::format("a point is split from number {}", from));
  }
}

// Between two steps all points stand in the grid, and the engine relies on it.
void require_inside(const Columns& points, const GridSpec& grid) {
  constexpr double rounding = 1e-6;  // cells
  for (int d = 0; points.has(column::position) && d < grid.dim; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    for (int p = 0; p < points.points(); ++p) {
      const double cells = (points(column::position, d)[p] - grid.origin[axis]) / grid.h;
      if (cells >= -rounding && cells <= grid.cells[axis] + rounding) continue;
      throw ArchiveError(fmt::format("point {} stands outside the grid", p));
    }
  }
}

struct BodyState {
  Columns& points;
  std::vector<int>&id, &split_from;
  const GridSpec& grid;

  void history(Archive& archive) {
    archive("id", id);
    archive("split_from", split_from);
    archive_columns(archive, static_cast<int>(id.size()), points);
    if (!archive.reads()) return;
    require_numbers(id, split_from);
    require_inside(points, grid);
  }
};

void archive_integrator(Archive& archive, const std::string& name, std::shared_ptr<const TimeIntegrator>& integrator) {
  std::shared_ptr<TimeIntegrator> own = find_integrator(name)->copy(*integrator);
  for (const IntegratorParameter& parameter : own->parameters()) {
    archive("integrator/parameters/" + parameter.name, *parameter.value);
  }
  int k = 0;
  for (State* state : own->memory()) archive(fmt::format("integrator/memory/{}", k++), state->values);
  k = 0;
  for (double* number : own->kept()) archive(fmt::format("integrator/kept/{}", k++), *number);
  integrator = std::move(own);
}

}  // namespace

void archive_simulation(Archive& archive, Simulation& simulation, const std::string& integrator) {
  Checkpoint state = simulation.save();
  archive("time", state.time);
  archive("step", state.step);
  double limit = state.step_limit.value_or(0);
  archive("step_limit", limit);
  state.step_limit = limit;
  archive_ledger(archive, state.ledger);
  for (std::size_t b = 0; b < state.points.size(); ++b) {
    BodyState body{state.points[b], state.ids[b], state.split_from[b], simulation.scene().grid};
    archive(fmt::format("bodies/{}", b), body);
  }
  archive_integrator(archive, integrator, state.integrator);
  if (!archive.reads()) return;
  try {
    simulation.restore(state);
  } catch (const std::invalid_argument& error) {
    throw ArchiveError(error.what());
  }
}

}  // namespace plumbline
