// The loops over points whose parallelograms carry tents at their corners, in two dimensions: for solids with affine
// velocities by all corners side by side, for all else along lists. Tests hold the first against the second.
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
  using typename Lists::Motion, typename Lists::Spread, typename Lists::Wanted;

  // make: of the lists of the same shape.
  CornerLoops(const GridSpec& spec, const Transfer& transfer, MakeListed<dim> make)
      : Lists(spec, transfer, make),
        domains_(Lists::grid()),
        per_h_(1 / Lists::grid().h()) {}

  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;

  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    side_by_side(body) ? map_motion<true>(body, at, chunk, field)
                       : Lists::map_mass_and_momentum(body, at, chunk, field);
  }
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    side_by_side(body) ? map_motion<false>(body, at, chunk, field) : Lists::map_momentum(body, at, chunk, field);
  }
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override;
  void spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const override;
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
  bool side_by_side(const Body& body) const {
    return Lists::is_solid(body) && this->transfer().affine && this->transfer().order == 0 &&
           this->transfer().keep == 0;
  }
  static double affine_square(const Square& c, const Square& inertia) { return (c * inertia).dot(c); }
  static Square outer(const Two& a, const Two& b) { return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y}; }
  static void add_spin(double m, const Square& s, Turn& turn) {
    if (rotations > 0) turn[about] += m * (s.yx - s.xy);
  }
  static bool full(const Body& body) { return body.material->measure() == StressMeasure::full; }

  // Number: double, or const double where the points are only read. Pointers are taken once per loop.
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
    Two velocity(int p) const { return {v[0][p], v[1][p]}; }
    Square affine(int p) const { return {c[0][p], c[1][p], c[2][p], c[3][p]}; }
  };
  struct RateColumns {
    double* at[dim * dim + 1];
    bool full;
    explicit RateColumns(Body& body) : full(CornerLoops::full(body)) {
      for (int k = 0; k < body.points.components(column::strain_rate); ++k) at[k] = body.points(column::strain_rate, k);
    }
  };

  // The edges of points, a column each, times a factor.
  class EdgeColumns {
   public:
    explicit EdgeColumns(const Columns& points) : any_(points), set_(points.has(column::half_edges)) {
      for (int k = 0; set_ && k < dim * dim; ++k) at_[k] = points(column::half_edges, k);
    }
    Square square(int p, double factor) const {
      if (set_) return Square{at_[0][p], at_[2][p], at_[1][p], at_[3][p]}.times(factor);
      const Matrix edges = any_[p];
      return Square{edges(0, 0), edges(0, 1), edges(1, 0), edges(1, 1)}.times(factor);
    }

   private:
    DomainEdges<dim> any_;
    bool set_;
    const double* at_[dim * dim] = {};
  };

  // A point in cells, its edges as squeezed there.
  struct Placed {
    Two place;
    Square edges;
  };
  Placed placed(const double* const (&x)[dim], const EdgeColumns& edges, int p) const;
  Square inertia_of(const double* const (&x)[dim], const EdgeColumns& edges, int p) const;
  CornerWeights weights(const double* const (&x)[dim], const EdgeColumns& edges, int p, const CellRange& cells) const;
  bool on_grid(const double* const (&x)[dim], int p) const {
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const double cells = this->grid().logical(x[d][p], d);
      inside = inside && cells >= -on_side && cells <= this->grid().cells(d) + on_side;
    }
    return inside;
  }
  Square squeezed(const Two& place, const Square& edges) const;
  CellRange all_cells() const;
  CellRange cells_of(const Bins& bins, int bin) const;
  // visit(p, weights) for all points of a chunk.
  template <class Visit>
  void for_points(const Columns& points, const At& at, const Chunk& chunk, Visit&& visit) const;

  template <bool with_mass>
  void map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const;
  static void store_strain_rates(const RateColumns& rates, int p, const CornerWeights::Jet& jet, double radius);
  void sum_motion(const Body& body, PointRange range, Totals& totals, bool& inside) const;

  Domains<dim> domains_;
  double per_h_;
};

template <class G>
[[gnu::always_inline]] inline auto CornerLoops<G>::placed(const double* const (&x)[dim], const EdgeColumns& edges,
                                                          int p) const -> Placed {
  const Two place{domains_.place(x[0][p], 0), domains_.place(x[1][p], 1)};
  const Square own = edges.square(p, per_h_);
  const double extent = std::max(std::abs(own.xx) + std::abs(own.xy), std::abs(own.yx) + std::abs(own.yy));
  return {place, extent > 1 ? squeezed(place, own) : own};
}

template <class G>
[[gnu::always_inline]] inline CornerWeights CornerLoops<G>::weights(const double* const (&x)[dim],
                                                                    const EdgeColumns& edges, int p,
                                                                    const CellRange& cells) const {
  const Placed at = placed(x, edges, p);
  return CornerWeights(at.place, at.edges, cells, this->grid().row_length(), this->grid().h());
}

template <class G>
[[gnu::always_inline]] inline Square CornerLoops<G>::inertia_of(const double* const (&x)[dim], const EdgeColumns& edges,
                                                                int p) const {
  const Placed at = placed(x, edges, p);
  return CornerWeights::inertia_at(at.place, at.edges, this->grid().h());
}

template <class G>
Square CornerLoops<G>::squeezed(const Two& place, const Square& edges) const {
  Matrix own;
  own << edges.xx, edges.xy, edges.yx, edges.yy;
  domains_.squeeze({place.x, place.y}, own);
  return {own(0, 0), own(0, 1), own(1, 0), own(1, 1)};
}

template <class G>
CellRange CornerLoops<G>::all_cells() const {
  return {{0, 0}, {this->grid().nodes(0) - 2, this->grid().nodes(1) - 2}};
}

template <class G>
CellRange CornerLoops<G>::cells_of(const Bins& bins, int bin) const {
  const int node = bins.node(bin), row = node / this->grid().row_length();
  const int first[] = {node - row * this->grid().row_length(), row}, reach = domains_.support() - 2;
  return {{first[0], first[1]}, {first[0] + reach, first[1] + reach}};
}

template <class G>
template <class Visit>
[[gnu::always_inline]] inline void CornerLoops<G>::for_points(const Columns& points, const At& at, const Chunk& chunk,
                                                              Visit&& visit) const {
  const Places<dim> places = at.places(points, true);
  const EdgeColumns edges(points);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    const CellRange cells = cells_of(at.bins, bin);
    for (int p = at.bins.start(bin); p < at.bins.end(bin); ++p) visit(p, weights(places.x, edges, p, cells));
  }
}

}  // namespace plumbline
