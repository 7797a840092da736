// What the parts of a step share and none of them changes: the grid with its walls, the loops of a shape and transfer, and
// what a scene fixes for all materials.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "kernel/engine/point_loops.hpp"
#include "kernel/limiter.hpp"
#include "kernel/nodal_pressure.hpp"
#include "kernel/normals/membrane_tangents.hpp"
#include "kernel/parallel.hpp"
#include "kernel/pressure_quadrature.hpp"
#include "kernel/scene.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/sharpening.hpp"
#include "kernel/summation.hpp"
#include "kernel/transfers/transfer.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

inline std::array<double, 3> amounts_of(const Scene& scene) {
  if (scene.sharpening == 0) return {};
  return {scene.sharpening, scene.sharpening_second, scene.sharpening_third};
}

// Whether anything is to be known per volume of the nodes' cells.
inline bool needs_volumes(const Scene& scene) {
  const bool gas = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                               [](const Body& body) { return body.material->has_density(); });
  return gas && (scene.density == DensityMethod::grid || scene.nodal_pressure || scene.sharpening_in_expansion < 1);
}

// Whether sums of pressures over points may be corrected.
inline bool corrects_pressures(const Scene& scene) {
  return scene.density == DensityMethod::grid && !scene.grid.axisymmetric && !scene.nodal_pressure;
}

template <class Geometry>
struct Discretisation {
  static constexpr int dim = Geometry::dim;
  static constexpr int rotations = Geometry::rotations;
  static constexpr std::size_t about = dim == 2 ? 2 : 0;  // the first rotation's place in a Turn
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Field = VelocityField<dim>;
  using Loops = PointLoops<Geometry>;

  Grid<dim> grid;
  Walls<dim> walls;
  Transfer transfer;
  std::unique_ptr<const Loops> loops;
  ShapeTraits shape;
  std::vector<double> inverse_volumes;  // 1 / |cell_i|, m^-dim; axisymmetric per radian; empty where no part needs them
  Sharpening<dim> sharpening;
  Limiter<dim> limiter;
  NodalPressure<dim> pressure;
  PressureQuadrature<dim> quadrature;
  double sharpening_in_expansion;  // the least share of it
  MaterialContext context;
  int threads;

  Discretisation(const Scene& scene, int thread_count)
      : grid(scene.grid),
        walls(grid),
        transfer(transfer_of(scene.transfer, scene.transfer_order)),
        loops(std::get<MakeLoops<Geometry>>(shape_named(scene.shape).loops)(scene.grid, transfer)),
        shape(loops->shape()),
        inverse_volumes(needs_volumes(scene) ? loops->inverse_volumes() : std::vector<double>()),
        sharpening(grid, shape.blur, amounts_of(scene)),
        limiter(grid),
        pressure(grid, scene.nodal_pressure && !Geometry::axisymmetric),
        quadrature(grid, shape.degree, corrects_pressures(scene) ? scene.quadrature : 0),
        sharpening_in_expansion(scene.sharpening_in_expansion),
        context{dim,
                grid.h(),
                scene.density == DensityMethod::continuity,
                0,
                scene.density == DensityMethod::grid,
                MembraneTangents::given_by(scene.normals)},
        threads(thread_count) {}

  // Whether what gases lose in the maps is a matter of time. [Filter 1]
  bool filters_at_rate(const Scene& scene) const { return transfer.affine && !scene.filter.none(); }

