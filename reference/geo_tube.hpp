#pragma once
// A closed membrane tube, filled with liquid and laid on a flat floor without friction: plane, weightless membrane
// (R. H. Plaut, S. Suherman, Acta Mech. 129 (1998) 207; D. Leshchinsky et al., J. Geotech. Eng. 122 (1996) 682). It is
// the elastica, since pressure grows linearly with depth. T is the tension (the same everywhere: the pressure is normal
// to the membrane), w the weight of liquid per volume, p0 the pressure at the floor, p1 = p0 - w H that at the top,
// theta the angle of the tangent, 0 where the membrane leaves the floor and pi at the top:
//   T dtheta/ds = p,   p = p0 - w y,   T (1 - cos theta) = p0 y - w y^2/2,   2 T = p1 H + w H^2/2.
// With k^2 = 4 w T/p0^2, k' = p1/p0, phi = theta/2, l = T/p0, Delta^2 = 1 - k^2 sin^2 phi:
//   p = p0 Delta,   s - b/2 = 2 l F(phi),   x = s - 4 l D(phi),   y = 4 l sin^2 phi/(1 + Delta),
//   contact b = 4 l (2 D - K),   whole length L = 8 l D,   area = p0 b/w (the floor carries the liquid).
// With v = (k/k')^2 the length asks for A(v) = (K - E)/k' = w L/(2 p1), and T = p1^2 v/(4 w). A(0) = 0, dA/dv = K k'/2:
// A rises and is concave, and has one root if the length is given. An elastic membrane has L = L0 (1 + c T): then
// A(v) - (c p1 L0/8) v = w L0/(2 p1), whose lower root is the stable one; if there is none, the tube gives way.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// SI units, per unit depth.
struct GeoTubeProblem {
  double perimeter = 4;           // m, of the unstretched membrane, > 0
  double specific_weight = 9810;  // N/m^3, density times gravity, >= 0; 0: gas, a circle
  double top_pressure = 2000;     // Pa, over the pressure outside, > 0 (at 0 the tube lies flat)
  double compliance = 0;          // m/N, 1/(E' t): strain per tension; 0: inextensible
};

/// A place on the membrane. Origin on the floor below the top; x to the right, y up.
struct GeoTubePoint {
  Bounded x, y;
  Bounded angle;      // of the tangent, from 0 on the floor over pi at the top to 2 pi
  Bounded curvature;  // 1/m, 0 on the floor
  Bounded pressure;   // of the liquid
};

class GeoTube {
 public:
  /// Throws ParameterError with the key of a value out of range, with "compliance" if there is no equilibrium.
  explicit GeoTube(const GeoTubeProblem& problem = {});

  const GeoTubeProblem& problem() const { return problem_; }
  Bounded height() const;
  Bounded width() const;
  Bounded contact_width() const;
  Bounded tension() const;  // N/m
  Bounded strain() const;   // of the membrane
  Bounded area() const;     // of the section: volume of liquid per depth
  Bounded bottom_pressure() const;
  /// `along`: distance from the middle of the floor along the unstretched membrane, counter-clockwise, from 0 to the
  /// perimeter. Where the bound of the place covers the end of contact, that of the curvature covers its jump.
  GeoTubePoint at(double along) const;

 private:
  Bounded half_angle(Bounded u) const;
  GeoTubePoint free_point(Bounded s, Bounded u) const;

  GeoTubeProblem problem_;
  Bounded square_ = 0, complement_ = 1;  // k^2, k'
  Bounded K_, D_, C_;
  Bounded length_;  // l
};

}  // namespace plumbline::reference
