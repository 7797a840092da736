#pragma once
// Small dense matrices, row by row: as much algebra as writing down one step of a method takes.
#include <complex>
#include <vector>

namespace plumbline::reference {

template <class Number>
struct Dense {
  Dense() = default;
  Dense(int rows_, int columns_)
      : rows(rows_),
        columns(columns_),
        entries(static_cast<std::size_t>(rows_ * columns_)) {}

  Number& operator()(int row, int column) { return entries[static_cast<std::size_t>(row * columns + column)]; }
  const Number& operator()(int row, int column) const {
    return entries[static_cast<std::size_t>(row * columns + column)];
  }

  int rows = 0, columns = 0;
  std::vector<Number> entries;
};

inline double conjugate(double x) { return x; }
inline std::complex<double> conjugate(std::complex<double> x) { return std::conj(x); }

template <class Number>
Dense<Number> operator*(const Dense<Number>& a, const Dense<Number>& b) {
  Dense<Number> product(a.rows, b.columns);
  for (int i = 0; i < a.rows; ++i) {
    for (int k = 0; k < a.columns; ++k) {
      for (int j = 0; j < b.columns; ++j) product(i, j) += a(i, k) * b(k, j);
    }
  }
  return product;
}

template <class Number>
Dense<Number> operator*(double factor, Dense<Number> a) {
  for (Number& entry : a.entries) entry *= factor;
  return a;
}

template <class Number>
Dense<Number> operator+(Dense<Number> a, const Dense<Number>& b) {
  for (std::size_t k = 0; k < a.entries.size(); ++k) a.entries[k] += b.entries[k];
  return a;
}

template <class Number>
Dense<Number> operator-(const Dense<Number>& a, const Dense<Number>& b) {
  return a + -1.0 * b;
}

/// The conjugate transpose.
template <class Number>
Dense<Number> adjoint(const Dense<Number>& a) {
  Dense<Number> turned(a.columns, a.rows);
  for (int i = 0; i < a.rows; ++i) {
    for (int j = 0; j < a.columns; ++j) turned(j, i) = conjugate(a(i, j));
  }
  return turned;
}

/// `rows` rows of ones at (i, first + i), else zeros.
template <class Number>
Dense<Number> selection(int rows, int columns, int first) {
  Dense<Number> chosen(rows, columns);
  for (int i = 0; i < rows; ++i) chosen(i, first + i) = 1;
  return chosen;
}

}  // namespace plumbline::reference
