// One layer of points that carry stress along their tangent only: springs, strings, nets. [York chapter 5]
#pragma once

#include "kernel/materials/material.hpp"

namespace plumbline {

// d eps_t = (t . e . t) dt                            [York 5.2]
// eps carried as the *total* tangential strain        [York 5.3]
// sigma = E eps t t, all other stresses zero          [York 5.5]
// one_way: no stress while eps < 0, but the negative strain still accumulates (wrinkles). [York 5.2, text]
// Tangents in the plane come from connectivity, the mean of the two adjoining segment angles [York 7.1], or are given.
// A tangent of (0, 0) carries no stress.
// Volumes stay constant.
struct UniaxialMembrane : Material {
  double youngs_modulus = 0;  // E, Pa, > 0
  double density = 0;         // rho_0, kg/m^3, > 0: sets the wave speed of the step limit
  bool one_way = true;
  bool closed = false;  // the last point is joined to the first

  std::string name() const override { return "uniaxial_membrane"; }
  void add_columns(Columns& points, int dim) const override;
  Store store() const override { return Store::elastic; }
  bool chain() const override { return true; }
  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override;
  std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const override;
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override;
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override;
  double set_strain(Columns& points, const std::vector<double>& strain) const override;
  double stored_energy(const Columns& points, PointRange range) const override;
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override;
  Fault first_fault(const Columns& points, PointRange range) const override;

  // Strain energy density W(eps), J/m^3.
  double energy_density(double strain) const { return carries(strain) ? 0.5 * modulus() * strain * strain : 0.0; }
  // Tangential stress over tangential strain, Pa.
  virtual double modulus() const { return youngs_modulus; }

 private:
  bool carries(double strain) const { return !one_way || strain > 0; }
};

// A membrane that neither strains nor is free to contract out of the plane:
//   sigma_1 = E eps / (1 - nu^2), sigma_2 = nu sigma_1 out of the plane, eps_2 = 0, eps_3 = -nu eps / (1 - nu). [York 5.12-5.15]
struct PlaneStressMembrane final : UniaxialMembrane {
  double poissons_ratio = 0;  // nu, -1 < nu < 1

  std::string name() const override { return "plane_stress_membrane"; }
  double modulus() const override { return youngs_modulus / (1 - poissons_ratio * poissons_ratio); }
};

}  // namespace plumbline
