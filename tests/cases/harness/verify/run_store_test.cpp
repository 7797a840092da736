// A run that comes from its file is the run that was made, to the last bit; and what is not whole or not of this code is none.
#include "cases/harness/verify/run_store.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "cases/harness/files/seal.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "cases/harness/verify/verification.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::run_store_test {
namespace {

Provenance by(const std::string& code) {
  Provenance provenance;
  provenance.fingerprint = code;
  return provenance;
}

void append(std::string& bits, double value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bits.append(raw, sizeof value);
}

// Every bit of a run but for its frames.
std::string bits(const RunResult& run) {
  std::string all = run.case_name + run.scheme + run.settings.canonical() + run.file + run.profile.kind +
                    run.profile.abscissa + std::to_string(run.dim) + std::to_string(run.axisymmetric) +
                    std::to_string(run.finished) + std::to_string(run.steps) + " " + std::to_string(run.points) + " " +
                    std::to_string(run.doubles_per_point);
  for (const double value : {run.h, run.dt, run.end_time, run.wall_s}) append(all, value);
  all.append(reinterpret_cast<const char*>(&run.ledger), sizeof run.ledger);
  if (run.stop) {
    const Stop& s = *run.stop;
    all += s.reason + s.body + s.field + std::to_string(s.step) + " " + std::to_string(s.point);
    append(all, s.time);
    append(all, s.value);
  }
  const auto table = [&](const std::vector<double>& values) {
    for (const double value : values) append(all, value);
  };
  table(run.history.step);
  table(run.history.time);
  for (const LedgerHistory::Series& series : run.history.series) {
    all += series.quantity + series.column;
    table(series.values);
  }
  for (const Measure& m : run.measures) {
    all += m.name + m.unit + (m.value ? "v" : "") + (m.reference ? "r" : "");
    table({m.error, m.scale, m.value.value_or(0), m.reference.value_or(0), m.reference_bound});
  }
  for (const ProfileColumn& column : run.profile.columns) {
    all += column.name + column.unit + column.label;
    table(column.values);
  }
  return all;
}

struct Sample {
  std::string name, case_name, study;
  std::vector<Override> overrides;
  Vary vary;
  std::vector<double> values;
};
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

class Restored : public testing::TestWithParam<Sample> {};

// The gates of the case's own study of that name, and the generic ones.
std::vector<JudgedGate> judged(const StudyResult& study) {
  std::vector<CaseGate> gates = generic_gates(study.plan.id, study.levels.front().run.dim,
                                              study.levels.front().run.axisymmetric);
  for (CaseGate gate : study.entry->gates) {
    if (gate.study == study.plan.id) gates.push_back(std::move(gate));
  }
  return judge_gates(gates, study);
}

TEST_P(Restored, RunsAndGatesAreTheSameToTheLastBit) {
  const TemporaryFolder folder;
  const ResultsFolder results(folder.path());
  const Sample& sample = GetParam();
  const Case& entry = find_case(sample.case_name);
  StudyPlan plan{.id = sample.study, .title = {}, .why = {}, .overrides = sample.overrides};
  plan.vary = sample.vary;
  plan.values = sample.values;
  const std::vector<PlannedRun> planned = planned_runs(entry, plan, Tier::quick);
  RunStore first(results, by("0123456789ab"), true), again(results, by("0123456789ab"), true);
  const StudyResult fresh = run_study(entry, plan, planned, 2, {}, &first);
  const StudyResult restored = run_study(entry, plan, planned, 2, {}, &again);
  EXPECT_EQ(first.made(), static_cast<int>(planned.size()));
  EXPECT_EQ(first.reused(), 0);
  EXPECT_EQ(again.made(), 0);
  EXPECT_EQ(again.reused(), static_cast<int>(planned.size()));
  ASSERT_EQ(fresh.levels.size(), restored.levels.size());
  for (std::size_t k = 0; k < fresh.levels.size(); ++k) {
    EXPECT_TRUE(bits(fresh.levels[k].run) == bits(restored.levels[k].run)) << "level " << k;
    EXPECT_EQ(fresh.levels[k].h, restored.levels[k].h);
  }
  EXPECT_EQ(fresh.levels.front().run.stop.has_value(), sample.name == "Stopped");
  EXPECT_EQ(fresh.levels.front().run.axisymmetric, sample.name == "Axisymmetric");
  EXPECT_EQ(to_json(judged(fresh)).dump(), to_json(judged(restored)).dump());
  EXPECT_EQ(study_document(fresh, {}, {}).dump(), study_document(restored, {}, {}).dump());
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Restored,
    testing::Values(Sample{"Gas", "sod", "default", {{"ppc", 4.0}}, Vary::cells, {20, 40, 80}},
                    Sample{"Steps", "sod", "step", {{"cells", 20.0}}, Vary::dt, {1, 0.5, 0.25}},
                    Sample{"Membrane", "spring-mass", "default", {}, Vary::cells, {4}},
                    Sample{"Stopped", "sod", "default", {{"cfl", 5.0}}, Vary::cells, {20, 40}},
                    Sample{"Axisymmetric", "airbag-200", "default", {{"t_end", 5e-3}}, Vary::cells, {10}},
                    Sample{"Trial",
                           "stability-york",
                           "list-centres",
                           {{"trial", std::string("list-centres")}},
                           Vary::cells,
                           {trial_level}}),
    [](const auto& about) { return about.param.name; });

// A run with numbers that JSON has no words for.
RunResult odd_run() {
  RunResult run = run_experiment(find_case("sod"), "default", find_case("sod").settings("default", {{"cells", 10.0}}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  run.measures.push_back({"odd", nan, -0.0, inf, -inf, std::numeric_limits<double>::denorm_min(), "m"});
  run.measures.push_back({"bare", 1, 2, {}, nan, 0, "1"});
  run.profile.columns.push_back({"odd", "m", "odd \"column\"", {nan, inf, -0.0}});
  run.stop = Stop{"a reason\nof two lines", "gas", "field", 3, nan, 7, -inf};
  run.file = ResultsFolder::run_name(run);
  return run;
}

class StoredRun : public testing::Test {
 protected:
  void SetUp() override { write({}); }
  void write(const Making& making) { results.write_run(run, {}, by("code"), making); }
  std::string path() const { return folder / run.file; }
  RunStore store(const std::string& code = "code") const { return {results, by(code), true}; }
  bool taken(const FrameRequest& frames = {}) { return store().take(sod, run.file, frames).has_value(); }

  TemporaryFolder folder;
  ResultsFolder results{folder.path()};
  const Case& sod = find_case("sod");
  RunResult run = odd_run();
};

TEST_F(StoredRun, KeepsNumbersThatAreNone) {
  const auto restored = results.read_run(run.file, "code");
  ASSERT_TRUE(restored);
  EXPECT_TRUE(bits(*restored) == bits(run));
}

TEST_F(StoredRun, IsOfItsCodeAlone) {
  EXPECT_TRUE(taken());
  EXPECT_FALSE(store("other").take(sod, run.file));
  EXPECT_FALSE(store("").take(sod, run.file)) << "a program that does not know its own code takes nothing";
  EXPECT_FALSE(results.read_run(run.file, "other"));
  EXPECT_FALSE(RunStore(results, by("code"), false).take(sod, run.file)) << "nothing is taken without being asked to";
}

TEST_F(StoredRun, HasTheFramesAskedForOrIsNone) {
  EXPECT_FALSE(taken({10, 0}));
  write({{10, 20000}, 1});
  EXPECT_TRUE(taken());
  EXPECT_TRUE(taken({10, 20000}));
  EXPECT_TRUE(taken({5, 1000}));
  EXPECT_FALSE(taken({11, 20000}));
  EXPECT_FALSE(taken({10, 0})) << "all points were not kept";
  write({{10, 0}, 1});
  EXPECT_TRUE(taken({10, 20000}));
}

TEST_F(StoredRun, ThatIsNotThereIsNone) {
  std::filesystem::remove(path());
  testing::internal::CaptureStderr();
  EXPECT_FALSE(taken());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Damage anywhere: half a file, an empty one, one bit of any of the tables.
TEST_F(StoredRun, ThatIsDamagedIsNoneAndIsSaidOnce) {
  for (const double part : {0.0, 0.1, 0.5, 0.99}) {
    write({});
    const auto size = std::filesystem::file_size(path());
    std::filesystem::resize_file(path(), static_cast<std::uintmax_t>(part * static_cast<double>(size)));
    RunStore asked = store();
    testing::internal::CaptureStderr();
    EXPECT_FALSE(asked.take(sod, run.file)) << part;
    EXPECT_FALSE(asked.holds(sod, run.file)) << part;
    EXPECT_LT(asked.known_seconds(run.file), 0);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find(run.file), std::string::npos);
    EXPECT_EQ(said.find("plumbline:"), said.rfind("plumbline:")) << said;
  }
}

// As if it had been written as it is now.
void seal_again(const std::string& file) {
  std::string content = bytes(file);
  seal(content);
  write_text_file(file, content);
}

void change_one_number(const std::string& file, const std::string& path) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t data = H5Dopen2(handle, path.c_str(), H5P_DEFAULT);
  ASSERT_GE(data, 0) << path;
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  values.front() = values.front() == 0 ? 1 : 0;
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(handle);
  seal_again(file);
}

TEST_F(StoredRun, WithOneNumberChangedIsNone) {
  for (const char* part :
       {"/restore/numbers", "/restore/ledger", "/ledger/energy/store", "/ledger/mass/time", "/profile/density"}) {
    write({});
    change_one_number(path(), part);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(taken()) << part;
    EXPECT_NE(testing::internal::GetCapturedStderr().find("damaged"), std::string::npos) << part;
  }
}

void erase(const std::string& file, const std::string& path) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_GE(H5Ldelete(handle, path.c_str(), H5P_DEFAULT), 0);
  H5Fclose(handle);
  seal_again(file);
}

TEST_F(StoredRun, OfAnOlderVersionIsNoneWithoutAWord) {
  erase(path(), "/restore");
  testing::internal::CaptureStderr();
  EXPECT_FALSE(taken());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(StoredRun, WithoutOneOfItsTablesIsDamaged) {
  erase(path(), "/profile/density");
  EXPECT_THROW(results.read_run(run.file, "code"), FileError);
}

TEST_F(StoredRun, UnderAnotherNameIsNone) {
  std::filesystem::rename(path(), folder / "sod-default-10-0123456789ab.h5");
  EXPECT_THROW(results.read_run("sod-default-10-0123456789ab.h5", "code"), FileError);
}

TEST_F(StoredRun, WithFramesIsNotReplacedByTheSameWithout) {
  RunStore here = store();
  here.keep(sod, run, {{4, 0}, 0});
  here.keep(sod, run, {});
  EXPECT_TRUE(taken({4, 0}));
}

TEST(AbandonedFiles, OfProcessesThatAreNoMoreAreRemoved) {
  const TemporaryFolder folder;
  const std::string own = temporary_name(folder / "run.h5");
  const std::string mark = "-" + std::to_string(::getpid()) + ".part";
  std::string others = own;
  others.replace(others.rfind(mark), mark.size(), "-4194304.part");  // above the largest process number of Linux
  const std::string elsewhere = folder / "run.h5.another-4194304.part", result = folder / "run.h5";
  for (const std::string& name : {own, others, elsewhere, result}) std::ofstream(name) << "x";
  remove_abandoned(folder.path());
  EXPECT_TRUE(std::filesystem::exists(own)) << "of a process that lives";
  EXPECT_FALSE(std::filesystem::exists(others));
  EXPECT_TRUE(std::filesystem::exists(elsewhere)) << "another machine's processes are not known here";
  EXPECT_TRUE(std::filesystem::exists(result));
}

}  // namespace
}  // namespace plumbline::run_store_test
