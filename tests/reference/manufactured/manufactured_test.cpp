// Manufactured solutions: published body forces in closed form, stress from the stored energy, momentum by differences,
// free and resting edges.
#include "reference/manufactured/manufactured.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::manufactured_test {
namespace {

using Position = std::vector<double>;

struct Case {
  std::unique_ptr<ManufacturedSolution> solution;
  std::vector<Position> points;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  AxisAlignedProblem lengthy = mms_cube_problem(0.3);
  lengthy.length = 2.5;
  lengthy.phase = {0.2, 0.7, -0.4};
  all.push_back({mms_axis_aligned(mms_bar_problem()), {{0.1}, {0.5}, {0.83}}});
  all.push_back({mms_axis_aligned(mms_square_problem()), {{0.1, 0.7}, {0.5, 0.3}, {0.83, 0.9}}});
  all.push_back({mms_axis_aligned(lengthy), {{0.1, 0.7, 1.1}, {2, 0.3, 2.2}}});
  all.push_back({mms_ring(), {{0.5, 0}, {0.4, 0.45}, {-0.3, 0.7}}});
  all.push_back({mms_ring({2e3, 7, 0.2, 0.9, 0.05}), {{0.21, 0}, {0.4, 0.45}, {-0.3, 0.7}}});
  all.push_back({mms_vortex(), {{0.75, 0}, {0.6, 0.7}, {-0.3, -0.9}}});
  all.push_back({mms_vortex({30, 0.1, 4, 0.5, 1.4, -1.7, 3}), {{0.6, 0}, {0.6, 0.7}, {-0.3, -0.9}}});
  return all;
}

double largest(std::span<const double> numbers) {
  double size = 0;
  for (double number : numbers) size = std::max(size, std::abs(number));
  return size;
}

TEST(ManufacturedIdentity,
     MomentumBalanceByDifferences) {  // rho0 b = rho0 a - Div P, P for neighbours by [Wallstedt 2008]
  for (const Case& c : cases()) {
    const ManufacturedSolution& s = *c.solution;
    const int dim = s.dimension();
    for (const Position& at : c.points) {
      for (double share : {0.13, 0.5, 0.77}) {
        const double t = share * s.end_time(), h = 1e-4;
        const ManufacturedState<double> here = s.values(at, t);
        Vector<double> divergence{};
        for (int j = 0; j < dim; ++j) {
          auto stress = [&](double shift) {
            Position beside = at;
            beside[j] += shift;
            return s.values(beside, t).stress;
          };
          const Tensor<double> p2 = stress(2 * h), p1 = stress(h), m1 = stress(-h), m2 = stress(-2 * h);
          for (int i = 0; i < dim; ++i) {
            const int ij = dim * i + j;
            divergence[i] += (8 * (p1[ij] - m1[ij]) - (p2[ij] - m2[ij])) / (12 * h);
          }
        }
        // truncation h^4 times a fifth derivative, at most (2 pi/width)^5 = 1e5 of the stress; rounding 1e-16 E/h
        const double margin = 1e-9 * s.youngs_modulus() + 1e-10 * largest(divergence);
        for (int i = 0; i < dim; ++i) {
          EXPECT_NEAR(s.density() * (here.acceleration[i] - here.body_force[i]), divergence[i], margin);
        }
      }
    }
  }
}

TEST(ManufacturedIdentity, VelocityAndAccelerationAreRatesOfTheDisplacement) {
  for (const Case& c : cases()) {
    const ManufacturedSolution& s = *c.solution;
    const double t = 0.37 * s.end_time(), k = 1e-4 * s.end_time();
    for (const Position& at : c.points) {
      const auto before = s.values(at, t - k), now = s.values(at, t), after = s.values(at, t + k);
      const double speed = largest(now.velocity) + 1e-3, force = largest(now.acceleration) + speed / s.end_time();
      for (int i = 0; i < s.dimension(); ++i) {
        // truncation (2 pi 1e-4)^2/6 = 7e-8
        EXPECT_NEAR((after.displacement[i] - before.displacement[i]) / (2 * k), now.velocity[i], 1e-6 * speed);
        EXPECT_NEAR((after.velocity[i] - before.velocity[i]) / (2 * k), now.acceleration[i], 1e-6 * force);
      }
    }
  }
}

TEST(ManufacturedIdentity, StressIsTheDerivativeOfTheStoredEnergy) {  // [Wallstedt 2008]: P = dW/dF
  const auto lame = Lame<double>::from(3e3, 0.27);
  EXPECT_NEAR(lame.lambda, 3e3 * 0.27 / (1.27 * 0.46), 1e-12);
  EXPECT_NEAR(lame.mu, 1.5e3 / 1.27, 1e-12);
  for (int dim : {1, 2, 3}) {
    Tensor<double> f{};
    for (int i = 0; i < dim * dim; ++i) f[i] = (i % (dim + 1) == 0 ? 1.2 : 0) + 0.1 * std::sin(1.7 * i + 1);
    const Tensor<double> stress = first_piola(f, dim, lame);
    for (int i = 0; i < dim * dim; ++i) {
      Tensor<double> above = f, below = f;
      above[i] += 1e-5;
      below[i] -= 1e-5;
      const double slope = (stored_energy(above, dim, lame) - stored_energy(below, dim, lame)) / 2e-5;
      EXPECT_NEAR(stress[i], slope, 1e-6 * lame.mu);  // truncation 1e-10, rounding 1e-11
    }
    const Tensor<double> sigma = cauchy_stress(f, stress, dim);
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) EXPECT_NEAR(sigma[dim * i + j], sigma[dim * j + i], 1e-12 * lame.mu);
    }
  }
}

