// Fields whose answer is exact: affine motion, rigid motion, uniform stress, in all four geometries.
#include <Eigen/Core>

#include "kernel/shapes/shape.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::patch_test {
namespace {

using scenes::Space;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

class Patch : public testing::TestWithParam<Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Patch, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// The part of a gradient and a velocity that a geometry has.
Matrix in_space(Matrix l, int dim) {
  for (int d = dim; d < 3; ++d) l.row(d).setZero(), l.col(d).setZero();
  return l;
}
Vector in_space(Vector v, int dim) {
  for (int d = dim; d < 3; ++d) v[d] = 0;
  return v;
}

Vector vector_of(const Columns& points, const ColumnId& id, int p) {
  Vector v = Vector::Zero();
  for (int d = 0; d < points.components(id); ++d) v[d] = points(id, d)[p];
  return v;
}

// v = v_0 + L x at every point, C = L.
void set_affine_motion(Scene& scene, const Vector& v0, const Matrix& l) {
  const int dim = scene.grid.dim;
  Columns& points = scene.bodies[0].points;
  if (scene.transfer == "apic") points.add(column::affine, dim * dim);
  for (int p = 0; p < points.points(); ++p) {
    const Vector v = v0 + l * vector_of(points, column::position, p);
    for (int d = 0; d < dim; ++d) {
      points(column::velocity, d)[p] = v[d];
      for (int e = 0; e < dim && scene.transfer == "apic"; ++e) points(column::affine, d * dim + e)[p] = l(d, e);
    }
  }
}

// The strain rates of a gradient in the components of a geometry; one component alone is the divergence.
std::vector<double> strain_rates(Space space, const Matrix& l, double hoop, int components) {
  std::vector<double> e;
  const int dim = scenes::dim_of(space);
  for (int d = 0; d < dim; ++d) e.push_back(l(d, d));
  if (space == Space::axisymmetric) e.push_back(hoop);
  if (components == 1) return {l.trace() + (space == Space::axisymmetric ? hoop : 0)};
  if (dim == 3) e.insert(e.end(), {l(1, 2) + l(2, 1), l(0, 2) + l(2, 0)});
  if (dim > 1) e.push_back(l(0, 1) + l(1, 0));
  return e;
}

// Strain rates of at most 30 nodal velocities of order one over h = 0.1, each good to 1e-16: 1e-13 is ten times that.
void expect_strain_rates(Space space, const Columns& points, int p, const Matrix& l, double hoop) {
  const auto expected = strain_rates(space, l, hoop, points.components(column::strain_rate));
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(points(column::strain_rate, static_cast<int>(k))[p], expected[k], 1e-13) << "component " << k;
  }
}

std::vector<Matrix> gradients(int dim) {
  Matrix general, rotation;
  general << 0.5, -0.3, 0.2, 0.8, -0.7, -0.4, 0.1, 0.6, 0.3;
  rotation << 0, -2, 0.7, 2, 0, -1.1, -0.7, 1.1, 0;
  return {in_space(general, dim), in_space(rotation, dim)};
}

// APIC carries any affine field to every node that a point reaches and back without loss, on uneven points, at free sides
// as elsewhere. [York 3.23] [EC-APIC 1, 5]
TEST_P(Patch, AffineFieldsAreExactEverywhere) {
  const Space space = GetParam();
  const int dim = scenes::dim_of(space);
  const Vector v0 = in_space(Vector(0.3, -0.2, 0.5), dim);
  for (const IdealGas& gas : {scenes::rough_law(), scenes::inviscid_law()}) {
    for (const Choice& shape : scenes::shapes_in_space()) {
      for (const Matrix& l : gradients(dim)) {
        SCOPED_TRACE(shape.name);
        Scene scene = scenes::rough_gas_in_space(space, shape.name, "apic", scenes::no_gravity, gas);
        set_affine_motion(scene, v0, l);
        Columns& points = scene.bodies[0].points;
        std::fill_n(points(column::energy), points.points(), 0.0);  // cold: no forces
        Ledger ledger;
        const auto engine = make_engine(scene, ledger, {});
        engine->initialise();
        ledger.open(engine->totals());
        engine->locate_points();
        engine->map_mass_and_momentum();
        engine->evaluate_stress(NodalVelocity::start);
        for (int p = 0; p < points.points(); ++p) {
          const Vector x = vector_of(points, column::position, p), v = v0 + l * x;
          expect_strain_rates(space, points, p, l, v[0] / x[0]);
        }
        const Columns before = points;
        for (double& stress : points.values(column::stress)) stress = 0;
        engine->map_forces();
        engine->advance_momentum(0.01);
        engine->move_points(0.01);
        for (const ColumnId* id : {&column::velocity, &column::affine}) {
          const std::span<const double> now = points.values(*id), then = before.values(*id);
          for (std::size_t k = 0; k < now.size(); ++k) EXPECT_NEAR(now[k], then[k], 1e-13) << id->name();
        }
        // No loss but that of the moving inertia of linear shapes and boxes, which a uniform field does not feel.
        if (shape.name == "quadratic" || shape.name == "cubic") {
          EXPECT_NEAR(ledger.energy.flow(Flow::transfer), 0, 1e-14);
        }
      }
    }
  }
}

