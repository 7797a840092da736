// Solids on the grid: forces and strain rates are adjoint whatever the stress measure, and motions without strain or with
// the same strain everywhere are exact, in all geometries and on all shapes.
#include <Eigen/Core>
#include <utility>

#include "kernel/materials/shared_dilatation.hpp"
#include "kernel/shapes/shape.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::solids_test {
namespace {

using scenes::Law;
using scenes::Space;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

class Solids : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Solids, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// --- adjointness ----------------------------------------------------------------------------------------------------

// With FLIP, v_p' - v_p = dt sum_i N_ip f_i / M_i, so that sum_p m_p v_p . (v_p' - v_p) / dt = sum_i f_i . v_i, v_i what the
// points map to the nodes; and that is minus sum_p V_p times the dot product of the stress and strain_rate columns, whatever
// they hold. Sums of some thousand terms, the difference over dt loses three digits of v^2: 1e-12 of the larger half.
// [York 3.17, 3.23] [Segments 2] [Neo-Hookean 1] [Dilatation 1-3]
void expect_adjoint(Scene scene, double ahead) {
  Ledger ledger;
  const double dt = 1e-3;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->predict_stress(ahead, NodalVelocity::start);
  const Columns before = scene.bodies[0].points;
  double stress_power = 0, scale = 0;
  for (int k = 0; k < before.components(column::stress); ++k) {
    for (int p = 0; p < before.points(); ++p) {
      const double power = before(column::volume)[p] * before(column::stress, k)[p] * before(column::strain_rate, k)[p];
      stress_power += power;
      scale += std::abs(power);
    }
  }
  engine->map_forces();
  engine->advance_momentum(dt);
  engine->kick_points(dt);
  const Columns& after = scene.bodies[0].points;
  double force_power = 0;
  for (int d = 0; d < scene.grid.dim; ++d) {
    for (int p = 0; p < after.points(); ++p) {
      const double v = before(column::velocity, d)[p];
      force_power += before(column::mass)[p] * v * (after(column::velocity, d)[p] - v) / dt;
      scale += 1e-3 * before(column::mass)[p] * v * v / dt;
    }
  }
  EXPECT_NEAR(force_power, -stress_power, 1e-12 * scale);
  EXPECT_GT(std::abs(stress_power), 1e-4 * scale);
}

TEST_P(Solids, ForcesDoWhatStressesTake) {
  for (Law law : scenes::laws) {
    if (!scenes::lives_in(law, GetParam())) continue;
    for (const ShapeEntry& shape : shapes()) {
      if (shape.at_start && (scenes::is_chain(law) || GetParam() == Space::axisymmetric)) continue;
      for (const bool walled : {true, false}) {
        for (const double ahead : {0.0, 0.02}) {  // where the stress of finite strains is no longer symmetric
          for (const auto& [sharpening, means] : {std::pair{0.0, false}, std::pair{1.0, false}, std::pair{0.0, true}}) {
            SCOPED_TRACE(testing::Message() << law << ", " << shape.name << ", ahead " << ahead);
            const Scene gas = walled ? scenes::rough_gas(GetParam(), shape.name, "flip", scenes::no_gravity)
                                     : scenes::rough_gas_in_space(GetParam(), shape.name, "flip", scenes::no_gravity);
            Scene scene = scenes::rough_solid(law, gas);
            scene.sharpening = sharpening;
            if (means) scenes::let_hardly_compress(scene);
            expect_adjoint(std::move(scene), ahead);
          }
        }
      }
    }
  }
}

// --- patches --------------------------------------------------------------------------------------------------------

Matrix in_space(Matrix l, int dim) {
  for (int d = dim; d < 3; ++d) l.row(d).setZero(), l.col(d).setZero();
  return l;
}
Matrix general() {
  Matrix l;
  l << 0.5, -0.3, 0.2, 0.8, -0.7, -0.4, 0.1, 0.6, 0.3;
  return l;
}

// v = v0 + L x, C = L.
void set_affine_motion(Scene& scene, const Vector& v0, const Matrix& l) {
  const int dim = scene.grid.dim;
  Columns& points = scene.bodies[0].points;
  points.add(column::affine, dim * dim);
  for (int p = 0; p < points.points(); ++p) {
    Vector x = Vector::Zero();
    for (int d = 0; d < dim; ++d) x[d] = points(column::position, d)[p];
    const Vector v = v0 + l * x;
    for (int d = 0; d < dim; ++d) {
      points(column::velocity, d)[p] = v[d];
      for (int e = 0; e < dim; ++e) points(column::affine, d * dim + e)[p] = l(d, e);
    }
  }
}

// An affine velocity of uneven points without stress, over one step that strains with it: eps = dt sym L, F = 1 + dt L at
// every point, the hoop's by v_r / r. Strain rates of thirty nodal velocities of order one over h: 1e-13. [Hooke 1]
// [Neo-Hookean 2] [GIMP 1]
TEST_P(Solids, AffineMotionStrainsUniformly) {
  const double dt = 0.01;
  const int dim = scenes::dim_of(GetParam());
  const bool rings = GetParam() == Space::axisymmetric;
  const Matrix l = in_space(general(), dim);
  const Vector v0 = Vector(0.3, dim > 1 ? -0.2 : 0, dim > 2 ? 0.5 : 0);
  for (Law law : {Law::hooke, Law::neo_hookean}) {
    for (const Choice& shape : scenes::shapes_in_space()) {
      SCOPED_TRACE(testing::Message() << law << ", " << shape.name);
      Scene scene = scenes::rough_solid(
          law, scenes::rough_gas_in_space(GetParam(), shape.name, "apic", scenes::no_gravity), 0);
      set_affine_motion(scene, v0, l);
      const auto r = scenes::by_id(scene.bodies[0], column::position),
                 vr = scenes::by_id(scene.bodies[0], column::velocity);
      Simulation run(scene, "usl", {0.3, dt});
      run.step(1);
      const Body& body = run.scene().bodies[0];
      for (std::size_t p = 0; p < r.size(); ++p) {
        if (law == Law::neo_hookean) {
          for (int k = 0; k < dim * dim; ++k) {
            const double expected = dt * l(k / dim, k % dim) + (k / dim == k % dim ? 1 : 0);
            ASSERT_NEAR(scenes::by_id(body, column::deformation, k)[p], expected, 1e-13);
          }
          if (rings) {
            ASSERT_NEAR(scenes::by_id(body, column::deformation, 4)[p], 1 + dt * vr[p] / r[p], 1e-13);
          }
          continue;
        }
        std::vector<double> expected;
        for (int d = 0; d < dim; ++d) expected.push_back(l(d, d));
        if (rings) expected.push_back(vr[p] / r[p]);
        if (dim == 3) expected.insert(expected.end(), {l(1, 2) + l(2, 1), l(0, 2) + l(2, 0)});
        if (dim > 1) expected.push_back(l(0, 1) + l(1, 0));
        for (std::size_t k = 0; k < expected.size(); ++k) {
          ASSERT_NEAR(scenes::by_id(body, column::strain, static_cast<int>(k))[p], dt * expected[k], 1e-13);
        }
      }
    }
  }
}

// Where all points strain alike, what they share is what each has: ln J, also of a motion that mostly turns, over finite steps.
// [Dilatation 1, 4]
TEST_P(Solids, SharedDilatationOfAnAffineMotionIsThatOfThePoints) {
  for (const char* shape : {"quadratic", "cpdi"}) {
    Scene scene = scenes::rough_solid(Law::neo_hookean,
                                      scenes::rough_gas_in_space(GetParam(), shape, "apic", scenes::no_gravity), 0);
    scenes::let_hardly_compress(scene);
    Matrix l = in_space(general(), scenes::dim_of(GetParam()));
    if (GetParam() == Space::axisymmetric) l(0, 1) = 0;  // v_r / r is the same everywhere
    set_affine_motion(scene, Vector::Zero(), l);
    Simulation run(scene, "usl", {0.3, 0.05});
    run.step(1);
    const Columns& points = run.scene().bodies[0].points;
    for (int p = 0; p < points.points(); ++p) {
      const double log_j = std::log(points(column::volume)[p] / points(column::mass)[p]);  // rho_0 = 1
      ASSERT_GT(std::abs(log_j), 1e-4);
      ASSERT_NEAR(points(column::dilatation)[p], log_j, 1e-13) << shape;
    }
  }
}

// A rigid motion strains nothing: translation, rings' along their axis, with every step; over 20 steps no stress appears, and
// velocities stay. A stress of 1e-15 is what roundings of strain give, over 20 steps a hundred times that. [York 3.23]
TEST_P(Solids, TranslationStrainsNothing) {
  const int dim = scenes::dim_of(GetParam()), steps = 20;
  const double dt = 0.005;
  const bool rings = GetParam() == Space::axisymmetric;
  const Vector v0(rings ? 0 : 0.3, dim > 1 ? -0.2 : 0, dim > 2 ? 0.5 : 0);
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator.starts_with("test_")) continue;
    for (Law law : {Law::hooke, Law::neo_hookean, Law::segments}) {
      if (!scenes::lives_in(law, GetParam())) continue;
      SCOPED_TRACE(testing::Message() << c << ", " << law);
      Scene scene = scenes::rough_solid(
          law, scenes::rough_gas_in_space(GetParam(), c.shape, c.transfer, scenes::no_gravity), 0);
      set_affine_motion(scene, v0, Matrix::Zero());
      Simulation run(scene, c.integrator, {0.3, dt});
      for (int k = 0; k < steps; ++k) run.step(1);
      for (int d = 0; d < dim; ++d) {
        const auto x0 = scenes::by_id(scene.bodies[0], column::position, d),
                   x = scenes::by_id(run.scene().bodies[0], column::position, d),
                   v = scenes::by_id(run.scene().bodies[0], column::velocity, d);
        for (std::size_t p = 0; p < x.size(); ++p) {
          ASSERT_NEAR(v[p], v0[d], 1e-13);
          ASSERT_NEAR(x[p], x0[p] + steps * dt * v0[d], 1e-13);
        }
      }
      scenes::expect_ledger_closes(run.ledger(), 1e-13);
      EXPECT_NEAR(run.ledger().stores.elastic, 0, 1e-13 * run.ledger().energy.scale());
    }
  }
}

