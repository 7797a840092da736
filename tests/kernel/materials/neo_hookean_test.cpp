#include "kernel/materials/neo_hookean.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::neo_hookean_test {
namespace {

using scenes::Space;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

constexpr double e = 5, nu = 0.3, rho = 2, mass = 0.8;
constexpr double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));

NeoHookean law() {
  NeoHookean material;
  material.youngs_modulus = e;
  material.poissons_ratio = nu;
  material.density = rho;
  return material;
}
MaterialContext in(Space space, double ahead = 0) { return {scenes::dim_of(space), 0.1, false, ahead, false}; }

Columns points_of(Space space, int count = 1) {
  Body body = make_body("solid", std::make_shared<NeoHookean>(law()), count, scenes::dim_of(space),
                        space == Space::axisymmetric);
  std::fill_n(body.points(column::mass), count, mass);
  std::fill_n(body.points(column::volume), count, mass / rho);
  return std::move(body.points);
}

// A tensor in three directions, of which a column holds what the geometry has: the plane, then the hoop's.
struct Tensor {
  Space space;
  int dim() const { return scenes::dim_of(space); }
  bool rings() const { return space == Space::axisymmetric; }
  Matrix read(const Columns& points, const ColumnId& id, int p, double elsewhere) const {
    Matrix m = elsewhere * Matrix::Identity();
    for (int i = 0; i < dim(); ++i) {
      for (int j = 0; j < dim(); ++j) m(i, j) = points(id, i * dim() + j)[p];
    }
    if (rings()) m(2, 2) = points(id, 4)[p];
    return m;
  }
  void write(Columns& points, const ColumnId& id, int p, const Matrix& m) const {
    for (int i = 0; i < dim(); ++i) {
      for (int j = 0; j < dim(); ++j) points(id, i * dim() + j)[p] = m(i, j);
    }
    if (rings()) points(id, 4)[p] = m(2, 2);
  }
  // What of a tensor the geometry can have.
  Matrix of(Matrix m, double elsewhere) const {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (i >= dim() || j >= dim()) m(i, j) = i == j ? (rings() ? m(i, j) : elsewhere) : 0;
      }
    }
    return m;
  }
};

Matrix some_deformation() {
  Matrix f;
  f << 1.2, 0.3, -0.1, -0.2, 0.9, 0.15, 0.05, -0.25, 1.1;
  return f;
}
Matrix some_rate() {
  Matrix l;
  l << 0.5, -0.3, 0.2, 0.8, -0.7, -0.4, 0.1, 0.6, 0.3;
  return l;
}

// W in three directions, of which those without strain add nothing. [Neo-Hookean 1]
double energy(const Matrix& f) {
  const double log_j = std::log(f.determinant());
  return mu / 2 * ((f.transpose() * f).trace() - 3 - 2 * log_j) + lambda / 2 * log_j * log_j;
}

// dW/dF by central differences: d^2/6 of a third derivative below 1e2, 1e-16/d.
Matrix slope(const Matrix& f) {
  const double d = 1e-5;
  Matrix p;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Matrix high = f, low = f;
      high(i, j) += d;
      low(i, j) -= d;
      p(i, j) = (energy(high) - energy(low)) / (2 * d);
    }
  }
  return p;
}
constexpr double of_differences = 1e-8;

