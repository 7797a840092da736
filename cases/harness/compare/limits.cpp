#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/compare/parts.hpp"

namespace plumbline {
namespace {

Finding finding_of(const LimitRecord& record, const std::string& quantity) {
  Finding f;
  f.kind = "limit";
  f.case_name = record.problem;
  f.scheme = record.integrator;
  f.study = record.settings;
  f.quantity = quantity;
  return f;
}

// The largest step up to which all are stable; 0 where none is.
double limit(const LimitRecord& record) {
  if (record.always == "stable") return unbounded;
  if (record.always == "unstable" || record.predicted.empty()) return 0;
  return record.predicted.front().high.value_or(unbounded);
}

// All stable steps together, as far as both intervals are bounded.
double total(const LimitRecord& record) {
  double sum = 0;
  for (const Range& stable : record.predicted) {
    if (stable.high) sum += *stable.high - stable.low.value_or(0);
  }
  return sum;
}

Json step_json(double value) { return std::isfinite(value) ? Json(value) : Json("every step"); }

Change larger_is_better(double before, double after, double share) {
  if (before == after) return Change::same;
  if (std::isfinite(before) && std::isfinite(after) && std::abs(after - before) <= share * std::max(before, after))
    return Change::same;
  return after > before ? Change::better : Change::worse;
}

Finding predicted_finding(const LimitRecord& before, const LimitRecord& after) {
  Finding f = finding_of(before, "predicted limit in " + before.unit);
  const bool known_before = !before.predicted.empty() || !before.always.empty();
  const bool known_after = !after.predicted.empty() || !after.always.empty();
  if (!known_before || !known_after) {
    f.change = known_before ? Change::missing : known_after ? Change::added : Change::same;
    f.note = known_before ? "no limit is predicted any more" : "";
    return f;
  }
  const double a = limit(before), b = limit(after);
  f.before = step_json(a);
  f.after = step_json(b);
  f.change = larger_is_better(a, b, limit_share);
  if (std::isfinite(a) && std::isfinite(b) && a > 0) f.size = b / a - 1;
  f.equal = a == b || std::abs(b - a) <= equal_share * a;
  if (f.change != Change::same || before.predicted.size() + after.predicted.size() <= 2) return f;
  f.change = larger_is_better(total(before), total(after), limit_share);
  f.note = fmt::format("stable steps in {} and {} intervals, {:.6g} and {:.6g} in all", before.predicted.size(),
                       after.predicted.size(), total(before), total(after));
  return f;
}

Finding observed_finding(const LimitRecord& before, const LimitRecord& after) {
  Finding f = finding_of(before, "observed limit in " + before.unit);
  if (before.observed.empty() || after.observed.empty()) {
    if (before.observed.size() != after.observed.size())
      f.change = after.observed.empty() ? Change::missing : Change::added;
    return f;
  }
  const Range &a = before.observed.front(), &b = after.observed.front();
  f.before = range_json(a);
  f.after = range_json(b);
  f.equal = a.low == b.low && a.high == b.high;
  if (b.high.value_or(unbounded) < a.low.value_or(0)) f.change = Change::worse;
  if (b.low.value_or(0) > a.high.value_or(unbounded)) f.change = Change::better;
  if (f.change == Change::same && before.observed.size() != after.observed.size()) {
    f.equal = false;
    f.change = after.observed.size() > before.observed.size() ? Change::worse : Change::better;
    f.note = fmt::format("{} brackets before, {} now", before.observed.size(), after.observed.size());
  }
  return f;
}

// The studies of oscillators have the same steps: half the width of the difference's interval follows from both.
Finding order_finding(const LimitRecord& record, const std::string& quantity, const FitRecord& a, const FitRecord* b) {
  Finding f = finding_of(record, "order of " + quantity);
  f.kind = "order";
  f.before = a.order ? Json(*a.order) : Json(nullptr);
  if (!b || !b->order || !a.order) {
    f.change = a.order && !(b && b->order) ? Change::missing : Change::same;
    return f;
  }
  f.after = *b->order;
  const auto half = [](const FitRecord& fit) { return (fit.high.value_or(unbounded) - fit.low.value_or(0)) / 2; };
  const double difference = *b->order - *a.order, width = std::hypot(half(a), half(*b));
  f.size = difference;
  f.interval = {difference - width, difference + width};
  f.equal = std::abs(difference) <= equal_share;
  if (std::abs(difference) <= order_difference) return f;
  f.change = std::abs(difference) <= width ? Change::inconclusive : difference > 0 ? Change::better : Change::worse;
  return f;
}

}  // namespace

void compare_limits(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings) {
  for (const auto& [key, record] : before.limits) {
    const auto found = after.limits.find(key);
    if (found == after.limits.end()) {
      findings.push_back(finding_of(record, "limit in " + record.unit));
      findings.back().change = Change::missing;
      continue;
    }
    findings.push_back(predicted_finding(record, found->second));
    findings.push_back(observed_finding(record, found->second));
    for (const auto& [quantity, fit] : record.orders) {
      const auto other = found->second.orders.find(quantity);
      findings.push_back(
          order_finding(record, quantity, fit, other == found->second.orders.end() ? nullptr : &other->second));
    }
  }
  for (const auto& [key, record] : after.limits) {
    if (before.limits.count(key) > 0) continue;
    findings.push_back(finding_of(record, "limit in " + record.unit));
    findings.back().change = Change::added;
  }
}

}  // namespace plumbline
