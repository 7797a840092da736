#include "kernel/materials/ideal_gas.hpp"

#include "kernel/pack.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline::ideal_gas_test {
namespace {

// A few operations on numbers of order one.
constexpr double rounding = 4e-15;

// One point of gas: rho 2, e 3, m 1, so V = 0.5 and p = 0.4 x 2 x 3 = 2.4. One strain rate is the divergence, or that of a
// line; more are components.
Columns one_point(const std::vector<double>& rate, double energy = 3, int points = 1) {
  const bool rings = rate.size() == 4;
  const int dim = rate.size() == 6 ? 3 : rate.size() == 1 ? 1 : 2;
  const Body body = make_body("gas", std::make_shared<IdealGas>(scenes::rough_law()), points, dim, rings);
  EXPECT_EQ(body.points.components(column::strain_rate), static_cast<int>(rate.size()));
  Columns columns = body.points;
  for (int p = 0; p < points; ++p) {
    columns(column::mass)[p] = 1;
    columns(column::volume)[p] = 0.5;
    columns(column::density)[p] = 2;
    columns(column::energy)[p] = energy;
    for (std::size_t k = 0; k < rate.size(); ++k) columns(column::strain_rate, static_cast<int>(k))[p] = rate[k];
  }
  return columns;
}

IdealGas viscous(double mu, double linear = 0, double quadratic = 0) {
  IdealGas gas;
  gas.viscosity = mu;
  gas.viscosity_linear = linear;
  gas.viscosity_quadratic = quadratic;
  return gas;
}

constexpr MaterialContext on_line{1, 0.1, false}, in_plane{2, 0.1, false}, in_space{3, 0.1, false};

TEST(IdealGas, Pressure) {  // [York 4.4] p = (gamma - 1) rho e
  Columns points = one_point({0});
  IdealGas().evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -2.4, rounding);
  EXPECT_NEAR(points(column::volume)[0], 0.5, rounding);
  IdealGas monatomic;
  monatomic.gamma = 5.0 / 3;
  monatomic.evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -4, rounding);
  monatomic.describe(points);
  EXPECT_NEAR(points(column::pressure)[0], 4, rounding);
}

// [York 4.1] mu 0.5, e = (1, 3), e_xy = 2, tr e = 4: xx = 1 - 4/3 - 2.4, yy = 3 - 4/3 - 2.4, xy = 2.
TEST(IdealGas, NewtonianStressInThePlane) {
  Columns points = one_point({1, 3, 4});
  viscous(0.5).evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(points(column::stress, 0)[0], 1 - 4.0 / 3 - 2.4, rounding);
  EXPECT_NEAR(points(column::stress, 1)[0], 3 - 4.0 / 3 - 2.4, rounding);
  EXPECT_NEAR(points(column::stress, 2)[0], 2, rounding);
}

// [York 4.1] on a line 2 mu e - 2/3 mu e = 4/3 mu e: 3 - 1 - 2.4.
TEST(IdealGas, NewtonianStressOnALine) {
  Columns points = one_point({3});
  viscous(0.5).evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -0.4, rounding);
}

// [York 4.11] c = sqrt(1.68), h |div v| = 0.4: q = 2 x 0.4 x (0.2 sqrt(1.68) + 0.5 x 0.4) in compression, 0 in
// expansion.
TEST(IdealGas, ArtificialViscosity) {
  const double q = 0.8 * (0.2 * std::sqrt(1.68) + 0.2);
  EXPECT_NEAR(q, 0.367383702349, 1e-12);
  Columns points = one_point({-4});
  viscous(0, 0.2, 0.5).evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -2.4 - q, rounding);
  viscous(0, 0.2, 0.5).describe(points);
  EXPECT_NEAR(points(column::pressure)[0], 2.4, rounding);  // q is no part of the thermodynamic pressure
  Columns plane = one_point({-5, 1, 7});
  viscous(0, 0.2, 0.5).evaluate_stress(plane, all_points(plane), in_plane);
  EXPECT_NEAR(plane(column::stress, 0)[0], -2.4 - q, rounding);
  EXPECT_NEAR(plane(column::stress, 1)[0], -2.4 - q, rounding);
  EXPECT_EQ(plane(column::stress, 2)[0], 0);
  Columns expanding = one_point({4});
  viscous(0, 0.2, 0.5).evaluate_stress(expanding, all_points(expanding), on_line);
  EXPECT_NEAR(expanding(column::stress)[0], -2.4, rounding);
}

