// A material: parameters with units, the columns it needs, and loops of its own over those columns.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/geometry.hpp"
#include "kernel/points/columns.hpp"
#include "kernel/traits.hpp"

namespace plumbline {

// What a scene fixes for all materials.
struct MaterialContext {
  int dim = 1;                      // 1, 2 or 3
  double h = 1;                     // cell size, m; the length of an artificial viscosity
  bool continuity_density = false;  // rho follows div v point by point [York 4.7]
  double ahead = 0;                 // s; stresses are those that the strain rates lead to after this time
  bool volume_given = false;        // the volume column holds m_p / rho_p already; else the material sets it
  bool tangents_given = false;      // the tangent column is set; else membranes find tangents by connectivity
};

// Points first ... last-1 of a body. Loops over a range may run beside loops over other ranges.
struct PointRange {
  int first, last;
};
inline PointRange all_points(const Columns& points) { return {0, points.points()}; }

// What the stress column holds, and with it the strain_rate column, whose dot product with it is the power per volume.
//   pressure     one normal stress for all directions; div v
//   symmetric    normal stresses, then shears; normal strain rates, then engineering shears
//   full         all components sigma_de, row by row, then in an axisymmetric scene the hoop's; the velocity gradient
//                dv_d/dx_e. Of finite strains: J^-1 P F^T is symmetric only where P and F are of one instant.
//   point_force  -F_p / V_p of a force F_p on the point itself, which goes to the nodes by N_ip; the velocity at the point
enum class StressMeasure { pressure, symmetric, full, point_force };

inline constexpr int stress_components(StressMeasure measure, int dim, bool axisymmetric) {
  if (measure == StressMeasure::pressure) return 1;
  if (measure == StressMeasure::full) return dim * dim + (axisymmetric ? 1 : 0);
  return measure == StressMeasure::point_force ? dim : strain_components(dim, axisymmetric);
}

// Where a material keeps the energy that its stress power becomes.
enum class Store { none, internal, elastic };

// An elastic solid at rest.
struct RestState {
  double density;  // rho_0, kg/m^3
  double modulus;  // of compression along one axis, lambda + 2 mu, Pa
};

// What bounds the step: dt < cfl h / fastest and dt < cfl h^2 / (2 dim diffusivity).
struct StepBounds {
  double fastest = 0;                     // max c_p + |v_p|, m/s
  double diffusivity = 0;                 // max 4/3 mu / rho_p, m^2/s
  void include(const StepBounds& other);  // the larger of both; a NaN stays
};

class Material {
 public:
  virtual ~Material() = default;
  virtual std::string name() const = 0;
  virtual void add_columns(Columns& points, int dim) const = 0;
  virtual Store store() const = 0;
  virtual bool chain() const { return false; }        // points are a chain, see Body::chain
  virtual bool surface() const { return false; }      // points are a surface in space and are never sorted
  virtual bool has_density() const { return false; }  // a density column that a density method may set
  virtual bool takes_heat() const { return false; }   // transfer losses can become internal energy
  virtual bool dissipates() const { return false; }   // part of what it stores is heat()
  // Adds the column `dilatation`, of the strains as they are, if the material hardly compresses. [Dilatation 3]
  virtual void share_dilatation(Columns&) const {}
  virtual Traits needs() const { return {}; }  // of an integrator

  virtual StressMeasure measure() const { return StressMeasure::symmetric; }
  bool isotropic() const { return measure() == StressMeasure::pressure; }

  // Advances the internal variables over dt with the strain_rate column. Returns the energy stored meanwhile,
  // sum_p of the change of each point by its own formula, J.
  virtual double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const = 0;

  // The columns that advance() integrates, and their rates of change with the strain_rate and stress columns as they are,
  // one column after another: points() values each.
  virtual std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const = 0;
  virtual std::vector<double> rates(const Columns& points, const MaterialContext& context) const = 0;

  // Of materials whose points know their neighbours from the rest state: the same material of these points, which stand as
  // they do at the start of a run. Null: it knows nothing of single points.
  virtual std::shared_ptr<const Material> of_rest(const Columns&) const { return nullptr; }

  // What points show their neighbours: done for all of them before evaluate_stress() of any.
  virtual void prepare_stress(Columns&, PointRange, const MaterialContext&) const {}

  // Sets stress (and pressure, volume, tangent) from the internal variables and the strain_rate column.
  virtual void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const = 0;

  // Where viscous stress would cool (negative power with the strain_rate column), sets it from that column.
  // Returns whether any point changed. [EC-APIC viscous heat]
  virtual bool reverse_cooling(Columns&, PointRange, const MaterialContext&) const { return false; }

  // dt sum_p V_p s_p : strain_rate with s the viscous part of the stress, J.
  virtual double viscous_heat(const Columns&, PointRange, const MaterialContext&, double) const { return 0; }

  // Of forces between points alone: sets them where the points stand, component by component, N. Returns a time in which
  // they cannot carry a point past its rest, s^2: 1 / w^2 of the fastest oscillation of the points among each other.
  virtual double point_forces(const Columns&, std::vector<double>&) const { return 0; }

  // Strain carried by points takes the values `strain`; returns the energy stored meanwhile, J.
  virtual double set_strain(Columns&, const std::vector<double>& /*strain*/) const { return 0; }

  // Adds heat_p (J per point) to the internal energy. Only where takes_heat().
  virtual void add_heat(Columns&, PointRange, const double*) const {}

  // Energy stored, from the columns alone, J.
  virtual double stored_energy(const Columns& points, PointRange range) const = 0;

  // What of it is heat that the stress of an elastic material has given, J. The rest is elastic, and what hardening keeps.
  virtual double heat(const Columns&, PointRange) const { return 0; }

  virtual StepBounds step_bounds(const Columns& points, PointRange range, int dim) const = 0;
  // Whether those of points whose weights are of the start (column position_at_start) are of waves among the places of the
  // start; otherwise they are of waves in space, and such shapes allow for how much F shortens at most. [Lagrangian 4]
  virtual bool bounds_at_start() const { return false; }

  // Of solids.
  virtual std::optional<RestState> rest(int /*dim*/) const { return {}; }

  // First inadmissible point: its index and what is wrong; -1 if all are admissible. field: a column's name.
  struct Fault {
    int point = -1;
    std::string field;
    double value = 0;
    std::string reason;
  };
  virtual Fault first_fault(const Columns& points, PointRange range) const = 0;

  // Sets columns that nothing in a step reads (density, pressure), for those who look at points between steps.
  virtual void describe(Columns&) const {}
};

// Largest |v_p| of the range, m/s; a NaN stays.
double fastest_point(const Columns& points, PointRange range, int dim);

// A point of the range with a value of the column that is not finite.
Material::Fault first_not_finite(const Columns& points, PointRange range, const ColumnId& id, const char* reason);

}  // namespace plumbline
