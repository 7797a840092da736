#include "cases/harness/bench/bench_flow.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "cases/harness/files/errors.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

constexpr double pi = std::numbers::pi;

int per_cell(int dimension) { return dimension == 1 ? 8 : dimension == 2 ? 4 : 2; }

double power(double base, int exponent) {
  double product = 1;
  for (int k = 0; k < exponent; ++k) product *= base;
  return product;
}

void set_point(Columns& points, int p, const std::array<double, 3>& x, double volume, int dim) {
  double density = 1 + 0.3 * std::sin(2 * pi * x[0]);
  for (int d = 1; d < dim; ++d) density = 1 + (density - 1) * std::cos(2 * pi * x[static_cast<std::size_t>(d)]);
  points(column::mass)[p] = density * volume;
  points(column::volume)[p] = volume;
  points(column::density)[p] = density;
  points(column::energy)[p] = x[0] < 0.5 ? 2.5 : 1.5;
  points(column::velocity, 0)[p] = 0.5 * std::sin(pi * x[0]) * (dim > 1 ? std::cos(pi * x[1]) : 1.0);
  if (dim > 1) points(column::velocity, 1)[p] = -0.5 * std::cos(pi * x[0]) * std::sin(pi * x[1]);
  if (dim > 2) points(column::velocity, 2)[p] = 0.25 * std::sin(pi * x[2]);
  for (int d = 0; d < dim; ++d) points(column::position, d)[p] = x[static_cast<std::size_t>(d)];
}

}  // namespace

int BenchFlow::ppc() const { return static_cast<int>(power(per_cell(dimension), dimension)); }

int BenchFlow::cells() const {
  const double along = std::pow(static_cast<double>(points) / ppc(), 1.0 / dimension);
  return std::max(4, static_cast<int>(std::lround(along)));
}

std::string BenchFlow::name() const {
  return fmt::format("{} {} {} {}", axisymmetric ? "axisymmetric" : fmt::format("{}-D", dimension), shape, transfer,
                     integrator);
}

bool BenchFlow::is_possible() const {
  const IntegratorEntry* entry = find_integrator(integrator);
  return entry && lacks(*entry, shape, transfer).empty();
}

Scene flow_scene(const BenchFlow& flow) {
  const int dim = flow.dimension, along = flow.cells() * per_cell(dim);
  const double spacing = 1.0 / along;
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.axisymmetric = flow.axisymmetric;
  scene.grid.h = 1.0 / flow.cells();
  for (int d = 0; d < dim; ++d) scene.grid.cells[static_cast<std::size_t>(d)] = flow.cells();
  for (auto& sides : scene.grid.walls) sides = {Wall::symmetry, Wall::symmetry};
  scene.shape = flow.shape;
  scene.transfer = flow.transfer;
  scene.sharpening = scene.heat_exchange = flow.transfer == "flip" ? 0 : 1;
  auto gas = std::make_shared<IdealGas>();
  gas->viscosity_quadratic = 0.5;
  const int n = static_cast<int>(power(along, dim));
  Body body = make_body("gas", std::move(gas), n, dim, flow.axisymmetric);
  for (int p = 0; p < n; ++p) {
    std::array<double, 3> x{};
    for (int d = 0, rest = p; d < dim; ++d, rest /= along)
      x[static_cast<std::size_t>(d)] = (rest % along + 0.5) * spacing;
    set_point(body.points, p, x, power(spacing, dim) * (flow.axisymmetric ? x[0] : 1.0), dim);
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

}  // namespace plumbline