// [York 4.11] each part alone.
TEST(IdealGas, ArtificialViscosityLinearAndQuadratic) {
  Columns points = one_point({-4});
  viscous(0, 1, 0).evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -2.4 - 0.8 * std::sqrt(1.68), rounding);
  viscous(0, 0, 1).evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -2.4 - 0.32, rounding);
}

// [York 4.8] de = dt V sigma : e / m: the stress of NewtonianStressInThePlane on (1, 3, 4) does 23/75 x 10 =
// 3.0667.
TEST(IdealGas, EnergyFollowsTheStressPower) {
  Columns points = one_point({1, 3, 4});
  const IdealGas gas = viscous(0.5);
  gas.evaluate_stress(points, all_points(points), in_plane);
  const double stored = gas.advance(points, all_points(points), in_plane, 0.01);
  EXPECT_NEAR(points(column::energy)[0], 3 + 0.01 * 0.5 * 46.0 / 15, rounding);
  EXPECT_NEAR(stored, 0.01 * 0.5 * 46.0 / 15, rounding);
  EXPECT_EQ(points(column::density)[0], 2);  // the density is not this method's
  EXPECT_NEAR(gas.rates(points, in_plane)[0], 0.5 * 46.0 / 15, rounding);
}

// [York 4.7] rho / (1 + dt div v)
TEST(IdealGas, DensityByContinuity) {
  const MaterialContext context{2, 0.1, true};
  Columns points = one_point({1, 3, 4});
  const IdealGas gas;
  gas.evaluate_stress(points, all_points(points), context);
  ASSERT_EQ(gas.internal_variables(context).size(), 2u);
  EXPECT_NEAR(gas.rates(points, context)[1], -8, rounding);
  gas.advance(points, all_points(points), context, 0.01);
  EXPECT_NEAR(points(column::density)[0], 2 / 1.04, rounding);
}

// [York 4.1] s : e of the viscous part alone, dt V (sigma + p 1) : e = 0.01 x 0.5 x (46/15 + 2.4 x 4).
TEST(IdealGas, ViscousHeat) {
  Columns points = one_point({1, 3, 4});
  const IdealGas gas = viscous(0.5);
  gas.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(gas.viscous_heat(points, all_points(points), in_plane, 0.01), 0.005 * (46.0 / 15 + 9.6), rounding);
}

// Viscosity from a compression, power over an expansion: cools; [EC-APIC viscous heat] takes the stress from
// the latter.
TEST(IdealGas, CoolingIsReversed) {
  for (const IdealGas& gas : {viscous(0.5), viscous(0, 1, 1)}) {
    Columns points = one_point({-4});
    gas.evaluate_stress(points, all_points(points), on_line);
    points(column::strain_rate)[0] = 2;
    EXPECT_LT(gas.viscous_heat(points, all_points(points), on_line, 1), 0);
    EXPECT_TRUE(gas.reverse_cooling(points, all_points(points), on_line));
    EXPECT_NEAR(points(column::stress)[0], 4.0 / 3 * gas.viscosity * 2 - 2.4, rounding);
    EXPECT_GE(gas.viscous_heat(points, all_points(points), on_line, 1), 0);
    EXPECT_FALSE(gas.reverse_cooling(points, all_points(points), on_line));
  }
}