class Finite : public testing::TestWithParam<Space> {
 protected:
  const Tensor tensor{GetParam()};
  const NeoHookean material = law();
};
INSTANTIATE_TEST_SUITE_P(Spaces, Finite, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

TEST_P(Finite, StartsUndeformedAndWithoutStress) {
  Columns points = points_of(GetParam(), 3);
  EXPECT_EQ(tensor.read(points, column::deformation, 2, 1), Matrix::Identity());
  material.evaluate_stress(points, all_points(points), in(GetParam()));
  EXPECT_EQ(tensor.read(points, column::stress, 2, 0), Matrix::Zero());
  EXPECT_EQ(material.stored_energy(points, all_points(points)), 0);
}

// The stress column is J^-1 P F^T with P = dW/dF, and symmetric; the volume is J m / rho_0. [Neo-Hookean 1]
TEST_P(Finite, StressIsTheSlopeOfTheEnergy) {
  Columns points = points_of(GetParam());
  const Matrix f = tensor.of(some_deformation(), 1);
  tensor.write(points, column::deformation, 0, f);
  material.evaluate_stress(points, all_points(points), in(GetParam()));
  const Matrix sigma = tensor.read(points, column::stress, 0, 0),
               expected = tensor.of(slope(f) * f.transpose() / f.determinant(), 0);
  EXPECT_LE((sigma - expected).cwiseAbs().maxCoeff(), of_differences);
  EXPECT_LE((sigma - sigma.transpose()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_GT(sigma.cwiseAbs().maxCoeff(), 0.5);
  EXPECT_NEAR(points(column::volume)[0], f.determinant() * mass / rho, 1e-15);
  EXPECT_NEAR(material.stored_energy(points, all_points(points)), mass / rho * energy(f), 1e-15);
}

// `ahead`: P of the deformation that the velocity gradient leads to, over the deformation and volume as they are; no longer
// symmetric. [Neo-Hookean 1, 2]
TEST_P(Finite, PredictsItsStress) {
  Columns points = points_of(GetParam());
  const double ahead = 0.05;
  const Matrix f = tensor.of(some_deformation(), 1), l = tensor.of(some_rate(), 0);
  tensor.write(points, column::deformation, 0, f);
  tensor.write(points, column::strain_rate, 0, l);
  material.evaluate_stress(points, all_points(points), in(GetParam(), ahead));
  const Matrix sigma = tensor.read(points, column::stress, 0, 0), then = tensor.of(Matrix(f + ahead * l * f), 1),
               expected = tensor.of(slope(then) * f.transpose() / f.determinant(), 0);
  EXPECT_LE((sigma - expected).cwiseAbs().maxCoeff(), of_differences);
  EXPECT_EQ(tensor.read(points, column::deformation, 0, 1), f);
  EXPECT_NEAR(points(column::volume)[0], f.determinant() * mass / rho, 1e-15);
  if (tensor.dim() > 1) {
    EXPECT_GT((sigma - sigma.transpose()).cwiseAbs().maxCoeff(), 1e-3);
  }
}

// V sigma : L is the rate of V_0 W, whatever the velocity gradient: spins, that change no energy, included. [Neo-Hookean 1, 2]
TEST_P(Finite, PowerIsTheRateOfTheEnergy) {
  Columns points = points_of(GetParam());
  const Matrix f = tensor.of(some_deformation(), 1), l = tensor.of(some_rate(), 0);
  tensor.write(points, column::deformation, 0, f);
  tensor.write(points, column::strain_rate, 0, l);
  material.evaluate_stress(points, all_points(points), in(GetParam()));
  double power = 0;
  for (int k = 0; k < points.components(column::stress); ++k) {
    power += points(column::volume)[0] * points(column::stress, k)[0] * points(column::strain_rate, k)[0];
  }
  const double dt = 1e-5;
  const Matrix now = f + dt * l * f, before = f - dt * l * f;
  EXPECT_NEAR(power, mass / rho * (energy(now) - energy(before)) / (2 * dt), of_differences);
}

// F <- (1 + dt grad v) F, the hoop's stretch alike; what is stored meanwhile is returned; no other point changes.
// [Neo-Hookean 2]
TEST_P(Finite, DeformationFollowsTheVelocityGradient) {
  Columns points = points_of(GetParam(), 5);
  const Matrix f = tensor.of(some_deformation(), 1), l = tensor.of(some_rate(), 0);
  for (int p = 0; p < 5; ++p) {
    tensor.write(points, column::deformation, p, f);
    tensor.write(points, column::strain_rate, p, l);
  }
  const double dt = 0.1;
  const auto rates = material.rates(points, in(GetParam()));
  const double stored = material.advance(points, {1, 4}, in(GetParam()), dt);
  const Matrix now = tensor.of(Matrix(f + dt * l * f), 1);
  for (int p = 0; p < 5; ++p) {
    const Matrix expected = p > 0 && p < 4 ? now : f;
    EXPECT_LE((tensor.read(points, column::deformation, p, 1) - expected).cwiseAbs().maxCoeff(), 1e-15) << p;
  }
  EXPECT_NEAR(stored, 3 * mass / rho * (energy(now) - energy(f)), 1e-14);
  ASSERT_EQ(material.internal_variables(in(GetParam())), (std::vector<const ColumnId*>{&column::deformation}));
  ASSERT_EQ(rates.size(), static_cast<std::size_t>(5 * points.components(column::deformation)));
  for (int k = 0; k < points.components(column::deformation); ++k) {
    const int i = tensor.rings() && k == 4 ? 2 : k / tensor.dim(), j = tensor.rings() && k == 4 ? 2 : k % tensor.dim();
    EXPECT_NEAR(rates[static_cast<std::size_t>(5 * k + 3)], (l * f)(i, j), 1e-15);
  }
}

// A turned body has no stress, a turned and strained one the turned stress. [Neo-Hookean 1]
TEST_P(Finite, StressTurnsWithTheBody) {
  if (tensor.dim() == 1 || tensor.rings()) return;
  const Vector axis = tensor.dim() == 2 ? Vector(0, 0, 1) : Vector(1, 2, -2) / 3;
  const Matrix turn = Eigen::AngleAxisd(0.7, axis).toRotationMatrix(), f = tensor.of(some_deformation(), 1);
  Columns points = points_of(GetParam(), 3);
  tensor.write(points, column::deformation, 0, turn);
  tensor.write(points, column::deformation, 1, f);
  tensor.write(points, column::deformation, 2, turn * f);
  material.evaluate_stress(points, all_points(points), in(GetParam()));
  EXPECT_LE(tensor.read(points, column::stress, 0, 0).cwiseAbs().maxCoeff(), 1e-14);
  const Matrix still = tensor.read(points, column::stress, 1, 0), turned = tensor.read(points, column::stress, 2, 0);
  EXPECT_LE((turned - turn * still * turn.transpose()).cwiseAbs().maxCoeff(), 1e-14);
}

// Small strains: Hooke's law with the same constants. The law's second-order terms are below ten times the strain
// squared. [Neo-Hookean 1] [Hooke 1]
TEST_P(Finite, SmallStrainsFollowHooke) {
  Columns points = points_of(GetParam());
  const double small = 1e-6;
  const Matrix g = tensor.of(some_rate(), 0), eps = small * (g + g.transpose()) / 2;
  tensor.write(points, column::deformation, 0, tensor.of(Matrix(Matrix::Identity() + small * g), 1));
  material.evaluate_stress(points, all_points(points), in(GetParam()));
  const Matrix hooke = tensor.of(lambda * eps.trace() * Matrix::Identity() + 2 * mu * eps, 0);
  EXPECT_LE((tensor.read(points, column::stress, 0, 0) - hooke).cwiseAbs().maxCoeff(), 100 * small * small);
}

// Waves along n with wave number 1 in the body as it stands: rho_0 c^2 is an eigenvalue of the acoustic tensor
// Q_ik = (F^T n)_J (F^T n)_L d^2 W / dF_iJ dF_kL, taken here by differences of P. No wave is faster than the bound, and in the
// undeformed body the bound is the speed of compression. [Neo-Hookean 1]
double fastest_of_the_acoustic_tensor(const Tensor& tensor, const Matrix& f) {
  const double d = 1e-6;
  double fastest = 0;
  for (int k = 0; k < 300; ++k) {
    const double z = tensor.dim() < 3 ? 0 : 2 * ((k * 0.618) - std::floor(k * 0.618)) - 1, angle = 2.4 * k;
    Vector n(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    if (tensor.dim() == 1) n = Vector(1, 0, 0);
    const Vector wave = f.transpose() * n;
    Matrix q;
    for (int along = 0; along < 3; ++along) {
      Vector u = Vector::Zero();
      u[along] = 1;
      const auto pull = [&](double by) {
        const Matrix moved = f + by * u * wave.transpose(), inverse = moved.inverse().transpose();
        return Vector((mu * (moved - inverse) + lambda * std::log(moved.determinant()) * inverse) * wave);
      };
      q.col(along) = (pull(d) - pull(-d)) / (2 * d);
    }
    const Matrix in_space = q.topLeftCorner(3, 3);
    const int dim = tensor.dim();
    const Eigen::MatrixXd own = in_space.topLeftCorner(dim, dim);
    const double square = dense::symmetric_spectrum(own).values.maxCoeff();
    fastest = std::max(fastest, std::sqrt(square / rho));
  }
  return fastest;
}

TEST_P(Finite, NoWaveIsFasterThanTheBound) {
  Columns points = points_of(GetParam());
  const auto bound = [&](const Matrix& f) {
    tensor.write(points, column::deformation, 0, f);
    return material.step_bounds(points, all_points(points), tensor.dim()).fastest;
  };
  EXPECT_NEAR(bound(Matrix::Identity()), std::sqrt((lambda + 2 * mu) / rho), 1e-15);
  scenes::Random random(11);
  for (int k = 0; k < 50; ++k) {
    Matrix f = Matrix::Identity();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) f(i, j) += random(-0.35, 0.35);
    }
    f = tensor.of(f, 1);
    if (f.determinant() < 0.2) continue;
    const double fastest = fastest_of_the_acoustic_tensor(tensor, f);
    EXPECT_LE(fastest, bound(f) * (1 + 1e-8)) << f;
    // Row sums of F F^T are at most sqrt(3) times its largest eigenvalue; of rings the hoop, along which no wave runs, counts.
    if (!tensor.rings() && std::log(f.determinant()) < 1) {
      EXPECT_LE(bound(f), std::sqrt(std::sqrt(3.0)) * 1.01 * fastest) << f;
    }
  }
  points(column::velocity)[0] = 3;
  EXPECT_NEAR(bound(Matrix::Identity()), std::sqrt((lambda + 2 * mu) / rho) + 3, 1e-14);
}

// det F <= 0, or not a number, is inadmissible.
TEST_P(Finite, SaysWhatIsWrong) {
  Columns points = points_of(GetParam(), 4);
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, -1);
  points(column::deformation)[2] = -0.5;
  const Material::Fault fault = material.first_fault(points, all_points(points));
  EXPECT_EQ(fault.point, 2);
  EXPECT_EQ(fault.field, "deformation");
  EXPECT_EQ(fault.value, -0.5);
  EXPECT_EQ(material.first_fault(points, {0, 2}).point, -1);
  points(column::deformation)[2] = 0;
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, 2);
  points(column::deformation)[2] = 1;
  points(column::deformation, points.components(column::deformation) - 1)[1] = std::nan("");
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, 1);
}

