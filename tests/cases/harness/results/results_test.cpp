// The results folder: what a file is called, and that it holds what the run was.
#include "cases/harness/results/results.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <regex>
#include <set>

#include "cases/harness/files/hdf5_file.hpp"
#include "tests/cases/harness/temporary_folder.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::results_test {
namespace {

const Case toy = toy_case();

RunResult toy_run(const std::vector<Override>& overrides = {}) {
  RunResult run = run_experiment(toy, "default", toy.settings("default", overrides));
  run.measures = power_law_error(0.25, 1, 2);
  run.profile.columns = {{"x", "m", "position", {0.1, 0.2}}, {"density", "kg/m^3", "density", {1, 2}}};
  run.wall_s = 1;  // the one number that differs from run to run
  run.file = ResultsFolder::run_name(run);
  return run;
}

// The numbers at a path; none if the file has no such path.
std::vector<double> read_hdf5_numbers(const std::string& file, const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(handle, path.c_str(), H5P_DEFAULT);
  std::vector<double> values;
  if (data >= 0) {
    const hid_t space = H5Dget_space(data);
    values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    H5Sclose(space);
    H5Dclose(data);
  }
  H5Fclose(handle);
  return values;
}

Json read(const std::string& file, const std::string& path) { return Json::parse(read_hdf5_text(file, path)); }

TEST(ResultsFolder, IsMadeIfNeedBe) {
  const TemporaryFolder folder;
  const ResultsFolder results(folder / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b")) << "trying whether it can be written to leaves nothing";
}

TEST(ResultsFolder, AFileInItsPlaceIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_THROW(ResultsFolder(folder / "file"), FileError);
  EXPECT_THROW(ResultsFolder(folder / "file/inside"), FileError);
}

TEST(RunName, IsCaseSchemeCellsAndHash) {
  RunResult run("sod", "default", find_case("sod").settings("default", {}));
  EXPECT_TRUE(std::regex_match(ResultsFolder::run_name(run), std::regex("sod-default-100-[0-9a-f]{12}\\.h5")));
}

// Another value of any key is another run.
// A value of the key that is allowed and not its default.
Value another(const Key& key) {
  if (!key.choices.empty()) {
    return Value(to_text(key.value) == key.choices.back() ? key.choices.front() : key.choices.back());
  }
  const double now = std::holds_alternative<double>(key.value) ? std::get<double>(key.value) : 0;
  for (const double candidate :
       {7.0, 2.0, 1.0, 3.0, 0.37, 0.5 * key.low + 0.5 * key.high, 0.25 * key.low + 0.75 * key.high}) {
    const bool above = key.low_open ? candidate > key.low : candidate >= key.low;
    const bool below = key.high_open ? candidate < key.high : candidate <= key.high;
    const bool possible = !key.integer || candidate == std::floor(candidate);
    if (above && below && possible && candidate != now) return candidate;
  }
  throw std::logic_error("no other value of " + key.name);
}

TEST(RunName, ChangesWithEverySettingCaseAndScheme) {
  for (const Case* entry : cases()) {
    const Settings before = entry->settings("default", {});
    RunResult run(entry->name, "default", before);
    std::set<std::string> names{ResultsFolder::run_name(run)};
    std::size_t changes = 1;
    for (const Key& key : before.keys()) {
      if (key.choices.size() == 1) continue;
      const Value other = another(key);
      run.settings = before;
      run.settings.set(key.name, other, entry->name);
      names.insert(ResultsFolder::run_name(run));
      ++changes;
    }
    run.settings = before;
    run.scheme = "default+usl";
    names.insert(ResultsFolder::run_name(run));
    run.scheme = "default";
    run.case_name = "other";
    names.insert(ResultsFolder::run_name(run));
    EXPECT_EQ(names.size(), changes + 2) << entry->name;
  }
}

TEST(RunName, TheSameChoicesGiveTheSameName) {
  EXPECT_EQ(toy_run().file, toy_run().file);
  EXPECT_NE(toy_run().file, toy_run({{"weight", 2.0}}).file);
}

TEST(RunFile, HoldsWhatTheRunWas) {
  const TemporaryFolder folder;
  const ResultsFolder results(folder.path());
  const RunResult run = toy_run();
  Provenance provenance;
  provenance.command = "plumbline run toy";
  results.write_run(run, {}, provenance);
  const std::string file = folder / run.file;
  EXPECT_EQ(folder.names(), std::vector<std::string>{run.file});
  EXPECT_EQ(read(file, "/run"), run_document(run, {}, provenance));
  EXPECT_EQ(read(file, "/measures"), to_json(run.measures));
  EXPECT_EQ(read(file, "/settings"), to_json(run.settings));
  EXPECT_EQ(read(file, "/provenance")["command"], "plumbline run toy");
  EXPECT_EQ(read(file, "/gates"), Json::array());
}

TEST(RunFile, TheSameRunGivesTheSameBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) ResultsFolder(folder / name).write_run(toy_run(), {}, Provenance{});
  const std::string file = toy_run().file;
  EXPECT_TRUE(bytes(folder / ("a/" + file)) == bytes(folder / ("b/" + file)));
}

TEST(RunFile, WhatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  RunResult run = toy_run();
  run.profile.columns.push_back(run.profile.columns.front());  // a column twice
  EXPECT_THROW(ResultsFolder(folder.path()).write_run(run, {}, Provenance{}), FileError);
  EXPECT_TRUE(folder.names().empty());
}

StudyResult toy_study(const std::string& id = "s") {
  StudyResult study{&toy, {.id = id, .title = "t", .why = "w"}, "default", {}, {}, {}, nullptr};
  study.levels.push_back({4, 0.25, toy_run(), {}});
  return study;
}

TEST(StudyFile, HoldsLevelsGatesAndCatalog) {
  const TemporaryFolder folder;
  StudyResult study = toy_study();
  const Gate gate = toy_gate("s/gate", {{}, 1});
  Measured measured;
  measured.value = 0.5;
  const JudgedGate judged{gate, "toy", "default", "s", measured, judge(gate, measured), {}};
  ResultsFolder(folder.path()).write_study(study, {judged}, Provenance{});
  EXPECT_EQ(folder.names(), std::vector<std::string>{study.file});
  const std::string file = folder / study.file;
  EXPECT_EQ(read(file, "/study")["case"], "toy");
  EXPECT_EQ(read(file, "/study")["levels"].size(), 1u);
  EXPECT_EQ(read(file, "/gates")[0]["verdict"], "PASS");
  EXPECT_EQ(read(file, "/catalog")["name"], "toy");
  EXPECT_EQ(read(file, "/fit"), Json::object());
}

// A comparator's table has a row for each level of the study; only studies in cells of the plain default have one.
TEST(StudyFile, HasTheComparatorsTable) {
  Toy with;
  with.comparators = [](const Settings& settings, const std::vector<double>& cells) {
    Comparator comparator{"comparator", "another method"};
    for (const double n : cells) comparator.levels.push_back({n, 3, static_cast<long>(3 * n), 0.5, {{"error", 1 / n}}});
    comparator.levels.back().errors[0].second += settings.number("weight");
    return std::vector<Comparator>{comparator};
  };
  const Case entry = toy_case(with);
  StudyResult study = toy_study();
  study.entry = &entry;
  study.levels.push_back({8, 0.125, toy_run({{"cells", 8.0}}), {}});
  const TemporaryFolder folder;
  const ResultsFolder results(folder.path());
  results.write_study(study, {}, Provenance{});
  const std::string file = folder / study.file;
  EXPECT_EQ(read_hdf5_numbers(file, "/comparator/comparator/cells"), (std::vector<double>{4, 8}));
  EXPECT_EQ(read_hdf5_numbers(file, "/comparator/comparator/steps"), (std::vector<double>{3, 3}));
  EXPECT_EQ(read_hdf5_numbers(file, "/comparator/comparator/cell_steps"), (std::vector<double>{12, 24}));
  EXPECT_EQ(read_hdf5_numbers(file, "/comparator/comparator/wall_s"), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(read_hdf5_numbers(file, "/comparator/comparator/error"), (std::vector<double>{0.25, 1.125}));
  for (const auto& change : std::vector<std::function<void(StudyPlan&)>>{[](StudyPlan& p) { p.vary = Vary::dt; },
                                                                         [](StudyPlan& p) { p.scheme = "york1997"; },
                                                                         [](StudyPlan& p) {
                                                                           p.overrides = {{"ppc", 2.0}};
                                                                         }}) {
    StudyResult other = study;
    change(other.plan);
    results.write_study(other, {}, Provenance{});
    EXPECT_TRUE(read_hdf5_numbers(folder / other.file, "/comparator/comparator/cells").empty());
  }
}

TEST(StudyName, TellsStudiesApart) {
  StudyResult other = toy_study();
  other.levels.push_back({8, 0.125, toy_run({{"cells", 8.0}}), {}});
  const std::set<std::string> names{ResultsFolder::study_name(toy_study()),
                                    ResultsFolder::study_name(toy_study("other")), ResultsFolder::study_name(other)};
  EXPECT_EQ(names.size(), 3u);
  EXPECT_TRUE(std::regex_match(*names.begin(), std::regex("study-toy-default-cells-[0-9a-f]{12}\\.h5")));
}

TEST(VerdictsFile, HoldsTheVerdictsAndTheCatalogOfItsCases) {
  const TemporaryFolder folder;
  const Json document{{"gates", Json::array()}, {"counts", counts_document({})}, {"executed", 0}, {"declared", 0}};
  ResultsFolder(folder.path()).write_verdicts(document, {&toy, &find_case("sod")}, "quick", Provenance{});
  ASSERT_EQ(folder.names().size(), 1u);
  const std::string file = folder / folder.names().front();
  EXPECT_TRUE(std::regex_match(folder.names().front(), std::regex("verdicts-quick-[0-9a-f]{12}\\.h5")));
  EXPECT_EQ(read(file, "/verdicts"), document);
  EXPECT_TRUE(read(file, "/catalog").contains("toy"));
  EXPECT_TRUE(read(file, "/catalog").contains("sod"));
}

}  // namespace
}  // namespace plumbline::results_test
