#pragma once
// A heavy chain between two supports of the same height: the catenary, and the elastic catenary (H. M. Irvine, Cable
// Structures, 1981, chapter 1). With w the weight per unstretched length, q the distance along the unstretched chain
// from its middle, H = w a the horizontal force:
//   tension   T = w sqrt(a^2 + q^2),
//   place     x = a asinh(q/a) + H q/(E A),   y = sqrt(a^2 + q^2) - a + w q^2/(2 E A)   (from the lowest point),
//   supports  2 a asinh(L/(2 a)) + H L/(E A) = d.
// The inextensible chain has 1/(E A) = 0, where the last line is 2 a sinh(d/(2 a)) = L.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units.
struct CatenaryProblem {
  double span = 1;        // distance d of the supports, > 0
  double length = 1.2;    // L, unstretched, > 0; an inextensible chain needs L > d
  double weight = 1;      // w > 0, force per unstretched length
  double compliance = 0;  // 1/(E A) >= 0; 0: inextensible
};

/// `along` is the distance from the left support along the unstretched chain, 0 <= along <= L.
class Catenary {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit Catenary(const CatenaryProblem& problem);

  const CatenaryProblem& problem() const { return problem_; }
  Bounded parameter() const { return a_; }  // a = H/w
  Bounded sag() const;                      // depth of the lowest point below the supports
  Bounded horizontal_force() const;
  Bounded support_tension() const;
  Bounded stretched_length() const;
  Bounded x(double along) const;  // from the left support
  Bounded y(double along) const;  // from the height of the supports: <= 0
  Bounded tension(double along) const;
  Bounded slope_angle(double along) const;  // atan(dy/dx)

 private:
  Bounded from_middle(double along) const;

  CatenaryProblem problem_;
  Bounded a_;
};

}  // namespace plumbline::reference
