// The points and flows of a step beside those of the step written straight from the equations.
#pragma once

#include "tests/kernel/naive/step.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {

// The tensor entry that component k of a stress column is.
inline std::array<int, 2> tensor_entry(scenes::Space space, int k) {
  constexpr std::array<int, 2> plane[] = {{0, 0}, {1, 1}, {0, 1}}, rings[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}},
                               solid[] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};
  return space == scenes::Space::axisymmetric ? rings[k] : space == scenes::Space::solid ? solid[k] : plane[k];
}

// The same where all components are kept.
inline std::array<int, 2> full_entry(int dim, int k) {
  if (k == dim * dim) return {2, 2};
  return {k / dim, k % dim};
}

// Three steps: sums of a few hundred terms of order one and their differences, so 1e-12 of each field's size.
template <class Value>
void expect_column(const Body& body, const NaiveStep& naive, const ColumnId& id, int component, Value&& value) {
  const auto values = scenes::by_id(body, id, component);
  double scale = 0;
  for (double v : values) scale = std::max(scale, std::abs(v));
  for (std::size_t p = 0; p < values.size(); ++p) {
    ASSERT_NEAR(values[p], value(naive.points[p]), 1e-12 * scale) << id.name() << ' ' << component << " of point " << p;
  }
}

inline void expect_points_like_naive(const Scene& scene, const Body& body, const NaiveStep& naive) {
  using Point = NaivePoint;
  const scenes::Space space = scenes::space_of(scene.grid);
  const int dim = scene.grid.dim;
  for (int d = 0; d < dim; ++d) {
    expect_column(body, naive, column::position, d, [d](const Point& p) { return p.x[d]; });
    expect_column(body, naive, column::velocity, d, [d](const Point& p) { return p.v[d]; });
    for (int e = 0; e < dim && scene.transfer == "apic"; ++e) {
      expect_column(body, naive, column::affine, d * dim + e, [d, e](const Point& p) { return p.c(d, e); });
    }
  }
  const StressMeasure measure = body.material->measure();
  for (int k = 0; k < body.points.components(column::stress); ++k) {
    if (measure == StressMeasure::point_force) {
      expect_column(body, naive, column::stress, k, [k](const Point& p) { return -p.pull[k] / p.volume; });
      continue;
    }
    const bool full = measure == StressMeasure::full;
    const auto [i, j] = full ? full_entry(dim, k) : tensor_entry(space, k);
    expect_column(body, naive, column::stress, k, [i = i, j = j](const Point& p) { return p.stress(i, j); });
    if (full) {
      expect_column(body, naive, column::deformation, k, [i = i, j = j](const Point& p) { return p.f(i, j); });
    }
    if (body.points.components(column::strain) == body.points.components(column::stress) && dim > 1) {
      const double share = i == j ? 1 : 2;  // engineering shears
      expect_column(body, naive, column::strain, k,
                    [i = i, j = j, share](const Point& p) { return share * p.eps(i, j); });
    }
  }
  if (measure == StressMeasure::full) {
    expect_column(body, naive, column::volume, 0, [](const Point& p) { return p.volume; });
  } else if (dynamic_cast<const LinearElastic*>(body.material.get())) {
    expect_column(body, naive, column::strain, 0, [](const Point& p) { return p.eps(0, 0); });
  } else if (body.points.has(column::energy)) {
    expect_column(body, naive, column::energy, 0, [](const Point& p) { return p.energy; });
    expect_column(body, naive, column::volume, 0, [](const Point& p) { return p.volume; });
  } else {
    expect_column(body, naive, column::strain, 0, [](const Point& p) { return p.strain; });
  }
}

// The flows of energy, each against its own formula: roundings of the stores.
inline void expect_flows_like_naive(const Ledger& ledger, const NaiveStep& naive) {
  const Account& energy = ledger.energy;
  const double scale = energy.scale();
  EXPECT_NEAR(energy.flow(Flow::body_force), naive.body_work, 1e-13 * scale);
  EXPECT_NEAR(energy.flow(Flow::transfer), naive.transfer, 1e-13 * scale);
  EXPECT_NEAR(energy.flow(Flow::integration), naive.integration, 1e-13 * scale);
  EXPECT_NEAR(energy.flow(Flow::constitutive), naive.constitutive, 1e-13 * scale);
}

}  // namespace plumbline
