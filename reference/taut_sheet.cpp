#include "reference/taut_sheet.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>

#include "reference/circle.hpp"
#include "reference/gsl_owned.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

/// Share by which strain and stress grow up to where the integration starts. Its square is left out: rounding.
constexpr double first_growth = 1e-8;

struct Shape {
  double hoop_stretch, meridian_strain, difference, slope_square, drop_square;  // l2, e1, e1 - e2, r'^2, y'^2
};

Shape shape_at(const SheetSettings& p, const double* y, double s) {
  const double nu = p.poisson_ratio, e2 = y[0], S1 = y[1];
  Shape a;
  a.hoop_stretch = std::sqrt(1 + 2 * e2);
  a.meridian_strain = (1 - nu * nu) * S1 - nu * e2;
  a.difference = (1 + nu) * ((1 - nu) * S1 - e2);
  const double drop_slope = p.load * (1 + 2 * e2) * s / (2 * S1);  // [Surface 10]
  a.drop_square = drop_slope * drop_slope;
  a.slope_square = 1 + 2 * a.meridian_strain - a.drop_square;
  return a;
}

int sheet_rates(double log_s, const double* y, double* rate, void* settings) {
  const auto& p = *static_cast<const SheetSettings*>(settings);
  const double nu = p.poisson_ratio, s = std::exp(log_s), e2 = y[0], S1 = y[1], S2 = e2 + nu * S1;
  if (!(S1 > 0) || !(1 + 2 * e2 > 0)) return GSL_EBADFUNC;
  const Shape a = shape_at(p, y, s);
  if (!(a.slope_square >= 0)) return GSL_EBADFUNC;
  const double l2 = a.hoop_stretch, square = 1 + 2 * a.meridian_strain, slope = std::sqrt(a.slope_square);
  const double d = (2 * a.difference - a.drop_square) / (slope + l2);
  rate[0] = l2 * d;
  rate[1] = (nu * S1 * l2 * d - S2 * (slope * d + a.drop_square) - square * a.difference / (1 + nu)) /
            (square + (1 - nu * nu) * S1);  // [Surface 10]
  rate[2] = s * std::sqrt(a.drop_square);
  rate[3] = pi.value * l2 * l2 * s * s * rate[2];
  return GSL_SUCCESS;
}

}  // namespace

// About the middle l2 = l + b s^2 and r' = l + 3 b s^2, where the force along the radius, (s S1 r')' = S2 l2 - q r y',
// gives 8 b (S + l^2/(1 - nu^2)) = -q^2 l^3/(2 S) - l (3 - nu) (y'/s)^2/(2 (1 - nu^2)).
TautSheet::TautSheet(const SheetSettings& settings, double middle_strain, bool wrinkles)
    : settings_(settings),
      strain_(middle_strain) {
  const double nu = settings.poisson_ratio, plane = 1 - nu * nu, l = std::sqrt(1 + 2 * strain_), q = settings.load;
  stress_ = strain_ / (1 - nu);
  bend_ = std::pow(q * l * l / (2 * stress_), 2);
  const double pull = q * q * l * l * l / (2 * stress_) + l * (3 - nu) * bend_ / (2 * plane);
  hoop_rise_ = -l * pull / (8 * (stress_ + l * l / plane));
  stress_rise_ = ((3 + nu) * hoop_rise_ + bend_ / 2) / plane;
  const double growth = std::max({std::abs(hoop_rise_) / strain_, std::abs(stress_rise_) / stress_, bend_});
  start_ = std::min(0.01, std::sqrt(first_growth / growth));

  const double length = 1.0 / settings.steps, all = -std::log(start_);
  State state = near_middle(start_);
  path_.push_back(state);
  for (int k = 0; k * length < all; ++k) {
    const double from = k * length - all, part = std::min(length, -from);
    const bool whole = step(state, from, part);
    if (!whole || (wrinkles && slack(state) >= 0)) {
      end_within(from, part, wrinkles);
      return;
    }
    path_.push_back(state);
  }
  last_ = 1;
}

/// -S2.
double TautSheet::slack(const State& state) const { return -(state[0] + settings_.poisson_ratio * state[1]); }

/// Within the step after the last state of the path: where S2 changes its sign, or the sheet turns back. A whole step
/// may reach beyond both.
void TautSheet::end_within(double from, double length, bool wrinkles) {
  constexpr int most_halvings = 50;
  enum class Reached { taut, slack, turned };
  auto reached = [&](double part) {
    State state = path_.back();
    if (!step(state, from, part)) return Reached::turned;
    return wrinkles && slack(state) >= 0 ? Reached::slack : Reached::taut;
  };
  auto slack_after = [&](double part) {
    State state = path_.back();
    step(state, from, part);
    return slack(state);
  };
  double low = 0, high = length;
  for (int i = 0; i < most_halvings && reached(high) == Reached::turned; ++i) {
    const double middle = 0.5 * (low + high);
    (reached(middle) == Reached::taut ? low : high) = middle;
  }
  const bool found = reached(high) == Reached::slack && slack_after(high) > 0;
  end_ = found ? End::wrinkled : End::turned;
  last_ = std::exp(from + (found ? brent_root(slack_after, low, high) : low));
}

TautSheet::State TautSheet::near_middle(double s) const {
  const double x = s * s, area = 1 + 2 * strain_, drop = settings_.load * area * x / (4 * stress_);
  return {strain_ + hoop_rise_ * x, stress_ + stress_rise_ * x, drop, pi.value * area * x * drop / 2};
}

/// Advances the state from ln s = `from`; false where the sheet turns back towards the axis.
bool TautSheet::step(State& state, double from, double length) const {
  if (length == 0) return true;
  SheetSettings settings = settings_;
  gsl_odeiv2_system system{sheet_rates, nullptr, 4, &settings};
  const Owned<gsl_odeiv2_step> stepper(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 4));
  State error{};
  return gsl_odeiv2_step_apply(stepper.get(), from, length, state.data(), error.data(), nullptr, nullptr, &system) ==
         GSL_SUCCESS;
}

TautSheet::Point TautSheet::at(double s) const {
  State state = near_middle(std::min(s, start_));
  if (s > start_) {
    const double steps = settings_.steps, passed = std::log(s / start_);
    const double k = std::min(std::floor(passed * steps), static_cast<double>(path_.size() - 1));
    state = path_[static_cast<std::size_t>(k)];
    step(state, std::log(start_) + k / steps, std::max(0.0, passed - k / steps));
  }
  const Shape a = shape_at(settings_, state.data(), s);
  return {s * a.hoop_stretch,
          state[0] + settings_.poisson_ratio * state[1],
          state[1],
          state[0],
          a.meridian_strain,
          state[2],
          state[3]};
}

}  // namespace plumbline::reference
