// The exact Riemann solver: published values, identities, vacuum. The bounds have a property test of their own
// (riemann_bounds_test.py) and a second computation (riemann_second_test.py).
#include "reference/riemann.hpp"

#include <gsl/gsl_integration.h>

#include <limits>

#include "tests/reference/checks.hpp"

namespace plumbline::reference::riemann_test {
namespace {

const RiemannProblem sod{{1, 0, 1}, {0.125, 0, 0.1}, 1.4};
const RiemannProblem one_two_three{{1, -2, 0.4}, {1, 2, 0.4}, 1.4};
const RiemannProblem left_blast{{1, 0, 1000}, {1, 0, 0.01}, 1.4};
const RiemannProblem right_blast{{1, 0, 0.01}, {1, 0, 100}, 1.4};
const RiemannProblem lax{{0.445, 0.698, 3.528}, {0.5, 0, 0.571}, 1.4};
const RiemannProblem leblanc{{1, 0, 2.0 / 30}, {1e-3, 0, 2.0 / 3 * 1e-10}, 5.0 / 3};
const RiemannProblem monatomic{{2.3, -0.4, 7.1}, {0.37, 0.9, 0.55}, 1.67};

/// The states that met in tests 3 and 4 collide: the right star state of one with the left star state of the other.
RiemannProblem collision() {
  const StarRegion a = RiemannSolution(left_blast).star(), b = RiemannSolution(right_blast).star();
  return {{a.density_right.value, a.velocity.value, a.pressure.value},
          {b.density_left.value, b.velocity.value, b.pressure.value},
          1.4};
}

std::vector<RiemannProblem> all_problems() {
  return {sod, one_two_three, left_blast, right_blast, collision(), lax, leblanc, monatomic};
}

struct Published {
  RiemannProblem problem;
  double pressure, velocity, density_left, density_right;
  double half[4];  // half a unit of the last printed digit
};

void expect_published(const Published& p) {
  const StarRegion star = RiemannSolution(p.problem).star();
  EXPECT_NEAR(star.pressure.value, p.pressure, p.half[0] + star.pressure.bound);
  EXPECT_NEAR(star.velocity.value, p.velocity, p.half[1] + star.velocity.bound);
  EXPECT_NEAR(star.density_left.value, p.density_left, p.half[2] + star.density_left.bound);
  EXPECT_NEAR(star.density_right.value, p.density_right, p.half[3] + star.density_right.bound);
}

// Toro, 3rd ed., table 4.3. Test 5 is printed for the unrounded results of tests 3 and 4, which `collision` takes; the
// six digits of the inputs in table 4.1 alone would move its pressure by 0.005.
TEST(RiemannPublished, ToroTest1) {
  expect_published({sod, 0.30313, 0.92745, 0.42632, 0.26557, {5e-6, 5e-6, 5e-6, 5e-6}});
}
TEST(RiemannPublished, ToroTest2) {
  expect_published({one_two_three, 0.00189, 0, 0.02185, 0.02185, {5e-6, 5e-6, 5e-6, 5e-6}});
}
TEST(RiemannPublished, ToroTest3) {
  expect_published({left_blast, 460.894, 19.5975, 0.57506, 5.99924, {5e-4, 5e-5, 5e-6, 5e-6}});
}
TEST(RiemannPublished, ToroTest4) {
  expect_published({right_blast, 46.0950, -6.19633, 5.99242, 0.57511, {5e-5, 5e-6, 5e-6, 5e-6}});
}
TEST(RiemannPublished, ToroTest5) {
  expect_published({collision(), 1691.64, 8.68975, 14.2823, 31.0426, {5e-3, 5e-6, 5e-5, 5e-5}});
}

// Star state and wave speeds to 15 digits in the sources of ryujin (github.com/conservation-laws/ryujin,
// source/euler/initial_state_leblanc.h); pressure ratio 1e9.
TEST(RiemannPublished, LeBlanc) {
  expect_published({leblanc,
                    0.515577927650970e-3,
                    0.621838671391735,
                    5.40793353493162e-2,
                    3.99999806043000e-3,
                    {5e-19, 5e-16, 5e-17, 5e-18}});
  const RiemannSolution solution(leblanc);
  EXPECT_NEAR(solution.left_wave().tail.value, 0.495784895188979, 5e-16 + solution.left_wave().tail.bound);
  EXPECT_NEAR(solution.right_wave().head.value, 0.829118362533470, 5e-16 + solution.right_wave().head.bound);
}

// W. F. Noh, J. Comput. Phys. 72 (1987) 78, plane case: cold gas on a wall, gamma = 5/3, exactly 4, 4/3 and 1/3.
TEST(RiemannPublished, NohPlane) {
  const RiemannSolution solution({{1, 1, 0}, {1, -1, 0}, 5.0 / 3});
  const StarRegion& star = solution.star();
  EXPECT_NEAR(star.pressure.value, 4.0 / 3, star.pressure.bound);
  EXPECT_NEAR(star.velocity.value, 0, star.velocity.bound);
  // gamma = 5/3 is itself rounded, by less than one unit: (gamma + 1)/(gamma - 1) moves by 3 of them
  EXPECT_NEAR(star.density_left.value, 4, star.density_left.bound + 12 * rounding::unit);
  EXPECT_NEAR(solution.right_wave().head.value, 1.0 / 3, solution.right_wave().head.bound + 2 * rounding::unit);
  EXPECT_LT(star.pressure.bound, sharp);
}

// P. D. Lax, Comm. Pure Appl. Math. 7 (1954) 159 gives the data; the star state is 5-6 digits of a separate
// double-precision computation, repeated in riemann_second_test.py.
TEST(RiemannPublished, Lax) {
  const StarRegion star = RiemannSolution(lax).star();
  EXPECT_NEAR(star.pressure.value, 2.46610, 5e-6);
  EXPECT_NEAR(star.velocity.value, 1.52872, 5e-6);
}

/// Jumps of mass, momentum and energy in the frame of the shock (Toro, section 3.1.3).
void expect_rankine_hugoniot(const RiemannProblem& problem, const Wave& wave, const GasState& ahead, Bounded density,
                             Bounded velocity, Bounded pressure) {
  const Bounded gamma(problem.gamma), g = gamma / (gamma - 1.0), s = wave.head;
  const Bounded w1 = Bounded(ahead.velocity) - s, w2 = velocity - s, r1(ahead.density), p1(ahead.pressure);
  const double flux = std::abs((r1 * w1).value), speed = std::abs(w1.value);
  const double thermal = (g * pressure / density).value;  // speeds in other frames set the scale of rounding too
  const double frame = std::max({1.0, std::abs(s.value) / speed, std::abs(velocity.value) / std::abs(w2.value)});
  expect_zero(r1 * w1 - density * w2, 10 * frame * flux, "mass");
  expect_zero(r1 * w1 * w1 + p1 - density * w2 * w2 - pressure, 10 * frame * (flux * speed + p1.value), "momentum");
  expect_zero(Bounded(0.5) * w1 * w1 + g * p1 / r1 - Bounded(0.5) * w2 * w2 - g * pressure / density,
              10 * frame * (speed * speed + thermal), "energy");
}

TEST(RiemannIdentity, RankineHugoniotHoldsAcrossEveryShock) {  // [Toro 4.6, 4.8, 4.50, 4.52]
  int shocks = 0;
  for (const RiemannProblem& problem : all_problems()) {
    const RiemannSolution solution(problem);
    const StarRegion& star = solution.star();
    if (solution.left_wave().kind == WaveKind::shock) {
      ++shocks;
      expect_rankine_hugoniot(problem, solution.left_wave(), problem.left, star.density_left, star.velocity,
                              star.pressure);
    }
    if (solution.right_wave().kind == WaveKind::shock) {
      ++shocks;
      expect_rankine_hugoniot(problem, solution.right_wave(), problem.right, star.density_right, star.velocity,
                              star.pressure);
    }
  }
  EXPECT_EQ(shocks, 8);  // none in 123; two where gases collide; one in each of the other six
}

Bounded entropy(Bounded density, Bounded pressure, double gamma) {
  return log(pressure) - Bounded(gamma) * log(density);
}

TEST(RiemannIdentity, EntropyIsConstantThroughRarefactionsAndGrowsOverShocks) {  // [Toro 4.53, 4.56, 4.50]
  for (const RiemannProblem& problem : all_problems()) {
    const RiemannSolution solution(problem);
    auto check_side = [&](const Wave& wave, const GasState& gas, Bounded density) {
      const Bounded before = entropy(gas.density, gas.pressure, problem.gamma);
      const Bounded after = entropy(density, solution.star().pressure, problem.gamma);
      if (wave.kind == WaveKind::shock) {
        EXPECT_TRUE(certainly_below(before, after));
        return;
      }
      expect_zero(after - before, 100, "entropy behind the fan");
      for (double share : {0.1, 0.5, 0.9}) {
        const Sample inside = solution.sample(wave.head.value + share * (wave.tail.value - wave.head.value));
        expect_zero(entropy(inside.density, inside.pressure, problem.gamma) - before, 100, "entropy in the fan");
      }
    };
    check_side(solution.left_wave(), problem.left, solution.star().density_left);
    check_side(solution.right_wave(), problem.right, solution.star().density_right);
  }
}

TEST(RiemannIdentity, RiemannInvariantsAndRaysOfTheFan) {  // [Toro 4.54, 4.55, 4.56]
  int fans = 0;
  for (const RiemannProblem& problem : all_problems()) {
    const RiemannSolution solution(problem);
    for (int side : {-1, 1}) {
      const Wave& wave = side < 0 ? solution.left_wave() : solution.right_wave();
      const GasState& gas = side < 0 ? problem.left : problem.right;
      if (wave.kind != WaveKind::rarefaction) continue;
      ++fans;
      const Bounded gamma(problem.gamma), two_over = Bounded(2) / (gamma - 1.0), out(side);
      auto sound = [&](Bounded p, Bounded rho) { return sqrt(gamma * p / rho); };
      const Bounded invariant = Bounded(gas.velocity) - out * two_over * sound(gas.pressure, gas.density);
      for (double share : {0.0, 0.25, 0.5, 0.75, 0.999}) {
        const double xi = wave.head.value + share * (wave.tail.value - wave.head.value);
        const Sample s = solution.sample(xi);
        const Bounded a = sound(s.pressure, s.density);
        const double scale = std::abs(invariant.value) + std::abs(xi) + std::abs(gas.velocity);
        expect_zero(s.velocity - out * two_over * a - invariant, 100 * scale, "invariant");
        expect_zero(s.velocity + out * a - xi, 100 * scale, "ray");
        expect_zero(s.energy * (gamma - 1.0) * s.density - s.pressure, 100 * s.pressure.value, "equation of state");
      }
    }
  }
  EXPECT_EQ(fans, 8);
}

TEST(RiemannIdentity, PressureAndVelocityMatchFromBothSides) {  // [Toro 4.5, 4.9]
  for (const RiemannProblem& problem : all_problems()) {
    const StarRegion star = RiemannSolution(problem).star();
    const WaveCurve left(problem.left, problem.gamma, -1), right(problem.right, problem.gamma, 1);
    const Bounded from_left = left.velocity_behind(star.pressure), from_right = right.velocity_behind(star.pressure);
    EXPECT_LE(std::abs(from_left.value - from_right.value), from_left.bound + from_right.bound);
    EXPECT_LE(std::abs(from_left.value - star.velocity.value), from_left.bound + star.velocity.bound);
  }
}

TEST(RiemannIdentity, SlopeIsTheDerivativeOfTheVelocityChange) {  // [Toro 4.37]
  const WaveCurve curve({0.7, 0.3, 2.5}, 1.67, 1);
  for (double p : {0.01, 1.0, 2.4, 2.6, 40.0}) {
    const double h = 1e-5 * p;
    const double central = (curve.velocity_change(p + h).value - curve.velocity_change(p - h).value) / (2 * h);
    EXPECT_NEAR(curve.slope(p), central, 1e-8 * central);  // truncation (h/p)^2 = 1e-10, rounding 1e-16/1e-5
  }
}

TEST(RiemannSymmetry, Mirror) {
  for (const RiemannProblem& p : all_problems()) {
    const RiemannProblem mirrored{{p.right.density, -p.right.velocity, p.right.pressure},
                                  {p.left.density, -p.left.velocity, p.left.pressure},
                                  p.gamma};
    const RiemannSolution a(p), b(mirrored);
    expect_same(a.star().pressure, b.star().pressure);
    expect_same(a.star().velocity, -b.star().velocity);
    expect_same(a.star().density_left, b.star().density_right);
    for (double xi : {-3.1, -0.7, 0.013, 0.6, 5.0}) {
      const Sample s = a.sample(xi), t = b.sample(-xi);
      expect_same(s.density, t.density);
      expect_same(s.velocity, -t.velocity);
      expect_same(s.pressure, t.pressure);
      expect_same(s.energy, t.energy);
    }
  }
}

TEST(RiemannSymmetry, GalileanShift) {
  const double shift = 3;  // exact for these velocities but lax and monatomic, whose rounding 1e-15 is allowed for
  for (const RiemannProblem& p : all_problems()) {
    RiemannProblem moved = p;
    moved.left.velocity += shift;
    moved.right.velocity += shift;
    const RiemannSolution a(p), b(moved);
    const double input = 1e-14 * (a.star().pressure.value + p.left.pressure + p.right.pressure);
    EXPECT_NEAR(a.star().pressure.value, b.star().pressure.value,
                a.star().pressure.bound + b.star().pressure.bound + input);
    EXPECT_NEAR(a.star().velocity.value + shift, b.star().velocity.value,
                a.star().velocity.bound + b.star().velocity.bound + 1e-14);
    const std::vector<double> here = a.jumps(), there = b.jumps();
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      EXPECT_NEAR(here[i] + shift, there[i], 1e-13 * (1 + std::abs(here[i])));
  }
}

TEST(RiemannSymmetry, Scaling) {  // units of mass (x 8) and of velocity (x 4): powers of two, so the inputs stay exact
  for (const RiemannProblem& p : all_problems()) {
    auto scaled = [](GasState s) { return GasState{8 * s.density, 4 * s.velocity, 128 * s.pressure}; };
    const RiemannSolution a(p), b({scaled(p.left), scaled(p.right), p.gamma});
    expect_same(b.star().pressure, a.star().pressure, 128);
    expect_same(b.star().velocity, a.star().velocity, 4);
    expect_same(b.star().density_left, a.star().density_left, 8);
    for (double xi : {-1.0, 0.25, 0.5, 2.0}) {
      const Sample s = a.sample(xi), t = b.sample(4 * xi);
      expect_same(t.density, s.density, 8);
      expect_same(t.energy, s.energy, 16);
    }
  }
}

// Over [-a, a] with all waves inside, the content of the tube at t = 1 is what was there plus what flowed in:
// int U dxi = a (U_L + U_R) + F(U_L) - F(U_R).
class Conservation : public ::testing::Test {
 protected:
  static double integrate(const std::function<double(double)>& f, std::vector<double> points) {
    gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(400);
    gsl_function function{[](double x, void* g) { return (*static_cast<const std::function<double(double)>*>(g))(x); },
                          const_cast<std::function<double(double)>*>(&f)};
    double total = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      double part = 0, error = 0;  // open rules: no point falls on a jump
      gsl_integration_qag(&function, points[i - 1], points[i], 0, 1e-11, 400, GSL_INTEG_GAUSS31, workspace, &part,
                          &error);
      total += part;
    }
    gsl_integration_workspace_free(workspace);
    return total;
  }

