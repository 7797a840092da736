// What the parts of a step share and none of them changes: the grid with its walls, and the loops of a shape and transfer.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "kernel/engine/chunks.hpp"
#include "kernel/engine/point_loops.hpp"
#include "kernel/scene.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

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
  int threads;

  Discretisation(const Scene& scene, int thread_count)
      : grid(scene.grid),
        walls(grid),
        transfer(transfer_of(scene.transfer, scene.transfer_order)),
        loops(std::get<MakeLoops<Geometry>>(shape_named(scene.shape).loops)(scene.grid, transfer)),
        shape(loops->shape()),
        threads(thread_count) {}

  // See chunks.hpp.
  template <class Work>
  void for_chunks(const Weights<dim>& at, Work&& work) const {
    plumbline::for_chunks(at.bins, threads, work);
  }
  template <class Work>
  void for_chunks_writing_nodes(const Weights<dim>& at, Work&& work) const {
    plumbline::for_chunks_writing_nodes(at.bins, threads, work);
  }
  template <class Sum, class Work>
  Sum sum_over_chunks(const Weights<dim>& at, Work&& work) const {
    return plumbline::sum_over_chunks<Sum>(at.bins, threads, work);
  }
  template <class Sum, class Work>
  Sum sum_over_chunks_writing_nodes(const Weights<dim>& at, Work&& work) const {
    return plumbline::sum_over_chunks_writing_nodes<Sum>(at.bins, threads, work);
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
