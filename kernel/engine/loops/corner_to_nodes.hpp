// Where points with corners stand, and what they put on the nodes.
#pragma once

#include "kernel/engine/loops/corner_loops.hpp"

namespace plumbline {

template <class G>
bool CornerLoops<G>::find_lowest(const Columns& points, PointRange range, int* lowest) const {
  const Grid<dim>& grid = this->grid();
  const CellRange all = all_cells();
  const EdgeColumns edges(points);
  const double* const x[] = {points(column::position, 0), points(column::position, 1)};
  bool inside = true;
  for (int p = range.first; p < range.last; ++p) {
    const CornerWeights at = weights(x, edges, p, all);
    inside = inside && on_grid(x, p);
    int node = 0;
    for (int d = 0; d < dim; ++d) node += std::min(at.lowest(d), grid.nodes(d) - domains_.support()) * grid.stride(d);
    lowest[p] = node;
  }
  return inside;
}

template <class G>
template <bool with_mass>
void CornerLoops<G>::map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  const MovingColumns<const double> from(body.points);
  double *masses = field.mass.data(), *momenta = field.momentum.front().data();
  for_points(
      body.points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        weights.template spread_motion<with_mass>(from.mass[p], from.velocity(p), from.affine(p), masses, momenta);
      });
}

template <class G>
double CornerLoops<G>::map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares,
                                  Field& field) const {
  if (!side_by_side(body) || shares != Shares::none) return Lists::map_forces(body, at, chunk, shares, field);
  const Columns& points = body.points;
  const bool whole = full(body);
  const double* stress[dim * dim + 1];
  for (int k = 0; k < points.components(column::stress); ++k) stress[k] = points(column::stress, k);
  const double *volume = points(column::volume), *radius = at.places(points, true).x[0];
  double* forces = field.force.front().data();
  double hoop_force = 0;
  for_points(
      points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        Two base{0, 0};
        if (G::axisymmetric) {
          base.x = -volume[p] * stress[whole ? dim * dim : 2][p] / domains_.radius(radius[p]);
          hoop_force += base.x;
        }
        Square flux;  // [York 3.17] [EC-APIC 4]
        if (whole) {
          flux = {stress[0][p], stress[1][p], stress[2][p], stress[3][p]};
        } else {
          double s[G::strains], of[dim][dim];
          for (int k = 0; k < G::strains; ++k) s[k] = stress[k][p];
          G::flux(s, of);
          flux = {of[0][0], of[0][1], of[1][0], of[1][1]};
        }
        weights.spread_force(base, flux.times(-volume[p]), forces);
      });
  return hoop_force;
}

template <class G>
void CornerLoops<G>::spread(const Columns& points, const At& at, const Chunk& chunk,
                            std::span<const Spread> all) const {
  for_points(
      points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        for (const Spread& one : all) {
          const double q = one.mass ? one.mass[p] * one.values[p] : one.values[p];
          weights.for_nodes([&](int node, double n) { one.nodes[node * one.stride] += n * q; });
        }
      });
}

}  // namespace plumbline
