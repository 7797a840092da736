// `default` is one definition per kind of scene; york1997 is York's own.
#include "cases/harness/description/schemes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/scene_cases.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::schemes_test {
namespace {

using testing::ElementsAre;

// What a case may choose for itself: geometry, points and end time. All other keys of its kind are numerical.
bool free_to_choose(const std::string& key) {
  constexpr std::array free{"cells", "ppc", "points", "offset", "membrane.ppc"};
  return std::find(free.begin(), free.end(), key) != free.end();
}

// The numerical settings that a scheme resolves to in a case, as text.
std::map<std::string, std::string> numerics(const Case& entry, const std::string& scheme) {
  std::map<std::string, std::string> chosen;
  const Settings settings = entry.settings(scheme, {});
  for (const Key& key : kind_keys(entry.kind)) {
    if (!free_to_choose(key.name)) chosen[key.name] = to_text(settings[key.name]);
  }
  return chosen;
}

std::map<std::string, std::string> definition(Kind kind) {
  std::map<std::string, std::string> defined;
  for (const Key& key : kind_keys(kind)) {
    if (!free_to_choose(key.name)) defined[key.name] = to_text(key.value);
  }
  if (kind == Kind::coupled) defined["membrane.strain"] = "segments";  // follows from normals=connectivity
  return defined;
}

TEST(Schemes, DefaultIsOneDefinitionPerKindInEveryCase) {
  ASSERT_FALSE(scene_cases().empty());
  const std::set<std::string> on_domains{"cook-panel", "cylinder-vibration"};
  for (const Case* entry : scene_cases()) {
    auto defined = definition(entry->kind);
    // Points that are sectors of a ring, or parallelograms of a panel, have domains that tile it; boxes of theirs would not. The
    // rings of a cylinder lose half as much on domains.
    const Settings settings = entry->settings("default", {});
    const bool polar = settings.has("layout") && settings.text("layout") == "polar";
    if (polar || on_domains.contains(entry->name)) defined["shape"] = "cpdi";
    EXPECT_EQ(numerics(*entry, "default"), defined) << entry->name << " changes a numerical choice of default";
  }
}

// The comparison above can fail: a case that sets a numerical key, at once or afterwards, is seen.
TEST(Schemes, ACaseThatChangesANumberOfDefaultIsSeen) {
  Toy toy;
  toy.choices = {{"dt", std::monostate{}}};
  EXPECT_EQ(numerics(toy_case(toy), "default"), definition(Kind::membrane));
  toy.choices = {{"dt", std::monostate{}}, {"cells", 7.0}, {"ppc", 2.0}};
  EXPECT_EQ(numerics(toy_case(toy), "default"), definition(Kind::membrane));
  toy.choices = {{"dt", std::monostate{}}, {"cfl", 0.4}};
  EXPECT_NE(numerics(toy_case(toy), "default"), definition(Kind::membrane));
  toy.choices = {{"dt", std::monostate{}}, {"shape", "cubic"}};
  EXPECT_NE(numerics(toy_case(toy), "default"), definition(Kind::membrane));
  EXPECT_NE(numerics(toy_case(), "default"), definition(Kind::membrane)) << "a fixed step is numerical, too";
}

// The energy-conserving leapfrog on cubic B-splines with sharpened APIC, filtered at a rate, for gas; a symplectic step for
// membranes.
TEST(Schemes, DefaultOfGas) {
  const Settings settings(kind_keys(Kind::gas));
  EXPECT_EQ(settings.text("integrator"), "leapfrog");
  EXPECT_EQ(settings.text("shape"), "cubic");
  EXPECT_EQ(settings.text("transfer"), "apic");
  EXPECT_EQ(settings.text("density"), "grid");
  EXPECT_EQ(settings.text("points"), "equal-mass");
  EXPECT_EQ(settings.number("ppc"), 8);
  EXPECT_EQ(settings.number("cfl"), 0.5);
  EXPECT_FALSE(settings.is_set("dt"));
  EXPECT_EQ(settings.number("sharpening"), 1);
  EXPECT_EQ(settings.text("motion"), "sharpened");
  EXPECT_EQ(settings.text("read_off"), "sharpened");
  EXPECT_EQ(settings.text("pressure_at"), "points");
  EXPECT_EQ(settings.number("quadrature"), 0.1);
  EXPECT_EQ(settings.number("filter.sound"), 2);
  EXPECT_EQ(settings.number("filter.compression"), 4);
  EXPECT_EQ(settings.number("heat_exchange"), 4);
  EXPECT_EQ(settings.text("viscosity.closing"), "limited");
  EXPECT_EQ(settings.number("viscosity.linear"), 0);
  EXPECT_EQ(settings.number("viscosity.quadratic"), 0.25);
}

// The gas's step, with what membranes lose given to the gas.
TEST(Schemes, DefaultOfGasAndMembranes) {
  const Settings settings(kind_keys(Kind::coupled)), gas(kind_keys(Kind::gas));
  for (const char* key :
       {"integrator", "shape", "transfer", "density", "sharpening", "motion", "read_off", "filter.sound",
        "filter.compression", "heat_exchange", "viscosity.closing", "viscosity.linear", "viscosity.quadratic"}) {
    EXPECT_EQ(to_text(settings[key]), to_text(gas[key])) << key;
  }
  EXPECT_EQ(settings.number("cfl"), 0.9);
  EXPECT_EQ(settings.text("membrane.loss"), "gas");
  EXPECT_EQ(settings.number("membrane.relaxation"), 0.5);
  EXPECT_EQ(settings.text("normals"), "connectivity");
  EXPECT_FALSE(settings.has("split"));
  EXPECT_FALSE(settings.has("pressure_at"));
  EXPECT_FALSE(settings.has("quadrature"));
}

// Points of a gas whose pressures act at the nodes move by the integrals of the shape's kernels. [Pressure 4]
TEST(Schemes, PressuresAtNodesWantAShapeWhoseIntegralsAreKnown) {
  const Case& tube = find_case("sod");
  for (const char* shape : {"linear", "quadratic", "cubic"}) {
    EXPECT_NO_THROW(tube.settings("default", {},
                                  {"integrator=musl", "split=0", "pressure_at=nodes", "shape=" + std::string(shape)}));
  }
  for (const char* shape : {"gimp", "cpdi"}) {
    EXPECT_NO_THROW(tube.settings("default", {}, {"integrator=musl", "split=0", "shape=" + std::string(shape)}));
    EXPECT_THROW(tube.settings("default", {},
                               {"integrator=musl", "split=0", "pressure_at=nodes", "shape=" + std::string(shape)}),
                 UsageError);
  }
}

// What cannot work together is refused, naming both choices; nothing is silently replaced.
TEST(Schemes, MembraneChoicesFollowOrExcludeEachOther) {
  const Case& bag = find_case("membrane-expansion");
  EXPECT_EQ(bag.settings("default", {}).text("membrane.strain"), "segments");
  EXPECT_EQ(bag.settings("default", {}, {"normals=modern"}).text("membrane.strain"), "accumulated");
  const auto refuses = [&](const std::vector<std::string>& typed, const std::string& first, const std::string& second) {
    try {
      bag.settings("default", {}, typed);
      ADD_FAILURE() << first << " with " << second << " is accepted";
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(first), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(second), std::string::npos) << error.what();
    }
  };
  refuses({"normals=modern", "membrane.strain=segments"}, "normals=modern", "membrane.strain=segments");
  refuses({"integrator=musl"}, "membrane.loss=gas", "integrator=musl");
  refuses({"integrator=musl", "membrane.loss=booked", "shape=gimp"}, "membrane.relaxation=0.5", "shape=gimp");
}

