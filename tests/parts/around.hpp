// A material for wrong ones that differ from it in one function.
#pragma once

#include <vector>

#include "kernel/materials/material.hpp"

namespace plumbline::wrong {

// Does all as Right does, made by right().
template <class Right>
struct Around : Material {
  virtual Right right() const = 0;

  StressMeasure measure() const override { return right().measure(); }
  bool dissipates() const override { return right().dissipates(); }
  void add_columns(Columns& points, int dim) const override { right().add_columns(points, dim); }
  Store store() const override { return right().store(); }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override {
    return right().advance(points, range, context, dt);
  }
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override {
    return right().internal_variables(context);
  }
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override {
    return right().rates(points, context);
  }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    right().evaluate_stress(points, range, context);
  }
  double stored_energy(const Columns& points, PointRange range) const override {
    return right().stored_energy(points, range);
  }
  double heat(const Columns& points, PointRange range) const override { return right().heat(points, range); }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    return right().step_bounds(points, range, dim);
  }
  Fault first_fault(const Columns& points, PointRange range) const override {
    return right().first_fault(points, range);
  }
};

}  // namespace plumbline::wrong
