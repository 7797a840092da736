// Densities, pressures, chains, and losses that go to the gas, each built without the rest of the engine.
#include "kernel/engine/chains.hpp"
#include "kernel/engine/densities.hpp"
#include "kernel/engine/loss_to_gas.hpp"
#include "kernel/engine/pressures.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/pressure_quadrature.hpp"
#include "tests/kernel/engine/parts.hpp"

namespace plumbline::coupled_parts_test {
namespace {

// --- densities ----------------------------------------------------------------------------------------------------------

double mean_square_weight() {  // sum_i N_ip^2 per direction of a point on a node, quadratic: 3/4 and twice 1/8
  return 0.75 * 0.75 + 2 * 0.125 * 0.125;
}

// A point of 2 kg alone, on a node: rho_i = 2 N_ip / h^2. [EC-APIC 2]
TEST(Densities, OfTheGridAreMassOverCell) {
  Located on(points_at({{1.0, 1.0}}, Wall::free));
  on.at.fields[0].mass.assign(on.field().mass.size(), 0.0);
  const typename PointLoops<Plane>::Spread mass[] = {{on.points()(column::mass), nullptr, on.field().mass.data(), 1}};
  on.space.spread(on.points(), on.at.weights[0], mass);
  Densities<Plane> densities(on.space, DensityMethod::grid);
  const auto source = densities.find(on.scene.bodies, on.body(), on.at.weights[0], on.field(), true);
  ASSERT_TRUE(source.nodes);
  EXPECT_FALSE(source.specific || source.elsewhere);
  double at_point = 0;
  on.field().for_touched(on.space.grid, [&](std::size_t i) {
    EXPECT_DOUBLE_EQ((*source.nodes)[i], on.field().mass[i] / 0.25);
    at_point += on.field().mass[i] / 2 * (*source.nodes)[i];
  });
  EXPECT_NEAR(at_point, 2 / 0.25 * mean_square_weight() * mean_square_weight(), 1e-14);
}

// Where others share the nodes a body's own mass is mapped; once it has moved, where it stands.
TEST(Densities, AreOfTheBodysOwnMassWhereItStands) {
  Located on(points_at({{1.0, 1.0}}, Wall::free));
  std::fill(on.field().mass.begin(), on.field().mass.end(), 17.0);  // of others
  Densities<Plane> densities(on.space, DensityMethod::grid);
  on.at.weights[0].keep(on.points());
  on.points()(column::position)[0] = 1.5;
  const auto source = densities.find(on.scene.bodies, on.body(), on.at.weights[0], on.field(), false);
  ASSERT_TRUE(source.nodes && source.elsewhere);
  double first_moment = 0, sum = 0;
  for (int i = 0; i < on.space.grid.node_count(); ++i) {
    const double rho = (*source.nodes)[static_cast<std::size_t>(i)];
    sum += rho;
    first_moment += rho * on.space.grid.position(i)[0];
  }
  EXPECT_NEAR(sum, 2 / 0.25, 1e-13);
  EXPECT_NEAR(first_moment / sum, 1.5, 1e-13);
}

TEST(Densities, OfCellsAreSetOnThePoints) {
  Located on(points_at({{0.6, 0.6}, {0.9, 0.7}}, Wall::free));
  Densities<Plane> densities(on.space, DensityMethod::cell);
  EXPECT_FALSE(densities.find(on.scene.bodies, on.body(), on.at.weights[0], on.field(), true).nodes);
  for (int p = 0; p < 2; ++p) EXPECT_DOUBLE_EQ(on.points()(column::density)[p], 2 * 2 / 0.25);  // [York 4.5]
}

// --- pressures ----------------------------------------------------------------------------------------------------------

void read_pressures(Located& on, DensityMethod method, double sharpening) {
  Columns& points = on.points();
  const typename PointLoops<Plane>::Spread mass[] = {{points(column::mass), nullptr, on.field().mass.data(), 1}};
  on.space.spread(points, on.at.weights[0], mass);
  Pressures<Plane>(on.space, method, sharpening).read(on.body(), on.at.weights[0], on.field());
}

// Four points a cell, between walls on all sides.
std::vector<std::array<double, 2>> lattice() {
  std::vector<std::array<double, 2>> places;
  for (int k = 0; k < 64; ++k) places.push_back({0.125 + 0.25 * (k % 8), 0.125 + 0.25 * (k / 8)});
  return places;
}

// A point alone, at whose edge there is no pressure.
TEST(Pressures, AreTheirOwnAtAFreeEdge) {
  Located on(points_at({{1.0, 1.0}}, Wall::free));
  on.points()(column::volume)[0] = 0.125;
  on.points()(column::pressure)[0] = 3;
  read_pressures(on, DensityMethod::grid, 0);
  EXPECT_EQ(on.points()(column::pressure)[0], 3);
}

// Rising along x by a share of the first: read where that is less than 0.3 of the most, more of it the less it is. [Read-off 2]
TEST(Pressures, AreReadTheMoreTheEvener) {
  const auto read = [](double rise, int p) {
    Located on(points_at(lattice()));
    for (int q = 0; q < 64; ++q) {
      on.points()(column::volume)[q] = 0.0625;
      on.points()(column::pressure)[q] = q % 8 < 4 ? 1 : 1 + rise;
    }
    read_pressures(on, DensityMethod::grid, 0);
    return (on.points()(column::pressure)[p] - 1) / rise;
  };
  const int below = 3, above = 4;  // beside the jump, which maps smooth
  EXPECT_EQ(read(1, below), 0);
  EXPECT_EQ(read(1, above), 1);
  const double smoothed = read(1e-3, below), less = read(0.1, below);
  EXPECT_GT(smoothed, 0.2);
  EXPECT_NEAR(read(1e-3, above), 1 - smoothed, 1e-4);
  EXPECT_LT(less, smoothed);
  EXPECT_GT(less, smoothed * even_share(1, 1.1, 0.3));  // nodes differ by less than points
}

// Denser on one side by eight times and hotter on the other: V_p p_p = (gamma - 1) m_p e_p is even, whatever
// volumes are read there, and so is the pressure. Walls stand on all sides. [Read-off 2]
TEST(Pressures, AreEvenAcrossAContact) {
  for (const double sharpening : {0.0, 1.0}) {
    Located on(points_at(lattice()));
    for (int p = 0; p < 64; ++p) {
      on.points()(column::mass)[p] = p % 8 < 4 ? 8 : 1;
      const double spread = on.points()(column::volume)[p] = 0.0625 * (1 + 0.3 * std::cos(p % 8));
      on.points()(column::pressure)[p] = 5 * 0.0625 / spread;
    }
    read_pressures(on, DensityMethod::grid, sharpening);
    for (int p = 0; p < 64; ++p) EXPECT_NEAR(on.points()(column::pressure)[p], 5, 1e-13) << p;
  }
}

// Of other densities, of an enclosed gas, and where points have left the places of their weights, nothing is read.
TEST(Pressures, AreReadOffDensitiesOfTheGridAlone) {
  const auto kept = [](DensityMethod method, bool enclosed, bool moved) {
    Located on(points_at(lattice()));
    for (int p = 0; p < 64; ++p) {
      const double volume = p % 2 == 0 ? 1 : 2;
      on.points()(column::volume)[p] = volume;
      on.points()(column::pressure)[p] = 3 / volume;
    }
    if (enclosed) on.body().enclosure.emplace();
    if (moved) on.at.weights[0].keep(on.points());
    read_pressures(on, method, 1);
    return on.points()(column::pressure)[0] == 3;
  };
  EXPECT_FALSE(kept(DensityMethod::grid, false, false));
  EXPECT_TRUE(kept(DensityMethod::continuity, false, false));
  EXPECT_TRUE(kept(DensityMethod::quadratic, false, false));
  EXPECT_TRUE(kept(DensityMethod::grid, true, false));
  EXPECT_TRUE(kept(DensityMethod::grid, false, true));
}

// --- chains -------------------------------------------------------------------------------------------------------------

// Three points of a chain, the middle one off the line.
Scene bent_chain(const std::shared_ptr<const Material>& law) {
  Scene scene = points_at({}, Wall::free);
  Body body = make_body("chain", law, 3, 2);
  const double x[] = {0.7, 1.0, 1.3}, y[] = {1.0, 1.1, 1.0};
  for (int p = 0; p < 3; ++p) {
    body.points(column::position, 0)[p] = x[p];
    body.points(column::position, 1)[p] = y[p];
    body.points(column::mass)[p] = 2 + p;
    body.points(column::volume)[p] = 1;
  }
  scene.bodies = {std::move(body)};
  return scene;
}

Scene pulled_chain() {
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = law->density = law->section = 1;
  Scene scene = bent_chain(law);
  for (int p = 0; p < 3; ++p) scene.bodies[0].points(column::rest_length)[p] = 0.2;
  return scene;
}

// What has no share in the nodes' motion is taken out: elastic energy falls, the centre of mass stays, and the turn of the shifts is told.
// [Coupling 2]
TEST(Chains, RelaxationReleasesEnergyAndKeepsTheCentre) {
  Located on(pulled_chain());
  Columns& points = on.points();
  for (int p = 0; p < 3; ++p) points(column::velocity, 1)[p] = 3;
  const Columns before = points;
  const Material& law = *on.body().material;
  law.describe(points);
  const double stored = law.stored_energy(points, all_points(points));
  MotionSums sums;
  Chains<Plane>(on.space, 1, 0).relax(on.body(), on.at.weights[0], sums);
  law.describe(points);
  EXPECT_LT(law.stored_energy(points, all_points(points)), stored);
  double moment[2] = {0, 0}, turned = 0, moved = 0;
  for (int p = 0; p < 3; ++p) {
    for (int d = 0; d < 2; ++d) {
      const double step = points(column::position, d)[p] - before(column::position, d)[p];
      moment[d] += points(column::mass)[p] * step;
      moved += std::abs(step);
      if (d == 0) turned += points(column::mass)[p] * step * 3;
    }
  }
  EXPECT_GT(moved, 1e-3);
  EXPECT_NEAR(moment[0], 0, 1e-14);
  EXPECT_NEAR(moment[1], 0, 1e-14);
  EXPECT_NEAR(sums.moved[2], turned, 1e-14);
}

TEST(Chains, NothingIsRelaxedWithoutTheta) {
  Located on(pulled_chain());
  const Columns before = on.points();
  MotionSums sums;
  Chains<Plane>(on.space, 0, 1).relax(on.body(), on.at.weights[0], sums);
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 3; ++p) EXPECT_EQ(on.points()(column::position, d)[p], before(column::position, d)[p]);
  }
}

