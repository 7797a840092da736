// A drag on the points of a body, beside what else its load gives them.
#pragma once

#include <functional>
#include <span>
#include <utility>

#include "kernel/points/column_names.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

// What Body::load holds.
using Load = std::function<void(double time, Columns& points, std::span<const int> id)>;

// Adds -rate v to the force per mass of each point. rate: 1/s, >= 0.
inline void add_drag(Columns& points, double rate) {
  for (int d = 0; d < points.components(column::body_force); ++d) {
    const double* v = points(column::velocity, d);
    double* force = points(column::body_force, d);
    for (int p = 0; p < points.points(); ++p) force[p] -= rate * v[p];
  }
}

// A load and that drag.
inline Load with_drag(Load load, double rate) {
  return [load = std::move(load), rate](double time, Columns& points, std::span<const int> id) {
    load(time, points, id);
    add_drag(points, rate);
  };
}

}  // namespace plumbline
