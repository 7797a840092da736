#include "reference/manufactured/motion.hpp"

namespace plumbline::reference {
namespace {

using std::cos;
using std::sin;
using std::sqrt;

struct AxisAligned {
  AxisAlignedProblem problem;

  template <class Number>
  Motion<Number> motion(const Vector<double>& position, double time) const {
    const AxisAlignedProblem& p = problem;
    const int dim = p.dimension;
    const Number k = circle_constant<Number>() / Number(p.length);
    const Number omega = k * sqrt(Number(p.youngs_modulus) / Number(p.density));
    Motion<Number> m;
    for (int i = 0; i < dim; ++i) {
      const Number phase = omega * Number(time) + circle_constant<Number>() * Number(p.phase[i]);
      const Number swing = Number(p.amplitude) * sin(phase);
      const Number place = k * Number(position[i]), shape = sin(place);
      m.displacement[i] = swing * shape;  // [Wallstedt 2008]
      m.velocity[i] = Number(p.amplitude) * omega * cos(phase) * shape;
      m.acceleration[i] = -(omega * omega * m.displacement[i]);
      m.deformation[dim * i + i] = Number(1) + swing * k * cos(place);
      m.gradient[(dim * i + i) * dim + i] = -(k * k * m.displacement[i]);
    }
    return m;
  }

  bool contains(std::span<const double> position) const {
    for (int i = 0; i < problem.dimension; ++i) {
      if (!(position[i] >= 0 && position[i] <= problem.length)) return false;
    }
    return true;
  }
};

}  // namespace

AxisAlignedProblem mms_bar_problem(double amplitude) { return {1, 1e7, 0, 1000, 1, amplitude, {0, 0, 0}}; }
AxisAlignedProblem mms_square_problem(double amplitude) { return {2, 1e4, 0.3, 1, 1, amplitude, {0, 1, 0}}; }
AxisAlignedProblem mms_cube_problem(double amplitude) { return {3, 1e4, 0.3, 1, 1, amplitude, {0, 2.0 / 3, 4.0 / 3}}; }

std::unique_ptr<ManufacturedSolution> mms_axis_aligned(const AxisAlignedProblem& p) {
  check_positive("length", p.length);
  check_finite("amplitude", p.amplitude);
  for (double phase : p.phase) check_finite("phase", phase);
  if (!(std::abs(p.amplitude) * pi.value < p.length)) {
    throw ParameterError("amplitude", p.amplitude, "below length/pi in size: else the body turns inside out");
  }
  const double end_time = 2 * p.length * std::sqrt(p.density / p.youngs_modulus);
  return std::make_unique<ManufacturedMotion<AxisAligned>>(AxisAligned{p}, p.dimension, p.youngs_modulus, p.poisson,
                                                           p.density, end_time);
}

}  // namespace plumbline::reference
