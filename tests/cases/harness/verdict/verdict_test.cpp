// Every branch of the verdict, and that a gate can fail.
#include "cases/harness/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "cases/harness/verdict/order.hpp"

namespace plumbline::verdict_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Gate gate(Range expected) {
  Gate result;
  result.id = "sod.error";
  result.quantity = "density.L1";
  result.expected = expected;
  result.reason = "as accurate as another method";
  return result;
}

Gate order_gate(Range expected) {
  Gate result = gate(expected);
  result.order = true;
  return result;
}

Gate failing(Gate result, Range band, const std::optional<StopBand>& stops = {}) {
  result.expected_failure = ExpectedFailure{"points of unequal mass at the contact", band, stops, {}};
  return result;
}

Measured value(double number) {
  Measured result;
  result.value = number;
  return result;
}

Measured order(double low, double number, double high) {
  Measured result = value(number);
  result.interval = {low, high};
  return result;
}

Measured stopped(long step, const std::string& field) {
  Measured result;
  result.stopped = Measured::Stop{step, field};
  return result;
}

Verdict verdict(const Gate& declared, const Measured& measured) { return judge(declared, measured).verdict; }

const Range at_most{{}, 0.007};
const Range at_least{2.0, {}};
const Range between{1.0, 3.0};

TEST(Verdict, NamesAreThoseOfTheResults) {
  const std::vector<std::string> verdicts{"PASS", "FAIL", "INCONCLUSIVE", "XFAIL", "XPASS", "INVALID", "NONE"};
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    EXPECT_EQ(name(all_verdicts[k]), verdicts[k]);
    EXPECT_EQ(verdict_from(verdicts[k]), all_verdicts[k]);
  }
  EXPECT_EQ(name(Verdict::xpass), "XPASS");
  EXPECT_EQ(name(Verdict::none), "NONE");
  EXPECT_FALSE(verdict_from("pass"));
  const std::vector<std::string> origins{"theory",   "literature",  "reference_bound",
                                         "identity", "requirement", "regression"};
  for (std::size_t k = 0; k < origins.size(); ++k) {
    EXPECT_EQ(name(all_origins[k]), origins[k]);
    EXPECT_EQ(origin_from(origins[k]), all_origins[k]);
  }
  EXPECT_EQ(name(Origin::reference_bound), "reference_bound");
  EXPECT_FALSE(origin_from("guess"));
  EXPECT_EQ(origin_from("frozen"), Origin::regression);  // until 0.8: files of the previous version
  EXPECT_EQ(origin_from("target"), Origin::requirement);
}

TEST(Verdict, ARangeBindsAtItsEndsAndHoldsNoNan) {
  EXPECT_TRUE(at_most.contains(0.007));
  EXPECT_TRUE(at_most.contains(-1));
  EXPECT_FALSE(at_most.contains(std::nextafter(0.007, 1)));
  EXPECT_TRUE(at_least.contains(2));
  EXPECT_FALSE(at_least.contains(std::nextafter(2, 0)));
  EXPECT_TRUE(between.contains(1));
  EXPECT_TRUE(between.contains(3));
  EXPECT_FALSE(between.contains(0.99));
  EXPECT_FALSE(between.contains(3.01));
  EXPECT_FALSE(Range{}.contains(0));
  for (const Range& range : {at_most, at_least, between}) EXPECT_FALSE(range.contains(nan));
}

TEST(Verdict, ValueGates) {
  EXPECT_EQ(verdict(gate(at_most), value(0.0066)), Verdict::pass);
  EXPECT_EQ(verdict(gate(at_most), value(0.007)), Verdict::pass);
  EXPECT_EQ(verdict(gate(at_most), value(0.0071)), Verdict::fail);
  EXPECT_EQ(verdict(gate(at_least), value(2)), Verdict::pass);
  EXPECT_EQ(verdict(gate(at_least), value(1.999)), Verdict::fail);
  EXPECT_EQ(verdict(gate(at_least), value(-2)), Verdict::fail);  // a swapped sign
  EXPECT_EQ(verdict(gate(between), value(2)), Verdict::pass);
  EXPECT_EQ(verdict(gate(between), value(0.9)), Verdict::fail);
  EXPECT_EQ(verdict(gate(between), value(3.1)), Verdict::fail);
  EXPECT_EQ(verdict(gate(between), value(-2)), Verdict::fail);
}