// --- packs of points, against the law point by point ----------------------------------------------------------------

// Points that all differ, as many as fill no whole number of packs.
constexpr int some_points = 2 * 8 + 3;

struct Varied {
  Columns points;
  std::vector<Matrix> f, rate;
};
Varied varied(const Tensor& tensor) {
  Varied v{points_of(tensor.space, some_points), {}, {}};
  scenes::Random random(3);
  for (int p = 0; p < some_points; ++p) {
    Matrix f = Matrix::Identity(), l;
    for (int k = 0; k < 9; ++k) {
      f(k / 3, k % 3) += random(-0.2, 0.2);
      l(k / 3, k % 3) = random(-1, 1);
    }
    v.f.push_back(tensor.of(f, 1));
    v.rate.push_back(tensor.of(l, 0));
    tensor.write(v.points, column::deformation, p, v.f.back());
    tensor.write(v.points, column::strain_rate, p, v.rate.back());
    v.points(column::mass)[p] = random(0.5, 1.5);
    for (int d = 0; d < tensor.dim(); ++d) v.points(column::velocity, d)[p] = random(-1, 1);
  }
  return v;
}
// P by Eigen's inverse.
Matrix stress_of(const Matrix& f) {
  const Matrix inverse = f.inverse().transpose();
  return mu * (f - inverse) + lambda * std::log(f.determinant()) * inverse;
}
double wave_speed(const Tensor& tensor, const Matrix& f) {
  const int dim = tensor.dim();
  const Eigen::MatrixXd left = (f * f.transpose()).topLeftCorner(dim, dim);
  const double rows = left.cwiseAbs().rowwise().sum().maxCoeff(),
               square = tensor.rings() ? std::max(rows, f(2, 2) * f(2, 2)) : rows;
  return std::sqrt((mu * (square + 1) + lambda * std::max(0.0, 1 - std::log(f.determinant()))) / rho);
}
const std::vector<PointRange> ranges{{0, some_points}, {0, 1}, {3, 4}, {1, 8}, {5, 5}, {2, some_points - 1}};

