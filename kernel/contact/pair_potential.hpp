// Contact from a potential of the distances between points of two bodies.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "kernel/contact/pair_friction.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

namespace column {
inline const ColumnId contact_force{"contact_force", "N"};          // F_p of all pairs of the point
inline const ColumnId contact_velocity{"contact_velocity", "m/s"};  // of the grid where the point stands
}  // namespace column

inline constexpr double pair_reach = 2.5;  // r_0 over a spacing

// Points p and q of bodies that name different fields repel each other where they are nearer than r_0:
//   U = K/4 s^4/l^2,  s = max(0, r_0 - r),  r = |x_q - x_p|,  l = (l_p + l_q)/2                            [Pairs 1]
//   r_0 = 2.5 l,  2/K = 1/K_p + 1/K_q,  K_p = M_p l_p^(dim-2)/4                                         [Pairs 2]
// with l_p the spacing and M_p the modulus of compression at rest. The reach and the fourth power make what a row of points feels of
// another hardly vary along it: lightly pressed rows of springs of 1.6 l would hold each other up to a slope of .3.
// Over a time in which x = x_q - x_p becomes x_1 = x + dt (v_q - v_p) the force is a mean of that on the way, which takes what U
// falls by, however the points turn about each other:
//   F_q = -F_p = (U(r) - U(r_1))/(r_1 - r) (x + x_1)/(r + r_1),  r_1 = |x_1|                             [Pairs 3]
// (LaBudde and Greenspan 1976, doi 10.1007/BF01396331)
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
  void press(std::vector<Body>& bodies, double time);

  // Pairs that press, as of the last press().
  std::vector<PressedPair<dim>> pressed(const std::vector<Body>& bodies) const;

  // sum of U where the points stand, J.
  double energy(const std::vector<Body>& bodies) const;

 private:
  struct Pair {
    std::size_t a, b;         // bodies
    int p, q;                 // points
    double reach, stiffness;  // r_0, m, and K/l^2
    Vec force;                // on the second
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

// Throws std::invalid_argument where they do and could not: about an axis, and without a modulus at rest; with friction also where
// bodies that press each other need not share nodes: with shapes of kinked gradients or of places at the start, and with less than two
// points a cell.
void check_pairs(const Scene& scene);

// The energy of the scene's pairs, J, which the ledger's stores do not hold: what it takes and gives is work of contact there.
double contact_energy(const Scene& scene);

}  // namespace plumbline