// b = pi^2 u/rho0 (lambda (1 - ln J)/F^2 + mu (1 + 1/F^2) - E), F the stretch along the same axis, as in the codes of
// Wallstedt, of de Vaucorbeil et al. and in the Uintah verification suite.
TEST(ManufacturedPublished, AxisAlignedBodyForce) {  // [Wallstedt 2008]
  for (const AxisAlignedProblem& p : {mms_bar_problem(0.05), mms_square_problem(), mms_cube_problem()}) {
    const auto solution = mms_axis_aligned(p);
    const auto lame = Lame<double>::from(p.youngs_modulus, p.poisson);
    const Position at = {0.21, 0.48, 0.9};
    for (double t : {0.1 * solution->end_time(), 0.62 * solution->end_time()}) {
      const auto s = solution->values(at, t);
      double volume = 1;
      for (int i = 0; i < p.dimension; ++i) volume *= s.deformation[(p.dimension + 1) * i];
      for (int i = 0; i < p.dimension; ++i) {
        const double f = s.deformation[(p.dimension + 1) * i];
        const double published = M_PI * M_PI * s.displacement[i] / p.density *
                                 (lame.lambda * (1 - std::log(volume)) / (f * f) + lame.mu * (1 + 1 / (f * f)) -
                                  p.youngs_modulus);
        EXPECT_NEAR(s.body_force[i], published, 1e-13 * p.youngs_modulus / p.density * 10);
      }
    }
  }
}

TEST(ManufacturedPublished, BarAtItsSteepest) {  // u, v, F of the published bar at a quarter of its period
  const auto bar = mms_axis_aligned(mms_bar_problem(0.05));
  EXPECT_NEAR(bar->wave_speed().value, 100, 1e-13);
  EXPECT_NEAR(bar->end_time(), 0.02, 1e-17);
  const auto s = bar->values(Position{0.0}, 0.005);
  EXPECT_NEAR(s.deformation[0], 1 + 0.05 * M_PI, 1e-15);
  EXPECT_NEAR(bar->values(Position{0.5}, 0.005).displacement[0], 0.05, 1e-17);
  EXPECT_NEAR(bar->values(Position{0.5}, 0).velocity[0], 0.05 * M_PI * 100, 1e-13);
}