// Two points on one place see the mean of their strains, and take it where the step is long; the energy of the difference is
// released. [Coupling 3]
TEST(Chains, SmoothingTakesOutWhatNoNodeSees) {
  auto law = std::make_shared<UniaxialMembrane>();
  law->youngs_modulus = 5;
  law->density = 1;
  Located on(bent_chain(law));
  Columns& points = on.points();
  for (int p = 0; p < 3; ++p) {
    points(column::position, 0)[p] = points(column::position, 1)[p] = 1;
    points(column::mass)[p] = 1;
    points(column::strain)[p] = 0.1 * (p + 1);
  }
  Placing<Plane>(on.space).locate(on.body(), on.at.weights[0], false, {});
  const double stored = Chains<Plane>(on.space, 0, 1e9).smooth_strain(on.body(), on.at.weights[0], 1);
  for (int p = 0; p < 3; ++p) EXPECT_NEAR(points(column::strain)[p], 0.2, 1e-15);
  EXPECT_NEAR(stored, 5 / 2.0 * (3 * 0.04 - 0.01 - 0.04 - 0.09), 1e-14);
}

// --- losses to the gas --------------------------------------------------------------------------------------------------

// Gas in the cells to the left, membrane points amid it and beyond its reach.
Scene gas_beside_membrane() {
  Scene scene = points_at({{0.4, 0.4}, {0.6, 0.4}, {0.4, 0.6}, {0.6, 0.6}}, Wall::free);
  auto law = std::make_shared<UniaxialMembrane>();
  Body membrane = make_body("membrane", law, 2, 2);
  membrane.points(column::position, 0)[0] = membrane.points(column::position, 1)[0] = 0.5;
  membrane.points(column::position, 0)[1] = membrane.points(column::position, 1)[1] = 1.9;
  scene.bodies.push_back(std::move(membrane));
  for (Body& body : scene.bodies) {
    for (const ColumnId* id : {&column::transfer_loss, &column::kept_loss}) body.points.add(*id);
  }
  return scene;
}

