#include "reference/elastic_plastic_impact.hpp"

#include <algorithm>

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

void check_problem(const ElasticPlasticImpactProblem& problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poissons_ratio", 0, -1, 0.5, true, true, "1", ""}, problem.poissons_ratio);
  check_positive("density", problem.density);
  check_positive("yield_stress", problem.yield_stress);
  check_not_negative("hardening_modulus", problem.hardening_modulus);
  check_positive("velocity", problem.velocity);
  check_not_negative("rise_time", problem.rise_time);
}

/// x between low and high; no further off than the most unsure of the three.
Bounded clamped(Bounded x, Bounded low, Bounded high) {
  if (highest(x) <= lowest(low)) return low;
  if (lowest(x) >= highest(high)) return high;
  return {std::max(low.value, std::min(x.value, high.value)), std::max({x.bound, low.bound, high.bound})};
}

void check_argument(const char* key, Bounded x) {
  check_finite(key, x.value);
  if (highest(x) < 0) throw ParameterError(key, x.value, "[0, inf)");
}

}  // namespace

ElasticPlasticImpact::ElasticPlasticImpact(const ElasticPlasticImpactProblem& problem) : problem_(problem) {
  check_problem(problem);
  const Bounded e(problem.youngs_modulus), nu(problem.poissons_ratio), rho(problem.density), one(1.0);
  const Bounded y(problem.yield_stress), h(problem.hardening_modulus), v(problem.velocity),
      four_thirds = Bounded(4.0) / 3.0;
  shear_ = e / (Bounded(2.0) * (one + nu));
  const Bounded bulk = e / (Bounded(3.0) * (one - Bounded(2.0) * nu)), modulus = bulk + four_thirds * shear_;
  const Bounded sum = Bounded(3.0) * shear_ + h;
  elastic_speed_ = sqrt(modulus / rho);
  plastic_speed_ = sqrt((bulk + four_thirds * shear_ * h / sum) / rho);
  limit_ = y * modulus / (Bounded(2.0) * shear_);
  limit_velocity_ = limit_ / (rho * elastic_speed_);
  flow_ = Bounded(2.0) * shear_ / sum;
  elastic_part_ = clamped(v, 0.0, limit_velocity_);
  plastic_part_ = clamped(v - limit_velocity_, 0.0, v);
}

ElasticPlasticState ElasticPlasticImpact::of_parts(Bounded elastic, Bounded plastic) const {
  const Bounded rho(problem_.density), alpha = flow_ * plastic / plastic_speed_;
  const Bounded stress = -(rho * (elastic_speed_ * elastic + plastic_speed_ * plastic));
  // The lateral stress is higher by 2 G e up to yield, which is Y there, and by Y + H alpha beyond.
  const Bounded shear = Bounded(2.0) * shear_ * elastic / elastic_speed_ + Bounded(problem_.hardening_modulus) * alpha;
  return {elastic + plastic, stress, stress + shear, alpha};
}

ElasticPlasticState ElasticPlasticImpact::precursor() const { return of_parts(elastic_part_, 0.0); }
ElasticPlasticState ElasticPlasticImpact::plateau() const { return of_parts(elastic_part_, plastic_part_); }

Bounded ElasticPlasticImpact::strain() const { return elastic_part_ / elastic_speed_ + plastic_part_ / plastic_speed_; }

Bounded ElasticPlasticImpact::driven(Bounded time) const {
  const Bounded v(problem_.velocity);
  if (problem_.rise_time > 0) return clamped(v * time / problem_.rise_time, 0.0, v);
  if (highest(time) <= 0) return 0.0;
  if (lowest(time) > 0) return v;
  return {time.value > 0 ? v.value : 0, v.value};
}

ElasticPlasticState ElasticPlasticImpact::state(Bounded position, Bounded time) const {
  check_argument("position", position);
  check_argument("time", time);
  const Bounded first = driven(time - position / elastic_speed_), second = driven(time - position / plastic_speed_);
  return of_parts(clamped(first, 0.0, elastic_part_), clamped(second - limit_velocity_, 0.0, plastic_part_));
}

// The plastic strain of all particles is the integral of flow v_p/c_p over x, and so of flow V_p over the time.
Bounded ElasticPlasticImpact::heat(Bounded time) const {
  check_argument("time", time);
  if (plastic_part_.value == 0) return 0.0;
  const Bounded rise(problem_.rise_time), v(problem_.velocity);
  const Bounded yields = rise * elastic_part_ / v;  // when the piston has the velocity of the limit
  const Bounded growing = clamped(time, yields, rise) - yields, beyond = clamped(time - rise, 0.0, time);
  const Bounded half = problem_.rise_time > 0 ? v * growing * growing / (Bounded(2.0) * rise) : Bounded(0.0);
  return Bounded(problem_.yield_stress) * flow_ * (half + plastic_part_ * beyond);
}

}  // namespace plumbline::reference
