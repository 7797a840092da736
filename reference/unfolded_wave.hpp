#pragma once
// A wave that travels to the right in a bar [0, L] with reflecting ends, unfolded to the left: what arrives at a place
// started there, or beyond the left end as the opposite wave in the mirror image of the bar, or beyond that again as
// the same wave, and so on with the period 2 L.
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Values from `from` to the next step, or L.
struct WaveStep {
  Bounded from;
  Bounded here, opposite;  // of the wave that goes right, and of the one that goes left
};

class UnfoldedWave {
 public:
  UnfoldedWave() = default;
  /// The steps in order, the first from 0. The ends reflect a wave times `left_sign`, `right_sign` (+1 or -1).
  UnfoldedWave(std::vector<WaveStep> steps, Bounded length, double left_sign, double right_sign);

  /// The wave that started at `place` <= L. Where the bound reaches over steps, the bounds cover all of them.
  Bounded value(Bounded place) const;
  /// The integral from 0 to `place` <= L.
  Bounded integral(Bounded place) const;

 private:
  struct Folded {
    Bounded place;  // within [-L, L]
    double turns;   // by 2 L
  };
  Folded fold(Bounded place) const;
  Bounded within(Bounded place, double turns) const;
  Bounded sum(Bounded place, bool opposite) const;  // integral from 0 to a place inside the bar
  double sign(double turns) const;

  struct Integrals {
    Bounded here, opposite;
  };

  std::vector<WaveStep> steps_;
  std::vector<Integrals> before_;  // over all steps before each
  Bounded two_bars_;               // the integral over [-2 L, 0]
  Bounded length_;
  double left_ = 1, right_ = 1;
  double largest_ = 0;
};

}  // namespace plumbline::reference
