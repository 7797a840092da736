#include <algorithm>

#include "reference/circle.hpp"
#include "reference/quadrature.hpp"
#include "reference/shooting.hpp"

namespace plumbline::reference {
namespace {

/// int_0^angle cos^power/sqrt(1 + cos^2).
double lemniscate(double angle, int power) {
  auto f = [power](double at) {
    const double square = std::pow(std::cos(at), 2);
    return Bounded(std::pow(square, power / 2) / std::sqrt(1 + square));
  };
  return integrate(f, 0, angle).value;
}

/// The strain e1 with l1 (l1^2 - 1)/2 = l1 e1 = pull: Newton's method falls to it, as the left side is convex.
double pulled_strain(double pull) {
  double e = pull;
  for (int i = 0; i < 100; ++i) {
    const double l = std::sqrt(1 + 2 * e), step = (l * e - pull) / (l + e / l);
    e -= step;
    if (!(step > 2 * rounding::unit * e)) break;
  }
  return e;
}

/// int l1 ds from s to 1, by parts: s = N/(l1 e1), l1^2 = 1 + 2 e1.
double arc_length(double force, double s) {
  const double inner = pulled_strain(force / s), outer = pulled_strain(force);
  // [l1 s] - int s dl1 with int 2 dl1/(l1 (l1^2 - 1)) = ln(2 e1/l1^2)
  const double logarithm = std::log(inner / (1 + 2 * inner)) - std::log(outer / (1 + 2 * outer));
  return std::sqrt(1 + 2 * outer) - std::sqrt(1 + 2 * inner) * s + force * logarithm;  // [Surface 11]
}

/// One strain in the middle: the taut middle, and wrinkles from there to the seam.
struct SewnShot {
  static constexpr const char* refusal = "less: the balloon is taut at its seam";
  TautSheet sheet;
  double force = 0, rim = 0, angle = 0;  // N, R, theta where the wrinkles begin
  TautSheet::Point edge{};

  SewnShot(const SheetSettings& settings, double strain) : sheet(settings, strain, true) {
    if (!sheet.is_wrinkled()) return;
    edge = sheet.at(sheet.end());
    force = sheet.end() * edge.meridian * std::sqrt(1 + 2 * edge.meridian_strain);
    rim = std::sqrt(2 * force / settings.load);
    angle = std::acos(std::min(1.0, edge.radius / rim));
  }

  /// How much longer the way to the seam is than the sheet that is left.
  double excess() const {
    if (!sheet.is_wrinkled()) return sheet.reaches_rim() ? 1 : -1;
    return rim * lemniscate(angle, 0) - arc_length(force, sheet.end());
  }
  double edge_height() const { return rim * lemniscate(angle, 2); }
  std::vector<double> numbers() const {
    const double wrinkled = pi.value * rim * rim * rim * lemniscate(angle, 4);
    return {edge_height() + edge.drop, sheet.at(0).meridian, rim, 2 * (edge.volume + wrinkled), sheet.end()};
  }
  std::array<double, 5> at(double s) const {
    if (s <= sheet.end()) {
      const TautSheet::Point p = sheet.at(s);
      return {p.radius, edge_height() + edge.drop - p.drop, p.meridian, p.hoop, std::sqrt(1 + 2 * p.meridian_strain)};
    }
    const double e = pulled_strain(force / s), length = arc_length(force, s);
    auto missed = [&](double theta) { return rim * lemniscate(theta, 0) - length; };
    const double theta = missed(0) < 0 ? brent_root(missed, 0, 1.6) : 0;
    return {rim * std::cos(theta), rim * lemniscate(theta, 2), e, 0, std::sqrt(1 + 2 * e)};
  }
};

}  // namespace

struct MylarBalloon::Solution {
  Shooting<SewnShot> shooting;
};

MylarBalloon::MylarBalloon(const CircularMembraneProblem& problem) : radius_(problem.radius) {
  check_circular_membrane(problem);
  solution_ = std::make_shared<const Solution>(Solution{{problem.load, problem.poisson_ratio}});
  const Bounded rim = solution_->shooting.number(2);
  const Bounded hoop = Bounded(0.5) * (rim * rim - 1.0),
                strain = pulled_strain(0.5 * problem.load * rim.value * rim.value);
  if (!certainly_below(hoop + Bounded(problem.poisson_ratio) * strain, 0.0)) {
    throw ParameterError("load", problem.load, SewnShot::refusal);
  }
}

Bounded MylarBalloon::half_height() const { return solution_->shooting.number(0) * radius_; }
Bounded MylarBalloon::stress() const { return solution_->shooting.number(1); }
Bounded MylarBalloon::rim_radius() const { return solution_->shooting.number(2) * radius_; }
Bounded MylarBalloon::volume() const { return solution_->shooting.number(3) * radius_ * radius_ * radius_; }
Bounded MylarBalloon::taut_radius() const { return solution_->shooting.number(4) * radius_; }
MembranePoint MylarBalloon::at(double s) const { return solution_->shooting.at(s, radius_); }

}  // namespace plumbline::reference
