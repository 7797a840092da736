// Tangents that a scene gives its membranes. [York 7.1] [Circle 1-3]
#include "kernel/normals/membrane_tangents.hpp"

#include <numbers>

#include "tests/kernel/coupled_scenes.hpp"

namespace plumbline::membrane_tangents_test {
namespace {

using scenes::Place;
using scenes::Skin;
using scenes::Space;
constexpr double h = 0.1, radius = 0.47, centre = 0.83;

// A ring under tension, with the gas inside it that colours want.
Scene ring(Skin skin = Skin::uniaxial, int count = 120) {
  std::vector<Place> places, inside;
  for (int k = 0; k < count; ++k) {
    const double a = 2 * std::numbers::pi * k / count;
    places.push_back({centre + radius * std::cos(a), centre + radius * std::sin(a), 0});
  }
  const GridSpec grid = scenes::plane(17, 17, h);
  for (const Place& place : scenes::lattice(grid, 4)) {
    if (std::hypot(place[0] - centre, place[1] - centre) < radius - 0.01) inside.push_back(place);
  }
  Body membrane = scenes::skin_body(skin, Space::plane, places, 0.02 * 2 * std::numbers::pi * radius / count);
  if (membrane.points.has(column::strain)) std::fill_n(membrane.points(column::strain), count, 0.1);
  auto law = std::make_shared<UniaxialMembrane>();
  law->youngs_modulus = 1.5;
  law->density = 1;
  law->closed = true;
  if (skin == Skin::uniaxial) membrane.material = law;
  Body gas = scenes::gas_body(scenes::inviscid_law(), 2, inside, h * h / 16, [](auto&) {
    return scenes::GasState{1, 1, {0, 0, 0}};
  });
  return scenes::scene_of(grid, {std::move(gas), std::move(membrane)}, "quadratic", "apic");
}

// How far the tangents of a body are off those of the circle, and their stresses off E eps t t, as sines.
struct Misses {
  double tangent = 0, stress = 0;
};
Misses misses(const Body& body) {
  Misses m;
  for (int p = 0; p < body.points.points(); ++p) {
    const double x = body.points(column::position)[p] - centre, y = body.points(column::position, 1)[p] - centre;
    const double tx = body.points(column::tangent)[p], ty = body.points(column::tangent, 1)[p];
    EXPECT_NEAR(tx * tx + ty * ty, 1, 1e-14);
    m.tangent = std::max(m.tangent, std::abs(tx * x + ty * y) / std::hypot(x, y));
    const double tension = 1.5 * body.points(column::strain)[p];
    const double stress[] = {tension * tx * tx, tension * ty * ty, tension * tx * ty};
    for (int k = 0; k < 3; ++k) m.stress = std::max(m.stress, std::abs(body.points(column::stress, k)[p] - stress[k]));
  }
  return m;
}

// On a circle points have the circle's tangents from the start, and so the stress along them: a fitted circle is exact,
// to the rounding of its sums of some tens of points over the few hundredths of h^2 that they spread. Stress and
// tangent are of one instant. [York 5.5]
TEST(MembraneTangents, OfAFittedCircleAreTheCircles) {
  for (const char* integrator : {"leapfrog", "musl"}) {
    Scene scene = ring();
    scene.normals = "modern";
    if (std::string(integrator) == "musl") scene.transfer = "flip";
    Simulation run(scene, integrator, {0.3, 1e-3});
    const Misses start = misses(run.scene().bodies[1]);
    EXPECT_LE(start.tangent, 1e-11);
    EXPECT_LE(start.stress, 1e-15);
    for (int k = 0; k < 5; ++k) run.step(1);
    // The gas blows it up by p / (rho t) t^2 / 2 = 2.5e-4 meanwhile, not quite evenly: over a cell that is an angle of
    // 2.5e-3.
    EXPECT_LE(misses(run.scene().bodies[1]).tangent, 2.5e-3);
    scenes::expect_ledger_closes(run.ledger(), 1e-12);
  }
}

// Every method gives them in the engine what it gives by itself, with the gas where it wants colour. What connectivity
// says is exact on even points.
TEST(MembraneTangents, OfAllMethodsAreAcrossTheirNormals) {
  for (const Choice& method : normals_methods()) {
    Scene scene = ring();
    scene.normals = method.name;
    const Simulation run(scene, "leapfrog", {0.3, 1e-3});
    const Body& membrane = run.scene().bodies[1];
    if (method.name == "connectivity") {
      EXPECT_LE(misses(membrane).tangent, 1e-14);
      continue;
    }
    const Scene still = ring();
    const auto x = scenes::by_id(still.bodies[1], column::position),
               y = scenes::by_id(still.bodies[1], column::position, 1),
               gas_x = scenes::by_id(still.bodies[0], column::position),
               gas_y = scenes::by_id(still.bodies[0], column::position, 1);
    std::vector<double> nx(x.size(), 0.0), ny(x.size(), 0.0);
    const bool colours = method.name == "york-simple" || method.name == "york-quadratic" || method.name == "york-cubic";
    NormalsInput input{still.grid, x, y, {}, {}, {}, {}};
    if (colours) {
      input.other_x = gas_x;
      input.other_y = gas_y;
    }
    make_normals(method.name)->find(input, nx, ny);
    const auto tx = scenes::by_id(membrane, column::tangent), ty = scenes::by_id(membrane, column::tangent, 1);
    for (std::size_t p = 0; p < x.size(); ++p) {
      EXPECT_NEAR(std::abs(tx[p] * nx[p] + ty[p] * ny[p]), 0, 1e-11) << method.name << ' ' << p;
    }
  }
}

// A run with fitted tangents goes as one with connectivity: the ring stays even, and its pull is 2e-2 of the gas's
// pressure.
TEST(MembraneTangents, OfACircleGoOnLikeConnectivity) {
  std::vector<double> x[2];
  for (const int k : {0, 1}) {
    Scene scene = ring();
    if (k) scene.normals = "modern";
    Simulation run(scene, "leapfrog", {0.3, 1e-3});
    for (int step = 0; step < 10; ++step) run.step(1);
    x[k] = scenes::by_id(run.scene().bodies[1], column::velocity);
  }
  double largest = 0;
  for (double v : x[0]) largest = std::max(largest, std::abs(v));
  EXPECT_GT(largest, 1e-4);
  for (std::size_t p = 0; p < x[0].size(); ++p) EXPECT_NEAR(x[1][p], x[0][p], 1e-3 * largest);
}

// With the default nothing is given, and to bodies that have no tangents no method does anything.
TEST(MembraneTangents, ConnectivityAndSegmentsStayAsTheyAre) {
  EXPECT_FALSE(MembraneTangents::given_by("connectivity"));
  EXPECT_TRUE(MembraneTangents::given_by("modern"));
  Scene scene = ring();
  std::vector<Body> bodies = scene.bodies;
  MembraneTangents("connectivity").find(scene.grid, bodies);
  for (std::size_t b = 0; b < 2; ++b) EXPECT_TRUE(scenes::same_bits(bodies[b], scene.bodies[b]));
  for (const char* method : {"modern", "york-cubic"}) {
    Scene plain = ring(Skin::closed_segments), keyed = plain;
    keyed.normals = method;
    Simulation run(plain, "leapfrog", {0.3, 1e-3}), other(keyed, "leapfrog", {0.3, 1e-3});
    for (int k = 0; k < 5; ++k) {
      run.step(1);
      other.step(1);
    }
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_TRUE(scenes::same_bits(run.scene().bodies[b], other.scene().bodies[b])) << method;
    }
    scenes::expect_same_ledger(run.ledger(), other.ledger());
  }
}

// A point by itself has no direction, and then no stress.
TEST(MembraneTangents, WithoutADirectionThereIsNoStress) {
  Scene scene = ring(Skin::uniaxial, 1);
  scene.normals = "modern";
  const Simulation run(scene, "leapfrog", {0.3, 1e-3});
  const Columns& points = run.scene().bodies[1].points;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(points(column::stress, k)[0], 0);
}

// On a line there is one direction, whatever is asked for.
TEST(MembraneTangents, OnALineNothingIsToBeFound) {
  Scene scene = scenes::gas_and_skin(Skin::uniaxial, Space::line, "quadratic", "apic", true), keyed = scene;
  keyed.normals = "modern";
  Simulation run(scene, "leapfrog", {0.3, 1e-3}), other(keyed, "leapfrog", {0.3, 1e-3});
  run.step(1);
  other.step(1);
  EXPECT_TRUE(scenes::same_bits(run.scene().bodies[1], other.scene().bodies[1]));
}

TEST(MembraneTangents, UnknownNamesThrow) {
  EXPECT_THROW(MembraneTangents("by-eye"), std::invalid_argument);
  Scene scene = ring();
  scene.normals = "by-eye";
  EXPECT_THROW(Simulation(scene, "leapfrog", {0.3, 1e-3}), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::membrane_tangents_test
