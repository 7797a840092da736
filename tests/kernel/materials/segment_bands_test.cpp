// Segments as bands around an axis, and the forces between points alone. [Segments 3]
#include <Eigen/Core>
#include <numbers>

#include "kernel/materials/segment_membrane.hpp"
#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/dense.hpp"

namespace plumbline::segment_bands_test {
namespace {

using scenes::Place;
using scenes::Space;
constexpr double pi = std::numbers::pi;
constexpr double rounding = 4e-14;  // a handful of operations on tensions of order ten
constexpr MaterialContext context{2, 0.1, false, 0, false};

SegmentMembrane bands(double nu = 0.3) {
  SegmentMembrane law;
  law.youngs_modulus = 100;
  law.density = 4;
  law.section = 0.2;
  law.revolved = true;
  law.poissons_ratio = nu;
  return law;
}

// The printed energy, by hand: both pull, one does, none.
double printed_energy(const SegmentMembrane& law, double s, double h) {
  const double e = law.youngs_modulus, nu = law.poissons_ratio;
  if (s + nu * h > 0 && h + nu * s > 0) return e / (1 - nu * nu) / 2 * (s * s + h * h + 2 * nu * s * h);
  if (s > 0) return e * s * s / 2;
  if (h > 0) return e * h * h / 2;
  return 0;
}

// Pairs of strains all over the plane, and some close to the borders of the three regions.
std::vector<std::array<double, 2>> strains() {
  scenes::Random random(31);
  std::vector<std::array<double, 2>> all;
  for (int k = 0; k < 400; ++k) all.push_back({random(-0.3, 0.3), random(-0.3, 0.3)});
  for (int k = 0; k < 100; ++k) {
    const double t = random(0.02, 0.3), off = random(-1e-3, 1e-3);
    all.push_back({t, -0.3 * t + off});
    all.push_back({-0.3 * t + off, t});
  }
  return all;
}

// Stresses are the slopes of the energy, by central differences: of a parabola exact, beside a border off by the step
// of the second derivative, 1e2 E', over 1e-6. [Segments 3]
TEST(SegmentBands, StressesAreSlopesOfTheEnergy) {
  for (const double nu : {0.0, 0.3, 0.45}) {
    const SegmentMembrane law = bands(nu);
    const double d = 1e-6;
    for (const auto& [s, h] : strains()) {
      const auto state = law.band(s, h);
      EXPECT_NEAR(state.energy, printed_energy(law, s, h), 1e-14);
      EXPECT_NEAR(state.along, (printed_energy(law, s + d, h) - printed_energy(law, s - d, h)) / (2 * d), 2e-4);
      EXPECT_NEAR(state.around, (printed_energy(law, s, h + d) - printed_energy(law, s, h - d)) / (2 * d), 2e-4);
      EXPECT_GE(state.along, 0);
      EXPECT_GE(state.around, 0);
    }
  }
}

// Across the borders energy and stresses go on without a step, so that 1e-9 of strain changes them by no more than E'
// 1e-9 and a little; and (d sigma) . (d eps) >= 0 between any two states: convex. [Segments 3]
TEST(SegmentBands, EnergyIsSmoothAndConvex) {
  for (const double nu : {0.0, 0.3, 0.45}) {
    const SegmentMembrane law = bands(nu);
    const double stiff = 100 / (1 - nu * nu) * (1 + nu);
    for (const double t : {0.01, 0.1, 0.3}) {
      const std::array<double, 2> borders[] = {{t, -nu * t}, {-nu * t, t}, {0, -t}, {-t, 0}};
      for (const auto& [s, h] : borders) {
        for (const auto& [ds, dh] : {std::array{1e-9, 0.0}, {0.0, 1e-9}}) {
          const auto low = law.band(s - ds, h - dh), high = law.band(s + ds, h + dh);
          EXPECT_NEAR(low.energy, high.energy, stiff * 2e-9 * 0.5);
          EXPECT_NEAR(low.along, high.along, stiff * 2.1e-9);
          EXPECT_NEAR(low.around, high.around, stiff * 2.1e-9);
        }
      }
    }
    const auto all = strains();
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      const auto a = law.band(all[k][0], all[k][1]), b = law.band(all[k + 1][0], all[k + 1][1]);
      const double ds = all[k + 1][0] - all[k][0], dh = all[k + 1][1] - all[k][1];
      EXPECT_GE((b.along - a.along) * ds + (b.around - a.around) * dh, -1e-14);
      EXPECT_GE(b.energy - a.energy, a.along * ds + a.around * dh - 1e-14);  // above its tangent plane
    }
  }
}

// A crooked chain beside the axis, some of it taut both ways, some wrinkled, some slack.
Columns crooked(const SegmentMembrane& law, int count = 12) {
  Columns points = make_body("bag", std::make_shared<SegmentMembrane>(law), count, 2, true).points;
  scenes::Random random(6);
  for (int p = 0; p < count; ++p) {
    points(column::position)[p] = 0.5 + 0.2 * std::cos(1.3 * p);
    points(column::position, 1)[p] = 0.3 * p + 0.04 * std::sin(3.0 * p);
    points(column::volume)[p] = 0.05 + 0.01 * p;
    points(column::mass)[p] = 4 * points(column::volume)[p];
  }
  for (int p = 0; p < count; ++p) {
    const int next = (p + 1) % count;
    points(column::rest_length)[p] = random(0.9, 1.1) *
                                     std::hypot(points(column::position)[next] - points(column::position)[p],
                                                points(column::position, 1)[next] - points(column::position, 1)[p]);
    points(column::rest_radius)[p] = random(0.9, 1.1) * 0.5 *
                                     (points(column::position)[p] + points(column::position)[next]);
  }
  return points;
}

double printed_energy(const SegmentMembrane& law, const Columns& points) {
  const int n = points.points();
  double sum = 0;
  for (int p = 0; p < (law.closed ? n : n - 1); ++p) {
    const int next = (p + 1) % n;
    const double rest = points(column::rest_length)[p], radius = points(column::rest_radius)[p];
    const double length = std::hypot(points(column::position)[next] - points(column::position)[p],
                                     points(column::position, 1)[next] - points(column::position, 1)[p]);
    const double mean = 0.5 * (points(column::position)[p] + points(column::position)[next]);
    sum += law.section * rest * radius * printed_energy(law, length / rest - 1, mean / radius - 1);
  }
  return sum;
}

// -V_p times the stress column is F_p = -dW/dx_p, W = sum A L R w. Differences of an energy whose third derivative
// stays below 1e3 but for steps of the second at borders. And what is stored is W. [Segments 3]
TEST(SegmentBands, ForceIsTheSlopeOfTheEnergy) {
  for (const bool closed : {false, true}) {
    SegmentMembrane law = bands();
    law.closed = closed;
    Columns points = crooked(law);
    law.evaluate_stress(points, all_points(points), context);
    const double d = 1e-6;
    for (int p = 0; p < points.points(); ++p) {
      for (int k = 0; k < 2; ++k) {
        Columns low = points, high = points;
        low(column::position, k)[p] -= d;
        high(column::position, k)[p] += d;
        const double force = -points(column::volume)[p] * points(column::stress, k)[p];
        EXPECT_NEAR(force, -(printed_energy(law, high) - printed_energy(law, low)) / (2 * d), 1e-8) << p << ' ' << k;
      }
    }
    const double stored = law.advance(points, all_points(points), context, 0.1);
    EXPECT_NEAR(stored, printed_energy(law, points), rounding);
    EXPECT_NEAR(law.stored_energy(points, all_points(points)), printed_energy(law, points), rounding);
    EXPECT_NEAR(law.advance(points, all_points(points), context, 0.1), 0, 1e-16);
    Columns described = crooked(law);
    law.describe(described);
    for (const ColumnId* id : {&column::strain, &column::hoop_strain}) {
      for (int p = 0; p < points.points(); ++p) EXPECT_EQ(described(*id)[p], points(*id)[p]);
    }
  }
}

// The rates are those of the strains, by differences over points that go on with their velocities. [Segments 3]
TEST(SegmentBands, RatesOfBothStrains) {
  const SegmentMembrane law = bands();
  Columns points = crooked(law);
  scenes::Random random(3);
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < points.points(); ++p) points(column::strain_rate, d)[p] = random(-1, 1);
  }
  const auto after = [&](double dt) {
    Columns moved = points;
    for (int d = 0; d < 2; ++d) {
      for (int p = 0; p < points.points(); ++p) moved(column::position, d)[p] += dt * points(column::strain_rate, d)[p];
    }
    law.describe(moved);
    return moved;
  };
  const double dt = 1e-6;
  const Columns low = after(-dt), high = after(dt);
  const auto rates = law.rates(points, context);
  ASSERT_EQ(law.internal_variables(context), (std::vector<const ColumnId*>{&column::strain, &column::hoop_strain}));
  const auto n = static_cast<std::size_t>(points.points());
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_NEAR(rates[p], (high(column::strain)[p] - low(column::strain)[p]) / (2 * dt), 1e-8);
    EXPECT_NEAR(rates[n + p], (high(column::hoop_strain)[p] - low(column::hoop_strain)[p]) / (2 * dt), 1e-8);
  }
  MaterialContext ahead = context;
  ahead.ahead = 0.02;
  Columns later = after(0.02);
  law.evaluate_stress(points, all_points(points), ahead);
  law.evaluate_stress(later, all_points(later), context);
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < points.points(); ++p) {
      EXPECT_NEAR(points(column::stress, d)[p], later(column::stress, d)[p], 1e-11);
    }
  }
}