TEST(Verdict, MarginIsZeroAtTheBoundAndNegativeBeyond) {
  EXPECT_NEAR(*judge(gate(at_most), value(0.0066)).margin, 0.0571, 1e-4);  // the 0.06 of the format's example
  EXPECT_DOUBLE_EQ(*margin(at_most, 0), 1);
  EXPECT_DOUBLE_EQ(*margin(at_most, 0.007), 0);
  EXPECT_DOUBLE_EQ(*margin(at_most, 0.014), -1);
  EXPECT_DOUBLE_EQ(*margin(at_least, 3), 0.5);
  EXPECT_DOUBLE_EQ(*margin(at_least, 1), -0.5);
  EXPECT_DOUBLE_EQ(*margin(Range{-2.0, {}}, -1), 0.5);
  EXPECT_DOUBLE_EQ(*margin(Range{{}, -2.0}, -3), 0.5);
  EXPECT_DOUBLE_EQ(*margin(between, 2), 1);
  EXPECT_DOUBLE_EQ(*margin(between, 1.25), 0.25);
  EXPECT_DOUBLE_EQ(*margin(between, 2.75), 0.25);
  EXPECT_DOUBLE_EQ(*margin(between, 4), -1);
  EXPECT_FALSE(margin(Range{{}, 0.0}, 1));
  EXPECT_FALSE(margin(Range{5.0, 5.0}, 5));
  EXPECT_FALSE(margin(at_least, nan));
}

TEST(Verdict, OrderGatesJudgeTheInterval) {
  const Gate declared = order_gate({0.9, {}});
  EXPECT_EQ(verdict(declared, order(0.95, 1.0, 1.05)), Verdict::pass);
  EXPECT_EQ(verdict(declared, order(0.9, 1.0, 1.1)), Verdict::pass);
  EXPECT_EQ(verdict(declared, order(0.85, 1.0, 1.15)),
            Verdict::inconclusive);  // though the estimate is above
  EXPECT_EQ(verdict(declared, order(0.7, 0.8, 0.9)), Verdict::inconclusive);
  EXPECT_EQ(verdict(declared, order(0.6, 0.7, 0.8)), Verdict::fail);
  EXPECT_EQ(verdict(declared, order(-1.05, -1.0, -0.95)), Verdict::fail);  // a swapped sign
  EXPECT_EQ(verdict(declared, order(-infinity, 1, infinity)), Verdict::inconclusive);
  const Gate upper = order_gate({{}, 1.2});
  EXPECT_EQ(verdict(upper, order(0.9, 1.0, 1.1)), Verdict::pass);
  EXPECT_EQ(verdict(upper, order(1.1, 1.2, 1.3)), Verdict::inconclusive);
  EXPECT_EQ(verdict(upper, order(1.3, 1.4, 1.5)), Verdict::fail);
}

TEST(Verdict, MarginOfAnOrderGateIsThatOfTheIntervalsEnd) {
  EXPECT_DOUBLE_EQ(*judge(order_gate({0.8, {}}), order(1.0, 1.1, 1.2)).margin, 0.25);
  EXPECT_LT(*judge(order_gate({0.8, {}}), order(0.7, 0.9, 1.1)).margin, 0);
  EXPECT_LT(*judge(order_gate({0.8, {}}), order(0.4, 0.5, 0.6)).margin, 0);
  EXPECT_DOUBLE_EQ(*judge(order_gate({{}, 2.0}), order(0.5, 1.0, 1.5)).margin, 0.25);
}

