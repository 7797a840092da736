// What is carried from one place of memory to another: columns of points that are sorted and copied, and all of a run that is
// saved and taken up again. Each number has a value that no other has, so that none can take another's place.
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/run/simulation_state.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/points/column_registry.hpp"

namespace plumbline {
namespace {

constexpr int carried_points = 5;

Scene few_points() {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {4, 4, 1};
  scene.transfer = "flip";  // wanted by integrators that remember states
  Body gas = make_body("gas", std::make_shared<IdealGas>(), carried_points, 2);
  for (int p = 0; p < carried_points; ++p) {
    for (int d = 0; d < 2; ++d) gas.points(column::position, d)[p] = 1.5 + 0.1 * p;
    for (const ColumnId* id : {&column::mass, &column::volume, &column::density, &column::energy}) {
      gas.points(*id)[p] = 1;
    }
  }
  scene.bodies.push_back(std::move(gas));
  return scene;
}

// Those that the scene has by now, and one, two or three of the other columns.
int carried_components(std::size_t column) {
  static const Columns own = Simulation(few_points(), "generalized-alpha", {}).scene().bodies[0].points;
  const int components = own.components(registered_columns()[column]);
  return components > 0 ? components : 1 + static_cast<int>(column % 3);
}

// Between 1 and 3, so that a position of this value stands in the grid.
double carried_value(std::size_t column, int component, int point) {
  return 1 + static_cast<double>(column) / 64 + component / 256.0 + point / 8192.0;
}

// All columns that the program knows.
Columns every_column(int count) {
  Columns all(count);
  const std::vector<ColumnId> known = registered_columns();
  for (std::size_t k = 0; k < known.size(); ++k) {
    all.add(known[k], carried_components(k));
    for (int e = 0; e < carried_components(k); ++e) {
      for (int p = 0; p < count; ++p) all(known[k], e)[p] = carried_value(k, e, p);
    }
  }
  return all;
}

// That the point at place p of each column holds what point was[p] had. A column that is not there, or of which less is there, is
// none of these.
void add_columns(const std::string& name, const Columns& found, const std::vector<int>& was, KnownAnswers& all) {
  const std::vector<ColumnId> known = registered_columns();
  all.push_back({name + ".points", static_cast<double>(found.points()), static_cast<double>(was.size())});
  for (std::size_t k = 0; k < known.size(); ++k) {
    double off = found.components(known[k]) == carried_components(k) ? 0 : 1;
    for (int e = 0; off == 0 && e < carried_components(k); ++e) {
      for (std::size_t p = 0; p < was.size(); ++p) {
        off = larger(off, std::abs(found(known[k], e)[p] - carried_value(k, e, was[p])));
      }
    }
    all.push_back({name + "." + known[k].name(), off, 0});
  }
}

void add_sorted(KnownAnswers& all) {
  int components = 0;
  for (std::size_t k = 0; k < registered_columns().size(); ++k) components += carried_components(k);
  all.push_back(
      {"doubles_per_point", static_cast<double>(every_column(1).doubles_per_point()), static_cast<double>(components)});
  const std::vector<int> order{3, 0, 4, 2, 1};
  Columns sorted = every_column(carried_points);
  sorted.reorder(order);
  add_columns("sorted", sorted, order, all);
  sorted.reorder(std::vector<int>{1, 4, 3, 0, 2});  // and back
  add_columns("unsorted", sorted, {0, 1, 2, 3, 4}, all);
  // Of a column that nobody will read again nothing moves; all others do.
  const std::vector<ColumnId> stale{column::density};
  sorted.reorder(order, stale);
  all.push_back({"stale.density", sorted(column::density)[0], every_column(1)(column::density)[0]});
  sorted = every_column(carried_points);
  sorted.append_copies(std::vector<int>{4, 1, 4});
  add_columns("appended", sorted, {0, 1, 2, 3, 4, 4, 1, 4}, all);
}

using LedgerImage = std::array<double, sizeof(Ledger) / sizeof(double)>;

// One point more than at the start, split from number 3, and everything else otherwise, too.
const std::vector<int> later_numbers{4, 0, 5, 2, 1, 3}, later_split{3};
constexpr double later_time = 1.25, later_limit = 0.375, later_parameter = 0.625, later_kept = 0.0625;
constexpr long later_step = 17;
double later_entry(std::size_t k) { return 0.5 + static_cast<double>(k); }  // of the ledger
const std::vector<double> later_memory{7, 8, 9};

Checkpoint later_state(const Simulation& simulation, const std::string& integrator) {
  Checkpoint later = simulation.save();
  later.time = later_time;
  later.step = later_step;
  later.step_limit = later_limit;
  later.points[0] = every_column(carried_points + 1);
  later.ids[0] = later_numbers;
  later.split_from[0] = later_split;
  LedgerImage image;
  for (std::size_t k = 0; k < image.size(); ++k) image[k] = later_entry(k);
  later.ledger = std::bit_cast<Ledger>(image);
  std::shared_ptr<TimeIntegrator> own = find_integrator(integrator)->copy(*later.integrator);
  for (const IntegratorParameter& parameter : own->parameters()) *parameter.value = later_parameter;
  for (State* state : own->memory()) state->values = later_memory;
  for (double* number : own->kept()) *number = later_kept;
  later.integrator = std::move(own);
  return later;
}

double differing(const std::vector<int>& found, const std::vector<int>& exact) { return found == exact ? 0 : 1; }

// Saved, and taken up by a run that is at its start.
void add_taken_up(const std::string& integrator, KnownAnswers& all) {
  Simulation saved(few_points(), integrator, {}), other(few_points(), integrator, {});
  saved.restore(later_state(saved, integrator));
  Archive writing;
  archive_simulation(writing, saved, integrator);
  const Archive::Table kept = writing.take();
  Archive reading(kept);
  archive_simulation(reading, other, integrator);

  const Checkpoint found = other.save();
  add_columns(integrator, found.points[0], {0, 1, 2, 3, 4, 5}, all);
  const auto row = [&](const char* name, double value, double exact) {
    all.push_back({integrator + "." + name, value, exact});
  };
  row("time", found.time, later_time);
  row("step", static_cast<double>(found.step), later_step);
  row("step_limit", found.step_limit.value_or(NAN), later_limit);
  row("numbers", differing(found.ids[0], later_numbers), 0);
  row("split_from", differing(found.split_from[0], later_split), 0);
  const auto image = std::bit_cast<LedgerImage>(found.ledger);
  for (std::size_t k = 0; k < image.size(); ++k) row("ledger", image[k], later_entry(k));
  const std::unique_ptr<TimeIntegrator> own = find_integrator(integrator)->copy(*found.integrator);
  for (const IntegratorParameter& parameter : own->parameters()) row("parameter", *parameter.value, later_parameter);
  for (const State* state : own->memory()) {
    row("memory", static_cast<double>(state->values.size()), 3);
    for (std::size_t k = 0; k < state->values.size(); ++k) row("memory", state->values[k], later_memory[k]);
  }
  for (const double* number : own->kept()) row("kept", *number, later_kept);
}

// Whether a state is refused that has a point here.
bool refused_at(double x) {
  Simulation saved(few_points(), "musl", {}), other(few_points(), "musl", {});
  Checkpoint later = saved.save();
  later.points[0](column::position, 1)[2] = x;
  saved.restore(later);
  Archive writing;
  archive_simulation(writing, saved, "musl");
  const Archive::Table kept = writing.take();
  Archive reading(kept);
  return throws<ArchiveError>([&] { archive_simulation(reading, other, "musl"); });
}

}  // namespace

KnownAnswers carried_answers() {
  KnownAnswers all;
  add_sorted(all);
  add_taken_up("generalized-alpha", all);   // with a parameter and a memory
  add_taken_up("central-difference", all);  // with a number that it keeps
  // Four cells from 0 on, and rounding beyond them.
  for (const double x : {-1e-9, 4 + 1e-9}) all.push_back(no("at_the_edge", refused_at(x)));
  for (const double x : {-0.01, 4.01}) all.push_back(yes("outside", refused_at(x)));
  return all;
}

}  // namespace plumbline
