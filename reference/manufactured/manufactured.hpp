#pragma once
// Manufactured solutions of finite-strain elasticity: a motion x = X + u(X, t) is chosen, and the body force per mass
// that makes a neo-Hookean solid move so follows, b = a - Div P/rho0 (P. J. Roache, J. Fluids Eng. 124 (2002) 4).
// All fields belong to the material point that started at X: b too is a function of X, not of x.
#include <memory>
#include <span>
#include <string>

#include "reference/manufactured/neo_hookean.hpp"

namespace plumbline::reference {

/// At one point and time. Vectors have dim components, tensors are row-major dim x dim.
template <class Number>
struct ManufacturedState {
  Vector<Number> displacement{}, velocity{}, acceleration{};  // m, m/s, m/s^2
  Tensor<Number> deformation{};                               // F = I + du/dX
  Tensor<Number> stress{};                                    // first Piola-Kirchhoff, Pa
  Vector<Number> body_force{};                                // per mass, m/s^2
};

/// What a solution has to state; the material makes stress and body force of it.
template <class Number>
struct Motion {
  Vector<Number> displacement{}, velocity{}, acceleration{};
  Tensor<Number> deformation{};
  TensorGradient<Number> gradient{};  // of the deformation
};

class ManufacturedSolution {
 public:
  virtual ~ManufacturedSolution() = default;

  int dimension() const { return dimension_; }
  double youngs_modulus() const { return youngs_modulus_; }
  double poisson() const { return poisson_; }
  double density() const { return density_; }  // initial, kg/m^dim
  Lame<Bounded> lame() const { return lame_bounded_; }
  Bounded wave_speed() const;  // c = sqrt(E/rho0)
  double end_time() const { return end_time_; }

  /// `position` is the initial one, `dimension()` coordinates, within the body; time >= 0. Every number with the bound
  /// of its error. Throws ParameterError (key x, y, z or time) outside the body.
  ManufacturedState<Bounded> state(std::span<const double> position, double time) const;
  /// The same numbers without bounds, for each point at each step; checks nothing.
  ManufacturedState<double> values(std::span<const double> position, double time) const;
  Vector<double> body_force(std::span<const double> position, double time) const;

  /// False outside the initial body.
  virtual bool contains(std::span<const double> position) const = 0;

 protected:
  ManufacturedSolution(int dimension, double youngs_modulus, double poisson, double density, double end_time);

 private:
  virtual Motion<double> motion(const Vector<double>& position, double time) const = 0;
  virtual Motion<Bounded> bounded_motion(const Vector<double>& position, double time) const = 0;

  int dimension_;
  double youngs_modulus_, poisson_, density_, end_time_;
  Lame<double> lame_;
  Lame<Bounded> lame_bounded_;
};

/// u_i = A sin(pi X_i/L) sin(pi c t/L + pi phase_i) in [0, L]^dim: normal components vanish on all faces, and so do the
/// shears [Wallstedt 2008]. A pi/L < 1. To t = 2 L/c, one period.
struct AxisAlignedProblem {
  int dimension = 2;
  double youngs_modulus = 1e4;
  double poisson = 0.3;
  double density = 1;
  double length = 1;
  double amplitude = 0.1;
  Vector<double> phase{0, 1, 0};  // in units of pi
};

/// In one dimension, E = 1e7, nu = 0, rho = 1000, to t = 0.02 (Steffen et al. 2008, de Vaucorbeil et al. 2020).
AxisAlignedProblem mms_bar_problem(double amplitude = 0.05);
/// Two dimensions (plane strain), phases 0 and 1; amplitude 0.1 [Wallstedt 2008].
AxisAlignedProblem mms_square_problem(double amplitude = 0.1);
/// Three dimensions, phases 0, 2/3, 4/3 as in the Uintah verification suite; the paper's author also used none.
AxisAlignedProblem mms_cube_problem(double amplitude = 0.1);

/// Radial: u_R = A cos(pi c t) (c3 R^3 + c2 R^2 + c1 R), with u_R(outer) = A at t = 0 and du_R/dR proportional to
/// (R - inner)(R - outer): with nu = 0 both edges are free of traction [Wallstedt 2008]. In the plane about the origin;
/// pi here has the unit 1/m. outer != 3 inner. To t = 2/c.
struct RingProblem {
  double youngs_modulus = 1e4;
  double density = 1;
  double inner = 0.5;
  double outer = 1;
  double amplitude = 0.1;
};

/// Each circle turns by alpha = A sin(pi t/T) h(R), h = (1 - 4 s^2)^2, s = (R - mean radius)/(outer - inner): large
/// shears, no change of volume; at both edges h and h' vanish: they rest, free of traction [Kamojjala 2015]. To t = T.
struct VortexProblem {
  double youngs_modulus = 1000;
  double poisson = 0.3;
  double density = 1000;
  double inner = 0.75;
  double outer = 1.25;
  double amplitude = 1;  // radians
  double period = 1;     // T, s
};

// Each throws ParameterError with the key of a value out of range, also where the motion would turn the body inside
// out.
std::unique_ptr<ManufacturedSolution> mms_axis_aligned(const AxisAlignedProblem& problem);
std::unique_ptr<ManufacturedSolution> mms_ring(const RingProblem& problem = {});
std::unique_ptr<ManufacturedSolution> mms_vortex(const VortexProblem& problem = {});

}  // namespace plumbline::reference
