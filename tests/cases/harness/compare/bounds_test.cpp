#include "cases/harness/compare/bounds.hpp"

#include <gtest/gtest.h>

namespace plumbline::bounds_test {
namespace {

Bounds expected(std::optional<double> low, std::optional<double> high) { return {{low, high}, {}, {}, false}; }

Bounds failing(Bounds bounds, double low, double high) {
  bounds.band = Range{low, high};
  return bounds;
}

TEST(Shift, OfEqualBoundsIsNone) {
  EXPECT_EQ(shift(expected(0.9, 1.1), expected(0.9, 1.1)), Shift::same);
  EXPECT_EQ(shift(expected({}, 0.007), expected({}, 0.007 * (1 + 1e-14))), Shift::same) << "another compiler";
  EXPECT_EQ(shift(expected(0.0, 0.0), expected(0.0, 0.0)), Shift::same);
}

TEST(Shift, AnEndFurtherOutIsWidened) {
  std::string why;
  EXPECT_EQ(shift(expected({}, 0.007), expected({}, 0.00701), &why), Shift::widened);
  EXPECT_EQ(why, "the expected range");
  EXPECT_EQ(shift(expected(0.9, 1.1), expected(0.89, 1.1)), Shift::widened);
  EXPECT_EQ(shift(expected(0.9, {}), expected(-0.9, {})), Shift::widened);
  EXPECT_EQ(shift(expected(0.0, 0.0), expected(0.0, 1e-15)), Shift::widened) << "nothing is slack of zero";
}

TEST(Shift, AnEndThatIsGoneIsWidened) {
  EXPECT_EQ(shift(expected(0.9, 1.1), expected({}, 1.1)), Shift::widened);
  EXPECT_EQ(shift(expected(0.9, 1.1), expected(0.9, {})), Shift::widened);
}

TEST(Shift, ARangeThatMovedLetsPassWhatItDidNot) {
  EXPECT_EQ(shift(expected(0.9, 1.1), expected(1.0, 1.2)), Shift::widened);
  EXPECT_EQ(shift(expected(0.9, 1.1), expected(0.8, 0.95)), Shift::widened);
}

TEST(Shift, AnEndFurtherInIsNarrowed) {
  EXPECT_EQ(shift(expected({}, 0.007), expected({}, 0.0069)), Shift::narrowed);
  EXPECT_EQ(shift(expected({}, 1.1), expected(0.9, 1.1)), Shift::narrowed);
}

TEST(Shift, OfExpectedFailures) {
  const Bounds gate = expected({}, 0.01), known = failing(gate, 0.02, 0.03);
  std::string why;
  EXPECT_EQ(shift(gate, known, &why), Shift::widened);
  EXPECT_EQ(why, "a failure is expected where none was");
  EXPECT_EQ(shift(known, gate), Shift::narrowed) << "the failure is mended";
  EXPECT_EQ(shift(known, failing(gate, 0.02, 0.031), &why), Shift::widened);
  EXPECT_EQ(why, "the band of the expected failure");
  EXPECT_EQ(shift(known, failing(gate, 0.021, 0.03)), Shift::narrowed);
}

TEST(Shift, OfExpectedStops) {
  Bounds before = expected({}, 0.01);
  before.stops = StopBand{10, 20, "density"};
  Bounds later = before;
  later.stops->step_high = 21;
  EXPECT_EQ(shift(before, later), Shift::widened);
  EXPECT_EQ(shift(later, before), Shift::narrowed);
  Bounds elsewhere = before;
  elsewhere.stops->field = "energy";
  EXPECT_EQ(shift(before, elsewhere), Shift::widened);
  EXPECT_EQ(shift(before, failing(before, 0.02, 0.03)), Shift::widened) << "a value may now fail, too";
}

TEST(Shift, JudgingTheValueAloneIsWidened) {
  Bounds interval = expected(0.9, {});
  interval.order = true;
  EXPECT_EQ(shift(interval, expected(0.9, {})), Shift::widened);
  EXPECT_EQ(shift(expected(0.9, {}), interval), Shift::narrowed);
}

TEST(BoundsWords, SayAllThatPasses) {
  EXPECT_EQ(bounds_words(expected(0.9, 1.1)), "[0.9, 1.1]");
  EXPECT_EQ(bounds_words(failing(expected({}, 0.01), 0.02, 0.03)), "at most 0.01, known to fail in [0.02, 0.03]");
}

}  // namespace
}  // namespace plumbline::bounds_test