// A known limit. Linear shapes alone have a gradient where their weight is zero: of a point that stands exactly on a node line
// with none beyond, the node beyond has no mass, and so no velocity, and a translation reads as a strain of dt v / h. A
// rounding beside the line it does not.
TEST(LinearShapes, StrainAPointAloneOnANodeLine) {
  const double h = 0.25, v = 0.5, dt = 0.125;
  const auto strain = [&](const std::string& shape, double x) {
    Body body = scenes::solid_body(Law::hooke, Space::line, {{x, 0, 0}}, 0.1);
    body.points(column::velocity)[0] = v;
    Simulation run(scenes::scene_of(scenes::line(8, h, scenes::walls_everywhere(Wall::free)), {body}, shape, "flip"),
                   "usl", {0.3, dt});
    run.step(1);
    return run.scene().bodies[0].points(column::strain)[0];
  };
  EXPECT_EQ(strain("linear", 4 * h), -dt * v / h);
  EXPECT_NEAR(strain("linear", std::nextafter(4 * h, 2.0)), 0, 1e-15);
  for (const Choice& shape : scenes::shapes_in_space()) {
    if (shape.name == "linear") continue;
    EXPECT_NEAR(strain(shape.name, 4 * h), 0, 1e-15) << shape.name;
  }
}

