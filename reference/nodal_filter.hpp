#pragma once
// What a transfer keeps of a nodal velocity and what it hands on of a nodal change, as functions of the eigenvalue b of B
// in mpm_amplification.hpp, and how much stiffness each order of straining then bears.
#include "reference/mpm_amplification.hpp"

namespace plumbline::reference {

template <class Number>
struct NodalFilter {
  Number keeps, hands_on;  // alpha, beta
};

/// Number: anything with + - * of its own kind and a constructor from int.
template <class Number>
NodalFilter<Number> nodal_filter(const MapScheme& scheme, const Number& b) {
  const Number one(1);
  if (scheme.transfer == GridTransfer::flip) return {one, b};
  if (scheme.transfer == GridTransfer::pic || scheme.transfer == GridTransfer::apic) return {b, b};
  Number lost = one;
  for (int j = 0; j < scheme.order; ++j) lost = lost * (one - b);
  const Number kept = one - lost;
  return {kept, scheme.transfer == GridTransfer::fmpm ? kept : b};
}

/// W of [Stability 5].
template <class Number>
Number stiffness_weight(const MapScheme& scheme, const Number& b) {
  const NodalFilter<Number> filter = nodal_filter(scheme, b);
  const Number whole = Number(1) + filter.keeps;
  const Number part = scheme.update == StressUpdate::last ? whole - filter.hands_on : filter.hands_on;
  return part / (Number(2) * whole);
}

}  // namespace plumbline::reference
