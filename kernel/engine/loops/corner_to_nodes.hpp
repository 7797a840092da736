// Where points with corners stand, and what they put on the nodes.
#pragma once

#include "kernel/engine/loops/corner_loops.hpp"
#include "kernel/engine/loops/lowest_nodes.hpp"

namespace plumbline {

template <class G>
[[gnu::always_inline]] inline Pack CornerLoops<G>::lowest_node(const PackVector& place, const EdgeColumns& edges, int p,
                                                               int count, PackMask& inside) const {
  const Grid<dim>& grid = this->grid();
  inside = inside && (on_grid(place) || !first_lanes(count));
  const Parallelograms at = domains(place, edges, p);
  const PackVector reach = at.reach();
  const auto lowest = [&](const Pack& corner, int d) {
    return min(max(floor(corner), Pack(0.0)), Pack(grid.nodes(d) - domains_.support())) * grid.stride(d);
  };
  return lowest(at.place.x - reach.x, 0) + lowest(at.place.y - reach.y, 1);
}

template <class G>
bool CornerLoops<G>::find_lowest(const Columns& points, PointRange range, int* lowest) const {
  const EdgeColumns edges(points);
  const double* const x[] = {points(column::position, 0), points(column::position, 1)};
  return store_lowest_nodes(
      range, lowest, [&](int p, int count, PackMask& inside) __attribute__((always_inline)) {
        return lowest_node({load(x[0] + p), load(x[1] + p)}, edges, p, count, inside);
      });
}

template <class G>
template <bool with_mass>
void CornerLoops<G>::map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  const MovingColumns<const double> from(body.points);
  for_bins(body.points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    Pack masses[side * side] = {}, momenta[side * side * dim] = {};
    for_packs_here([&](const Parallelograms&, const DomainWeights<side>& weights, int p, int count)
                       __attribute__((always_inline)) {
                         const Pack m = kept(load(from.mass + p), count);
                         const PackVector v = from.velocity(p);
                         const PackMatrix c = from.affine(p);
                         for (int b = 0; b < side; ++b) {
                           const PackVector row{v.x + c.xy * weights.y[b], v.y + c.yy * weights.y[b]};
                           for (int a = 0; a < side; ++a) {
                             const int k = a + side * b;
                             const Pack share = m * weights.n[k];
                             if (with_mass) masses[k] += share;                          // [York 3.15]
                             momenta[k * dim] += share * (row.x + c.xx * weights.x[a]);  // [York 3.16] [EC-APIC 1]
                             momenta[k * dim + 1] += share * (row.y + c.yx * weights.x[a]);
                           }
                         }
                       });
    if (with_mass) block.template add_to_nodes<1>(masses, field.mass.data());
    block.template add_to_nodes<dim>(momenta, component(field.momentum, 0));
  });
}

template <class G>
double CornerLoops<G>::map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares,
                                  Field& field) const {
  if (!in_packs(body) || shares != Shares::none) return Lists::map_forces(body, at, chunk, shares, field);
  const Columns& points = body.points;
  const bool whole = full(body);
  const double *stress[dim * dim + 1], *volume = points(column::volume);
  for (int k = 0; k < points.components(column::stress); ++k) stress[k] = points(column::stress, k);
  const double* x = at.places(points, true).x[0];
  Pack hoop_force = 0.0;
  for_bins(points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    Pack forces[side * side * dim] = {};
    for_packs_here([&](const Parallelograms&, const DomainWeights<side>& weights, int p,
                       int count) __attribute__((always_inline)) {
      const Pack v = -load(volume + p);
      PackMatrix flux;  // [York 3.17] [EC-APIC 4]
      if (whole) {
        flux = {load(stress[0] + p), load(stress[1] + p), load(stress[2] + p), load(stress[3] + p)};
      } else {
        Pack s[G::strains], of[dim][dim];
        for (int k = 0; k < G::strains; ++k) s[k] = load(stress[k] + p);
        G::flux(s, of);
        flux = {of[0][0], of[0][1], of[1][0], of[1][1]};
      }
      // Of each edge's dual vector; packs that are not full may hold domains without area.
      const PackMatrix by = flux.times(v) * weights.duals.transposed();
      const PackMatrix force{kept(by.xx, count), kept(by.xy, count), kept(by.yx, count), kept(by.yy, count)};
      Pack hoop = 0.0;
      if (G::axisymmetric) {
        hoop = kept(v * load(stress[whole ? dim * dim : 2] + p) / radius(load(x + p)), count);
        hoop_force += hoop;
      }
      for (int k = 0; k < side * side; ++k) {
        forces[k * dim] += force.xx * weights.first[k] + force.xy * weights.second[k];
        forces[k * dim + 1] += force.yx * weights.first[k] + force.yy * weights.second[k];
        if (G::axisymmetric) forces[k * dim] += hoop * weights.n[k];
      }
    });
    block.template add_to_nodes<dim>(forces, component(field.force, 0));
  });
  return sum(hoop_force);
}

template <class G>
void CornerLoops<G>::spread(const Columns& points, const At& at, const Chunk& chunk,
                            std::span<const Spread> all) const {
  for_bins(points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    Pack sums[Lists::most_spread][side * side] = {};
    for_packs_here([&](const Parallelograms&, const DomainWeights<side>& weights, int p,
                       int count) __attribute__((always_inline)) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        const Pack one = load(all[j].values + p), q = kept(all[j].mass ? load(all[j].mass + p) * one : one, count);
        for (int k = 0; k < side * side; ++k) sums[j][k] += q * weights.n[k];
      }
    });
    for (std::size_t j = 0; j < all.size(); ++j) {
      block.for_nodes(
          [&](int k, std::size_t i) { all[j].nodes[i * static_cast<std::size_t>(all[j].stride)] += sum(sums[j][k]); });
    }
  });
}

}  // namespace plumbline
