// The loops over points whose parallelograms carry tents at their corners, in two dimensions: for solids with affine
// velocities by packs of points, for all else along lists. Tests hold the first against the second.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/engine/loops/corner_weights.hpp"
#include "kernel/engine/loops/list_loops.hpp"

namespace plumbline {

template <class Geometry>
class CornerLoops final : public ListLoops<Geometry> {
 public:
  static constexpr int dim = Geometry::dim;
  static_assert(dim == 2);
  using Lists = ListLoops<Geometry>;
  using typename Lists::At, typename Lists::Field, typename Lists::Vec;
  using typename Lists::Gather, typename Lists::Motion, typename Lists::Spread, typename Lists::Wanted;

  // make: of the lists of the same shape.
  CornerLoops(const GridSpec& spec, const Transfer& transfer, MakeListed<dim> make)
      : Lists(spec, transfer, make),
        domains_(Lists::grid()),
        per_h_(1 / Lists::grid().h()) {}

  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;

  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    in_packs(body) ? map_motion<true>(body, at, chunk, field) : Lists::map_mass_and_momentum(body, at, chunk, field);
  }
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    in_packs(body) ? map_motion<false>(body, at, chunk, field) : Lists::map_momentum(body, at, chunk, field);
  }
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override;
  void spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const override;

  void gather(const Columns& points, const At& at, const Chunk& chunk, std::span<const Gather> all) const override;
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const override;
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const override;
  Survey survey(const Body& body, PointRange range) const override;
  Totals survey_motion(const Body& body, PointRange range) const override;

 private:
  using Lists::about;
  using Lists::rotations;
  using typename Lists::Matrix;

  // The sums of others are those of gases and chains.
  bool in_packs(const Body& body) const {
    return Lists::is_solid(body) && this->transfer().affine && this->transfer().order == 0 &&
           this->transfer().keep == 0;
  }
  static Pack affine_square(const PackMatrix& c, const PackMatrix& inertia) { return (c * inertia).dot(c); }
  static PackMatrix outer(const PackVector& a, const PackVector& b) {
    return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y};
  }
  static Pack spin(const PackMatrix& s) { return s.yx - s.xy; }
  static bool full(const Body& body) { return body.material->measure() == StressMeasure::full; }

  // Pointers are taken once per loop. Number: double, or const double where the points are only read.
  template <class Number>
  struct MovingColumns {
    Number *mass, *x[dim], *v[dim], *c[dim * dim];
    template <class ColumnsRef>
    explicit MovingColumns(ColumnsRef& points) : mass(points(column::mass)) {
      for (int d = 0; d < dim; ++d) {
        x[d] = points(column::position, d);
        v[d] = points(column::velocity, d);
      }
      for (int k = 0; k < dim * dim; ++k) c[k] = points(column::affine, k);
    }
    PackVector position(int p) const { return {load(x[0] + p), load(x[1] + p)}; }
    PackVector velocity(int p) const { return {load(v[0] + p), load(v[1] + p)}; }
    PackMatrix affine(int p) const { return {load(c[0] + p), load(c[1] + p), load(c[2] + p), load(c[3] + p)}; }
  };
  struct RateColumns {
    double* at[dim * dim + 1];
    bool full;
    explicit RateColumns(Body& body) : full(CornerLoops::full(body)) {
      for (int k = 0; k < body.points.components(column::strain_rate); ++k) at[k] = body.points(column::strain_rate, k);
    }
  };

  // Half the edges of points, a column for each, m.
  class EdgeColumns {
   public:
    explicit EdgeColumns(const Columns& points) {
      const DomainEdges<dim> edges(points);
      for (int k = 0; k < dim * dim; ++k) at_[k] = edges.component(k / dim, k % dim);
    }
    PackMatrix operator[](int p) const { return {from(0, p), from(1, p), from(2, p), from(3, p)}; }

   private:
    Pack from(int k, int p) const { return at_[k] ? load(at_[k] + p) : Pack(0.0); }
    const double* at_[dim * dim];
  };

  Parallelograms domains(const PackVector& place, const EdgeColumns& edges, int p) const;
  Parallelograms domains(const Places<dim>& places, const EdgeColumns& edges, int p) const {
    return domains({load(places.x[0] + p), load(places.x[1] + p)}, edges, p);
  }
  Pack lowest_node(const PackVector& place, const EdgeColumns& edges, int p, int count, PackMask& inside) const;
  PackMask on_grid(const PackVector& x) const;
  // The distance from the axis of rings, m, of points' first coordinates.
  Pack radius(const Pack& x) const;
  // Whether no domain of a chunk is wider than a cell: all corners then lie within two cells of the lowest node.
  bool narrow(const EdgeColumns& edges, const Chunk& chunk) const;
  // How far corners of some points lie from a node along the axes, at most, cells.
  double extent_of(const Places<dim>& places, const EdgeColumns& edges, PointRange range, int column, int row) const;
  // visit(block, for_packs) for each bin of a chunk: the nodes that its points reach, and for_packs(with_pack) calls
  // with_pack(domains, weights, p, count) for each pack of them.
  template <class Visit>
  void for_bins(const Columns& points, const At& at, const Chunk& chunk, Visit&& visit) const;

  template <bool with_mass>
  void map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const;
  static void store_strain_rates(const RateColumns& rates, int p, int count, const PackJet& jet, const Pack& radius);
  bool sum_motion(const Body& body, PointRange range, Totals& totals) const;

  Domains<dim> domains_;
  double per_h_;
};

