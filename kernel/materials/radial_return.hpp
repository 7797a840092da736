// One point of an elastoplastic solid at finite strains: Hencky's law and the radial return.
#pragma once

#include <Eigen/Core>

namespace plumbline {

// Isotropic elasticity in logarithmic strains, von Mises's yield condition, linear isotropic hardening.
struct J2Law {
  double bulk, shear;       // K, G, Pa, > 0
  double yield, hardening;  // Y > 0, H >= 0, Pa
};

// The elastic logarithmic strain (1/2) ln b_e, symmetric, and the equivalent plastic strain.
struct J2State {
  Eigen::Matrix3d elastic = Eigen::Matrix3d::Zero();
  double plastic = 0;
};

// With eps = (1/2) ln b_e per undeformed volume: W = K/2 (tr eps)^2 + G |dev eps|^2, and Kirchhoff's stress
// tau = K tr eps 1 + 2 G dev eps                                                                            [J2 1]
double elastic_energy(const J2Law& law, const Eigen::Matrix3d& elastic);             // J/m^3
Eigen::Matrix3d kirchhoff_stress(const J2Law& law, const Eigen::Matrix3d& elastic);  // Pa

// q = sqrt(3/2) |dev tau|, which may not exceed Y + H alpha                                                 [J2 2]
double equivalent_stress(const J2Law& law, const Eigen::Matrix3d& elastic);  // Pa
inline double yield_stress(const J2Law& law, double plastic) { return law.yield + law.hardening * plastic; }

// The elastic strain after an increment dt grad v of the deformation without plastic flow, (1/2) ln(A b_e A^T) with
// A = 1 + increment; accurate relative to the strain, however small. NaN where A turns the point inside out.   [J2 3]
Eigen::Matrix3d strained(const Eigen::Matrix3d& elastic, const Eigen::Matrix3d& increment);

// The state of such a trial strain. Plastic flow is along dev tau and takes an exponential of it off the stretches, so that the
// return has the form of small strains: d_alpha = (q - Y - H alpha)/(3 G + H) if positive, dev eps (1 - 3 G d_alpha/q).  [J2 4]
J2State returned(const J2Law& law, const J2State& trial);

// Rates of change of both under a velocity gradient, of a state that obeys the yield condition.
J2State rate_of(const J2Law& law, const J2State& state, const Eigen::Matrix3d& gradient);

}  // namespace plumbline