TEST(IdealGas, HeatingIsLeftAsItIs) {
  const IdealGas gas = viscous(0.5, 1, 1);
  Columns points = one_point({-4});
  gas.evaluate_stress(points, all_points(points), on_line);
  const double stress = points(column::stress)[0];
  points(column::strain_rate)[0] = -1;
  EXPECT_FALSE(gas.reverse_cooling(points, all_points(points), on_line));
  EXPECT_EQ(points(column::stress)[0], stress);
  EXPECT_FALSE(IdealGas().reverse_cooling(points, all_points(points), on_line));
}

// [EC-APIC 6] e_p += (A_p + B_p) / m_p with the losses in joules.
TEST(IdealGas, TakesHeat) {
  Columns points = one_point({0}, 3, 2);
  points(column::mass)[1] = 4;
  std::vector<double> heat(2 + lanes);
  heat[0] = heat[1] = 0.5;
  IdealGas().add_heat(points, all_points(points), heat.data());
  EXPECT_EQ(points(column::energy)[0], 3.5);
  EXPECT_EQ(points(column::energy)[1], 3.125);
  EXPECT_EQ(IdealGas().stored_energy(points, all_points(points)), 3.5 + 4 * 3.125);
}

// c = sqrt(gamma (gamma - 1) e) and 4/3 mu / rho, of the fastest and the thinnest point.
// A cold gas that moves: what rounding takes from nothing is nothing, what is more than that stays to be refused.
TEST(IdealGas, IsNotColderThanNothingByRounding) {
  for (const double lost : {0.9e-16, 1.1e-16}) {
    const double left = lost < 1e-16 ? 0 : -4 * lost;
    Columns points = one_point({1}, 0);
    points(column::velocity)[0] = -2;
    const std::vector<double> heat(1 + lanes, -4 * lost);
    IdealGas().add_heat(points, all_points(points), heat.data());
    EXPECT_EQ(points(column::energy)[0], left);
    points = one_point({1}, 0);
    points(column::velocity)[0] = -2;
    points(column::stress)[0] = -8 * lost;  // V sigma : d = -4 lost
    IdealGas().advance(points, all_points(points), on_line, 1);
    EXPECT_EQ(points(column::energy)[0], left);
  }
}

TEST(IdealGas, StepBounds) {
  Columns points = one_point({0, 0, 0}, 3, 2);
  points(column::velocity, 0)[1] = 3;
  points(column::velocity, 1)[1] = -4;
  points(column::volume)[0] = 2;  // rho 0.5
  const StepBounds plane = viscous(0.3).step_bounds(points, all_points(points), 2);
  EXPECT_NEAR(plane.fastest, std::sqrt(1.68) + 5, rounding);
  EXPECT_NEAR(plane.diffusivity, 0.8, rounding);
  Columns line = one_point({0});
  line(column::velocity)[0] = -3;
  EXPECT_NEAR(IdealGas().step_bounds(line, all_points(line), 1).fastest, std::sqrt(1.68) + 3, rounding);
  EXPECT_EQ(IdealGas().step_bounds(line, all_points(line), 1).diffusivity, 0);
}

TEST(IdealGas, NamesTheFirstFault) {
  const IdealGas gas;
  Columns points = one_point({0}, 3, 4);
  EXPECT_EQ(gas.first_fault(points, all_points(points)).point, -1);
  points(column::energy)[2] = 0;
  EXPECT_EQ(gas.first_fault(points, all_points(points)).point, -1);  // cold is admissible
  points(column::energy)[2] = -1e-30;
  EXPECT_EQ(gas.first_fault(points, all_points(points)).point, 2);
  EXPECT_EQ(gas.first_fault(points, all_points(points)).field, "energy");
  EXPECT_EQ(gas.first_fault(points, all_points(points)).value, -1e-30);
  for (double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    points(column::volume)[1] = bad;
    EXPECT_EQ(gas.first_fault(points, all_points(points)).point, 1) << bad;
    EXPECT_EQ(gas.first_fault(points, all_points(points)).field, "density");
  }
  points(column::volume)[1] = 1;
  for (double bad : {std::nan(""), HUGE_VAL}) {
    points(column::energy)[0] = bad;
    EXPECT_EQ(gas.first_fault(points, all_points(points)).point, 0) << bad;
  }
}