// Dust under simple shear, L = u w^T with u . w = 0, flies on straight lines: L v is the same everywhere, so C = L stays true
// while the points move, each keeps its velocity, and the gradient stays. (Of other gradients, rotation among them, the
// field of the next step is L (1 + dt L)^-1, which no point carries.) Rings may shear along their axis alone, on a line there is
// no shear. Velocities differ by some ten roundings a step, over 50 steps: 1e-13; strain rates by that over h.
// Nothing is stored, lost or given. [York 3.21-3.23] [EC-APIC 1, 5]
TEST_P(Patch, ShearedDustKeepsItsVelocities) {
  const Space space = GetParam();
  const int dim = scenes::dim_of(space), steps = 50;
  const bool rings = space == Space::axisymmetric;
  const Vector u = rings ? Vector(0, 1, 0) : Vector(0.6, 0.8, -0.5), w = rings ? Vector(1, 0, 0) : Vector(0.8, -0.6, 0);
  const Matrix l = dim == 1 ? Matrix(Matrix::Zero()) : in_space(Matrix(u * w.transpose()), dim);
  const Vector v0 = in_space(Vector(rings ? 0 : 0.3, -0.2, 0.5), dim);
  for (const char* shape : {"quadratic", "cubic"}) {
    SCOPED_TRACE(shape);
    Scene scene = scenes::rough_gas_in_space(space, shape, "apic", scenes::no_gravity, {});
    set_affine_motion(scene, v0, l);
    std::fill_n(scene.bodies[0].points(column::energy), scene.bodies[0].points.points(), 0.0);
    Simulation run(scene, "energy", {0.3, 0.002});
    for (int k = 0; k < steps; ++k) {
      run.step(1);
      const Columns& points = run.scene().bodies[0].points;
      for (int p = 0; p < points.points(); ++p) {
        const auto expected = strain_rates(space, l, 0, 1);
        ASSERT_NEAR(points(column::strain_rate)[p], expected[0], 1e-12);
      }
    }
    for (int d = 0; d < dim; ++d) {
      const auto before = scenes::by_id(scene.bodies[0], column::velocity, d),
                 now = scenes::by_id(run.scene().bodies[0], column::velocity, d);
      for (std::size_t p = 0; p < now.size(); ++p) ASSERT_NEAR(now[p], before[p], 1e-13);
      for (int e = 0; e < dim; ++e) {
        for (double c : scenes::by_id(run.scene().bodies[0], column::affine, d * dim + e))
          ASSERT_NEAR(c, l(d, e), 1e-12);
      }
    }
    scenes::expect_ledger_closes(run.ledger(), 1e-13);
    const Account& energy = run.ledger().energy;
    EXPECT_NEAR(energy.store(), energy.initial(), 1e-13 * energy.scale());
    EXPECT_NEAR(energy.booked(), 0, 1e-13 * energy.scale());
  }
}

