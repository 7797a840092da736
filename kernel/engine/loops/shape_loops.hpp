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

// Whether the integrals of a shape's kernels are known, by which points move whose pressures act at the nodes. [Pressure 4]
template <class Shape>
concept FlowingShape = requires(double f, double (&c)[Shape::support]) {
  Shape::above(f, c);
};

// Of the B-splines that a shape is; 0: it is none.
template <class Shape>
constexpr int degree_of() {
  if constexpr (requires { Shape::degree; })
    return Shape::degree;
  else
    return 0;
}

template <class Geometry, class Shape>
class ShapeLoops final : public PointLoops<Geometry> {
 public:
  using Base = PointLoops<Geometry>;
  static constexpr int dim = Geometry::dim;
  using typename Base::Field, typename Base::Vec;
  using typename Base::Gather, typename Base::Motion, typename Base::Spread, typename Base::Straining,
      typename Base::Wanted;
  using At = Weights<dim>;

  ShapeLoops(const GridSpec& grid, const Transfer& transfer)
      : grid_(grid),
        per_h_(1 / grid_.h()),
        transfer_(transfer) {}

  ShapeTraits shape() const override {
    return {Shape::support, Shape::blur, Shape::fixed_inertia, Shape::boxes, false, degree};
  }
  std::vector<double> inverse_volumes() const override { return inverse_cell_volumes<Shape>(grid_); }
  void find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                             std::vector<double>& volume) const override {
    if constexpr (dim == 2)
      enclosed_volumes<Shape>(grid_, chain, corners, volume);
    else
      throw std::logic_error("only in two dimensions does a chain of points enclose a gas");
  }
  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;
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
  void take_pressure(const Columns& points, const At& at, const Chunk& chunk, const std::vector<double>& pressure,
                     Field& field) const override;
  void map_divergence(const Columns& points, const At& at, const Chunk& chunk, const std::vector<Vec>& velocity,
                      std::vector<double>& sums) const override;
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
  static constexpr int degree = degree_of<Shape>();
  static constexpr bool corrects = degree > 0 && dim > 1 && !Geometry::axisymmetric;
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
  // What the lowest nodes of points are found from: copies, since a loop that writes whole numbers could change the grid's.
  struct Extent {
    const double* position[dim];
    double origin[dim], per_h, ends[dim], stride[dim];
    int cells[dim];
  };
  // Nodal values of a bin, for each node of the stencil in turn.
  using BinVectors = double[nodes][dim];
  using BinNumbers = double[nodes];
  // The nodal velocities of a bin relative to one node's, and that node's.
  struct BinVelocity {
    BinVectors u;
    BinNumbers square;
    double base[dim];
  };

  // A Straining's arrays.
  struct BinStraining {
    bool by_velocity = false, by_divergence = false;
    BinVectors velocity;
    BinNumbers divergence;
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
  // visit(k, i) for each row of a stencil's nodes: its first node is the k-th of the stencil, and i in the nodal arrays.
  template <class Visit>
  static void for_rows(const Print& print, Visit&& visit);
  template <class Visit>
  static void for_stencil_nodes(const Print& print, Visit&& visit);
  PackStencil stencil(const Places<dim>& places, const double (&anchor)[dim], int p) const;
  Pack box(const double* half_size, int p) const;
  Extent extent(const Columns& points) const;
  static Pack lowest_node(const Extent& grid, int p, int count, PackMask& inside);
  template <class Number>
  static Number inertia_at(const Number& x, const Number& half);
  template <int count>
  static void clear(Pack (&sums)[count]);
  // Adds the lanes of a bin's sums to the nodes' values of so many components.
  template <int components>
  static void add_to_nodes(const Print& print, const Pack (&sums)[nodes * components], double* values);
  static void collect(const Print& print, const std::vector<Vec>& values, BinVectors& bin);
  static void collect(const Print& print, const std::vector<double>& values, BinNumbers& bin);
  static BinVelocity bin_velocity(const Print& print, const std::vector<Vec>& velocity);
  BinFilter bin_filter(const Print& print, const Field& field, const BinVelocity& end) const;
  Pack take_filtered(const BinFilter& bin, const PackStencil& weights, const Pack (&inertia)[dim], Pack (&v)[dim],
                     Pack (&c)[dim][dim]) const;
  static RateColumns rate_columns(Body& body);
  static void collect(const Print& print, const Straining& by, BinStraining& bin);
  void store_strain_rates(const RateColumns& rates, const PackStencil& weights, const Pack& radius, int p, int count,
                          const BinStraining& by) const;

  Grid<dim> grid_;
  double per_h_;  // 1 / h: a division takes as long as the weights of a point
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
[[gnu::always_inline]] inline void ShapeLoops<G, S>::for_rows(const Print& print, Visit&& visit) {
  int k = 0;
  for (int z = 0; z < (dim > 2 ? support : 1); ++z) {
    for (int y = 0; y < (dim > 1 ? support : 1); ++y) {
      int node = print.lowest;
      if constexpr (dim > 1) node += y * print.stride[1];
      if constexpr (dim > 2) node += z * print.stride[2];
      visit(k, static_cast<std::size_t>(node));
      k += support;
    }
  }
}

template <class G, class S>
template <class Visit>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::for_stencil_nodes(const Print& print, Visit&& visit) {
  for_rows(
      print, [&](int k, std::size_t i) __attribute__((always_inline)) {
        for (int x = 0; x < support; ++x) visit(k + x, i + static_cast<std::size_t>(x));
      });
}

// Half size of the points' boxes in cells.
template <class G, class S>
[[gnu::always_inline]] inline Pack ShapeLoops<G, S>::box(const double* half_size, int p) const {
  if constexpr (S::boxes) {
    const Pack half = load(half_size + p) * per_h_;
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
[[gnu::always_inline]] inline auto ShapeLoops<G, S>::stencil(const Places<dim>& places, const double (&anchor)[dim],
                                                             int p) const -> PackStencil {
  Pack local[dim], half[dim];
  for (int d = 0; d < dim; ++d) {
    local[d] = (load(places.x[d] + p) - grid_.origin(d)) * per_h_ - anchor[d];
    half[d] = box(places.half_size[d], p);
  }
  return PackStencil(local, half, grid_.h(), per_h_);
}

template <class G, class S>
template <int count>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::clear(Pack (&sums)[count]) {
#pragma GCC unroll 32
  for (int k = 0; k < count; ++k) sums[k] = 0.0;
}

template <class G, class S>
template <int components>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::add_to_nodes(const Print& print,
                                                                  const Pack (&sums)[nodes * components],
                                                                  double* values) {
  for_rows(
      print, [&](int k, std::size_t i) __attribute__((always_inline)) {
        add_lane_sums<support * components>(sums + k * components, values + i * components);
      });
}

template <class G, class S>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::collect(const Print& print, const std::vector<Vec>& values,
                                                             BinVectors& bin) {
  for_stencil_nodes(print, [&](int k, std::size_t i) {
    for (int d = 0; d < dim; ++d) bin[k][d] = values[i][d];
  });
}
template <class G, class S>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::collect(const Print& print, const std::vector<double>& values,
                                                             BinNumbers& bin) {
  for_stencil_nodes(print, [&](int k, std::size_t i) { bin[k] = values[i]; });
}

template <class G, class S>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::collect(const Print& print, const Straining& by,
                                                             BinStraining& bin) {
  bin.by_velocity = by.velocity != nullptr;
  bin.by_divergence = by.divergence != nullptr;
  if (by.velocity) collect(print, *by.velocity, bin.velocity);
  if (by.divergence) collect(print, *by.divergence, bin.divergence);
}

// Relative to the middle node's, because what the maps lose is a difference of squares; a node at the stencil's edge could
// be all but massless and fast.
template <class G, class S>
[[gnu::always_inline]] inline auto ShapeLoops<G, S>::bin_velocity(const Print& print, const std::vector<Vec>& velocity)
    -> BinVelocity {
  BinVelocity bin;
  int middle = print.lowest;
  for (int d = 0; d < dim; ++d) middle += support / 2 * print.stride[d];
  for (int d = 0; d < dim; ++d) bin.base[d] = velocity[static_cast<std::size_t>(middle)][d];
  for_stencil_nodes(print, [&](int k, std::size_t i) {
    for (int d = 0; d < dim; ++d) {
      bin.u[k][d] = velocity[i][d] - bin.base[d];
      bin.square[k] = d == 0 ? bin.u[k][d] * bin.u[k][d] : bin.square[k] + bin.u[k][d] * bin.u[k][d];
    }
  });
  return bin;
}

}  // namespace plumbline
