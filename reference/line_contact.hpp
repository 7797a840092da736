#pragma once
// An elastic cylinder pressed by a force P per length on a flat of the same material, plane strain: how wide they touch, how
// deep it sits, and how much it creeps where it rolls and is pulled by a force F along the flat. K. L. Johnson, Contact
// Mechanics, 1985, with E* = E/(2 (1 - nu^2)):
//   a^2 = 4 P R/(pi E*)                                                                                    [Johnson 4.2]
//   of the cylinder's centre P (1 - nu^2)/(pi E) (2 ln(4 R/a) - 1), of a layer of depth d on rigid ground
//   P (1 - nu^2)/(pi E) (2 ln(2 d/a) - nu/(1 - nu))                                                        [Johnson 5.6]
//   creep, by which v exceeds w R: mu a/R (1 - sqrt(1 - F/(mu P))), F. W. Carter 1926                      [Johnson 8.3]
// All hold for a much smaller than R and d; what they leave out is of the order (a/R)^2.

namespace plumbline::reference {

/// All positive, poisson in (-1, 1/2); force in N/m, lengths in m.
struct LineContact {
  double radius = 1;
  double youngs_modulus = 1;
  double poisson = 0.3;
  double force = 1;

  double half_width() const;
  /// How far the centre comes nearer to the ground under a layer of this depth, m.
  double approach(double depth) const;
  /// friction mu > 0; pull F in [0, mu P]: all slips at the upper end.
  double creep(double friction, double pull) const;
};

}  // namespace plumbline::reference