TEST(Verdict, WhatWasNotMeasuredIsInvalid) {
  EXPECT_EQ(verdict(gate(at_most), Measured{}), Verdict::invalid);
  for (double wrong : {nan, infinity, -infinity}) {
    EXPECT_EQ(verdict(gate(at_most), value(wrong)), Verdict::invalid);
    EXPECT_EQ(verdict(gate(between), value(wrong)), Verdict::invalid);
    EXPECT_EQ(verdict(failing(gate(at_most), {0.02, 0.03}), value(wrong)), Verdict::invalid);
  }
  EXPECT_EQ(verdict(order_gate({0.9, {}}), value(1)), Verdict::invalid);  // no interval
  EXPECT_EQ(verdict(order_gate({0.9, {}}), order(nan, 1, nan)), Verdict::invalid);
  EXPECT_EQ(verdict(order_gate({0.9, {}}), order(1.1, 1.0, 0.9)), Verdict::invalid);  // swapped ends
  EXPECT_EQ(verdict(order_gate({0.9, {}}), order(1.1, 1.0, 1.2)),
            Verdict::invalid);  // another run's interval
  Measured broken = value(0.001);
  broken.invalid = true;
  broken.note = "the run file is damaged";
  EXPECT_EQ(verdict(gate(at_most), broken), Verdict::invalid);
  EXPECT_EQ(judge(gate(at_most), broken).note, "the run file is damaged");
  broken.inconclusive = true;
  EXPECT_EQ(verdict(gate(at_most), broken), Verdict::invalid);
}

TEST(Verdict, TooLittleDataIsInconclusive) {
  Measured few = order(0.95, 1.0, 1.05);
  few.inconclusive = true;
  EXPECT_EQ(verdict(order_gate({0.9, {}}), few), Verdict::inconclusive);
  EXPECT_EQ(verdict(failing(order_gate({0.9, {}}), {0.1, 0.5}), few), Verdict::inconclusive);
  few.interval = {nan, nan};
  EXPECT_EQ(verdict(order_gate({0.9, {}}), few), Verdict::invalid);
  few.value = nan;
  few.interval.reset();
  EXPECT_EQ(verdict(order_gate({0.9, {}}), few), Verdict::invalid);
}

TEST(Verdict, AReferenceMustBeGoodEnough) {
  Measured measured = value(0.003);
  measured.reference_bound = 0.00007;  // 1 % of the tolerance 0.007
  EXPECT_EQ(verdict(gate({{}, 0.007}), measured), Verdict::pass);
  measured.reference_bound = 0.000071;
  EXPECT_EQ(verdict(gate({{}, 0.007}), measured), Verdict::invalid);
  EXPECT_EQ(verdict(failing(gate({{}, 0.002}), {0.0025, 0.004}), measured), Verdict::invalid);
  measured = value(2);
  measured.reference_bound = 0.01;  // 1 % of the half width 1
  EXPECT_EQ(verdict(gate(between), measured), Verdict::pass);
  measured.reference_bound = 0.0101;
  EXPECT_EQ(verdict(gate(between), measured), Verdict::invalid);
  for (double wrong : {nan, infinity, -1e-3}) {
    measured.reference_bound = wrong;
    EXPECT_EQ(verdict(gate(between), measured), Verdict::invalid) << wrong;
  }
  measured.reference_bound = nan;
  EXPECT_EQ(judge(gate(between), measured).note, "the reference has no error bound");
}

TEST(Verdict, TenUlpOfTheScaleExcuseAReference) {
  const double ulp = std::numeric_limits<double>::epsilon();  // of 1
  Measured measured = value(1e-16);
  measured.scale = 1;
  measured.reference_bound = 10 * ulp;
  EXPECT_EQ(verdict(gate({{}, 1e-14}), measured), Verdict::pass);
  EXPECT_EQ(verdict(gate({{}, 0.0}),
                    [&] {
                      Measured exact = measured;
                      exact.value = 0;
                      return exact;
                    }()),
            Verdict::pass);  // an identity leaves no tolerance at all
  measured.reference_bound = 10.1 * ulp;
  EXPECT_EQ(verdict(gate({{}, 1e-14}), measured), Verdict::invalid);
  measured.scale = -4;
  EXPECT_EQ(verdict(gate({{}, 1e-14}), measured), Verdict::pass);
  measured.scale = nan;
  EXPECT_EQ(verdict(gate({{}, 1e-14}), measured), Verdict::invalid);
  measured.reference_bound = 0;
  EXPECT_EQ(verdict(gate({{}, 1e-14}), measured), Verdict::invalid);
}