// A uniform velocity, rings along their axis alone, is every scheme's exact field: no strain, and 20 steps later the same
// velocity. All but cold, so that its pressure of 1e-20 is far below rounding, and rounding is no negative energy.
void expect_translation(Scene scene, const scenes::Combination& c, const Vector& v0) {
  const double dt = 0.005;
  const int steps = 20, dim = scene.grid.dim;
  set_affine_motion(scene, v0, Matrix::Zero());
  std::fill_n(scene.bodies[0].points(column::energy), scene.bodies[0].points.points(), 1e-20);
  Simulation run(scene, c.integrator, {0.3, dt});
  for (int k = 0; k < steps; ++k) {
    run.step(1);
    const auto rates = run.scene().bodies[0].points.values(column::strain_rate);
    for (double rate : rates) ASSERT_NEAR(rate, 0, 1e-13);
  }
  for (int d = 0; d < dim; ++d) {
    const auto x0 = scenes::by_id(scene.bodies[0], column::position, d),
               x = scenes::by_id(run.scene().bodies[0], column::position, d),
               v = scenes::by_id(run.scene().bodies[0], column::velocity, d);
    for (std::size_t p = 0; p < x.size(); ++p) {
      ASSERT_NEAR(v[p], v0[d], 1e-14);
      ASSERT_NEAR(x[p], x0[p] + steps * dt * v0[d], 1e-14);
    }
  }
  scenes::expect_ledger_closes(run.ledger(), 1e-13);
  EXPECT_NEAR(run.ledger().energy.store(), run.ledger().energy.initial(), 1e-13 * run.ledger().energy.scale());
}

TEST_P(Patch, TranslationStrainsNothing) {
  const Space space = GetParam();
  const bool rings = space == Space::axisymmetric;
  const Vector v0 = in_space(Vector(rings ? 0 : 0.3, -0.2, 0.5), scenes::dim_of(space));
  for (const scenes::Combination& c : scenes::working_combinations()) {
    SCOPED_TRACE(c);
    expect_translation(scenes::rough_gas_in_space(space, c.shape, c.transfer, scenes::no_gravity), c, v0);
  }
}

// Along symmetry walls and along the axis as well: the tangential velocity is even. [EC-APIC walls]
TEST_P(Patch, TranslationAlongSymmetryWalls) {
  const Space space = GetParam();
  if (space == Space::line) return;
  for (const scenes::Combination& c : scenes::working_combinations()) {
    SCOPED_TRACE(c);
    Scene scene = scenes::rough_gas(space, c.shape, c.transfer, scenes::no_gravity);
    scene.grid.walls = scenes::walls(Wall::symmetry, Wall::symmetry, Wall::free, Wall::free, Wall::free,
                                     Wall::symmetry);
    scene.grid.origin[1] = -0.25;
    scene.grid.cells[1] = 9;
    expect_translation(std::move(scene), c, Vector(0, -0.2, 0));
  }
}

// --- forces ---------------------------------------------------------------------------------------------------------

// Even points that fill a box of `filled` cells a direction, in the middle of a larger grid, h = 1.
Scene even_gas(Space space, int per_cell, int filled, const std::string& shape, const IdealGas& gas, double shift) {
  const int dim = scenes::dim_of(space);
  GridSpec grid = scenes::box(space, {filled + 6, filled + 6, filled + 6}, 1.0);
  for (int d = 0; d < dim; ++d) grid.origin[d] = -3;
  const double off_axis = space == Space::axisymmetric ? 5 : 0;
  grid.origin[0] += off_axis;
  auto places = scenes::lattice(grid, per_cell, {3, 3, 3}, {filled + 3, filled + 3, filled + 3});
  for (auto& place : places) {
    for (int d = 0; d < dim; ++d) place[d] += shift;
  }
  Scene scene = scenes::scene_of(grid,
                                 {scenes::gas_body(gas, space, places, scenes::lattice_volume(grid, per_cell),
                                                   [](auto&) {
                                                     return scenes::GasState{2, 2.5, {0, 0, 0}};
                                                   })},
                                 shape, "apic");
  scene.density = DensityMethod::continuity;  // V_p as the scene gives them
  return scene;
}

// Points whose nodes feel nothing of the edges: four cells off, the reach of two cubic shapes.
bool inside(const Columns& points, int p, Space space, int filled) {
  for (int d = 0; d < points.components(column::position); ++d) {
    const double low = space == Space::axisymmetric && d == 0 ? 5 : 0, x = points(column::position, d)[p] - low;
    if (x < 4 || x > filled - 4) return false;
  }
  return true;
}

