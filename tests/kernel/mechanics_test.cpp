// The engine's stages: against the printed equations written out node by node, and on fields whose answer is
// exact.
#include "kernel/mechanics.hpp"
#include "kernel/transfers/transfer.hpp"

#include "tests/kernel/naive/expect.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::mechanics_test {
namespace {

// --- against the equations, [York 3.15-3.24] and [EC-APIC 1-6] ------------------------------------------------------

Scene free_membrane(int dim, const std::string& shape, const std::string& transfer) {
  UniaxialMembrane law;
  law.youngs_modulus = 2;
  law.density = 1;
  std::vector<scenes::Place> places;
  for (int k = 0; k < 9; ++k)
    places.push_back({0.113 + 0.047 * k, dim == 1 ? 0 : 0.217 + 0.03 * k + 0.1 * std::sin(0.7 * k)});
  const GridSpec grid = dim == 1 ? scenes::line(8, 0.1) : scenes::plane(8, 8, 0.1);
  Body body = scenes::membrane_body(law, dim, places, 0.01, [](const scenes::Place& x) {
    return scenes::Place{0.3 * std::sin(20 * x[0]), 0.2 * std::cos(9 * x[0])};
  });
  for (int k = 0; k < 9; ++k) body.points(column::strain)[k] = 0.05 * std::cos(2.0 * k);  // some slack, some taut
  return scenes::scene_of(grid, {std::move(body)}, shape, transfer, {1, -2});
}

void expect_like_naive(const Scene& scene, const std::string& integrator, double dt) {
  Simulation run(scene, integrator, {0.3, dt});
  NaiveStep naive(scene);
  for (int k = 0; k < 3; ++k) {
    run.step(1);
    naive.step(integrator, dt);
  }
  const Body& body = run.scene().bodies[0];
  const bool gas = body.points.has(column::energy);
  expect_points_like_naive(scene, body, naive);
  if (gas && scene.density == DensityMethod::continuity) {
    expect_column(body, naive, column::density, 0, [](const NaivePoint& p) { return p.density; });
  }
  expect_flows_like_naive(run.ledger(), naive);
  if (!gas) return;
  run.refresh_density();
  naive.refresh();
  expect_column(body, naive, column::density, 0, [](const NaivePoint& p) { return p.density; });
  expect_column(body, naive, column::pressure, 0, [](const NaivePoint& p) { return p.pressure; });
}

// Nothing pulls along the hoop of a ring.
scenes::Place gravity_in(scenes::Space space) {
  return space == scenes::Space::solid ? scenes::Place{3, -9, 5} : scenes::rough_gravity;
}

// The rings and, behind them in the order of points, their mirror images beyond the axis.
Scene with_images(const Scene& scene) {
  Scene whole = scene;
  const Columns& half = scene.bodies[0].points;
  const int n = half.points(), beyond = scene.grid.cells[0];
  whole.bodies[0] = make_body("gas", scene.bodies[0].material, 2 * n, 2, true);
  Columns& points = whole.bodies[0].points;
  for (const ColumnId* id :
       {&column::position, &column::velocity, &column::mass, &column::volume, &column::density, &column::energy}) {
    for (int d = 0; d < points.components(*id); ++d) {
      const bool odd = d == 0 && (id == &column::position || id == &column::velocity);
      for (int p = 0; p < n; ++p) {
        points(*id, d)[p] = half(*id, d)[p];
        points(*id, d)[p + n] = (odd ? -1 : 1) * half(*id, d)[p];
      }
    }
  }
  whole.grid.walls = scenes::walls_everywhere(Wall::free);
  whole.grid.origin[0] = -beyond * scene.grid.h;
  whole.grid.cells[0] = 2 * beyond;
  return whole;
}

// Whether pressures can act at the nodes.
bool flows(const std::string& shape) { return shape_named(shape).flows; }

class EveryCombination : public testing::TestWithParam<std::string> {};

TEST_P(EveryCombination, StepsAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam()) continue;
    SCOPED_TRACE(testing::Message() << c);
    for (scenes::Space space : scenes::spaces) {
      SCOPED_TRACE(space);
      for (const IdealGas& gas : {scenes::rough_law(), scenes::inviscid_law()}) {
        expect_like_naive(scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space), gas), c.integrator,
                          0.01);
      }
    }
    for (int dim : {1, 2}) expect_like_naive(free_membrane(dim, c.shape, c.transfer), c.integrator, 0.01);
  }
}

