// Which velocity information goes back and forth between points and grid.
#pragma once

#include <string>

namespace plumbline {

// Compile-time traits of the point loops: whether points carry C_p beside v_p.
struct Plain {
  static constexpr bool affine = false;
};
// v_p = sum_i N_ip v~_i, C_p = D^-1 sum_i N_ip v~_i (x_i - x_p)^T. [EC-APIC 5]
struct Affine {
  static constexpr bool affine = true;
};

// What the plain loops do.
//   pic    v_p = sum_i N_ip v~_i
//   flip   v_p += dt sum_i N_ip a_i                                                               [York 3.22]
//   xpic   v_p = sum_i N_ip (w_i + dt a_i), w = sum_{j < m} (1 - P)^j v                           [XPIC 1]
//   fmpm   v_p = sum_i N_ip w_i, w = sum_{j < m} (1 - P)^j v~                                      [FMPM 1]
// P: from the nodes to the points and back. For m = 1 both are pic, for large m they keep what flip keeps but what no
// node sees.
struct TransferChoice {
  bool affine = false;       // points carry C_p
  bool increments = false;   // points keep their velocity and add the grid's change
  int order = 0;             // m of xpic and fmpm; 0: no filter
  bool filters_end = false;  // fmpm: w of v~ instead of v
};

// Throws std::invalid_argument for an unknown name.
TransferChoice transfer_choice(const std::string& name, int order);

}  // namespace plumbline
