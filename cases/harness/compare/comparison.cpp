#include "cases/harness/compare/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cases/harness/compare/parts.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline {
namespace {

std::size_t executed(const Snapshot& snapshot) { return snapshot.gates.size(); }

// What explains others comes before them: a run that stopped, then a lost order, then the errors it leaves.
std::size_t rank(const std::string& kind) {
  static constexpr std::array order{"machine", "study",    "run",   "verdict", "bound",
                                    "order",   "constant", "error", "limit",   "cost"};
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), kind) - order.begin());
}

auto place(const Finding& f) {
  // Within a change of one kind the larger first: a lost order leads, its smallest consequence ends the list.
  const double size = f.kind == "cost" && f.size ? std::log(*f.size) : f.size.value_or(0);
  return std::make_tuple(f.change, rank(f.kind), f.case_name, f.scheme, f.study, -std::abs(size), f.quantity);
}

std::string where(const Finding& f) {
  std::string text = f.case_name;
  for (const std::string& part : {f.scheme, f.study}) text += part.empty() ? "" : (text.empty() ? "" : " / ") + part;
  return text;
}

// What one line stands for.
bool one_group(const Finding& a, const Finding& b) {
  const bool lone = a.change == Change::missing || a.change == Change::added;
  return a.change == b.change && a.kind == b.kind && a.case_name == b.case_name &&
         (lone || (a.scheme == b.scheme && a.study == b.study && a.kind != "verdict" && a.kind != "bound"));
}

std::string line(const Finding& f, std::size_t further) {
  std::string text = fmt::format("  {:9} {}", f.kind, where(f));
  if (!f.quantity.empty()) text += (where(f).empty() ? "" : ": ") + f.quantity;
  if (const std::string what = words(f); !what.empty()) text += "  " + what;
  if (further > 0)
    text += fmt::format("  (and {} more of this {})", further,
                        f.change == Change::missing || f.change == Change::added ? "case" : "study");
  return text;
}

std::vector<std::string> lines_of(const std::vector<Finding>& findings, Change change, bool each) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < findings.size();) {
    std::size_t end = k + 1;
    while (!each && end < findings.size() && one_group(findings[k], findings[end])) ++end;
    if (findings[k].change == change) lines.push_back(line(findings[k], end - k - 1));
    k = end;
  }
  return lines;
}

std::string heading(Change change, std::size_t count) {
  static constexpr std::array<const char*, all_changes.size()> titles{"WORSE",
                                                                      "WIDENED: a gate lets pass more than it did",
                                                                      "MISSING: only the baseline has it",
                                                                      "INCONCLUSIVE: cannot be told from these data",
                                                                      "better",
                                                                      "new",
                                                                      "same"};
  return fmt::format("{} ({})", titles[static_cast<std::size_t>(change)], count);
}

std::string same_words(const Comparison& comparison) {
  std::map<std::string, std::size_t> kinds;
  for (const Finding& f : comparison.findings) {
    if (f.change == Change::same) ++kinds[f.kind];
  }
  std::vector<std::string> parts;
  for (const auto& [kind, count] : kinds) parts.push_back(fmt::format("{} {}", count, kind));
  std::string text = fmt::format("same ({}): {}", comparison.count(Change::same), fmt::join(parts, ", "));
  if (const std::size_t moved = comparison.moved(); moved > 0)
    text += fmt::format("; {} of these are not equal, but moved by less than what counts", moved);
  return text;
}

std::string closing(const Comparison& comparison) {
  if (comparison.nothing_changed()) return "nothing changed";
  std::vector<std::string> parts;
  for (const Change change : all_changes) {
    if (const std::size_t count = comparison.count(change); count > 0 && change != Change::same)
      parts.push_back(fmt::format("{} {}", count, name(change)));
  }
  if (parts.empty())
    return fmt::format("nothing of weight changed: {} numbers moved, the largest by {:.2g} %", comparison.moved(),
                       100 * comparison.largest_move());
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string source_words(const Snapshot& s) {
  return s.folder + (s.version.empty() ? "" : fmt::format(" ({}, {})", s.version, s.git.empty() ? "no git" : s.git));
}

void add_damaged(const Snapshot& snapshot, std::vector<std::string>& lines) {
  for (const auto& [file, why] : snapshot.damaged)
    lines.push_back(fmt::format("DAMAGED  {}/{}: {}", snapshot.folder, file, why));
}

Json snapshot_document(const Snapshot& s) {
  Json damaged = Json::array();
  for (const auto& [file, why] : s.damaged) damaged.push_back({{"file", file}, {"reason", why}});
  return {{"folder", s.folder},   {"version", s.version},    {"git", s.git},
          {"started", s.started}, {"executed", executed(s)}, {"damaged", damaged}};
}

}  // namespace

std::size_t Comparison::count(Change change) const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.change == change; }));
}

std::size_t Comparison::moved() const {
  return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const Finding& f) {
    return f.change == Change::same && !f.equal && f.kind != "cost";
  }));
}

