// One elastoplastic point against closed forms: Hencky's law, radial paths, Krieg's turning stress, turned axes.
#include "kernel/materials/radial_return.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::radial_return_test {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

constexpr J2Law law{100, 60, 0.5, 30};
constexpr J2Law perfect{100, 60, 0.5, 0};

Matrix diagonal(const Vector& values) { return values.asDiagonal(); }
Matrix any(scenes::Random& random, double size) {
  return Matrix::NullaryExpr([&] { return random(-size, size); });
}
// (1/2) ln(F F^T) by the eigenvectors of another library than the law's.
Matrix logarithmic(const Matrix& f) {
  const auto [values, vectors] = dense::symmetric_spectrum(f * f.transpose());
  return vectors * (0.5 * values.array().log()).matrix().asDiagonal() * vectors.transpose();
}
// The increment that adds this strain in fixed axes.
Matrix increment(const Vector& strain) {
  return diagonal(strain.unaryExpr([](double e) { return std::expm1(e); }));
}
// von Mises's stress by its differences.
double von_mises(const Matrix& s) {
  const double normal = std::pow(s(0, 0) - s(1, 1), 2) + std::pow(s(1, 1) - s(2, 2), 2) +
                        std::pow(s(2, 2) - s(0, 0), 2);
  return std::sqrt(0.5 * normal + 3 * (s(0, 1) * s(0, 1) + s(1, 2) * s(1, 2) + s(0, 2) * s(0, 2)));
}
J2State step(const J2Law& of, const J2State& state, const Matrix& by) {
  return returned(of, {strained(state.elastic, by), state.plastic});
}

TEST(RadialReturn, ElasticStrainsAreLogarithms) {  // [J2 3]
  scenes::Random random(1);
  for (int k = 0; k < 20; ++k) {
    Matrix f = Matrix::Identity(), elastic = Matrix::Zero();
    for (int n = 0; n < 5; ++n) {
      const Matrix by = any(random, 0.2);
      elastic = strained(elastic, by);
      f = f + by * f;
    }
    if (f.determinant() < 0.1) continue;
    EXPECT_LE((elastic - logarithmic(f)).norm(), 1e-13 * (1 + elastic.norm()));
    EXPECT_LE((elastic - elastic.transpose()).norm(), 1e-15);
    EXPECT_NEAR(elastic.trace(), std::log(f.determinant()), 1e-13);
  }
  EXPECT_FALSE(std::isfinite(strained(Matrix::Zero(), -1.0 * Matrix::Identity()).sum()));  // flattened
}

// Strains far below the rounding of stretches keep their digits. [J2 3]
TEST(RadialReturn, SmallStrainsKeepTheirDigits) {
  scenes::Random random(2);
  const Matrix g = 1e-13 * any(random, 1), symmetric = 0.5 * (g + g.transpose());
  EXPECT_LE((strained(Matrix::Zero(), g) - symmetric).norm(), 1e-12 * symmetric.norm());
  EXPECT_LE((strained(strained(Matrix::Zero(), g), g) - 2 * symmetric).norm(), 1e-12 * symmetric.norm());
}

// The stress is the slope of the energy, q von Mises's stress. [J2 1, 2]
TEST(RadialReturn, StressIsTheSlopeOfTheEnergy) {
  scenes::Random random(3);
  const Matrix g = any(random, 0.3), elastic = 0.5 * (g + g.transpose());
  const Matrix h = any(random, 1), way = 0.5 * (h + h.transpose());
  const Matrix tau = kirchhoff_stress(law, elastic);
  const double d = 1e-4,
               slope = (elastic_energy(law, elastic + d * way) - elastic_energy(law, elastic - d * way)) / (2 * d);
  EXPECT_NEAR(slope, tau.cwiseProduct(way).sum(), 1e-10);  // the energy is a square
  EXPECT_NEAR(equivalent_stress(law, elastic), von_mises(tau), 1e-13 * von_mises(tau));
  EXPECT_NEAR(tau.trace(), 3 * law.bulk * elastic.trace(), 1e-12);
}

// Uniaxial strain and simple extension without change of volume, in one step or many, to finite strains: with the equivalent
// strain E of the deviator, alpha = (3 G E - Y)/(3 G + H), q = Y + H alpha, the pressure elastic. [J2 4]
TEST(RadialReturn, RadialPathsAreExact) {
  for (const J2Law& of : {law, perfect}) {
    for (const Vector& way : {Vector(-1, 0, 0), Vector(1, -0.5, -0.5), Vector(0.2, -0.7, 0.4)}) {
      for (const int steps : {1, 2, 7, 100}) {
        for (const double size : {1e-6, 1e-3, 0.004, 0.3}) {
          J2State state;
          for (int k = 0; k < steps; ++k) state = step(of, state, increment(size / steps * way));
          const Vector deviator = size * (way - way.mean() * Vector::Ones());
          const double equivalent = std::sqrt(2.0 / 3) * deviator.norm();
          const double flow = std::max(0.0, (3 * of.shear * equivalent - of.yield) / (3 * of.shear + of.hardening));
          const double q = 3 * of.shear * (equivalent - flow);
          EXPECT_NEAR(state.plastic, flow, 1e-13 * equivalent);
          EXPECT_NEAR(von_mises(kirchhoff_stress(of, state.elastic)), q, 1e-12 * q);
          EXPECT_NEAR(state.elastic.trace(), size * way.sum(), 1e-13 * size);
          if (flow > 0) {
            EXPECT_NEAR(q, of.yield + of.hardening * flow, 1e-12 * q);
            EXPECT_LE(q, (of.yield + of.hardening * flow) * (1 + 1e-14));
          }
        }
      }
    }
  }
}

