// What a case says of itself, read from Markdown.
#include "cases/harness/description/prose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::prose_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string whole = R"(# A title

## Source
Somebody 1997,
section 4

## Claim
It converges.

## Physics
A first paragraph
of two lines.

A second one.

## Equations
    p = (γ − 1) ρ e
{{shared}}

## Cells
a length of 1 m

## Reference: riemann
Exact.

## Bound of the reference
Rounding.

## Orders
- density.L1, velocity.L1 of order 1: jumps: they
  spread
- pressure.L1 of order 1/2: slow

## Known limits
- One that goes
  on.
- Another.
)";

Statement read(const std::string& markdown) {
  const auto text_of = [](const std::string& name) -> std::string {
    if (name != "shared") throw std::invalid_argument(name + ".md: is not there");
    return "# Shared\n\n## Claim\nNot this.\n\n## Equations\n    a = b\n\n";
  };
  return statement_of(Prose("toy", markdown, text_of), "<svg/>");
}

std::string without(const std::string& heading) {
  const std::string text = "\n" + whole;
  const std::size_t at = text.find("\n" + heading), end = text.find("\n## ", at + 1);
  return text.substr(0, at) + text.substr(end);
}

TEST(StatementOfProse, TakesEverySection) {
  const Statement s = read(whole);
  EXPECT_EQ(s.name, "toy");
  EXPECT_EQ(s.title, "A title");
  EXPECT_EQ(s.source, "Somebody 1997, section 4");
  EXPECT_EQ(s.claim, "It converges.");
  EXPECT_EQ(s.physics, "A first paragraph of two lines.\n\nA second one.");
  EXPECT_THAT(s.equations, ElementsAre("p = (γ − 1) ρ e", "a = b"));
  EXPECT_EQ(s.sketch, "<svg/>");
  EXPECT_EQ(s.cells_along, "a length of 1 m");
  EXPECT_EQ(s.reference_name, "riemann");
  EXPECT_EQ(s.reference_text, "Exact.");
  EXPECT_EQ(s.reference_bound, "Rounding.");
  ASSERT_EQ(s.theory_orders.size(), 3u);
  EXPECT_EQ(s.theory_orders[1].measure, "velocity.L1");
  EXPECT_EQ(s.theory_orders[1].why, "jumps: they spread");
  EXPECT_EQ(s.theory_orders[2].order, 0.5);
  EXPECT_THAT(s.known_limits, ElementsAre("One that goes on.", "Another."));
}

TEST(StatementOfProse, NamesTheSectionThatIsNotThere) {
  for (const char* heading : {"# A title", "## Source", "## Claim", "## Physics", "## Reference", "## Bound"}) {
    try {
      read(without(heading));
      ADD_FAILURE() << heading;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("toy.md: ")) << heading;
    }
  }
  for (const char* heading : {"## Equations", "## Cells", "## Orders"}) EXPECT_NO_THROW(read(without(heading)));
}

TEST(StatementOfProse, NamesALineThatHasNoPlace) {
  const auto replaced = [](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THROW(read(replaced("    p =", "p =")), std::invalid_argument);
  EXPECT_THROW(read(replaced("- One", "One")), std::invalid_argument);
  EXPECT_THROW(read(replaced(" of order 1/2", "")), std::invalid_argument);
  for (const char* number : {"", "two", "2x", "1/0", "1/", "/2", "1/2/3"})
    EXPECT_THROW(read(replaced("of order 1/2", std::string("of order ") + number)), std::invalid_argument) << number;
  EXPECT_THROW(read(replaced("{{shared}}", "{{other}}")), std::invalid_argument);
  EXPECT_THROW(read("before\n" + whole), std::invalid_argument);
}

TEST(WrittenProse, IsThereForEveryCase) {
  for (const Case* entry : cases()) {
    const Statement s = entry->statement();
    EXPECT_EQ(s.name, entry->name);
    EXPECT_THAT(s.sketch, HasSubstr("<svg")) << s.name;
  }
  for (const StabilityProblem* problem : stability_problems()) EXPECT_EQ(problem->statement().name, problem->name());
  EXPECT_THROW(written_prose("no-such-case"), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::prose_test