// The same for every elastic law: their forces, strains and energies, and boxes that follow the deformation.
// [Hooke 1] [Neo-Hookean 1, 2] [Segments 1, 2] [GIMP 1, 2] [Midpoint 1-4] [XPIC 1] [FMPM 1]
TEST_P(EveryCombination, SolidsStepAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam()) continue;
    for (scenes::Law law : scenes::laws) {
      for (scenes::Space space : scenes::spaces) {
        if (!scenes::lives_in(law, space)) continue;
        SCOPED_TRACE(testing::Message() << c << ", " << law << ", " << space);
        Scene scene = scenes::rough_solid(law,
                                          scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space)));
        scene.transfer_order = 3;
        expect_like_naive(scene, c.integrator, 0.01);
      }
    }
  }
}

// And where the points of a cell share their dilatation. [Dilatation 1-4]
TEST_P(EveryCombination, SolidsThatHardlyCompressStepAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam() || c.transfer != "apic" || (c.shape != "quadratic" && c.shape != "cpdi")) continue;
    for (scenes::Law law : {scenes::Law::hooke, scenes::Law::neo_hookean}) {
      for (scenes::Space space : scenes::spaces) {
        SCOPED_TRACE(testing::Message() << c << ", " << law << ", " << space);
        Scene scene = scenes::rough_solid(law,
                                          scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space)));
        scenes::let_hardly_compress(scene);
        expect_like_naive(scene, c.integrator, 0.01);
      }
    }
  }
}

TEST_P(EveryCombination, ContinuityDensityStepsAsThePrintedEquationsSay) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const char* transfer : {"pic", "apic"}) {
      for (scenes::Space space : scenes::spaces) {
        for (const IdealGas& gas : {scenes::rough_law(), scenes::inviscid_law()}) {
          Scene scene = scenes::rough_gas_in_space(space, shape, transfer, gravity_in(space), gas);
          scene.density = DensityMethod::continuity;
          expect_like_naive(scene, GetParam(), 0.01);
        }
      }
    }
  }
}

// The same through sharpened nodes and, where a step ends with heat, with heat exchanged; once with less sharpening where the gas
// expands, of transfers that leave points velocities of their own: with the others nodes that only one point reaches move alike, and
// the sign of a slope that is zero but for rounding decides how much is kept there. [Sharpening 1] [Limiter 2] [Exchange 1]
TEST_P(EveryCombination, SharpenedStepsAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam()) continue;
    SCOPED_TRACE(testing::Message() << c);
    for (scenes::Space space : scenes::spaces) {
      for (const double in_expansion : {1.0, 0.25}) {
        if (in_expansion < 1 && c.transfer != "apic" && c.transfer != "flip") continue;
        SCOPED_TRACE(testing::Message() << space << ", " << in_expansion);
        Scene scene = scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space));
        scene.sharpening = 0.75;
        scene.sharpening_second = 0.5;
        scene.sharpening_third = 2;
        scene.sharpening_in_expansion = in_expansion;
        scene.sharpened_motion = scene.sharpened_density = true;
        scene.heat_exchange = 2;
        expect_like_naive(scene, c.integrator, 0.01);
      }
    }
  }
}