TEST(SegmentBands, WavesAndFaults) {
  const SegmentMembrane law = bands();
  Columns points = crooked(law);
  EXPECT_NEAR(law.step_bounds(points, all_points(points), 2).fastest, std::sqrt(100 / 0.91 / 4), 1e-14);
  EXPECT_EQ(law.first_fault(points, all_points(points)).point, -1);
  points(column::rest_radius)[11] = 0;  // the last of an open chain has no band
  EXPECT_EQ(law.first_fault(points, all_points(points)).point, -1);
  points(column::rest_radius)[4] = 0;
  EXPECT_EQ(law.first_fault(points, all_points(points)).point, 4);
  EXPECT_EQ(law.first_fault(points, all_points(points)).field, "rest_radius");
}

// --- forces between points alone ------------------------------------------------------------------------------------

struct ChainCase {
  SegmentMembrane law;
  Columns points;
};
std::vector<ChainCase> chains() {
  std::vector<ChainCase> all;
  for (const bool closed : {false, true}) {
    SegmentMembrane law = bands();
    law.closed = closed;
    all.push_back({law, crooked(law)});
    Columns taut = crooked(law);
    for (int p = 0; p < taut.points(); ++p) {
      taut(column::rest_length)[p] *= 0.8;
      taut(column::rest_radius)[p] *= 0.8;
    }
    all.push_back({law, taut});
    Columns narrow = taut;  // rings: all their stiffness is around
    for (int p = 0; p < taut.points(); ++p) {
      narrow(column::position)[p] *= 0.02;
      narrow(column::rest_radius)[p] *= 0.02;
      narrow(column::rest_length)[p] = 0.28;
    }
    all.push_back({law, narrow});
    Columns tube = crooked(law, 20);  // even: as close to the bound as a chain comes
    for (int p = 0; p < tube.points(); ++p) {
      tube(column::position)[p] = 0.5;
      tube(column::position, 1)[p] = 0.1 * p;
      tube(column::mass)[p] = 0.3;
      tube(column::rest_length)[p] = 0.08;
      tube(column::rest_radius)[p] = 0.4;
    }
    if (!closed) all.push_back({law, tube});
    law.revolved = false;
    law.poissons_ratio = 0;
    for (const bool one_way : {true, false}) {
      law.one_way = one_way;
      all.push_back({law, crooked(bands())});
      all.push_back({law, taut});
    }
  }
  return all;
}