// [York 4.1] in space: mu 0.5, e = (1, 2, -6), tr e = -3: normal 2 mu e + mu - p, shears mu times the engineering ones.
TEST(IdealGas, NewtonianStressInSpace) {
  Columns points = one_point({1, 2, -6, 3, 4, 5});
  viscous(0.5).evaluate_stress(points, all_points(points), in_space);
  const double expected[6] = {1 + 1 - 2.4, 2 + 1 - 2.4, -6 + 1 - 2.4, 1.5, 2, 2.5};
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(points(column::stress, k)[0], expected[k], rounding) << k;
}

// [York 4.1] of rings: the third is the hoop, and part of the trace.
TEST(IdealGas, NewtonianStressOfRings) {
  Columns points = one_point({1, 2, -6, 3});
  viscous(0.5).evaluate_stress(points, all_points(points), in_plane);
  const double expected[4] = {1 + 1 - 2.4, 2 + 1 - 2.4, -6 + 1 - 2.4, 1.5};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(points(column::stress, k)[0], expected[k], rounding) << k;
}

TEST(IdealGas, WithoutPhysicalViscosityItsStressIsAPressure) {
  EXPECT_TRUE(IdealGas().isotropic());
  EXPECT_TRUE(viscous(0, 1, 1).isotropic());
  EXPECT_FALSE(viscous(1e-30).isotropic());
}

// Seven points around a range, and in it more than a pack: a loop over the range does there what it does alone, and nothing
// elsewhere, not even where the neighbours are no numbers.
Columns many_points(int strains) {
  const int n = 2 * lanes + 14;
  Columns points = one_point(std::vector<double>(static_cast<std::size_t>(strains), 0.0), 3, n);
  scenes::Random random(17);
  for (int p = 0; p < n; ++p) {
    points(column::mass)[p] = random(1, 2);
    points(column::volume)[p] = random(1, 2);
    points(column::density)[p] = points(column::mass)[p] / points(column::volume)[p];
    points(column::energy)[p] = random(1, 2);
    for (int d = 0; d < points.components(column::velocity); ++d) points(column::velocity, d)[p] = random(-1, 1);
    for (int k = 0; k < strains; ++k) points(column::strain_rate, k)[p] = random(-3, 1);
  }
  return points;
}

constexpr const ColumnId* gas_columns[] = {&column::mass,   &column::volume,  &column::strain_rate, &column::stress,
                                           &column::energy, &column::density, &column::pressure,    &column::velocity};

void expect_same_in_range(const Columns& a, const Columns& b, PointRange range) {
  for (const ColumnId* id : gas_columns) {
    for (int k = 0; k < a.components(*id); ++k) {
      for (int p = range.first; p < range.last; ++p) EXPECT_EQ(a(*id, k)[p], b(*id, k)[p]) << id->name() << ' ' << p;
    }
  }
}

template <class Loop>
void expect_range_alone(int strains, Loop&& loop) {
  const Columns start = many_points(strains);
  const int n = start.points();
  const PointRange range{7, n - 7};
  Columns alone = start, beside_nothing = start;
  for (const ColumnId* id : gas_columns) {
    for (int k = 0; k < start.components(*id); ++k) {
      for (int p = 0; p < n; ++p) {
        if (p < range.first || p >= range.last) beside_nothing(*id, k)[p] = std::nan("");
      }
    }
  }
  const double result = loop(alone, range);
  EXPECT_EQ(result, loop(beside_nothing, range));
  expect_same_in_range(alone, beside_nothing, range);
  expect_same_in_range(alone, start, {0, range.first});
  expect_same_in_range(alone, start, {range.last, n});
  // Point by point it is the same, and sums add up: two dozen roundings of some hundred.
  Columns one_by_one = start;
  double sum = 0;
  for (int p = range.first; p < range.last; ++p) sum += loop(one_by_one, PointRange{p, p + 1});
  expect_same_in_range(alone, one_by_one, range);
  EXPECT_NEAR(result, sum, 1e-12);
}

