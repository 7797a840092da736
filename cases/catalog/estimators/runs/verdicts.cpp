#include <cmath>
#include <limits>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/verdict/verdict.hpp"

namespace plumbline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct VerdictRow {
  const char* name;
  Gate gate;
  Measured measured;
  Verdict verdict;
};

Gate plain_gate(Range expected) {
  Gate gate;
  gate.id = "known";
  gate.quantity = "known";
  gate.expected = expected;
  gate.reason = "known";
  return gate;
}
Gate order_gate(Range expected) {
  Gate gate = plain_gate(expected);
  gate.order = true;
  return gate;
}
Gate failing(Gate gate, Range band) {
  gate.expected_failure = ExpectedFailure{"known", band, {}, {}};
  return gate;
}
Gate stopping(long low, long high) {
  Gate gate = plain_gate({{}, 1.0});
  gate.expected_failure = ExpectedFailure{"known", {}, StopBand{low, high, "volume"}, {}};
  return gate;
}

Measured known(double value, double bound, double scale) {
  Measured measured = Measured::of(value);
  measured.reference_bound = bound;
  measured.scale = scale;
  return measured;
}
Measured inconclusive_value(double value) {
  Measured measured = Measured::of(value);
  measured.inconclusive = true;
  return measured;
}
Measured within(double low, double value, double high) {
  Measured measured = Measured::of(value);
  measured.interval = {low, high};
  return measured;
}
Measured stopped_at(long step, const char* field) {
  Measured measured;
  measured.stopped = Measured::Stop{step, field};
  return measured;
}

std::vector<VerdictRow> rows_of_verdicts() {
  const Gate most = plain_gate({{}, 1.0}), least = plain_gate({1.0, {}}), both = plain_gate({1.0, 3.0});
  const Gate order = order_gate({1.0, {}}), low_order = order_gate({{}, 1.0});
  const Gate fails = failing(most, {2.0, 3.0}), order_fails = failing(order, {0.4, 0.6});
  const double rounding = std::numeric_limits<double>::epsilon();
  return {
      {"at_most_met", most, Measured::of(1), Verdict::pass},
      {"at_most_missed", most, Measured::of(1 + 1e-15), Verdict::fail},
      {"at_least_met", least, Measured::of(1), Verdict::pass},
      {"at_least_missed", least, Measured::of(1 - 1e-15), Verdict::fail},
      {"between_met", both, Measured::of(3), Verdict::pass},
      {"between_below", both, Measured::of(0.9), Verdict::fail},
      {"between_above", both, Measured::of(3.1), Verdict::fail},
      {"no_number", most, Measured::of(nan), Verdict::invalid},
      {"no_value", most, Measured{}, Verdict::invalid},
      {"invalid", most, Measured::failed("known"), Verdict::invalid},
      {"inconclusive", most, inconclusive_value(0.5), Verdict::inconclusive},
      // A reference may be off by 1 % of the tolerance, here half of what lies between the ends, or by 10 ulp of the scale.
      {"reference_good", both, known(2, 0.0099, 1), Verdict::pass},
      {"reference_bad", both, known(2, 0.0101, 1), Verdict::invalid},
      {"reference_rounded", plain_gate({0.0, 0.0}), known(0, 9.9 * rounding, 1), Verdict::pass},
      {"reference_not_rounded", plain_gate({0.0, 0.0}), known(0, 10.1 * rounding, 1), Verdict::invalid},
      {"expected_failure", fails, Measured::of(2.5), Verdict::xfail},
      {"fails_otherwise", fails, Measured::of(1.5), Verdict::fail},
      {"fails_more", fails, Measured::of(3.5), Verdict::fail},
      {"does_not_fail", fails, Measured::of(0.5), Verdict::xpass},
      {"order_met", order, within(1.1, 1.2, 1.3), Verdict::pass},
      {"order_missed", order, within(0.7, 0.8, 0.9), Verdict::fail},
      {"order_straddles", order, within(0.9, 1.1, 1.3), Verdict::inconclusive},
      {"order_below_met", low_order, within(0.7, 0.8, 0.9), Verdict::pass},
      {"order_below_missed", low_order, within(1.1, 1.2, 1.3), Verdict::fail},
      {"order_outside", order, within(1.1, 1.4, 1.3), Verdict::invalid},
      {"order_alone", order, Measured::of(1.2), Verdict::invalid},
      {"order_fails", order_fails, within(0.4, 0.5, 0.6), Verdict::xfail},
      {"order_fails_unsure", order_fails, within(0.0, 0.5, 1.1), Verdict::inconclusive},
      {"order_fails_otherwise", order_fails, within(0.0, 0.7, 1.1), Verdict::fail},
      {"stopped", most, stopped_at(7, "volume"), Verdict::fail},
      {"stops_first", stopping(7, 9), stopped_at(7, "volume"), Verdict::xfail},
      {"stops_last", stopping(7, 9), stopped_at(9, "volume"), Verdict::xfail},
      {"stops_early", stopping(7, 9), stopped_at(6, "volume"), Verdict::fail},
      {"stops_late", stopping(7, 9), stopped_at(10, "volume"), Verdict::fail},
      {"stops_elsewhere", stopping(7, 9), stopped_at(8, "density"), Verdict::fail}};
}

