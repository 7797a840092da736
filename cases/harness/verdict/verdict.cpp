#include "cases/harness/verdict/verdict.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/harness/verdict/order.hpp"

namespace plumbline {
namespace {

constexpr double reference_share_of_tolerance = 0.01;
constexpr double reference_ulps = 10;

constexpr std::array<std::string_view, all_verdicts.size()> verdict_names{"PASS",  "FAIL",    "INCONCLUSIVE", "XFAIL",
                                                                          "XPASS", "INVALID", "NONE"};
constexpr std::array<std::string_view, all_origins.size()> origin_names{"theory",   "literature",  "reference_bound",
                                                                        "identity", "requirement", "regression"};

std::string text(double value) {  // the same under every locale
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

bool has_end(const Range& range) { return range.low || range.high; }

bool is_ordered(const Range& range) {
  const bool finite = std::isfinite(range.low.value_or(0)) && std::isfinite(range.high.value_or(0));
  return finite && (!range.low || !range.high || *range.low <= *range.high);
}

// Every value of `inner` lies in `outer`.
bool covers(const Range& outer, const Range& inner) {
  const bool low = !outer.low || (inner.low && *inner.low >= *outer.low);
  const bool high = !outer.high || (inner.high && *inner.high <= *outer.high);
  return low && high;
}

// "2026-11-21 a1b2c3d": a date, then at least seven hexadecimal digits.
bool has_date_and_commit(std::string_view stamp) {
  constexpr std::string_view date = "dddd-dd-dd ", digits = "0123456789", hexadecimal = "0123456789abcdef";
  if (stamp.size() < date.size() + 7) return false;
  for (std::size_t k = 0; k < date.size(); ++k)
    if (date[k] == 'd' ? digits.find(stamp[k]) == std::string_view::npos : stamp[k] != date[k]) return false;
  return stamp.find_first_not_of(hexadecimal, date.size()) == std::string_view::npos;
}

std::string defect(const Range& expected, const ExpectedFailure& failure) {
  if (failure.cause.empty()) return "its expected failure names no cause";
  if (!has_end(failure.band) && !failure.stops) return "its expected failure has neither band nor stop";
  if (!is_ordered(failure.band)) return "the band of its expected failure is not finite or its ends are swapped";
  if (has_end(failure.band) && covers(expected, failure.band))
    return "the band of its expected failure lies wholly inside the expected range";
  if (!failure.measured_on.empty() && !has_date_and_commit(failure.measured_on))
    return "the band of its expected failure lacks date and commit";
  if (!failure.stops) return {};
  if (failure.stops->field.empty()) return "the stop of its expected failure names no field";
  if (failure.stops->step_low < 0 || failure.stops->step_low > failure.stops->step_high)
    return "the steps of its expected stop are negative or swapped";
  return {};
}

// A stored number may drift either way and says where it comes from; what a run beside it gives is stored nowhere.
std::string defect_of_regression(const Gate& gate) {
  if (gate.origin != Origin::regression) return {};
  const bool two_sided = gate.expected.low && gate.expected.high;
  if (gate.measured_on.empty())
    return two_sided ? "a two-sided regression gate needs date and commit of its measurement" : "";
  if (!has_date_and_commit(gate.measured_on)) return "the measurement of a regression gate needs date and commit";
  return two_sided ? "" : "a regression gate with a stored measurement is two-sided";
}

std::string defect(const Gate& gate) {
  const Range& expected = gate.expected;
  if (gate.id.empty() || gate.quantity.empty()) return "it lacks an id or a quantity";
  if (gate.reason.empty()) return "it gives no reason for its number";
  if (!has_end(expected)) return "it expects nothing: neither low nor high";
  if (!is_ordered(expected)) return "its ends are not finite or swapped";
  const bool two_sided = expected.low && expected.high;
  if (gate.order && two_sided) return "an order gate has exactly one bound";
  if (std::string why = defect_of_regression(gate); !why.empty()) return why;
  return gate.expected_failure ? defect(expected, *gate.expected_failure) : std::string{};
}

std::string why_reference_unfit(const Gate& gate, const Measured& measured) {
  if (gate.order) return {};
  if (!std::isfinite(measured.reference_bound) || measured.reference_bound < 0)
    return "the reference has no error bound";
  if (!std::isfinite(measured.scale)) return "the scale is not a number";
  const double scale = std::abs(measured.scale);
  const double ulp = std::nextafter(scale, std::numeric_limits<double>::infinity()) - scale;
  const double share = reference_share_of_tolerance * tolerance(gate.expected);
  if (measured.reference_bound <= share || measured.reference_bound <= reference_ulps * ulp) return {};
  return "the bound of the reference, " + text(measured.reference_bound) + ", is above 1 % of the tolerance " +
         text(tolerance(gate.expected));
}

std::string why_not_a_number(const Measured& measured) {
  if (measured.value && !std::isfinite(*measured.value)) return "the value is not a number";
  if (measured.interval && (std::isnan(measured.interval->first) || std::isnan(measured.interval->second)))
    return "the interval is not a number";
  return {};
}

std::string why_incomplete(const Gate& gate, const Measured& measured) {
  if (!measured.value) return "no value was measured";
  if (!gate.order) return {};
  if (!measured.interval) return "no interval was measured";
  if (!(measured.interval->first <= *measured.value && *measured.value <= measured.interval->second))
    return "the value lies outside its own interval";
  return {};
}

Judgement judge_stop(const Gate& gate, const Measured::Stop& stop) {
  const std::string what = "stopped at step " + std::to_string(stop.step) + " in field " + stop.field;
  if (!gate.expected_failure || !gate.expected_failure->stops) return {Verdict::fail, {}, what};
  const StopBand& band = *gate.expected_failure->stops;
  const bool expected = stop.field == band.field && band.step_low <= stop.step && stop.step <= band.step_high;
  if (expected) return {Verdict::xfail, {}, what};
  return {Verdict::fail,
          {},
          what + ", expected between step " + std::to_string(band.step_low) + " and " + std::to_string(band.step_high) +
              " in field " + band.field};
}

// Of an interval: the end that decides whether an order gate is met, and the one that decides whether it is
// missed. A value has both in one.
struct Ends {
  double next_to_bound, far;
};
Ends ends(const Gate& gate, const Measured& measured) {
  if (!gate.order) return {*measured.value, *measured.value};
  const auto [low, high] = *measured.interval;
  return gate.expected.low ? Ends{low, high} : Ends{high, low};
}

Judgement judge_numbers(const Gate& gate, const Measured& measured) {
  const auto [next_to_bound, far] = ends(gate, measured);
  const bool met = gate.expected.contains(next_to_bound);
  const bool straddles = !met && gate.expected.contains(far);
  Judgement judgement{Verdict::pass, margin(gate.expected, next_to_bound), measured.note};
  const auto& failure = gate.expected_failure;
  const bool as_expected = failure && failure->band.contains(*measured.value);
  if (met)
    judgement.verdict = failure ? Verdict::xpass : Verdict::pass;
  else if (straddles && (!failure || as_expected))
    judgement.verdict = Verdict::inconclusive;
  else
    judgement.verdict = as_expected ? Verdict::xfail : Verdict::fail;
  return judgement;
}

// Worst first.
constexpr std::array severity{Verdict::invalid,      Verdict::fail,  Verdict::xpass,
                              Verdict::inconclusive, Verdict::xfail, Verdict::pass};

}  // namespace

std::string_view name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }
std::string_view name(Origin origin) { return origin_names[static_cast<std::size_t>(origin)]; }

std::optional<Verdict> verdict_from(std::string_view wanted) {
  for (Verdict verdict : all_verdicts)
    if (name(verdict) == wanted) return verdict;
  return {};
}

std::optional<Origin> origin_from(std::string_view wanted) {
  if (wanted == "frozen") return Origin::regression;   // until 0.8: what files of the previous version call it
  if (wanted == "target") return Origin::requirement;  // likewise
  for (Origin origin : all_origins)
    if (name(origin) == wanted) return origin;
  return {};
}

bool Range::contains(double value) const {
  return has_end(*this) && !std::isnan(value) && (!low || value >= *low) && (!high || value <= *high);
}

Measured Measured::of(double value) {
  Measured measured;
  measured.value = value;
  return measured;
}

Measured Measured::failed(std::string note) {
  Measured measured;
  measured.invalid = true;
  measured.note = std::move(note);
  return measured;
}

Measured measured_order(const OrderFit& fit) {
  Measured measured;
  measured.invalid = fit.invalid;
  measured.inconclusive = !fit.invalid && !fit.usable;
  if (std::isfinite(fit.order)) measured.value = fit.order;
  if (measured.value) measured.interval = {fit.low, fit.high};
  measured.note = fit.usable && !fit.asymptotic ? "the levels are not asymptotic" : fit.reason;
  return measured;
}

void validate(const Gate& gate) {
  if (const std::string why = defect(gate); !why.empty()) throw std::invalid_argument("gate '" + gate.id + "': " + why);
}

double tolerance(const Range& expected) {
  if (expected.low && expected.high) return (*expected.high - *expected.low) / 2;
  return std::abs(expected.low ? *expected.low : expected.high.value_or(0));
}

std::optional<double> margin(const Range& expected, double value) {
  const double unit = tolerance(expected);
  if (!(unit > 0) || !std::isfinite(value)) return {};
  const double infinity = std::numeric_limits<double>::infinity();
  const double above = expected.low ? value - *expected.low : infinity;
  const double below = expected.high ? *expected.high - value : infinity;
  return std::min(above, below) / unit;
}

Judgement judge(const Gate& gate, const Measured& measured) {
  validate(gate);
  if (measured.invalid) return {Verdict::invalid, {}, measured.note};
  if (measured.stopped) return judge_stop(gate, *measured.stopped);
  for (const std::string& why : {why_reference_unfit(gate, measured), why_not_a_number(measured)})
    if (!why.empty()) return {Verdict::invalid, {}, why};
  if (measured.inconclusive) return {Verdict::inconclusive, {}, measured.note};
  if (const std::string why = why_incomplete(gate, measured); !why.empty()) return {Verdict::invalid, {}, why};
  return judge_numbers(gate, measured);
}

std::size_t Counts::total() const {
  std::size_t sum = 0;
  for (std::size_t count : by_verdict) sum += count;
  return sum;
}

Counts tally(std::span<const Verdict> verdicts) {
  Counts counts;
  for (Verdict verdict : verdicts) ++counts.by_verdict[static_cast<std::size_t>(verdict)];
  return counts;
}

Verdict overall(std::span<const Verdict> verdicts) {
  const Counts counts = tally(verdicts);
  for (Verdict verdict : severity)
    if (counts[verdict] > 0) return verdict;
  return Verdict::none;
}

int exit_status(std::span<const Verdict> verdicts, bool allow_inconclusive) {
  const Counts counts = tally(verdicts);
  const std::size_t green = counts[Verdict::pass] + counts[Verdict::xfail] + counts[Verdict::none] +
                            (allow_inconclusive ? counts[Verdict::inconclusive] : 0);
  return verdicts.empty() || green != counts.total() ? 1 : 0;
}

}  // namespace plumbline
