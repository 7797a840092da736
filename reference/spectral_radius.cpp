#include "reference/spectral_radius.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

#include <stdexcept>

#include "reference/gsl_owned.hpp"

namespace plumbline::reference {
namespace {

std::size_t size_of(const SquareMatrix& matrix) { return static_cast<std::size_t>(matrix.size); }

// GSL reports what it cannot do through a process-wide handler that aborts: it never gets to see such numbers.
Owned<gsl_matrix> copy_of(const SquareMatrix& matrix) {
  Owned<gsl_matrix> copy(gsl_matrix_alloc(size_of(matrix), size_of(matrix)));
  for (std::size_t k = 0; k < matrix.entries.size(); ++k) {
    if (!std::isfinite(matrix.entries[k])) throw std::invalid_argument("eigenvalues: an entry is not finite");
    copy->data[k / size_of(matrix) * copy->tda + k % size_of(matrix)] = matrix.entries[k];
  }
  return copy;
}

double frobenius(const SquareMatrix& matrix) {
  double square = 0;
  for (double entry : matrix.entries) square += entry * entry;
  return std::sqrt(square);
}

double frobenius(const gsl_matrix_complex& matrix) {
  double square = 0;
  for (std::size_t i = 0; i < matrix.size1; ++i) {
    for (std::size_t j = 0; j < matrix.size2; ++j) square += gsl_complex_abs2(gsl_matrix_complex_get(&matrix, i, j));
  }
  return std::sqrt(square);
}

double largest(const gsl_vector_complex& values) {
  double radius = 0;
  for (std::size_t i = 0; i < values.size; ++i) {
    radius = std::max(radius, gsl_complex_abs(gsl_vector_complex_get(&values, i)));
  }
  return radius;
}

struct EigenPairs {
  Owned<gsl_vector_complex> values;
  Owned<gsl_matrix_complex> vectors;
};

EigenPairs eigen_pairs(const SquareMatrix& matrix) {
  const std::size_t n = size_of(matrix);
  EigenPairs pairs{Owned<gsl_vector_complex>(gsl_vector_complex_alloc(n)),
                   Owned<gsl_matrix_complex>(gsl_matrix_complex_alloc(n, n))};
  const Owned<gsl_matrix> copy = copy_of(matrix);
  const Owned<gsl_eigen_nonsymmv_workspace> work(gsl_eigen_nonsymmv_alloc(n));
  gsl_eigen_nonsymmv(copy.get(), pairs.values.get(), pairs.vectors.get(), work.get());
  return pairs;
}

// |A V - V L| with its own rounding and that of A.
double residual(const SquareMatrix& matrix, const EigenPairs& pairs, double entry_error) {
  double square = 0;
  const std::size_t n = size_of(matrix);
  for (std::size_t j = 0; j < n; ++j) {
    const gsl_complex value = gsl_vector_complex_get(pairs.values.get(), j);
    for (std::size_t i = 0; i < n; ++i) {
      gsl_complex sum = gsl_complex_negative(gsl_complex_mul(value, gsl_matrix_complex_get(pairs.vectors.get(), i, j)));
      for (std::size_t k = 0; k < n; ++k) {
        const gsl_complex entry = gsl_matrix_complex_get(pairs.vectors.get(), k, j);
        sum = gsl_complex_add(sum, gsl_complex_mul_real(entry, matrix.entries[i * n + k]));
      }
      square += gsl_complex_abs2(sum);
    }
  }
  const double wrong = 4 * static_cast<double>(n) * rounding::unit + entry_error;
  return std::sqrt(square) + wrong * frobenius(matrix) * frobenius(*pairs.vectors);
}

// Every eigenvalue is within |V^-1 (A V - V L)| of a computed one, and of n discs that overlap as many belong to each
// union as it has discs. Infinite where the vectors say too little.
double bauer_fike(const SquareMatrix& matrix, const EigenPairs& pairs, double entry_error) {
  const std::size_t n = size_of(matrix);
  const double left = residual(matrix, pairs, entry_error), vectors = frobenius(*pairs.vectors);
  const Owned<gsl_matrix_complex> factors(gsl_matrix_complex_alloc(n, n)), inverse(gsl_matrix_complex_alloc(n, n));
  gsl_matrix_complex_memcpy(factors.get(), pairs.vectors.get());
  const Owned<gsl_permutation> order(gsl_permutation_alloc(n));
  int sign = 0;
  gsl_linalg_complex_LU_decomp(factors.get(), order.get(), &sign);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(gsl_complex_abs(gsl_matrix_complex_get(factors.get(), i, i)) > 0)) return rounding::infinity;
  }
  gsl_linalg_complex_LU_invert(factors.get(), order.get(), inverse.get());
  const double size = static_cast<double>(n), back = frobenius(*inverse);
  const double wrong = 4 * size * size * rounding::unit * back * vectors;  // relative, of the inverse
  if (!(wrong < 0.1)) return rounding::infinity;
  return (2 * size - 1) * back * left / (1 - wrong);
}

// The computed eigenvalues are those of a matrix within ten roundings a row of this one.
double elsner(const SquareMatrix& matrix, double entry_error) {
  const double size = matrix.size, norm = frobenius(matrix), shift = (10 * size * rounding::unit + entry_error) * norm;
  return std::pow(2 * norm + shift, 1 - 1 / size) * std::pow(shift, 1 / size);
}

}  // namespace

std::vector<std::complex<double>> eigenvalues(const SquareMatrix& matrix) {
  const std::size_t n = size_of(matrix);
  const Owned<gsl_matrix> copy = copy_of(matrix);
  const Owned<gsl_vector_complex> values(gsl_vector_complex_alloc(n));
  const Owned<gsl_eigen_nonsymm_workspace> work(gsl_eigen_nonsymm_alloc(n));
  gsl_eigen_nonsymm(copy.get(), values.get(), work.get());
  std::vector<std::complex<double>> all;
  for (std::size_t i = 0; i < n; ++i) {
    const gsl_complex value = gsl_vector_complex_get(values.get(), i);
    all.emplace_back(GSL_REAL(value), GSL_IMAG(value));
  }
  return all;
}

Bounded spectral_radius(const SquareMatrix& matrix, double entry_error) {
  const EigenPairs pairs = eigen_pairs(matrix);
  const double radius = largest(*pairs.values);
  return {radius,
          std::min(bauer_fike(matrix, pairs, entry_error), elsner(matrix, entry_error)) + 4 * rounding::unit * radius};
}

Bounded spectral_radius(const ComplexMatrix& matrix, double entry_error) {
  const int n = matrix.size;
  SquareMatrix real(2 * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      real(i, j) = real(i + n, j + n) = matrix(i, j).real();
      real(i + n, j) = matrix(i, j).imag();
      real(i, j + n) = -matrix(i, j).imag();
    }
  }
  return spectral_radius(real, entry_error);
}

}  // namespace plumbline::reference
