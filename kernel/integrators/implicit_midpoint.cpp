#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/inadmissible.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

using Vector = Eigen::VectorXd;

Eigen::Map<const Vector> as_vector(const State& state) {
  return {state.values.data(), static_cast<Eigen::Index>(state.values.size())};
}

// How the residual of the midpoint's velocities answers to a change of them: 1 - (dt/2)^2 dA/dq B - dt/2 dA/dv, with
// accelerations A and rates B v of all else. By differences of rates: no matrix is ever formed.
struct Response;

}  // namespace
}  // namespace plumbline

template <>
struct Eigen::internal::traits<plumbline::Response> : public Eigen::internal::traits<Eigen::SparseMatrix<double>> {};

namespace plumbline {
namespace {

struct Response : public Eigen::EigenBase<Response> {
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

  Response(Stages& stages, const State& midpoint, double half_step) : mpm(stages), z(midpoint), half(half_step) {}
  Eigen::Index rows() const { return static_cast<Eigen::Index>(z.values.size()); }
  Eigen::Index cols() const { return rows(); }
  template <class Rhs>
  Eigen::Product<Response, Rhs, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Rhs>& x) const {
    return {*this, x.derived()};
  }

  // w where it is not a velocity stays as it is.
  Vector times(const Vector& w) const {
    State change = z;
    std::copy(w.begin(), w.end(), change.values.begin());
    const State velocities = mpm.velocities_of(change);
    const double size = as_vector(velocities).norm();
    if (size == 0) return w;
    const double small = 1e-6 * (1 + as_vector(z).norm()) / size;  // [Implicit-Midpoint 3]
    mpm.set_state(z + -1.0 * mpm.velocities_of(z) + velocities);
    const State kinematic = mpm.rate();
    const State along = velocities + half * (kinematic + -1.0 * mpm.velocities_of(kinematic));
    mpm.set_state(z + small * along);
    const State above = mpm.velocities_of(mpm.rate());
    mpm.set_state(z + -small * along);
    const State below = mpm.velocities_of(mpm.rate());
    return w - half / (2 * small) * (as_vector(above) - as_vector(below));
  }

  Stages& mpm;
  const State& z;
  double half;
};

}  // namespace
}  // namespace plumbline

template <class Rhs>
struct Eigen::internal::generic_product_impl<plumbline::Response, Rhs, Eigen::SparseShape, Eigen::DenseShape,
                                             Eigen::GemvProduct>
    : Eigen::internal::generic_product_impl_base<plumbline::Response, Rhs,
                                                 Eigen::internal::generic_product_impl<plumbline::Response, Rhs>> {
  template <class To>
  static void scaleAndAddTo(To& to, const plumbline::Response& response, const Rhs& x, const double& factor) {
    to += factor * response.times(x);
  }
};

namespace plumbline {
namespace {

// y' = y + dt f((y + y')/2). Newton's method for the velocities of the midpoint, each correction by GMRES; all else follows
// from them. Of an oscillator neither damped nor ever unstable. Throws InadmissibleState where no midpoint is found: forces
// that jump may have none. Equations: reports/docs/theory/step.md, "Integrators of the laboratory".
class ImplicitMidpoint final : public TimeIntegrator {
  static constexpr int most_corrections = 20;
  static constexpr double rounding = 1e-12;  // of forces that cancel, to the size of the state

  Claims claims() const override {
    return {.orders = {{2}, {2, "oscillator", "velocity"}, {2, "fixed mesh", "strain"}, {2, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::conserved,
            .limit = std::numeric_limits<double>::infinity(),
            .reversible = true};
  }

  void step(Stages& mpm, double dt) override {
    const State y = mpm.state();
    State z = y;
    mpm.set_state(z);
    State rate = mpm.rate();
    double least = std::numeric_limits<double>::infinity();
    bool found = false;
    for (int k = 0; k < most_corrections; ++k) {
      const State velocities = mpm.velocities_of(z);
      z = velocities + (y + -1.0 * mpm.velocities_of(y)) + dt / 2 * (rate + -1.0 * mpm.velocities_of(rate));
      mpm.set_state(z);
      rate = mpm.rate();
      const State residual = y + dt / 2 * rate + -1.0 * z;  // [Implicit-Midpoint 1]
      const double size = as_vector(mpm.velocities_of(residual)).norm(), speed = as_vector(velocities).norm();
      const double kick = dt / 2 * as_vector(mpm.velocities_of(rate)).norm();
      found = size <= 1e-9 * (speed + kick) || size <= rounding * as_vector(z).norm();
      if (size <= 1e-13 * (speed + kick) || (found && !(size < 0.5 * least))) break;  // rounding is left
      least = std::min(least, size);
      z += correction(mpm, z, mpm.velocities_of(residual), dt / 2);
      mpm.set_state(z);
      rate = mpm.rate();
    }
    if (!found) throw InadmissibleState("the implicit midpoint was not found", "all", 0, "velocity", least);
    mpm.set_state(2.0 * z + -1.0 * y);  // [Implicit-Midpoint 2]
  }

  static State correction(Stages& mpm, const State& z, const State& residual, double half) {
    const Response response(mpm, z, half);
    Eigen::GMRES<Response, Eigen::IdentityPreconditioner> gmres;
    gmres.set_restart(60);
    gmres.setTolerance(1e-8);  // differences of rates know no more; the next correction takes the rest
    gmres.setMaxIterations(120);
    gmres.compute(response);
    const Vector solved = gmres.solve(as_vector(residual));
    State change = residual;
    std::copy(solved.begin(), solved.end(), change.values.begin());
    return mpm.velocities_of(change);
  }
};

PLUMBLINE_INTEGRATOR(ImplicitMidpoint, "implicit-midpoint", "the implicit midpoint rule, matrix-free",
                     "Simo, Tarnow, Wong 1992, doi 10.1016/0045-7825(92)90115-Z; Newton-Krylov: Knoll, Keyes 2004, doi "
                     "10.1016/j.jcp.2003.08.010");

}  // namespace
}  // namespace plumbline
