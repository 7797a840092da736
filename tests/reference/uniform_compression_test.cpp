// A gas compressed uniformly: limits that are known, the energy equation by differences, and what is refused.
#include "reference/uniform_compression.hpp"

#include <cmath>

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::uniform_compression_test {
namespace {

using Problem = UniformCompressionProblem;

const Problem mixed{2, 0.4, 0.05, 0, 0.03, 1.3, 2, 5.0 / 3};  // physical and quadratic
const Problem linear{3, 0.4, 0, 0.2, 0, 1.3, 2, 5.0 / 3};

TEST(UniformCompressionPublished, IsentropicWithoutViscosity) {
  for (int d : {1, 2, 3}) {
    const UniformCompression gas({.dimension = d, .rate = 0.5, .density = 1.3, .pressure = 2, .gamma = 1.4});
    const Sample s = gas.sample(0.3, 0.8);
    EXPECT_NEAR(s.density.value, 1.3 / std::pow(0.6, d), 1e-14);
    EXPECT_NEAR(s.velocity.value, -0.5 * 0.3 / 0.6, 1e-15);
    EXPECT_NEAR(s.pressure.value, 2 * std::pow(s.density.value / 1.3, 1.4), 1e-13);
    EXPECT_EQ(gas.viscous_heat(0.8).value, 0);
  }
}

// 4/3 mu D^2 for one direction; two directions change the shape as much, three not at all. [York 4.1]
TEST(UniformCompressionPublished, FirstHeatOfPhysicalViscosity) {
  const double t = 1e-7, a = 0.5, mu = 0.2, rho = 1.3;
  for (const auto& [d, factor] : {std::pair{1, 4.0 / 3}, std::pair{2, 4.0 / 3}, std::pair{3, 0.0}}) {
    const UniformCompression gas({.dimension = d, .rate = a, .viscosity = mu, .density = rho});
    EXPECT_NEAR(gas.viscous_heat(t).value / t, factor * mu * a * a / rho, 1e-6);
  }
}

TEST(UniformCompressionPublished, FirstHeatOfArtificialViscosity) {  // q D/rho [York 4.11]
  const double t = 1e-7, a = 0.5, c = std::sqrt(1.4);
  for (int d : {1, 2, 3}) {
    const double closing = d * a;
    const UniformCompression l({.dimension = d, .rate = a, .linear = 0.1}),
        q({.dimension = d, .rate = a, .quadratic = 0.1});
    EXPECT_NEAR(l.viscous_heat(t).value / t, 0.1 * c * closing * closing, 1e-6);
    EXPECT_NEAR(q.viscous_heat(t).value / t, 0.1 * std::pow(closing, 3), 1e-6);
  }
}

TEST(UniformCompressionPublished, ArtificialViscosityActsInCompressionAlone) {
  for (const Problem& p : {Problem{.rate = -0.5, .linear = 0.1}, Problem{.rate = -0.5, .quadratic = 0.1}}) {
    EXPECT_EQ(UniformCompression(p).viscous_heat(0.5).value, 0);
  }
  EXPECT_GT(UniformCompression({.rate = -0.5, .viscosity = 0.1}).viscous_heat(0.5).value, 0);
}

// e' = sigma : grad v/rho, by central differences of 1e-4: truncated at 1e-8, rounded at 1e-12 of the rates.
TEST(UniformCompressionIdentity, EnergyEquation) {
  for (const Problem& p : {mixed, linear}) {
    const UniformCompression gas(p);
    const double t = 0.7, k = 1e-4, d = p.dimension, rate = p.rate / gas.stretch(t).value, closing = d * rate;
    const Sample s = gas.sample(0, t);
    const double rho = s.density.value, sound = std::sqrt(p.gamma * s.pressure.value / rho);
    const double q = rho * (p.linear * sound * closing + p.quadratic * closing * closing);
    const double shape = 2 * p.viscosity * (d * rate * rate - closing * closing / 3);
    const double expected = ((s.pressure.value + q) * closing + shape) / rho;
    const double found = (gas.energy(t + k).value - gas.energy(t - k).value) / (2 * k);
    EXPECT_NEAR(found, expected, 1e-7 * expected);
  }
}

TEST(UniformCompressionBounds, AreSmall) {
  for (const Problem& p : {mixed, linear}) {
    const Bounded heat = UniformCompression(p).viscous_heat(0.7);
    EXPECT_GT(heat.bound, 0);
    EXPECT_LT(heat.bound, 1e-13 * heat.value);
  }
}

TEST(UniformCompressionArguments, AreRefusedByKey) {
  const auto key_of = [](const Problem& p, double time = 0.5) -> std::string {
    try {
      UniformCompression(p).energy(time);
    } catch (const ParameterError& error) {
      return error.key;
    }
    return "";
  };
  EXPECT_EQ(key_of({}), "");
  EXPECT_EQ(key_of({.dimension = 4}), "dimension");
  EXPECT_EQ(key_of({.rate = NAN}), "rate");
  EXPECT_EQ(key_of({.viscosity = -1}), "viscosity");
  EXPECT_EQ(key_of({.linear = -1}), "linear");
  EXPECT_EQ(key_of({.viscosity = 1, .linear = 1}), "linear");
  EXPECT_EQ(key_of({.linear = 1, .quadratic = 1}), "linear");
  EXPECT_EQ(key_of({.quadratic = -1}), "quadratic");
  EXPECT_EQ(key_of({.density = 0}), "density");
  EXPECT_EQ(key_of({.pressure = 0}), "pressure");
  EXPECT_EQ(key_of({.gamma = 1}), "gamma");
  EXPECT_EQ(key_of({}, 2), "time");
  EXPECT_EQ(key_of({}, -1), "time");
}

}  // namespace
}  // namespace plumbline::reference::uniform_compression_test
