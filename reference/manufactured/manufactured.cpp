#include "reference/manufactured/manufactured.hpp"

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

template <class Number>
Vector<Number> force(const Motion<Number>& motion, int dim, double density, const Lame<Number>& lame) {
  const Vector<Number> divergence = divergence_of_first_piola(motion.deformation, motion.gradient, dim, lame);
  Vector<Number> force{};
  for (int i = 0; i < dim; ++i)
    force[i] = motion.acceleration[i] - divergence[i] / Number(density);  // b = a - Div P/rho0
  return force;
}

template <class Number>
ManufacturedState<Number> complete_state(const Motion<Number>& motion, int dim, double density,
                                         const Lame<Number>& lame) {
  ManufacturedState<Number> state;
  state.displacement = motion.displacement;
  state.velocity = motion.velocity;
  state.acceleration = motion.acceleration;
  state.deformation = motion.deformation;
  state.stress = first_piola(motion.deformation, dim, lame);
  state.body_force = force(motion, dim, density, lame);
  return state;
}

Vector<double> three(std::span<const double> position) {
  Vector<double> padded{};
  for (std::size_t i = 0; i < position.size() && i < 3; ++i) padded[i] = position[i];
  return padded;
}

}  // namespace

ManufacturedSolution::ManufacturedSolution(int dimension, double youngs_modulus, double poisson, double density,
                                           double end_time)
    : dimension_(dimension),
      youngs_modulus_(youngs_modulus),
      poisson_(poisson),
      density_(density),
      end_time_(end_time),
      lame_(Lame<double>::from(youngs_modulus, poisson)),
      lame_bounded_(Lame<Bounded>::from(youngs_modulus, poisson)) {
  if (dimension < 1 || dimension > 3) throw ParameterError("dimension", dimension, "1, 2 or 3");
  check_positive("youngs_modulus", youngs_modulus);
  check({"poisson", 0, -1, 0.5, true, true, "1", ""}, poisson);
  check_positive("density", density);
}

Bounded ManufacturedSolution::wave_speed() const { return sqrt(Bounded(youngs_modulus_) / density_); }

ManufacturedState<Bounded> ManufacturedSolution::state(std::span<const double> position, double time) const {
  const Vector<double> at = three(position);
  const char* keys[] = {"x", "y", "z"};
  for (int i = 0; i < dimension_; ++i) check_finite(keys[i], at[i]);
  check_not_negative("time", time);
  if (!contains(position)) throw ParameterError("x", at[0], "a position within the initial body");
  return complete_state(bounded_motion(at, time), dimension_, density_, lame_bounded_);
}

ManufacturedState<double> ManufacturedSolution::values(std::span<const double> position, double time) const {
  return complete_state(motion(three(position), time), dimension_, density_, lame_);
}

Vector<double> ManufacturedSolution::body_force(std::span<const double> position, double time) const {
  return force(motion(three(position), time), dimension_, density_, lame_);
}

}  // namespace plumbline::reference
