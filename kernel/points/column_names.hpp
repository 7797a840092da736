// The columns a point may carry. A body stores those that its material, transfer and integrator ask for, no others.
#pragma once

#include <string>

namespace plumbline {

// Identifies one column in every body. A new material declares its own with a further constant of this type.
class ColumnId {
 public:
  // `name`: the column's name, unique; asking for the same name again gives the same identity.
  ColumnId(const char* name, const char* unit);
  int index() const { return index_; }
  const std::string& name() const;
  const std::string& unit() const;

 private:
  int index_;
};

namespace column {
// Vectors have one component a dimension, component-major: all x, then all y.
inline const ColumnId position{"position", "m"};          // x_p
inline const ColumnId velocity{"velocity", "m/s"};        // v_p
inline const ColumnId affine{"affine", "1/s"};            // C_p, row-major, APIC only
inline const ColumnId mass{"mass", "kg"};                 // m_p, > 0
inline const ColumnId volume{"volume", "m^3"};            // V_p, > 0
inline const ColumnId strain_rate{"strain_rate", "1/s"};  // normal components, then engineering shears
inline const ColumnId stress{"stress", "Pa"};             // sigma_p in the same order, tension positive
inline const ColumnId density{"density", "kg/m^3"};       // rho_p, > 0
inline const ColumnId energy{"energy", "J/kg"};           // e_p, specific internal energy, >= 0
inline const ColumnId pressure{"pressure", "Pa"};         // thermodynamic p_p, without viscosity
inline const ColumnId sound_speed{"sound_speed", "m/s"};  // c_p, where the nodes want to know it
inline const ColumnId closing{"closing", "1/s"};  // how fast the flow closes, for artificial viscosity that is limited
inline const ColumnId strain{"strain", "1"};      // total: of a membrane along its tangent, else as strain_rate
inline const ColumnId deformation{"deformation", "1"};                // F_p, row by row, then the hoop's
inline const ColumnId body_force{"body_force", "m/s^2"};              // b_p where a body's load sets it
inline const ColumnId half_size{"half_size", "m"};                    // of the point's box, along each axis
inline const ColumnId half_size_at_start{"half_size_at_start", "m"};  // of the undeformed box
inline const ColumnId tangent{"tangent", "1"};                        // unit tangent of a membrane point, from 2-D on
inline const ColumnId transfer_loss{"transfer_loss", "J"};            // what the two maps of a step took from the point
inline const ColumnId kept_loss{"kept_loss", "J"};  // what of it waits for gas to share a node with [Coupling 1]
}  // namespace column
}  // namespace plumbline
