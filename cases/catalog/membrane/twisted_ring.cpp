#include "cases/catalog/membrane/twisted_ring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/whole.hpp"
#include "reference/parameter.hpp"

namespace plumbline {
namespace {

// S_ab with the direction of its larger principal stress, in the tangents at rest.
struct Principal {
  double larger, smaller, cosine, sine;
  explicit Principal(const SurfaceLaw::State& s) {
    const double mean = 0.5 * (s.first + s.second), half = 0.5 * (s.first - s.second);
    const double radius = std::hypot(half, s.mixed), angle = 0.5 * std::atan2(s.mixed, half);
    larger = mean + radius;
    smaller = mean - radius;
    cosine = std::cos(angle);
    sine = std::sin(angle);
  }
};

// z of x times the vector first * f_1 + second * f_2.
double moment(const Columns& points, int p, double first, double second) {
  const auto f = [&](int d) {
    return first * points(column::tangents, d)[p] + second * points(column::tangents, 3 + d)[p];
  };
  return points(column::position, 0)[p] * f(1) - points(column::position, 1)[p] * f(0);
}

double length(const Columns& points, int p, double first, double second) {
  const SurfaceLaw::Metric c = metric_of(points, p);
  return std::sqrt(first * first * c.first + 2 * first * second * c.mixed + second * second * c.second);
}

}  // namespace

TwistedAnnulus::TwistedAnnulus(Parameters given) : SurfaceCase(std::move(given)) {
  inner = number({.name = "inner",
                  .value = 0.5,
                  .low = 0.1,
                  .high = 0.9,
                  .description = "radius of the inner rim over that of the outer one"});
  twist = number({.name = "twist",
                  .value = 0.05,
                  .unit = "rad",
                  .low = 1e-6,
                  .high = 1,
                  .description = "of the outer rim against the inner one"});
  choice.law.one_way = method("compression", "none", {"none", "carried"},
                              "none: what is shortened wrinkles; carried: the sheet bears it, as a plate would") ==
                       "none";
  drag = not_negative("drag", 1, "1", "against the velocity, over the speed of waves and the outer radius");
  end = positive("end", 12, "1", "time of the end");
  rows = number({.name = "clamped_rows",
                 .value = 3.0,
                 .low = 0,
                 .high = 10,
                 .description = "so many rings next to a rim have images behind it"});
}

reference::TwistedAnnulus TwistedAnnulus::exact() const {
  const SurfaceLaw& law = choice.law;
  try {
    return reference::TwistedAnnulus(
        {law.youngs_modulus, law.poissons_ratio, law.thickness, inner_radius(), size, twist});
  } catch (const reference::ParameterError& error) {
    const bool far = error.key == "twist";
    const std::string key = far ? "twist" : "poissons_ratio", value = fmt::format("{:g}", error.value);
    throw UsageError(key, value, error.allowed, {},
                     fmt::format("{}={} with inner={:g} twist={:g} is no ring that wrinkles everywhere; allowed: {}",
                                 key, value, inner, twist, error.allowed));
  }
}

TwistedRing::TwistedRing(const TwistedAnnulus& at, double spacings)
    : inner_(at.inner_radius()),
      outer_(at.size),
      twist_(at.twist),
      exact_(at.exact()) {
  const double spacing = outer_ / spacings;
  const int rings = std::max(4, whole(std::round((outer_ - inner_) / spacing)));
  wide_ = (outer_ - inner_) / rings;
  count_ = std::max(12, whole(std::round(std::numbers::pi * (inner_ + outer_) / spacing)));
  for (int k = 0; k < rings; ++k) rings_.push_back(exact_.at(radius(k)));
}

std::vector<SurfacePoint> TwistedRing::points() const {
  std::vector<SurfacePoint> all;
  for (int k = 0; k < static_cast<int>(rings_.size()); ++k) {
    const reference::AnnulusPoint& exact = exact_at(k);
    const double along = exact.along.value, across = exact.across.value, rest = exact.rest.value;
    for (int j = 0; j < count_; ++j) {
      const double angle = 2 * std::numbers::pi * j / count_ + exact.turned.value;
      const double c = std::cos(angle + exact.now.value), s = std::sin(angle + exact.now.value);
      // l m n and l2 times the directions across, of the tangents along the radius at rest and around.
      const auto carried = [&](double n, double other) {
        return Vec3{along * n * c - across * other * s, along * n * s + across * other * c, 0};
      };
      all.push_back({{exact.radius.value * std::cos(angle), exact.radius.value * std::sin(angle), 0},
                     carried(std::cos(rest), -std::sin(rest)),
                     carried(std::sin(rest), std::cos(rest)),
                     2 * std::numbers::pi * radius(k) * wide_ / count_});
    }
  }
  return all;
}

Seat TwistedRing::seat(const Columns& points, int p) const {
  const double x = points(column::position, 0)[p], y = points(column::position, 1)[p], r = std::hypot(x, y);
  int nearest = 0;
  for (int k = 1; k < static_cast<int>(rings_.size()); ++k)
    if (std::abs(exact_at(k).radius.value - r) < std::abs(exact_at(nearest).radius.value - r)) nearest = k;
  return {nearest, std::atan2(y, x) - exact_at(nearest).turned.value};
}

std::vector<OddImage> TwistedRing::images(const Columns& points, double rows) const {
  std::vector<OddImage> all;
  const int rings = static_cast<int>(rings_.size());
  for (int p = 0; p < points.points(); ++p) {
    const Seat at = seat(points, p);
    const auto behind = [&](double rim, double turned) {
      const double x = rim * std::cos(at.angle + turned), y = rim * std::sin(at.angle + turned);
      all.push_back({p, {2 * x - points(column::position, 0)[p], 2 * y - points(column::position, 1)[p], 0}});
    };
    if (at.ring + 0.5 <= rows) behind(inner_, -twist_);
    if (rings - at.ring - 0.5 <= rows) behind(outer_, 0);
  }
  return all;
}

double largest_stress(const Columns& points, int p, const SurfaceLaw& law) {
  return Principal(law.state(metric_of(points, p))).larger;
}

RingForces ring_forces(const Columns& points, const std::vector<int>& ring, const SurfaceLaw& law,
                       const TwistedRing& exact) {
  const double arm = exact.exact().arm().value, whole_torque = exact.exact().torque().value,
               whole_energy = exact.exact().energy().value;
  RingForces all{};
  struct Through {
    double torque = 0, weight = 0;
  };
  std::map<int, Through> rings;
  double weights = 0, stresses = 0, volume = 0;
  for (int p = 0; p < points.points(); ++p) {
    const int own = ring[static_cast<std::size_t>(p)];
    const double R = exact.radius(own), V = points(column::volume)[p], weight = V / R;
    const SurfaceLaw::State s = law.state(metric_of(points, p));
    const Principal stress(s);
    // The traction on what is within a ring is S_1b f_b: f_1 stood along the radius at rest.
    const double torque = 2 * std::numbers::pi * law.thickness * R * moment(points, p, s.first, s.mixed) / whole_torque;
    rings[own].torque += weight * torque;
    rings[own].weight += weight;
    all.torque += weight * torque;
    weights += weight;
    all.energy += V * s.energy / whole_energy;
    const double away = moment(points, p, stress.cosine, stress.sine) / length(points, p, stress.cosine, stress.sine);
    all.crooked += V * std::pow(away / arm - 1, 2);
    all.across += V * stress.smaller * stress.smaller;
    stresses += V * std::pow(exact.exact_at(own).stress.value, 2);
    volume += V;
  }
  all.torque /= weights;
  for (const auto& [k, through] : rings)
    all.uneven += through.weight / weights * std::pow(through.torque / through.weight - all.torque, 2);
  all.uneven = std::sqrt(all.uneven);
  all.crooked = std::sqrt(all.crooked / volume);
  all.across = std::sqrt(all.across / stresses);
  return all;
}

}  // namespace plumbline
