// Dilatation of solids that the points of a cell share. As many points as a cell holds would each keep their volume where a
// material hardly compresses, more than the cell's nodes are free to do: it locks. One mean a cell does not
// (Simo, Taylor, Pister 1985, doi 10.1016/0045-7825(85)90033-7; by projection of the rates: Telikicherla, Moutsanidis 2024,
// arXiv 2407.03826).
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/engine/discretisation.hpp"
#include "kernel/materials/shared_dilatation.hpp"

namespace plumbline {

// With the mean of a quantity q over the points of a cell, where they were located, q^c = sum_p m_p q_p / sum_p m_p, the
// dilatation theta_p that most of a point's pressure comes from, see Bulk, grows by the mean rate
//   dtheta_p/dt = (div v)^c                                                                            [Dilatation 1]
// and the pressure is that of the mean theta^c [Dilatation 2]. The energy lambda/2 theta_p^2 per volume at rest then grows by what
// the pressures do over the points' own div v: lambda/rho_0 (div v)^c sum_p m_p theta_p of a cell, either way. A point that comes to
// another cell brings its theta along. Of finite strains what a step changes ln J by beyond dt div v is added to theta_p [Dilatation 4]:
// the theta of a cell stays the dilatation of its points.
template <class Geometry>
class MeanDilatation {
 public:
  static constexpr int dim = Geometry::dim;
  using Space = Discretisation<Geometry>;

  explicit MeanDilatation(const Space& space) : space_(space) {}

  // Before the first step: if the material hardly compresses.
  static void add_columns(Body& body) {
    if (body.points.has(column::dilatation)) return;
    body.material->share_dilatation(body.points);
    if (!of(body)) return;
    body.points.add(column::dilatation_rate);
    body.points.add(column::mean_dilatation);
  }

  static bool of(const Body& body) { return body.points.has(column::dilatation); }

  // Of the strain rates that the points hold.
  void average_rates(Body& body, const Weights<dim>& at) const {
    if (!of(body)) return;
    const bool full = body.material->measure() == StressMeasure::full;
    double* rate = body.points(column::dilatation_rate);
    std::fill_n(rate, body.points.points(), 0.0);
    for (int k = 0; k < Geometry::normals; ++k) {
      const double* own = body.points(column::strain_rate, !full ? k : k < dim ? k * (dim + 1) : dim * dim);
      for (int p = 0; p < body.points.points(); ++p) rate[p] += own[p];
    }
    average(body, at, rate, rate);
  }
  void average_dilatation(Body& body, const Weights<dim>& at) const {
    if (of(body)) average(body, at, body.points(column::dilatation), body.points(column::mean_dilatation));
  }

 private:
  int cell_of(const Places<dim>& places, int p) const {
    int cell = 0, stride = 1;
    for (int d = 0; d < dim; ++d) {
      const int cells = space_.grid.cells(d);
      cell += stride * std::clamp(static_cast<int>(space_.grid.logical(places.x[d][p], d)), 0, cells - 1);
      stride *= cells;
    }
    return cell;
  }

  // The means of `values`, which may be `means` itself.
  void average(const Body& body, const Weights<dim>& at, const double* values, double* means) const {
    struct Sums {
      double mass = 0, value = 0;
    };
    std::size_t cells = 1;
    for (int d = 0; d < dim; ++d) cells *= static_cast<std::size_t>(space_.grid.cells(d));
    std::vector<Sums> sums(cells);
    std::vector<int> cell(static_cast<std::size_t>(body.points.points()));
    const Places<dim> places = at.places(body.points, false);
    const double* mass = body.points(column::mass);
    for (int p = 0; p < body.points.points(); ++p) {
      const int own = cell[static_cast<std::size_t>(p)] = cell_of(places, p);
      sums[static_cast<std::size_t>(own)].mass += mass[p];
      sums[static_cast<std::size_t>(own)].value += mass[p] * values[p];
    }
    for (int p = 0; p < body.points.points(); ++p) {
      const Sums& own = sums[static_cast<std::size_t>(cell[static_cast<std::size_t>(p)])];
      means[p] = own.value / own.mass;
    }
  }

  const Space& space_;
};

}  // namespace plumbline
