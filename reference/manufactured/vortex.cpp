// Tag [Kamojjala 2015]: K. Kamojjala, R. Brannon, A. Sadeghirad, J. Guilkey, Verification tests in solid mechanics,
// Eng. Comput. 31 (2015) 193, doi 10.1007/s00366-013-0342-x.
#include "reference/manufactured/motion.hpp"

namespace plumbline::reference {
namespace {

using std::cos;
using std::sin;
using std::sqrt;

/// x = Q(alpha) X, Q the rotation by alpha = g(t) h(R).
struct Vortex {
  VortexProblem problem;

  /// h, h', h'' at R
  template <class Number>
  std::array<Number, 3> profile(Number radius) const {
    const Number inner(problem.inner), outer(problem.outer), width = outer - inner;
    const Number s = (radius - Number(0.5) * (inner + outer)) / width;
    const Number rest = Number(4) * (radius - inner) * (outer - radius) / (width * width);  // 1 - 4 s^2, exact at edges
    const Number h = rest * rest;                                                           // [Kamojjala 2015]
    const Number slope = Number(-16) * s * rest / width;
    const Number curvature = Number(16) * (Number(8) * s * s - rest) / (width * width);
    return {h, slope, curvature};
  }

  template <class Number>
  Motion<Number> motion(const Vector<double>& position, double time) const {
    const Number x[2] = {Number(position[0]), Number(position[1])};
    const Number radius = sqrt(x[0] * x[0] + x[1] * x[1]), n[2] = {x[0] / radius, x[1] / radius};
    const auto [h, slope, curvature] = profile(radius);
    const Number rate = circle_constant<Number>() / Number(problem.period), phase = rate * Number(time);
    const Number g = Number(problem.amplitude) * sin(phase);
    const Number turn_rate = Number(problem.amplitude) * rate * cos(phase) * h;
    const Number turn_acceleration = -(rate * rate * g * h);
    const Number c = cos(g * h), s = sin(g * h);
    const Number q[2][2] = {{c, -s}, {s, c}}, dq[2][2] = {{-s, -c}, {c, -s}};  // dQ/dalpha; d2Q/dalpha2 = -Q
    const Number turned[2] = {c * x[0] - s * x[1], s * x[0] + c * x[1]}, across[2] = {-turned[1], turned[0]};
    auto delta = [](int a, int b) { return Number(a == b ? 1 : 0); };
    const Number half = sin(Number(0.5) * g * h), off = Number(-2) * half * half;  // cos(alpha) - 1
    Motion<Number> m;
    m.displacement = {off * x[0] - s * x[1], s * x[0] + off * x[1], Number(0)};
    for (int i = 0; i < 2; ++i) {
      m.velocity[i] = turn_rate * across[i];
      m.acceleration[i] = turn_acceleration * across[i] - turn_rate * turn_rate * turned[i];
      for (int j = 0; j < 2; ++j) {
        m.deformation[2 * i + j] = q[i][j] + g * slope * across[i] * n[j];
        for (int k = 0; k < 2; ++k) {
          const Number second = g * (curvature * n[j] * n[k] + slope / radius * (delta(j, k) - n[j] * n[k]));
          m.gradient[(2 * i + j) * 2 + k] = g * slope * (dq[i][j] * n[k] + dq[i][k] * n[j]) -
                                            g * g * slope * slope * turned[i] * n[j] * n[k] + across[i] * second;
        }
      }
    }
    return m;
  }

  bool contains(std::span<const double> position) const {
    return within_annulus(position, problem.inner, problem.outer);
  }
};

}  // namespace

std::unique_ptr<ManufacturedSolution> mms_vortex(const VortexProblem& p) {
  check_annulus(p.youngs_modulus, p.density, p.inner, p.outer);
  check_finite("amplitude", p.amplitude);
  check_positive("period", p.period);
  return std::make_unique<ManufacturedMotion<Vortex>>(Vortex{p}, 2, p.youngs_modulus, p.poisson, p.density, p.period);
}

}  // namespace plumbline::reference
