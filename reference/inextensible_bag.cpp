#include "reference/inextensible_bag.hpp"

#include <algorithm>

#include "reference/argument.hpp"
#include "reference/carlson.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {

/// What a member of the family, taken exactly, measures.
struct InextensibleBag::Measures {
  Bounded meridian, height, volume, sine;  // sine of a
};

namespace {

constexpr int table = 96;
constexpr double least_share = 0.01;  // of the free height: flatter bags are not asked for

/// F and D at sin^2 psi = (1 + sine)/2, with Delta = r/R.
LegendreFD end_integrals(Bounded sine, Bounded delta) {
  const Bounded half(0.5);
  return legendre_FD(sqrt(half * (Bounded(1) + sine)), sqrt(half * (Bounded(1) - sine)), delta);
}

/// The change of both unknowns that undoes the misses, by differences of the measures.
struct Slopes {
  double meridian_square, meridian_length, height_square, height_length;
  double determinant() const { return meridian_square * height_length - meridian_length * height_square; }
  double square(double meridian, double height) const {
    return (height_length * meridian - meridian_length * height) / determinant();
  }
  double length(double meridian, double height) const {
    return (meridian_square * height - height_square * meridian) / determinant();
  }
};

}  // namespace

InextensibleBag::InextensibleBag(double meridian, double probe_radius)
    : meridian_(meridian),
      probe_radius_(probe_radius) {
  check_positive("meridian", meridian);
  check_positive("probe_radius", probe_radius);
  const LegendreFD quarter = end_integrals(0, 0);
  free_radius_ = Bounded(meridian) / (Bounded(2) * quarter.F);
  free_height_ = Bounded(2) * free_radius_ * (quarter.F - Bounded(2) * quarter.D);
  tabulate();
}

Bounded InextensibleBag::free_volume() const { return pi / 3.0 * free_radius_ * free_radius_ * meridian_; }

double InextensibleBag::least_height() const { return heights_.back(); }

InextensibleBag::Measures InextensibleBag::measure(Member member) const {
  const Bounded square(member.square), area = Bounded(member.length) * member.length, b = sqrt(square);
  const Bounded R = sqrt(square + area), rp(probe_radius_);
  const LegendreFD low = end_integrals(0, b / R);
  LegendreFD high = low;
  Bounded top = b, sine = 0.0, spared = 0.0;
  if (b.value > probe_radius_) {
    top = rp;
    sine = (square - rp * rp) / area;
    sine = {std::clamp(sine.value, 0.0, 1.0), sine.bound};
    high = end_integrals(sine, rp / R);
    spared = rp * sine * sine / (Bounded(1) + sqrt(Bounded(1) - sine * sine));  // r_p (1 - cos a)
  }
  const Bounded scale = area / R, F = low.F + high.F, D = low.D + high.D;
  Measures found;
  found.meridian = b + top + scale * F;
  found.height = scale * (F - Bounded(2) * D);
  found.volume = pi / 3.0 * (area * (found.meridian - spared) + square * found.height);
  found.sine = sine;
  return found;
}

/// Smallest l for that b: the edge must be reached before the skin hangs straight down along the probe.
double InextensibleBag::least_length(double radius) const {
  const double over = (radius - probe_radius_) * (radius + probe_radius_);
  return std::max(1e-6 * meridian_, std::sqrt(std::max(0.0, over)) * (1 + 1e-9));
}

InextensibleBag::Member InextensibleBag::member(double radius) const {
  const double square = radius * radius;
  auto missed = [&](double length) { return measure({square, length}).meridian.value - meridian_; };
  return {square, brent_root(missed, least_length(radius), meridian_)};
}

double InextensibleBag::greatest_radius() const {
  double low = 0, high = 0.5 * meridian_;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    const Measures shortest = measure({middle * middle, least_length(middle)});
    const bool exists = shortest.meridian.value < meridian_;
    const bool open = exists && measure(member(middle)).height.value > least_share * free_height_.value;
    (open ? low : high) = middle;
  }
  return low;
}

