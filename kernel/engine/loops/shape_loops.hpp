// The loops for one geometry and shape. What depends on whether points carry C_p is compiled for both.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "kernel/cell_volumes.hpp"
#include "kernel/enclosed_volumes.hpp"
#include "kernel/engine/point_loops.hpp"
#include "kernel/grid.hpp"
#include "kernel/pack.hpp"
#include "kernel/stencil.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {

// visit(d) for each direction, d a constant of the compilation.
template <int dim, class Visit>
[[gnu::always_inline]] inline void for_directions(Visit&& visit) {
  visit(std::integral_constant<int, 0>());
  if constexpr (dim > 1) visit(std::integral_constant<int, 1>());
  if constexpr (dim > 2) visit(std::integral_constant<int, 2>());
}

template <class Geometry, class Shape>
class ShapeLoops final : public PointLoops<Geometry> {
 public:
  using Base = PointLoops<Geometry>;
  static constexpr int dim = Geometry::dim;
  using typename Base::Field, typename Base::Vec;
  using typename Base::Gather, typename Base::Motion, typename Base::Spread, typename Base::Wanted;
  using At = Weights<dim>;

  ShapeLoops(const GridSpec& grid, const Transfer& transfer) : grid_(grid), transfer_(transfer) {}

  ShapeTraits shape() const override { return {Shape::support, Shape::blur, Shape::fixed_inertia, Shape::boxes}; }
  std::vector<double> inverse_volumes() const override { return inverse_cell_volumes<Shape>(grid_); }
  void find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                             std::vector<double>& volume) const override {
    if constexpr (dim == 2)
      enclosed_volumes<Shape>(grid_, chain, corners, volume);
    else
      throw std::logic_error("only in two dimensions does a chain of points enclose a gas");
  }
  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;
  bool find_movers(const Columns& points, const Bins& bins, const Chunk& chunk,
                   std::vector<Mover>& movers) const override;
  double inertia(const Columns& points, int d, int p) const override;
  Pack pack_inertia(const Columns& points, int d, int p, int count) const override;

  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    transfer_.affine ? map_motion<true, true>(body, at, chunk, field) : map_motion<false, true>(body, at, chunk, field);
  }
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    transfer_.affine ? map_motion<true, false>(body, at, chunk, field)
                     : map_motion<false, false>(body, at, chunk, field);
  }
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override;
  void spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const override;

  void gather(const Columns& points, const At& at, const Chunk& chunk, std::span<const Gather> all) const override;
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const override {
    return transfer_.affine ? gather_start<true>(body, at, chunk, wanted)
                            : gather_start<false>(body, at, chunk, wanted);
  }
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const override {
    return transfer_.affine ? gather_motion<true>(body, at, chunk, field, motion)
                            : gather_motion<false>(body, at, chunk, field, motion);
  }
  Survey survey(const Body& body, PointRange range) const override {
    return transfer_.affine ? survey<true>(body, range) : survey<false>(body, range);
  }

 private:
  static constexpr int support = Shape::support;
  static constexpr int nodes = Stencil<dim, Shape, double>::nodes;
  static constexpr int rotations = Geometry::rotations;
  static constexpr std::size_t about = dim == 2 ? 2 : 0;  // the first rotation's place in a Turn
  static constexpr int most_components = dim * dim + 1;   // of stress, whatever the material
  using PackStencil = Stencil<dim, Shape, Pack>;
  using Print = Footprint<dim>;

  struct RateColumns {
    double* at[most_components];
    StressMeasure measure;
  };
  // The nodal velocities of a bin relative to one node's, and that node's.
  struct BinVelocity {
    double u[nodes][dim], square[nodes];
    Vec base;
  };

  struct BinFilter;

  template <bool affine, bool with_mass>
  void map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const;
  template <StressMeasure measure, Shares shares>
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Field& field) const;
  template <StressMeasure measure>
  double map_forces_of_gas(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const;
  template <bool affine>
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const;
  template <bool affine>
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const;
  template <bool affine>
  Survey survey(const Body& body, PointRange range) const;

  // visit(footprint, anchor, first point, last point) for each bin of a chunk; anchor: node index per direction, ghosts
  // not counted.
  template <class Visit>
  void for_bins(const Bins& bins, const Chunk& chunk, Visit&& visit) const;
  template <class Visit>
  static void for_stencil_nodes(const Print& print, Visit&& visit);
  PackStencil stencil(const Places<dim>& places, const double (&anchor)[dim], int p) const;
  Pack box(const double* half_size, int p) const;
  Pack lowest_node(const double* const (&position)[dim], int p, int count, PackMask& inside) const;
  template <class Number>
  static Number inertia_at(const Number& x, const Number& half);
  // Sums the lanes of a bin's node sums into `to[node]` (component k of each node's value).
  template <int components, class Add>
  void add_to_nodes(const Print& print, const Pack (&sums)[nodes * components], Add&& add) const;
  BinVelocity bin_velocity(const Print& print, const std::vector<Vec>& velocity) const;
  BinFilter bin_filter(const Print& print, const Field& field, const BinVelocity& end) const;
  Pack take_filtered(const BinFilter& bin, const PackStencil& weights, const Pack (&inertia)[dim], Pack (&v)[dim],
                     Pack (&c)[dim][dim]) const;
  static RateColumns rate_columns(Body& body);
  template <class Component>
  void store_strain_rates(const RateColumns& rates, const PackStencil& weights, const Pack& radius, int p, int count,
                          Component&& u) const;

  Grid<dim> grid_;
  Transfer transfer_;
};

