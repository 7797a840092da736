#include "cases/harness/compare/tolerances.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::tolerances_test {
namespace {

using ::testing::HasSubstr;

LedgerLine line(const std::string& id, std::optional<double> low, std::optional<double> high) {
  CaseGate gate;
  gate.study = "cells";
  gate.gate = plumbline::gate(id, {"a number", {}}, {low, high}, requirement("first order from a coarse mesh")).gate;
  return declared_line("toy", gate, "2026-11-22");
}

std::vector<LedgerLine> ledger() { return {line("a", {}, 0.1 + 0.2), line("b", 1.0 / 3, 2.0 / 3), line("c", 0.9, {})}; }

std::string kinds(const std::vector<Discrepancy>& found) {
  std::string all;
  for (const Discrepancy& d : found) all += (all.empty() ? "" : " ") + d.kind + ":" + std::get<2>(d.gate);
  return all;
}

TEST(DeclaredLine, CarriesAllThatLetsAGatePass) {
  CaseGate declared;
  declared.study = "cells";
  declared.tier = Tier::full;
  declared.gate = gate("a", {"a number", {}}, at_most(0.1), theory("why"))
                      .fails("a known cause", {0.2, 0.3}, "2026-11-21 abcdef0")
                      .gate;
  declared.gate.order = true;
  declared.gate.expected_failure->stops = StopBand{3, 9, "density"};
  const LedgerLine l = declared_line("toy", declared, "2026-11-22");
  EXPECT_EQ(to_json(l).dump(),
            R"({"case":"toy","study":"cells","id":"a","tier":"full","low":null,"high":0.1,"order":true,)"
            R"("band":{"low":0.2,"high":0.3},"stops":{"step_low":3,"step_high":9,"field":"density"},)"
            R"("origin":"theory","reason":")" +
                l.reason + R"(","since":"2026-11-21 abcdef0"})");
  declared.gate.expected_failure->cause = "another";
  EXPECT_NE(declared_line("toy", declared, "2026-11-22").reason, l.reason);
}

TEST(Ledger, ReadsBackEveryBit) {
  const TemporaryFolder folder;
  std::vector<LedgerLine> lines = ledger();
  lines[0].widened = Widening{lines[1].bounds, "2026-11-22", "a reason"};
  write_ledger(folder / "t.json", lines);
  const std::vector<LedgerLine> read = read_ledger(folder / "t.json");
  ASSERT_EQ(read.size(), lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_EQ(read[k].bounds.expected.low, lines[k].bounds.expected.low);
    EXPECT_EQ(read[k].bounds.expected.high, lines[k].bounds.expected.high);
    EXPECT_EQ(to_json(read[k]), to_json(lines[k]));
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"t.json"}) << "no temporary file is left";
  const std::string text = bytes(folder / "t.json");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 2) << "one line a gate";
}

// The name of an origin until 0.8: it is no other origin, so that nothing is to be recorded.
TEST(Ledger, ReadsTheOriginNamesOfThePreviousVersion) {
  const TemporaryFolder folder;
  const CaseGate declared = recorded("cells/a", {"a number", {}}, 2, 0.1, "2026-11-21 abcdef0", "as it was");
  const LedgerLine now = declared_line("toy", declared, "2026-11-22");
  EXPECT_EQ(now.origin, "regression");
  LedgerLine before = now;
  before.origin = "frozen";
  write_ledger(folder / "t.json", {before});
  const std::vector<LedgerLine> read = read_ledger(folder / "t.json");
  EXPECT_EQ(read.at(0).origin, "regression");
  EXPECT_EQ(kinds(discrepancies(read, {now})), "");
}

TEST(Ledger, DefectsAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_ledger(folder / "none.json"), FileError);
  std::ofstream(folder / "damaged.json") << "{\"format\": 1, \"gates\": [";
  EXPECT_THROW(read_ledger(folder / "damaged.json"), FileError);
  std::ofstream(folder / "newer.json") << "{\"format\": 2, \"gates\": []}";
  EXPECT_THROW(read_ledger(folder / "newer.json"), FileError);
  write_ledger(folder / "twice.json", {line("a", {}, 1), line("a", {}, 2)});
  EXPECT_THROW(read_ledger(folder / "twice.json"), FileError);
  LedgerLine without = line("a", {}, 1);
  without.widened = Widening{without.bounds, "2026-11-22", ""};
  write_ledger(folder / "why.json", {without});
  EXPECT_THROW(read_ledger(folder / "why.json"), FileError);
}

