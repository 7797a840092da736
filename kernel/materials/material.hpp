// A material: parameters with units, the columns it needs, and loops of its own over those columns.
#pragma once

#include <string>
#include <vector>

#include "kernel/points/columns.hpp"

namespace plumbline {

// What a scene fixes for all materials.
struct MaterialContext {
  int dim;                  // 1 or 2
  double h;                 // cell size, m; the length of an artificial viscosity
  bool continuity_density;  // rho follows div v point by point [York 4.7]
};

// Where a material keeps the energy that its stress power becomes.
enum class Store { none, internal, elastic };

// Sums over a body that bound the step: dt < cfl h / fastest and dt < cfl h^2 / (2 dim diffusivity).
struct StepBounds {
  double fastest = 0;      // max c_p + |v_p|, m/s
  double diffusivity = 0;  // max 4/3 mu / rho_p, m^2/s
};

class Material {
 public:
  virtual ~Material() = default;
  virtual std::string name() const = 0;
  virtual void add_columns(Columns& points, int dim) const = 0;
  virtual Store store() const = 0;
  virtual bool chain() const { return false; }        // points are a chain, see Body::chain
  virtual bool has_density() const { return false; }  // a density column that a density method may set
  virtual bool takes_heat() const { return false; }   // transfer losses can become internal energy

  // Advances the internal variables over dt with the strain_rate column. Returns the energy stored meanwhile,
  // sum_p of the change of each point by its own formula, J.
  virtual double advance(Columns& points, const MaterialContext& context, double dt) const = 0;

  // The columns that advance() integrates, and their rates of change with the strain_rate and stress columns as they are,
  // one column after another: points() values each.
  virtual std::vector<const ColumnId*> internal_variables(const MaterialContext& context) const = 0;
  virtual std::vector<double> rates(const Columns& points, const MaterialContext& context) const = 0;

  // Sets stress (and volume, pressure, tangent) from the internal variables and the strain_rate column.
  virtual void evaluate_stress(Columns& points, const MaterialContext& context) const = 0;

  // Where viscous stress would cool (negative power with the strain_rate column), sets it from that column.
  // Returns whether any point changed. [EC-APIC viscous heat]
  virtual bool reverse_cooling(Columns&, const MaterialContext&) const { return false; }

  // dt sum_p V_p s_p : strain_rate with s the viscous part of the stress, J.
  virtual double viscous_heat(const Columns&, const MaterialContext&, double) const { return 0; }

  // Adds heat_p (J per point) to the internal energy. Only where takes_heat().
  virtual void add_heat(Columns&, const double*) const {}

  // Energy stored, from the columns alone, J.
  virtual double stored_energy(const Columns& points) const = 0;

  virtual StepBounds step_bounds(const Columns& points, int dim) const = 0;

  // First inadmissible point: its index and what is wrong; -1 if all are admissible. field: a column's name.
  struct Fault {
    int point = -1;
    std::string field;
    double value = 0;
    std::string reason;
  };
  virtual Fault first_fault(const Columns& points) const = 0;
};

// What `list` says of a material; each registers itself in its own source file.
struct MaterialEntry {
  std::string name, title, source;
};
const std::vector<MaterialEntry>& materials();  // in the order of their names
struct RegisterMaterial {
  explicit RegisterMaterial(MaterialEntry entry);
};

}  // namespace plumbline