TEST(Schemes, DefaultOfMembranes) {
  const Settings settings(kind_keys(Kind::membrane));
  EXPECT_EQ(settings.text("integrator"), "leapfrog");
  EXPECT_EQ(settings.text("shape"), "quadratic");
  EXPECT_EQ(settings.text("transfer"), "apic");
  EXPECT_EQ(settings.number("cfl"), 0.5);
  EXPECT_FALSE(settings.has("viscosity.linear"));
}

// [York chapter 3]: linear shapes, FLIP, the momentum form with a second map. Sections 4.1 and 5.5 fix the steps.
TEST(Schemes, York1997IsYorks) {
  for (const Case* entry : scene_cases()) {
    const Settings settings = entry->settings("york1997", {});
    EXPECT_EQ(settings.text("shape"), "linear") << entry->name;
    EXPECT_EQ(settings.text("transfer"), "flip") << entry->name;
    EXPECT_EQ(settings.text("integrator"), "musl") << entry->name;
    const std::set<std::string> published{"sod", "two-bar", "two-disks", "ball-net"};
    const std::set<std::string> at_rest{"normals-cell", "normals-first-step",
                                        "normals-surface"};  // one step, in which nothing moves
    const std::set<std::string> in_space{"balloon",      "breathing-sphere", "circular-membrane",  // he ran none
                                         "drum",         "mylar-balloon",    "sheared-sheet",     "twisted-annulus",
                                         "pulled-strip", "spinning-band",    "square-airbag",     "turning-cap"};
    const bool his_own = published.count(entry->name) ||  // their steps are given
                         (entry->kind == Kind::membrane && !at_rest.count(entry->name) && !in_space.count(entry->name));
    EXPECT_NE(settings.is_set("dt"), settings.is_set("cfl")) << entry->name;
    EXPECT_TRUE(entry->kind == Kind::coupled || settings.is_set("dt") == his_own) << entry->name;
    if (entry->kind == Kind::coupled) {
      EXPECT_EQ(settings.text("membrane.loss"), "booked") << entry->name;
      EXPECT_EQ(settings.number("membrane.relaxation"), 0) << entry->name;
      EXPECT_EQ(settings.number("viscosity.quadratic"), 0) << entry->name;
    }
    if (entry->kind != Kind::gas) continue;
    EXPECT_EQ(settings.number("sharpening"), 0) << entry->name;
    EXPECT_EQ(settings.number("heat_exchange"), 0) << entry->name;
    EXPECT_EQ(settings.text("density"), "quadratic") << entry->name;
    EXPECT_EQ(settings.text("points"), "equal-volume") << entry->name;
    EXPECT_EQ(settings.number("viscosity.linear"), 1) << entry->name;
    const bool one_at_a_time = entry->name == "uniform-compression";  // both together have no closed form
    EXPECT_EQ(settings.number("viscosity.quadratic"), one_at_a_time ? 0 : 1) << entry->name;
  }
}

