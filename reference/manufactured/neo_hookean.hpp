#pragma once
// The compressible neo-Hookean solid of the manufactured solutions, and the divergence of its stress in closed form.
// Tag [Wallstedt 2008]: P. C. Wallstedt, J. E. Guilkey, J. Comput. Phys. 227 (2008) 9628,
// doi 10.1016/j.jcp.2008.07.019: Cauchy stress sigma = (lambda ln J I + mu (F F^T - I))/J. With P = J sigma F^-T, the
// first Piola-Kirchhoff stress (row: component of the force, column: normal in the initial state), and the energy per
// initial volume W:
//   P = lambda ln J F^-T + mu (F - F^-T) = dW/dF,   W = lambda/2 (ln J)^2 + mu/2 (tr F^T F - dim - 2 ln J).
// In fewer than three dimensions nothing strains across: plane strain, uniaxial strain.
#include <array>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Row-major dim x dim in the first dim^2 places, vectors in the first dim; the rest is zero.
template <class Number>
using Tensor = std::array<Number, 9>;
template <class Number>
using Vector = std::array<Number, 3>;
/// gradient[(i * dim + J) * dim + K] = d F_iJ/d X_K, in the first dim^3 places.
template <class Number>
using TensorGradient = std::array<Number, 27>;

/// Lame's constants, Pa.
template <class Number>
struct Lame {
  Number lambda = 0, mu = 0;

  /// E > 0, -1 < nu < 1/2.
  static Lame from(double youngs_modulus, double poisson) {
    const Number e(youngs_modulus), nu(poisson);
    const Number twice_mu = e / (Number(1) + nu);
    return {twice_mu * nu / (Number(1) - Number(2) * nu), Number(0.5) * twice_mu};
  }
};

/// det F and F^-1; the bounds are infinite if F may be singular.
template <class Number>
struct Inverse {
  Number determinant = 1;
  Tensor<Number> tensor{};
  Inverse(const Tensor<Number>& f, int dim);
};

/// Needs det F > 0 (else NaN, or an infinite bound).
template <class Number>
Tensor<Number> first_piola(const Tensor<Number>& f, int dim, const Lame<Number>& lame);

/// W, energy per initial volume; the same needs.
template <class Number>
Number stored_energy(const Tensor<Number>& f, int dim, const Lame<Number>& lame);

/// (Div P)_i = d P_iJ/d X_J from the gradient of F; the same needs.
template <class Number>
Vector<Number> divergence_of_first_piola(const Tensor<Number>& f, const TensorGradient<Number>& gradient, int dim,
                                         const Lame<Number>& lame);

/// P F^T/det F, symmetric.
template <class Number>
Tensor<Number> cauchy_stress(const Tensor<Number>& f, const Tensor<Number>& stress, int dim);

}  // namespace plumbline::reference