// Of points off the grid those of the nearest place on it.
template <class G>
[[gnu::always_inline]] inline Parallelograms CornerLoops<G>::domains(const PackVector& place, const EdgeColumns& edges,
                                                                     int p) const {
  const Grid<dim>& grid = this->grid();
  const auto cells = [&](const Pack& x, int d) {
    return min(max((x - grid.origin(d)) * per_h_, Pack(0.0)), Pack(grid.cells(d)));
  };
  const PackVector x{cells(place.x, 0), cells(place.y, 1)};
  Parallelograms at{{x.x + Grid<dim>::ghosts, x.y + Grid<dim>::ghosts}, edges[p].times(per_h_)};
  const PackVector reach = at.reach();
  if (any_of(reach.x > domains_.free_reach() || reach.y > domains_.free_reach())) {
    const Pack along = domains_.squeeze(x.x, reach.x, 0), up = domains_.squeeze(x.y, reach.y, 1);
    at.edges = {along * at.edges.xx, along * at.edges.xy, up * at.edges.yx, up * at.edges.yy};
  }
  return at;
}

template <class G>
[[gnu::always_inline]] inline PackMask CornerLoops<G>::on_grid(const PackVector& x) const {
  const Grid<dim>& grid = this->grid();
  const auto within = [&](const Pack& at, int d) {
    const Pack cells = (at - grid.origin(d)) * per_h_;
    return cells >= -on_side && cells <= grid.cells(d) + on_side;
  };
  return within(x.x, 0) && within(x.y, 1);
}

template <class G>
[[gnu::always_inline]] inline Pack CornerLoops<G>::radius(const Pack& x) const {
  const double low = this->grid().origin(0);
  return min(max(x, Pack(low)), Pack(low + this->grid().cells(0) * this->grid().h()));
}

template <class G>
bool CornerLoops<G>::narrow(const EdgeColumns& edges, const Chunk& chunk) const {
  Pack widest = 0.0;
  for_packs(chunk.first, chunk.last, [&](int p, int count) {
    const PackVector reach = Parallelograms{{}, edges[p]}.reach();
    widest = max(kept(max(reach.x, reach.y), count), widest);
  });
  return hmax(widest) <= 0.5 * this->grid().h();
}

template <class G>
double CornerLoops<G>::extent_of(const Places<dim>& places, const EdgeColumns& edges, PointRange range, int column,
                                 int row) const {
  Pack furthest = 0.0;
  for_packs(range.first, range.last, [&](int p, int count) {
    const Parallelograms at = domains(places, edges, p);
    const PackVector reach = at.reach();
    furthest = max(kept(max(at.place.x + reach.x - column, at.place.y + reach.y - row), count), furthest);
  });
  return hmax(furthest);
}

template <class G>
template <class Visit>
[[gnu::always_inline]] inline void CornerLoops<G>::for_bins(const Columns& points, const At& at, const Chunk& chunk,
                                                            Visit&& visit) const {
  const Grid<dim>& grid = this->grid();
  const EdgeColumns edges(points);
  const Places<dim> places = at.places(points, true);
  const int last[] = {grid.nodes(0) - domains_.support(), grid.nodes(1) - domains_.support()};
  const bool small = narrow(edges, chunk);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    const PointRange range{at.bins.start(bin), at.bins.end(bin)};
    const int node = at.bins.node(bin), row = node / grid.row_length(), column = node - row * grid.row_length();
    const auto visit_block = [&]<int side>() __attribute__((always_inline)) {
      const NodeBlock<side> block{node, 1.0 * column, 1.0 * row, grid.row_length(), domains_.support()};
      visit(
          block, [&](auto&& with_pack) __attribute__((always_inline)) {
            for_packs(
                range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
                  const Parallelograms here = domains(places, edges, p);
                  with_pack(here, DomainWeights<side>(here, block, grid.h()), p, count);
                });
          });
    };
    const bool near = small && column < last[0] && row < last[1];
    const double extent = near ? 2 : extent_of(places, edges, range, column, row);
    if (extent <= 2)
      visit_block.template operator()<3>();
    else if (extent <= 3)
      visit_block.template operator()<4>();
    else
      visit_block.template operator()<Domains<dim>::most_nodes>();
  }
}

}  // namespace plumbline
