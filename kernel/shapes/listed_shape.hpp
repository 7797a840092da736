// Shapes that are no products of functions of one coordinate: they list the nodes that each point reaches.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "kernel/engine/point_loops.hpp"
#include "kernel/grid.hpp"

namespace plumbline {

// What points reach, one point after another.
template <int dim>
class NodeList {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  struct Entry {
    int node;  // in the flat arrays
    double value;
    Vec gradient;  // 1/m
  };

  // N_ip and grad N_ip of the point that is being listed. What comes twice counts twice.
  void add(int node, double value, const Vec& gradient) { entries_.push_back({node, value, gradient}); }
  // All its nodes are listed.
  void end_point() { end_.push_back(entries_.size()); }

  // No point is listed; the memory stays.
  void clear() {
    entries_.clear();
    end_.clear();
  }

  bool holds_memory() const { return entries_.capacity() > 0; }  // not so once it was moved elsewhere

  int points() const { return static_cast<int>(end_.size()); }
  std::span<const Entry> of(int point) const {
    const auto p = static_cast<std::size_t>(point);
    const std::size_t first = p == 0 ? 0 : end_[p - 1];
    return {entries_.data() + first, end_[p] - first};
  }

 private:
  std::vector<Entry> entries_;
  std::vector<std::size_t> end_;
};

// A list in memory that stays with the thread: those of a chunk are long, and a step wants several of each.
template <int dim>
class SpareList {
 public:
  SpareList() {
    if (spare().empty()) return;
    list_ = std::move(spare().back());
    spare().pop_back();
    list_.clear();
  }
  SpareList(SpareList&&) = default;
  SpareList& operator=(SpareList&&) = default;
  ~SpareList() {
    if (list_.holds_memory()) spare().push_back(std::move(list_));
  }

  NodeList<dim>& operator*() { return list_; }
  const NodeList<dim>& operator*() const { return list_; }

 private:
  static std::vector<NodeList<dim>>& spare() {
    thread_local std::vector<NodeList<dim>> lists;
    return lists;
  }
  NodeList<dim> list_;
};

// A shape on one grid. Of every point sum_i N_ip = 1 and sum_i N_ip x_i = x_p; the affine transfer also wants nodes that are not
// all in one line or plane.
template <int dim>
class ListedShape {
 public:
  virtual ~ListedShape() = default;

  // support: a block of so many nodes a direction holds all that any point reaches.
  virtual ShapeTraits traits() const = 0;

  // Lists what points range.first ... range.last - 1 reach from the places at.x, all on the grid. Beside these it may read only
  // columns that no step changes, at.half_size and what follow() has set: every stage of a step has the same weights.
  virtual void list(const Columns& points, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const = 0;

  // Whether solids that move keep the energy of their affine velocities, whatever becomes of their inertia: C_p then changes.
  virtual bool keeps_affine_energy() const { return false; }
  // Whether follow() does something.
  virtual bool follows() const { return false; }
  // Sets columns of its own from the points as they are, once a step, before they are located.
  virtual void follow(Columns&) const {}
};

// Makes the shape on a grid.
template <int dim>
using MakeListed = std::unique_ptr<const ListedShape<dim>> (*)(const Grid<dim>&);

}  // namespace plumbline