TEST_P(Finite, EveryPointOfARangeFollowsTheLaw) {
  const double dt = 0.1, rounding = 4e-15;
  for (const PointRange range : ranges) {
    for (const double ahead : {0.0, 0.05}) {
      Varied v = varied(tensor);
      const Columns before = v.points;
      material.evaluate_stress(v.points, range, in(GetParam(), ahead));
      double stored = 0, gained = 0, fastest = 0, fastest_point = 0;
      for (int p = 0; p < some_points; ++p) {
        const Matrix f = v.f[static_cast<std::size_t>(p)], l = v.rate[static_cast<std::size_t>(p)];
        const bool mine = p >= range.first && p < range.last;
        const Matrix then = tensor.of(Matrix(f + ahead * l * f), 1), now = tensor.of(Matrix(f + dt * l * f), 1),
                     sigma = tensor.of(stress_of(then) * f.transpose() / f.determinant(), 0),
                     expected = mine ? sigma : Matrix(Matrix::Zero());
        const double own = v.points(column::mass)[p], volume = before(column::volume)[p];
        EXPECT_LE((tensor.read(v.points, column::stress, p, 0) - expected).cwiseAbs().maxCoeff(), rounding) << p;
        EXPECT_NEAR(v.points(column::volume)[p], mine ? own / rho * f.determinant() : volume, rounding) << p;
        if (!mine) continue;
        stored += own / rho * energy(f);
        gained += own / rho * (energy(now) - energy(f));
        fastest = std::max(fastest, wave_speed(tensor, f));
        double square = 0;
        for (int d = 0; d < tensor.dim(); ++d) square += std::pow(v.points(column::velocity, d)[p], 2);
        fastest_point = std::max(fastest_point, std::sqrt(square));
      }
      EXPECT_NEAR(material.stored_energy(v.points, range), stored, rounding * (1 + stored));
      EXPECT_NEAR(material.step_bounds(v.points, range, tensor.dim()).fastest, fastest + fastest_point, rounding);
      EXPECT_EQ(material.first_fault(v.points, range).point, -1);
      EXPECT_NEAR(material.advance(v.points, range, in(GetParam()), dt), gained, rounding * (1 + std::abs(gained)));
      for (int p = 0; p < some_points; ++p) {
        const Matrix f = v.f[static_cast<std::size_t>(p)], l = v.rate[static_cast<std::size_t>(p)];
        const bool mine = p >= range.first && p < range.last;
        const Matrix expected = mine ? tensor.of(Matrix(f + dt * l * f), 1) : f;
        EXPECT_LE((tensor.read(v.points, column::deformation, p, 1) - expected).cwiseAbs().maxCoeff(),
                  mine ? rounding : 0)
            << p;
      }
    }
  }
}

