#include "kernel/materials/segment_membrane.hpp"

#include <Eigen/Geometry>

#include "tests/kernel/scenes.hpp"

namespace plumbline::segment_membrane_test {
namespace {

constexpr double rounding = 4e-14;  // a handful of operations on tensions of order ten

SegmentMembrane law(bool one_way = true, bool closed = false) {
  SegmentMembrane material;
  material.youngs_modulus = 100;
  material.density = 4;
  material.section = 0.2;
  material.one_way = one_way;
  material.closed = closed;
  return material;
}

// A crooked chain whose segments are partly taut and partly slack: rest lengths are `rest` times what they are, by turns.
Columns chain(const SegmentMembrane& material, int dim, int count = 6,
              std::vector<double> rest = {0.95, 1.1, 0.9, 1.02}) {
  Body body = make_body("net", std::make_shared<SegmentMembrane>(material), count, dim);
  Columns& points = body.points;
  for (int p = 0; p < count; ++p) {
    const double x[3] = {0.3 * p + 0.04 * std::sin(3.0 * p), 0.2 * std::cos(1.3 * p), 0.1 * std::sin(2.1 * p)};
    for (int d = 0; d < dim; ++d) points(column::position, d)[p] = x[d];
    points(column::volume)[p] = 0.05 + 0.01 * p;
    points(column::mass)[p] = material.density * points(column::volume)[p];
  }
  for (int p = 0; p < count; ++p) {
    double square = 0;
    for (int d = 0; d < dim; ++d) {
      square += std::pow(points(column::position, d)[(p + 1) % count] - points(column::position, d)[p], 2);
    }
    points(column::rest_length)[p] = std::sqrt(square) * rest[static_cast<std::size_t>(p) % rest.size()];
  }
  return std::move(body.points);
}
MaterialContext in(int dim, double ahead = 0) { return {dim, 0.1, false, ahead, false}; }

// The energy of the chain as it stands, by the printed formula: sum A L E eps^2 / 2 over taut segments. [Segments 1]
double energy(const SegmentMembrane& material, const Columns& points) {
  const int n = points.points(), dim = points.components(column::position);
  double sum = 0;
  for (int p = 0; p < (material.closed ? n : n - 1); ++p) {
    double square = 0;
    for (int d = 0; d < dim; ++d) {
      square += std::pow(points(column::position, d)[(p + 1) % n] - points(column::position, d)[p], 2);
    }
    const double rest = points(column::rest_length)[p], eps = std::sqrt(square) / rest - 1;
    if (eps > 0 || !material.one_way) sum += 0.5 * material.section * rest * material.youngs_modulus * eps * eps;
  }
  return sum;
}

template <class Check>
void for_all_chains(Check&& check) {
  for (int dim : {1, 2, 3}) {
    for (bool one_way : {true, false}) {
      for (bool closed : {false, true}) {
        SCOPED_TRACE(testing::Message() << dim << "-D, one way " << one_way << ", closed " << closed);
        check(law(one_way, closed), dim);
      }
    }
  }
}

// -V_p times the stress column is F_p = -dW/dx_p. Central differences of a smooth function: d^2/6 of its third derivative,
// below 1e3, and 1e-16 over d. [Segments 2]
TEST(SegmentMembrane, ForceIsTheSlopeOfTheEnergy) {
  for_all_chains([](const SegmentMembrane& material, int dim) {
    Columns points = chain(material, dim);
    material.evaluate_stress(points, all_points(points), in(dim));
    const double d = 1e-6;
    for (int p = 0; p < points.points(); ++p) {
      for (int k = 0; k < dim; ++k) {
        Columns low = points, high = points;
        low(column::position, k)[p] -= d;
        high(column::position, k)[p] += d;
        const double force = -points(column::volume)[p] * points(column::stress, k)[p];
        EXPECT_NEAR(force, -(energy(material, high) - energy(material, low)) / (2 * d), 1e-8) << p << ' ' << k;
      }
    }
  });
}

// Each segment pulls both its ends alike: no force on the chain as a whole, and no moment. [Segments 2]
TEST(SegmentMembrane, ForcesAndMomentsAddUpToNothing) {
  for_all_chains([](const SegmentMembrane& material, int dim) {
    Columns points = chain(material, dim);
    material.evaluate_stress(points, all_points(points), in(dim));
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
    double largest = 0;
    for (int p = 0; p < points.points(); ++p) {
      Eigen::Vector3d x = Eigen::Vector3d::Zero(), f = x;
      for (int d = 0; d < dim; ++d) {
        x[d] = points(column::position, d)[p];
        f[d] = -points(column::volume)[p] * points(column::stress, d)[p];
      }
      force += f;
      moment += x.cross(f);
      largest = std::max(largest, f.norm());
    }
    EXPECT_LE(force.norm(), rounding);
    EXPECT_LE(moment.norm(), rounding);
    EXPECT_GT(largest, 1);
  });
}

// Strain is what the segments' stretch is, whatever it was and however long the step; the last point of an open chain has
// none. What is stored, and what advance() returns, is the printed energy. [Segments 1]
TEST(SegmentMembrane, StrainIsTheStretchOfSegments) {
  for_all_chains([](const SegmentMembrane& material, int dim) {
    Columns points = chain(material, dim);
    const int n = points.points();
    const double stretch[] = {1 / 0.95 - 1, 1 / 1.1 - 1, 1 / 0.9 - 1, 1 / 1.02 - 1};
    const double stored = material.advance(points, all_points(points), in(dim), 0.3);
    for (int p = 0; p + 1 < n; ++p) EXPECT_NEAR(points(column::strain)[p], stretch[p % 4], 1e-15) << p;
    EXPECT_NEAR(points(column::strain)[n - 1], material.closed ? stretch[(n - 1) % 4] : 0, 1e-15);
    EXPECT_NEAR(stored, energy(material, points), rounding);
    EXPECT_NEAR(material.stored_energy(points, all_points(points)), energy(material, points), rounding);
    for (int d = 0; d < dim; ++d) points(column::position, d)[2] += 0.01 * (d + 1);
    const double before = material.stored_energy(points, all_points(points));
    const double more = material.advance(points, all_points(points), in(dim), 0.1);
    EXPECT_NEAR(before + more, energy(material, points), rounding);
    EXPECT_NEAR(material.advance(points, all_points(points), in(dim), 0.1), 0, 1e-16);
  });
}

// A chain that starts stretched has its energy from the start.
TEST(SegmentMembrane, StartsWithTheEnergyOfItsStretch) {
  const SegmentMembrane material = law();
  Columns points = chain(material, 2);
  EXPECT_EQ(material.stored_energy(points, all_points(points)), 0);
  material.describe(points);
  EXPECT_NEAR(material.stored_energy(points, all_points(points)), energy(material, points), rounding);
  EXPECT_NEAR(material.advance(points, all_points(points), in(2), 0.1), 0, 1e-16);
}

// No tension while shorter than at rest; with the two-way law the segment pushes. [Segments 1]
TEST(SegmentMembrane, SlackSegmentsDoNotPush) {
  EXPECT_EQ(law().tension(-0.1), 0);
  EXPECT_NEAR(law().tension(0.1), 2, rounding);
  EXPECT_NEAR(law(false).tension(-0.1), -2, rounding);
  for (bool one_way : {true, false}) {
    const SegmentMembrane material = law(one_way);
    Columns points = chain(material, 2, 2, {1.25});
    material.evaluate_stress(points, all_points(points), in(2));
    double along = 0;
    for (int d = 0; d < 2; ++d) {
      along += points(column::stress, d)[0] * (points(column::position, d)[1] - points(column::position, d)[0]);
    }
    if (one_way) {
      EXPECT_EQ(along, 0);
    } else {
      EXPECT_GT(along, 0);  // -F/V: the force on the first point is away from the second
    }
  }
}

// `ahead`: the force where points will be if they keep the velocities that the grid has for them. [Segments 2]
TEST(SegmentMembrane, PredictsItsForces) {
  for_all_chains([](const SegmentMembrane& material, int dim) {
    Columns points = chain(material, dim);
    for (int p = 0; p < points.points(); ++p) {
      for (int d = 0; d < dim; ++d) points(column::strain_rate, d)[p] = std::sin(2.0 * p + d);
    }
    Columns later = points;
    for (int p = 0; p < points.points(); ++p) {
      for (int d = 0; d < dim; ++d) later(column::position, d)[p] += 0.02 * points(column::strain_rate, d)[p];
    }
    material.evaluate_stress(points, all_points(points), in(dim, 0.02));
    material.evaluate_stress(later, all_points(later), in(dim));
    for (int p = 0; p < points.points(); ++p) {
      for (int d = 0; d < dim; ++d) {
        EXPECT_NEAR(points(column::stress, d)[p], later(column::stress, d)[p], 100 * rounding);
      }
    }
  });
}

// The rates of the strains, for those who advance states: differences as above. [Segments 1]
TEST(SegmentMembrane, RatesOfItsStrains) {
  for_all_chains([](const SegmentMembrane& material, int dim) {
    Columns points = chain(material, dim);
    for (int p = 0; p < points.points(); ++p) {
      for (int d = 0; d < dim; ++d) points(column::strain_rate, d)[p] = std::sin(2.0 * p + d);
    }
    const double dt = 1e-6;
    const auto strains = [&](double by) {
      Columns moved = points;
      for (int p = 0; p < points.points(); ++p) {
        for (int d = 0; d < dim; ++d) moved(column::position, d)[p] += by * points(column::strain_rate, d)[p];
      }
      material.describe(moved);
      return std::vector<double>(moved(column::strain), moved(column::strain) + moved.points());
    };
    const auto low = strains(-dt), high = strains(dt), rates = material.rates(points, in(dim));
    ASSERT_EQ(rates.size(), low.size());
    for (std::size_t p = 0; p < rates.size(); ++p) EXPECT_NEAR(rates[p], (high[p] - low[p]) / (2 * dt), 1e-8);
    EXPECT_EQ(material.internal_variables(in(dim)), (std::vector<const ColumnId*>{&column::strain}));
  });
}

TEST(SegmentMembrane, RangesLeaveOthersAlone) {
  const SegmentMembrane material = law(true, true);
  const Columns start = chain(material, 2, 11);
  Columns part = start, whole = start;
  const PointRange range{3, 8};
  const double stored = material.advance(part, range, in(2), 0.1);
  material.evaluate_stress(part, range, in(2));
  material.advance(whole, all_points(whole), in(2), 0.1);
  material.evaluate_stress(whole, all_points(whole), in(2));
  for (const ColumnId* id : {&column::strain, &column::stress}) {
    for (int k = 0; k < part.components(*id); ++k) {
      for (int p = 0; p < 11; ++p) EXPECT_EQ(part(*id, k)[p], (p >= 3 && p < 8 ? whole : start)(*id, k)[p]);
    }
  }
  EXPECT_NEAR(stored, material.stored_energy(whole, range), rounding);
}

TEST(SegmentMembrane, WaveSpeedAndFaults) {
  const SegmentMembrane material = law();
  Columns points = chain(material, 2);
  points(column::velocity, 1)[4] = -2;
  EXPECT_NEAR(material.step_bounds(points, all_points(points), 2).fastest, 5 + 2, 1e-14);
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, -1);
  points(column::rest_length)[5] = 0;  // the last of an open chain has no segment
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, -1);
  points(column::rest_length)[3] = 0;
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, 3);
  EXPECT_EQ(material.first_fault(points, all_points(points)).field, "rest_length");
  points(column::strain)[1] = std::nan("");
  EXPECT_EQ(material.first_fault(points, all_points(points)).point, 1);
  EXPECT_EQ(material.first_fault(points, all_points(points)).field, "strain");
}

TEST(SegmentMembrane, IsAChainOfPointForces) {
  EXPECT_EQ(law().measure(), StressMeasure::point_force);
  EXPECT_EQ(law().store(), Store::elastic);
  EXPECT_TRUE(law().chain());
}

}  // namespace
}  // namespace plumbline::segment_membrane_test
