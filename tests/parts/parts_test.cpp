// Built-in parts are green, wrong ones red by the gate that their defect is about.
#include "cases/harness/parts/parts.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <set>

#include "cases/harness/files/errors.hpp"

namespace plumbline::parts_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const PartKind& kind_named(const std::string& name) {
  return *std::find_if(part_kinds().begin(), part_kinds().end(),
                       [&](const PartKind& kind) { return kind.name == name; });
}

bool is_wrong(const std::string& name) { return name.rfind("wrong-", 0) == 0; }

// Ids of the red gates.
std::set<std::string> red(const JudgedPart& judged) {
  std::set<std::string> ids;
  for (const JudgedGate& gate : judged.gates) {
    if (!gate.explanation.empty()) ids.insert(gate.gate.id);
  }
  return ids;
}

struct KindAndName {
  std::string kind, name;
  friend std::ostream& operator<<(std::ostream& out, const KindAndName& one) {
    return out << one.kind << ' ' << one.name;
  }
};
std::vector<KindAndName> built_in_parts() {
  std::vector<KindAndName> all;
  for (const PartKind& kind : part_kinds()) {
    for (const std::string& name : kind.names()) {
      if (!is_wrong(name)) all.push_back({kind.name, name});
    }
  }
  return all;
}

class BuiltInPart : public testing::TestWithParam<KindAndName> {};