// In the frame that turns with the circle, with alpha = g h: b_r = mu/rho0 R alpha'^2 - R alphadot^2,
// b_t = R alphaddot - mu/rho0 (3 alpha' + R alpha''); the Uintah verification suite has it for these numbers as powers
// of R.
TEST(ManufacturedPublished, VortexBodyForce) {  // [Kamojjala 2015]
  const VortexProblem p;
  const auto vortex = mms_vortex(p);
  const double mu = vortex->lame().mu.value;
  for (double R : {0.76, 0.9, 1.13, 1.25}) {
    for (double t : {0.0, 0.2, 0.5, 0.9}) {
      const double theta = 0.7, s = std::sin(M_PI * t), c = std::cos(M_PI * t);
      const double quartic = (4 * R - 3) * (4 * R - 5), h = quartic * quartic;
      const double br = -R * c * c * M_PI * M_PI * h * h +
                        2 / p.density * 2048 * std::pow((4 * R - 5) * (R - 1) * (4 * R - 3), 2) * s * s * R * mu;
      const double bt = -s *
                        (R * M_PI * M_PI * h + 64 * mu / p.density * (96 * R * R * R - 240 * R * R + 188 * R - 45));
      const double beta = theta + s * h;
      const Vector<double> b = vortex->body_force(Position{R * std::cos(theta), R * std::sin(theta)}, t);
      EXPECT_NEAR(b[0], std::cos(beta) * br - std::sin(beta) * bt, 1e-11);
      EXPECT_NEAR(b[1], std::sin(beta) * br + std::cos(beta) * bt, 1e-11);
    }
  }
}

TEST(ManufacturedPublished, RingCoefficientsAndDisplacement) {  // [Wallstedt 2008]: 4 R^3 - 9 R^2 + 6 R for 0.5 and 1
  const auto ring = mms_ring();
  for (double R : {0.5, 0.6, 0.95, 1.0}) {
    EXPECT_NEAR(ring->values(Position{R, 0}, 0).displacement[0], 0.1 * (4 * R * R * R - 9 * R * R + 6 * R), 1e-15);
    EXPECT_NEAR(ring->values(Position{0, R}, 0.01).displacement[1], -0.1 * (4 * R * R * R - 9 * R * R + 6 * R), 1e-15);
  }
}

void expect_free(const ManufacturedSolution& solution, double radius, double time) {
  for (double angle : {0.0, 0.4, 2.0, 5.1}) {
    const double n[2] = {std::cos(angle), std::sin(angle)};
    const auto s = solution.values(Position{radius * n[0], radius * n[1]}, time);
    for (int i = 0; i < 2; ++i) {
      // the place itself is off the edge by rounding, where strains change by up to 100 over the width
      EXPECT_NEAR(s.stress[2 * i] * n[0] + s.stress[2 * i + 1] * n[1], 0, 1e-13 * solution.youngs_modulus());
    }
  }
}

TEST(ManufacturedBoundary, EdgesOfTheRingAreFreeOfTraction) {  // [Wallstedt 2008]
  for (const RingProblem& p :
       {RingProblem{}, RingProblem{3e3, 2, 0.2, 0.5, -0.03}, RingProblem{1e4, 1, 0.1, 1, 0.05}}) {
    const auto ring = mms_ring(p);
    for (double t : {0.0, 0.003, 0.017}) {
      expect_free(*ring, p.inner, t);
      expect_free(*ring, p.outer, t);
    }
  }
}

