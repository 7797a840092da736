// Files that are whole or not there.
#include "cases/harness/files/hdf5_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::hdf5_file_test {
namespace {

std::vector<double> read_numbers(const std::string& file, const std::string& path) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(handle, path.c_str(), H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  const herr_t status = H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(handle);
  if (status < 0) throw std::runtime_error("cannot read " + path);
  return values;
}

std::int64_t read_number_attribute(const std::string& file, const std::string& object, const std::string& name) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(handle, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  std::int64_t value = 0;
  H5Aread(attribute, H5T_NATIVE_INT64, &value);
  H5Aclose(attribute);
  H5Fclose(handle);
  return value;
}

std::string read_text_attribute(const std::string& file, const std::string& object, const std::string& name) {
  const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(handle, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), '\0');
  H5Aread(attribute, type, text.data());
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(handle);
  return text.substr(0, text.find('\0'));
}

void write_something(Hdf5Writer& file) {
  file.attribute("/", "kind", "run");
  file.attribute("/", "plumbline_format", std::int64_t{1});
  file.text("/note", "density ρ, γ = 1.4");
  file.numbers("/ledger/energy/time", std::vector<double>{0, 0.1, -1e300});
  file.group("/deep/er");
  file.attribute("/deep/er", "label", "");
}

TEST(Hdf5File, WhatIsWrittenIsReadBack) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.h5";
  {
    Hdf5Writer file(path);
    write_something(file);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    file.numbers("/odd", std::vector<double>{nan, std::numeric_limits<double>::infinity(), 5e-324});
    file.numbers("/none", {});
    file.text("/empty", "");
    file.commit();
  }
  EXPECT_EQ(read_hdf5_text(path, "/note"), "density ρ, γ = 1.4");
  EXPECT_EQ(read_hdf5_text(path, "/empty"), "");
  EXPECT_EQ(read_numbers(path, "/ledger/energy/time"), (std::vector<double>{0, 0.1, -1e300}));
  EXPECT_TRUE(std::isnan(read_numbers(path, "/odd")[0]));
  EXPECT_TRUE(std::isinf(read_numbers(path, "/odd")[1]));
  EXPECT_EQ(read_numbers(path, "/odd")[2], 5e-324);
  EXPECT_TRUE(read_numbers(path, "/none").empty());
  EXPECT_EQ(read_text_attribute(path, "/", "kind"), "run");
  EXPECT_EQ(read_text_attribute(path, "/deep/er", "label"), "");
  EXPECT_EQ(read_number_attribute(path, "/", "plumbline_format"), 1);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"}) << "nothing temporary is left";
}

TEST(Hdf5File, IsNotThereBeforeItIsWhole) {
  const TemporaryFolder folder;
  Hdf5Writer file(folder / "a.h5");
  write_something(file);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
  file.commit();
  EXPECT_TRUE(std::filesystem::exists(folder / "a.h5"));
}

TEST(Hdf5File, AWriterThatIsGivenUpLeavesNothing) {
  const TemporaryFolder folder;
  {
    Hdf5Writer file(folder / "a.h5");
    write_something(file);
  }
  EXPECT_TRUE(folder.names().empty());
  try {
    Hdf5Writer file(folder / "a.h5");
    write_something(file);
    throw std::runtime_error("half-way");
  } catch (const std::runtime_error&) {}
  EXPECT_TRUE(folder.names().empty());
}

TEST(Hdf5File, AWriterThatIsGivenUpLeavesTheFileBeforeIt) {
  const TemporaryFolder folder;
  {
    Hdf5Writer file(folder / "a.h5");
    file.text("/note", "first");
    file.commit();
  }
  {
    Hdf5Writer file(folder / "a.h5");
    file.text("/note", "second");
  }
  EXPECT_EQ(read_hdf5_text(folder / "a.h5", "/note"), "first");
  Hdf5Writer file(folder / "a.h5");
  file.text("/note", "third");
  file.commit();
  EXPECT_EQ(read_hdf5_text(folder / "a.h5", "/note"), "third");
}

// Root may write anywhere, so a file stands where a folder should.
TEST(Hdf5File, WhereNothingCanBeWrittenIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  std::filesystem::create_directories(folder / "taken.h5/inside");
  for (const char* name : {"file/a.h5", "no/such/a.h5", "taken.h5"}) {
    Hdf5Writer writer(folder / name);
    writer.text("/note", "x");
    EXPECT_THROW(writer.commit(), FileError) << name;
  }
}

TEST(Hdf5File, WritingTwiceToOnePlaceIsAnError) {
  const TemporaryFolder folder;
  Hdf5Writer file(folder / "a.h5");
  file.text("/note", "x");
  EXPECT_THROW(file.text("/note", "y"), FileError);
  EXPECT_THROW(file.attribute("/no/such", "name", "y"), FileError);
}

TEST(Hdf5File, WhatCannotBeReadIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_hdf5_text(folder / "none.h5", "/note"), FileError);
  std::ofstream(folder / "text.h5") << "this is no HDF5 file";
  EXPECT_THROW(read_hdf5_text(folder / "text.h5", "/note"), FileError);
  {
    Hdf5Writer file(folder / "a.h5");
    write_something(file);
    file.commit();
  }
  EXPECT_THROW(read_hdf5_text(folder / "a.h5", "/other"), FileError);
  std::filesystem::resize_file(folder / "a.h5", std::filesystem::file_size(folder / "a.h5") / 2);
  EXPECT_THROW(read_hdf5_text(folder / "a.h5", "/note"), FileError);
}

// Of a chunked data set only the chunks that were written are stored: this one claims 8 MB, and stores none of them.
TEST(Hdf5File, WhatClaimsToBeLargerThanItIsStoredIsAnError) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.h5";
  const hsize_t count = 1 << 20, chunk = 4096;
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(1, &count, nullptr), layout = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(layout, 1, &chunk);
  H5Dclose(H5Dcreate2(file, "claim", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, layout, H5P_DEFAULT));
  H5Pclose(layout);
  H5Sclose(space);
  H5Fclose(file);
  EXPECT_THROW(Hdf5Reader(path).numbers("claim"), FileError);
}

// Read as one number, more of them would be written over what stands behind it.
TEST(Hdf5File, AnAttributeOfSeveralNumbersIsNotOne) {
  const TemporaryFolder folder;
  Hdf5Writer file(folder / "a.h5");
  file.integers_attribute("/", "version", {1, 0, 7});
  file.attribute("/", "format", std::int64_t{3});
  file.commit();
  EXPECT_EQ(Hdf5Reader(folder / "a.h5").attribute("/", "format"), 3);
  EXPECT_THROW(Hdf5Reader(folder / "a.h5").attribute("/", "version"), FileError);
}

// HDF5 may stamp objects with the second in which they were made: over a second later the bytes must be the same.
TEST(Hdf5File, TheSameContentGivesTheSameBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a.h5", "b.h5"}) {
    Hdf5Writer file(folder / name);
    write_something(file);
    file.commit();
    if (name[0] == 'a') std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  }
  EXPECT_GT(bytes(folder / "a.h5").size(), 100u);
  EXPECT_TRUE(bytes(folder / "a.h5") == bytes(folder / "b.h5"));
}

}  // namespace
}  // namespace plumbline::hdf5_file_test