// What relaxes a chain are the forces that move it. [Segments 2] [Segments 3]
TEST(SegmentForces, AreThoseOfTheStressColumn) {
  for (auto& [law, points] : chains()) {
    std::vector<double> force;
    law.point_forces(points, force);
    law.evaluate_stress(points, all_points(points), context);
    const auto n = static_cast<std::size_t>(points.points());
    ASSERT_EQ(force.size(), 2 * n);
    for (int d = 0; d < 2; ++d) {
      for (std::size_t p = 0; p < n; ++p) {
        EXPECT_NEAR(force[static_cast<std::size_t>(d) * n + p],
                    -points(column::volume)[p] * points(column::stress, d)[p], rounding);
      }
    }
  }
}

// Largest eigenvalue w^2 of M^-1 K, K by differences of the forces.
double fastest_of(const SegmentMembrane& law, const Columns& points) {
  const int n = points.points();
  const double d = 1e-7;
  Eigen::MatrixXd k(2 * n, 2 * n);
  for (int c = 0; c < 2 * n; ++c) {
    Columns low = points, high = points;
    low(column::position, c / n)[c % n] -= d;
    high(column::position, c / n)[c % n] += d;
    std::vector<double> under, over;
    law.point_forces(low, under);
    law.point_forces(high, over);
    for (int r = 0; r < 2 * n; ++r) {
      const auto i = static_cast<std::size_t>(r);
      k(r, c) = -(over[i] - under[i]) / (2 * d) / std::sqrt(points(column::mass)[r % n] * points(column::mass)[c % n]);
    }
  }
  return dense::symmetric_spectrum(k).values.maxCoeff();
}