double number_of(Verdict verdict) { return static_cast<double>(verdict); }

}  // namespace

KnownAnswers verdict_answers() {
  KnownAnswers all;
  for (const VerdictRow& row : rows_of_verdicts()) {
    all.push_back({row.name, number_of(judge(row.gate, row.measured).verdict), number_of(row.verdict)});
  }
  // In units of the bound, or of half the width; of an order the interval's end next to the bound.
  for (const auto& [name, gate, measured, exact] :
       {std::tuple{"margin.at_most", plain_gate({{}, 4.0}), Measured::of(3), 0.25},
        {"margin.at_least", plain_gate({4.0, {}}), Measured::of(5), 0.25},
        {"margin.negative", plain_gate({{}, -4.0}), Measured::of(-5), 0.25},
        {"margin.low_half", plain_gate({1.0, 5.0}), Measured::of(1.5), 0.25},
        {"margin.high_half", plain_gate({1.0, 5.0}), Measured::of(4.5), 0.25},
        {"margin.missed", plain_gate({{}, 4.0}), Measured::of(5), -0.25},
        {"margin.order", order_gate({2.0, {}}), within(2.5, 3, 3.5), 0.25},
        {"margin.order_below", order_gate({{}, 2.0}), within(0.5, 1, 1.5), 0.25}}) {
    all.push_back({name, judge(gate, measured).margin.value_or(nan), exact});
  }
  const std::pair<const char*, Range> ranges[] = {{"holds.at_most", {{}, 1.0}},
                                                  {"holds.at_least", {1.0, {}}},
                                                  {"holds.between", {1.0, 3.0}},
                                                  {"holds.nothing", {}}};
  for (const auto& [name, range] : ranges) all.push_back({name, static_cast<double>(range.contains(nan)), 0});
  all.push_back({"holds.no_value", static_cast<double>(Range{}.contains(1)), 0});
  all.push_back({"margin.of_zero", static_cast<double>(margin({{}, 0.0}, 0).has_value()), 0});

  const Verdict pass = Verdict::pass, xfail = Verdict::xfail, unsure = Verdict::inconclusive, xpass = Verdict::xpass,
                fail = Verdict::fail, invalid = Verdict::invalid;
  std::vector<Verdict> growing{pass};
  for (const Verdict worse : {xfail, unsure, xpass, fail, invalid}) {
    growing.insert(growing.begin(), worse);
    all.push_back({"overall." + std::string(name(worse)), number_of(overall(growing)), number_of(worse)});
    all.push_back({"exit." + std::string(name(worse)), static_cast<double>(exit_status(growing, false)),
                   worse == xfail ? 0.0 : 1.0});
    all.push_back({"allowed." + std::string(name(worse)), static_cast<double>(exit_status(growing, true)),
                   worse == xfail || worse == unsure ? 0.0 : 1.0});
  }
  all.push_back({"exit.nothing", static_cast<double>(exit_status(std::vector<Verdict>{}, false)), 1});
  all.push_back({"overall.nothing", number_of(overall(std::vector<Verdict>{})), number_of(Verdict::none)});
  return all;
}

}  // namespace plumbline
