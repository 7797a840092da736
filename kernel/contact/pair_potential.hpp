// Contact from a potential of the distances between points of two bodies.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "kernel/scene.hpp"

namespace plumbline {

namespace column {
inline const ColumnId contact_force{"contact_force", "N"};          // F_p of all pairs of the point
inline const ColumnId contact_velocity{"contact_velocity", "m/s"};  // of the grid where the point stands
}  // namespace column

// Points p and q of bodies that name different fields repel each other where they are nearer than r_0:
//   U = K/2 s^2,  s = max(0, r_0 - r),  r = |x_q - x_p|                                                [Pairs 1]
//   r_0 = 1.6 (l_p + l_q)/2,  2/K = 1/K_p + 1/K_q,  K_p = M_p l_p^(dim-2)/8                            [Pairs 2]
// with l the spacing and M the modulus of compression at rest. At 1.4, the diagonal of a lattice, points of two bodies that press
// hard still slip between each other; a stiffer pair gives away more of an impact, a softer one lengthens it.
// Over a time the force is the mean of that on the way, n = (x_q - x_p)/r of its start:
//   F_q = -F_p = n (U(r) - U(r_1))/(r_1 - r),  r_1 = r + dt n . (v_q - v_p)                            [Pairs 3]
// The distance becomes r_1 or more, so that U never gains more than F takes.
template <int dim>
class PairPotential {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;

  // All pairs that could press before points are located again, from where they stand.
  void find(const std::vector<Body>& bodies);

  bool none() const { return pairs_.empty(); }
  // Whether a body has points in pairs.
  bool of(std::size_t body) const { return involved_[body]; }

  // Sets the columns contact_force of bodies with pairs: the mean over a time, s, >= 0, in which points move with the column
  // contact_velocity from where they stand.
  void press(std::vector<Body>& bodies, double time) const;

  // sum of U where the points stand, J.
  double energy(const std::vector<Body>& bodies) const;

 private:
  struct Pair {
    std::size_t a, b;  // bodies
    int p, q;          // points
    double reach, stiffness;
  };
  void find_between(const std::vector<Body>& bodies, std::size_t a, std::size_t b);
  std::vector<Pair> pairs_;
  std::vector<bool> involved_;
};

extern template class PairPotential<1>;
extern template class PairPotential<2>;
extern template class PairPotential<3>;

// Whether bodies of different fields meet by pairs of points.
bool meets_by_pairs(const Scene& scene);

// Throws std::invalid_argument where they do and could not: about an axis, and without a modulus at rest.
void check_pairs(const Scene& scene);

// The energy of the scene's pairs, J, which the ledger's stores do not hold: what it takes and gives is work of contact there.
double contact_energy(const Scene& scene);

}  // namespace plumbline