// 1 / tau is no less than w^2 of the fastest oscillation, and of an even chain, open or closed, no more than what is
// missing to its zigzag: w^2 = (2 + 2 cos(pi / n)) k / m of 4 k / m.
TEST(SegmentForces, TimeIsBelowTheFastestOscillation) {
  for (auto& [law, points] : chains()) {
    std::vector<double> force;
    const double tau = law.point_forces(points, force), fastest = fastest_of(law, points);
    EXPECT_GT(fastest, 0);
    EXPECT_LE(fastest, (1 + 1e-6) / tau);
  }
  SegmentMembrane law = bands(0);
  law.revolved = false;
  const int n = 20;
  Columns points = make_body("net", std::make_shared<SegmentMembrane>(law), n, 2).points;
  for (int p = 0; p < n; ++p) {
    points(column::position)[p] = 0.1 * p;
    points(column::mass)[p] = points(column::volume)[p] = 0.3;
    points(column::rest_length)[p] = 0.08;
  }
  std::vector<double> force;
  const double stiffness = 0.2 * 100 / 0.08;
  EXPECT_NEAR(law.point_forces(points, force), 0.3 / (4 * stiffness), 1e-16);
  EXPECT_NEAR(fastest_of(law, points), (2 + 2 * std::cos(pi / n)) * stiffness / 0.3, 1e-4 * stiffness);
}

// One point has no neighbour to be moved by: no time either.
TEST(SegmentForces, OfASinglePointAreNone) {
  const SegmentMembrane law = bands();
  const Columns points = crooked(law, 1);
  std::vector<double> force;
  EXPECT_EQ(law.point_forces(points, force), 0);
  EXPECT_EQ(force, (std::vector<double>{0, 0}));
}

// --- bags -----------------------------------------------------------------------------------------------------------

// A sphere of radius r made at R = 1: eps = r/R - 1 both ways, for chords and bands alike, so W = A S E eps^2 / (1 -
// nu), per radian, with S = 2 R^2 the surface of rest. What drives it apart balances p times what its volume gains, 2
// r^2 p = dW/dr: p r / 2 = sigma A R / r, sigma = E eps / (1 - nu) and A R / r the thickness as if it kept its share of
// the ring. The surface of the polygon is off by less than half the square of its angle, and so is each ring's share.
// [Segments 3]
TEST(SegmentBags, SphereHasTheStressOfItsPressure) {
  const SegmentMembrane law = bands();
  for (const int n : {20, 40, 80}) {
    Columns points = make_body("bag", std::make_shared<SegmentMembrane>(law), n + 1, 2, true).points;
    const double r = 1.1;
    const auto at = [&](int k) { return std::array{r * std::sin(pi * k / n), -r * std::cos(pi * k / n)}; };
    for (int k = 0; k <= n; ++k) {
      points(column::position)[k] = at(k)[0];
      points(column::position, 1)[k] = at(k)[1];
      points(column::volume)[k] = 1;
    }
    for (int k = 0; k < n; ++k) {
      points(column::rest_length)[k] = std::hypot(at(k + 1)[0] - at(k)[0], at(k + 1)[1] - at(k)[1]) / r;
      points(column::rest_radius)[k] = 0.5 * (at(k + 1)[0] + at(k)[0]) / r;
    }
    law.evaluate_stress(points, all_points(points), context);
    const double p = 2 * 0.2 / (r * r) * (100 / 0.7) * (r - 1);
    double apart = 0;
    for (int k = 0; k <= n; ++k) {
      const double fx = -points(column::stress)[k], fy = -points(column::stress, 1)[k];
      const double sx = at(k)[0] / r, sy = at(k)[1] / r;
      apart += fx * sx + fy * sy;
      if (sx < 0.3 || n < 80) continue;
      // Each ring by itself: the pressure on its share r^2 sin(a) da, to second order.
      const double share = p * r * r * sx * pi / n;
      EXPECT_NEAR(fx * sx + fy * sy, -share, share * std::pow(pi / n, 2) / (sx * sx));
    }
    const double angle = pi / n;
    EXPECT_NEAR(apart, -p * 2 * r * r, p * 2 * r * r * angle * angle / 2) << n;
  }
}

