// Two shocks at finite strains: the law followed in small steps, jump conditions, balances, the limit of small strains.
#include "reference/plate_impact.hpp"

#include "reference/elastic_plastic_impact.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::plate_impact_test {
namespace {

using Problem = PlateImpactProblem;

// Copper as the case has it; steel that hardens much or not, fast and slow; also too slow to yield.
std::vector<Problem> problems() {
  return {{},
          {210e9, 0.29, 7850, 400e6, 12e9, 150},
          {210e9, 0.29, 7850, 400e6, 0, 400},
          {210e9, 0.29, 7850, 400e6, 12e9, 9}};
}

struct Moduli {
  double shear, bulk;
  explicit Moduli(const Problem& p)
      : shear(p.youngs_modulus / (2 * (1 + p.poissons_ratio))),
        bulk(p.youngs_modulus / (3 * (1 - 2 * p.poissons_ratio))) {}
};

// Uniaxial strain in small steps of ln F: deviatoric trial, radial return, Kirchhoff's stress over det F = F.
struct Followed {
  double plastic = 0, axial_flow = 0, log_stretch = 0;
  void to(double end, const Problem& p, int steps) {
    const Moduli m(p);
    const double from = log_stretch;
    for (int k = 1; k <= steps; ++k) {
      log_stretch = from + (end - from) * k / steps;
      const double q = 3 * m.shear * std::abs(2.0 / 3 * log_stretch - axial_flow);
      const double beyond = q - p.yield_stress - p.hardening_modulus * plastic;
      if (beyond <= 0) continue;
      const double flow = beyond / (3 * m.shear + p.hardening_modulus);
      plastic += flow;
      axial_flow -= flow;
    }
  }
  double deviatoric(const Problem& p) const { return 2 * Moduli(p).shear * (2.0 / 3 * log_stretch - axial_flow); }
  double axial(const Problem& p) const {
    return (Moduli(p).bulk * log_stretch + deviatoric(p)) / std::exp(log_stretch);
  }
  double lateral(const Problem& p) const {
    return (Moduli(p).bulk * log_stretch - 0.5 * deviatoric(p)) / std::exp(log_stretch);
  }
};

TEST(PlateImpact, StatesAreThoseOfTheLawFollowedInSmallSteps) {  // [Hencky 1]
  for (const Problem& p : problems()) {
    const PlateImpact impact(p);
    for (const PlateState* state : {&impact.precursor(), &impact.plateau()}) {
      Followed point;
      point.to(std::log(state->stretch.value), p, 2000);
      EXPECT_NEAR(state->stress.value, point.axial(p), 1e-9 * p.youngs_modulus);
      EXPECT_NEAR(state->lateral_stress.value, point.lateral(p), 1e-9 * p.youngs_modulus);
      EXPECT_NEAR(state->plastic_strain.value, point.plastic, 1e-9);
      EXPECT_LE(state->stress.bound, 1e-9 * p.youngs_modulus);
    }
    EXPECT_NEAR(impact.plateau().velocity.value, p.velocity, 1e-9 * p.velocity);
  }
}

// rho U [v] = [p], U [stretch] = -[v]; and of energy what the jump dissipates beyond flow is never negative.
TEST(PlateImpact, ShocksObeyTheirJumpConditions) {  // [Hencky 2]
  for (const Problem& p : problems()) {
    const PlateImpact impact(p);
    const bool yields = p.velocity > 20;
    EXPECT_EQ(impact.plateau().plastic_strain.value > 0, yields);
    PlateState ahead = impact.state(1, 1e-7);
    EXPECT_EQ(ahead.stress.value, 0);
    EXPECT_EQ(ahead.stretch.value, 1);
    std::vector<PlateState> behind{impact.precursor()};
    if (yields) behind.push_back(impact.plateau());
    for (const PlateState& b : behind) {
      const Bounded jump = b.velocity - ahead.velocity, rho(p.density);
      expect_zero(rho * b.speed * jump + b.stress - ahead.stress, 1e10, "momentum", 1e-9);
      expect_zero(b.speed * (ahead.stretch - b.stretch) - jump, p.velocity, "mass", 1e-9);
      const double front = b.speed.value * 1e-5;
      EXPECT_EQ(impact.state(front * 0.9999, 1e-5).stress.value, b.stress.value);
      EXPECT_EQ(impact.state(front * 1.0001, 1e-5).stress.value, ahead.stress.value);
      EXPECT_GT(impact.state(front, 1e-5).stress.bound, 1e6);  // rounding leaves the side open
      ahead = b;
    }
    EXPECT_EQ(impact.state(0, 0).velocity.value, 0);
  }
}

// Copper at 227 m/s: a third, longhand computation by bisection of both jumps in Python.
TEST(PlateImpact, CopperOfTaylorsBar) {
  const PlateImpact impact({});
  expect_near(impact.precursor().velocity, 21.188761274, 1e-6);
  expect_near(impact.plateau().stress, -8226019601.9, 1);
  expect_near(impact.plateau().plastic_strain, 0.0353373469, 1e-9);
  expect_near(impact.elastic_speed(), 4601.500806, 1e-4);
  expect_near(impact.plastic_speed(), 4002.049216, 1e-4);
}

// Towards small strains it is the two waves of the linear theory, which differ by 3/2 of the strain.
TEST(PlateImpact, SmallStrainsAreTheLimit) {
  for (const double scale : {1e-2, 1e-3, 1e-4}) {
    Problem p;
    p.yield_stress *= scale;
    p.velocity *= scale;
    const PlateImpact impact(p);
    const ElasticPlasticImpact small(
        {p.youngs_modulus, p.poissons_ratio, p.density, p.yield_stress, p.hardening_modulus, p.velocity, 0});
    const double strain = small.strain().value;
    const double off = std::abs(impact.plateau().stress.value / small.plateau().stress.value - 1);
    EXPECT_LE(off, 1.5 * strain);
    EXPECT_GE(off, 0.3 * strain);
    EXPECT_NEAR(impact.plastic_speed().value / small.plastic_speed().value, 1, 1.5 * strain);
    EXPECT_NEAR(impact.plateau().plastic_strain.value / small.plateau().plastic_strain.value, 1, 1.5 * strain);
  }
}

TEST(PlateImpact, Refuses) {
  using Impact = PlateImpact;
  EXPECT_EQ((refused_value<Impact>(&Problem::youngs_modulus, 0)), "youngs_modulus");
  EXPECT_EQ((refused_value<Impact>(&Problem::poissons_ratio, 0.5)), "poissons_ratio");
  EXPECT_EQ((refused_value<Impact>(&Problem::density, -1)), "density");
  EXPECT_EQ((refused_value<Impact>(&Problem::yield_stress, 0)), "yield_stress");
  EXPECT_EQ((refused_value<Impact>(&Problem::hardening_modulus, -1)), "hardening_modulus");
  EXPECT_EQ((refused_value<Impact>(&Problem::velocity, 0)), "velocity");
  EXPECT_EQ((refused_value<Impact>(&Problem::velocity, 1e5)), "velocity");   // keeps too little of its thickness
  EXPECT_EQ((refused_value<Impact>(&Problem::velocity, 1500)), "velocity");  // the plastic shock is the faster one
  EXPECT_EQ(refused_key([] { PlateImpact({}).state(-1, 0); }), "place");
  EXPECT_EQ(refused_key([] { PlateImpact({}).state(0, -1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::plate_impact_test