TEST(Verdict, AnExpectedFailureIsAsserted) {
  const Gate declared = failing(gate(at_most), {0.02, 0.03});
  EXPECT_EQ(verdict(declared, value(0.025)), Verdict::xfail);
  EXPECT_EQ(verdict(declared, value(0.02)), Verdict::xfail);
  EXPECT_EQ(verdict(declared, value(0.03)), Verdict::xfail);
  EXPECT_EQ(verdict(declared, value(0.031)), Verdict::fail);    // worse than known
  EXPECT_EQ(verdict(declared, value(0.019)), Verdict::fail);    // better than known, and still not met
  EXPECT_EQ(verdict(declared, value(-0.025)), Verdict::xpass);  // met
  EXPECT_EQ(verdict(declared, value(0.006)), Verdict::xpass);
  EXPECT_LT(*judge(declared, value(0.025)).margin, 0);
  const Gate open = failing(gate({{}, 0.6}), {1.3, {}});
  EXPECT_EQ(verdict(open, value(1.4)), Verdict::xfail);
  EXPECT_EQ(verdict(open, value(1.2)), Verdict::fail);
  const Gate overlapping = failing(gate(at_most), {0.006, 0.03});
  EXPECT_EQ(verdict(overlapping, value(0.0065)), Verdict::xpass);  // met comes first
}

TEST(Verdict, AnExpectedFailureOfAnOrder) {
  const Gate declared = failing(order_gate({0.9, {}}), {-0.3, 0.3});
  EXPECT_EQ(verdict(declared, order(-0.1, 0.1, 0.3)), Verdict::xfail);
  EXPECT_EQ(verdict(declared, order(0.3, 0.5, 0.7)), Verdict::fail);
  EXPECT_EQ(verdict(declared, order(0.95, 1.0, 1.05)), Verdict::xpass);
  EXPECT_EQ(verdict(declared, order(-0.9, 0.1, 1.1)), Verdict::inconclusive);  // failure not established
  EXPECT_EQ(verdict(declared, order(0.2, 0.7, 1.2)), Verdict::fail);
}

TEST(Verdict, AStoppedRun) {
  const Gate plain = gate(at_most);
  const Gate band_only = failing(plain, {0.02, 0.03});
  const Gate stopping = failing(plain, {}, StopBand{100, 200, "density"});
  EXPECT_EQ(verdict(plain, stopped(150, "density")), Verdict::fail);
  EXPECT_EQ(verdict(band_only, stopped(150, "density")), Verdict::fail);
  for (long step : {100, 150, 200}) EXPECT_EQ(verdict(stopping, stopped(step, "density")), Verdict::xfail);
  EXPECT_EQ(verdict(stopping, stopped(99, "density")), Verdict::fail);
  EXPECT_EQ(verdict(stopping, stopped(201, "density")), Verdict::fail);
  EXPECT_EQ(verdict(stopping, stopped(150, "energy")), Verdict::fail);
  EXPECT_EQ(verdict(stopping, value(0.001)), Verdict::xpass);
  EXPECT_EQ(verdict(stopping, value(0.025)), Verdict::fail);  // ran through, but wrong
  Measured early = stopped(150, "density");
  early.value = 0.001;  // whatever it measured on the way, it did not finish
  EXPECT_EQ(verdict(plain, early), Verdict::fail);
  early.value = nan;
  EXPECT_EQ(verdict(stopping, early), Verdict::xfail);
  EXPECT_EQ(judge(plain, stopped(150, "density")).note, "stopped at step 150 in field density");
}