  // work(chunk) for each of one body's, in any order.
  template <class Work>
  void for_chunks(const Weights<dim>& at, Work&& work) const {
    const auto& chunks = at.bins.chunks();
    for_each_piece(at.bins.chunk_count(), threads, [&](int k) { work(chunks[static_cast<std::size_t>(k)]); });
  }
  // The same; chunks that could write the same node are never under way together, and always in the same order.
  template <class Work>
  void for_chunks_writing_nodes(const Weights<dim>& at, Work&& work) const {
    for (int colour = 0; colour < 2; ++colour) {
      const auto& blocks = at.bins.blocks(colour);
      for_each_piece(static_cast<int>(blocks.size()), threads, [&](int k) {
        const Bins::Block block = blocks[static_cast<std::size_t>(k)];
        for (int c = block.first; c < block.last; ++c) work(at.bins.chunks()[static_cast<std::size_t>(c)]);
      });
    }
  }
  // The sum of work(chunk) over all chunks, which does not depend on threads.
  template <class Sum, class Work>
  Sum sum_over_chunks(const Weights<dim>& at, Work&& work) const {
    const auto& chunks = at.bins.chunks();
    if (chunks.size() == 1) return work(chunks.front());
    std::vector<Sum> sums(chunks.size());
    for_chunks(at, [&](const Chunk& chunk) { sums[static_cast<std::size_t>(&chunk - chunks.data())] = work(chunk); });
    return pairwise_sum(sums.data(), sums.size());
  }
  // The same for work that writes nodes.
  template <class Sum, class Work>
  Sum sum_over_chunks_writing_nodes(const Weights<dim>& at, Work&& work) const {
    const auto& chunks = at.bins.chunks();
    if (chunks.size() == 1) return work(chunks.front());
    std::vector<Sum> sums(chunks.size());
    for_chunks_writing_nodes(
        at, [&](const Chunk& chunk) { sums[static_cast<std::size_t>(&chunk - chunks.data())] = work(chunk); });
    return pairwise_sum(sums.data(), sums.size());
  }
  void spread(const Columns& points, const Weights<dim>& at, std::span<const typename Loops::Spread> all) const {
    for_chunks_writing_nodes(at, [&](const Chunk& chunk) { loops->spread(points, at, chunk, all); });
  }
  void gather(const Columns& points, const Weights<dim>& at, std::span<const typename Loops::Gather> all) const {
    for_chunks(at, [&](const Chunk& chunk) { loops->gather(points, at, chunk, all); });
  }

  // Marks the nodes that the points reach.
  void touch(const Weights<dim>& at, Field& field) const {
    const int length = grid.row_length();
    for (int bin = 0; bin < at.bins.bins(); ++bin) {
      const int node = at.bins.node(bin), row = node / length, first = node - row * length,
                last = first + shape.support;
      for (int z = 0; z < (dim > 2 ? shape.support : 1); ++z) {
        for (int y = 0; y < (dim > 1 ? shape.support : 1); ++y) {
          int here = row + y;
          if constexpr (dim > 2) here += z * (grid.stride(2) / length);
          auto& range = field.touched[static_cast<std::size_t>(here)];
          range = range.first == range.second ? std::pair{first, last}
                                              : std::pair{std::min(range.first, first), std::max(range.second, last)};
        }
      }
    }
  }
  // The same of one body's points alone, with no mass yet.
  void touch_alone(const Weights<dim>& at, Field& field) const {
    std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
    touch(at, field);
    walls.include_mirrors(field.touched);
    field.for_touched(grid, [&](std::size_t i) { field.mass[i] = 0; });
  }

  // For all that is sharpened until velocities are mapped anew, by the velocity that was.
  void limit_sharpening(Field& field, const std::vector<Vec>& velocity) const {
    if (sharpening.none() || sharpening_in_expansion == 1 || inverse_volumes.empty()) return;
    limiter.find_kept(field, inverse_volumes, sharpening_in_expansion, velocity, field.held(field.gas.slopes),
                      field.held(field.corrected.kept), threads);
  }
  // The nodal velocity whose gradients strain the points: sharpened as the accelerations are. [Sharpening 1]
  const std::vector<Vec>& straining_velocity(Field& field, const std::vector<Vec>& velocity) const {
    if (sharpening.none()) return velocity;
    std::vector<Vec>& straining = field.held(field.corrected.straining);
    sharpening.apply(field, velocity, straining, threads);
    walls.extend(field, straining);
    return straining;
  }

