// Two waves ahead of a piston: jump conditions, the constitutive law followed point by point, conservation, finite strains.
#include "reference/elastic_plastic_impact.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::elastic_plastic_impact_test {
namespace {

using Problem = ElasticPlasticImpactProblem;

// Away from the defaults: steel, in SI units, hardening or not, at once or not, also too slow to yield.
std::vector<Problem> problems() {
  const Problem steel{210e9, 0.29, 7850, 400e6, 12e9, 60, 0};
  std::vector<Problem> all;
  for (const double hardening : {12e9, 0.0}) {
    for (const double rise : {0.0, 3e-6}) {
      for (const double velocity : {60.0, 9.0}) {
        Problem one = steel;
        one.hardening_modulus = hardening;
        one.rise_time = rise;
        one.velocity = velocity;
        all.push_back(one);
      }
    }
  }
  return all;
}

struct Moduli {
  double shear, bulk;
  explicit Moduli(const Problem& p)
      : shear(p.youngs_modulus / (2 * (1 + p.poissons_ratio))),
        bulk(p.youngs_modulus / (3 * (1 - 2 * p.poissons_ratio))) {}
};

// Radial return of small strains in uniaxial strain, step by step: an elastic predictor taken back to the yield stress.
struct Point {
  double strain = 0, plastic_axial = 0, plastic = 0;  // tension positive; plastic: equivalent
  void strain_to(double to, const Problem& p) {
    const Moduli m(p);
    strain = to;
    const double trial = 2 * m.shear * (2.0 / 3 * strain - plastic_axial), q = 1.5 * std::abs(trial);
    const double flow = (q - p.yield_stress - p.hardening_modulus * plastic) / (3 * m.shear + p.hardening_modulus);
    if (flow <= 0) return;
    plastic += flow;
    plastic_axial += std::copysign(flow, trial);
  }
  double deviatoric(const Problem& p) const { return 2 * Moduli(p).shear * (2.0 / 3 * strain - plastic_axial); }
  double stress(const Problem& p) const { return Moduli(p).bulk * strain + deviatoric(p); }
  double lateral(const Problem& p) const { return Moduli(p).bulk * strain - 0.5 * deviatoric(p); }
};

TEST(ElasticPlasticImpact, PublishedLimit) {  // s_H = Y (1 - nu)/(1 - 2 nu), the Hugoniot elastic limit
  const ElasticPlasticImpact impact({210e9, 0.29, 7850, 400e6, 12e9, 60, 0});
  expect_near(impact.elastic_limit(), 400e6 * 0.71 / 0.42, 1e-2);
  expect_near(impact.elastic_speed(), std::sqrt(210e9 * 0.71 / (1.29 * 0.42 * 7850)), 1e-8);
  const ElasticPlasticImpact soft({210e9, 0.29, 7850, 400e6, 0, 60, 0});  // without hardening: the bulk's speed
  expect_near(soft.plastic_speed(), std::sqrt(210e9 / (3 * 0.42 * 7850)), 1e-8);
}

// rho c [v] = -[stress] across either front, and [strain] = -[v]/c: with Hooke's law ahead of the second one, and
// K strain + 2/3 (Y + H alpha) behind.
TEST(ElasticPlasticImpact, FrontsObeyTheirJumpConditions) {
  for (Problem p : problems()) {
    if (p.rise_time > 0 || p.velocity < 20) continue;
    const ElasticPlasticImpact impact(p);
    const ElasticPlasticState ahead = impact.state(1, 1e-6), between = impact.precursor(), behind = impact.plateau();
    const Bounded rho(p.density), ce = impact.elastic_speed(), cp = impact.plastic_speed(), bulk(Moduli(p).bulk, 1e-4);
    EXPECT_EQ(ahead.stress.value, 0);
    EXPECT_EQ(behind.velocity.value, p.velocity);
    expect_zero(rho * ce * between.velocity + between.stress, 1e9, "momentum, elastic");
    expect_zero(rho * cp * (behind.velocity - between.velocity) + behind.stress - between.stress, 1e10,
                "momentum, plastic");
    const Bounded strain = -(between.velocity / ce) - (behind.velocity - between.velocity) / cp;
    const Bounded yield = Bounded(p.yield_stress) + Bounded(p.hardening_modulus) * behind.plastic_strain;
    expect_zero(behind.lateral_stress - behind.stress - yield, 1e9, "yield");
    expect_zero(behind.stress - (bulk * strain - Bounded(2.0) / 3.0 * yield), 1e10, "pressure", 1e-10);
    expect_zero(between.lateral_stress - between.stress - p.yield_stress, 1e9, "yield at the limit");
    const double x_e = ce.value * 1e-5, x_p = cp.value * 1e-5;
    EXPECT_EQ(impact.state(x_e * 1.0001, 1e-5).velocity.value, 0);
    EXPECT_EQ(impact.state(x_e * 0.9999, 1e-5).stress.value, between.stress.value);
    EXPECT_EQ(impact.state(x_p * 1.0001, 1e-5).stress.value, between.stress.value);
    EXPECT_EQ(impact.state(x_p * 0.9999, 1e-5).plastic_strain.value, behind.plastic_strain.value);
    EXPECT_GT(impact.state(x_p, 1e-5).stress.bound, 1e6);  // rounding leaves the side open
  }
}

// A particle is strained by dv/dx; its stresses are those that the law gives along the way. Momentum: rho dv/dt = dstress/dx.
TEST(ElasticPlasticImpact, ParticlesFollowTheLawAndNewton) {
  for (Problem p : problems()) {
    p.rise_time = 3e-6;
    const ElasticPlasticImpact impact(p);
    for (const double x : {0.0, 3e-3, 0.02}) {
      Point point;
      const int steps = 4000;
      const double end = 1.2e-5, dt = end / steps, dx = 1e-7;
      for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) * dt;
        const double gradient = (impact.state(x + dx, t).velocity.value - impact.state(x, t).velocity.value) / dx;
        point.strain_to(point.strain + dt * gradient, p);
        const ElasticPlasticState now = impact.state(x, t + dt / 2);
        // Of a step: the corners of the ramp lie within one; of the velocity's roundings over dx.
        const double step = 3 * p.velocity * dt / p.rise_time * p.density * impact.elastic_speed().value +
                            1e-3 * p.yield_stress;
        ASSERT_NEAR(point.stress(p), now.stress.value, step) << x << ' ' << t;
        ASSERT_NEAR(point.lateral(p), now.lateral_stress.value, step) << x << ' ' << t;
        ASSERT_NEAR(point.plastic, now.plastic_strain.value, step / Moduli(p).shear) << x << ' ' << t;
      }
    }
    const double t = 8e-6, a = 1e-9, b = 1e-5;
    for (const double x : {5e-3, 0.022, 0.0275, 0.033, 0.041}) {
      const double rate = impact.state(x, t + a).velocity.value - impact.state(x, t - a).velocity.value;
      const double slope = impact.state(x + b, t).stress.value - impact.state(x - b, t).stress.value;
      EXPECT_NEAR(p.density * rate / (2 * a), slope / (2 * b), 1e-5 * p.density * p.velocity / p.rise_time) << x;
    }
  }
}

