// Parameters that are each said once: their keys, and what settings say of them.
#include "cases/harness/description/parameters.hpp"

#include <gtest/gtest.h>

#include "cases/harness/files/errors.hpp"

namespace plumbline::parameters_test {
namespace {

struct Held {
  double mass = 3;
};

struct Swing : Parameters {
  double gravity = any_number("gravity", -20, "m/s^2", "along y");
  double share = within("share", 0.5, "1", 0, 1, "of something");
  double friction = not_negative("friction", 0, "1", "of the pivot");
  int points = integer({.name = "points", .value = 20.0, .low = 2, .description = "of the string"});
  std::string layout = one_of("layout", "ends", {"ends", "ppc"}, "of the points");
  std::optional<double> end = optional_number({.name = "end", .unit = "s", .description = "of the run"});
  bool one_way = yes_or_no("one_way", true, "whether the string carries no pressure");
  Held bob;
  explicit Swing(Parameters given = {}) : Parameters(std::move(given)) {
    bob.mass = positive("mass", bob.mass, "kg", "of the bob");
  }
};

TEST(Parameters, HoldTheirDefaults) {
  const Swing swing;
  EXPECT_EQ(swing.gravity, -20);
  EXPECT_EQ(swing.points, 20);
  EXPECT_EQ(swing.layout, "ends");
  EXPECT_FALSE(swing.end);
  EXPECT_TRUE(swing.one_way);
  EXPECT_EQ(swing.bob.mass, 3);
}

TEST(Parameters, HaveAKeyEachInTheirOrder) {
  const Settings settings(Swing().keys());
  std::vector<std::string> names, allowed;
  for (const Key& key : settings.keys()) {
    names.push_back(key.name);
    allowed.push_back(key.allowed());
    EXPECT_FALSE(key.description.empty()) << key.name;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"gravity", "share", "friction", "points", "layout", "end", "one_way", "mass"}));
  EXPECT_EQ(allowed,
            (std::vector<std::string>{"(-inf, inf) m/s^2", "(0, 1]", "[0, inf)", "whole number in [2, inf)",
                                      "one of ends, ppc", "(-inf, inf) s, or none", "one of yes, no", "(0, inf) kg"}));
}

TEST(Parameters, AreWhatTheSettingsSay) {
  Settings settings(Swing().keys());
  for (const char* typed : {"gravity=1", "points=7", "layout=ppc", "end=2", "one_way=no", "mass=0.5"})
    settings.set_text(typed, "toy");
  const Swing swing(settings);
  EXPECT_EQ(swing.gravity, 1);
  EXPECT_EQ(swing.points, 7);
  EXPECT_EQ(swing.layout, "ppc");
  EXPECT_EQ(swing.end, 2);
  EXPECT_FALSE(swing.one_way);
  EXPECT_EQ(swing.bob.mass, 0.5);
  EXPECT_THROW(settings.set_text("mass=0", "toy"), UsageError);
  EXPECT_THROW(settings.set_text("share=0", "toy"), UsageError);
  EXPECT_THROW(settings.set_text("points=2.5", "toy"), UsageError);
}

}  // namespace
}  // namespace plumbline::parameters_test
