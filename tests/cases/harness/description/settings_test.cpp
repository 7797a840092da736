// Keys, their ranges, and the text from which a run's name is made.
#include "cases/harness/description/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "cases/harness/files/errors.hpp"

namespace plumbline::settings_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Key> keys() {
  return {{.name = "cells", .value = 100.0, .low = 2, .high = 1e6, .integer = true},
          {.name = "shape", .value = std::string("linear"), .choices = {"linear", "quadratic", "cubic"}},
          {.name = "cfl", .value = 0.3, .low = 0, .low_open = true, .optional = true},
          {.name = "dt", .value = std::monostate{}, .unit = "s", .low = 0, .low_open = true, .optional = true},
          {.name = "offset", .value = 0.0, .low = 0, .high = 1, .high_open = true},
          {.name = "velocity", .value = -2.5, .unit = "m/s"}};
}

// What a call that must be refused says.
template <class Call>
UsageError refusal(Call&& call) {
  try {
    call();
  } catch (const UsageError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {"", "", "", {}, ""};
}

UsageError refused(const std::string& assignment) {
  Settings settings(keys());
  const UsageError error = refusal([&] { settings.set_text(assignment, "sod"); });
  EXPECT_TRUE(settings == Settings(keys())) << assignment << " was refused but changed something";
  return error;
}

Settings after(const std::string& assignment) {
  Settings settings(keys());
  settings.set_text(assignment, "sod");
  return settings;
}

TEST(Settings, GivesTheDefaultsAsDeclared) {
  const Settings settings(keys());
  EXPECT_EQ(settings.number("cfl"), 0.3);
  EXPECT_EQ(settings.integer("cells"), 100);
  EXPECT_EQ(settings.text("shape"), "linear");
  EXPECT_TRUE(settings.is_set("cfl"));
  EXPECT_FALSE(settings.is_set("dt"));
  EXPECT_TRUE(settings.has("dt"));
  EXPECT_FALSE(settings.has("cflx"));
  EXPECT_THROW(settings["cflx"], std::out_of_range);
}

TEST(Settings, TakesValuesAsTyped) {
  EXPECT_EQ(after("cells=200").integer("cells"), 200);
  EXPECT_EQ(after("cfl=5").number("cfl"), 5);
  EXPECT_EQ(after("cfl=1e-3").number("cfl"), 1e-3);
  EXPECT_EQ(after("velocity=-1.5e2").number("velocity"), -150);
  EXPECT_EQ(after("shape=cubic").text("shape"), "cubic");
  EXPECT_FALSE(after("cfl=none").is_set("cfl"));
  EXPECT_EQ(after("dt=1e-4").number("dt"), 1e-4);
}

TEST(Settings, EndsOfRangesAreClosedUnlessOpen) {
  EXPECT_EQ(after("cells=2").integer("cells"), 2);
  EXPECT_EQ(after("cells=1000000").integer("cells"), 1000000);
  EXPECT_EQ(after("offset=0").number("offset"), 0);
  for (const char* out : {"cells=1", "cells=1000001", "cfl=0", "cfl=-1", "offset=1", "offset=-1e-300", "dt=0"}) {
    EXPECT_FALSE(refused(out).allowed.empty()) << out;
  }
}

TEST(Settings, RefusalNamesKeyValueAndRange) {
  const UsageError error = refused("offset=1.5");
  EXPECT_EQ(error.key, "offset");
  EXPECT_EQ(error.value, "1.5");
  EXPECT_EQ(error.allowed, "[0, 1)");
  EXPECT_EQ(refused("dt=-1").allowed, "(0, inf) s, or none");
  EXPECT_EQ(refused("cells=0").allowed, "whole number in [2, 1000000]");
  EXPECT_NE(std::string(error.what()).find("offset = 1.5"), std::string::npos);
}

TEST(Settings, WholeNumbersAreWhole) { EXPECT_EQ(refused("cells=100.5").key, "cells"); }

TEST(Settings, NumbersThatAreNoneAreRefused) {
  for (const char* text : {"cfl=nan", "cfl=inf", "cfl=-inf", "cfl=1e999", "cfl=1e-999", "cfl=", "cfl=0.3x", "cfl= 0.3",
                           "cfl=0,3", "cfl=0x10", "velocity=fast", "velocity=nan", "velocity=infinity"}) {
    EXPECT_EQ(refused(text).key, std::string(text).substr(0, std::string(text).find('='))) << text;
  }
}

TEST(Settings, OnlyOptionalKeysMayBeNone) {
  EXPECT_EQ(refused("cells=none").key, "cells");
  EXPECT_EQ(refused("shape=none").value, "none");
}

TEST(Settings, ChoicesOfferTheNearest) {
  const UsageError error = refused("shape=quadratc");
  EXPECT_EQ(error.key, "shape");
  ASSERT_FALSE(error.nearest.empty());
  EXPECT_EQ(error.nearest.front(), "quadratic");
  EXPECT_EQ(refused("shape=3").key, "shape");
}

TEST(Settings, AnUnknownKeyOffersTheNearest) {
  for (const char* assignment : {"cflx=1", "cflx=none", "cflx=fast"}) {
    const UsageError error = refused(assignment);
    EXPECT_EQ(error.key, "cflx");
    ASSERT_FALSE(error.nearest.empty());
    EXPECT_EQ(error.nearest.front(), "cfl");
    EXPECT_NE(std::string(error.what()).find("key of sod"), std::string::npos);
  }
}

TEST(Settings, AnAssignmentHasAKeyAndAnEqualsSign) {
  for (const char* text : {"cfl", "=5", "", "="}) {
    const UsageError error = refused(text);
    EXPECT_EQ(error.key, "--set");
    EXPECT_EQ(error.allowed, "key=value");
  }
  EXPECT_EQ(refused("cfl=1=2").key, "cfl");
}

// A number that may also be left to a word.
TEST(Settings, WordsStandForNumbers) {
  const auto with_words = [] {
    return Settings(
        {{.name = "cfl", .value = 0.3, .low = 0, .low_open = true, .optional = true, .words = {"auto", "safe"}}});
  };
  Settings settings = with_words();
  settings.set_text("cfl=auto", "sod");
  EXPECT_EQ(settings.text("cfl"), "auto");
  EXPECT_TRUE(settings.is_set("cfl"));
  EXPECT_NE(settings.canonical().find("cfl=auto"), std::string::npos);
  settings.set_text("cfl=0.7", "sod");
  EXPECT_EQ(settings.number("cfl"), 0.7);
  settings.set_text("cfl=none", "sod");
  EXPECT_FALSE(settings.is_set("cfl"));
  settings.set("cfl", std::string("safe"), "sod");
  EXPECT_EQ(settings.text("cfl"), "safe");
  for (const char* text : {"cfl=aut", "cfl=AUTO", "cfl=-1", "cfl=auto "}) {
    const UsageError error = refusal([&] { settings.set_text(text, "sod"); });
    EXPECT_EQ(error.allowed, "(0, inf), or auto, or safe, or none") << text;
  }
  EXPECT_THROW(settings.set("cfl", std::string("linear"), "sod"), UsageError);
  EXPECT_EQ(refused("cfl=auto").key, "cfl");  // of a key without words
}

TEST(Settings, SetFromCodeChecksLikewise) {
  Settings settings(keys());
  EXPECT_EQ(refusal([&] { settings.set("cells", 1.0, "sod"); }).key, "cells");
  EXPECT_EQ(refusal([&] { settings.set("cells", "many", "sod"); }).key, "cells");
  EXPECT_EQ(refusal([&] { settings.set("cfl", infinity, "sod"); }).key, "cfl");
  EXPECT_EQ(refusal([&] { settings.set("clls", 10.0, "sod"); }).nearest.front(), "cells");
  settings.set("dt", 0.5, "sod");
  EXPECT_EQ(settings.number("dt"), 0.5);
}

TEST(Settings, CanonicalTextDoesNotDependOnTheOrderOfKeys) {
  auto turned = keys();
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(Settings(turned).canonical(), Settings(keys()).canonical());
  EXPECT_EQ(Settings(keys()).canonical(), "cells=100\ncfl=0.3\ndt=none\noffset=0\nshape=linear\nvelocity=-2.5\n");
}

TEST(Settings, CanonicalTextKeepsEveryDigit) {
  Settings settings(keys());
  settings.set("velocity", 0.1 + 0.2, "sod");
  Settings other(keys());
  other.set("velocity", 0.3, "sod");
  EXPECT_NE(settings.canonical(), other.canonical());
  EXPECT_FALSE(settings == other);
  for (const double number : {0.1, 1.0 / 3, 1e-300, 1e22, 123456789.123456789, -0.30000000000000004}) {
    EXPECT_EQ(std::stod(to_text(number)), number);
  }
}

TEST(Settings, EveryKeyChangesTheCanonicalText) {
  const std::string before = Settings(keys()).canonical();
  for (const char* change :
       {"cells=101", "shape=cubic", "cfl=none", "cfl=0.30000000000000004", "dt=1", "offset=0.5", "velocity=1"}) {
    EXPECT_NE(after(change).canonical(), before) << change;
  }
}

// FNV-1a, 64 bit: published values of the empty text, "a" and "foobar" are cbf29ce484222325, af63dc4c8601ec8c and
// 85944171f73967e8 (Fowler, Noll, Vo; RFC 9923); names of files keep the last twelve digits.
TEST(Settings, TheHashIsFnv1a) {
  EXPECT_EQ(short_hash(""), "9ce484222325");
  EXPECT_EQ(short_hash("a"), "dc4c8601ec8c");
  EXPECT_EQ(short_hash("foobar"), "4171f73967e8");
}

TEST(Settings, RangesAreWrittenForPeople) {
  EXPECT_EQ((Key{.name = "x", .value = 1.0}.allowed()), "(-inf, inf)");
  EXPECT_EQ(
      (Key{.name = "x", .value = 1.0, .unit = "m", .low = 0, .high = 2, .low_open = true, .high_open = true}.allowed()),
      "(0, 2) m");
  EXPECT_EQ((Key{.name = "s", .value = std::string("a"), .choices = {"a", "b"}}.allowed()), "one of a, b");
}

}  // namespace
}  // namespace plumbline::settings_test