// The same where the nodes leave points a part of what the grid does not carry, and viscosity spares linear flow; once with
// rates that leave much and once with those that take all somewhere. [Filter 1] [Limiter 1]
TEST_P(EveryCombination, FilteredStepsAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam() || c.transfer != "apic") continue;
    SCOPED_TRACE(testing::Message() << c);
    for (scenes::Space space : scenes::spaces) {
      for (const double rate : {0.1, 3.0}) {
        SCOPED_TRACE(space);
        IdealGas gas = scenes::rough_law();
        gas.limits_viscosity = true;
        Scene scene = scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space), gas);
        scene.filter = {rate, 2 * rate};
        scene.sharpening = 0.75;
        scene.sharpened_motion = scene.sharpened_density = true;
        scene.heat_exchange = 2;
        expect_like_naive(scene, c.integrator, 0.01);
      }
    }
  }
}

// The same with pressures at the nodes, of uneven masses: nodes at free edges, and some inside, take less than their shares of
// what presses on a face. [Pressure 1-4]
TEST_P(EveryCombination, NodalPressuresStepAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam() || !flows(c.shape)) continue;
    SCOPED_TRACE(testing::Message() << c);
    for (scenes::Space space : {scenes::Space::line, scenes::Space::plane, scenes::Space::solid}) {
      SCOPED_TRACE(space);
      Scene scene = scenes::rough_gas_in_space(space, c.shape, c.transfer, gravity_in(space), scenes::inviscid_law());
      for (int p = 0; p < scene.bodies[0].points.points(); p += 3) scene.bodies[0].points(column::mass)[p] *= 20;
      scene.nodal_pressure = scene.sharpened_motion = true;
      scene.sharpening = 0.75;
      if (c.transfer == "apic") scene.filter = {0.1, 0.2};
      expect_like_naive(scene, c.integrator, 0.01);
    }
  }
}

// A gas of pressures that differ by a tenth, on irregular points of uneven masses, wide enough for nodes whose reach is all gas.
Scene even_gas(scenes::Space space, const std::string& shape, const std::string& transfer) {
  const int cells = space == scenes::Space::solid ? 9 : 13, per_cell = space == scenes::Space::solid ? 1 : 2;
  GridSpec grid = scenes::box(space, {cells, cells, cells}, 0.1);
  const std::vector<scenes::Place> places = scenes::jittered(
      scenes::lattice(grid, per_cell, {1, 1, 1}, {cells - 1, cells - 1, cells - 1}), 0.02, grid.dim);
  for (int d = 0; d < grid.dim; ++d) grid.origin[d] = -0.05;  // no node at an edge is all but massless
  Body body = scenes::gas_body(
      scenes::inviscid_law(), space, places, scenes::lattice_volume(grid, per_cell), [](const scenes::Place& x) {
        const double wave = std::sin(5 * x[0] + 3 * x[1] - 4 * x[2]);
        return scenes::GasState{
            1 + 0.1 * wave, 2 - 0.1 * wave, {0.2 * std::cos(4 * x[1]), 0.3 * std::sin(6 * x[0]), 0.1 * x[0]}};
      });
  Scene scene = scenes::scene_of(grid, {std::move(body)}, shape, transfer, gravity_in(space));
  scene.quadrature = 1;
  return scene;
}

// [Quadrature 1-4]
TEST_P(EveryCombination, CorrectedSumsStepAsThePrintedEquationsSay) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    const bool spline = c.shape == "linear" || c.shape == "quadratic" || c.shape == "cubic";
    if (c.integrator != GetParam() || !spline) continue;
    SCOPED_TRACE(testing::Message() << c);
    Scene scene = even_gas(scenes::Space::plane, c.shape, c.transfer);
    scene.sharpened_motion = scene.sharpened_density = true;
    scene.sharpening = 0.75;
    if (c.transfer == "apic") scene.filter = {0.1, 0.2};
    expect_like_naive(scene, c.integrator, 0.01);
  }
}
TEST(Mechanics, CorrectedSumsStepInSpaceAsThePrintedEquationsSay) {
  expect_like_naive(even_gas(scenes::Space::solid, "cubic", "apic"), "leapfrog", 0.01);
}

