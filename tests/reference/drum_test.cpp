// The drum: tables of its tones, its wave equation, and the sheet stretched alike along both tangents.
#include "reference/drum.hpp"

#include "reference/equal_stretches.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::drum_test {
namespace {

// Zeros of Bessel functions in table 9.5 of M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions: half of
// the last printed digit.
TEST(Drum, PublishedTones) {  // [Surface 9]
  const Drum drum({0.3, 70, 0.2});
  const double unit = std::sqrt(70 / 0.2) / 0.3, half = 5e-6 * unit;
  EXPECT_NEAR(drum.omega(0).value, 2.40483 * unit, half);
  EXPECT_NEAR(drum.omega(1).value, 3.83171 * unit, half);
  EXPECT_NEAR(drum.omega(2).value, 5.13562 * unit, half);
  EXPECT_NEAR(drum.omega(0, 2).value, 5.52008 * unit, half);
  EXPECT_NEAR(drum.omega(3).value, 6.38016 * unit, half);
  EXPECT_NEAR(drum.omega(1, 2).value, 7.01559 * unit, half);
  for (int around : {0, 1, 2, 7}) EXPECT_LE(drum.omega(around).bound, 1e-12 * drum.omega(around).value);
}

// m omega^2 w + T (w'' + w'/r - around^2 w/r^2) = 0 by central differences: h^2 k^4/4 of a function within [-1, 1].
TEST(Drum, ShapesObeyTheWaveEquation) {  // [Surface 9]
  const double radius = 2, h = 1e-3;
  const Drum drum({radius, 5, 0.4});
  for (int around : {0, 1, 2}) {
    for (int across : {1, 2}) {
      const double k = drum.omega(around, across).value / drum.wave_speed().value;
      for (double r : {0.3, 0.9, 1.6}) {
        auto w = [&](double at) { return drum.shape(around, at, across).value; };
        const double bend = (w(r + h) - 2 * w(r) + w(r - h)) / (h * h), slope = (w(r + h) - w(r - h)) / (2 * h);
        EXPECT_NEAR(bend + slope / r + (k * k - around * around / (r * r)) * w(r), 0,
                    h * h * std::pow(k, 4) / 4 + 1e-9);
      }
      expect_zero(drum.shape(around, radius, across), 1, "rim");
      EXPECT_EQ(drum.shape(around, 0, across).value == 0, around > 0);
    }
  }
}

TEST(Drum, StretchedSheet) {  // [Surface 5, 9]
  const PrestretchedSheet sheet{3, 0.25, 0.02, 0.7, 1.5, 0.8};
  const Drum drum = drum_of(sheet);
  expect_zero(drum.tension() - 0.02 * 2.5, 1, "T = t S, S = 3/0.75 * 1.25/2");
  expect_zero(drum.area_density() * 1.5 * 1.5 - Bounded(0.7) * 0.02, 1, "mass of the stretched area");
  expect_zero(drum.wave_speed() * drum.wave_speed() * 0.7 - 1.5 * 1.5 * 2.5, 1, "l^2 S/rho");
  expect_same(drum.omega(1), Drum({0.8, drum.tension().value, drum.area_density().value}).omega(1));
  const double thicker = drum_of({3, 0.25, 0.09, 0.7, 1.5, 0.8}).omega(1).value;
  EXPECT_NEAR(thicker, drum.omega(1).value, 1e-12 * thicker);
}

TEST(Drum, WrongProblemsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { Drum({0, 1, 1}); }), "radius");
  EXPECT_EQ(refused_key([] { Drum({1, 0, 1}); }), "tension");
  EXPECT_EQ(refused_key([] { Drum({1, 1, -1}); }), "area_density");
  auto key = [](double PrestretchedSheet::*member, double value) {
    PrestretchedSheet sheet;
    sheet.*member = value;
    return refused_key([=] { drum_of(sheet); });
  };
  EXPECT_EQ(key(&PrestretchedSheet::youngs_modulus, 0), "youngs_modulus");
  EXPECT_EQ(key(&PrestretchedSheet::poisson_ratio, -1), "poisson_ratio");
  EXPECT_EQ(key(&PrestretchedSheet::thickness, 0), "thickness");
  EXPECT_EQ(key(&PrestretchedSheet::density, std::nan("")), "density");
  EXPECT_EQ(key(&PrestretchedSheet::stretch, 1), "stretch");
  EXPECT_EQ(key(&PrestretchedSheet::radius, -1), "radius");
  EXPECT_EQ(refused_key([] { Drum().omega(-1); }), "order");
  EXPECT_EQ(refused_key([] { Drum().omega(1, 0); }), "mode");
  EXPECT_EQ(refused_key([] { Drum().shape(1, 1.01); }), "position");
}

}  // namespace
}  // namespace plumbline::reference::drum_test
