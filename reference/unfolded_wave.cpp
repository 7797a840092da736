#include "reference/unfolded_wave.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace plumbline::reference {

UnfoldedWave::UnfoldedWave(std::vector<WaveStep> steps, Bounded length, double left_sign, double right_sign)
    : steps_(std::move(steps)),
      length_(length),
      left_(left_sign),
      right_(right_sign) {
  Bounded here = 0.0, opposite = 0.0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    before_.push_back({here, opposite});
    if (i + 1 == steps_.size()) break;
    const Bounded width = steps_[i + 1].from - steps_[i].from;
    here = here + width * steps_[i].here;
    opposite = opposite + width * steps_[i].opposite;
  }
  two_bars_ = Bounded(left_) * sum(length_, true) + Bounded(left_ * right_) * sum(length_, false);
  for (const WaveStep& step : steps_) {
    largest_ = std::max(
        {largest_, std::abs(step.here.value) + step.here.bound, std::abs(step.opposite.value) + step.opposite.bound});
  }
}

UnfoldedWave::Folded UnfoldedWave::fold(Bounded place) const {
  const double turns = std::max(0.0, std::floor((length_.value - place.value) / (2 * length_.value)));
  return {turns == 0 ? place : place + Bounded(2 * turns) * length_, turns};
}

double UnfoldedWave::sign(double turns) const { return std::fmod(turns, 2) == 0 ? 1 : left_ * right_; }

/// The hull of all steps that the place may lie in, on either side of the left end.
Bounded UnfoldedWave::within(Bounded place, double turns) const {
  std::optional<Bounded> answer;
  auto add = [&](Bounded value, bool middle) {
    if (!answer) {
      answer = value;
    } else {
      answer = middle ? hull(value, *answer) : hull(*answer, value);
    }
  };
  auto add_side = [&](Bounded at, double factor, bool opposite) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const bool last = i + 1 == steps_.size();
      const double low = i == 0 ? -rounding::infinity : steps_[i].from.value;
      const double high = last ? rounding::infinity : steps_[i + 1].from.value;
      const double before = i == 0 ? 0 : steps_[i].from.bound, after = last ? 0 : steps_[i + 1].from.bound;
      if (highest(at) < low - before || lowest(at) > high + after) continue;
      const Bounded value = opposite ? steps_[i].opposite : steps_[i].here;
      add(Bounded(factor * value.value, value.bound), at.value >= std::max(low, 0.0) && at.value < high);
    }
  };
  if (highest(place) >= 0) add_side(place, sign(turns), false);
  if (lowest(place) <= 0) add_side(-place, sign(turns) * left_, true);
  return *answer;
}

Bounded UnfoldedWave::value(Bounded place) const {
  const Folded folded = fold(place);
  Bounded answer = within(folded.place, folded.turns);
  const Bounded full = Bounded(2) * length_;
  if (folded.turns > 0 && highest(folded.place) >= lowest(length_)) {
    answer = hull(answer, within(folded.place - full, folded.turns - 1));
  }
  if (lowest(folded.place) <= -lowest(length_)) answer = hull(answer, within(folded.place + full, folded.turns + 1));
  return answer;
}

Bounded UnfoldedWave::sum(Bounded place, bool opposite) const {
  const auto beyond = std::find_if(steps_.begin() + 1, steps_.end(),
                                   [&](const WaveStep& step) { return place.value <= step.from.value; });
  const std::size_t i = static_cast<std::size_t>(beyond - steps_.begin()) - 1;
  const Bounded width = place - steps_[i].from;
  return (opposite ? before_[i].opposite : before_[i].here) + width * (opposite ? steps_[i].opposite : steps_[i].here);
}

// With D the integral over the two bars [-2 L, 0] and s the product of the signs,
// I(y - 2 L n) = s^n I(y) - D (1 + s + ... + s^(n - 1)). The integral changes by at most the largest value per length.
Bounded UnfoldedWave::integral(Bounded place) const {
  const auto [folded, turns] = fold(place);
  const Bounded at(folded.value);
  const Bounded near = at.value >= 0 ? sum(at, false) : Bounded(-left_) * sum(-at, true);
  const double count = left_ * right_ > 0 ? turns : std::fmod(turns, 2);
  Bounded answer = Bounded(sign(turns)) * near - Bounded(count) * two_bars_;
  answer.bound = (answer.bound + largest_ * folded.bound) * rounding::inflate;
  return answer;
}

}  // namespace plumbline::reference
