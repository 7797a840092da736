// What was written is read; anything else is said to be damaged before HDF5 sees it.
#include "cases/harness/files/seal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::seal_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Seal : public ::testing::Test {
 protected:
  void SetUp() override {
    Hdf5Writer writer(file());
    writer.text("/note", "a note");
    writer.numbers("/numbers", std::vector<double>(1000, 0.5));
    writer.commit();
    whole_ = bytes(file());
  }
  std::string file() const { return folder_ / "a.h5"; }
  void write(const std::string& content) const { std::ofstream(file(), std::ios::binary) << content; }
  std::string refusal() const {
    try {
      check_seal(file());
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string whole_;
};

TEST_F(Seal, OfAWholeFileHolds) {
  EXPECT_EQ(whole_.substr(0, 10), "plumbline:");
  EXPECT_EQ(whole_.substr(seal_size, 4), "\x89HDF");
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(read_hdf5_text(file(), "/note"), "a note");
}

// [zlib]: the check value of CRC-32 is that of the digits 1 to 9.
TEST_F(Seal, ChecksumIsThatOfZlib) {
  std::string file = std::string(seal_size, 'x') + "123456789";
  seal(file);
  EXPECT_THAT(file, StartsWith(std::string("plumbline: 9 bytes follow byte 512, CRC-32 cbf43926\n\0\0", 54)));
  EXPECT_THAT(file, EndsWith(std::string("\0\0", 2) + "123456789"));
}

TEST_F(Seal, EveryChangedByteIsNoticed) {
  for (std::size_t at = seal_size; at < whole_.size(); at += 97) {
    std::string changed = whole_;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    write(changed);
    EXPECT_THAT(refusal(), HasSubstr("damaged")) << at;
    EXPECT_THROW(read_hdf5_text(file(), "/note"), FileError) << at;
  }
}

TEST_F(Seal, AShorterFileIsSaidToBeTruncated) {
  for (const std::size_t size : {std::size_t{600}, whole_.size() - 1}) {
    write(whole_.substr(0, size));
    EXPECT_THAT(refusal(), HasSubstr("truncated, " + std::to_string(size) + " of " + std::to_string(whole_.size())));
  }
  write(whole_ + "x");
  EXPECT_THAT(refusal(), HasSubstr("not what was written"));
}

TEST_F(Seal, ALostStartIsNoPlainFile) {
  for (const std::string& start : {std::string(seal_size, '\0'), std::string(seal_size, 'x'), std::string()}) {
    write(start + (start.empty() ? "" : whole_.substr(seal_size)));
    EXPECT_THAT(refusal(), HasSubstr("neither HDF5 nor a result file"));
  }
}

TEST_F(Seal, FilesOfOthersNeedNone) {
  write(whole_.substr(seal_size));
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace plumbline::seal_test
