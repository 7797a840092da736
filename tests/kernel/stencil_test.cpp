#include "kernel/stencil.hpp"

#include "kernel/pack.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::stencil_test {
namespace {

// Sums of up to 64 products of numbers of order one.
constexpr double rounding = 1e-14;
constexpr double h = 0.5;

// Local coordinates from -1/2 to 1/2 for shapes about the nearest node, from 0 to 1 for others.
template <class Shape>
double local_coordinate(double f) {
  return f + (Shape::support == 3 ? 0.0 : 0.5);
}

template <int dim>
std::vector<std::array<double, 3>> local_places() {
  std::vector<std::array<double, 3>> all;
  for (double x : {-0.3, 0.05, 0.4}) {
    for (double y : {-0.45, 0.2}) {
      for (double z : {-0.1, 0.35}) {
        if (dim == 1 && (y > 0 || z > 0)) continue;
        if (dim == 2 && z > 0) continue;
        all.push_back({x, y, z});
      }
    }
  }
  return all;
}

// A footprint in an array of nodes, and where its nodes stand relative to the point.
template <int dim, class Shape>
struct Neighbourhood {
  double local[dim];
  Footprint<dim> print;
  explicit Neighbourhood(const std::array<double, 3>& f) {
    print.lowest = 7;
    const int strides[3] = {1, 20, 400};
    for (int d = 0; d < dim; ++d) {
      local[d] = local_coordinate<Shape>(f[static_cast<std::size_t>(d)]);
      print.stride[d] = strides[d];
    }
  }
  Stencil<dim, Shape, double> stencil() const { return {local, h}; }
  // (x_i - x_p)_d of the node with flat index i.
  double distance(std::size_t i, int d) const {
    const int offset = static_cast<int>(i) - print.lowest;
    const int k = d == 0 ? offset % 20 : d == 1 ? offset / 20 % 20 : offset / 400;
    return (k + Shape::first - local[d]) * h;
  }
};

// sum N = 1, sum grad N = 0, sum a = 0; sum N r = 0, sum r grad N^T = 1, sum r a^T = 1; sum N r_d r_e = D. [EC-APIC 5]
template <int dim, class Shape>
void expect_identities() {
  for (const auto& f : local_places<dim>()) {
    const Neighbourhood<dim, Shape> at(f);
    const auto stencil = at.stencil();
    const auto one = stencil.gather(at.print, [](std::size_t) { return 1.0; });
    EXPECT_NEAR(one.value, 1, rounding);
    for (int d = 0; d < dim; ++d) {
      EXPECT_NEAR(one.gradient[d], 0, rounding / h);
      EXPECT_NEAR(one.affine[d], 0, rounding / h);
      EXPECT_NEAR(stencil.inertia(d), Shape::inertia(at.local[d]) * h * h, rounding);
      const auto r = stencil.gather(at.print, [&](std::size_t i) { return at.distance(i, d); });
      EXPECT_NEAR(r.value, 0, rounding);
      for (int e = 0; e < dim; ++e) {
        EXPECT_NEAR(r.gradient[e], d == e, rounding);
        EXPECT_NEAR(r.affine[e], d == e, rounding);
        const auto rr = stencil.gather(at.print, [&](std::size_t i) { return at.distance(i, d) * at.distance(i, e); });
        EXPECT_NEAR(rr.value, d == e ? stencil.inertia(d) : 0, rounding);
      }
    }
  }
}

template <class Shape>
void expect_identities_in_all_dimensions() {
  expect_identities<1, Shape>();
  expect_identities<2, Shape>();
  expect_identities<3, Shape>();
}
TEST(Stencil, LinearIdentities) { expect_identities_in_all_dimensions<Linear>(); }
TEST(Stencil, QuadraticIdentities) { expect_identities_in_all_dimensions<Quadratic>(); }
TEST(Stencil, CubicIdentities) { expect_identities_in_all_dimensions<Cubic>(); }

// The weight, gradient and affine weight of each node, one at a time, are products of those of each direction; and each
// node is met once, where the footprint says.
template <int dim, class Shape>
void expect_products() {
  const Neighbourhood<dim, Shape> at({0.13, -0.2, 0.31});
  const auto stencil = at.stencil();
  double n[dim][Shape::support], g[dim][Shape::support], a[dim][Shape::support];
  for (int d = 0; d < dim; ++d) {
    Shape::weights(at.local[d], n[d]);
    Shape::gradients(at.local[d], g[d]);
    Shape::affine_weights(at.local[d], a[d]);
  }
  std::vector<std::size_t> met;
  stencil.gather(at.print, [&](std::size_t i) {
    met.push_back(i);
    return 0.0;
  });
  ASSERT_EQ(met.size(), static_cast<std::size_t>(stencil.nodes));
  for (std::size_t k = 0; k < met.size(); ++k) {
    int rest = static_cast<int>(k), index[3] = {0, 0, 0};
    for (int d = 0; d < dim; ++d) {
      index[d] = rest % Shape::support;
      rest /= Shape::support;
    }
    EXPECT_EQ(met[k], 7u + static_cast<unsigned>(index[0] + 20 * index[1] + 400 * index[2]));
    const auto jet = stencil.gather_array([&](int j) { return j == static_cast<int>(k) ? 1.0 : 0.0; });
    double product = 1;
    for (int d = 0; d < dim; ++d) product *= n[d][index[d]];
    EXPECT_NEAR(jet.value, product, rounding);
    for (int d = 0; d < dim; ++d) {
      double others = 1 / h;
      for (int e = 0; e < dim; ++e) others *= e == d ? 1 : n[e][index[e]];
      EXPECT_NEAR(jet.gradient[d], others * g[d][index[d]], rounding);
      EXPECT_NEAR(jet.affine[d], others * a[d][index[d]], rounding);
    }
  }
}
template <class Shape>
void expect_products_in_all_dimensions() {
  expect_products<1, Shape>();
  expect_products<2, Shape>();
  expect_products<3, Shape>();
}
TEST(Stencil, IsAProductOfDirections) {
  expect_products_in_all_dimensions<Linear>();
  expect_products_in_all_dimensions<Quadratic>();
  expect_products_in_all_dimensions<Cubic>();
}

// What points spread and what they gather are one map and its transpose: node by node
//   spread: N base,  spread_gradient: slope . grad N,  spread_moment: w (base + slope . (x_i - x_p)) with w = scale N,
// added to what is there, in steps.
template <int dim, class Shape>
void expect_spread_is_the_transpose() {
  const Neighbourhood<dim, Shape> at({0.13, -0.2, 0.31});
  const auto stencil = at.stencil();
  constexpr int nodes = Stencil<dim, Shape, double>::nodes, step = 3;
  const double base = 0.7, scale = 1.3, slope[3] = {1.1, -0.6, 0.4};
  double along[dim];
  for (int d = 0; d < dim; ++d) along[d] = slope[d];
  double value[nodes * step], gradient[nodes * step], moment[nodes * step];
  for (int k = 0; k < nodes * step; ++k) value[k] = gradient[k] = moment[k] = k;
  double weights[nodes];
  stencil.find_weights(scale, weights);
  stencil.spread(base, value + 1, step);
  stencil.spread_gradient(along, gradient + 1, step);
  stencil.spread_moment(weights, base, along, moment + 1, step);
  std::vector<std::size_t> node;
  stencil.gather(at.print, [&](std::size_t i) {
    node.push_back(i);
    return 0.0;
  });
  for (int k = 0; k < nodes; ++k) {
    const auto jet = stencil.gather_array([&](int j) { return j == k ? 1.0 : 0.0; });
    double flux = 0, carried = base;
    for (int d = 0; d < dim; ++d) {
      flux += jet.gradient[d] * slope[d];
      carried += slope[d] * at.distance(node[static_cast<std::size_t>(k)], d);
    }
    EXPECT_NEAR(weights[k], scale * jet.value, 200 * rounding);
    EXPECT_NEAR(value[step * k + 1] - (step * k + 1), jet.value * base, 200 * rounding);
    EXPECT_NEAR(gradient[step * k + 1] - (step * k + 1), flux, 200 * rounding);
    EXPECT_NEAR(moment[step * k + 1] - (step * k + 1), scale * jet.value * carried, 200 * rounding);
    for (const double* sums : {value, gradient, moment}) {
      EXPECT_EQ(sums[step * k], step * k);  // other components stay
      EXPECT_EQ(sums[step * k + 2], step * k + 2);
    }
  }
}
template <class Shape>
void expect_transposes() {
  expect_spread_is_the_transpose<1, Shape>();
  expect_spread_is_the_transpose<2, Shape>();
  expect_spread_is_the_transpose<3, Shape>();
}
TEST(Stencil, SpreadingIsTheTransposeOfGathering) {
  expect_transposes<Linear>();
  expect_transposes<Quadratic>();
  expect_transposes<Cubic>();
}

TEST(Stencil, OnALine) {
  const double local[1] = {0.25};
  const Stencil<1, Linear, double> stencil(local, 0.1);
  const double expected[2][4] = {{0.75, -10, -0.025, -10}, {0.25, 10, 0.075, 10}};
  for (int k = 0; k < 2; ++k) {
    const auto jet = stencil.gather_array([&](int j) { return j == k ? 1.0 : 0.0; });
    EXPECT_NEAR(jet.value, expected[k][0], rounding);
    EXPECT_NEAR(jet.gradient[0], expected[k][1], rounding);
    EXPECT_NEAR(jet.value * (k - 0.25) * 0.1, expected[k][0] * expected[k][2], rounding);
    EXPECT_NEAR(jet.affine[0], expected[k][3], rounding);
  }
}

// A pack is so many points, each with its own weights: a handful of roundings apart, since products and sums may be fused
// in one and not in the other.
template <int dim, class Shape>
void expect_packs_like_numbers() {
  Pack local[dim];
  for (int d = 0; d < dim; ++d) {
    local[d] = Pack(
        [&](auto lane) { return local_coordinate<Shape>(0.1 * static_cast<double>(lane) - 0.4 + 0.07 * d); });
  }
  const Stencil<dim, Shape, Pack> together(local, h);
  const auto field = [](int k) { return std::sin(1.0 + k); };
  const auto jets = together.gather_array(field);
  for (int lane = 0; lane < lanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    double own[dim];
    for (int d = 0; d < dim; ++d) own[d] = local[d][l];
    const Stencil<dim, Shape, double> alone(own, h);
    const auto jet = alone.gather_array(field);
    EXPECT_NEAR(jets.value[l], jet.value, rounding);
    for (int d = 0; d < dim; ++d) {
      EXPECT_NEAR(jets.gradient[d][l], jet.gradient[d], 4 * rounding / h);
      EXPECT_NEAR(jets.affine[d][l], jet.affine[d], 4 * rounding / h);
    }
  }
}
TEST(Stencil, PacksAreSoManyPoints) {
  expect_packs_like_numbers<1, Linear>();
  expect_packs_like_numbers<2, Quadratic>();
  expect_packs_like_numbers<3, Quadratic>();
  expect_packs_like_numbers<3, Cubic>();
}

// The last node of a point that stands `past` cells inside its reach: N = past^p / p!. At a free edge it is all but massless, and
// forces, which go with the gradient, make it so fast that its energy is of order one; mass and energy keep their digits.
// Sums of powers of the point's coordinate would not: a coefficient times it is as large as the node's value, and cancels.
template <class Shape>
void expect_digits_of_light_nodes(double first, double per_factorial) {
  for (const double wanted : {1e-2, 1e-4, 1e-6, 1e-8}) {
    SCOPED_TRACE(wanted);
    const double local[1] = {first + wanted}, past = local[0] - first;
    const Stencil<1, Shape, double> stencil(local, h);
    const double weight = per_factorial * std::pow(past, Shape::degree);
    double masses[Shape::support] = {};
    stencil.spread(1.0, masses, 1);
    EXPECT_NEAR(masses[Shape::support - 1] / weight, 1, rounding);
    const auto square = [&](int k) { return k + 1 < Shape::support ? 1.0 : 2 / weight; };
    EXPECT_NEAR(stencil.gather_array(square).value, 3 - weight, 3 * rounding);
  }
}
TEST(Stencil, NodesWithHardlyAnyMassKeepTheirDigits) {
  expect_digits_of_light_nodes<Quadratic>(-0.5, 1.0 / 2);
  expect_digits_of_light_nodes<Cubic>(0, 1.0 / 6);
}

}  // namespace
}  // namespace plumbline::stencil_test
