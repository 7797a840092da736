#include "cases/catalog/stability/bar_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

constexpr int more_places = 12;
constexpr double none = 0;

struct TableColumn {
  std::string name, integrator, transfer;
  int order = 2;  // of xpic and fmpm
};
const std::vector<TableColumn>& table_columns() {
  static const std::vector<TableColumn> all{
      {"usf-flip", "usf", "flip"},     {"musl-flip", "musl", "flip"},   {"usl-flip", "usl", "flip"},
      {"musl-pic", "musl", "pic"},     {"usl-apic", "usl", "apic"},     {"musl-apic", "musl", "apic"},
      {"usf-xpic2", "usf", "xpic", 2}, {"usf-fmpm2", "usf", "fmpm", 2}, {"usf-fmpm4", "usf", "fmpm", 4}};
  return all;
}

struct Entry {
  double regular = none, worst = none;
};

// As computed beforehand on 24 periodic cells, columns in the order of table_columns().
struct Row {
  int ppc;
  std::string shape;
  std::vector<Entry> older;
};
const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {1, "linear", {{2, 1}, {2, 1}, {.707}, {1.71, 1}, {1}, {1}, {1.85, 1}, {1.45, 1}, {1.28, 1}}},
      {1, "cubic", {{2.71}, {2.71}, {1.37}, {2.39}, {1.71}, {1.96}, {2.57}, {2.11}, {1.95}}},
      {2,
       "linear",
       {{1.735, 1.414}, {1.735, 1.414}, {.756}, {1.48, 1.22}, {1}, {1}, {1.6, 1.32}, {1.26, 1.08}, {1.11, 1.02}}},
      {2, "gimp", {{1.735}, {1.735}, {.756}, {1.48}, {1}, {1}, {1.6}, {1.26}, {1.11}}},
      {2,
       "quadratic",
       {{2.4, 2.24},
        {2.4, 2.24},
        {1.35, 1.03},
        {2.14, 1.96},
        {1.65, 1.27},
        {1.81, 1.55},
        {2.31, 2.11},
        {1.91, 1.7},
        {1.79, 1.56}}},
      {2, "cubic", {{2.73}, {2.73}, {1.49}, {2.41}, {1.79}, {2.04}, {2.59}, {2.15}, {1.99}}},
      {3,
       "linear",
       {{1.68, 1.54}, {1.68, 1.54}, {.766}, {1.43, 1.31}, {1}, {1}, {1.55, 1.42}, {1.22, 1.13}, {1.08, 1.04}}},
      {3, "quadratic", {{2.31}, {2.31}, {1.15}, {2.02}, {1.41}, {1.65}, {2.18}, {1.78}, {1.64}}},
      {4,
       "linear",
       {{1.66, 1.58}, {1.66, 1.58}, {.77}, {1.42, 1.35}, {1}, {1}, {1.53, 1.46}, {1.2, 1.15}, {1.07, 1.04}}},
      {4,
       "quadratic",
       {{2.36, 2.33},
        {2.36, 2.33},
        {1.27, 1.19},
        {2.09, 2.05},
        {1.56, 1.47},
        {1.75, 1.69},
        {2.26, 2.21},
        {1.86, 1.81},
        {1.73, 1.67}}}};
  return all;
}

Settings settings_at(const StabilityProblem& bar, const TableColumn& column, const Row& row, double place) {
  return stability_settings(bar, "default",
                            {{"integrator", column.integrator},
                             {"transfer", column.transfer},
                             {"transfer_order", static_cast<double>(column.order)},
                             {"shape", row.shape},
                             {"ppc", static_cast<double>(row.ppc)},
                             {"N", place}});
}

struct LimitPair {
  double laboratory, reference;
  double departure() const { return std::abs(laboratory / reference - 1); }
};

LimitPair limits_at(const StabilityProblem& bar, const TableColumn& column, const Row& row, double place) {
  const Settings settings = settings_at(bar, column, row, place);
  const auto scheme = map_scheme(settings);
  const auto points = reference::regular_points(row.ppc, (place - 0.5) / row.ppc);
  return {bar.predicted(settings, 1e-6).limit(), reference::periodic_courant_limit(*scheme, points).value};
}

