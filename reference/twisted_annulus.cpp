#include "reference/twisted_annulus.hpp"

#include <array>

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/quadrature.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

/// Of a line of tension where it is R from the axis at rest.
struct Line {
  Bounded g, q;

  Line(Bounded p, Bounded kappa, double R) {
    const Bounded square = (Bounded(R) - p) * (Bounded(R) + p) / (Bounded(R) * R), load = Bounded(2) * kappa / R;
    g = sqrt(square);
    // The cubic is convex above its root: Newton's steps from there never leave it below, but for rounding.
    double at = g.value + std::cbrt(load.value);
    for (double before = 2 * at; at < before;) {
      before = at;
      at -= (at * (at * at - square.value) - load.value) / (3 * at * at - square.value);
    }
    const Bounded left = Bounded(at) * (Bounded(at) * at - square) - load;  // [Annulus 2]
    const double slope = 2 * at * at + load.value / at;  // of the cubic there, by the cubic; halved for the interval
    q = {at, 2 * highest({std::abs(left.value), left.bound}) / slope};
  }
};

Bounded lengthening(Bounded p, Bounded kappa, double low, double high) {  // [Annulus 3]
  return integrate(
      [=](double R) {
        const Line line(p, kappa, R);
        const Bounded both = Bounded(R) * line.q;
        return (Bounded(1) - p * p / (both * R * line.g)) / (both * (line.q + line.g));
      },
      low, high);
}

Bounded turning(Bounded p, Bounded kappa, double low, double high) {  // [Annulus 4]
  return integrate(
      [=](double R) {
        const Line line(p, kappa, R);
        const Bounded both = Bounded(R) * line.q;
        return Bounded(1) / (both * both * R * line.g * (line.q + line.g));
      },
      low, high);
}

Bounded twist_of(Bounded p, Bounded kappa, double a, double b) {
  return Bounded(2) * kappa * p * turning(p, kappa, a, b);
}

/// The pull at which lines that pass the axis at p reach from rim to rim.
double pull_of(double p, double a, double b) {
  const auto longer = [&](double kappa) { return lengthening(p, kappa, a, b).value; };
  double high = a;
  while (!(longer(high) > 0)) high *= 4;
  double low = high;
  while (!(longer(low) < 0)) low /= 4;
  return brent_root(longer, low, high);
}

/// p of small twists. Inside the inner rim there is one, since the difference falls from log(b^2/a^2) without end.
double arm_of_small_twists(double a, double b) {
  const auto side = [](double x) { return std::log(x / (1 - x)) - 1 / (1 - x); };
  const auto falls = [&](double x) { return side(x * a * a / (b * b)) - side(x); };  // [Annulus 5]
  return a * std::sqrt(brent_root(falls, 1e-9, 1 - 1e-9));
}

Bounded atan2(Bounded y, Bounded x) {  // both positive
  const Bounded square = x * x + y * y;
  const double spread = (std::abs(y.value) * x.bound + std::abs(x.value) * y.bound + x.bound * y.bound) /
                        std::max(lowest(square), std::numeric_limits<double>::min());
  return rounding::result(std::atan2(y.value, x.value), 2 * spread, 2);
}

}  // namespace

TwistedAnnulus::TwistedAnnulus(const TwistedAnnulusProblem& problem) : problem_(problem) {
  const double a = problem.inner_radius, b = problem.outer_radius, twist = problem.twist;
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_within("poisson_ratio", problem.poisson_ratio, 0, 0.5);
  check_positive("thickness", problem.thickness);
  check_positive("inner_radius", a);
  check({"outer_radius", 0, 1.02 * a, 50 * a, false, false, "", ""}, b);
  check({"twist", 0, 1e-6, 3, false, false, "", ""}, twist);
  // Unit of length: the outer radius. More twist takes lines farther from the axis.
  const double inner = a / b;
  const auto excess = [&](double p) { return twist_of(p, pull_of(p, inner, 1), inner, 1).value - twist; };
  const double nearest = arm_of_small_twists(inner, 1);
  double least = 0.5, most = 0.5;  // shares of the way from there to the rim
  const auto share = [&](double s) { return excess(nearest + s * (inner - nearest)); };
  while (most < 1 - 1e-6 && !(share(most) > 0)) most = 0.5 * (1 + most);
  if (!(share(most) > 0)) throw ParameterError("twist", twist, "less: lines of tension would meet the inner rim");
  while (!(share(least) < 0)) least *= 0.25;
  const double p = nearest + brent_root(share, least, most) * (inner - nearest), kappa = pull_of(p, inner, 1);
  bound_roots(p, kappa);
  for (int i = 0; i <= 64; ++i) {
    const AnnulusPoint point = at(a + (b - a) * i / 64);
    const Bounded across = (point.across - 1.0) * (point.across + 1.0);
    const Bounded along = (point.along - 1.0) * (point.along + 1.0);
    if (!certainly_below(across + Bounded(problem.poisson_ratio) * along, 0.0))  // [Annulus 7]
      throw ParameterError("poisson_ratio", problem.poisson_ratio,
                           "less: the sheet is taut both ways at its outer rim");
  }
}