// The axis of rings is a mirror: with the images of all rings at negative radii the printed equations need no wall.
// [EC-APIC walls]
TEST_P(EveryCombination, TheAxisIsAMirror) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (c.integrator != GetParam()) continue;
    SCOPED_TRACE(testing::Message() << c);
    Scene scene = scenes::rough_gas(scenes::Space::axisymmetric, c.shape, c.transfer, {0, -9});
    scene.grid.walls = scenes::walls(Wall::symmetry, Wall::free);
    scene.grid.origin[1] = -0.25;
    scene.grid.cells = {8, 9, 1};
    scene.heat_exchange = 1;
    // Linear shapes and boxes throw the light nodes of free edges about as it is, until an energy is negative.
    const bool smooth = c.shape == "quadratic" || c.shape == "cubic";
    if (smooth) {
      scene.sharpening = 1;
      scene.sharpened_motion = scene.sharpened_density = true;
      scene.filter = {1, 2};
    }
    constexpr double dt = 0.008;  // in which no ring passes the axis, where images change places
    Simulation run(scene, c.integrator, {0.3, dt});
    NaiveStep naive(with_images(scene));
    for (int k = 0; k < (smooth ? 3 : 1); ++k) {
      run.step(1);
      naive.step(c.integrator, dt);
    }
    expect_points_like_naive(scene, run.scene().bodies[0], naive);
    const Account& energy = run.ledger().energy;
    EXPECT_NEAR(energy.flow(Flow::body_force), naive.body_work / 2, 1e-13 * energy.scale());
    EXPECT_NEAR(energy.flow(Flow::transfer), naive.transfer / 2, 1e-13 * energy.scale());
    EXPECT_NEAR(energy.flow(Flow::integration), naive.integration / 2, 1e-13 * energy.scale());
    EXPECT_NEAR(energy.flow(Flow::constitutive), naive.constitutive / 2, 1e-13 * energy.scale());
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, EveryCombination,
                         testing::Values("usf", "usl", "musl", "usavg", "midpoint", "energy", "leapfrog"),
                         [](const auto& chosen) { return chosen.param; });

// --- walls ----------------------------------------------------------------------------------------------------------

// A domain cut at its planes of symmetry is the whole domain: same points, same step, differences of rounding
// only. Rings have their axis as a wall in both, and are cut across it.
struct Cut {
  Scene part, whole;
  double share;
};

Cut cut_scene(scenes::Space space, double viscosity) {
  const double h = 0.125;
  const int dim = scenes::dim_of(space), first = space == scenes::Space::axisymmetric ? 1 : 0;
  // In space two cells are filled: every shape of a point in them reaches nodes beyond a wall, and those of the free side.
  const int filled = dim == 3 ? 2 : 4, cells = filled + 2;
  GridSpec part = scenes::box(space, {cells, cells, cells}, h);
  for (int d = 0; d < dim; ++d) part.walls[d][0] = Wall::symmetry;
  GridSpec whole = part;
  for (int d = first; d < dim; ++d) {
    whole.walls[d][0] = Wall::free;
    whole.origin[d] = -cells * h;
    whole.cells[d] = 2 * cells;
  }
  const auto places = scenes::jittered(scenes::lattice(part, 2, {0, 0, 0}, {filled, filled, filled}), 0.02, dim);
  std::vector<scenes::GasState> states;
  scenes::Random random(5);
  for (std::size_t p = 0; p < places.size(); ++p) {
    states.push_back({random(0.5, 1.5), random(1, 2), {random(-0.3, 0.3), random(-0.3, 0.3), random(-0.3, 0.3)}});
  }
  std::vector<scenes::Place> all;
  std::vector<scenes::GasState> all_states;
  const int images = 1 << (dim - first);
  for (int mirror = 0; mirror < images; ++mirror) {
    for (std::size_t p = 0; p < places.size(); ++p) {
      all.push_back(places[p]);
      all_states.push_back(states[p]);
      for (int d = first; d < dim; ++d) {
        const double sign = mirror >> (d - first) & 1 ? -1 : 1;
        all.back()[d] *= sign;
        all_states.back().velocity[d] *= sign;
      }
    }
  }
  IdealGas gas = scenes::rough_law();
  gas.viscosity = viscosity;
  const double volume = scenes::lattice_volume(part, 2);
  const auto scene = [&](const GridSpec& grid, const auto& where, const auto& what) {
    std::size_t k = 0;
    return scenes::scene_of(grid, {scenes::gas_body(gas, space, where, volume, [&](auto&) { return what[k++]; })},
                            "quadratic", "apic");
  };
  return {scene(part, places, states), scene(whole, all, all_states), 1.0 / images};
}

