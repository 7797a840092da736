// Bands of expected failures assert something: none is wider than what roundings do.
#include "cases/harness/compare/bands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::bands_test {
namespace {

using ::testing::HasSubstr;

Gate failing(Range band, const std::string& quantity = "error") {
  return gate("s/error", {quantity, {}}, at_most(1e-6), wanted_by_test).fails("known", band).gate;
}

Ensemble of(std::vector<double> values) { return {"toy", "s", "s/error", std::move(values), {}}; }

TEST(TooWide, RatiosOrdersAndSigns) {
  EXPECT_EQ(too_wide(toy_gate("a", {{}, 1}), nullptr), "");
  EXPECT_EQ(too_wide(failing({1.0, 1.35}), nullptr), "");
  EXPECT_THAT(too_wide(failing({1.0, 1.36}), nullptr), HasSubstr("a factor 1.35"));
  EXPECT_EQ(too_wide(failing({-1.35, -1.0}), nullptr), "");
  EXPECT_THAT(too_wide(failing({-1.36, -1.0}), nullptr), HasSubstr("a factor 1.35"));
  EXPECT_THAT(too_wide(failing({-0.1, 0.1}), nullptr), HasSubstr("a factor 1.35"));
  EXPECT_THAT(too_wide(failing({1.0, {}}), nullptr), HasSubstr("one end"));
  EXPECT_EQ(too_wide(failing({-0.1, 0.1}, "fitted order of error"), nullptr), "");
  EXPECT_THAT(too_wide(failing({-0.1, 0.11}, "fitted order of error"), nullptr), HasSubstr("0.2 of an order"));
}

TEST(TooWide, AnEnsembleShowsWhatRoundingsDo) {
  const std::vector<double> sixteen{1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  const Ensemble runs = of(sixteen);
  EXPECT_EQ(widened(runs).low, 0.5);
  EXPECT_EQ(widened(runs).high, 2.5);
  EXPECT_EQ(too_wide(failing({0.5, 2.5}), &runs), "");
  EXPECT_THAT(too_wide(failing({0.5, 2.51}), &runs), HasSubstr("beyond what its ensemble shows"));
  const Ensemble few = of({1, 2});
  EXPECT_THAT(too_wide(failing({1.0, 2.0}), &few), HasSubstr("2 runs, not 16"));
}

TEST(TooWide, RunsThatStoppedAreExpectedToStop) {
  Ensemble runs = of(std::vector<double>(16, 1.0));
  runs.stopped.push_back({70, "velocity"});
  Gate gate = failing({1.0, 1.0});
  EXPECT_THAT(too_wide(gate, &runs), HasSubstr("stopped at step 70"));
  gate.expected_failure->stops = StopBand{60, 80, "velocity"};
  EXPECT_EQ(too_wide(gate, &runs), "");
  gate.expected_failure->stops = StopBand{60, 69, "velocity"};
  EXPECT_THAT(too_wide(gate, &runs), HasSubstr("stopped at step 70"));
}

TEST(WideBands, NamesGatesAndEnsemblesOfNoGate) {
  Toy toy;
  toy.gates = {gate("s/error", error_at("error", 4), at_most(1e-6), wanted_by_test).fails("known", {1.0, 2.0})};
  const Case entry = toy_case(toy);
  const std::vector<const Case*> one{&entry};
  ASSERT_EQ(wide_bands(one, {}).size(), 1u);
  EXPECT_THAT(wide_bands(one, {})[0].message, HasSubstr("gate s/error of toy"));
  EXPECT_TRUE(wide_bands(one, {of({std::vector<double>(15, 1.0)})}).size() == 1);
  Ensemble stray = of(std::vector<double>(17, 1.0));
  stray.id = "gone";
  EXPECT_EQ(wide_bands(one, {stray}).size(), 2u);
}

}  // namespace
}  // namespace plumbline::bands_test