TEST_P(BuiltInPart, IsGreen) {
  const JudgedPart judged = judge_part(kind_named(GetParam().kind), GetParam().name);
  EXPECT_EQ(judged.declared, static_cast<int>(judged.gates.size() + judged.not_applicable.size()));
  EXPECT_FALSE(judged.gates.empty());
  for (const JudgedGate& gate : judged.gates) {
    EXPECT_TRUE(gate.explanation.empty()) << gate.gate.id << " is " << name(gate.judgement.verdict) << ": "
                                          << gate.measured.value.value_or(-1) << ' ' << gate.measured.note;
  }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltInPart, testing::ValuesIn(built_in_parts()), [](const auto& one) {
  std::string name = one.param.kind + "_" + one.param.name;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

// A wrong part, a gate that has to see it, and one that its defect leaves alone where there is one.
struct Wrong {
  const char *kind, *name, *red, *green;
  const char* shape = "quadratic";  // with which a transfer is judged: its loops are the shape's
  friend std::ostream& operator<<(std::ostream& out, const Wrong& one) { return out << one.kind << ' ' << one.name; }
};
constexpr Wrong wrong_parts[] = {
    {"shape", "wrong-unity", "unity/line", "gradient/sums/line"},
    {"shape", "wrong-centre", "linear/plane", "unity/plane"},
    {"shape", "wrong-gradient", "gradient/derivative/line", "gradient/sums/line"},
    {"shape", "wrong-domain", "gradient/domain/plane", "gradient/sums/plane"},
    {"shape", "wrong-anchor", "continuity/value/plane", "linear/plane"},
    {"shape", "wrong-inertia", "inertia/second-moment/line", "linear/line"},
    {"shape", "wrong-smooth", "continuity/gradient/line", "gradient/derivative/line"},
    {"shape", "wrong-affine", "inertia/affine/plane", "inertia/second-moment/plane"},
    {"shape", "wrong-blur", "inertia/blur/line", "inertia/constant/line"},
    {"shape", "wrong-nearest", "order/value/line", "unity/line"},
    {"shape", "wrong-force", "adjoint/forces/space", "adjoint/values/space"},
    {"shape", "wrong-volume", "volume/rings", "unity/rings"},
    {"shape", "wrong-read", "volume/read/plane", "volume/plane"},
    {"shape", "wrong-loss", "adjoint/loss/space", "adjoint/values/space"},
    {"shape", "wrong-reach", "support/reach/plane", "support/sides/plane"},
    {"shape", "wrong-sides", "support/sides/line", "support/reach/line"},
    {"material", "wrong-stress", "energy/derivative/plane", "frame/spin/plane"},
    {"material", "wrong-axes", "frame/spin/space", "rates/advance/space"},
    {"material", "wrong-viscosity", "entropy/production/line", "energy/derivative/line"},
    {"material", "wrong-viscosity", "entropy/told/rings", "speed/motion/rings"},
    {"material", "wrong-speed", "speed/small-strains/plane", "energy/derivative/plane"},
    {"material", "wrong-hesitant", "speed/excess/plane", "speed/small-strains/plane"},
    {"material", "wrong-tangent", "speed/strained/line", "speed/small-strains/line"},
    {"material", "wrong-still", "speed/motion/space", "speed/strained/space"},
    {"material", "wrong-rates", "rates/advance/rings", "energy/derivative/rings"},
    {"material", "wrong-stored", "energy/told/line", "energy/derivative/line"},
    {"material", "wrong-cooling", "entropy/heat/plane", "energy/derivative/plane"},
    {"material", "wrong-faults", "faults/named/plane", "energy/told/plane"},
    {"contact", "wrong-reaction", "momentum/line", "release/line"},
    {"contact", "wrong-bounce", "energy/plane", "momentum/plane"},
    {"contact", "wrong-sticking", "release/space", "momentum/space"},
    {"contact", "wrong-passing", "approach/plane", "energy/plane"},
    {"contact", "wrong-silent", "told/line", "momentum/line"},
    {"contact", "wrong-pull", "tension/plane", "momentum/plane"},
    {"contact", "wrong-choosing", "again/line", "told/line"},
    {"transfer", "wrong-unfiltered", "claims/unfiltered/line", "momentum/open/line"},
    {"transfer", "wrong-taken", "claims/taken/plane", "momentum/open/plane"},
    {"transfer", "pic", "momentum/along-walls/plane", "momentum/open/plane", "wrong-walls"},
    {"transfer", "flip", "momentum/booked/space", "momentum/open/space", "wrong-walls"},
    {"transfer", "pic", "momentum/open/line", "energy/growth/line", "wrong-overshoot"},
    {"transfer", "flip", "energy/growth/space", "", "wrong-overshoot"},
    {"transfer", "flip", "filter/range/line", "", "wrong-overshoot"},
    {"transfer", "flip", "reproduction/uniform/plane", "", "wrong-overshoot"},
    {"transfer", "xpic", "filter/order/line", "energy/growth/line", "wrong-overshoot"},
    {"transfer", "pic", "energy/booked/plane", "energy/growth/plane", "wrong-overshoot"},
    {"transfer", "apic", "momentum/angular/space", "momentum/open/space", "wrong-spin"},
    {"transfer", "apic", "reproduction/affine/rings", "momentum/open/rings", "wrong-spin"},
};

class WrongPart : public testing::TestWithParam<Wrong> {};

TEST_P(WrongPart, IsRedByTheGateOfItsDefect) {
  const JudgedPart judged = judge_part(kind_named(GetParam().kind), GetParam().name, {1, false, {}, GetParam().shape});
  const std::set<std::string> found = red(judged);
  EXPECT_THAT(found, Contains(GetParam().red));
  if (*GetParam().green == 0) return;
  const auto green = std::find_if(judged.gates.begin(), judged.gates.end(),
                                  [](const JudgedGate& gate) { return gate.gate.id == GetParam().green; });
  ASSERT_NE(green, judged.gates.end()) << GetParam().green;
  EXPECT_EQ(green->judgement.verdict, Verdict::pass) << GetParam().green;
}

INSTANTIATE_TEST_SUITE_P(All, WrongPart, testing::ValuesIn(wrong_parts), [](const auto& one) {
  std::string name = std::string(one.param.name) + '_' + one.param.shape + '_' + one.param.red;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

// Every wrong part stands in the table above.
TEST(WrongParts, AreAllJudged) {
  for (const PartKind& kind : part_kinds()) {
    for (const std::string& name : kind.names()) {
      if (!is_wrong(name)) continue;
      EXPECT_TRUE(std::any_of(std::begin(wrong_parts), std::end(wrong_parts), [&](const Wrong& one) {
        return (one.kind == kind.name && one.name == name) || one.shape == name;
      })) << name;
    }
  }
}

// Each id once, each with a reason, a bound and what usually causes a miss.
TEST(PartGates, AreDeclaredInFull) {
  for (const auto& [kind, name] : built_in_parts()) {
    std::set<std::string> ids;
    for (const MeasuredGate& row : kind_named(kind).gates(name, "quadratic")) {
      EXPECT_NO_THROW(validate(row.gate)) << row.gate.id;
      EXPECT_FALSE(row.explanation.empty()) << row.gate.id;
      EXPECT_EQ(row.gate.id.rfind(row.family + "/", 0), 0U) << row.gate.id;
      EXPECT_TRUE(ids.insert(row.gate.id).second) << row.gate.id;
    }
  }
}

TEST(PartGates, EndAtTheFirstRedOneIfAsked) {
  const JudgedPart judged = judge_part(kind_named("shape"), "wrong-unity", {1, true, {}});
  EXPECT_EQ(judged.gates.size(), 1U);
  EXPECT_GT(judged.declared, 10);
}

TEST(PartGates, UnknownNamesAreOfferedTheNearest) {
  try {
    judge_part(kind_named("shape"), "cubics");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.nearest, Contains("cubic"));
    EXPECT_THAT(error.what(), HasSubstr("shape"));
  }
}

}  // namespace
}  // namespace plumbline::parts_test