// The piston's work is kinetic energy, elastic energy, H alpha^2/2 and Y alpha; its impulse is momentum.
TEST(ElasticPlasticImpact, WorkAndImpulseAreConserved) {
  for (const Problem& p : problems()) {
    const ElasticPlasticImpact impact(p);
    const Moduli m(p);
    const double end = 1e-5;
    const int n = 200000;
    double work = 0, impulse = 0, kinetic = 0, momentum = 0, stored = 0, heat = 0;
    for (int k = 0; k < n; ++k) {
      const double t = end * (k + 0.5) / n, dx = impact.elastic_speed().value * end / n, x = dx * (k + 0.5);
      const ElasticPlasticState face = impact.state(0, t), s = impact.state(x, end);
      work -= face.stress.value * face.velocity.value * end / n;
      impulse -= face.stress.value * end / n;
      const double v = s.velocity.value, alpha = s.plastic_strain.value;
      const double mean = (s.stress.value + 2 * s.lateral_stress.value) / 3,
                   q = s.lateral_stress.value - s.stress.value;
      kinetic += 0.5 * p.density * v * v * dx;
      momentum += p.density * v * dx;
      stored += (mean * mean / (2 * m.bulk) + q * q / (6 * m.shear) + 0.5 * p.hardening_modulus * alpha * alpha) * dx;
      heat += p.yield_stress * alpha * dx;
    }
    EXPECT_NEAR(work, kinetic + stored + heat, 3e-5 * work);
    EXPECT_NEAR(impulse, momentum, 3e-5 * impulse);
    EXPECT_NEAR(heat, impact.heat(end).value, 3e-5 * work);
    EXPECT_LE(impact.heat(end).bound, 1e-12 * work);
    EXPECT_EQ(heat > 0, p.velocity > 20);
  }
}