template <class G, class S>
template <class Visit>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::for_bins(const Bins& bins, const Chunk& chunk,
                                                              Visit&& visit) const {
  Print print;
  for (int d = 0; d < dim; ++d) print.stride[d] = grid_.stride(d);
  const int length = grid_.row_length();
  int row = -1;
  double anchor[dim];
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    print.lowest = bins.node(bin);
    if (row < 0 || print.lowest < row * length || print.lowest >= (row + 1) * length) {
      row = print.lowest / length;
      for (int d = 1; d < dim; ++d) anchor[d] = grid_.row_index(row, d) - Grid<dim>::ghosts - S::first;
    }
    anchor[0] = print.lowest - row * length - Grid<dim>::ghosts - S::first;
    visit(print, anchor, bins.start(bin), bins.end(bin));
  }
}

template <class G, class S>
template <class Visit>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::for_stencil_nodes(const Print& print, Visit&& visit) {
  int k = 0;
  for (int z = 0; z < (dim > 2 ? support : 1); ++z) {
    for (int y = 0; y < (dim > 1 ? support : 1); ++y) {
      int node = print.lowest;
      if constexpr (dim > 1) node += y * print.stride[1];
      if constexpr (dim > 2) node += z * print.stride[2];
      for (int x = 0; x < support; ++x) visit(k++, static_cast<std::size_t>(node + x));
    }
  }
}

// Half size of the points' boxes in cells.
template <class G, class S>
[[gnu::always_inline]] inline Pack ShapeLoops<G, S>::box(const double* half_size, int p) const {
  if constexpr (S::boxes) {
    const Pack half = load(half_size + p) * (1 / grid_.h());
    return min(max(half, Pack(S::narrowest)), Pack(S::widest));
  } else {
    return 0.0;
  }
}

// D_p / h^2 along d of points at x cells from the first node line, with boxes of the half size `half`.
template <class G, class S>
template <class Number>
[[gnu::always_inline]] inline Number ShapeLoops<G, S>::inertia_at(const Number& x, const Number& half) {
  using std::floor;
  if constexpr (S::boxes)
    return S::inertia_at(x, half);
  else
    return S::inertia(Number(x - floor(x)));
}

template <class G, class S>
double ShapeLoops<G, S>::inertia(const Columns& points, int d, int p) const {
  const double cells = grid_.logical(points(column::position, d)[p], d);
  double half = 0;
  if constexpr (S::boxes) half = std::clamp(points(column::half_size, d)[p] / grid_.h(), S::narrowest, S::widest);
  return inertia_at(cells, half) * grid_.h() * grid_.h();
}