// Uniform stress on an even lattice, wherever it lies between the node lines: the sums of N and of grad N over it are those
// of the integrals, exactly, because the transforms of B-splines vanish, of their first moments too, at all
// multiples of the lattice's wave number (Strang-Fix). So inner nodes feel no force, and rings under pressure none either:
// sum_p A_p (r_p dN/dr + N) = integral of d(r N)/dr = 0. 1e-13 of p / (rho h) = 0.5: a thousand terms of order one.
// [York 3.17]
TEST_P(Patch, UniformStressPushesNoInnerNode) {
  const Space space = GetParam();
  const int dim = scenes::dim_of(space), filled = 9, per_cell = 2;
  const bool rings = space == Space::axisymmetric;
  IdealGas thick;
  thick.viscosity = 0.4;
  Matrix l;
  l << 0.05, -0.03, 0.02, 0.08, -0.07, -0.04, 0.01, 0.06, 0.03;
  for (const bool viscous : {false, true}) {
    if (viscous && rings) continue;  // uniform shear is no equilibrium of rings
    for (const Choice& shape : scenes::shapes_in_space()) {
      for (double shift : {0.0, 0.3}) {
        SCOPED_TRACE(shape.name);
        Scene scene = even_gas(space, per_cell, filled, shape.name, viscous ? thick : IdealGas(), shift);
        if (viscous) set_affine_motion(scene, Vector::Zero(), in_space(l, dim));
        const double dt = 0.01;
        Ledger ledger;
        const auto engine = make_engine(scene, ledger, {});
        engine->initialise();
        engine->locate_points();
        engine->map_mass_and_momentum();
        engine->evaluate_stress(NodalVelocity::start);
        const Columns before = scene.bodies[0].points;
        engine->map_forces();
        engine->advance_momentum(dt);
        engine->move_points(dt);
        const Columns& points = scene.bodies[0].points;
        int seen = 0;
        double largest = 0;
        for (int p = 0; p < points.points(); ++p) {
          for (int d = 0; d < dim; ++d) {
            const double a = (points(column::velocity, d)[p] - before(column::velocity, d)[p]) / dt;
            largest = std::max(largest, std::abs(a));
            if (inside(before, p, space, filled)) {
              EXPECT_NEAR(a, 0, scenes::terms(shape.name, dim) * 1e-13) << p << ' ' << d;
            }
          }
          seen += inside(before, p, space, filled);
        }
        EXPECT_GE(seen, 1);
        EXPECT_GT(largest, 0.1);  // the edges fly apart
      }
    }
  }
}

// Next to the axis the same sum covers half a lattice, and the midpoint rule of spacing d (in cells) leaves, for quadratic
// shapes, d^2/24 times the jump of f' for f = r dN/dr + N of node 1: 3/2, twice because of the mirror image. So the pressure
// pushes node 1, and no other, outwards by (p / rho h) (d^2/8) / (1 + 1/192 + d^2/96), where the denominator is
// the node's mass by the same rule. Lattices whose cells have the pieces' ends: 2 and 4 points a cell.
// [York 3.17] [EC-APIC walls]
TEST(PatchAtTheAxis, PressurePushesByTheLatticesQuadrature) {
  for (int per_cell : {2, 4}) {
    const GridSpec grid = scenes::box(Space::axisymmetric, {12, 14, 1}, 1.0, scenes::walls(Wall::symmetry, Wall::free));
    const auto places = scenes::lattice(grid, per_cell, {0, 2, 0}, {10, 12, 1});
    Scene scene = scenes::scene_of(
        grid,
        {scenes::gas_body({}, Space::axisymmetric, places, scenes::lattice_volume(grid, per_cell),
                          [](auto&) {
                            return scenes::GasState{2, 2.5, {0, 0, 0}};
                          })},
        "quadratic", "pic");
    scene.density = DensityMethod::continuity;
    const double dt = 0.001, d = 1.0 / per_cell;
    Simulation run(scene, "usl", {0.3, dt});
    run.step(1);
    const double a1 = 0.4 * 2.5 * (d * d / 8) / (1 + 1.0 / 192 + d * d / 96);
    const auto v = scenes::by_id(run.scene().bodies[0], column::velocity),
               w = scenes::by_id(run.scene().bodies[0], column::velocity, 1);
    const auto spline = [](double u) {
      u = std::abs(u);
      return u < 0.5 ? 0.75 - u * u : u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
    };
    for (std::size_t p = 0; p < places.size(); ++p) {
      if (places[p][0] > 6 || places[p][1] < 6 || places[p][1] > 8) continue;
      const double r = places[p][0];
      EXPECT_NEAR(v[p] / dt, a1 * (spline(r - 1) - spline(r + 1)), 1e-13) << r;
      EXPECT_NEAR(w[p] / dt, 0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace plumbline::patch_test
