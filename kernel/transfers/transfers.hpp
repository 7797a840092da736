// Which velocity information goes back and forth between points and grid. Compile-time traits of the point loops.
#pragma once

namespace plumbline {

// Points take the grid's velocity: v_p = sum_i N_ip v~_i.
struct Pic {
  static constexpr bool affine = false;      // points carry C_p
  static constexpr bool increments = false;  // points keep their velocity and add the grid's change
};

// v_p += dt sum_i N_ip a_i. [York 3.22]
struct Flip {
  static constexpr bool affine = false;
  static constexpr bool increments = true;
};

// v_p = sum_i N_ip v~_i, C_p = D^-1 sum_i N_ip v~_i (x_i - x_p)^T. [EC-APIC 5]
struct Apic {
  static constexpr bool affine = true;
  static constexpr bool increments = false;
};

}  // namespace plumbline