double Comparison::largest_move() const {
  double largest = 0;
  for (const Finding& f : findings) {
    if (f.change == Change::same && !f.equal && f.kind != "cost" && f.kind != "order" && f.size)
      largest = std::max(largest, std::abs(*f.size));
  }
  return largest;
}

bool Comparison::nothing_changed() const { return count(Change::same) == findings.size() && moved() == 0; }

Comparison compare(const Snapshot& before, const Snapshot& after) {
  Comparison result;
  compare_gates(before, after, result.findings);
  compare_studies(before, after, result.findings);
  compare_limits(before, after, result.findings);
  compare_costs(before, after, result.findings);
  std::stable_sort(result.findings.begin(), result.findings.end(),
                   [](const Finding& a, const Finding& b) { return place(a) < place(b); });
  result.gates_before = executed(before);
  result.gates_after = executed(after);
  for (const auto& [key, value] : before.machine) {
    const auto other = after.machine.find(key);
    if (other != after.machine.end() && other->second != value) result.machine.push_back({key, value, other->second});
  }
  return result;
}

void look_up_widenings(const std::vector<LedgerLine>& ledger, const Snapshot& before, const Snapshot& after,
                       Comparison& comparison) {
  std::map<LedgerLine::Key, const LedgerLine*> lines;
  for (const LedgerLine& line : ledger) {
    if (line.widened) lines[line.key()] = &line;
  }
  // Results do not say what stops a run, nor whether the interval is judged.
  const auto known = [](Bounds bounds) {
    bounds.stops.reset();
    bounds.order = false;
    return bounds;
  };
  for (Finding& f : comparison.findings) {
    if (f.change != Change::widened) continue;
    for (const auto& [key, gate] : after.gates) {
      const auto was = before.gates.find(key);
      const auto line = lines.find({gate.case_name, gate.study, gate.id});
      if (was == before.gates.end() || line == lines.end() || f.quantity != gate_words(gate) ||
          std::tie(f.case_name, f.scheme, f.study) != std::tie(gate.case_name, gate.scheme, gate.study))
        continue;
      const Widening& widened = *line->second->widened;
      const bool from = shift(known(widened.from), known(was->second.bounds)) == Shift::same;
      if (from && shift(known(line->second->bounds), known(gate.bounds)) == Shift::same)
        f.recorded = widened.date + ", " + widened.why;
    }
  }
}

Change overall(const Comparison& comparison) {
  return comparison.findings.empty() ? Change::same : comparison.findings.front().change;
}

int exit_status(const Comparison& comparison, const Snapshot& before, const Snapshot& after,
                const std::set<Change>& allowed) {
  if (!before.damaged.empty() || !after.damaged.empty()) return exit_files;
  static const std::set<Change> red{Change::worse, Change::widened, Change::missing, Change::inconclusive};
  const bool any = std::any_of(comparison.findings.begin(), comparison.findings.end(), [&](const Finding& f) {
    return red.count(f.change) > 0 && allowed.count(f.change) == 0 && f.recorded.empty();
  });
  return any ? exit_red : 0;
}

Json document(const Comparison& comparison, const Snapshot& before, const Snapshot& after) {
  Json counts = Json::object(), findings = Json::array(), machine = Json::array();
  for (const Change change : all_changes) counts[std::string(name(change))] = comparison.count(change);
  for (const Finding& f : comparison.findings) findings.push_back(to_json(f));
  for (const auto& [key, a, b] : comparison.machine) machine.push_back({{"key", key}, {"before", a}, {"after", b}});
  return {{"baseline", snapshot_document(before)},
          {"results", snapshot_document(after)},
          {"change", name(overall(comparison))},
          {"nothing_changed", comparison.nothing_changed()},
          {"summary", closing(comparison)},
          {"counts", counts},
          {"moved", comparison.moved()},
          {"largest_move", comparison.largest_move()},
          {"machine", machine},
          {"findings", findings}};
}

std::vector<std::string> table(const Comparison& comparison, const Snapshot& before, const Snapshot& after,
                               std::size_t most) {
  std::vector<std::string> lines{fmt::format("baseline {}\nresults  {}", source_words(before), source_words(after))};
  for (const auto& [key, a, b] : comparison.machine) lines.push_back(fmt::format("{} differs: {} / {}", key, a, b));
  add_damaged(before, lines);
  add_damaged(after, lines);
  for (const Change change : all_changes) {
    const std::size_t count = comparison.count(change);
    if (count == 0 || change == Change::same) continue;
    lines.push_back(heading(change, count));
    std::vector<std::string> found = lines_of(comparison.findings, change, most == 0);
    const std::size_t shown = most == 0 ? found.size() : std::min(most, found.size());
    lines.insert(lines.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(shown));
    if (shown < found.size()) lines.push_back(fmt::format("  ... and {} more lines (--all)", found.size() - shown));
  }
  if (comparison.count(Change::same) > 0) lines.push_back(same_words(comparison));
  lines.push_back(fmt::format("{} gates executed, {} in the baseline{}", comparison.gates_after,
                              comparison.gates_before,
                              comparison.gates_after < comparison.gates_before ? ": gates were dropped" : ""));
  lines.push_back(closing(comparison));
  return lines;
}

}  // namespace plumbline