/// By the inverse of the slopes of both conditions, which differences know to 1e-6: twice the change that what is left asks for.
void TwistedAnnulus::bound_roots(double p, double kappa) {
  const double inner = problem_.inner_radius / problem_.outer_radius, d = 1e-6;
  const auto left = [&](double at_p, double at_kappa) {
    return std::array{lengthening(at_p, at_kappa, inner, 1), twist_of(at_p, at_kappa, inner, 1) - problem_.twist};
  };
  const auto here = left(p, kappa), more_p = left(p * (1 - d), kappa), more_kappa = left(p, kappa * (1 + d));
  double by_p[2], by_kappa[2], size[2];
  for (std::size_t i = 0; i < 2; ++i) {
    by_p[i] = (here[i].value - more_p[i].value) / (p * d);
    by_kappa[i] = (more_kappa[i].value - here[i].value) / (kappa * d);
    size[i] = std::abs(here[i].value) + here[i].bound;
  }
  const double determinant = std::abs(by_p[0] * by_kappa[1] - by_p[1] * by_kappa[0]);
  const double length = problem_.outer_radius;
  arm_ = Bounded(p, 2 * (std::abs(by_kappa[1]) * size[0] + std::abs(by_kappa[0]) * size[1]) / determinant) * length;
  kappa_ = Bounded(kappa, 2 * (std::abs(by_p[1]) * size[0] + std::abs(by_p[0]) * size[1]) / determinant) * length;
}

Bounded TwistedAnnulus::pull() const { return Bounded(problem_.thickness) * problem_.youngs_modulus * kappa_; }

Bounded TwistedAnnulus::torque() const { return Bounded(2) * pi * pull() * arm_; }  // [Annulus 6]

Bounded TwistedAnnulus::energy() const {  // [Annulus 6]
  const Bounded density = integrate(
      [this](double R) {
        const Bounded strain = kappa_ / (Bounded(R) * Line(arm_, kappa_, R).q);  // [Annulus 1]
        return strain * strain * R;
      },
      problem_.inner_radius, problem_.outer_radius);
  return pi * problem_.thickness * problem_.youngs_modulus * density;
}

AnnulusPoint TwistedAnnulus::at(double R) const {
  const double a = problem_.inner_radius;
  check_within("position", R, a, problem_.outer_radius);
  const Line line(arm_, kappa_, R);
  const Bounded rest = line.g * R, twice = Bounded(2) * kappa_;
  const Bounded u = rest + twice * lengthening(arm_, kappa_, a, R);
  const Bounded strain = kappa_ / (Bounded(R) * line.q);
  AnnulusPoint point;
  point.radius = sqrt(u * u + arm_ * arm_);
  point.turned = atan2(u, arm_) - atan2(rest, arm_) + twice * arm_ * turning(arm_, kappa_, a, R) - problem_.twist;
  point.along = sqrt(Bounded(1) + Bounded(2) * strain);
  point.across = point.along * u / (Bounded(R) * line.q);
  point.stress = Bounded(problem_.youngs_modulus) * strain;
  point.rest = atan2(arm_ / R, line.q);
  point.now = atan2(arm_, u);
  return point;
}

}  // namespace plumbline::reference
