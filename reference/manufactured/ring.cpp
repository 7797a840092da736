#include "reference/manufactured/motion.hpp"

namespace plumbline::reference {
namespace {

using std::cos;
using std::sin;
using std::sqrt;

/// u = s(R) X cos(omega t), s = A (c3 R^2 + c2 R + c1).
struct Ring {
  RingProblem problem;

  /// s, s', s'' at R
  template <class Number>
  std::array<Number, 3> stretch(Number radius) const {
    const Number inner(problem.inner), outer(problem.outer), amplitude(problem.amplitude);
    const Number scale = amplitude / (outer * outer * (outer - Number(3) * inner));
    const Number c3 = Number(-2) * scale;  // [Wallstedt 2008]
    const Number c2 = Number(3) * (inner + outer) * scale;
    const Number c1 = Number(-6) * inner * outer * scale;
    return {(c3 * radius + c2) * radius + c1, Number(2) * c3 * radius + c2, Number(2) * c3};
  }

  template <class Number>
  Motion<Number> motion(const Vector<double>& position, double time) const {
    const Number x[2] = {Number(position[0]), Number(position[1])};
    const Number radius = sqrt(x[0] * x[0] + x[1] * x[1]), n[2] = {x[0] / radius, x[1] / radius};
    const Number omega = circle_constant<Number>() * sqrt(Number(problem.youngs_modulus) / Number(problem.density));
    const Number swing = cos(omega * Number(time)), rate = -(omega * sin(omega * Number(time)));
    const auto [s, slope, curvature] = stretch(radius);
    auto delta = [](int a, int b) { return Number(a == b ? 1 : 0); };
    Motion<Number> m;
    for (int i = 0; i < 2; ++i) {
      m.displacement[i] = s * x[i] * swing;
      m.velocity[i] = s * x[i] * rate;
      m.acceleration[i] = -(omega * omega * m.displacement[i]);
      for (int j = 0; j < 2; ++j) {
        m.deformation[2 * i + j] = delta(i, j) + swing * (s * delta(i, j) + slope * x[i] * n[j]);
        for (int k = 0; k < 2; ++k) {
          const Number turn = x[i] * (delta(j, k) - n[j] * n[k]) / radius;
          const Number first = delta(i, j) * n[k] + delta(i, k) * n[j] + turn;
          m.gradient[(2 * i + j) * 2 + k] = swing * (slope * first + curvature * x[i] * n[j] * n[k]);
        }
      }
    }
    return m;
  }

  bool contains(std::span<const double> position) const {
    return within_annulus(position, problem.inner, problem.outer);
  }

  /// Largest size of du_R/dR, midway between the edges, and of u_R/R, a parabola, at t = 0.
  double largest_strain() const {
    const double middle = 0.5 * (problem.inner + problem.outer);
    const auto [s, slope, curvature] = stretch(middle);
    double largest = std::abs(s + middle * slope);
    const double top = middle - slope / curvature;
    for (double radius : {problem.inner, problem.outer, std::clamp(top, problem.inner, problem.outer)}) {
      largest = std::max(largest, std::abs(stretch(radius)[0]));
    }
    return largest;
  }
};

}  // namespace

std::unique_ptr<ManufacturedSolution> mms_ring(const RingProblem& p) {
  check_annulus(p.youngs_modulus, p.density, p.inner, p.outer);
  check_finite("amplitude", p.amplitude);
  if (p.outer == 3 * p.inner) throw ParameterError("outer", p.outer, "not three times inner");
  const Ring ring{p};
  if (!(ring.largest_strain() < 1)) {
    throw ParameterError("amplitude", p.amplitude, "small enough that no strain reaches -1");
  }
  const double end_time = 2 * std::sqrt(p.density / p.youngs_modulus);
  return std::make_unique<ManufacturedMotion<Ring>>(ring, 2, p.youngs_modulus, 0, p.density, end_time);
}

}  // namespace plumbline::reference
