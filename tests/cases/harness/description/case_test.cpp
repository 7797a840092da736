// The registry of cases, how a run's choices are resolved, and what every case must declare.
#include "cases/harness/description/case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/judge/study.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::case_test {
namespace {

TEST(Cases, StandInTheOrderOfTheirNames) {
  std::vector<std::string> names;
  for (const Case* entry : cases()) names.push_back(entry->name);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_NE(std::find(names.begin(), names.end(), "sod"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "spring-mass"), names.end());
}

TEST(Cases, AreFoundByNameAndAnUnknownNameOffersTheNearest) {
  EXPECT_EQ(find_case("sod").name, "sod");
  try {
    find_case("spring-mas");
    FAIL() << "found what is not there";
  } catch (const UsageError& error) {
    ASSERT_FALSE(error.nearest.empty());
    EXPECT_EQ(error.nearest.front(), "spring-mass");
    EXPECT_EQ(error.value, "spring-mas");
    EXPECT_NE(error.allowed.find("sod"), std::string::npos);
  }
}

TEST(Cases, VaryHasFourNames) {
  for (const char* text : {"cells", "dt", "ppc", "offset"}) EXPECT_EQ(name(vary_from(text)), text);
  EXPECT_THROW(vary_from("cell"), UsageError);
}

// Scheme, then the case's own choices, then overrides, then what was typed, then the step that follows from all of these.
TEST(Cases, LaterChoicesWin) {
  Toy toy;
  toy.choices = {{"cells", 20.0}, {"ppc", 2.0}, {"dt", std::monostate{}}};
  toy.york_step = [](const Settings& settings) { return Override{"dt", 1 / settings.number("cells")}; };
  const Case entry = toy_case(toy);
  EXPECT_EQ(entry.settings("default", {}).integer("cells"), 20);
  EXPECT_EQ(entry.settings("york1997", {}).text("shape"), "linear");
  EXPECT_EQ(entry.settings("york1997", {{"shape", "cubic"}}).text("shape"), "cubic");
  const Settings typed = entry.settings("york1997", {{"cells", 30.0}}, {"cells=40", "ppc=1"});
  EXPECT_EQ(typed.integer("cells"), 40);
  EXPECT_EQ(typed.integer("ppc"), 1);
  EXPECT_EQ(typed.number("dt"), 1.0 / 40);
  EXPECT_EQ(entry.settings("york1997", {}, {"dt=1e-5"}).number("dt"), 1e-5);
  EXPECT_FALSE(entry.settings("default", {}).is_set("dt"));
}

TEST(Cases, AnUnknownSchemeOffersTheNearest) {
  try {
    find_case("sod").settings("york1998", {});
    FAIL();
  } catch (const UsageError& error) {
    ASSERT_FALSE(error.nearest.empty());
    EXPECT_EQ(error.nearest.front(), "york1997");
  }
}

TEST(Cases, CombinationsThatCannotWorkAreRefusedNamingBoth) {
  for (const std::vector<std::string>& typed : {std::vector<std::string>{"shape=linear"}, {"transfer=flip"}}) {
    try {
      find_case("sod").settings("default", {}, typed);
      FAIL() << typed.front();
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("integrator=leapfrog"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(typed.front()), std::string::npos);
    }
  }
}

TEST(Cases, ARunNeedsAStep) {
  try {
    find_case("sod").settings("default", {}, {"cfl=none"});
    FAIL() << "neither cfl nor dt is set";
  } catch (const UsageError& error) {
    EXPECT_EQ(error.key, "cfl");
  }
  EXPECT_NO_THROW(find_case("sod").settings("default", {}, {"cfl=none", "dt=1e-4"}));
}

// --- what every registered case must declare ----------------------------------------------------------------------

// visit(case) for all of them, each failure with its name.
template <class Visit>
void for_every_case(Visit&& visit) {
  for (const Case* entry : cases()) {
    SCOPED_TRACE(entry->name);
    visit(*entry);
  }
}

TEST(EveryCase, SaysWhatItIs) {
  for_every_case([](const Case& entry) {
    const Statement s = entry.statement();
    for (const std::string& text :
         {s.title, s.source, s.claim, s.physics, s.sketch, s.reference_name, s.reference_text, s.reference_bound}) {
      EXPECT_FALSE(text.empty());
    }
    EXPECT_FALSE(s.equations.empty());
    for (const Statement::TheoryOrder& order : s.theory_orders) EXPECT_FALSE(order.why.empty());
    EXPECT_NE(s.sketch.find("</svg>"), std::string::npos);
    EXPECT_EQ(s.cells_along.empty(), !entry.trials.empty());
  });
}

TEST(EveryCase, HasNoKeyTwice) {
  for_every_case([](const Case& entry) {
    std::set<std::string> names;
    const Settings settings = entry.settings("default", {});
    for (const Key& key : settings.keys()) {
      EXPECT_TRUE(names.insert(key.name).second) << key.name;
      EXPECT_FALSE(key.description.empty()) << key.name;
    }
  });
}

TEST(EveryCase, StudiesAndGatesHaveNamesOfTheirOwn) {
  for_every_case([](const Case& entry) {
    std::set<std::string> studies, gates;
    for (const StudyPlan& plan : entry.studies) {
      EXPECT_TRUE(studies.insert(plan.id).second) << plan.id;
      EXPECT_FALSE(plan.why.empty()) << plan.id;
      EXPECT_FALSE(plan.values.empty()) << plan.id;
    }
    for (const CaseGate& gate : entry.gates) EXPECT_TRUE(gates.insert(gate.gate.id).second) << gate.gate.id;
  });
}

// A gate whose level its study lacks in that tier would never be judged.
TEST(EveryCase, GatesAreCompleteAndReadLevelsThatTheirStudyHas) {
  for_every_case([](const Case& entry) {
    const std::vector<StudyPlan> plans = entry.studies;
    for (const CaseGate& declared : entry.gates) {
      EXPECT_NO_THROW(validate(declared.gate)) << declared.gate.id;
      if (declared.study.rfind("integrator/", 0) == 0) continue;  // made by verify for every integrator
      const auto plan = std::find_if(plans.begin(), plans.end(),
                                     [&](const StudyPlan& p) { return p.id == declared.study; });
      ASSERT_NE(plan, plans.end()) << declared.gate.id;
      EXPECT_TRUE(declared.tier == Tier::full || plan->tier == Tier::quick) << declared.gate.id;
      for (const Tier tier : {Tier::quick, Tier::full}) {
        if (tier == Tier::quick && declared.tier == Tier::full) continue;
        const auto& values = tier == Tier::full && !plan->full_values.empty() ? plan->full_values : plan->values;
        for (const double level : declared.levels) {
          EXPECT_NE(std::find(values.begin(), values.end(), level), values.end())
              << declared.gate.id << " at " << level;
        }
      }
    }
  });
}

TEST(EveryCase, PlansResolveInBothTiers) {
  for_every_case([](const Case& entry) {
    for (const StudyPlan& plan : entry.studies) {
      for (const Tier tier : {Tier::quick, Tier::full}) EXPECT_NO_THROW(planned_runs(entry, plan, tier)) << plan.id;
    }
  });
}

// With the fewest cells that a case names.
TEST(EveryCase, MakesASceneOfItsOwnEachTime) {
  for_every_case([](const Case& entry) {
    if (!entry.trials.empty()) {
      EXPECT_THROW(entry.problem(entry.settings("default", {})), UsageError);
      return;
    }
    const Settings settings = entry.settings("default", {{"cells", entry.levels.front()}});
    const auto problem = entry.problem(settings);
    EXPECT_GT(problem->end_time(), 0);
    const Scene first = problem->scene(), second = problem->scene();
    ASSERT_FALSE(first.bodies.empty());
    const auto one = first.bodies[0].points.values(column::position),
               two = second.bodies[0].points.values(column::position);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), two.begin(), two.end()));
    EXPECT_EQ(first.shape, settings.text("shape"));
    EXPECT_EQ(first.transfer, settings.text("transfer"));
  });
}

}  // namespace
}  // namespace plumbline::case_test