class EverySpace : public testing::TestWithParam<scenes::Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, EverySpace, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

// Four steps of both, with the choices that the parts have.
void expect_mirrored(const Cut& cut, const std::string& integrator) {
  Simulation one(cut.part, integrator, {0.3, 0.01}), other(cut.whole, integrator, {0.3, 0.01});
  for (int step = 0; step < 4; ++step) {
    one.step(1);
    other.step(1);
  }
  one.refresh_density();
  other.refresh_density();
  for (const ColumnId* id :
       {&column::position, &column::velocity, &column::energy, &column::density, &column::stress}) {
    for (int d = 0; d < one.scene().bodies[0].points.components(*id); ++d) {
      const auto a = scenes::by_id(one.scene().bodies[0], *id, d), b = scenes::by_id(other.scene().bodies[0], *id, d);
      for (std::size_t p = 0; p < a.size(); ++p) ASSERT_NEAR(a[p], b[p], 1e-12) << id->name() << d << ' ' << p;
    }
  }
  // Four steps' stores of the part are its share of the whole's.
  const Account &part = one.ledger().energy, &whole = other.ledger().energy;
  EXPECT_NEAR(part.store(), cut.share * whole.store(), 1e-13);
  EXPECT_NEAR(part.flow(Flow::transfer), cut.share * whole.flow(Flow::transfer), 1e-13);
}

TEST_P(EverySpace, ASymmetryWallIsAMirror) {
  Cut cut = cut_scene(GetParam(), 0.005);
  for (const scenes::Combination& c : scenes::working_combinations()) {
    SCOPED_TRACE(c);
    for (DensityMethod density : {DensityMethod::cell, DensityMethod::quadratic, DensityMethod::grid}) {
      cut.part.shape = cut.whole.shape = c.shape;
      cut.part.transfer = cut.whole.transfer = c.transfer;
      cut.part.density = cut.whole.density = density;
      expect_mirrored(cut, c.integrator);
    }
  }
}

// [Pressure 2-4]
TEST_P(EverySpace, ASymmetryWallIsAMirrorOfNodalPressures) {
  Cut cut = cut_scene(GetParam(), 0);
  for (const scenes::Combination& c : scenes::working_combinations()) {
    if (!flows(c.shape)) continue;
    SCOPED_TRACE(c);
    for (Scene* scene : {&cut.part, &cut.whole}) {
      scene->shape = c.shape;
      scene->transfer = c.transfer;
      scene->nodal_pressure = scene->sharpened_motion = true;
      scene->sharpening = 0.5;
    }
    expect_mirrored(cut, c.integrator);
  }
}

// [Quadrature 1-3]
TEST(Mechanics, ASymmetryWallIsAMirrorOfCorrectedSums) {
  for (scenes::Space space : {scenes::Space::plane, scenes::Space::solid}) {
    Cut cut = cut_scene(space, 0);
    for (const char* shape : {"quadratic", "cubic"}) {
      SCOPED_TRACE(testing::Message() << shape);
      for (Scene* scene : {&cut.part, &cut.whole}) {
        scene->shape = shape;
        scene->quadrature = 1;
        scene->sharpening = 0.5;
        scene->sharpened_density = true;
      }
      expect_mirrored(cut, "leapfrog");
    }
  }
}