  // Whether the stress of a body acts at the nodes. [Pressure 3]
  bool acts_at_nodes(const Body& body) const {
    return !pressure.none() && body.material->measure() == StressMeasure::pressure;
  }
  // Whether the forces of its pressures are corrected. own_mass: the gas on its field's nodes is its own. [Quadrature 2]
  bool corrects(const Body& body, bool own_mass) const {
    return !quadrature.none() && own_mass && body.material->measure() == StressMeasure::pressure && !body.enclosure;
  }
  // What of a straining velocity strains a body. corrected: the forces of its pressures are, and were mapped.
  typename Loops::Straining straining(const Body& body, const Weights<dim>& at, Field& field,
                                      const std::vector<Vec>& velocity, bool corrected) const {
    if constexpr (dim > 1) {
      if (corrected) {
        std::vector<double>& mean = field.held(field.gas.mean);
        field.for_touched(
            grid, [&](std::size_t i) { mean[i] = 0; }, threads);
        for_chunks_writing_nodes(
            at, [&](const Chunk& chunk) { loops->map_divergence(body.points, at, chunk, velocity, mean); });
        walls.fold_even(field, mean);
        quadrature.find_correction(field, velocity, inverse_volumes, threads);
        walls.extend_even(field, mean);
        return {.velocity = &velocity, .divergence = &mean};
      }
    }
    if (!acts_at_nodes(body)) return {.velocity = &velocity};
    find_flow(field, velocity);
    std::vector<double>& divergence = field.held(field.gas.divergence);
    field.for_touched(
        grid, [&](std::size_t i) { divergence[i] = field.gas.stretch[i].sum(); }, threads);
    return {.divergence = &divergence};
  }
  // By a nodal velocity, beyond walls too. [Pressure 2]
  void find_flow(Field& field, const std::vector<Vec>& velocity) const {
    pressure.find_flow(field, velocity, threads);
    walls.extend_flow(field, field.gas.faces, field.gas.stretch);
  }

  // Q u - u of a nodal velocity u; nothing where a gas shares the node with a membrane, through which it must not move.
  // [Sharpening 2]
  const std::vector<Vec>& added_by_sharpening(Field& field, const std::vector<Vec>& velocity) const {
    std::vector<Vec>& added = field.held(field.corrected.added);
    sharpening.apply(field, velocity, added, threads);
    field.for_touched(
        grid,
        [&](std::size_t i) {
          const bool shared = field.mixed() && field.gas.mass[i] < field.mass[i];
          added[i] = shared ? Vec(Vec::Zero()) : Vec(added[i] - velocity[i]);
        },
        threads);
    walls.extend(field, added);
    return added;
  }

  // How fast the straining velocity closes; null: the body's material does not ask. [Limiter 1]
  const std::vector<double>* closing(const Body& body, Field& field, const std::vector<Vec>& straining) const {
    if (!body.points.has(column::closing)) return nullptr;
    std::vector<double>& closing = field.held(field.gas.closing);
    limiter.apply(field, straining, field.held(field.gas.slopes), closing, threads);
    walls.extend_even(field, closing);
    return &closing;
  }

  // What points put on nodes, per mass of those that put it: zero where there is none, continued beyond the walls.
  void divide_sums(const Field& field, const std::vector<double>& mass, std::vector<double>& values) const {
    walls.fold_even(field, values);
    field.for_touched(
        grid, [&](std::size_t i) { values[i] = mass[i] > least_mass ? values[i] / mass[i] : 0.0; }, threads);
    walls.extend_even(field, values);
  }
  // values_i / M_i, zero where no mass is, continued beyond the walls.
  void divide_by_mass(const Field& field, const std::vector<Vec>& values, std::vector<Vec>& quotient) const {
    field.for_touched(
        grid,
        [&](std::size_t i) {
          quotient[i] = field.mass[i] > least_mass ? Vec(values[i] / field.mass[i]) : Vec(Vec::Zero());
        },
        threads);
    walls.extend(field, quotient);
  }
};

}  // namespace plumbline
