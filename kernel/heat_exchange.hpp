// How fast points exchange heat at a node. [Exchange 1] Heat that a shock leaves where it starts or is stopped stands out: the
// nodal energies have an extremum there. Those of a contact are monotone, and what they exchange smears it.
//   kappa_i = kappa (1 + 3 max_d chi_d) / 4,  chi_d = min(l / m, 50 l / E_i),
// l and m the less and the more of |E_i - E_i-1| and |E_i - E_i+1| where both differences have one sign, else l = 0, i +- 1 the
// neighbours along d: kappa at a symmetric extremum, a quarter of it where energies are monotone or even. It rises slowly with l:
// where a step takes more of an extremum than what makes it faster, rounding grows. Behind a wall stand mirror images; beyond
// a body all is as at the node.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

// kappa_i / kappa of a node with mass, beside others of its row; energies: E_i of the nodes, J/kg.
template <int dim>
double exchange_share(const RowNeighbours<dim>& beside, const std::vector<double>& energies, int i) {
  constexpr double everywhere = 0.25, even = 0.02;
  double stands_out = 0;
  for (int d = 0; d < dim; ++d) {
    double above[2] = {0, 0};
    const double own = energies[static_cast<std::size_t>(i)];
    for (int side = 0; side < 2; ++side) {
      const int there = beside(i, d, side).node;
      if (there >= 0) above[side] = own - energies[static_cast<std::size_t>(there)];
    }
    if (above[0] * above[1] <= 0) continue;
    const double least = std::min(std::abs(above[0]), std::abs(above[1]));
    const double most = std::max(std::abs(above[0]), std::abs(above[1]));
    stands_out = std::max(stands_out, std::min(least / most, least / (even * std::abs(own))));
  }
  return everywhere + (1 - everywhere) * stands_out;
}

}  // namespace plumbline