// What walls give is booked, and energy closes. [Quadrature 2, 3]
TEST(Mechanics, LedgersOfCorrectedSumsClose) {
  for (scenes::Space space : {scenes::Space::plane, scenes::Space::solid}) {
    for (const char* integrator : {"leapfrog", "energy", "midpoint"}) {
      SCOPED_TRACE(testing::Message() << space << ", " << integrator);
      Scene scene = even_gas(space, "cubic", "apic");
      for (int d = 0; d < scene.grid.dim; ++d) scene.grid.origin[d] = 0.05;  // walls half a cell before the gas
      scene.grid.walls = scenes::walls(Wall::symmetry, Wall::free, Wall::symmetry, Wall::free);
      scene.sharpening = 1;
      scene.filter = {1, 2};
      Simulation run(scene, integrator, {0.3, 0.005});
      for (int step = 0; step < 5; ++step) run.step(1);
      scenes::expect_ledger_closes(run.ledger(), 1e-13);
    }
  }
}

// A gas at rest between walls that is moved by a millionth of its speed of sound: over 300 h/c sums over points as they are make
// waves of shear grow, in the plane and in space; corrected, nothing moves faster than it was moved. [Quadrature 2]
TEST(Mechanics, AGasAtRestStaysAtRestByCorrectedSums) {
  for (scenes::Space space : {scenes::Space::plane, scenes::Space::solid}) {
    const GridSpec grid = scenes::box(space, {6, 6, 6}, 1, scenes::walls_everywhere(Wall::symmetry));
    scenes::Random random(7);
    const auto v = [&] { return random(-1e-6, 1e-6); };
    const auto moved = [&](const scenes::Place&) { return scenes::GasState{1, 1 / 0.56, {v(), v(), v()}}; };  // c = 1
    Scene scene = scenes::scene_of(grid,
                                   {scenes::gas_body(scenes::inviscid_law(), space, scenes::lattice(grid, 2),
                                                     scenes::lattice_volume(grid, 2), moved)},
                                   "cubic", "apic");
    scene.sharpening = 1;
    scene.sharpened_motion = scene.sharpened_density = true;
    scene.filter = {2, 4};
    const auto fastest = [&](double evenness) {
      scene.quadrature = evenness;
      Simulation run(scene, "leapfrog", {0.5, 0.4});
      for (int step = 0; step < 750; ++step) run.step(1);
      double most = 0;
      for (const double u : run.scene().bodies[0].points.values(column::velocity)) most = std::max(most, std::abs(u));
      return most;
    };
    const double corrected = fastest(0.1);
    EXPECT_LT(corrected, 1e-6) << space;
    EXPECT_GT(fastest(0), 1000 * corrected) << space;
  }
}

// What walls of either kind give is booked, and energy closes. [Pressure 2, 3]
TEST_P(EverySpace, LedgersOfNodalPressuresClose) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const char* integrator : {"leapfrog", "energy", "midpoint"}) {
      SCOPED_TRACE(testing::Message() << shape << ", " << integrator);
      Scene scene = scenes::rough_gas(GetParam(), shape, "apic", scenes::rough_gravity, scenes::inviscid_law());
      scene.nodal_pressure = scene.sharpened_motion = true;
      scene.sharpening = 1;
      scene.filter = {1, 2};
      Simulation run(scene, integrator, {0.3, 0.005});
      for (int step = 0; step < 5; ++step) run.step(1);
      scenes::expect_ledger_closes(run.ledger(), 1e-13);
    }
  }
}

