#pragma once
// The strain in the middle for which a circular sheet is as it must be at its rim, and what halving the step changes.
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "reference/argument.hpp"
#include "reference/circular_membrane.hpp"
#include "reference/parameter.hpp"
#include "reference/root.hpp"
#include "reference/taut_sheet.hpp"

namespace plumbline::reference {

/// A shot is made of SheetSettings and the strain in the middle. Its excess(), of the order of 1, rises through 0 with
/// that strain, if it does not jump, which `refusal` explains; numbers() begins with height and stress of the middle and
/// then has whatever else must stay; at(s) has the members of MembranePoint. Units of taut_sheet.hpp.
template <class Shot>
class Shooting {
 public:
  /// Throws ParameterError "load" where no strain meets the rim's condition.
  Shooting(double load, double poisson_ratio) {
    constexpr int most_steps = 128;
    SheetSettings settings{load, poisson_ratio, 8};
    double strain = 0.3 * std::cbrt(load * load);
    coarse_ = aimed(settings, strain);
    for (settings.steps = 16;; settings.steps *= 2) {
      fine_ = aimed(settings, strain);
      bool stays = true;
      const std::vector<double> before = coarse_->numbers(), now = fine_->numbers();
      numbers_.resize(now.size());
      for (std::size_t i = 0; i < now.size(); ++i) {
        const Bounded x = bounded(before[i], now[i], now[i]);
        numbers_[i] = x;
        stays = stays && x.bound <= 2 * rounding_share() * x.value;
      }
      if (stays || settings.steps == most_steps) return;
      coarse_ = fine_;
    }
  }

  Bounded number(std::size_t i) const { return numbers_[i]; }

  MembranePoint at(double s, double radius) const {
    check_within("position", s, 0, radius);
    const std::array<double, 5> before = coarse_->at(s / radius), now = fine_->at(s / radius);
    const double height = numbers_[0].value, stress = numbers_[1].value;
    return {Bounded(radius) * bounded(before[0], now[0], 1), Bounded(radius) * bounded(before[1], now[1], height),
            bounded(before[2], now[2], stress), bounded(before[3], now[3], stress), bounded(before[4], now[4], 1)};
  }

 private:
  double rounding_share() const { return 4 * rounding::unit * (fine_->sheet.steps() + 16); }
  Bounded bounded(double before, double now, double scale) const {
    return {now, 2 * std::abs(now - before) + rounding_share() * scale};
  }

  /// The strain is where the search begins, and is changed to what is found.
  static std::shared_ptr<const Shot> aimed(const SheetSettings& settings, double& strain) {
    auto excess = [&settings](double at) { return Shot(settings, at).excess(); };
    double low = strain, high = strain;
    constexpr int most_tries = 60;
    for (int i = 0; i < most_tries && !(excess(low) < 0); ++i) low /= 1.5;
    for (int i = 0; i < most_tries && !(excess(high) > 0); ++i) high *= 1.5;
    strain = brent_root(excess, low, high);
    auto shot = std::make_shared<const Shot>(settings, strain);
    constexpr double jump = 1e-10;  // roots are met to rounding
    if (!(std::abs(shot->excess()) < jump)) throw ParameterError("load", settings.load, Shot::refusal);
    return shot;
  }

  std::shared_ptr<const Shot> coarse_, fine_;
  std::vector<Bounded> numbers_;
};

}  // namespace plumbline::reference
