// Files of one frame each: cells of points and chains. That VTK reads them so is tested in tests/contract.
#include "cases/harness/results/paraview_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::paraview_files_test {
namespace {

using ::testing::ElementsAre;

std::vector<int> integers(const std::string& file, const std::string& path) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(handle, path.c_str(), H5P_DEFAULT), space = H5Dget_space(data);
  std::vector<int> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(handle);
  return values;
}

Frame frame_of(double time, const std::vector<int>& points) {
  Frame frame;
  frame.time = time;
  frame.points = points;
  for (const int count : points) {
    for (int p = 0; p < count; ++p) frame.id.push_back(p);
  }
  const std::size_t all = frame.id.size();
  frame.position.assign(3 * all, 0.5F);
  frame.velocity.assign(3 * all, 0.0F);
  frame.pressure.assign(all, 1.0F);
  frame.stress.assign(all, 2.0F);
  return frame;
}

// Two points, an open chain of two, a closed one of three, a chain that has no points.
FrameSet bodies_of_all_kinds() {
  FrameSet set;
  set.bodies = {{"gas", "ideal_gas", "gas", false, false},
                {"rope", "segment_membrane", "membrane", true, false},
                {"ring", "segment_membrane", "membrane", true, true},
                {"none", "segment_membrane", "membrane", true, true}};
  set.frames = {frame_of(0, {2, 2, 3, 0}), frame_of(0.125, {3, 2, 3, 0})};
  return set;
}

TEST(ParaviewFiles, PointsAreVerticesAndChainsAreLines) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_paraview_files(folder / "film", "run", bodies_of_all_kinds()), folder / "film/run.hdf.series");
  const std::string first = folder / "film/run-0000.hdf", second = folder / "film/run-0001.hdf";
  EXPECT_THAT(integers(first, "/VTKHDF/Types"), ElementsAre(1, 1, 4, 4));
  EXPECT_THAT(integers(first, "/VTKHDF/Offsets"), ElementsAre(0, 1, 2, 4, 8));
  EXPECT_THAT(integers(first, "/VTKHDF/Connectivity"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 4));
  EXPECT_THAT(integers(first, "/VTKHDF/NumberOfPoints"), ElementsAre(7));
  EXPECT_THAT(integers(first, "/VTKHDF/NumberOfCells"), ElementsAre(4));
  EXPECT_THAT(integers(first, "/VTKHDF/NumberOfConnectivityIds"), ElementsAre(8));
  EXPECT_THAT(integers(first, "/VTKHDF/PointData/body"), ElementsAre(0, 0, 1, 1, 2, 2, 2));
  EXPECT_THAT(integers(second, "/VTKHDF/Connectivity"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 5));
}

TEST(ParaviewFiles, TheListHasTheTrueTimes) {
  const TemporaryFolder folder;
  const auto list = nlohmann::json::parse(bytes(write_paraview_files(folder.path(), "run", bodies_of_all_kinds())));
  EXPECT_EQ(list["files"][1]["name"], "run-0001.hdf");
  EXPECT_EQ(list["files"][1]["time"], 0.125);
  EXPECT_THAT(folder.names(), ElementsAre("run-0000.hdf", "run-0001.hdf", "run.hdf.series"));
}

TEST(ParaviewFiles, NothingIsWrittenOfNoFrames) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_paraview_files(folder / "film", "run", {}), "");
  EXPECT_TRUE(folder.names().empty());
}

TEST(ParaviewFiles, AFolderThatCannotBeIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "film") << "a file";
  EXPECT_THROW(write_paraview_files(folder / "film", "run", bodies_of_all_kinds()), FileError);
}

}  // namespace
}  // namespace plumbline::paraview_files_test
