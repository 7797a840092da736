// What the laboratory says of the free end of a bar, against linear algebra, a table made beforehand, and runs.
#include <array>
#include <cmath>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_bar_edge {
namespace {

// Largest stable steps at two points a cell, as computed before this program was written: a bar of eight cells with two
// free ends.
struct Column {
  std::string shape, integrator;
  std::array<double, 4> limit;  // at each of the depths
};
constexpr std::array<double, 4> depths{0.25, 0.1, 0.01, 1e-4};
const std::vector<Column>& table() {
  static const std::vector<Column> all{
      {"linear", "usf", {1.732, 1.617, 1.435, 1.411}},    {"linear", "musl", {1.732, 1.617, 1.435, 1.411}},
      {"linear", "usl", {0.657, 0.435, 0.141, 0.0141}},   {"gimp", "usf", {1.732, 1.939, 1.967, 1.967}},
      {"gimp", "musl", {1.732, 1.939, 1.967, 1.967}},     {"gimp", "usl", {0.657, 0.704, 0.709, 0.708}},
      {"quadratic", "usf", {2.282, 2.235, 2.170, 2.162}}, {"quadratic", "musl", {2.282, 2.235, 2.170, 2.162}},
      {"quadratic", "usl", {0.999, 0.963, 0.917, 0.910}}};
  return all;
}

std::string name_of(const Column& column) { return column.shape + "-" + column.integrator; }

Settings settings_at(const StabilityProblem& edge, const Column& column, double depth, const std::string& far_end,
                     double length) {
  return stability_settings(edge, "default",
                            {{"shape", column.shape},
                             {"integrator", column.integrator},
                             {"depth", depth},
                             {"far_end", far_end},
                             {"length", length}});
}

// Largest departures of a column from the table and from the reference. The bar that leans on a wall has no reference.
Findings against_table(const std::string& far_end, double length) {
  const StabilityProblem& edge = find_stability_problem("bar-edge");
  Findings findings;
  findings.profile.abscissa = "depth";
  findings.profile.columns = {{"depth", "1", "depth of the last point in its cell", {depths.begin(), depths.end()}}};
  double from_reference = 0;
  for (const Column& column : table()) {
    double from_table = 0;
    ProfileColumn limits{name_of(column), "h/c", column.shape + ", " + column.integrator, {}};
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const Settings settings = settings_at(edge, column, depths[k], far_end, length);
      const double limit = edge.predicted(settings, 1e-7).limit();
      from_table = larger(from_table, std::abs(limit / column.limit[k] - 1));
      if (const auto closed = edge.closed_form(settings)) {
        from_reference = larger(from_reference, std::abs(limit / closed->limit - 1));
      }
      limits.values.push_back(limit);
    }
    findings.measures.push_back(scalar_measure(name_of(column) + ".departure", from_table, 0, 1e-15, "1"));
    findings.profile.columns.push_back(std::move(limits));
  }
  if (far_end == "free")
    findings.measures.push_back(scalar_measure("reference.departure", from_reference, 0, 1e-15, "1"));
  return findings;
}

Findings shallow() {
  const StabilityProblem& edge = find_stability_problem("bar-edge");
  Findings findings;
  findings.profile.abscissa = "depth";
  ProfileColumn depth{"depth", "1", "depth of the last point in its cell", {}}, limit{"limit", "h/c", "usl", {}},
      root{"limit_reference", "h/c", "√(2 depth)", {}};
  for (const double at : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const Settings settings = settings_at(edge, {"linear", "usl", {}}, at, "wall", 16);
    depth.values.push_back(at);
    limit.values.push_back(edge.predicted(settings, 1e-7).limit());
    root.values.push_back(std::sqrt(2 * at));
  }
  double worst = 0;
  for (std::size_t k = 0; k < limit.values.size(); ++k) {
    worst = larger(worst, std::abs(limit.values[k] / root.values[k] - 1) / depth.values[k]);
  }
  findings.measures.push_back(finding("departure_over_depth", worst));
  findings.profile.columns = {depth, limit, root};
  return findings;
}

Findings runs() {
  const StabilityProblem& edge = find_stability_problem("bar-edge");
  Findings findings;
  double worst = 0, brackets = 1;
  for (const Column& column : table()) {
    for (const double depth : {0.25, 0.01}) {
      const Settings settings = settings_at(edge, column, depth, "wall", 16);
      const Configuration found = examine(edge, "default", settings, true);
      const auto& seen = found.observed->brackets;
      if (seen.size() != 1) brackets = static_cast<double>(seen.size());
      const double limit = seen.empty() ? std::nan("") : 0.5 * (seen.back().low + seen.back().high);
      worst = larger(worst, std::abs(limit / found.predicted.limit() - 1));
    }
  }
  findings.measures.push_back(scalar_measure("observed.departure", worst, 0, 1e-15, "1"));
  findings.measures.push_back(finding("observed.brackets", brackets));
  return findings;
}

std::vector<Trial> trials() {
  return {
      {"table", "two free ends, eight cells", "Nine columns at four depths.", [] { return against_table("free", 8); }},
      {"one-edge", "one free end", "The same depths.", [] { return against_table("wall", 16); }, Tier::full},
      {"shallow", "usl with linear shapes, the last point ever less deep", "One light node.", shallow},
      {"runs", "limits that runs show, one free end", "Random states of sixteen cells.", runs, Tier::full}};
}

std::vector<CaseGate> gates() {
  const auto within_one = [](const std::string& study, const std::string& column) {
    return gate(study + "/" + column, error_of(column + ".departure"), at_most(0.01),
                requirement("within 1 % of a table computed before this program was, to three digits, a tenth of the "
                            "margin that cfl=auto leaves below a limit"));
  };
  std::vector<CaseGate> all;
  for (const Column& column : table()) {
    const std::string name = name_of(column);
    all.push_back(within_one("table", name));
    if (name != "quadratic-usl") all.push_back(within_one("one-edge", name).in(Tier::full));
  }
  const std::vector<CaseGate> rows{
      within_one("one-edge", "quadratic-usl")
          .fails("the table's column is that of its other end, ½ − depth deep", {0.06, 0.075}, "2026-11-22 8052781")
          .in(Tier::full),
      gate("table/reference", error_of("reference.departure"), at_most(2e-6),
           theory("differentiating the step gives the eigenvalues of the symmetric matrix; a radius up to 1 + 1e-6 "
                  "counts as stable, where usl's grows with twice the step's")),
      gate("shallow/root", value_of("departure_over_depth"), at_most(1),
           theory("the light node's own limit is the root of twice the depth, next order in depth")),
      gate("runs/limit", error_of("observed.departure"), at_most(0.01), requirement(observed_limits)).in(Tier::full),
      gate("runs/brackets", value_of("observed.brackets"), exactly(1),
           theory("below the limit all steps are stable, above it none"))
          .in(Tier::full)};
  all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

Case stability_bar_edge() { return trial_case("stability-bar-edge", trials(), gates()); }
PLUMBLINE_CASE(stability_bar_edge);

}  // namespace
}  // namespace plumbline::stability_bar_edge
