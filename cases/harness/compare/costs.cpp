#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/compare/parts.hpp"
#include "cases/harness/compare/two_samples.hpp"

namespace plumbline {
namespace {

Finding finding_of(const CostRecord& record) {
  Finding f;
  f.kind = "cost";
  f.case_name = record.case_name;
  f.scheme = record.scheme;
  f.study = record.study.empty() ? record.vary : record.study;
  f.quantity = "wall time in s";
  return f;
}

// The levels that both have, added up.
struct Sums {
  std::vector<double> before, after;  // one a sample
  double instructions_before = 0, instructions_after = 0;
  std::size_t levels = 0;
};

using Pair = std::pair<const CostRecord*, const CostRecord*>;

std::vector<Pair> common_levels(const std::vector<CostRecord>& before, const std::vector<CostRecord>& after) {
  std::vector<Pair> pairs;
  for (const CostRecord& a : before) {
    for (const CostRecord& b : after) {
      if (a.value == b.value && a.cells == b.cells) pairs.emplace_back(&a, &b);
    }
  }
  return pairs;
}

// One long run that was timed once would leave none of the others an interval.
void drop_rarely_timed(std::vector<Pair>& pairs) {
  const auto rare = [](const Pair& pair) {
    return std::min(pair.first->wall_s.size(), pair.second->wall_s.size()) < least_samples;
  };
  if (!std::all_of(pairs.begin(), pairs.end(), rare))
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), rare), pairs.end());
}

void add(std::vector<double>& sums, const std::vector<double>& samples, bool first) {
  if (first) {
    sums = samples;
    return;
  }
  sums.resize(std::min(sums.size(), samples.size()));
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += samples[k];
}

Sums common_sums(std::vector<Pair> pairs) {
  Sums sums;
  for (const auto& [a, b] : pairs) {
    if (!a->instructions || !b->instructions) continue;
    sums.instructions_before += *a->instructions;
    sums.instructions_after += *b->instructions;
  }
  drop_rarely_timed(pairs);
  for (const auto& [a, b] : pairs) {
    add(sums.before, a->wall_s, sums.levels == 0);
    add(sums.after, b->wall_s, sums.levels == 0);
    ++sums.levels;
  }
  return sums;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Change of_interval(const TimeRatio& ratio) {
  if (ratio.low > 1 + cost_share) return Change::worse;
  if (ratio.high < 1 / (1 + cost_share)) return Change::better;
  return ratio.high <= 1 + cost_share ? Change::same : Change::inconclusive;
}

bool usable(const std::vector<double>& times) {
  return !times.empty() && std::all_of(times.begin(), times.end(), [](double t) { return t > 0; });
}

Finding time_finding(const CostRecord& record, const Sums& sums) {
  Finding f = finding_of(record);
  f.equal = sums.before == sums.after;
  if (!usable(sums.before) || !usable(sums.after)) {
    f.change = Change::inconclusive;
    f.note = "no times that can be compared";
    return f;
  }
  const TimeRatio ratio = time_ratio(sums.before, sums.after);
  f.before = median(sums.before);
  f.after = median(sums.after);
  f.size = ratio.estimate;
  if (std::isfinite(ratio.high)) f.interval = {ratio.low, ratio.high};
  f.change = f.equal ? Change::same : of_interval(ratio);
  f.note = fmt::format("{} and {} samples", sums.before.size(), sums.after.size());
  if (!f.interval) f.note += fmt::format(", {} are needed for an interval", least_samples);
  return f;
}

// A count repeats, so it needs no interval; it does not see memory, so a time that is surely worse stays worse.
std::optional<Change> of_instructions(double ratio, Change of_time) {
  if (of_time == Change::worse) return {};
  if (ratio > 1 + instruction_share) return Change::worse;
  if (ratio < 1 / (1 + instruction_share)) return Change::better;
  return of_time == Change::inconclusive ? std::optional(Change::same) : std::nullopt;
}

void settle_by_instructions(const Sums& sums, Finding& f) {
  if (!(sums.instructions_before > 0)) return;
  const double ratio = sums.instructions_after / sums.instructions_before;
  const std::optional<Change> decided = of_instructions(ratio, f.change);
  if (!decided) {
    f.note += fmt::format("; instructions x {:.3f}", ratio);
    return;
  }
  f.note = fmt::format("{} {}", f.quantity, words(f));  // what decides leads
  f.quantity = "instructions";
  f.before = sums.instructions_before;
  f.after = sums.instructions_after;
  f.size = ratio;
  f.interval.reset();
  f.change = *decided;
}

void not_comparable(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings) {
  for (const auto& [key, value] : before.timed_machine) {
    const auto other = after.timed_machine.find(key);
    if (other == after.timed_machine.end() || other->second == value) continue;
    Finding f;
    f.kind = "machine";
    f.quantity = key;
    f.before = value;
    f.after = other->second;
    f.change = Change::inconclusive;
    f.note = "costs are not comparable";
    findings.push_back(std::move(f));
  }
}

void lone(const CostRecord& record, Change change, std::vector<Finding>& findings) {
  findings.push_back(finding_of(record));
  findings.back().change = change;
}

}  // namespace

void compare_costs(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings) {
  const std::size_t first = findings.size();
  not_comparable(before, after, findings);
  const bool comparable = findings.size() == first;
  for (const auto& [key, records] : before.costs) {
    const auto found = after.costs.find(key);
    const auto pairs = found == after.costs.end() ? std::vector<Pair>{} : common_levels(records, found->second);
    if (pairs.empty()) {
      lone(records.front(), Change::missing, findings);
    } else if (comparable) {
      const Sums sums = common_sums(pairs);
      findings.push_back(time_finding(records.front(), sums));
      settle_by_instructions(sums, findings.back());
    }
  }
  for (const auto& [key, records] : after.costs) {
    if (before.costs.count(key) == 0) lone(records.front(), Change::added, findings);
  }
}

}  // namespace plumbline
