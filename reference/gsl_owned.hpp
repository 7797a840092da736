// Objects of GSL that free themselves.
#pragma once

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_permutation.h>
#include <gsl/gsl_roots.h>

#include <memory>

namespace plumbline::reference {

struct GslFree {
  void operator()(gsl_vector* p) const { gsl_vector_free(p); }
  void operator()(gsl_vector_complex* p) const { gsl_vector_complex_free(p); }
  void operator()(gsl_matrix* p) const { gsl_matrix_free(p); }
  void operator()(gsl_matrix_complex* p) const { gsl_matrix_complex_free(p); }
  void operator()(gsl_permutation* p) const { gsl_permutation_free(p); }
  void operator()(gsl_eigen_symmv_workspace* p) const { gsl_eigen_symmv_free(p); }
  void operator()(gsl_eigen_nonsymm_workspace* p) const { gsl_eigen_nonsymm_free(p); }
  void operator()(gsl_eigen_nonsymmv_workspace* p) const { gsl_eigen_nonsymmv_free(p); }
  void operator()(gsl_integration_glfixed_table* p) const { gsl_integration_glfixed_table_free(p); }
  void operator()(gsl_root_fsolver* p) const { gsl_root_fsolver_free(p); }
  void operator()(gsl_odeiv2_step* p) const { gsl_odeiv2_step_free(p); }
  void operator()(gsl_odeiv2_control* p) const { gsl_odeiv2_control_free(p); }
  void operator()(gsl_odeiv2_evolve* p) const { gsl_odeiv2_evolve_free(p); }
};

template <class Object>
using Owned = std::unique_ptr<Object, GslFree>;

}  // namespace plumbline::reference
