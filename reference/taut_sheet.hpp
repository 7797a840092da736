#pragma once
// A circular sheet, axisymmetric and taut, under pressure on its deformed surface: integrated from its middle outwards
// for a given strain there. Lengths in units of the radius at rest, stresses in units of E, load q = p a/(E t). At the
// distance s from the middle at rest the sheet is at the radius r(s) and the drop y(s) below its middle:
//   hoop    l2 = r/s,  e2 = (l2^2 - 1)/2,      meridian  l1^2 = r'^2 + y'^2,  e1 = (l1^2 - 1)/2,
//   plane stress of St. Venant and Kirchhoff:  S1 = (e1 + nu e2)/(1 - nu^2),  S2 = e2 + nu S1,
//   force along the axis on the part within s:       s S1 y' = q r^2/2,
//   force along the meridian (pressure has none):    (s S1 l1)' = S2 l2 r'/l1. [Surface 10]
// In the unknowns e2, S1 and ln s, with e1 - e2 = (1 + nu) ((1 - nu) S1 - e2) and
//   d = r' - l2 = (2 (e1 - e2) - y'^2)/(r' + l2),
//   s e2' = l2 d,  s S1' (l1^2 + (1 - nu^2) S1) = nu S1 l2 d - S2 (r' d + y'^2) - l1^2 (e1 - e2)/(1 + nu),
// regular at the middle, and small strains lose no digits. Steps of equal length in ln s of the method of eighth order
// rk8pd of GSL start where the parabola about the middle is exact to rounding.
#include <array>
#include <vector>

namespace plumbline::reference {

struct SheetSettings {
  double load = 0;           // q
  double poisson_ratio = 0;  // nu
  int steps = 0;             // per unit of ln s
};

class TautSheet {
 public:
  /// The state is e2, S1, the drop below the middle, and the volume below the middle within the radius: int pi r^2 dy.
  using State = std::array<double, 4>;
  struct Point {
    double radius;                        // r
    double hoop, meridian;                // S2, S1
    double hoop_strain, meridian_strain;  // e2, e1
    double drop, volume;
  };

  /// From the middle to the rim, s = 1, or as far as r' > 0 or, if `wrinkles`, S2 >= 0 goes.
  TautSheet(const SheetSettings& settings, double middle_strain, bool wrinkles);

  bool reaches_rim() const { return end_ == End::rim; }
  bool is_wrinkled() const { return end_ == End::wrinkled; }
  double end() const { return last_; }  // s where it ends
  int steps() const { return static_cast<int>(path_.size()); }
  /// 0 <= s <= end().
  Point at(double s) const;

 private:
  enum class End { rim, wrinkled, turned };

  State near_middle(double s) const;
  bool step(State& state, double from, double length) const;
  double slack(const State& state) const;
  void end_within(double from, double length, bool wrinkles);

  SheetSettings settings_;
  double strain_, start_ = 0, last_ = 0;            // s
  double stress_, bend_, hoop_rise_, stress_rise_;  // S1, y'^2/s^2 at the middle; growth of e2 and S1 with s^2
  End end_ = End::rim;
  std::vector<State> path_;  // at ln start_ + k/steps
};

}  // namespace plumbline::reference
