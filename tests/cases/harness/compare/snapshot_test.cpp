#include "cases/harness/compare/snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/harness/files/hdf5_file.hpp"
#include "tests/cases/harness/compare/synthetic.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::snapshot_test {
namespace {

using ::testing::HasSubstr;

void write_study(const std::string& file, const Json& study, const std::string& started, std::int64_t format = 1) {
  Hdf5Writer out(file);
  out.attribute("/", "plumbline_format", format);
  out.attribute("/", "kind", "study");
  out.text("/provenance", Json{{"started", started}, {"cpu", "some"}, {"version", "1.2.3"}}.dump());
  out.text("/study", study.dump());
  out.commit();
}

void write_verdicts(const std::string& file, const Json& gates, const std::string& started) {
  Hdf5Writer out(file);
  out.attribute("/", "plumbline_format", std::int64_t{1});
  out.text("/provenance", Json{{"started", started}}.dump());
  out.text("/verdicts", Json{{"tier", "quick"}, {"gates", gates}}.dump());
  out.commit();
}

Json without_provenance(Json study) {
  study.erase("provenance");
  return study;
}

TEST(ReadSnapshot, TakesTheNewestOfEach) {
  const TemporaryFolder folder;
  SyntheticStudy old;
  old.order = 1;
  write_study(folder / "study-b.h5", without_provenance(SyntheticStudy{}.document()), "2026-11-22T00:00:00Z");
  write_study(folder / "study-z.h5", without_provenance(old.document()), "2026-11-21T00:00:00Z");
  write_verdicts(folder / "verdicts-a.h5", Json::array({synthetic_gate("cells/mass", "FAIL", 1)}),
                 "2026-11-22T00:00:00Z");
  write_verdicts(folder / "verdicts-b.h5", Json::array({synthetic_gate("cells/mass", "PASS", 1)}),
                 "2026-11-21T00:00:00Z");
  const Snapshot snapshot = read_snapshot(folder.path());
  ASSERT_EQ(snapshot.studies.size(), 1u);
  ASSERT_EQ(snapshot.studies.begin()->second.size(), 1u);
  EXPECT_EQ(snapshot.studies.begin()->second[0].file, "study-b.h5");
  ASSERT_EQ(snapshot.gates.size(), 1u);
  EXPECT_EQ(snapshot.gates.begin()->second.verdict, Verdict::fail);
  EXPECT_EQ(snapshot.version, "1.2.3");
}

TEST(ReadSnapshot, KeepsStudiesOfOtherLevelsApart) {
  const TemporaryFolder folder;
  SyntheticStudy full;
  full.cells = {100, 200, 400, 800, 1600};
  write_study(folder / "study-a.h5", SyntheticStudy{}.document(), "2026-11-22T00:00:00Z");
  write_study(folder / "study-b.h5", full.document(), "2026-11-22T00:00:00Z");
  EXPECT_EQ(read_snapshot(folder.path()).studies.begin()->second.size(), 2u);
}

TEST(ReadSnapshot, ListsWhatIsDamaged) {
  const TemporaryFolder folder;
  write_study(folder / "study-good.h5", SyntheticStudy{}.document(), "2026-11-22T00:00:00Z");
  write_study(folder / "study-newer.h5", SyntheticStudy{}.document(), "2026-11-22T00:00:00Z", 99);
  write_study(folder / "study-other.h5", {{"case", "toy"}}, "2026-11-22T00:00:00Z");
  std::ofstream(folder / "study-short.h5") << bytes(folder / "study-good.h5").substr(0, 700);
  std::ofstream(folder / "stability.json") << "{\"problems\": [";
  std::ofstream(folder / "cost.json") << "[1]";
  std::ofstream(folder / "notes.txt") << "not ours";
  const Snapshot snapshot = read_snapshot(folder.path());
  std::map<std::string, std::string> damaged(snapshot.damaged.begin(), snapshot.damaged.end());
  EXPECT_EQ(damaged.size(), 5u);
  EXPECT_THAT(damaged["study-newer.h5"], HasSubstr("newer version"));
  EXPECT_THAT(damaged["study-short.h5"], HasSubstr("truncated"));
  EXPECT_THAT(damaged["stability.json"], HasSubstr("not JSON"));
  EXPECT_THAT(damaged["cost.json"], HasSubstr("shape"));
  EXPECT_EQ(snapshot.studies.size(), 1u);
}

TEST(ReadSnapshot, OffersTheNearestFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "baseline");
  try {
    read_snapshot(folder / "baselin");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean"));
    ASSERT_EQ(error.nearest.size(), 1u);
    EXPECT_THAT(error.nearest[0], HasSubstr("baseline"));
  }
}

TEST(ReadSnapshot, AFolderWithNothingToCompareIsAWrongCall) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_snapshot(folder.path()), UsageError);
}

}  // namespace
}  // namespace plumbline::snapshot_test
