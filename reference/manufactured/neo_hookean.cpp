#include "reference/manufactured/neo_hookean.hpp"

#include <cmath>

namespace plumbline::reference {

using std::log;  // beside the one that takes a Bounded

template <class Number>
Inverse<Number>::Inverse(const Tensor<Number>& f, int dim) {
  if (dim == 1) {
    determinant = f[0];
    tensor[0] = Number(1) / f[0];
  } else if (dim == 2) {
    determinant = f[0] * f[3] - f[1] * f[2];
    tensor = {f[3] / determinant, -f[1] / determinant, -f[2] / determinant, f[0] / determinant};
  } else {
    auto cofactor = [&f](int row, int column) {  // cyclic indices carry the sign
      const int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
      return f[3 * r1 + c1] * f[3 * r2 + c2] - f[3 * r1 + c2] * f[3 * r2 + c1];
    };
    determinant = f[0] * cofactor(0, 0) + f[1] * cofactor(0, 1) + f[2] * cofactor(0, 2);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) tensor[3 * i + j] = cofactor(j, i) / determinant;
    }
  }
}

template <class Number>
Tensor<Number> first_piola(const Tensor<Number>& f, int dim, const Lame<Number>& lame) {
  const Inverse<Number> inverse(f, dim);
  const Number pull = lame.lambda * log(inverse.determinant) - lame.mu;
  Tensor<Number> stress{};
  for (int i = 0; i < dim; ++i) {
    for (int j = 0; j < dim; ++j) {
      stress[dim * i + j] = pull * inverse.tensor[dim * j + i] + lame.mu * f[dim * i + j];  // [Wallstedt 2008]
    }
  }
  return stress;
}

template <class Number>
Number stored_energy(const Tensor<Number>& f, int dim, const Lame<Number>& lame) {
  const Number growth = log(Inverse<Number>(f, dim).determinant);
  Number trace(-dim);
  for (int i = 0; i < dim * dim; ++i) trace = trace + f[i] * f[i];
  return Number(0.5) * (lame.lambda * growth * growth + lame.mu * (trace - Number(2) * growth));
}

// dP_iJ/dF_kL = lambda Fi_Ji Fi_Lk + (mu - lambda ln J) Fi_Jk Fi_Li + mu delta_ik delta_JL, Fi the inverse of F.
template <class Number>
Vector<Number> divergence_of_first_piola(const Tensor<Number>& f, const TensorGradient<Number>& gradient, int dim,
                                         const Lame<Number>& lame) {
  const Inverse<Number> inverse(f, dim);
  const Number push = lame.mu - lame.lambda * log(inverse.determinant);
  auto inv = [&](int a, int b) { return inverse.tensor[dim * a + b]; };
  auto grad = [&](int k, int l, int j) { return gradient[(dim * k + l) * dim + j]; };
  Vector<Number> divergence{};
  for (int i = 0; i < dim; ++i) {
    Number sum(0);
    for (int j = 0; j < dim; ++j) {
      sum = sum + lame.mu * grad(i, j, j);
      for (int k = 0; k < dim; ++k) {
        for (int l = 0; l < dim; ++l) {
          sum = sum + (lame.lambda * inv(j, i) * inv(l, k) + push * inv(j, k) * inv(l, i)) * grad(k, l, j);
        }
      }
    }
    divergence[i] = sum;
  }
  return divergence;
}

template <class Number>
Tensor<Number> cauchy_stress(const Tensor<Number>& f, const Tensor<Number>& stress, int dim) {
  const Number determinant = Inverse<Number>(f, dim).determinant;
  Tensor<Number> sigma{};
  for (int i = 0; i < dim; ++i) {
    for (int j = 0; j < dim; ++j) {
      Number sum(0);
      for (int k = 0; k < dim; ++k) sum = sum + stress[dim * i + k] * f[dim * j + k];
      sigma[dim * i + j] = sum / determinant;
    }
  }
  return sigma;
}

#define PLUMBLINE_INSTANTIATE(Number)                                                                          \
  template struct Inverse<Number>;                                                                             \
  template Tensor<Number> first_piola(const Tensor<Number>&, int, const Lame<Number>&);                        \
  template Number stored_energy(const Tensor<Number>&, int, const Lame<Number>&);                              \
  template Vector<Number> divergence_of_first_piola(const Tensor<Number>&, const TensorGradient<Number>&, int, \
                                                    const Lame<Number>&);                                      \
  template Tensor<Number> cauchy_stress(const Tensor<Number>&, const Tensor<Number>&, int);
PLUMBLINE_INSTANTIATE(double)
PLUMBLINE_INSTANTIATE(Bounded)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumbline::reference