// A body that spins: small strains see the spin's symmetric part, zero, exactly; finite ones F = 1 + dt W, whose stretch of
// (w dt)^2 / 2 is the step's error and the law's stress that of it: mu ((F F^T - 1) + ...) of second order in dt.
// [Hooke 1] [Neo-Hookean 1, 2]
TEST_P(Solids, SpinStrainsInSecondOrderOnly) {
  const int dim = scenes::dim_of(GetParam());
  if (dim == 1 || GetParam() == Space::axisymmetric) return;
  Matrix spin;
  spin << 0, -2, 0.7, 2, 0, -1.1, -0.7, 1.1, 0;
  spin = in_space(spin, dim);
  for (const Choice& shape : scenes::shapes_in_space()) {
    SCOPED_TRACE(shape.name);
    const auto largest_stress = [&](Law law, double dt) {
      Scene scene = scenes::rough_solid(
          law, scenes::rough_gas_in_space(GetParam(), shape.name, "apic", scenes::no_gravity), 0);
      set_affine_motion(scene, Vector(0.1, 0.2, 0), spin);
      Simulation run(scene, "usl", {0.3, dt});
      run.step(1);
      double largest = 0;
      for (double s : run.scene().bodies[0].points.values(column::stress)) largest = std::max(largest, std::abs(s));
      return largest;
    };
    EXPECT_LE(largest_stress(Law::hooke, 0.01), 1e-13);
    const double once = largest_stress(Law::neo_hookean, 0.01), half = largest_stress(Law::neo_hookean, 0.005);
    EXPECT_NEAR(once / half, 4, 0.01);
  }
}