// What is inadmissible is the first such point of the range, in whatever lane; what is not finite reaches the bound of the waves.
TEST_P(Finite, OneBadPointIsSeenInAnyLane) {
  const int last = Columns(some_points).points() - 1,
            components = stress_components(StressMeasure::full, tensor.dim(), tensor.rings());
  for (int bad = 0; bad <= last; ++bad) {
    for (const double j : {-0.3, 0.0, std::nan(""), HUGE_VAL}) {
      Columns points = points_of(GetParam(), some_points);
      points(column::deformation, components - 1)[bad] = j;
      if (bad < last) points(column::deformation)[last] = -2;
      const Material::Fault fault = material.first_fault(points, all_points(points));
      EXPECT_EQ(fault.point, bad) << j;
      EXPECT_EQ(material.first_fault(points, {0, bad}).point, -1) << j;
      EXPECT_EQ(material.first_fault(points, {bad + 1, some_points}).point, bad < last ? last : -1) << j;
      const double bound = material.step_bounds(points, {0, last}, tensor.dim()).fastest;
      if (bad < last && !(std::abs(j) > 0 && std::abs(j) < HUGE_VAL)) {
        EXPECT_FALSE(bound < HUGE_VAL) << bad << ' ' << j;
      } else {
        EXPECT_NEAR(bound, std::sqrt((lambda + 2 * mu) / rho), 1e-15) << bad;
      }
    }
  }
}

TEST(NeoHookean, IsAnElasticMaterialOfFullStress) {
  EXPECT_EQ(law().measure(), StressMeasure::full);
  EXPECT_EQ(law().store(), Store::elastic);
  EXPECT_EQ(stress_components(StressMeasure::full, 1, false), 1);
  EXPECT_EQ(stress_components(StressMeasure::full, 2, false), 4);
  EXPECT_EQ(stress_components(StressMeasure::full, 2, true), 5);
  EXPECT_EQ(stress_components(StressMeasure::full, 3, false), 9);
}

}  // namespace
}  // namespace plumbline::neo_hookean_test
