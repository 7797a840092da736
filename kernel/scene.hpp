// A scene: grid, bodies, and the choices that hold for all of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/choice.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

// How gas points get their density.
//   cell        mass of the cell over its volume, for every point of the cell            [York 4.5]
//   quadratic   the same with quadratic shapes about the cell centre                      [York 4.6]
//   continuity  rho <- rho / (1 + dt div v)                                               [York 4.7]
//   grid        sum_i N_ip M_i / |cell_i|                                                 [EC-APIC 2]
enum class DensityMethod { cell, quadratic, continuity, grid };

// A rigid frictionless plane that moves along `direction`, the scene on one side of it: nodes behind it, or less than half a
// cell before it, take its normal velocity. Its work is booked.
struct Piston {
  int direction = 0;    // 0 ... dim - 1
  int side = 0;         // 0: the scene lies above it, 1: below it
  double position = 0;  // at t = 0, m
  double velocity = 0;  // m/s, from t = rise on
  double rise = 0;      // s, >= 0: until then the velocity grows from zero in proportion to the time

  double velocity_at(double time) const { return time < rise ? velocity * (time / rise) : velocity; }
  double place_at(double time) const {
    return position + velocity * (time < rise ? 0.5 * time * (time / rise) : time - 0.5 * rise);
  }
};

// How fast the affine transfers take from points what the nodes do not carry: rates of time, not shares of a step. [Filter 1]
struct FilterRate {
  double sound = 0;                                             // k_f >= 0, of c/h
  double compression = 0;                                       // b_f >= 0, of -div v where that is positive
  bool none() const { return sound == 0 && compression == 0; }  // all of it in each step, however short
};

struct Scene {
  GridSpec grid;
  std::array<double, 3> gravity{0, 0, 0};  // b, m/s^2
  std::vector<Piston> pistons;
  std::vector<Body> bodies;
  std::string shape = "quadratic";  // one of shapes()
  std::string transfer = "apic";    // one of transfers()
  int transfer_order = 2;           // m of transfers that have one, >= 1
  DensityMethod density = DensityMethod::grid;
  std::string contact = "none";          // between velocity fields: one of contacts()
  double friction = 0;                   // mu >= 0 of contact, where the law has friction [Touching 4]
  std::string normals = "connectivity";  // how membranes that carry their strain know their tangents: normals_methods()
  double sharpening = 0;  // 0: none, 1: the leading term of the maps' smoothing undone, see sharpening.hpp; [0, 1]
  double sharpening_second = 0, sharpening_third = 0;  // >= 0: of the powers beyond it, where `sharpening` is not 0
  double sharpening_in_expansion = 1;                  // least share of it where gases expand, see limiter.hpp; [0, 1]
  bool sharpened_motion = false;                       // points move with the velocity that strains them [Sharpening 2]
  bool sharpened_density =
      false;  // and read densities off nodes where the maps' smoothing of these is undone [Read-off 1]
  bool nodal_pressure = false;  // pressures of gases act at the nodes: not in rings, and not of gases with physical
                                // viscosity [Pressure 2]
  double quadrature =
      0;             // eps, [0, 1]: sums over points of pressures that differ by less are corrected to integrals, in
                     // the plane and in space, where the shape is a B-spline; 0: nowhere [Quadrature 1]
  double split = 0;  // > 0: gas points larger than this many cells are split, see splitting.hpp; 0: never
  bool loss_to_gas =
      false;  // what maps, and strains of membranes, take from points without an energy equation heats the
              // gas at their nodes [Coupling 1]
  double chain_relaxation = 0;   // theta of segments, [0, 1]: null-space modes of motion are taken out [Coupling 2]
  double strain_smoothing = 0;   // kappa >= 0 of carried strains: null-space modes are taken out [Coupling 3]
  bool mean_dilatation = false;  // points of solids that hardly compress share their cell's dilatation [Dilatation 1]
  FilterRate filter;
  double heat_exchange = 0;  // kappa >= 0: heat that points of a compressed gas exchange through the nodes [Exchange 1]
};

// The methods in the order of DensityMethod.
const std::vector<Choice>& densities();
DensityMethod density_method(const std::string& name);  // throws std::out_of_range

}  // namespace plumbline
