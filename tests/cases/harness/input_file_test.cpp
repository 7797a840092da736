#include "cases/harness/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "cases/harness/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline {
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
  const std::string bytes("a\0b\r\n\xff", 6), path = folder.path() + "/text";
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(read_text_file(path), bytes);
  std::filesystem::create_symlink(path, folder.path() + "/link");
  EXPECT_EQ(read_text_file(folder.path() + "/link"), bytes);
}

TEST(InputFile, WhatIsNoFileIsNotWaitedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() + "/pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop", folder.path() + "/loop");
  EXPECT_THAT(refusal(folder.path() + "/pipe"), HasSubstr("pipe"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("device"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("folder"));
  EXPECT_THAT(refusal(folder.path() + "/nowhere"), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal(folder.path() + "/loop"), HasSubstr("symbolic links"));
}

TEST(InputFile, HasALimit) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/large";
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, largest_text + 1);
  EXPECT_THAT(refusal(path), HasSubstr("more than"));
}

}  // namespace
}  // namespace plumbline