void InextensibleBag::tabulate() {
  const double most = greatest_radius();
  for (int i = 0; i <= table; ++i) {
    members_.push_back(i == 0 ? Member{0, free_radius_.value} : member(i == table ? most : most * i / table));
    heights_.push_back(measure(members_.back()).height.value);
  }
  edge_height_ = probe_radius_ < most ? measure(member(probe_radius_)).height.value : heights_.back();
}

InextensibleBag::Member InextensibleBag::guess(double height) const {
  const auto after = std::upper_bound(heights_.begin(), heights_.end(), height, std::greater<>());
  if (after == heights_.begin()) return members_.front();
  if (after == heights_.end()) return members_.back();
  const auto i = static_cast<std::size_t>(after - heights_.begin());
  const double share = (heights_[i - 1] - height) / (heights_[i - 1] - heights_[i]);
  const Member &a = members_[i - 1], &b = members_[i];
  return {a.square + share * (b.square - a.square), a.length + share * (b.length - a.length)};
}

// Newton's method with the slopes at the guess: they are a hundredth off, so each step gains two digits. Across the
// change to the edge they are further off, and it takes more steps.
BagShape InextensibleBag::at(Bounded height) const {
  if (certainly_below(free_height_, height) || !(height.value >= least_height() * (1 - 1e-12)))
    throw ParameterError("height", height.value, "from least_height() to free_height()");
  Member found = guess(height.value);
  const double step = 1e-6 * meridian_;
  Measures here = measure(found);
  const Measures wider = measure({found.square + step * meridian_, found.length});
  const Measures longer = measure({found.square, found.length + step});
  const Slopes slopes{
      (wider.meridian - here.meridian).value / (step * meridian_), (longer.meridian - here.meridian).value / step,
      (wider.height - here.height).value / (step * meridian_), (longer.height - here.height).value / step};
  auto missed = [&](const Measures& m) {
    return std::abs(m.meridian.value - meridian_) + std::abs(m.height.value - height.value);
  };
  for (int i = 0; i < 60; ++i) {
    const double S = here.meridian.value - meridian_, H = here.height.value - height.value;
    Member next{std::max(0.0, found.square - slopes.square(S, H)), found.length - slopes.length(S, H)};
    const Measures there = measure(next);
    if (!(missed(there) < missed(here))) break;
    found = next;
    here = there;
  }
  const double S = highest(abs(here.meridian - meridian_)), H = highest(abs(here.height - height));
  const double square = found.square, length = found.length;
  // Bounds to first order, doubled: what is missed is rounding, its square nothing.
  const Slopes size{std::abs(slopes.meridian_square), -std::abs(slopes.meridian_length),
                    -std::abs(slopes.height_square), std::abs(slopes.height_length)};
  const double margin = 2 / std::abs(slopes.determinant()) * std::abs(size.determinant());
  const Bounded b2(square, margin * std::abs(size.square(S, H)));
  const Bounded l(length, margin * std::abs(size.length(S, H)));
  BagShape shape;
  shape.height = height;
  shape.volume = {here.volume.value, here.volume.bound + 2 * pi.value * (length * length * S + square * H)};
  shape.pressed_area = pi * b2;
  shape.plate_radius = sqrt(b2);
  shape.probe_radius = shape.plate_radius.value > probe_radius_
                           ? Bounded(probe_radius_, std::max(0.0, probe_radius_ - lowest(shape.plate_radius)))
                           : shape.plate_radius;
  shape.equator = sqrt(b2 + l * l);
  shape.tension = Bounded(0.5) * l * l;
  const Bounded sine = Bounded(std::max(0.0, square - probe_radius_ * probe_radius_), b2.bound + 1e-15 * square) /
                       (l * l);
  shape.edge_angle = atan(sine / sqrt(Bounded(1) - sine * sine));
  return shape;
}

}  // namespace plumbline::reference
