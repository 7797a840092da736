#include "cases/catalog/solid/net_throw.hpp"

#include <cmath>
#include <numbers>

namespace plumbline {
namespace {

// Angle at the ball's centre from the direction of flight to where the net leaves the ball.
double wrap_angle(const NetBall& ball, double depth) {
  const double back = ball.radius - depth, half = 0.5 * ball.length;  // from the centre to the supports
  return std::atan2(half, back) - std::acos(ball.radius / std::hypot(back, half));
}

double net_energy(const NetBall& ball, double depth) {
  const double strain = net_length(ball, depth) / ball.length - 1;
  return 0.5 * ball.stiffness * ball.length * strain * strain;
}

}  // namespace

double net_length(const NetBall& ball, double depth) {
  const double back = ball.radius - depth, half = 0.5 * ball.length;
  const double tangent = std::sqrt(back * back + half * half - ball.radius * ball.radius);
  return 2 * (tangent + ball.radius * wrap_angle(ball, depth));
}

double net_force(const NetBall& ball, double depth) {
  const double strain = net_length(ball, depth) / ball.length - 1;
  return 2 * ball.stiffness * strain * std::sin(wrap_angle(ball, depth));
}

NetThrow throw_of_net(const NetBall& ball) {
  const double kinetic = 0.5 * ball.mass * ball.speed * ball.speed;
  double low = 0, high = ball.length;
  for (int k = 0; k < 200 && high - low > 0; ++k) {
    const double middle = 0.5 * (low + high);
    (net_energy(ball, middle) < kinetic ? low : high) = middle;
  }
  NetThrow thrown;
  thrown.deepest = low;
  thrown.force = net_force(ball, low);
  // T = 2 int_0^deepest dx / v(x), x = deepest sin(a): the integrand is smooth, Simpson's rule of 2000 pieces enough.
  const int pieces = 2000;
  const double step = 0.5 * std::numbers::pi / pieces;
  const auto integrand = [&](int k) {
    if (k == pieces) return std::sqrt(ball.mass * low / thrown.force);
    const double a = k * step, left = 1 - net_energy(ball, low * std::sin(a)) / kinetic;
    return low * std::cos(a) / (ball.speed * std::sqrt(left));
  };
  double sum = integrand(0) + integrand(pieces);
  for (int k = 1; k < pieces; ++k) sum += (k % 2 ? 4 : 2) * integrand(k);
  thrown.duration = 2 * sum * step / 3;
  return thrown;
}

}  // namespace plumbline