// A strain rate that stands at an angle psi to the stress on the surface of perfect plasticity turns it:
// tan(psi/2) falls as exp(-2 G e/R), e the length of the strain's deviator, R = sqrt(2/3) Y (Krieg, Krieg 1977,
// doi 10.1115/1.3454568). The return is of first order in the step: what doubling the steps leaves is of second. [J2 4]
TEST(RadialReturn, StressTurnsAsKriegSays) {
  const double radius = std::sqrt(2.0 / 3) * perfect.yield;
  const Vector first = Vector(2, -1, -1).normalized(), second = Vector(0, 1, -1).normalized();
  for (const double psi : {0.4, 1.2, 1.5}) {
    for (const double length : {0.3, 1.5}) {  // 2 G e/R
      const Vector way = std::cos(psi) * first + std::sin(psi) * second;
      const double e = length * radius / (2 * perfect.shear);
      const auto cosine = [&](int steps) {
        J2State state{diagonal(radius / (2 * perfect.shear) * first), 0};
        for (int k = 0; k < steps; ++k) state = step(perfect, state, increment(e / steps * way));
        return kirchhoff_stress(perfect, state.elastic).diagonal().dot(way) / radius;
      };
      const double exact = std::cos(2 * std::atan(std::tan(psi / 2) * std::exp(-length)));
      const double coarse = cosine(200) - exact, fine = cosine(400) - exact;
      EXPECT_NEAR(coarse / fine, 2, 0.02) << psi << ' ' << length;
      EXPECT_NEAR(2 * fine - coarse, 0, 2e-5) << psi << ' ' << length;
    }
  }
}

// Backwards it is elastic until q has fallen to zero and risen to the same yield stress again. [J2 2, 4]
TEST(RadialReturn, UnloadingIsElastic) {
  const Vector way(1, -0.5, -0.5);
  const J2State loaded = step(law, {}, increment(0.02 * way));
  ASSERT_GT(loaded.plastic, 0.01);
  const double range = 2 * yield_stress(law, loaded.plastic) / (3 * law.shear);
  const J2State back = step(law, loaded, increment(-0.999 * range * way));
  EXPECT_EQ(back.plastic, loaded.plastic);
  EXPECT_LE((back.elastic - loaded.elastic + 0.999 * range * diagonal(way)).norm(), 1e-15);
  EXPECT_GT(step(law, loaded, increment(-1.001 * range * way)).plastic, loaded.plastic);
}

// Random walks at finite strains: yield is never violated by more than 1e-12 of it, plastic strain only grows, plastic flow
// keeps the volume, and seen from a turned frame all is turned. [J2 2, 4]
TEST(RadialReturn, WalksStayOnTheSurfaceAndTurnWithTheFrame) {
  const Matrix turn = Eigen::AngleAxisd(0.9, Vector(1, 2, -2) / 3).toRotationMatrix();
  for (const J2Law& of : {law, perfect}) {
    scenes::Random random(4);
    J2State state, turned;
    double volume = 0;
    for (int k = 0; k < 300; ++k) {
      const Matrix by = any(random, k % 3 == 0 ? 0.05 : 1e-3);
      const J2State next = step(of, state, by);
      EXPECT_LE(von_mises(kirchhoff_stress(of, next.elastic)) - of.yield - of.hardening * next.plastic,
                1e-12 * of.yield);
      EXPECT_GE(next.plastic, state.plastic);
      volume += std::log((Matrix::Identity() + by).determinant());
      EXPECT_NEAR(next.elastic.trace(), volume, 1e-12);
      turned = step(of, turned, turn * by * turn.transpose());
      EXPECT_LE((turned.elastic - turn * next.elastic * turn.transpose()).norm(), 1e-12);
      EXPECT_NEAR(turned.plastic, next.plastic, 1e-12);
      state = next;
    }
    EXPECT_GT(state.plastic, 1);
    const J2State rotated = step(of, state, turn - Matrix::Identity());  // a rotation alone
    EXPECT_LE((rotated.elastic - turn * state.elastic * turn.transpose()).norm(), 1e-14);
    EXPECT_NEAR(rotated.plastic, state.plastic, 1e-15 + 1e-14 * state.plastic);
  }
}

// Rates are those of small steps, in the elastic range, on the surface and back from it; also where principal strains meet.
// [J2 3, 4]
TEST(RadialReturn, RatesAreThoseOfSmallSteps) {
  scenes::Random random(5);
  int flows = 0, springs = 0;
  for (int k = 0; k < 60; ++k) {
    J2State state;
    if (k >= 10) state = step(law, state, any(random, k < 20 ? 1e-3 : 0.1));
    const Matrix gradient = any(random, 1);
    const J2State rate = rate_of(law, state, gradient);
    const double dt = 1e-7;
    const J2State half = step(law, state, dt / 2 * gradient), full = step(law, state, dt * gradient);
    const Matrix elastic = (4 * half.elastic - 3 * state.elastic - full.elastic) / dt;
    EXPECT_LE((rate.elastic - elastic).norm(), 1e-8) << k;
    EXPECT_NEAR(rate.plastic, (4 * half.plastic - 3 * state.plastic - full.plastic) / dt, 1e-8) << k;
    flows += rate.plastic > 0;
    springs += state.plastic > 0 && rate.plastic == 0;
  }
  EXPECT_GT(flows, 10);
  EXPECT_GT(springs, 10);
}

}  // namespace
}  // namespace plumbline::radial_return_test
