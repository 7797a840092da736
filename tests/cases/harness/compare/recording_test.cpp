// What `plumbline tolerances --record` makes of the results of verify, and what it asks for.
#include "cases/harness/compare/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::recording_test {
namespace {

using ::testing::HasSubstr;

Json gate(const std::string& id, double high, double measured, const std::string& verdict = "PASS") {
  return {{"case", "sod"},       {"study", "default"},      {"id", id},
          {"quantity", "error"}, {"origin", "requirement"}, {"expected", {{"low", nullptr}, {"high", high}}},
          {"interval", nullptr}, {"verdict", verdict},      {"measured", measured}};
}

Json verification(const std::vector<Json>& gates) {
  return {{"tier", "quick"},
          {"settings", Json::array()},
          {"gates", gates},
          {"provenance", {{"git", "5825b24aabb"}, {"started", "2026-11-23T10:00:00Z"}}}};
}

std::vector<RecordedValue> recorded(const std::vector<RecordedValue>& before, const Json& results,
                                    const std::string& why = "") {
  return recorded_from(before, results, "judged.json", why);
}

TEST(RecordedFrom, GatesGetTheirValueAndLooseOnesARange) {
  const auto values = recorded({}, verification({gate("a", 1, 0.1), gate("b", 0.2, 0.1), gate("c", 1, 2, "XFAIL"),
                                                 gate("d", 1, 0.5, "INCONCLUSIVE"), gate("a/regression", 1, 0.1)}));
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(values[0].id, "a");
  EXPECT_DOUBLE_EQ(*values[0].within->high, 0.3);
  EXPECT_EQ(values[0].since, "2026-11-23 5825b24");
  EXPECT_EQ(values[1].id, "b");
  EXPECT_FALSE(values[1].within);
  EXPECT_FALSE(values[2].within);
}

TEST(RecordedFrom, ValuesInTheirRangeKeepTheirLine) {
  const auto before = recorded({}, verification({gate("a", 1, 0.1)}));
  const auto values = recorded(before, verification({gate("a", 1, 0.29)}));
  EXPECT_EQ(values[0].measured, 0.1);
  EXPECT_FALSE(recorded(before, verification({gate("a", 0.2, 0.1)}))[0].within) << "the bound has become close";
}

TEST(RecordedFrom, ValuesThatMovedAskForAReason) {
  const auto before = recorded({}, verification({gate("a", 1, 0.1)}));
  for (const double moved : {0.9, 0.01}) {
    const Json results = verification({gate("a", 1, moved)});
    try {
      recorded(before, results);
      FAIL();
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a of sod, quick tier: 0.1 became"));
    }
    const auto values = recorded(before, results, "the limiter was mended");
    EXPECT_EQ(values[0].measured, moved);
    EXPECT_EQ(values[0].moved->from, 0.1);
    EXPECT_EQ(values[0].moved->why, "the limiter was mended");
    EXPECT_EQ(values[0].moved->date, "2026-11-23");
  }
}

TEST(RecordedFrom, OtherStudiesTiersAndGatesThatAreGone) {
  auto before = recorded({}, verification({gate("a", 1, 0.1), gate("b", 1, 0.1)}));
  before[0].tier = "full";
  EXPECT_EQ(recorded(before, verification({gate("c", 1, 0.1)})).size(), 2u) << "a of the full tier, and c";
  before[1].study = "other";
  EXPECT_EQ(recorded(before, verification({gate("c", 1, 0.1)})).size(), 3u);
}

TEST(RecordedFrom, ChosenGatesLeaveTheOthersOfTheirStudy) {
  const auto before = recorded({}, verification({gate("a", 1, 0.1), gate("b", 1, 0.1)}));
  Json some = verification({gate("a", 1, 0.1)});
  EXPECT_EQ(recorded(before, some).size(), 1u) << "b is gone";
  some["chosen_gates"] = {"a"};
  EXPECT_EQ(recorded(before, some).size(), 2u) << "b was not asked for";
}

TEST(RecordedFrom, RefusesOtherResults) {
  Json changed = verification({gate("a", 1, 0.1)});
  changed["settings"] = {"gamma=1.5"};
  EXPECT_THROW(recorded({}, changed), UsageError);
  EXPECT_THROW(recorded({}, Json::object()), FileError);
  Json nowhere = verification({});
  nowhere["provenance"]["git"] = "unknown";
  EXPECT_THROW(recorded({}, nowhere), FileError);
}

TEST(Unrecorded, NamesGatesWithWhatToCallAndValuesOfNoStudy) {
  Toy toy;
  toy.studies = {{.id = "s", .title = {}, .why = {}, .values = {4}}};
  toy.gates = {gate("s/error", error_at("error", 4), at_most(1), wanted_by_test),
               gate("s/late", error_at("error", 4), at_most(1), wanted_by_test).in(Tier::full)};
  const Case entry = toy_case(toy);
  std::vector<RecordedValue> values;
  for (const char* id : {"s/finite", "s/mass", "s/momentum", "s/ledger"}) {
    values.push_back({"toy", "s", id, "quick", 0, {}, "2026-11-23 5825b24", {}});
  }
  auto found = unrecorded({&entry}, values);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("gate s/error of toy"));
  EXPECT_THAT(found[0].message, HasSubstr("plumbline verify toy --json judged.json"));
  EXPECT_THAT(found[0].message, HasSubstr("--record judged.json"));
  values.push_back({"toy", "s", "s/error", "quick", 0, {}, "2026-11-23 5825b24", {}});
  EXPECT_TRUE(unrecorded({&entry}, values).empty());
  values.push_back({"toy", "gone", "gone/error", "quick", 0, {}, "2026-11-23 5825b24", {}});
  EXPECT_EQ(unrecorded({&entry}, values).size(), 1u);
}

TEST(Regressions, AreWrittenAsTheyAreRead) {
  const TemporaryFolder folder;
  auto values = recorded({}, verification({gate("a", 1, 0.1 + 0.2 - 0.2), gate("b", 0.2, 0.1)}));
  values[0].moved = RecordedValue::Moved{0.7, "2026-11-23", "a reason"};
  write_regressions(folder / "r.json", values);
  const auto read = read_regressions(folder / "r.json");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].measured, values[0].measured);
  EXPECT_EQ(*read[0].within->high, *values[0].within->high);
  EXPECT_EQ(read[0].moved->why, "a reason");
  EXPECT_FALSE(read[1].within);
  EXPECT_THROW(read_regressions(folder / "none.json"), FileError);
}

}  // namespace
}  // namespace plumbline::recording_test