TEST(Discrepancies, AsRecordedThereAreNone) { EXPECT_EQ(kinds(discrepancies(ledger(), ledger())), ""); }

TEST(Discrepancies, WidenedNamesGateBoundsAndWhatToDo) {
  std::vector<LedgerLine> now = ledger();
  now[1] = line("b", 1.0 / 3, 0.7);
  const auto found = discrepancies(ledger(), now);
  EXPECT_EQ(kinds(found), "widened:b");
  EXPECT_THAT(found.at(0).message, HasSubstr("gate b of toy, study cells"));
  EXPECT_THAT(found.at(0).message,
              HasSubstr("[0.3333333333333333, 0.6666666666666666] became [0.3333333333333333, 0.7]"));
  EXPECT_THAT(found.at(0).message, HasSubstr("--update --why"));
}

TEST(Discrepancies, NarrowedNewRemovedAndOtherReasonsAreToBeRecorded) {
  std::vector<LedgerLine> now = ledger();
  now[0] = line("a", {}, 0.2);
  now[1].reason = "000000000000";
  now[2] = line("d", 0.9, {});
  EXPECT_EQ(kinds(discrepancies(ledger(), now)), "narrowed:a reason:b removed:c new:d");
  for (const Discrepancy& d : discrepancies(ledger(), now)) EXPECT_THAT(d.message, HasSubstr("--update"));
}

TEST(Updated, AWideningNeedsAReason) {
  std::vector<LedgerLine> now = ledger();
  now[1] = line("b", 0.3, 0.7);
  try {
    updated(ledger(), now, "", "2026-12-01");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.key, "--why");
    EXPECT_THAT(error.what(), HasSubstr("gate b of toy"));
  }
  const auto lines = updated(ledger(), now, "the reference is only so good", "2026-12-01");
  ASSERT_TRUE(lines[1].widened);
  EXPECT_EQ(lines[1].widened->why, "the reference is only so good");
  EXPECT_EQ(lines[1].widened->date, "2026-12-01");
  EXPECT_EQ(lines[1].widened->from.expected.high, 2.0 / 3);
  EXPECT_FALSE(lines[0].widened);
  EXPECT_EQ(kinds(discrepancies(lines, now)), "");
}

TEST(Updated, KeepsSinceAndWideningForAsLongAsTheyHold) {
  std::vector<LedgerLine> recorded = ledger(), now = ledger();
  recorded[0].since = "2026-01-01";
  recorded[1].widened = Widening{{{0.4, 0.6}, {}, {}, false}, "2026-02-02", "because"};
  now[2] = line("c", 0.95, {});
  now[2].since = "2026-12-01";
  const auto lines = updated(recorded, now, "", "2026-12-01");
  EXPECT_EQ(lines[0].since, "2026-01-01");
  EXPECT_EQ(lines[2].since, "2026-12-01");
  EXPECT_TRUE(lines[1].widened) << "still wider than it was";
  now[1] = line("b", 0.4, 0.6);
  EXPECT_FALSE(updated(recorded, now, "", "2026-12-01")[1].widened) << "taken back";
}

// A line edited by hand agrees with the executable; only the earlier ledger tells that it was widened.
TEST(UnsignedWidenings, AreThoseWithoutANewReason) {
  const std::vector<LedgerLine> earlier = ledger();
  std::vector<LedgerLine> recorded = ledger();
  EXPECT_EQ(kinds(unsigned_widenings(earlier, recorded)), "");
  recorded[1] = line("b", 0.3, 0.7);
  EXPECT_EQ(kinds(unsigned_widenings(earlier, recorded)), "widened:b");
  recorded[1].widened = Widening{earlier[1].bounds, "2026-12-01", "because"};
  EXPECT_EQ(kinds(unsigned_widenings(earlier, recorded)), "");
  std::vector<LedgerLine> signed_before = earlier;
  signed_before[1].widened = recorded[1].widened;
  EXPECT_EQ(kinds(unsigned_widenings(signed_before, recorded)), "widened:b") << "an old reason is none for this";
}

}  // namespace
}  // namespace plumbline::tolerances_test
