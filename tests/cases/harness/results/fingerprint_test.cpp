// What a change of one object changes, and what it does not.
#include "cases/harness/results/fingerprint.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/temporary_folder.hpp"

namespace plumbline::fingerprint_test {
namespace {

// A program in small: the sources are real, the hashes are not.
std::vector<ObjectHash> objects() {
  return {{"kernel/simulation.cpp", "1", true},
          {"reference/riemann.cpp", "2", true},
          {"cases/harness/judge/gates.cpp", "3", true},
          {"cases/harness/laboratory/limits.cpp", "4", true},
          {"cases/harness/commands/run.cpp", "15", false},
          {"cases/catalog/gas/fill.cpp", "5", true},
          {"cases/catalog/gas/sod.cpp", "6", false},
          {"cases/catalog/gas/noh.cpp", "7", false},
          {"cases/catalog/membrane/string.cpp", "8", true},
          {"cases/catalog/membrane/pendulum.cpp", "9", false},
          {"cases/catalog/normals/marked_points.cpp", "10", true},
          {"cases/catalog/normals/cylinder.cpp", "11", false},
          {"cases/catalog/coupled/membrane.cpp", "12", true},
          {"cases/catalog/gas/tube_case.cpp", "13", true},
          {"cases/catalog/gas/lax.cpp", "14", false}};
}

const std::vector<std::pair<std::string, std::string>> uses{
    {"gas", "gas"}, {"normals", "coupled"}, {"coupled", "membrane"}, {"normals", "harness"}};

class Fingerprint : public testing::Test {
 protected:
  void TearDown() override { RegisterCode({}, {}); }

  static std::string of(const std::string& name) { return fingerprint(find_case(name)); }

  // The cases among these whose fingerprint is another one after a change of the object.
  static std::vector<std::string> changed_by(const std::string& source) {
    const std::vector<std::string> names{"sod", "noh", "lax", "pendulum", "normals-cylinder"};
    std::vector<std::string> before, changed;
    RegisterCode(objects(), uses);
    for (const std::string& name : names) before.push_back(of(name));
    std::vector<ObjectHash> others = objects();
    for (ObjectHash& object : others) {
      if (object.source == source) object.hash += "'";
    }
    RegisterCode(others, uses);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (of(names[k]) != before[k]) changed.push_back(names[k]);
    }
    return changed;
  }
};

using Names = std::vector<std::string>;
const Names all{"sod", "noh", "lax", "pendulum", "normals-cylinder"};

TEST_F(Fingerprint, IsAHashThatStaysAsLongAsTheCodeDoes) {
  RegisterCode(objects(), uses);
  const std::string first = of("sod");
  EXPECT_EQ(first.size(), 12u);
  EXPECT_NE(first, of("noh"));
  RegisterCode(objects(), uses);
  EXPECT_EQ(of("sod"), first);
  EXPECT_EQ(changed_by("no such object"), Names{});
}

TEST_F(Fingerprint, WhatIsBelowEveryCaseChangesAll) {
  EXPECT_EQ(changed_by("kernel/simulation.cpp"), all);
  EXPECT_EQ(changed_by("reference/riemann.cpp"), all);
  EXPECT_EQ(changed_by("cases/harness/judge/gates.cpp"), all);
  EXPECT_EQ(changed_by("cases/harness/laboratory/limits.cpp"), all);
}

TEST_F(Fingerprint, WhatPrintsResultsChangesNone) { EXPECT_EQ(changed_by("cases/harness/commands/run.cpp"), Names{}); }

TEST_F(Fingerprint, ACasesOwnObjectChangesItAlone) {
  EXPECT_EQ(changed_by("cases/catalog/gas/sod.cpp"), Names{"sod"});
  EXPECT_EQ(changed_by("cases/catalog/gas/noh.cpp"), Names{"noh"});
  EXPECT_EQ(changed_by("cases/catalog/gas/lax.cpp"), Names{"lax"});  // a description of a class that tubes share
}

TEST_F(Fingerprint, WhatAFolderSharesChangesItsCasesAndThoseOfFoldersThatIncludeIt) {
  EXPECT_EQ(changed_by("cases/catalog/gas/fill.cpp"), (Names{"sod", "noh", "lax"}));
  EXPECT_EQ(changed_by("cases/catalog/membrane/string.cpp"), (Names{"pendulum", "normals-cylinder"}));
  EXPECT_EQ(changed_by("cases/catalog/coupled/membrane.cpp"), Names{"normals-cylinder"});
  EXPECT_EQ(changed_by("cases/catalog/membrane/pendulum.cpp"), Names{"pendulum"});
}

TEST_F(Fingerprint, AnObjectWithAHeaderIsShared) {
  EXPECT_EQ(changed_by("cases/catalog/gas/tube_case.cpp"), (Names{"sod", "noh", "lax"}));
}

TEST_F(Fingerprint, APlugInChangesAllAndItsFileMustBeReadable) {
  const TemporaryFolder folder;
  RegisterCode(objects(), uses);
  const std::string before = of("sod");
  std::ofstream(folder / "mine.so") << "one";
  add_plugin_to_code(folder / "mine.so");
  const std::string with = of("sod");
  EXPECT_NE(with, before);
  RegisterCode(objects(), uses);
  std::ofstream(folder / "mine.so") << "two";
  add_plugin_to_code(folder / "mine.so");
  EXPECT_NE(of("sod"), before);
  EXPECT_NE(of("sod"), with);
  EXPECT_THROW(add_plugin_to_code(folder / "none.so"), FileError);
}

TEST_F(Fingerprint, IsEmptyWhereNothingIsTold) {
  EXPECT_EQ(of("sod"), "");
  EXPECT_EQ(code_fingerprint(), "");
  RegisterCode({{"kernel/simulation.cpp", "1", true}}, {});
  EXPECT_EQ(of("sod"), "") << "without its own object nothing is known of a case";
  EXPECT_NE(code_fingerprint(), "");
}

}  // namespace
}  // namespace plumbline::fingerprint_test