// An even lattice of points, spacing `spacing` along each axis, each with the same stress; columns as the engine wants them.
// Boxes or domains that tile the body: sum_p V_p grad N_ip = integral of grad N = 0 at inner nodes, exactly, wherever the
// lattice lies and whatever its spacing. B-splines and uniform boxes have that on lattices of the grid's own spacing alone.
// [York 3.17] [GIMP 1, 2]
double force_on_inner_points(Space space, Law law, const std::string& shape, const Vector& stretch, double shift) {
  const int dim = scenes::dim_of(space), filled = 9, per_cell = 2;
  GridSpec grid = scenes::box(space, {filled + 10, filled + 10, filled + 10}, 1.0);
  for (int d = 0; d < dim; ++d) grid.origin[static_cast<std::size_t>(d)] = -5;
  auto places = scenes::lattice(grid, per_cell, {5, 5, 5}, {filled + 5, filled + 5, filled + 5});
  Scene scene = scenes::scene_of(grid, {scenes::solid_body(law, space, places, scenes::lattice_volume(grid, per_cell))},
                                 shape, "apic");
  Columns& points = scene.bodies[0].points;
  scene.bodies[0].spacing = grid.h / per_cell;
  for (int p = 0; p < points.points(); ++p) {
    for (int d = 0; d < dim; ++d) {
      double& x = points(column::position, d)[p];
      x = stretch[d] * (x - 0.5 * filled) + 0.5 * filled + shift;
      if (law == Law::neo_hookean) points(column::deformation, d * (dim + 1))[p] = stretch[d];
    }
    for (int k = 0; law == Law::hooke && k < points.components(column::strain); ++k) {
      points(column::strain, k)[p] = 0.1 * std::cos(2.0 * k);
    }
  }
  const double dt = 0.01;
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->map_forces();
  engine->advance_momentum(dt);
  engine->kick_points(dt);
  double inner = 0, outer = 0;
  for (int p = 0; p < points.points(); ++p) {
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const double from_edge = stretch[d] * filled / 2 -
                               std::abs(points(column::position, d)[p] - shift - 0.5 * filled);
      inside = inside && from_edge > 3.5;
    }
    for (int d = 0; d < dim; ++d) {
      double& worst = inside ? inner : outer;
      worst = std::max(worst, std::abs(points(column::velocity, d)[p]) / dt);
    }
  }
  EXPECT_GT(outer, 1e-3);  // the edges feel it
  return inner;
}

// Sums of a thousand terms of order one: 1e-13 of the edges' accelerations of order one.
TEST_P(Solids, UniformStressPushesNoInnerPoint) {
  if (GetParam() == Space::axisymmetric) return;  // uniform stress is no equilibrium of boxes of rings
  for (const Choice& shape : scenes::shapes_in_space()) {
    for (double shift : {0.0, 0.3}) {
      for (Law law : {Law::hooke, Law::neo_hookean}) {
        SCOPED_TRACE(testing::Message() << law << ", " << shape.name << ", shift " << shift);
        // Hooke's volumes stay, so that its lattice is the grid's; finite strains stretch theirs.
        if (law == Law::hooke) {
          EXPECT_LE(force_on_inner_points(GetParam(), law, shape.name, Vector::Ones(), shift), 1e-13);
          continue;
        }
        const double inner = force_on_inner_points(GetParam(), law, shape.name, Vector(1.13, 0.94, 1.07), shift);
        if (shape.name == "contiguous-gimp" || shape.name == "cpdi") {
          EXPECT_LE(inner, 1e-13);
        } else {
          EXPECT_GT(inner, 1e-6);
        }
      }
    }
  }
}

// A chain of segments in space: what an engine of three dimensions makes of it. Chains that carry stress along tangents
// live on lines and in the plane.
TEST(Chains, LiveWhereTheirForcesDo) {
  Ledger ledger;
  for (Space space : scenes::spaces) {
    Scene scene = scenes::scene_of(
        scenes::box(space, {8, 8, 8}, 0.1),
        {scenes::solid_body(Law::segments, space, {{0.31, 0.3, 0.3}, {0.35, 0.32, 0.3}, {0.4, 0.3, 0.33}}, 1e-3)},
        "quadratic", "apic");
    EXPECT_NO_THROW(make_engine(scene, ledger, {}));
  }
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  Scene scene = scenes::rough_gas(3, "quadratic", "apic");
  scene.bodies = {scenes::membrane_body(law, 3, {{0.3, 0.3, 0.3}, {0.35, 0.3, 0.3}}, 1e-3)};
  EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::solids_test
