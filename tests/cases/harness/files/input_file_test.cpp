#include "cases/harness/files/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::input_file_test {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& path) {
  try {
    read_text_file(path);
  } catch (const FileError& error) {
    EXPECT_EQ(error.path, path);
    return error.what();
  }
  return "read";
}

TEST(InputFile, IsReadByteByByte) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6), path = folder / "text";
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(read_text_file(path), bytes);
  std::filesystem::create_symlink(path, folder / "link");
  EXPECT_EQ(read_text_file(folder / "link"), bytes);
}

TEST(InputFile, WhatIsNoFileIsNotWaitedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_THAT(refusal(folder / "pipe"), HasSubstr("pipe"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("device"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("folder"));
  EXPECT_THAT(refusal(folder / "nowhere"), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal(folder / "loop"), HasSubstr("symbolic links"));
}

TEST(InputFile, LinksThatLeadNowhereAreNotThere) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  EXPECT_FALSE(is_there(folder / "loop") || is_there(folder / "dangling") || is_there(folder / "nothing"));
  EXPECT_TRUE(is_there(folder.path()));
}

TEST(InputFile, HasALimit) {
  const TemporaryFolder folder;
  const std::string path = folder / "large";
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, largest_text + 1);
  EXPECT_THAT(refusal(path), HasSubstr("more than"));
}

}  // namespace
}  // namespace plumbline::input_file_test
