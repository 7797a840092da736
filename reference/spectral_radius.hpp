#pragma once
// Eigenvalues of small dense matrices (gsl_eigen_nonsymm) and the spectral radius with a bound of its own error.
#include <complex>
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Square, row by row. Number: double or std::complex<double>.
template <class Number>
struct Square {
  explicit Square(int size_) : size(size_), entries(static_cast<std::size_t>(size_ * size_)) {}
  Number& operator()(int row, int column) { return entries[static_cast<std::size_t>(row * size + column)]; }
  const Number& operator()(int row, int column) const { return entries[static_cast<std::size_t>(row * size + column)]; }

  int size;
  std::vector<Number> entries;
};
using SquareMatrix = Square<double>;
using ComplexMatrix = Square<std::complex<double>>;

/// In no order. Throws std::invalid_argument for an entry that is not finite.
std::vector<std::complex<double>> eigenvalues(const SquareMatrix& matrix);

/// Largest magnitude of an eigenvalue. `entry_error` bounds the error of the entries, as the Frobenius norm of all of
/// them over that of the matrix. The bound is the smaller of two: Bauer's and Fike's from the residual of the computed
/// eigenvectors, tight where they are well conditioned, and Elsner's from the rounding of the QR algorithm, which needs
/// none and therefore also holds at defective matrices, where an n-fold root is only known to the n-th root of the
/// rounding. (L. Elsner, Linear Algebra and its Applications 71, 1985, 77.) Throws as above.
Bounded spectral_radius(const SquareMatrix& matrix, double entry_error = 0);

/// Of a complex matrix A + iB, as that of the real ((A, -B), (B, A)), whose eigenvalues are its own and their
/// conjugates.
Bounded spectral_radius(const ComplexMatrix& matrix, double entry_error = 0);

}  // namespace plumbline::reference
