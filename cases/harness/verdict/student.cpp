#include "cases/harness/verdict/student.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <limits>

namespace plumbline {
namespace {

namespace policies = boost::math::policies;

// In double throughout: tables in long double, made as the program starts, end it under valgrind, which has none.
using StudentT = boost::math::students_t_distribution<double, policies::policy<policies::promote_double<false>>>;

}  // namespace

double student_quantile(double degrees) {
  if (!(degrees > 0)) return std::numeric_limits<double>::infinity();
  return quantile(complement(StudentT(degrees), 0.025));
}

}  // namespace plumbline
