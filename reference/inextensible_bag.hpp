#pragma once
// Shapes of an axisymmetric bag that holds gas between a flat plate and a flat round probe. Its skin does not stretch
// along the meridian and wrinkles freely around the hoop; nothing rubs. W. H. Paulsen (Amer. Math. Monthly 101 (1994)
// 953) and I. M. Mladenov, J. Oprea (Amer. Math. Monthly 110 (2003) 761) have the free bag, the "Mylar balloon".
//
// Without hoop stress, r times the meridional tension is a constant; call it q l^2/2, q the pressure difference. The
// bag leaves the plate at the radius b along it. With t the angle of the tangent from the outward radius:
//   sin t = (r^2 - b^2)/l^2,   ds = l^2 dt/(2 r),   equator R^2 = b^2 + l^2.
// At the probe of radius r_p it either leaves along the face at r = b < r_p, by symmetry, or, b > r_p, it bulges around
// the probe and meets the edge of the face at t = pi + a, sin a = (b^2 - r_p^2)/l^2. Both ends reach t = pi/2 - 2 psi
// with sin^2 psi = (1 + sin a)/2 (a = 0 at the plate). With m = 2 l^2/R^2 and sums of F(psi, m) and D(psi, m) over
// them,
//   meridian S = b + min(b, r_p) + (l^2/R) sum F,   gap H = (l^2/R) sum (F - 2 D),
//   volume V = pi/3 (l^2 (S - r_p (1 - cos a)) + b^2 H).
// These are equilibria, so V is stationary, and largest, among all shapes of that meridian and gap, and
//   dV = pi b^2 dH + pi l^2 dS:
// the plate and the probe are pressed with q pi b^2. A shape that misses S and H by little therefore has V right but
// for a known and small amount: that is how the bound of V is made.
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Lengths in the unit of the meridian.
struct BagShape {
  Bounded height;        // H
  Bounded volume;        // V
  Bounded pressed_area;  // pi b^2 = dV/dH: force over pressure difference
  Bounded plate_radius;  // b
  Bounded probe_radius;  // at which the bag leaves the probe: min(b, r_p)
  Bounded equator;       // R, the largest radius
  Bounded tension;       // l^2/2: meridional tension times radius, over pressure difference
  Bounded edge_angle;    // a, 0 where the bag leaves the face along it
};

class InextensibleBag {
 public:
  /// `meridian` S from pole to pole and radius of the probe, both > 0. Throws ParameterError with the key `meridian` or
  /// `probe_radius`.
  InextensibleBag(double meridian, double probe_radius);

  double meridian() const { return meridian_; }
  double probe_radius() const { return probe_radius_; }
  /// Untouched: height, volume and radius.
  Bounded free_height() const { return free_height_; }
  Bounded free_volume() const;
  Bounded free_radius() const { return free_radius_; }
  /// Below it the bag closes around the side of the probe (a = 90 degrees) or is nearly flat: no answer here.
  double least_height() const;
  /// Gap at which the bag, pressed, reaches the edge of the probe; least_height() if it never does.
  double edge_height() const { return edge_height_; }
  /// least_height() <= height <= free_height(). Throws ParameterError with key `height`.
  BagShape at(Bounded height) const;

 private:
  struct Member {
    double square, length;  // b^2 and l
  };
  struct Measures;
  Measures measure(Member member) const;
  Member member(double radius) const;
  Member guess(double height) const;
  double least_length(double radius) const;
  double greatest_radius() const;
  void tabulate();

  double meridian_, probe_radius_, edge_height_ = 0;
  Bounded free_height_, free_radius_;
  std::vector<Member> members_;
  std::vector<double> heights_;  // of the members, falling
};

}  // namespace plumbline::reference
