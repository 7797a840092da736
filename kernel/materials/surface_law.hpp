// What a membrane in space stores, and its stresses, by how its tangents are stretched.
#pragma once

#include <Eigen/Core>

#include "kernel/points/columns.hpp"

namespace plumbline {

namespace column {
// f_1, then f_2: where two orthonormal tangents of the surface at rest are carried to
inline const ColumnId tangents{"tangents", "1"};
}  // namespace column

// Where the material of a membrane stores energy, per volume at rest, by the metric c_ab = f_a . f_b of its tangents; S_ab = 2 dW/dc_ab:
//   plane stress of St. Venant and Kirchhoff, e = (c - 1)/2:  W = E / (2 (1 - nu^2)) ((1 - nu) e : e + nu (tr e)^2),
//     and one-way: of its principal stresses none is negative (tension field, Pipkin 1986, doi 10.1093/imamat/36.1.85);
//   incompressible neo-Hookean, mu = E / 3:  W = mu / 2 (tr c + 1 / det c - 3). [Surface 2]
struct SurfaceLaw {
  double youngs_modulus = 0;  // E, Pa, > 0
  double poissons_ratio = 0;  // nu, (-1, 1/2]; not of the neo-Hookean
  double density = 0;         // rho_0, kg/m^3, > 0
  double thickness = 0;       // t at rest, m, > 0
  bool one_way = false;       // wrinkles: carries no compression
  bool neo_hookean = false;

  struct Metric {
    double first, mixed, second;  // c_11, c_12, c_22
    double determinant() const { return first * second - mixed * mixed; }
  };
  struct State {
    double energy;                // W, Pa
    double first, mixed, second;  // S_11, S_12, S_22, Pa
  };
  State state(const Metric& metric) const;
  // Principal resultants over the thickness at rest, Pa; of incompressible membranes Cauchy's stresses are these times
  // the root of det c. [Surface 2]
  struct Stresses {
    double largest, least;
  };
  Stresses principal_stresses(const Metric& metric) const;
  // Of the fastest wave in the membrane, m/s through space.
  double wave_speed(const Metric& metric) const;
  // Of points first ... last - 1 the fastest, m/s.
  double fastest_wave(const Columns& points, int first, int last) const;
  // Throws std::invalid_argument where the choices exclude each other, or the dimension is not 3.
  void refuse_what_cannot_work(int dim) const;

 private:
  State taut(const Metric& strain) const;  // St. Venant and Kirchhoff, of e
};

// The metric of the tangents that point p holds.
SurfaceLaw::Metric metric_of(const Columns& points, int p);

// Where point p stands in space, m.
Eigen::Vector3d place_of(const Columns& points, int p);

}  // namespace plumbline
