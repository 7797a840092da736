// The loops of quadratic B-splines, for wrong shapes that differ from them in one function.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "kernel/shapes/shape.hpp"
#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong {

template <class Geometry>
class AroundQuadratic : public PointLoops<Geometry> {
 public:
  using Base = PointLoops<Geometry>;
  using typename Base::Field, typename Base::Gather, typename Base::Motion, typename Base::Spread,
      typename Base::Wanted;
  using At = Weights<Geometry::dim>;

  AroundQuadratic(const GridSpec& grid, const Transfer& transfer)
      : right_(std::get<MakeLoops<Geometry>>(shape_named("quadratic").loops)(grid, transfer)) {}

  ShapeTraits shape() const override { return right_->shape(); }
  std::vector<double> inverse_volumes() const override { return right_->inverse_volumes(); }
  void find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                             std::vector<double>& volume) const override {
    right_->find_enclosed_volumes(chain, corners, volume);
  }
  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override {
    return right_->find_lowest(points, range, lowest);
  }
  double inertia(const Columns& points, int d, int p) const override { return right_->inertia(points, d, p); }
  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    right_->map_mass_and_momentum(body, at, chunk, field);
  }
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override {
    right_->map_momentum(body, at, chunk, field);
  }
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override {
    return right_->map_forces(body, at, chunk, shares, field);
  }
  void spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const override {
    right_->spread(points, at, chunk, all);
  }
  void gather(const Columns& points, const At& at, const Chunk& chunk, std::span<const Gather> all) const override {
    right_->gather(points, at, chunk, all);
  }
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const override {
    return right_->gather_start(body, at, chunk, wanted);
  }
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const override {
    return right_->gather_motion(body, at, chunk, field, motion);
  }
  Survey survey(const Body& body, PointRange range) const override { return right_->survey(body, range); }

 private:
  std::unique_ptr<PointLoops<Geometry>> right_;
};

// Loops<Geometry> is derived from AroundQuadratic<Geometry>.
template <template <class> class Loops, class Geometry>
std::unique_ptr<PointLoops<Geometry>> make_around(const GridSpec& grid, const Transfer& transfer) {
  return std::make_unique<Loops<Geometry>>(grid, transfer);
}

template <template <class> class Loops>
ShapeEntry shape_around(const std::string& name, const std::string& defect) {
  ShapeEntry entry = shape_named("quadratic");
  entry.name = name;
  entry.title = defect;
  entry.source = here;
  entry.loops = {make_around<Loops, Line>, make_around<Loops, Plane>, make_around<Loops, Axisymmetric>,
                 make_around<Loops, Solid>};
  return entry;
}

}  // namespace plumbline::wrong
