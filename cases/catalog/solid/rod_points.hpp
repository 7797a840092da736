// The points of a rod of an elastoplastic solid by rings, and what is read off them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "kernel/points/body.hpp"

namespace plumbline {

// Upright on y = 0 around the axis x = 0: rows of rings of the given spacing, m, which divides the radius; along the axis the
// nearest one that divides the length. Masses are those of density, kg/m^3, per radian.
Body rod_points(std::shared_ptr<const Material> material, double length, double radius, double spacing, double density);

// m, at the corners of the points' domains, deformed with them: how high the rod reaches, and how wide.
struct RodShape {
  double length = 0, radius = 0;
};
// At a height: how far the rod reaches, the plastic strain next to the axis, and the largest.
struct RodSlice {
  double height = 0, radius = 0, axis = 0, largest = 0;
};
// J per radian, of all points: Y alpha, H alpha^2/2 and K/2 (tr e)^2 + G |dev e|^2 times the undeformed volume.
struct RodSums {
  double heat = 0, hardening = 0, elastic = 0;
};
struct RodLaw {
  double bulk, shear, density, yield, hardening;
};

// Points with the columns of j2_plasticity; its equations are written here a second time. e: elastic strain.
class RodPoints {
 public:
  RodPoints(const Body& body, const RodLaw& law) : body_(body), points_(body.points), law_(law) {}

  double beyond_yield(int p) const;  // (q - Y - H alpha)/Y
  double volume_off(int p) const;    // |ln det F - tr e|
  double axial_stress(int p) const;  // Cauchy's, without the viscous pressure, Pa
  double stretch(int p) const;       // of a line along the axis, by plastic flow: |exp(-e) F e_z|
  RodShape shape() const;
  std::vector<RodSlice> slices(double thickness) const;  // m; from the wall on, of those with a point
  RodSums sums() const;
  double shared_off() const;  // |sum m (theta - tr e)| over sum m |tr e|; 0 where no dilatation is shared
  double largest_plastic_strain() const;
  double mean_of_lines() const;    // of the stretch, by undeformed volumes
  double excess_of_lines() const;  // the largest |ln stretch| - alpha
  // Root of the mean square, over all points with a neighbour on either side along the axis, of (p_- - 2 p + p_+)/4: the
  // amplitude of a pressure that alternates from point to point. `across`: points of a row, Pa.
  double alternation(int across) const;

 private:
  Eigen::Matrix3d elastic(int p) const;
  double dilatation(int p) const;  // that K is the modulus of
  Eigen::Matrix3d deformation(int p) const;
  double reach(int p, int d) const;  // of a domain's corners from its point

  const Body& body_;
  const Columns& points_;
  RodLaw law_;
};

}  // namespace plumbline
