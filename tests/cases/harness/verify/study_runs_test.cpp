// The runs of several studies: one that two of them plan is made once, with the snapshots that either wants.
#include "cases/harness/verify/study_runs.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::study_runs_test {
namespace {

// How many scenes were made for these studies, and the snapshots of each one's only run.
struct Made {
  int scenes = 0;
  std::vector<std::size_t> frames;
};

Made made(const std::vector<StudyPlan>& plans) {
  std::atomic<int> scenes{0};
  Toy toy;
  toy.change = [&](Scene&) { ++scenes; };
  toy.studies = plans;
  const Case entry = toy_case(toy);
  std::vector<std::vector<PlannedRun>> planned;
  for (const StudyPlan& plan : plans) planned.push_back(planned_runs(entry, plan, Tier::quick));
  const auto outcomes = make_runs(entry, plans, planned, 1, {}, nullptr);
  Made result;
  result.scenes = scenes;
  for (const auto& runs : outcomes) result.frames.push_back(runs.at(0).run->frames.frames.size());
  return result;
}

StudyPlan plain(const char* id) { return study(id, "plain", "no snapshots", {4}); }
StudyPlan pictured(const char* id, int frames) { return plain(id).pictured(frames); }

TEST(StudyRuns, OneThatTwoStudiesPlanIsMadeOnceWhateverSnapshotsTheyWant) {
  const int of_one = made({plain("one")}).scenes;
  EXPECT_GT(of_one, 0);
  for (const auto& [plans, frames] :
       std::vector<std::pair<std::vector<StudyPlan>, std::size_t>>{{{plain("one"), plain("other")}, 0},
                                                                   {{plain("one"), pictured("other", 3)}, 3},
                                                                   {{pictured("one", 3), plain("other")}, 3},
                                                                   {{pictured("one", 3), pictured("other", 5)}, 5}}) {
    const Made both = made(plans);
    EXPECT_EQ(both.scenes, of_one) << frames;
    EXPECT_EQ(both.frames, (std::vector<std::size_t>{frames, frames}));
  }
}

// A study of two meshes wants snapshots of its last alone, if any: the same run of another's last one is not another run.
TEST(StudyRuns, ALevelThatIsLastInOneStudyIsTheSameRunInAnother) {
  const StudyPlan longer = study("longer", "plain", "no snapshots", {4, 8});
  EXPECT_EQ(made({longer, plain("short")}).scenes, made({longer}).scenes);
}

}  // namespace
}  // namespace plumbline::study_runs_test
