// Chain of bars against what it tends to: the bar with a heavy end in closed form, the elastic pendulum, the slack
// string; energy; order of the elements.
#include "reference/bar_chain.hpp"

#include "reference/elastic_pendulum.hpp"
#include "reference/heavy_spring.hpp"
#include "reference/slack_string.hpp"
#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::bar_chain_test {
namespace {

/// Lumped masses: x_n^2/(12 n^2) of a frequency; the bar of heavy_spring.hpp is the limit.
TEST(BarChainPublished, SpringTendsToTheBarWithAHeavyEnd) {  // (Rao, section 8.3)
  const HeavySpring bar(SpringProblem{});
  double before = 0;
  for (int elements : {8, 16, 32}) {
    const BarChain chain(chain_spring_problem(), elements);
    const Bounded period = chain.period(ChainTurn::bounce);
    EXPECT_LE(std::abs(period.value - bar.period().value), period.bound) << elements;
    const double time = 0.05, error = std::abs(-0.3 - chain.at(time).y.value - bar.displacement(time).value);
    EXPECT_LE(error, chain.at(time).y.bound + bar.displacement(time).bound);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 1.2);  // second order
    }
    before = error;
  }
  EXPECT_NEAR(BarChain(chain_spring_problem()).string_mass_ratio(), 0.003 / 3.33, 1e-15);
}

TEST(BarChainPublished, PendulumSwingsAsTheElasticPendulum) {  // York's coordinates; string of 0.2 % of the mass
  const ElasticPendulum light({});
  const Bounded chain = BarChain().period(ChainTurn::swing);
  // the string's own waves, set off from a state without tension, carry no more than its share of the mass
  const double share = light.string_mass_ratio().value;
  EXPECT_NEAR(chain.value, light.heavy_period().value, 0.1 * share * chain.value);
  EXPECT_LE(chain.bound, 0.1 * share * chain.value);
}

TEST(BarChainPublished, WithoutMassItIsTheElasticPendulum) {
  ElasticPendulumProblem light;
  light.one_way = false;
  BarChainProblem problem;
  problem.density = 1e-3;
  problem.one_way = false;
  const ElasticPendulum pendulum(light);
  const BarChain chain(problem, 8, 1e-6);
  const double share = chain.string_mass_ratio();  // 2e-5
  for (double time : {0.05, 0.15}) {
    const BarChainState here = chain.at(time);
    const PendulumState there = pendulum.at(time);
    EXPECT_NEAR(here.x.value, there.x.value, share * 0.7);
    EXPECT_NEAR(here.y.value, there.y.value, share * 0.7);
  }
}

TEST(BarChainPublished, SlackStringFallsTautensAndReturns) {  // closed form for a string without mass
  const SlackString string(SlackStringProblem{});
  const auto turns = BarChain(chain_slack_problem()).turns(ChainTurn::bounce, 2);
  const double share = 0.003 / 3.33;  // of the mass: what a chain that falls and tautens can change
  EXPECT_NEAR(turns[2].time.value, string.apex_time().value, share * string.apex_time().value);
  EXPECT_NEAR(-0.28 - turns[1].y.value, string.max_displacement().value, 4 * share * string.max_displacement().value);
  const BarChainState falling = BarChain(chain_slack_problem()).at(0.01);  // free
  EXPECT_NEAR(falling.y.value, -0.28 - 125 * 1e-4, 1e-9);
  EXPECT_EQ(falling.support_tension.value, 0);
}

TEST(BarChainIdentity, EnergyStaysAndIsTheWorkOfGravity) {
  BarChainProblem swing;
  swing.one_way = false;
  for (const BarChainProblem& p : {chain_spring_problem(), chain_slack_problem(), swing, BarChainProblem{}}) {
    const BarChain chain(p);
    const std::vector<double> times = {0, 0.004, 0.017, 0.031};
    const auto states = chain.at(times);
    const double length = chain.rest_length(), e = p.strain;
    const double stored = p.one_way && e < 0 ? 0 : 0.5 * p.youngs_modulus * p.area * e * e * length;
    EXPECT_NEAR(states[0].elastic.value, stored, 1e-12);
    for (const BarChainState& s : states) {
      const double total = s.kinetic.value + s.elastic.value + s.potential.value;
      EXPECT_NEAR(total, stored, 1e-6 * p.mass * p.gravity * length);  // a hundred steps' tolerances
    }
  }
}

TEST(BarChainIdentity, StartsAtRestOnALine) {
  const BarChainState s = BarChain().at(0);
  EXPECT_NEAR(s.x.value, 0.101, 1e-15);
  EXPECT_NEAR(s.y.value, 0.303, 1e-15);
  EXPECT_EQ(s.velocity_x.value, 0);
  EXPECT_NEAR(s.length.value, std::hypot(0.33333 - 0.101, 0.99990 - 0.303), 1e-15);
  EXPECT_EQ(s.kinetic.value, 0);
}

TEST(BarChainProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<BarChain, BarChainProblem>;
  EXPECT_EQ(key([](auto& p) { p.mass = 0; }), "mass");
  EXPECT_EQ(key([](auto& p) { p.gravity = 0; }), "gravity");
  EXPECT_EQ(key([](auto& p) { p.youngs_modulus = 1; }), "youngs_modulus");
  EXPECT_EQ(key([](auto& p) { p.area = -1; }), "area");
  EXPECT_EQ(key([](auto& p) { p.density = 0; }), "density");
  EXPECT_EQ(key([](auto& p) { p.density = 100; }), "density");
  EXPECT_EQ(key([](auto& p) { p.strain = -0.6; }), "strain");
  EXPECT_EQ(key([](auto& p) {
              p.end_x = p.support_x;
              p.end_y = p.support_y;
            }),
            "end_y");
  EXPECT_EQ(refused_key([] { BarChain chain({}, 10); }), "elements");
  EXPECT_EQ(refused_key([] { BarChain chain({}, 8, 1e-14); }), "tolerance");
  EXPECT_EQ(refused_key([] { BarChain(chain_spring_problem()).period(ChainTurn::swing); }), "end_x");
  EXPECT_EQ(refused_key([] { BarChain().at(-1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::bar_chain_test