TEST(IdealGas, RangesLeaveOthersAlone) {
  const IdealGas gas = viscous(0.5, 1, 1);
  for (int strains : {1, 3, 4, 6}) {
    SCOPED_TRACE(strains);
    const MaterialContext context{strains == 6 ? 3 : strains == 1 ? 1 : 2, 0.1, true};
    const auto stressed = [&](Columns& points, PointRange range) {
      gas.evaluate_stress(points, range, context);
      return 0.0;
    };
    expect_range_alone(strains, stressed);
    expect_range_alone(strains, [&](Columns& points, PointRange range) {
      stressed(points, range);
      return gas.advance(points, range, context, 0.01);
    });
    expect_range_alone(strains, [&](Columns& points, PointRange range) {
      stressed(points, range);
      return gas.viscous_heat(points, range, context, 0.01);
    });
    expect_range_alone(strains, [&](Columns& points, PointRange range) {
      stressed(points, range);
      for (int k = 0; k < strains; ++k) {
        for (int p = range.first; p < range.last; ++p) points(column::strain_rate, k)[p] *= -0.5;
      }
      gas.reverse_cooling(points, range, context);
      return 0.0;
    });
    expect_range_alone(strains, [&](Columns& points, PointRange range) {
      const std::vector<double> heat(static_cast<std::size_t>(points.points() + lanes), 0.25);
      gas.add_heat(points, range, heat.data());
      return gas.stored_energy(points, range);
    });
  }
}

TEST(IdealGas, RangesAreJudgedAlone) {
  const IdealGas gas = viscous(0.5, 1, 1);
  Columns points = many_points(3);
  const PointRange range{7, points.points() - 7};
  const StepBounds bounds = gas.step_bounds(points, range, 2);
  double fastest = 0, diffusivity = 0;
  for (int p = range.first; p < range.last; ++p) {
    fastest = std::max(fastest, std::sqrt(0.56 * points(column::energy)[p]) +
                                    std::hypot(points(column::velocity)[p], points(column::velocity, 1)[p]));
    diffusivity = std::max(diffusivity, 4.0 / 3 * 0.5 * points(column::volume)[p] / points(column::mass)[p]);
  }
  EXPECT_NEAR(bounds.fastest, fastest, rounding);
  EXPECT_NEAR(bounds.diffusivity, diffusivity, rounding);
  for (int bad : {0, 6, range.last, points.points() - 1}) {
    points(column::energy)[bad] = std::nan("");
    points(column::volume)[bad] = 1e-9;
    points(column::velocity)[bad] = 1e9;
  }
  EXPECT_EQ(gas.step_bounds(points, range, 2).fastest, bounds.fastest);
  EXPECT_EQ(gas.step_bounds(points, range, 2).diffusivity, bounds.diffusivity);
  EXPECT_EQ(gas.first_fault(points, range).point, -1);
  EXPECT_EQ(gas.first_fault(points, all_points(points)).point, 0);
  // One that is no number within the range is never swallowed, whichever lane it has.
  for (int p = range.first; p < range.last; ++p) {
    Columns one_bad = points;
    one_bad(column::velocity, 1)[p] = std::nan("");
    EXPECT_TRUE(std::isnan(gas.step_bounds(one_bad, range, 2).fastest)) << p;
  }
}

}  // namespace
}  // namespace plumbline::ideal_gas_test