// Two shocks of Hencky's law at finite strains: P = (K + 4 G/3) ln F/F up to yield, with K + (4 G/3) H/(3 G + H) beyond,
// rho_0 U^2 = [P]/[F], [v] = -U [F]. They differ from the small strains by about 3/2 of the strain.
TEST(ElasticPlasticImpact, FiniteStrainsDifferByTheStrain) {
  for (const double scale : {1e-3, 1e-4, 1e-5}) {
    Problem p;
    p.yield_stress = 1e5 * scale;
    p.velocity = 1200 * scale;
    const ElasticPlasticImpact impact(p);
    const Moduli m(p);
    const double modulus = m.bulk + 4 * m.shear / 3, rate = p.hardening_modulus / (3 * m.shear + p.hardening_modulus);
    const double softer = m.bulk + 4 * m.shear / 3 * rate, limit = -p.yield_stress / (2 * m.shear);
    const auto piola = [&](double log_f) {
      const double tau = log_f > limit ? modulus * log_f : modulus * limit + softer * (log_f - limit);
      return tau / std::exp(log_f);
    };
    const auto speed = [&](double a, double b) {
      return std::sqrt((piola(b) - piola(a)) / (std::exp(b) - std::exp(a)) / p.density);
    };
    const double first = speed(0, limit) * (1 - std::exp(limit));
    double low = 10 * limit, high = limit;
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (low + high), v = first + speed(limit, middle) * (std::exp(limit) - std::exp(middle));
      (v > p.velocity ? low : high) = middle;
    }
    const double strain = impact.strain().value, stress = impact.plateau().stress.value;
    EXPECT_LE(std::abs(piola(low) / stress - 1), 1.5 * strain);
    EXPECT_GE(std::abs(piola(low) / stress - 1), 0.3 * strain);
    const double plastic = 2 * m.shear / (3 * m.shear + p.hardening_modulus) * (limit - low);
    EXPECT_LE(std::abs(plastic / impact.plateau().plastic_strain.value - 1), 1.5 * strain);
  }
  EXPECT_LE(1.5 * ElasticPlasticImpact({}).strain().value, 1e-4);
}

TEST(ElasticPlasticImpact, Refuses) {
  using Impact = ElasticPlasticImpact;
  EXPECT_EQ((refused_value<Impact>(&Problem::youngs_modulus, 0)), "youngs_modulus");
  EXPECT_EQ((refused_value<Impact>(&Problem::poissons_ratio, 0.5)), "poissons_ratio");
  EXPECT_EQ((refused_value<Impact>(&Problem::poissons_ratio, -1)), "poissons_ratio");
  EXPECT_EQ((refused_value<Impact>(&Problem::density, -1)), "density");
  EXPECT_EQ((refused_value<Impact>(&Problem::yield_stress, 0)), "yield_stress");
  EXPECT_EQ((refused_value<Impact>(&Problem::hardening_modulus, -1)), "hardening_modulus");
  EXPECT_EQ((refused_value<Impact>(&Problem::velocity, 0)), "velocity");
  EXPECT_EQ((refused_value<Impact>(&Problem::rise_time, -1)), "rise_time");
  EXPECT_EQ(refused_key([] { ElasticPlasticImpact({}).state(-1, 0); }), "position");
  EXPECT_EQ(refused_key([] { ElasticPlasticImpact({}).state(0, -1); }), "time");
}

}  // namespace
}  // namespace plumbline::reference::elastic_plastic_impact_test
