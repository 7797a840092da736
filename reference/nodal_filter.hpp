#pragma once
// What a transfer keeps of a nodal velocity and what it hands on of a nodal change, as functions of the eigenvalue b of
// B in mpm_amplification.hpp, and up to what stiffness each order of straining is then stable.
#include "reference/mpm_amplification.hpp"

namespace plumbline::reference {

/// alpha, and beta = b share.
template <class Number>
struct NodalFilter {
  Number keeps, share;
};

/// Number: anything with + - * of its own kind and a constructor from int.
template <class Number>
NodalFilter<Number> nodal_filter(const MapScheme& scheme, const Number& b) {
  const Number one(1);
  if (scheme.transfer == GridTransfer::flip) return {one, one};
  if (scheme.transfer == GridTransfer::pic || scheme.transfer == GridTransfer::apic) return {b, one};
  Number lost = one, terms(0);  // (1 - b)^j and their sum
  for (int j = 0; j < scheme.order; ++j) {
    terms = terms + lost;
    lost = lost * (one - b);
  }
  return {one - lost, scheme.transfer == GridTransfer::fmpm ? terms : one};
}

/// beta/(2 b (1 + alpha)): W is b times this, or, straining last, a half less b times this. [Stability 5]
template <class Number>
Number stiffness_share(const MapScheme& scheme, const Number& b) {
  const NodalFilter<Number> filter = nodal_filter(scheme, b);
  return filter.share / (Number(2) * (Number(1) + filter.keeps));
}

}  // namespace plumbline::reference