// A tube between two mirrors under an inner pressure that follows it, at rest in the end: with A the thickness,
//   both ways taut   p r (1 + eps_s) = A E' (eps_h + nu eps_s),  along E' (eps_s + nu eps_h)
//   wrinkled along   p r (1 + eps_s) = A E eps_h,  nothing along.
// All points do the same, so the grid adds nothing to it, and what is left of the motion after damping is below 1e-9.
// [Segments 3]
TEST(SegmentBags, TubeHasTheStressOfItsPressure) {
  for (const double stretch : {0.01, -0.2}) {
    for (const char* integrator : {"leapfrog", "midpoint"}) {
      const GridSpec grid = scenes::box(Space::axisymmetric, {9, 4, 1}, 0.1,
                                        scenes::walls(Wall::symmetry, Wall::free, Wall::symmetry, Wall::symmetry));
      const double radius = 0.5, spacing = 0.025, thickness = 0.02, pressure = 0.004;
      auto law = std::make_shared<SegmentMembrane>(bands());
      law->youngs_modulus = 1.5;
      law->density = 1;
      law->section = thickness;
      Body body = make_body("tube", law, 17, 2, true);
      for (int p = 0; p < 17; ++p) {
        body.points(column::position)[p] = radius;
        body.points(column::position, 1)[p] = spacing * p;
        body.points(column::rest_length)[p] = spacing / (1 + stretch);
        body.points(column::rest_radius)[p] = radius;
        const double share = p == 0 || p == 16 ? 0.5 : 1;
        body.points(column::mass)[p] = body.points(column::volume)[p] = share * thickness * radius * spacing;
      }
      body.load = [=](double, Columns& points, std::span<const int>) {
        for (int p = 0; p < points.points(); ++p) {
          const double share = p == 0 || p == 16 ? 0.5 : 1, r = points(column::position)[p];
          points(column::body_force)[p] = pressure * r * spacing * share / points(column::mass)[p] -
                                          4 * points(column::velocity)[p];
          points(column::body_force, 1)[p] = 0;
        }
      };
      Simulation run(scenes::scene_of(grid, {std::move(body)}, "quadratic", "apic"), integrator, {0.5, {}, 1});
      run.run_until(15);
      const Columns& points = run.scene().bodies[0].points;
      const double nu = 0.3, taut = stretch > 0 ? 1.5 / (1 - nu * nu) : 1.5, along = stretch > 0 ? nu * stretch : 0;
      const double pull = pressure * (1 + stretch) / thickness;  // sigma over r
      const double r = (1 - along) / (1 / radius - pull / taut);
      for (int p = 0; p < 17; ++p) {
        EXPECT_NEAR(points(column::position)[p], r, 1e-9);
        EXPECT_NEAR(points(column::position, 1)[p], spacing * p, 1e-12);
        if (p == 16) continue;
        const auto state = law->band(points(column::strain)[p], points(column::hoop_strain)[p]);
        EXPECT_NEAR(state.around, pull * r, 1e-8);
        EXPECT_NEAR(state.along, stretch > 0 ? 1.5 / (1 - nu * nu) * (stretch + nu * (r / radius - 1)) : 0, 1e-8);
      }
    }
  }
}

