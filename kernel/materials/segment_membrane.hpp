// A chain whose strain is the stretch of the segments between its points.
#pragma once

#include "kernel/materials/material.hpp"

namespace plumbline {

// Segment s from point p to p + 1: eps_s = |x_{p+1} - x_p| / L_s - 1, T_s = A E eps_s, W_s = A L_s E eps_s^2 / 2. [Segments 1]
// Each point bears F_p = T_p t_p - T_{p-1} t_{p-1} = -dW/dx_p, which goes to the nodes by N_ip: the force whose work over
// the points' own motion is the stored energy. [Segments 2] Strain is a function of where points stand and cannot drift.
// (Lian, Zhang, Liu 2014, doi 10.1007/s10999-014-9241-6, carry finite elements on the grid in the same way.)
// The strain column holds that of the segment which starts at the point; the last point of an open chain has none.
//
// Of a surface of revolution (`revolved`, axisymmetric, per radian) a segment is a band that stretches around the axis, too:
// eps_h = r_s / R_s - 1 with r_s the mean radius, and W_s = A L_s R_s w(eps_s, eps_h),
//   w = E' / 2 (eps_s^2 + eps_h^2 + 2 nu eps_s eps_h) where both stresses pull, E' = E / (1 - nu^2),
//   w = E eps^2 / 2 where one does, eps the strain along it, 0 where none does: it wrinkles. [Segments 3]
// (tension field: Pipkin 1986, doi 10.1093/imamat/36.1.85; convex, with continuous stresses.)
struct SegmentMembrane final : Material {
  double youngs_modulus = 0;  // E, Pa, > 0; in the plane, of a membrane held out of it, E / (1 - nu^2)
  double density = 0;         // rho_0, kg/m^3, > 0: sets the wave speed of the step limit
  double section = 0;         // A, m^2 (in the plane per unit depth: the thickness, m), > 0
  bool one_way = true;        // no tension while eps < 0
  bool closed = false;        // the last point is joined to the first
  bool revolved = false;      // bands around the axis; one_way holds
  double poissons_ratio = 0;  // nu of bands, [0, 1/2)

  std::string name() const override { return "segment_membrane"; }
  StressMeasure measure() const override { return StressMeasure::point_force; }
  // Rest lengths (column rest_length), and of bands rest radii (rest_radius), must be set before the first step.
  void add_columns(Columns& points, int dim) const override;
  Store store() const override { return Store::elastic; }
  bool chain() const override { return true; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double point_forces(const Columns& points, std::vector<double>& forces) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;
  // Sets the strain: at the start of a run of where the points are put.
  void describe(Columns& points) const override;

  bool has_segment(const Columns& points, int p) const { return closed || p + 1 < points.points(); }
  // T_s of a strain, N.
  double tension(double strain) const { return !one_way || strain > 0 ? section * youngs_modulus * strain : 0.0; }

  // Energy per rest area of a band over its thickness, Pa, and the stresses that are its derivatives, Pa. [Segments 3]
  struct BandState {
    double energy = 0, along = 0, around = 0;
  };
  BandState band(double strain, double hoop_strain) const;

 private:
  struct Band;
  struct Chain;  // the columns of the points, looked up once a range
  Band band_of(const Chain& chain, int p, double ahead) const;
  double energy_of(const Chain& chain, int p, double strain, double hoop_strain) const;  // J
};

namespace column {
inline const ColumnId rest_length{"rest_length", "m"};  // L_s of the segment that starts at the point, > 0
inline const ColumnId rest_radius{"rest_radius", "m"};  // R_s of the band that starts at the point, > 0
inline const ColumnId hoop_strain{"hoop_strain", "1"};  // eps_h of the band that starts at the point
// Forces of the segment that starts at the point on its two points, as the last forces used them, component by component
inline const ColumnId segment_force{"segment_force", "N"};
}  // namespace column
}  // namespace plumbline
