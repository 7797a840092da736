// What single cases of solids promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/judge/gates.hpp"
#include "cases/harness/judge/study.hpp"
#include "cases/harness/run/experiment.hpp"

namespace plumbline::solid_cases_test {
namespace {

double value(const RunResult& run, const std::string& measure) {
  const Measure* found = run.find(measure);
  return found && found->value ? *found->value : std::nan("");
}
RunResult run(const std::string& name, const std::string& scheme, const std::vector<std::string>& typed) {
  const Case& entry = find_case(name);
  return run_experiment(entry, scheme, entry.settings(scheme, {}, typed));
}

// The force on the middle node is (3 x 123034 - 2 x 181170)/60 before and (2 x 123274 - 123274 - 2 x 179802)/60 after.
TEST(CellCrossing, YorksForcesFollowFromHisStresses) {
  const RunResult forces = run("cell-crossing", "york1997", {"problem=forces"});
  EXPECT_NEAR(value(forces, "force_middle_before"), 6762.0 / 60, 1e-6);
  EXPECT_NEAR(value(forces, "force_middle_after"), (123274.0 - 2 * 179802) / 60, 1e-6);
  EXPECT_NEAR(value(forces, "force_lower_after") - value(forces, "force_lower_before"),
              (123274 + 2 * 179802 - 2 * 181170) / 60.0, 1e-6);
}

// Without stress there is nothing to make noise of; with boxes that gape there is.
TEST(CellCrossing, NoiseComesFromStress) {
  EXPECT_LT(value(run("cell-crossing", "default", {"stretch=0.93"}), "noise_peak"), 1e-10);
  EXPECT_GT(value(run("cell-crossing", "default", {"shape=gimp"}), "noise_rms"), 1e-3);
}

// The exact state of the disk: its start has the stress of the reference to the share of the strain.
TEST(SpinningDisk, StartsInItsSteadyState) {
  const RunResult start = run("spinning-disk", "default", {"turns=0.001"});
  EXPECT_LT(value(start, "stress.worst_error"), 0.03);
  EXPECT_NEAR(value(start, "centre_stress"), 0.964286, 0.01 * 0.964286);
}

TEST(PlaneStress, SheetAndMembraneAreOneBar) {
  const RunResult sheet = run("plane-stress", "default", {"cells=8"});
  const RunResult membrane = run("plane-stress", "default", {"cells=8", "body=membrane"});
  EXPECT_NEAR(value(sheet, "period") / value(membrane, "period"), 1, 1e-10);
  EXPECT_NEAR(*sheet.find("period")->reference, 4e-3 * std::sqrt(1 - 0.16), 1e-12);  // [York 5.14]
}

}  // namespace
}  // namespace plumbline::solid_cases_test