  static void expect_conserved(const RiemannProblem& problem) {
    const RiemannSolution solution(problem);
    std::vector<double> points = solution.jumps();
    const double a = 1.25 * std::max(std::abs(points.front()), std::abs(points.back()));
    points.insert(points.begin(), -a);
    points.push_back(a);
    const GasState &l = problem.left, &r = problem.right;
    auto energy = [&](double rho, double u, double p) { return p / (problem.gamma - 1) + 0.5 * rho * u * u; };
    auto flow = [&](auto conserved, auto flux, const char* what) {
      const double inside = integrate(
          [&](double xi) {
            const Sample s = solution.sample(xi);
            return conserved(s.density.value, s.velocity.value, s.pressure.value);
          },
          points);
      const double left = conserved(l.density, l.velocity, l.pressure),
                   right = conserved(r.density, r.velocity, r.pressure);
      const double in = flux(l.density, l.velocity, l.pressure), out = flux(r.density, r.velocity, r.pressure);
      const double scale = a * (std::abs(left) + std::abs(right)) + std::abs(in) + std::abs(out);
      EXPECT_NEAR(inside, a * (left + right) + in - out, 1e-10 * scale) << what;  // quadrature 1e-11 on <= 7 pieces
    };
    flow([](double d, double, double) { return d; }, [](double d, double u, double) { return d * u; }, "mass");
    flow([](double d, double u, double) { return d * u; }, [](double d, double u, double p) { return d * u * u + p; },
         "momentum");
    flow(
        energy, [&](double d, double u, double p) { return u * (energy(d, u, p) + p); }, "energy");
  }
};

TEST_F(Conservation, OfAllProblems) {
  for (const RiemannProblem& problem : all_problems()) expect_conserved(problem);
}

TEST_F(Conservation, WithVacuum) {  // Toro, section 4.6
  expect_conserved({{1, 0.3, 1}, {0, 0, 0}, 1.4});
  expect_conserved({{0, 0, 0}, {0.7, -0.2, 2}, 1.67});
  expect_conserved({{1, -9, 1}, {0.5, 8, 0.3}, 1.4});
}

TEST(RiemannVacuum, GasBesideAVacuumExpandsToItsEscapeSpeed) {  // Toro, section 4.6
  const RiemannSolution solution({{1, 0.3, 1}, {0, 0, 0}, 1.4});
  const double a = std::sqrt(1.4);
  EXPECT_TRUE(solution.vacuum());
  EXPECT_EQ(solution.right_wave().kind, WaveKind::none);
  EXPECT_NEAR(solution.left_wave().tail.value, 0.3 + 5 * a, 1e-14);  // u + 2 a/(gamma - 1), a few roundings of 6
  EXPECT_NEAR(solution.left_wave().head.value, 0.3 - a, 1e-15);
  EXPECT_EQ(solution.jumps().size(), 2u);
  const Sample beyond = solution.sample(solution.left_wave().tail.value + 1);
  EXPECT_EQ(beyond.density.value, 0);
  EXPECT_EQ(beyond.pressure.value, 0);
  EXPECT_EQ(beyond.energy.value, 0);
  EXPECT_EQ(beyond.velocity.value, solution.left_wave().tail.value);
}

TEST(RiemannVacuum, TwoGasesPartFasterThanTheyCanExpand) {  // [Toro 4.40], section 4.6
  const RiemannSolution solution({{1, -9, 1}, {0.5, 8, 0.3}, 1.4});
  EXPECT_TRUE(solution.vacuum());
  const double left = -9 + 5 * std::sqrt(1.4), right = 8 - 5 * std::sqrt(1.4 * 0.3 / 0.5);
  EXPECT_NEAR(solution.left_wave().tail.value, left, 1e-14);
  EXPECT_NEAR(solution.right_wave().tail.value, right, 1e-14);
  EXPECT_NEAR(solution.star().velocity.value, (left + right) / 2, 1e-14);
  EXPECT_EQ(solution.jumps().size(), 4u);
  const Sample inside = solution.sample(-1.5);
  EXPECT_EQ(inside.density.value, 0);
  EXPECT_EQ(inside.velocity.value, -1.5);
  const double eps = 1e-9;
  EXPECT_LT(solution.sample(left - eps).density.value, 1e-40);  // continuous at the edge: (eps/a)^5
  EXPECT_NEAR(solution.sample(left - eps).velocity.value, left, 1e-8);
}

TEST(RiemannVacuum, OpensContinuously) {  // [Toro 4.40]
  const double critical = 2 / 0.4 * 2 * std::sqrt(1.4);
  double last = 1;
  for (double short_of : {1e-1, 1e-2, 1e-3, 1e-6, 1e-9}) {
    const double u = critical * (1 - short_of) / 2;
    const RiemannSolution solution({{1, -u, 1}, {1, u, 1}, 1.4});
    EXPECT_FALSE(solution.vacuum());
    const Bounded p = solution.star().pressure;
    EXPECT_NEAR(p.value, std::pow(short_of, 7), 0.01 * p.value + p.bound);  // ((1 - u/u_c))^(2 gamma/(gamma-1))
    EXPECT_LT(p.value, last);
    last = p.value;
  }
  const double u = critical / 2;  // within rounding of the limit: whatever is answered, the bound admits both
  const Bounded p = RiemannSolution({{1, -u, 1}, {1, u, 1}, 1.4}).star().pressure;
  EXPECT_GE(p.bound, p.value);
  EXPECT_LT(p.bound, 1e-100);
}

TEST(RiemannVacuum, ColdGases) {
  const RiemannSolution apart({{1, -1, 0}, {2, 3, 0}, 1.4});
  EXPECT_TRUE(apart.vacuum());
  EXPECT_EQ(apart.sample(-2).density.value, 1);
  EXPECT_EQ(apart.sample(0).density.value, 0);
  EXPECT_EQ(apart.sample(3).density.value, 2);
  const RiemannSolution together({{1, 0.3, 0}, {2, 0.3, 0}, 1.4});
  EXPECT_FALSE(together.vacuum());
  EXPECT_EQ(together.star().density_left.value, 1);
  EXPECT_EQ(together.sample(0.3).density.value, 2);
  EXPECT_EQ(together.sample(0.2).density.value, 1);
}

TEST(RiemannSample, TakesTheValueOnTheRightAtAJump) {
  const RiemannSolution solution(sod);
  const double shock = solution.right_wave().head.value, contact = solution.star().velocity.value;
  EXPECT_EQ(solution.sample(shock).density.value, 0.125);
  EXPECT_EQ(solution.sample(std::nextafter(shock, 0)).density.value, solution.star().density_right.value);
  EXPECT_EQ(solution.sample(contact).density.value, solution.star().density_right.value);
  EXPECT_EQ(solution.sample(std::nextafter(contact, 0)).density.value, solution.star().density_left.value);
}

TEST(RiemannSample, BoundAtAJumpCoversBothSides) {
  const RiemannSolution solution(sod);
  const double shock = solution.right_wave().head.value;
  EXPECT_GE(solution.sample(shock).density.bound, solution.star().density_right.value - 0.125);
  EXPECT_LE(solution.sample(shock + 1e-12).density.bound, 0);
}

TEST(RiemannSample, JumpsOfSodAreInOrder) {
  const std::vector<double> jumps = RiemannSolution(sod).jumps();
  ASSERT_EQ(jumps.size(), 4u);  // head, tail, contact, shock
  EXPECT_NEAR(jumps[0], -std::sqrt(1.4), 1e-15);
  EXPECT_NEAR(jumps[2], 0.92745, 5e-6);  // Toro, table 4.3
  EXPECT_NEAR(jumps[3], 1.7522, 5e-5);   // rho u = (rho - rho_R) S with the star state of table 4.3
}

TEST(RiemannSample, WeakestWavesAreNotLost) {
  const RiemannSolution still({{1, 2, 3}, {1, 2, 3}, 1.4});
  EXPECT_NEAR(still.star().pressure.value, 3, still.star().pressure.bound);
  const Sample s = still.sample(1.5);
  EXPECT_NEAR(s.density.value, 1, s.density.bound);
  EXPECT_LE(s.density.bound, sharp);
  const RiemannSolution sound({{1, 0, 1}, {1, 0, 1 + 1e-8}, 1.4});  // acoustics: p* is the mean
  EXPECT_NEAR(sound.star().pressure.value, 1 + 0.5e-8, 1e-16);      // to the square of the strength
}

TEST(RiemannProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const RiemannProblem& problem) { return refused_key([&] { RiemannSolution solution(problem); }); };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(key({{1, 0, 1}, {1, 0, 1}, 1.0}), "gamma");
  EXPECT_EQ(key({{1, 0, 1}, {1, 0, 1}, nan}), "gamma");
  EXPECT_EQ(key({{-1, 0, 1}, {1, 0, 1}, 1.4}), "left.density");
  EXPECT_EQ(key({{1, 0, 1}, {1, infinity, 1}, 1.4}), "right.velocity");
  EXPECT_EQ(key({{1, 0, 1}, {1, 0, -1}, 1.4}), "right.pressure");
  EXPECT_EQ(key({{0, 0, 1}, {1, 0, 1}, 1.4}), "left.pressure");
  EXPECT_EQ(key({{0, 0, 0}, {0, 0, 0}, 1.4}), "left.density");
}

}  // namespace
}  // namespace plumbline::reference::riemann_test
