#include "cases/harness/exchange/foreign_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/hdf5_handle.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::foreign_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The processes that this one has split off.
std::vector<pid_t> children() {
  std::ifstream listed(fmt::format("/proc/self/task/{}/children", ::getpid()));
  return {std::istream_iterator<pid_t>(listed), {}};
}

class ForeignFileTest : public testing::Test {
 protected:
  ForeignFileTest() {
    const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const Hdf5Handle group(H5Gcreate2(file, "bodies", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const hsize_t shape[] = {2, 3};
    const Hdf5Handle plane(H5Screate_simple(2, shape, nullptr), H5Sclose), point(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle table(H5Dcreate2(group, "table", H5T_NATIVE_DOUBLE, plane, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           H5Dclose);
    const double values[] = {1, 2, 3, 4, 5, 6};
    H5Dwrite(table, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    const Hdf5Handle time(H5Acreate2(file, "time", H5T_NATIVE_DOUBLE, point, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    H5Awrite(time, H5T_NATIVE_DOUBLE, values + 4);
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text, 3);
    const Hdf5Handle name(H5Acreate2(file, "name", text, point, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    H5Awrite(name, text, "sod");
  }

  // What asking for the table says where it cannot be had.
  std::string refusal(const ForeignFile& file) const {
    try {
      file.numbers("/bodies/table");
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryFolder folder;
  const std::string path = folder / "result.h5";
};

TEST_F(ForeignFileTest, AnswersWhatIsThere) {
  const ForeignFile file(path);
  EXPECT_TRUE(file.has("/bodies/table"));
  EXPECT_FALSE(file.has("/bodies/other"));
  EXPECT_THAT(file.members("/bodies"), ElementsAre("table"));
  EXPECT_THAT(file.members("/other"), ElementsAre());
  EXPECT_EQ(file.text_attribute("name"), "sod");
  EXPECT_EQ(file.number_attribute("time"), 5.0);
  EXPECT_EQ(file.number_attribute("name2"), std::nullopt);
  const NumberTable table = file.numbers("/bodies/table");
  EXPECT_THAT(table.shape, ElementsAre(2, 3));
  EXPECT_THAT(table.values, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(ForeignFileTest, RefusesAndGoesOn) {
  const ForeignFile file(path);
  EXPECT_THROW(file.number_attribute("name"), FileError);
  EXPECT_THROW(file.numbers("/bodies"), FileError);
  EXPECT_EQ(file.number_attribute("time"), 5.0);
  EXPECT_THROW(ForeignFile(folder / "none.h5"), FileError);
}

TEST_F(ForeignFileTest, SurvivesTheDeathOfTheProcessThatReads) {
  const ForeignFile file(path);
  const std::vector<pid_t> reading = children();
  ASSERT_EQ(reading.size(), 1);
  ::kill(reading.front(), SIGSEGV);
  EXPECT_THAT(refusal(file), HasSubstr("result.h5: the process that read it died of signal 11"));
}

TEST_F(ForeignFileTest, DoesNotWaitForEver) {
  const ForeignFile file(path, 0.1);
  const std::vector<pid_t> reading = children();
  ASSERT_EQ(reading.size(), 1);
  ::kill(reading.front(), SIGSTOP);
  EXPECT_THAT(refusal(file), HasSubstr("result.h5: reading it was not done after 0.1 s"));
  EXPECT_THAT(children(), ElementsAre());
}

TEST_F(ForeignFileTest, LeavesNoProcessBehind) {
  { const ForeignFile file(path), other(path); }
  EXPECT_THAT(children(), ElementsAre());
}

// The lock of HDF5 that another thread holds is not held for ever in the process that reads.
TEST_F(ForeignFileTest, IsReadWhileAnotherThreadWrites) {
  std::atomic<bool> writes = true;
  std::thread writer([&] {
    while (writes) Hdf5Writer(folder / "other.h5").numbers("/numbers", std::vector<double>(4000, 1.5));
  });
  for (int k = 0; k < 10; ++k) {
    EXPECT_NO_THROW(EXPECT_EQ(ForeignFile(path, 10).number_attribute("time"), 5.0));
  }
  writes = false;
  writer.join();
}

}  // namespace
}  // namespace plumbline::foreign_file_test
