#pragma once
// What the manufactured motions share: numbers with and without bounds from one formula.
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/manufactured/manufactured.hpp"

namespace plumbline::reference {

template <class Number>
Number circle_constant() {
  if constexpr (std::is_same_v<Number, Bounded>) {
    return pi;
  } else {
    return pi.value;
  }
}

/// `Field` has motion<Number>(position, time) and contains(position).
template <class Field>
class ManufacturedMotion : public ManufacturedSolution {
 public:
  ManufacturedMotion(Field field, int dimension, double youngs_modulus, double poisson, double density, double end_time)
      : ManufacturedSolution(dimension, youngs_modulus, poisson, density, end_time),
        field_(std::move(field)) {}
  bool contains(std::span<const double> position) const override { return field_.contains(position); }

 private:
  Motion<double> motion(const Vector<double>& position, double time) const override {
    return field_.template motion<double>(position, time);
  }
  Motion<Bounded> bounded_motion(const Vector<double>& position, double time) const override {
    return field_.template motion<Bounded>(position, time);
  }
  Field field_;
};

/// True within an annulus; a coordinate pair on an edge may lie outside it by rounding.
inline bool within_annulus(std::span<const double> position, double inner, double outer) {
  const double radius = std::hypot(position[0], position[1]), rounding_error = 4 * rounding::unit * outer;
  return radius >= inner - rounding_error && radius <= outer + rounding_error;
}

/// E > 0, rho > 0, 0 < inner < outer.
inline void check_annulus(double youngs_modulus, double density, double inner, double outer) {
  check_positive("youngs_modulus", youngs_modulus);
  check_positive("density", density);
  check_positive("inner", inner);
  check_positive("outer", outer);
  if (!(inner < outer)) throw ParameterError("inner", inner, "less than outer");
}

}  // namespace plumbline::reference
