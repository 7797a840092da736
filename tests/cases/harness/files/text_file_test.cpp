// Text files are there whole or not at all.
#include "cases/harness/files/text_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::text_file_test {
namespace {

TEST(TextFile, HoldsTheTextAndNothingIsBesideIt) {
  const TemporaryFolder folder;
  write_text_file(folder / "a.json", "one\n");
  write_text_file(folder / "a.json", "two\n");
  EXPECT_EQ(bytes(folder / "a.json"), "two\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.json"});
}

TEST(TextFile, TheReasonIsNamed) {
  const TemporaryFolder folder;
  try {
    write_text_file(folder / "nowhere/a.json", "x");
    FAIL() << "no such folder";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
    EXPECT_EQ(error.path, folder / "nowhere/a.json");
  }
}

TEST(TextFile, AFullDiskLeavesTheFileThatWasThere) {
  const TemporaryFolder folder;
  write_text_file(folder / "a.json", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // then writing fails as on a full disk
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_text_file(folder / "a.json", std::string(5000, 'x')), FileError);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(bytes(folder / "a.json"), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.json"}) << "nothing half-written is left";
}

TEST(TextFile, ADeviceStaysADevice) {
  write_text_file("/dev/null", "gone");
  struct stat status {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
  EXPECT_THROW(write_text_file("/dev/full", "x"), FileError);
}

TEST(TextFile, APipeIsWrittenTo) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { write_text_file(pipe, "through"); });
  EXPECT_EQ(bytes(pipe), "through");
  writer.join();
}

// Where a result stood somebody made a pipe, and nobody reads it.
TEST(SealedFile, APipeIsReplaced) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "result.h5";
  for (const bool flush : {false, true}) {
    std::filesystem::remove(pipe);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    write_sealed_file(pipe, "whole", flush);
    EXPECT_TRUE(std::filesystem::is_regular_file(pipe));
    EXPECT_EQ(bytes(pipe), "whole");
  }
}

TEST(TextFile, TemporaryNamesTellWhoseTheyAre) {
  const std::string name = temporary_name("results/a.h5");
  EXPECT_EQ(name.find("results/a.h5."), 0u);
  EXPECT_NE(name.find("-" + std::to_string(::getpid()) + ".part"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::text_file_test