TEST(Verdict, DeclarationsAreChecked) {
  EXPECT_NO_THROW(validate(gate(at_most)));
  EXPECT_NO_THROW(validate(gate({5.0, 5.0})));
  std::vector<Gate> wrong{gate({}), gate({nan, {}}), gate({{}, infinity}), gate({3.0, 1.0}), order_gate(between)};
  wrong.push_back(gate(at_most));
  wrong.back().reason.clear();
  wrong.push_back(gate(at_most));
  wrong.back().id.clear();
  wrong.push_back(gate(at_most));
  wrong.back().quantity.clear();
  for (const Gate& declared : wrong) {
    EXPECT_THROW(validate(declared), std::invalid_argument);
    EXPECT_THROW(judge(declared, value(0.001)), std::invalid_argument);
  }
}

TEST(Verdict, ARegressionGateOnAStoredMeasurementIsTwoSidedWithDateAndCommit) {
  Gate stored = gate(between);
  stored.origin = Origin::regression;
  for (const char* stamp :
       {"", "2026-11-21", "2026-11-21 ", "2026-11-21 a1b2c3", "a1b2c3d", "21 November a1b2c3d", "2026-11-21 main"}) {
    stored.measured_on = stamp;
    EXPECT_THROW(validate(stored), std::invalid_argument) << stamp;
  }
  stored.measured_on = "2026-11-21 a1b2c3d";
  EXPECT_NO_THROW(validate(stored));
  for (const Range& one_sided : {at_most, at_least}) {
    stored.expected = one_sided;
    EXPECT_THROW(validate(stored), std::invalid_argument);
  }
}

TEST(Verdict, ARegressionGateOnAReferenceRunIsOneSided) {
  for (const Range& one_sided : {at_most, at_least}) {
    Gate beside = gate(one_sided);
    beside.origin = Origin::regression;
    EXPECT_NO_THROW(validate(beside));
    beside.measured_on = "some day";
    EXPECT_THROW(validate(beside), std::invalid_argument);
    beside.measured_on.clear();
    beside.reason.clear();  // where the factor is said
    EXPECT_THROW(validate(beside), std::invalid_argument);
  }
}

TEST(Verdict, ExpectedFailuresAreChecked) {
  EXPECT_NO_THROW(validate(failing(gate(at_most), {0.02, 0.03})));
  EXPECT_NO_THROW(validate(failing(gate(at_most), {0.02, {}})));
  EXPECT_NO_THROW(validate(failing(gate(at_most), {}, StopBand{0, 0, "density"})));
  EXPECT_THROW(validate(failing(gate(at_most), {})), std::invalid_argument);
  EXPECT_THROW(validate(failing(gate(at_most), {0.03, 0.02})), std::invalid_argument);
  EXPECT_THROW(validate(failing(gate(at_most), {0.02, nan})), std::invalid_argument);
  EXPECT_THROW(validate(failing(gate(at_most), {0.001, 0.002})), std::invalid_argument);  // cannot fail there
  EXPECT_THROW(validate(failing(gate(at_most), {}, StopBand{0, 9, ""})), std::invalid_argument);
  EXPECT_THROW(validate(failing(gate(at_most), {}, StopBand{9, 0, "density"})), std::invalid_argument);
  EXPECT_THROW(validate(failing(gate(at_most), {}, StopBand{-1, 9, "density"})), std::invalid_argument);
  Gate declared = failing(gate(at_most), {0.02, 0.03});
  declared.expected_failure->measured_on = "some day";
  EXPECT_THROW(validate(declared), std::invalid_argument);
  declared.expected_failure->measured_on = "2026-11-21 a1b2c3d";
  EXPECT_NO_THROW(validate(declared));
  declared.expected_failure->cause.clear();
  EXPECT_THROW(validate(declared), std::invalid_argument);
}

