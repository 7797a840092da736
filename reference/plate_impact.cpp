#include "reference/plate_impact.hpp"

#include "reference/argument.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

void check_problem(const PlateImpactProblem& problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poissons_ratio", 0, -1, 0.5, true, true, "1", ""}, problem.poissons_ratio);
  check_positive("density", problem.density);
  check_positive("yield_stress", problem.yield_stress);
  check_not_negative("hardening_modulus", problem.hardening_modulus);
  check_positive("velocity", problem.velocity);
}

constexpr double most_strain = 1;  // e of the strongest impact that is looked for
const PlateState undeformed{1.0, 0.0, 0.0, 0.0, 0.0, 0.0};

void check_argument(const char* key, Bounded x) {
  check_finite(key, x.value);
  if (highest(x) < 0) throw ParameterError(key, x.value, "[0, inf)");
}

// The one behind a shock at `front`, or that ahead of it.
PlateState beside(Bounded place, Bounded front, const PlateState& behind, const PlateState& ahead) {
  if (certainly_below(place, front)) return behind;
  if (certainly_below(front, place) || highest(front) <= 0) return ahead;
  const PlateState &near = place.value < front.value ? behind : ahead,
                   &far = place.value < front.value ? ahead : behind;
  return {hull(near.stretch, far.stretch),
          hull(near.stress, far.stress),
          hull(near.lateral_stress, far.lateral_stress),
          hull(near.plastic_strain, far.plastic_strain),
          hull(near.velocity, far.velocity),
          hull(near.speed, far.speed)};
}

}  // namespace

PlateImpact::PlateImpact(const PlateImpactProblem& problem) : problem_(problem) {
  check_problem(problem);
  const Bounded e(problem.youngs_modulus), nu(problem.poissons_ratio), one(1.0), two(2.0);
  shear_ = e / (two * (one + nu));
  bulk_ = e / (Bounded(3.0) * (one - two * nu));
  limit_ = Bounded(problem.yield_stress) / (two * shear_);
  const PlateState yields = struck(undeformed, limit_);
  if (!certainly_below(yields.velocity, problem.velocity)) {
    precursor_ = plateau_ = behind(undeformed, 0, problem.velocity);
    return;
  }
  precursor_ = yields;
  plateau_ = behind(yields, limit_.value, problem.velocity);
  if (!certainly_below(plateau_.speed, precursor_.speed))
    throw ParameterError("velocity", problem.velocity, "so low that the plastic shock is slower than the elastic one");
}

Bounded PlateImpact::pressure(Bounded strain) const {
  const Bounded trial = Bounded(2.0) * shear_ * strain, y(problem_.yield_stress), h(problem_.hardening_modulus);
  Bounded q = trial;
  if (strain.value > limit_.value) q = y + h * (trial - y) / (Bounded(3.0) * shear_ + h);
  return (expm1(strain) + 1.0) * (bulk_ * strain + Bounded(2.0) / 3.0 * q);  // [Hencky 1]
}

Bounded PlateImpact::square(const PlateState& ahead, Bounded strain) const {
  const Bounded shorter = ahead.stretch - 1.0 - expm1(-strain);
  return (pressure(strain) + ahead.stress) * shorter / Bounded(problem_.density);  // [Hencky 2]
}

PlateState PlateImpact::struck(const PlateState& ahead, Bounded strain) const {
  const Bounded y(problem_.yield_stress), h(problem_.hardening_modulus), trial = Bounded(2.0) * shear_ * strain;
  PlateState s;
  s.stretch = expm1(-strain) + 1.0;
  s.stress = -pressure(strain);
  const bool yielded = strain.value > limit_.value;
  s.plastic_strain = yielded ? (trial - y) / (Bounded(3.0) * shear_ + h) : Bounded(0.0);
  const Bounded q = yielded ? y + h * s.plastic_strain : trial;
  s.lateral_stress = s.stress + q / s.stretch;
  const Bounded jump = sqrt(square(ahead, strain));
  s.velocity = ahead.velocity + jump;
  s.speed = (ahead.stress - s.stress) / (Bounded(problem_.density) * jump);  // [Hencky 2]
  return s;
}

PlateState PlateImpact::state(Bounded place, Bounded time) const {
  check_argument("place", place);
  check_argument("time", time);
  const PlateState ahead = beside(place, elastic_speed() * time, precursor_, undeformed);
  return beside(place, plastic_speed() * time, plateau_, ahead);
}

// The square grows with the strain.
PlateState PlateImpact::behind(const PlateState& ahead, double low, double loss) const {
  const Bounded jump = Bounded(loss) - ahead.velocity, wanted = jump * jump;
  const auto f = [&](double strain) { return square(ahead, strain) - wanted; };
  if (!(f(most_strain).value > 0))
    throw ParameterError("velocity", loss, "so low that the plate keeps e^-1 of its thickness");
  const double guess = brent_root([&](double strain) { return f(strain).value; }, low, most_strain);
  const double step = 1e-6 * guess, slope = (f(guess + step).value - f(guess - step).value) / (2 * step);
  return struck(ahead, enclose_root(f, guess, slope, low, most_strain));
}

}  // namespace plumbline::reference