template <class G, class S>
Pack ShapeLoops<G, S>::pack_inertia(const Columns& points, int d, int p, int) const {
  const Pack cells = (load(points(column::position, d) + p) - grid_.origin(d)) * (1 / grid_.h());
  return inertia_at(cells, box(S::boxes ? points(column::half_size, d) : nullptr, p)) * (grid_.h() * grid_.h());
}

// The lowest node of a pack of points. inside: whether all so far stand on the grid.
template <class G, class S>
[[gnu::always_inline]] inline Pack ShapeLoops<G, S>::lowest_node(const double* const (&position)[dim], int p, int count,
                                                                 PackMask& inside) const {
  Pack node = 0.0;
  for (int d = 0; d < dim; ++d) {
    const Pack x = (load(position[d] + p) - grid_.origin(d)) * (1 / grid_.h());
    inside = inside && ((x >= -on_side && x <= grid_.cells(d) + on_side) || !first_lanes(count));
    const Pack on_grid = min(max(x, Pack(0.0)), Pack(1.0 * grid_.cells(d)));
    node += (S::anchor_node(on_grid, grid_.cells(d)) + (S::first + Grid<dim>::ghosts)) * (1.0 * grid_.stride(d));
  }
  return node;
}

template <class G, class S>
bool ShapeLoops<G, S>::find_lowest(const Columns& points, PointRange range, int* lowest) const {
  const double* position[dim];
  for (int d = 0; d < dim; ++d) position[d] = points(column::position, d);
  PackMask inside = first_lanes(lanes);
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        store_as_integers(lowest + p, lowest_node(position, p, count, inside), count);
      });
  return all_of(inside);
}

template <class G, class S>
bool ShapeLoops<G, S>::find_movers(const Columns& points, const Bins& bins, const Chunk& chunk,
                                   std::vector<Mover>& movers) const {
  const double* position[dim];
  for (int d = 0; d < dim; ++d) position[d] = points(column::position, d);
  PackMask inside = first_lanes(lanes);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    const double own = bins.node(bin);
    for_packs(
        bins.start(bin), bins.end(bin), [&](int p, int count) __attribute__((always_inline)) {
          const Pack node = lowest_node(position, p, count, inside);
          if (none_of(node != own && first_lanes(count))) return;
          for (int k = 0; k < count; ++k) {
            const double there = node[static_cast<std::size_t>(k)];
            if (there != own) movers.push_back({p + k, static_cast<int>(there)});
          }
        });
  }
  return all_of(inside);
}

template <class G, class S>
[[gnu::always_inline]] inline auto ShapeLoops<G, S>::stencil(const Places<dim>& places, const double (&anchor)[dim],
                                                             int p) const -> PackStencil {
  Pack local[dim], half[dim];
  for (int d = 0; d < dim; ++d) {
    local[d] = (load(places.x[d] + p) - grid_.origin(d)) * (1 / grid_.h()) - anchor[d];
    half[d] = box(places.half_size[d], p);
  }
  return PackStencil(local, half, grid_.h());
}

template <class G, class S>
template <int components, class Add>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::add_to_nodes(const Print& print,
                                                                  const Pack (&sums)[nodes * components],
                                                                  Add&& add) const {
  double total[nodes * components];
  sum_lanes<nodes * components>(sums, total);
  for_stencil_nodes(print, [&](int k, std::size_t i) { add(i, total + k * components); });
}

// Relative to the middle node's, because what the maps lose is a difference of squares; a node at the stencil's edge could
// be all but massless and fast.
template <class G, class S>
[[gnu::always_inline]] inline auto ShapeLoops<G, S>::bin_velocity(const Print& print,
                                                                  const std::vector<Vec>& velocity) const
    -> BinVelocity {
  BinVelocity bin;
  int middle = print.lowest;
  for (int d = 0; d < dim; ++d) middle += support / 2 * print.stride[d];
  bin.base = velocity[static_cast<std::size_t>(middle)];
  for_stencil_nodes(print, [&](int k, std::size_t i) {
    bin.square[k] = 0;
    for (int d = 0; d < dim; ++d) {
      bin.u[k][d] = velocity[i][d] - bin.base[d];
      bin.square[k] += bin.u[k][d] * bin.u[k][d];
    }
  });
  return bin;
}

}  // namespace plumbline