std::vector<Level> study(std::vector<double> errors) {
  std::vector<Level> levels(errors.size());
  for (std::size_t k = 0; k < errors.size(); ++k) {
    levels[k].h = std::pow(0.5, static_cast<double>(k));
    levels[k].error = errors[k];
  }
  return levels;
}

Verdict verdict_of(const std::vector<double>& errors, double bound) {
  return verdict(order_gate({bound, {}}), measured_order(fit_order(study(errors), Weighting::equal)));
}

TEST(Verdict, FromTheFitToTheVerdict) {
  EXPECT_EQ(verdict_of({16, 8, 4, 2, 1}, 0.9), Verdict::pass);
  EXPECT_EQ(verdict_of({16, 8, 4, 2, 1}, 1.9), Verdict::fail);
  EXPECT_EQ(verdict_of({16, 8, 4, 2}, 0.9), Verdict::inconclusive);  // four levels
  EXPECT_EQ(verdict_of({16, 8}, 0.9), Verdict::inconclusive);
  EXPECT_EQ(verdict_of({16}, 0.9), Verdict::inconclusive);
  EXPECT_EQ(verdict_of({}, 0.9), Verdict::invalid);
  EXPECT_EQ(verdict_of({16, 8, nan, 2, 1}, 0.9), Verdict::invalid);
  EXPECT_EQ(verdict_of({16, 8, 4, 2, -1}, 0.9), Verdict::invalid);         // an error with a swapped sign
  EXPECT_EQ(verdict_of({1, 2, 4, 8, 16}, 0.9), Verdict::fail);             // diverges
  EXPECT_NE(verdict_of({1024, 256, 64, 16, 16, 16}, 1.9), Verdict::pass);  // the finest grids stall
  EXPECT_EQ(verdict_of({16, 8, 80, 2, 1}, 0.9), Verdict::inconclusive);    // junk in the middle
  EXPECT_TRUE(measured_order(fit_order({}, Weighting::equal)).invalid);
  EXPECT_EQ(measured_order(fit_order({}, Weighting::equal)).note, "no levels");
  const Measured stalled = measured_order(fit_order(study({1024, 256, 64, 16, 16, 16}), Weighting::equal));
  EXPECT_NE(stalled.note.find("not asymptotic"), std::string::npos);
}

TEST(Verdict, CountsAndExitStatus) {
  const std::vector<Verdict> all(all_verdicts.begin(), all_verdicts.end());
  const std::vector<Verdict> several{Verdict::pass, Verdict::pass, Verdict::xfail};
  EXPECT_EQ(tally(several)[Verdict::pass], 2u);
  EXPECT_EQ(tally(several)[Verdict::xfail], 1u);
  EXPECT_EQ(tally(several)[Verdict::fail], 0u);
  EXPECT_EQ(tally(all).total(), 7u);
  EXPECT_EQ(exit_status(several, false), 0);
  EXPECT_EQ(exit_status({}, true), 1);  // nothing judged is not green
  for (Verdict one : all_verdicts) {
    const std::vector<Verdict> set{Verdict::pass, one};
    const bool green = one == Verdict::pass || one == Verdict::xfail || one == Verdict::none;
    EXPECT_EQ(exit_status(set, false), green ? 0 : 1) << name(one);
    EXPECT_EQ(exit_status(set, true), green || one == Verdict::inconclusive ? 0 : 1) << name(one);
  }
}

TEST(Verdict, TheWorstDecidesTheWhole) {
  EXPECT_EQ(overall({}), Verdict::none);
  const std::vector<Verdict> rising{Verdict::none,  Verdict::pass, Verdict::xfail,  Verdict::inconclusive,
                                    Verdict::xpass, Verdict::fail, Verdict::invalid};
  for (std::size_t k = 0; k < rising.size(); ++k)
    EXPECT_EQ(overall(std::span(rising).first(k + 1)), rising[k]) << name(rising[k]);
}

}  // namespace
}  // namespace plumbline::verdict_test