// Gas of pressure 1 at rest against one wall, free on the other side: from the first step on the wall pushes
// with p per area, and nothing else changes the gas's momentum along it. With four even points a cell the sum over
// points integrates the gradients of linear and quadratic shapes exactly (midpoint rule on linear pieces), and the radius
// over the bottom of a cylinder. [York 3.17] [EC-APIC walls]
TEST_P(EverySpace, AWallPushesWithThePressure) {
  const scenes::Space space = GetParam();
  const int dim = scenes::dim_of(space), along = space == scenes::Space::axisymmetric ? 1 : 0;
  const auto gas_at_rest = [](auto&) { return scenes::GasState{1, 2.5, {0, 0, 0}}; };  // p = 0.4 x 2.5
  const double dt = 1e-3, h = 0.5;
  std::array<int, 3> cells{3, 3, 2}, filled = cells;
  cells[static_cast<std::size_t>(along)] = 6;
  filled[static_cast<std::size_t>(along)] = 4;
  const double area = dim == 1 ? 1 : dim == 3 ? 6 * h * h : along == 1 ? 1.5 * 1.5 / 2 : 3 * h;
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    for (const char* shape : {"linear", "quadratic"}) {
      for (const Choice& transfer : transfers()) {
        if (transfer.name == "fmpm") continue;  // what it filters a wall has bent
        GridSpec grid = scenes::box(space, cells, h, scenes::walls_everywhere(Wall::symmetry));
        grid.walls[static_cast<std::size_t>(along)] = {kind, Wall::free};
        Scene scene = scenes::scene_of(grid,
                                       {scenes::gas_body({}, space, scenes::lattice(grid, 4, {0, 0, 0}, filled),
                                                         scenes::lattice_volume(grid, 4), gas_at_rest)},
                                       shape, transfer.name);
        scene.density = DensityMethod::continuity;
        Simulation run(scene, "usl", {0.3, dt});
        run.step(1);
        const Account& momentum = run.ledger().momentum[static_cast<std::size_t>(along)];
        EXPECT_NEAR(momentum.flow(Flow::walls), dt * area, 2e-15);
        EXPECT_NEAR(momentum.store(), dt * area, 2e-15);
        for (int d = 0; d < dim; ++d) {
          if (d == along || (d == 0 && grid.axisymmetric)) continue;
          EXPECT_NEAR(run.ledger().momentum[static_cast<std::size_t>(d)].flow(Flow::walls), 0, 2e-15);
        }
      }
    }
  }
}

// A point that stands on a wall stays there, however hard the gas pushes; on an edge it stays on both walls, in a corner
// on all three. [EC-APIC walls]
TEST_P(EverySpace, PointsOnAWallStayOnIt) {
  const scenes::Space space = GetParam();
  const int dim = scenes::dim_of(space);
  for (const scenes::Combination& c : scenes::working_combinations()) {
    for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
      Scene scene = scenes::rough_gas(space, c.shape, c.transfer);
      scene.grid.walls = scenes::walls(kind, Wall::symmetry, kind, Wall::free, Wall::free, kind);
      const int first = space == scenes::Space::axisymmetric ? 1 : 0;  // no ring lies on the axis: it has no mass
      const double at[3] = {0, 0, 0.4};
      Columns& points = scene.bodies[0].points;
      int on_walls[4] = {0, 0, 0, 0};
      for (int p = 0; p < points.points(); ++p) {
        int on = 0;
        for (int d = first; d < dim; ++d) {
          double& x = points(column::position, d)[p];
          if (std::abs(x - at[d]) >= (dim == 3 ? 0.05 : 0.03)) continue;
          x = at[d];
          ++on;
          // A leapfrog moves points before it looks at walls: those on one have what velocity it lets them have.
          if (c.integrator != "leapfrog") continue;
          for (int e = 0; e < dim; ++e) {
            if (e == d || scene.grid.walls[static_cast<std::size_t>(d)][at[d] > 0] == Wall::no_slip) {
              points(column::velocity, e)[p] = 0;
            }
          }
        }
        ++on_walls[on];
      }
      for (int on = 1; on <= dim - first; ++on) ASSERT_GT(on_walls[on], 0) << on;
      Simulation run(scene, c.integrator, {0.2, {}});
      for (int k = 0; k < 3; ++k) run.step(1);
      for (int d = first; d < dim; ++d) {
        const auto before = scenes::by_id(scene.bodies[0], column::position, d),
                   x = scenes::by_id(run.scene().bodies[0], column::position, d);
        for (std::size_t p = 0; p < x.size(); ++p) {
          if (before[p] == at[d]) {
            EXPECT_NEAR(x[p], at[d], 1e-16) << c << ' ' << d;
          }
        }
      }
    }
  }
}

