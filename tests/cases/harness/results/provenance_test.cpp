// Where a result comes from.
#include "cases/harness/results/provenance.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <vector>

namespace plumbline::provenance_test {
namespace {

std::string stored(std::vector<const char*> words) {
  return stored_command(static_cast<int>(words.size()), words.data());
}

TEST(StoredCommand, IsWhatWasTypedUnderTheProgramsOwnName) {
  EXPECT_EQ(stored({"build/bin/plumbline", "run", "sod", "--cells", "200", "--set", "cfl=0.1"}),
            "plumbline run sod --cells 200 --set cfl=0.1");
  EXPECT_EQ(stored({"plumbline"}), "plumbline");
}

TEST(StoredCommand, LeavesOutWhereResultsGo) {
  EXPECT_EQ(stored({"p", "run", "sod", "--results", "some/folder", "--json", "-"}), "plumbline run sod");
  EXPECT_EQ(stored({"p", "verify", "--results=x", "--json=a/b.json", "--junit=j.xml", "sod"}), "plumbline verify sod");
  EXPECT_EQ(stored({"p", "verify", "--junit", "j.xml", "sod", "--tier", "full"}), "plumbline verify sod --tier full");
}

TEST(StoredCommand, LeavesOutDirectories) {
  EXPECT_EQ(stored({"p", "run", "sod", "--plugin", "some/where/libmine.so"}), "plumbline run sod --plugin libmine.so");
  EXPECT_EQ(stored({"p", "run", "sod", "--plugin=some/where/libmine.so"}).find("some"), std::string::npos);
}

TEST(StoredCommand, AnOptionWithoutItsValueDoesNoHarm) {
  EXPECT_EQ(stored({"p", "run", "sod", "--json"}), "plumbline run sod");
}

TEST(BuildProvenance, IsFilled) {
  const Provenance p = build_provenance();
  for (const std::string& text : {p.version, p.compiler, p.flags, p.cpu, p.instruction_set}) EXPECT_FALSE(text.empty());
  for (const char* library : {"eigen", "hdf5", "gsl", "boost", "fmt", "cli11", "nlohmann_json"}) {
    ASSERT_TRUE(p.libraries.count(library)) << library;
    EXPECT_FALSE(p.libraries.at(library).empty()) << library;
  }
  EXPECT_TRUE(std::regex_match(p.started, std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)"))) << p.started;
  EXPECT_TRUE(p.command.empty());
}

}  // namespace
}  // namespace plumbline::provenance_test
