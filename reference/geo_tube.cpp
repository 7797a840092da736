#include "reference/geo_tube.hpp"

#include "reference/argument.hpp"
#include "reference/carlson.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

/// k^2, k' and the complete integrals, from v = (k/k')^2.
struct Modulus {
  Bounded square, complement;
  CompleteKDC complete;
  explicit Modulus(Bounded v)
      : square(v / (Bounded(1) + v)),
        complement(Bounded(1) / sqrt(Bounded(1) + v)),
        complete(complete_KDC(square, complement)) {}
  Bounded length(Bounded v) const { return v * complete.D * complement; }  // A(v)
};

/// The lower root of A(v) - give v = load. Newton's method rises to it from 0, since the left side is concave.
Bounded lower_root(Bounded load, Bounded give, double compliance) {
  const ParameterError none("compliance", compliance, "less: no membrane that gives so much holds this pressure");
  double v = 0, slope = 0;
  for (int i = 0; i < 500; ++i) {
    const Modulus m(v);
    slope = 0.5 * m.complete.K.value * m.complement.value - give.value;
    if (!(slope > 0) || !std::isfinite(v)) throw none;
    const double step = (load.value - m.length(v).value + give.value * v) / slope;
    v += step;
    if (!(step > 4 * rounding::unit * v)) break;
  }
  auto f = [&](double at) { return Modulus(at).length(at) - give * at - load; };
  return enclose_root(f, v, slope, 0, rounding::infinity);
}

Bounded modulus(const GeoTubeProblem& p) {
  const Bounded top(p.top_pressure), rest(p.perimeter);
  const Bounded give = Bounded(p.compliance) * top * rest / 8.0;
  if (p.specific_weight == 0 && !certainly_below(give, pi / 4.0))
    throw ParameterError("compliance", p.compliance, "less: no membrane that gives so much holds this pressure");
  if (p.specific_weight == 0) return 0.0;
  return lower_root(Bounded(p.specific_weight) * rest / (Bounded(2) * top), give, p.compliance);
}

Bounded delta_of(Bounded phi, Bounded complement) {
  const Bounded cosine = cos(phi), kept = complement * sin(phi);
  return sqrt(cosine * cosine + kept * kept);
}

LegendreFD integrals(Bounded phi, Bounded complement) {
  return legendre_FD(sin(phi), cos(phi), delta_of(phi, complement));
}

}  // namespace

GeoTube::GeoTube(const GeoTubeProblem& problem) : problem_(problem) {
  check_positive("perimeter", problem.perimeter);
  check_not_negative("specific_weight", problem.specific_weight);
  check_positive("top_pressure", problem.top_pressure);
  check_not_negative("compliance", problem.compliance);
  const Modulus m(modulus(problem));
  square_ = m.square;
  complement_ = m.complement;
  K_ = m.complete.K;
  D_ = m.complete.D;
  C_ = m.complete.C;
  // 8 l D = L0 (1 + c T) with T = l p0
  length_ = Bounded(problem.perimeter) /
            (Bounded(8) * D_ - Bounded(problem.compliance) * problem.perimeter * bottom_pressure());
}

Bounded GeoTube::bottom_pressure() const { return Bounded(problem_.top_pressure) / complement_; }
Bounded GeoTube::tension() const { return length_ * bottom_pressure(); }
Bounded GeoTube::strain() const { return Bounded(problem_.compliance) * tension(); }
Bounded GeoTube::height() const { return Bounded(4) * length_ / (Bounded(1) + complement_); }
Bounded GeoTube::contact_width() const { return Bounded(4) * length_ * square_ * C_; }
Bounded GeoTube::area() const { return Bounded(16) * length_ * length_ * C_; }  // p0 b/w, w = p0 k^2/(4 l)

Bounded GeoTube::width() const {
  const LegendreFD half = integrals(pi / 4.0, complement_);
  return contact_width() + Bounded(4) * length_ * (half.F - Bounded(2) * half.D);
}

/// phi with F(phi) = u. F' = 1/Delta >= 1 grows: an error of u moves phi by at most Delta at the lower end times as
/// much.
Bounded GeoTube::half_angle(Bounded u) const {
  const double most = 0.5 * pi.value;
  auto f = [&](double phi) { return integrals(phi, complement_).F - u.value; };
  auto value = [&](double phi) { return f(phi).value; };
  if (!(u.value > 0)) return {0, std::max(0.0, highest(u))};
  const double guess = value(most) > 0 ? brent_root(value, 0, most) : most;
  Bounded phi = enclose_root(f, guess, 1 / delta_of(guess, complement_).value, 0, most);
  const double lower = std::max(0.0, guess - phi.bound - u.bound);
  phi.bound += u.bound * std::min(1.0, highest(delta_of(lower, complement_))) + pi.bound;
  return phi;
}

GeoTubePoint GeoTube::free_point(Bounded s, Bounded u) const {
  const Bounded phi = half_angle(u), sine = sin(phi), delta = delta_of(phi, complement_);
  GeoTubePoint point;
  point.x = s - Bounded(4) * length_ * integrals(phi, complement_).D;
  point.y = Bounded(4) * length_ * sine * sine / (Bounded(1) + delta);
  point.angle = Bounded(2) * phi;
  point.pressure = bottom_pressure() * delta;
  point.curvature = delta / length_;
  return point;
}

GeoTubePoint GeoTube::at(double along) const {
  check_within("along", along, 0, problem_.perimeter);
  const bool left = along > 0.5 * problem_.perimeter;
  const Bounded rest = left ? Bounded(problem_.perimeter) - along : Bounded(along);
  const Bounded s = rest * (Bounded(1) + strain());
  const Bounded u = (s - Bounded(0.5) * contact_width()) / (Bounded(2) * length_);
  GeoTubePoint point{s, 0.0, 0.0, 0.0, bottom_pressure()};
  if (highest(u) > 0) point = free_point(s, u);
  if (lowest(u) <= 0 && highest(u) > 0) point.curvature = hull(point.curvature, 0.0);
  if (left) {
    point.x = -point.x;
    point.angle = Bounded(2) * pi - point.angle;
  }
  return point;
}

}  // namespace plumbline::reference