TEST(Schemes, EveryNameHasTitleAndSource) {
  for (const std::string& scheme : scheme_names()) {
    EXPECT_FALSE(scheme_title(scheme).empty());
    EXPECT_FALSE(scheme_source(scheme).empty());
  }
  EXPECT_NE(scheme_title("default"), scheme_title("york1997"));
  EXPECT_TRUE(scheme_choices("default", Kind::gas).empty());
  EXPECT_NE(name(Kind::gas), name(Kind::membrane));
}

TEST(Schemes, EveryPartMayBeChosen) {
  const auto choices = [](Kind kind, const char* name) {
    const std::vector<Key> keys = kind_keys(kind);
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
    return key == keys.end() ? std::vector<std::string>{} : key->choices;
  };
  EXPECT_EQ(choices(Kind::gas, "integrator").size(), integrators().size());
  EXPECT_THAT(choices(Kind::gas, "shape"), ElementsAre("contiguous-gimp", "cpdi", "cubic", "gimp", "lagrangian-cubic",
                                                       "lagrangian-quadratic", "linear", "quadratic"));
  EXPECT_THAT(choices(Kind::gas, "transfer"), ElementsAre("apic", "blend", "flip", "fmpm", "pic", "xpic"));
  EXPECT_THAT(choices(Kind::gas, "density"), ElementsAre("cell", "quadratic", "continuity", "grid"));
  EXPECT_THAT(choices(Kind::solid, "contact"),
              ElementsAre("none", "pairs", "default", "york-9.7", "york-9.8", "york-9.9"));
}

}  // namespace
}  // namespace plumbline::schemes_test