TEST(ManufacturedBoundary, EdgesOfTheVortexRestAndAreFree) {  // [Kamojjala 2015]
  for (const VortexProblem& p : {VortexProblem{}, VortexProblem{40, 0.4, 2, 0.3, 1.1, 2, 0.5}}) {
    const auto vortex = mms_vortex(p);
    for (double t : {0.0, 0.3 * p.period, 0.5 * p.period}) {
      for (double radius : {p.inner, p.outer}) {
        expect_free(*vortex, radius, t);
        const auto s = vortex->values(Position{0, radius}, t);
        EXPECT_NEAR(largest(s.displacement), 0, 1e-15);
        EXPECT_NEAR(largest(s.velocity), 0, 1e-14 / p.period);
      }
      const auto s = vortex->values(Position{0.5 * (p.inner + p.outer), 0}, t);  // turns most
      const double alpha = p.amplitude * std::sin(M_PI * t / p.period);
      EXPECT_NEAR(s.displacement[1], 0.5 * (p.inner + p.outer) * std::sin(alpha), 1e-15);
    }
  }
}

TEST(ManufacturedBoundary, FacesOfTheCubeCarryNoShear) {  // [Wallstedt 2008]: normal motion vanishes on them
  const auto cube = mms_axis_aligned(mms_cube_problem());
  for (double face : {0.0, 1.0}) {
    const auto s = cube->values(Position{0.3, face, 0.8}, 0.004);
    EXPECT_NEAR(s.displacement[1], 0, 1e-16);
    EXPECT_EQ(s.stress[1], 0);
    EXPECT_EQ(s.stress[3], 0);
  }
}

TEST(ManufacturedState, BoundsCoverTheFastNumbers) {  // the fast path makes the same roundings
  for (const Case& c : cases()) {
    for (const Position& at : c.points) {
      const double t = 0.4 * c.solution->end_time();
      const auto bounded = c.solution->state(at, t);
      const auto fast = c.solution->values(at, t);
      for (int i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs(fast.body_force[i] - bounded.body_force[i].value), bounded.body_force[i].bound);
        EXPECT_EQ(fast.body_force[i], c.solution->body_force(at, t)[i]);
      }
    }
  }
}

TEST(ManufacturedProblem, WrongProblemsAreRefusedByKey) {
  auto axis = [](auto change) {
    AxisAlignedProblem p = mms_square_problem();
    change(p);
    return refused_key([&] { mms_axis_aligned(p); });
  };
  EXPECT_EQ(axis([](auto& p) { p.dimension = 4; }), "dimension");
  EXPECT_EQ(axis([](auto& p) { p.youngs_modulus = 0; }), "youngs_modulus");
  EXPECT_EQ(axis([](auto& p) { p.poisson = 0.5; }), "poisson");
  EXPECT_EQ(axis([](auto& p) { p.density = -1; }), "density");
  EXPECT_EQ(axis([](auto& p) { p.length = 0; }), "length");
  EXPECT_EQ(axis([](auto& p) { p.amplitude = -0.32; }), "amplitude");  // 1/pi = 0.318
  EXPECT_EQ(axis([](auto& p) { p.phase[1] = NAN; }), "phase");
  EXPECT_EQ(refused_key([] { mms_ring({1e4, 1, 0.5, 0.4, 0.1}); }), "inner");
  EXPECT_EQ(refused_key([] { mms_ring({1e4, 1, 0.5, 1.5, 0.1}); }), "outer");
  EXPECT_EQ(refused_key([] { mms_ring({1e4, 1, 0.5, 1, 0.4}); }), "amplitude");  // u_R/R = 2.5 times 0.4 at the inside
  EXPECT_EQ(refused_key([] { mms_vortex({1e3, 0.3, 1e3, 0, 1}); }), "inner");
  EXPECT_EQ(refused_key([] { mms_vortex({1e3, 0.3, 1e3, 0.5, 1, 1, 0}); }), "period");
  EXPECT_EQ(refused_key([] { mms_vortex()->state(Position{0.5, 0.5}, 0); }), "x");
  EXPECT_EQ(refused_key([] { mms_ring()->state(Position{0.5, 0.5}, -1); }), "time");
  EXPECT_EQ(refused_key([] { mms_axis_aligned(mms_square_problem())->state(Position{0.5, 1.1}, 0); }), "x");
}

}  // namespace
}  // namespace plumbline::reference::manufactured_test