// Evenly spread over a share of a cell; the first as near to its side as makes no difference.
LimitPair worst_of_places(const StabilityProblem& bar, const TableColumn& column, const Row& row) {
  LimitPair worst{1e300, 1e300};
  for (int k = 0; k < more_places; ++k) {
    const LimitPair here = limits_at(bar, column, row, k == 0 ? 1e-5 : static_cast<double>(k) / more_places);
    worst = {std::min(worst.laboratory, here.laboratory), std::min(worst.reference, here.reference)};
  }
  return worst;
}

double departure(double value, double older) { return older == none ? 0 : std::abs(value / older - 1); }

// One column: `predict` at the regular places and at 12 more, against reference/mpm_amplification.hpp at the same places
// and against the table that was made beforehand. Measures:
//   regular.departure      largest relative one from the reference, regular places
//   worst.departure        the same of the worst of the 12 places
//   table.departure        largest relative one of the reference from the older table, regular places
//   table.worst_departure  the same at the worst places of all, where the table has them
// Profile: a row each.
Findings table_column(const TableColumn& column) {
  const StabilityProblem& bar = find_stability_problem("bar");
  const auto which = static_cast<std::size_t>(&column - table_columns().data());
  double regular = 0, worst = 0, older = 0, older_worst = 0;
  std::vector<std::vector<double>> table(6);
  for (const Row& row : rows()) {
    const LimitPair at_regular = limits_at(bar, column, row, 0.5), at_worst = worst_of_places(bar, column, row);
    const auto scheme = map_scheme(settings_at(bar, column, row, 0.5));
    const double worst_of_all = reference::worst_rigid_offset(*scheme, row.ppc).limit.value;
    const Entry& entry = row.older[which];
    regular = larger(regular, at_regular.departure());
    worst = larger(worst, at_worst.departure());
    older = larger(older, departure(at_regular.reference, entry.regular));
    older_worst = larger(older_worst, departure(worst_of_all, entry.worst));
    const double cells[] = {static_cast<double>(table[0].size() + 1),
                            static_cast<double>(row.ppc),
                            at_regular.laboratory,
                            entry.regular,
                            at_worst.laboratory,
                            worst_of_all};
    for (std::size_t k = 0; k < 6; ++k) table[k].push_back(cells[k]);
  }
  Findings findings;
  findings.measures = {scalar_measure("regular.departure", regular, 0, 1e-13, "1"),
                       scalar_measure("worst.departure", worst, 0, 1e-13, "1"),
                       scalar_measure("table.departure", older, 0, 1e-13, "1"),
                       scalar_measure("table.worst_departure", older_worst, 0, 1e-13, "1")};
  findings.profile.abscissa = "row";
  findings.profile.columns = {{"row", "1", "row of the table", table[0]},
                              {"ppc", "1", "points per cell", table[1]},
                              {"regular", "h/c", "regular places", table[2]},
                              {"regular_older", "h/c", "regular places, table made beforehand", table[3]},
                              {"worst_of_12", "h/c", "worst of twelve places", table[4]},
                              {"worst", "h/c", "worst place of all, reference", table[5]}};
  return findings;
}

}  // namespace

std::vector<Trial> table_trials() {
  std::vector<Trial> all;
  for (const TableColumn& column : table_columns()) {
    all.push_back({"table-" + column.name, column.integrator + ", " + column.transfer + ": regular and worst places",
                   "Ten rows of points per cell and shapes.", [&column] { return table_column(column); }, Tier::full});
  }
  return all;
}

std::vector<CaseGate> table_gates() {
  const Because exact = theory(
      "limits are exact eigenvalues; a radius up to 1 + 1e-6 counts as stable, bisected to 1e-6");
  std::vector<CaseGate> all;
  for (const TableColumn& column : table_columns()) {
    const auto add = [&](const std::string& measure, double most, Because because) {
      all.push_back(gate("table-" + column.name + "/" + measure, error_of(measure), at_most(most), std::move(because))
                        .in(Tier::full));
    };
    add("regular.departure", 1e-5, exact);
    add("worst.departure", 1e-5, exact);
    add("table.departure", 0.01,
        requirement("within 1 % of a table computed before this program was, of the waves that 24 cells hold, a tenth "
                    "of the margin that cfl=auto leaves below a limit"));
    add("table.worst_departure", 0.01, requirement("within 1 % of the same table at the worst place"));
  }
  return all;
}

}  // namespace plumbline
