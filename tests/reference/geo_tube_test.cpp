// The tube of liquid on a floor: balances of forces on every part, limits of gas and of a puddle, elastic membranes.
#include "reference/geo_tube.hpp"

#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::geo_tube_test {
namespace {

const GeoTubeProblem problems[] = {{},
                                   {4, 9810, 1e-2, 0},
                                   {0.3, 9810, 9e4, 0},
                                   {9, 12000, 35000, 1e-6},
                                   {4, 9810, 2000, 4e-5},
                                   {1, 0, 500, 0},
                                   {1, 0, 500, 1e-3},
                                   {2, 1e-7, 3, 0.02}};

TEST(GeoTube, ForcesBalance) {
  for (const GeoTubeProblem& p : problems) {
    const GeoTube tube(p);
    const Bounded H = tube.height(), w = p.specific_weight, top = p.top_pressure, bottom = tube.bottom_pressure();
    // half a tube: floor and top pull it with T each, the pressure on the other half pushes
    const Bounded push = top * H + Bounded(0.5) * w * H * H;
    expect_zero(Bounded(2) * tube.tension() - push, push.value, "half");
    expect_zero(bottom - top - w * H, bottom.value, "depth");
    expect_zero(bottom * tube.contact_width() - w * tube.area(), bottom.value * tube.width().value,
                "floor carries the liquid");
  }
}

// From the floor to a point: across, T (1 - cos) is the pressure over its height; upwards, T sin is the pressure over
// what overhangs, which is the liquid column of its width less the liquid enclosed.
TEST(GeoTube, EveryPieceIsInEquilibrium) {
  for (const GeoTubeProblem& p : problems) {
    const GeoTube tube(p);
    const Bounded T = tube.tension(), bottom = tube.bottom_pressure(), w = p.specific_weight;
    for (double share : {0.05, 0.2, 0.33, 0.46, 0.5, 0.71}) {
      const GeoTubePoint at = tube.at(share * p.perimeter);
      expect_zero(at.pressure + w * at.y - bottom, bottom.value, "pressure", 1e-10);
      const Bounded push = bottom * at.y - Bounded(0.5) * w * at.y * at.y;
      expect_zero(T * (Bounded(1) - cos(at.angle)) - push, T.value, "across", 1e-10);
      if (at.y.value > 0) expect_zero(T * at.curvature - at.pressure, bottom.value, "bend", 1e-10);
      EXPECT_EQ(at.curvature.value > 0, at.y.value > 0);
    }
  }
}

TEST(GeoTube, PointsFollowTheTangent) {
  for (const GeoTubeProblem& p : problems) {
    const GeoTube tube(p);
    const double h = 1e-4 * p.perimeter, length = 2 * h * (1 + tube.strain().value);
    for (double share : {0.02, 0.31, 0.4, 0.49, 0.52, 0.66, 0.98}) {
      const GeoTubePoint a = tube.at(share * p.perimeter - h), b = tube.at(share * p.perimeter + h);
      const GeoTubePoint m = tube.at(share * p.perimeter);
      const double dx = b.x.value - a.x.value, dy = b.y.value - a.y.value;
      const double margin = std::pow(length * tube.bottom_pressure().value / tube.tension().value, 2) + 1e-9;
      EXPECT_NEAR(std::hypot(dx, dy), length, margin * length) << share;
      if (a.y.value == 0 && b.y.value > 0) continue;  // leaves the floor in between
      EXPECT_NEAR(std::sin(m.angle.value) * dx - std::cos(m.angle.value) * dy, 0, margin * length) << share;
    }
  }
}

TEST(GeoTube, MarkedPoints) {
  for (const GeoTubeProblem& p : problems) {
    const GeoTube tube(p);
    const GeoTubePoint bottom = tube.at(0), top = tube.at(0.5 * p.perimeter);
    EXPECT_EQ(bottom.x.value, 0);
    EXPECT_EQ(bottom.y.value, 0);
    expect_zero(top.x, p.perimeter, "x of the top", 1e-10);
    expect_zero(top.y - tube.height(), tube.height().value, "y of the top", 1e-10);
    expect_zero(top.angle - pi, 1, "angle of the top",
                1e-6);  // where F is steep, F^-1 at its end keeps half the digits
    const GeoTubePoint right = tube.at(0.3 * p.perimeter), left = tube.at(0.7 * p.perimeter);
    expect_zero(right.x + left.x, p.perimeter, "mirror x", 1e-10);
    expect_zero(right.y - left.y, p.perimeter, "mirror y", 1e-10);
    expect_zero(right.angle + left.angle - Bounded(2) * pi, 1, "mirror angle", 1e-8);
  }
}

TEST(GeoTube, AreaIsThatOfThePolygon) {
  for (const GeoTubeProblem& p : problems) {
    const GeoTube tube(p);
    const int n = 4000;
    double area = 0, widest = 0;
    GeoTubePoint a = tube.at(0);
    for (int i = 1; i <= n; ++i) {
      const GeoTubePoint b = tube.at(p.perimeter * i / n);
      area += 0.5 * (a.x.value * b.y.value - a.y.value * b.x.value);
      widest = std::max(widest, 2 * b.x.value);
      a = b;
    }
    const double bend = tube.bottom_pressure().value / tube.tension().value, step = p.perimeter / n;
    const double margin = std::pow(bend * step, 2);  // a chord cuts off step^3 bend/12
    EXPECT_NEAR(tube.area().value, area, margin * tube.width().value * p.perimeter + 1e-12);
    EXPECT_NEAR(tube.width().value, widest, margin * p.perimeter + 1e-12);
  }
}

TEST(GeoTube, GasMakesACircle) {
  const GeoTube tube({3, 0, 700, 0});
  const Bounded radius = Bounded(3) / (Bounded(2) * pi);
  expect_zero(tube.height() - Bounded(2) * radius, 1, "height");
  expect_zero(tube.width() - Bounded(2) * radius, 1, "width");
  expect_zero(tube.tension() - Bounded(700) * radius, 700, "T = p R");
  expect_zero(tube.area() - pi * radius * radius, 1, "area");
  EXPECT_EQ(tube.contact_width().value, 0);
  const GeoTubePoint quarter = tube.at(0.75);
  expect_zero(quarter.x - radius, 1, "x");
  expect_zero(quarter.y - radius, 1, "y");
  const GeoTube light({3, 1e-9, 700, 0});  // the floor carries p b = w A
  EXPECT_NEAR(light.contact_width().value, 1e-9 / 700 * tube.area().value, 1e-20);
  EXPECT_LE(light.contact_width().bound, 1e-13 * light.contact_width().value);
}

// Without pressure at the top it is a puddle that does not wet: depth 2 sqrt(T/w) (P.-G. de Gennes, F. Brochard-Wyart,
// D. Quere, Capillarity and Wetting Phenomena, 2004, section 2.2: e = 2 sin(theta/2)/kappa at theta = 180 degrees).
TEST(GeoTube, FlatTubeIsAPuddle) {
  for (double top : {1e-1, 1e-3, 1e-6}) {
    const GeoTube tube({40, 9810, top, 0});
    const double depth = 2 * std::sqrt(tube.tension().value / 9810);
    // 2 T = p1 H + w H^2/2: shallower by p1/w to first order
    EXPECT_NEAR(tube.height().value, depth - top / 9810, depth * std::pow(top / 9810 / depth, 2));
    EXPECT_GT(tube.contact_width().value, 0.8 * 20);
  }
}

TEST(GeoTube, OnlyRatiosCount) {
  const GeoTube a({4, 9810, 2000, 4e-5}), b({12, 9810 * 5, 2000 * 15, 4e-5 / 45});
  expect_same(b.height(), a.height(), 3);
  expect_same(b.width(), a.width(), 3);
  expect_same(b.area(), a.area(), 9);
  expect_same(b.tension(), a.tension(), 45);
  expect_same(b.strain(), a.strain());
}

TEST(GeoTube, ElasticMembraneStretches) {
  const GeoTube stiff({4, 9810, 2000, 0}), soft({4, 9810, 2000, 3e-5});
  const GeoTube same({4 * (1 + soft.strain().value), 9810, 2000, 0});  // cut to the stretched length
  EXPECT_NEAR(same.height().value, soft.height().value, 1e-13);
  EXPECT_NEAR(same.tension().value, soft.tension().value, 1e-9);
  EXPECT_GT(soft.tension().value, stiff.tension().value);
  expect_zero(soft.strain() - Bounded(3e-5) * soft.tension(), 1, "law");
  const GeoTube gas({1, 0, 500, 1e-3});  // 2 pi R = L0 (1 + c p R)
  const Bounded radius = Bounded(1) / (Bounded(2) * pi - Bounded(1e-3) * 500);
  expect_zero(gas.height() - Bounded(2) * radius, 1, "round");
}

// A round tube bursts where the compliance reaches 2 pi/(p L0); weight lowers the limit.
TEST(GeoTube, MembraneThatGivesWayIsRefused) {
  auto key = [](const GeoTubeProblem& problem) { return refused_key([&] { GeoTube tube(problem); }); };
  const double burst = 2 * pi.value / 500;
  EXPECT_EQ(key({1, 0, 500, 0.999 * burst}), "accepted");
  EXPECT_EQ(key({1, 0, 500, 1.001 * burst}), "compliance");
  EXPECT_EQ(key({1, 1e-3, 500, 0.99 * burst}), "accepted");
  EXPECT_EQ(key({1, 500, 500, 0.99 * burst}), "compliance");
  EXPECT_EQ(key({1, 500, 500, 1.001 * burst}), "compliance");
}

TEST(GeoTubeProblem, WrongProblemsAreRefusedByKey) {
  auto key = [](const GeoTubeProblem& problem) { return refused_key([&] { GeoTube tube(problem); }); };
  EXPECT_EQ(key({0, 1, 1, 0}), "perimeter");
  EXPECT_EQ(key({1, -1, 1, 0}), "specific_weight");
  EXPECT_EQ(key({1, 1, 0, 0}), "top_pressure");
  EXPECT_EQ(key({1, 1, 1, -1}), "compliance");
  EXPECT_EQ(refused_key([] { GeoTube().at(4.1); }), "along");
  EXPECT_EQ(refused_key([] { GeoTube().at(-0.1); }), "along");
}

}  // namespace
}  // namespace plumbline::reference::geo_tube_test
