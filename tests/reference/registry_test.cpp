#include "reference/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

namespace plumbline::reference::registry_test {
namespace {

double value_of(const Record& record, const std::string& key) {
  for (const auto& [name, value] : record) {
    if (name == key) return value;
  }
  ADD_FAILURE() << "no " << key;
  return std::nan("");
}

TEST(Registry, ListsEveryReferenceInTheOrderOfNames) {
  std::vector<std::string> names;
  for (const Reference* reference : references()) names.push_back(reference->name());
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"gas-ring", "membrane-equilibrium", "piston-container", "riemann", "spring-mass"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end());
}

TEST(Registry, FindsByNameOrGivesNothing) {
  ASSERT_NE(find_reference("riemann"), nullptr);
  EXPECT_EQ(find_reference("riemann")->name(), "riemann");
  EXPECT_EQ(find_reference("rieman"), nullptr);
}

TEST(Registry, EveryReferenceDescribesItselfAndAnswersForItsDefaults) {
  for (const Reference* reference : references()) {
    EXPECT_FALSE(reference->title().empty());
    EXPECT_FALSE(reference->source().empty());
    for (const Parameter& parameter : reference->parameters()) {
      EXPECT_FALSE(parameter.unit.empty()) << parameter.key;
      EXPECT_FALSE(parameter.description.empty()) << parameter.key;
      EXPECT_NO_THROW(check(parameter, parameter.value)) << parameter.key;
    }
    const double least = reference->abscissa().low;  // a position within every initial body, or a count
    const double at[] = {std::max(0.8, least), std::max(0.9, 2 * least)};
    const Answer answer = reference->evaluate({}, at);
    ASSERT_EQ(answer.values.size(), answer.bounds.size());
    for (std::size_t i = 0; i < answer.values.size(); ++i) {
      EXPECT_EQ(answer.values[i].first, answer.bounds[i].first);
      EXPECT_TRUE(std::isfinite(answer.values[i].second)) << answer.values[i].first;
      EXPECT_GE(answer.bounds[i].second, 0);
    }
    ASSERT_EQ(answer.at.size(), 2u);
    ASSERT_EQ(answer.at_bounds.size(), 2u);
    EXPECT_EQ(answer.at[1][0], (std::pair<std::string, double>{reference->at_name(), at[1]}));
    EXPECT_EQ(answer.at[1].size(), answer.at_bounds[1].size() + 1);
  }
}

TEST(Registry, ChosenParametersReachTheSolution) {
  const Reference& riemann = *find_reference("riemann");
  const Answer sod = riemann.evaluate({}, {});
  EXPECT_NEAR(value_of(sod.values, "pressure_star"), 0.30313, 5e-6);  // Toro, table 4.3, test 1: half of the last digit
  const Answer other = riemann.evaluate({{"left.pressure", 1000}, {"right.density", 1}, {"right.pressure", 0.01}}, {});
  EXPECT_NEAR(value_of(other.values, "pressure_star"), 460.894, 5e-4);  // test 3
  EXPECT_NEAR(value_of(other.values, "density_star_right"), 5.99924, 5e-6);
}

TEST(Registry, AnUnknownKeyNamesTheKnownOnes) {
  try {
    find_reference("riemann")->evaluate({{"gama", 1.4}}, {});
    FAIL();
  } catch (const UnknownParameter& error) {
    EXPECT_EQ(error.key, "gama");
    EXPECT_NE(std::find(error.known.begin(), error.known.end(), "gamma"), error.known.end());
  }
}

TEST(Registry, AValueOutOfRangeNamesKeyValueAndRange) {
  try {
    find_reference("riemann")->evaluate({{"gamma", 1.0}}, {});
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key, "gamma");
    EXPECT_EQ(error.value, 1.0);
    EXPECT_EQ(error.allowed, "(1, inf)");
  }
  try {
    find_reference("spring-mass")->evaluate({{"mass", -3}}, {});
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key, "mass");
    EXPECT_EQ(error.allowed, "(0, inf) kg");
  }
}

// Parameters may forbid each other's values: whichever a reference refuses, it names one of them and the value it had. One
// or two are far from their defaults, within the ranges of their own. Left out are those that are computed numerically.
TEST(Registry, RefusalsNameAParameterAndItsValue) {
  const std::set<std::string> slow{"bar-chain",     "cook-panel", "finite-volume", "gas-expansion",
                                   "mpm-stability", "shu-osher",  "two-bar",       "woodward-colella"};
  std::mt19937_64 random(20);
  int refused = 0;
  for (const Reference* reference : references()) {
    const std::vector<Parameter> parameters = reference->parameters();
    for (int draw = 0; draw < 12 && !parameters.empty() && slow.count(reference->name()) == 0; ++draw) {
      std::map<std::string, double> settings;
      for (const Parameter& p : parameters) settings[p.key] = p.value;
      for (int changes = 0; changes < 2; ++changes) {
        const Parameter& one = parameters[random() % parameters.size()];
        const double factor = std::pow(10.0, std::uniform_real_distribution<double>(-4, 4)(random));
        const double value = (random() % 4 == 0 ? -factor : factor) * (one.value == 0 ? 1 : one.value);
        settings[one.key] = std::clamp(value, one.low, one.high);
      }
      try {
        reference->evaluate(settings, {});
      } catch (const ParameterError& error) {
        ++refused;
        ASSERT_TRUE(settings.count(error.key)) << reference->name() << ": " << error.what();
        EXPECT_EQ(error.value, settings.at(error.key)) << reference->name() << ": " << error.what();
      } catch (const std::domain_error&) {  // where no solution was found
      }
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Registry, NumbersThatAreNotFiniteAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const Reference& riemann = *find_reference("riemann");
  EXPECT_THROW(riemann.evaluate({{"left.velocity", infinity}}, {}), ParameterError);
  EXPECT_THROW(riemann.evaluate({{"left.pressure", nan}}, {}), ParameterError);
  const double at[] = {nan};
  EXPECT_THROW(riemann.evaluate({}, at), ParameterError);
  const double before[] = {-1.0};
  EXPECT_THROW(find_reference("spring-mass")->evaluate({}, before), ParameterError);
}

TEST(Registry, ANameIsTakenOnce) {
  struct Twin : Reference {
    std::string name() const override { return "riemann"; }
    std::string title() const override { return ""; }
    std::string source() const override { return ""; }
    std::vector<Parameter> parameters() const override { return {}; }
    Parameter abscissa() const override { return {}; }
    Answer solve(const std::map<std::string, double>&, std::span<const double>) const override { return {}; }
  };
  EXPECT_THROW(Registration(std::make_unique<Twin>()), std::logic_error);
}

}  // namespace
}  // namespace plumbline::reference::registry_test