// A ball of one material under a following pressure, from its pole on the axis to a mirror at its equator, which rests
// in the end at p r^2 = 2 A R E / (1 - nu) (r / R - 1). Forces of the pressure are the slopes of p times the polygon's
// volume. Returns the largest distance of a point from that sphere over r, and with it the largest of both strains'
// errors.
struct BallError {
  double radius = 0, strain = 0, exact = 0;
};
BallError ball_error(int cells, double relaxation) {
  const double h = 1.0 / cells, made = 0.5, thickness = 0.02, pressure = 0.02;
  const int n = static_cast<int>(std::lround(4 * made * pi / 2 / h));
  auto law = std::make_shared<SegmentMembrane>(bands());
  law->youngs_modulus = 1.5;
  law->density = 1;
  law->section = thickness;
  Body body = make_body("ball", law, n + 1, 2, true);
  double *x = body.points(column::position), *y = body.points(column::position, 1);
  for (int k = 0; k <= n; ++k) {
    x[k] = k == n ? 0 : made * std::cos(pi / 2 * k / n);
    y[k] = k == 0 ? 0 : made * std::sin(pi / 2 * k / n);
  }
  for (int k = 0; k < n; ++k) {
    const double rest = std::hypot(x[k + 1] - x[k], y[k + 1] - y[k]), mean = (x[k] + x[k + 1]) / 2;
    body.points(column::rest_length)[k] = rest;
    body.points(column::rest_radius)[k] = mean;
    for (const int end : {k, k + 1}) {
      body.points(column::mass)[end] += thickness * rest * mean / 2;
      body.points(column::volume)[end] += thickness * rest * mean / 2;
    }
  }
  body.load = [=](double, Columns& points, std::span<const int>) {
    const double *r = points(column::position), *z = points(column::position, 1), *mass = points(column::mass);
    double *outward = points(column::body_force), *up = points(column::body_force, 1);
    for (int k = 0; k <= n; ++k) outward[k] = up[k] = 0;
    for (int k = 0; k < n; ++k) {  // V = sum (r_k z_l - r_l z_k)(r_k + r_l) / 6
      const int l = k + 1;
      const double cross = r[k] * z[l] - r[l] * z[k], both = r[k] + r[l];
      outward[k] += pressure / 6 * (z[l] * both + cross);
      outward[l] += pressure / 6 * (cross - z[k] * both);
      up[k] -= pressure / 6 * r[l] * both;
      up[l] += pressure / 6 * r[k] * both;
    }
    for (int k = 0; k <= n; ++k) {
      outward[k] = outward[k] / mass[k] - 4 * points(column::velocity)[k];
      up[k] = up[k] / mass[k] - 4 * points(column::velocity, 1)[k];
    }
  };
  const GridSpec grid = scenes::box(Space::axisymmetric, {cells, cells, 1}, h,
                                    scenes::walls(Wall::symmetry, Wall::free, Wall::symmetry, Wall::free));
  Scene scene = scenes::scene_of(grid, {std::move(body)}, "cubic", "apic");
  scene.sharpening = 1;
  scene.chain_relaxation = relaxation;
  Simulation run(std::move(scene), "leapfrog", {0.5, {}, 1});
  run.run_until(12);
  double r = made;  // the fixed point, whose error falls by a factor of three each time
  for (int k = 0; k < 60; ++k) r = made * (1 + pressure * r * r * 0.7 / (2 * thickness * made * 1.5));
  BallError error;
  error.exact = r / made - 1;
  const Columns& points = run.scene().bodies[0].points;
  for (int k = 0; k <= n; ++k) {
    const double away = std::hypot(points(column::position)[k], points(column::position, 1)[k]);
    error.radius = std::max(error.radius, std::abs(away / r - 1));
    if (k == n) continue;
    for (const ColumnId* id : {&column::strain, &column::hoop_strain}) {
      error.strain = std::max(error.strain, std::abs(points(*id)[k] - error.exact));
    }
  }
  return error;
}

// Off by no more than (h / R)^2 of the strain, and less with finer cells: half of them leave a quarter where the order
// is two, half where it is one, and here less than 0.4. [Segments 3]
TEST(SegmentBags, BallHasTheRadiusOfItsPressure) {
  for (const double relaxation : {0.0, 0.5}) {
    BallError coarse;
    for (const int cells : {10, 20, 40}) {
      const BallError error = ball_error(cells, relaxation);
      const double share = std::pow(1.0 / (cells * 0.5), 2);
      EXPECT_LE(error.radius, share * error.exact) << cells;
      EXPECT_LE(error.strain, share * error.exact) << cells;
      EXPECT_LE(error.radius, cells == 10 ? 1 : 0.4 * coarse.radius) << cells;
      coarse = error;
    }
  }
}

}  // namespace
}  // namespace plumbline::segment_bands_test