TEST(LossToGas, GoesToGasAtTheNodesAndWaitsWhereThereIsNone) {
  Located on(gas_beside_membrane());
  VelocityField<2>& field = on.field();
  ASSERT_TRUE(field.mixed());
  std::fill(field.gas.mass.begin(), field.gas.mass.end(), 0.0);
  const typename PointLoops<Plane>::Spread mass[] = {{on.points()(column::mass), nullptr, field.gas.mass.data(), 1}};
  on.space.spread(on.points(), on.at.weights[0], mass);
  on.points(1)(column::transfer_loss)[0] = 6;
  on.points(1)(column::transfer_loss)[1] = 7;
  LossToGas<Plane> given(on.space, true);
  EXPECT_TRUE(given.gives(on.body(1), field));
  EXPECT_FALSE(given.gives(on.body(0), field));
  given.clear(field);
  for (std::size_t b = 0; b < 2; ++b) given.give(on.body(b), on.at.weights[b], field);
  given.divide(field);
  given.take(on.body(0), on.at.weights[0], field);
  double taken = 0;
  for (int p = 0; p < 4; ++p) taken += on.points()(column::transfer_loss)[p];
  EXPECT_NEAR(taken, 6, 1e-14);
  EXPECT_NEAR(on.points(1)(column::kept_loss)[0], 0, 1e-15);
  EXPECT_NEAR(on.points(1)(column::kept_loss)[1], 7, 1e-14);
}

TEST(LossToGas, NothingIsGivenWhereItIsNotWanted) {
  Located on(gas_beside_membrane());
  on.points(1)(column::transfer_loss)[0] = 6;
  LossToGas<Plane> none(on.space, false);
  EXPECT_FALSE(none.gives(on.body(1), on.field()));
  none.give(on.body(1), on.at.weights[1], on.field());
  none.take(on.body(0), on.at.weights[0], on.field());
  EXPECT_EQ(on.points()(column::transfer_loss)[0], 0);
  EXPECT_EQ(on.points(1)(column::kept_loss)[0], 0);
}

}  // namespace
}  // namespace plumbline::coupled_parts_test
