#include "tests/kernel/dense.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <complex>
#include <limits>
#include <memory>

namespace plumbline::dense {
namespace {

template <auto release>
struct Release {
  template <class Held>
  void operator()(Held* held) const {
    release(held);
  }
};
using Matrix = std::unique_ptr<gsl_matrix, Release<gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, Release<gsl_vector_free>>;

auto size(Eigen::Index of) { return static_cast<std::size_t>(of); }

Matrix square(Eigen::Index n) { return Matrix(gsl_matrix_alloc(size(n), size(n))); }
Vector vector(Eigen::Index n) { return Vector(gsl_vector_alloc(size(n))); }

Matrix copy(const Eigen::MatrixXd& of) {
  Matrix made(gsl_matrix_alloc(size(of.rows()), size(of.cols())));
  for (Eigen::Index i = 0; i < of.rows(); ++i) {
    for (Eigen::Index j = 0; j < of.cols(); ++j) gsl_matrix_set(made.get(), size(i), size(j), of(i, j));
  }
  return made;
}
Eigen::VectorXd copy(const Vector& of) {
  return Eigen::Map<const Eigen::VectorXd>(of->data, static_cast<Eigen::Index>(of->size));
}

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) {
  const Eigen::Index n = matrix.rows();
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, Release<gsl_eigen_nonsymm_free>> work(
      gsl_eigen_nonsymm_alloc(size(n)));
  const std::unique_ptr<gsl_vector_complex, Release<gsl_vector_complex_free>> values(gsl_vector_complex_alloc(size(n)));
  gsl_eigen_nonsymm(copy(matrix).get(), values.get(), work.get());
  Eigen::VectorXcd all(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const gsl_complex value = gsl_vector_complex_get(values.get(), size(k));
    all[k] = {GSL_REAL(value), GSL_IMAG(value)};
  }
  return all;
}

double spectral_radius(const Eigen::MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

Spectrum symmetric_spectrum(const Eigen::MatrixXd& matrix) {
  const Eigen::Index n = matrix.rows();
  const std::unique_ptr<gsl_eigen_symmv_workspace, Release<gsl_eigen_symmv_free>> work(gsl_eigen_symmv_alloc(size(n)));
  const Vector values = vector(n);
  const Matrix vectors = square(n);
  gsl_eigen_symmv(copy((matrix + matrix.transpose()) / 2).get(), values.get(), vectors.get(), work.get());
  gsl_eigen_symmv_sort(values.get(), vectors.get(), GSL_EIGEN_SORT_VAL_ASC);
  Spectrum all{copy(values), Eigen::MatrixXd(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) all.vectors(i, j) = gsl_matrix_get(vectors.get(), size(i), size(j));
  }
  return all;
}

Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Matrix left = copy(a), right = square(a.cols());
  const Vector singular = vector(a.cols()), wanted = vector(b.size()), x = vector(a.cols());
  for (Eigen::Index k = 0; k < b.size(); ++k) gsl_vector_set(wanted.get(), size(k), b[k]);
  gsl_linalg_SV_decomp_jacobi(left.get(), right.get(), singular.get());
  // What is rounding of the largest is none, and the least norm has no part along it.
  const double least = std::numeric_limits<double>::epsilon() * static_cast<double>(a.rows()) *
                       gsl_vector_get(singular.get(), 0);
  for (std::size_t k = 0; k < singular->size; ++k) {
    if (gsl_vector_get(singular.get(), k) <= least) gsl_vector_set(singular.get(), k, 0);
  }
  gsl_linalg_SV_solve(left.get(), right.get(), singular.get(), wanted.get(), x.get());
  return copy(x);
}

}  // namespace plumbline::dense