// --- the step limit -------------------------------------------------------------------------------------------------

// h / max(c_p + |v_p|) over all bodies; h^2 / (2 d 4/3 mu / rho) where the gas is thick; for Courant number 1.
TEST(Mechanics, StepLimit) {
  for (int dim : {1, 2, 3}) {
    const GridSpec grid = scenes::box(scenes::space_of(dim), {6, 6, 6}, 0.25);
    const auto places = scenes::lattice(grid, 2, {1, 1, 1}, {4, 4, 4});
    const auto limit_with = [&](double mu, bool with_membrane) {
      IdealGas gas;
      gas.viscosity = mu;
      Scene scene = scenes::scene_of(grid,
                                     {scenes::gas_body(gas, dim, places, scenes::lattice_volume(grid, 2),
                                                       [&](const scenes::Place& x) {
                                                         scenes::GasState state{2, 3, {0, 0}};
                                                         if (x == places[3]) state.velocity = {-0.7, 0};
                                                         return state;
                                                       })},
                                     "quadratic", "apic");
      scene.density = DensityMethod::continuity;
      UniaxialMembrane law;
      law.youngs_modulus = 36;
      law.density = 4;
      if (with_membrane) scene.bodies.push_back(scenes::membrane_body(law, dim, {{0.3, 0.3}, {0.4, 0.4}}, 1e-3));
      Ledger ledger;
      const auto engine = make_engine(scene, ledger, {});
      engine->initialise();
      return engine->step_limit();
    };
    EXPECT_NEAR(limit_with(0, false), 0.25 / (std::sqrt(1.68) + 0.7), 1e-15);
    EXPECT_NEAR(limit_with(0.9, false), 0.0625 * 2 / (2 * dim * 4.0 / 3 * 0.9), 1e-15);
    if (dim == 3) continue;  // chains live on lines and in planes
    EXPECT_NEAR(limit_with(0, true), 0.25 / 3, 1e-15);
    EXPECT_NEAR(limit_with(0.9, true), 0.0625 * 2 / (2 * dim * 4.0 / 3 * 0.9), 1e-15);
    EXPECT_NEAR(limit_with(1e-3, false), 0.25 / (std::sqrt(1.68) + 0.7), 1e-15);
  }
}

TEST(Mechanics, RefusesPressuresAtTheNodesOfShapesWhoseIntegralsAreNotKnown) {
  Ledger ledger;
  Scene scene = scenes::rough_gas(2, "gimp", "flip");
  EXPECT_NO_THROW(make_engine(scene, ledger, {}));
  scene.nodal_pressure = true;
  EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
}

TEST(Mechanics, RefusesWhatItDoesNotHave) {
  Ledger ledger;
  Scene scene = scenes::rough_gas(1, "quintic", "flip");
  EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
  scene.shape = "linear";
  scene.transfer = "tpic";
  EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
  scene.transfer = "pic";
  EXPECT_NO_THROW(make_engine(scene, ledger, {}));
  for (int dim : {0, 4}) {
    scene.grid.dim = dim;
    EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
  }
  scene.grid.axisymmetric = true;
  for (int dim : {1, 3}) {
    scene.grid.dim = dim;
    EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
  }
}

// Points made for another geometry, or for another law, have other columns.
TEST(Mechanics, RefusesPointsOfAnotherGeometry) {
  Ledger ledger;
  for (scenes::Space made : scenes::spaces) {
    for (scenes::Space space : scenes::spaces) {
      Scene scene = scenes::rough_gas(space, "quadratic", "apic");
      scene.bodies[0] = scenes::rough_gas(made, "quadratic", "apic").bodies[0];
      if (made == space) {
        EXPECT_NO_THROW(make_engine(scene, ledger, {}));
      } else {
        EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument) << made << " in " << space;
      }
    }
  }
  Scene scene = scenes::rough_gas(2, "quadratic", "apic");
  scene.bodies[0].material = std::make_shared<IdealGas>();
  EXPECT_THROW(make_engine(scene, ledger, {}), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::mechanics_test
