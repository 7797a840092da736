// The loops over points whose parallelograms carry tents at their corners, in two dimensions: for solids with affine
// velocities by all corners side by side, for all else along lists. Tests hold the first against the second.
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/engine/loops/corner_weights.hpp"
#include "kernel/engine/loops/list_loops.hpp"
#include "kernel/points/components.hpp"

namespace plumbline {

template <class Geometry>
class CornerLoops final : public ListLoops<Geometry> {
 public:
  static constexpr int dim = Geometry::dim;
  static_assert(dim == 2);
  using Lists = ListLoops<Geometry>;
  using typename Lists::At, typename Lists::Field, typename Lists::Vec;
  using typename Lists::Motion, typename Lists::Wanted;

  // make: of the lists of the same shape.
  CornerLoops(const GridSpec& spec, const Transfer& transfer, MakeListed<dim> make)
      : Lists(spec, transfer, make),
        domains_(Lists::grid()) {}

  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;

  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    side_by_side(body) ? map_motion<true>(body, at, chunk, field)
                       : Lists::map_mass_and_momentum(body, at, chunk, field);
  }
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    side_by_side(body) ? map_motion<false>(body, at, chunk, field) : Lists::map_momentum(body, at, chunk, field);
  }
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override;
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const override;
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const override;
  Survey survey(const Body& body, PointRange range) const override;
  Totals survey_motion(const Body& body, PointRange range) const override;

 private:
  using Lists::about;
  using Lists::rotations;
  using typename Lists::Matrix;

  // What has stress in all directions and no heat. The others' sums are those of gases and chains.
  bool side_by_side(const Body& body) const {
    const StressMeasure measure = body.material->measure();
    return (measure == StressMeasure::full || measure == StressMeasure::symmetric) && !body.material->takes_heat() &&
           this->transfer().affine && this->transfer().order == 0 && this->transfer().keep == 0;
  }
  static Matrix inverse(const Matrix& symmetric) {
    Matrix other;
    other << symmetric(1, 1), -symmetric(0, 1), -symmetric(1, 0), symmetric(0, 0);
    return other / (symmetric(0, 0) * symmetric(1, 1) - symmetric(0, 1) * symmetric(1, 0));
  }
  // tr(C D C^T).
  static double affine_square(const Matrix& c, const Matrix& inertia) { return (c * inertia).cwiseProduct(c).sum(); }
  static void add_spin(double m, const Matrix& s, Turn& turn) {
    if (rotations > 0) turn[about] += m * (s(1, 0) - s(0, 1));
  }
  static bool full(const Body& body) { return body.material->measure() == StressMeasure::full; }

  // Number: double, or const double where the points are only read.
  template <class Number>
  struct MovingColumns {
    Number* mass;
    Components<Vec, Number> position, velocity;
    Components<Matrix, Number> affine;
    template <class ColumnsRef>
    explicit MovingColumns(ColumnsRef& points)
        : mass(points(column::mass)),
          position(points, column::position),
          velocity(points, column::velocity),
          affine(points, column::affine) {}
  };
  struct RateColumns {
    double* at[dim * dim + 1];
    bool full;
    explicit RateColumns(Body& body) : full(CornerLoops::full(body)) {
      for (int k = 0; k < body.points.components(column::strain_rate); ++k) at[k] = body.points(column::strain_rate, k);
    }
  };

  CornerWeights weights(const double* const (&x)[dim], const DomainEdges<dim>& edges, int p,
                        const CellRange& cells) const;
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
};

template <class G>
[[gnu::always_inline]] inline CornerWeights CornerLoops<G>::weights(const double* const (&x)[dim],
                                                                    const DomainEdges<dim>& edges, int p,
                                                                    const CellRange& cells) const {
  const double h = this->grid().h();
  Vec place;
  for (int d = 0; d < dim; ++d) place[d] = domains_.place(x[d][p], d);
  Matrix own = edges[p] / h;
  domains_.squeeze(place, own);
  return CornerWeights(place, own, cells, this->grid().row_length(), h);
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
  const DomainEdges<dim> edges(points);
  for (int bin = chunk.first_bin; bin < chunk.last_bin; ++bin) {
    const CellRange cells = cells_of(at.bins, bin);
    for (int p = at.bins.start(bin); p < at.bins.end(bin); ++p) visit(p, weights(places.x, edges, p, cells));
  }
}

}  // namespace plumbline
