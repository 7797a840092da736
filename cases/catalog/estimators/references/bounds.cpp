// Numbers with bounds, which references are made of: values, what bounds of operands make of the bound, and what rounding adds.
#include <cmath>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "reference/elementary.hpp"

namespace plumbline {
namespace {

using reference::Bounded;

constexpr double no_bound = -1;  // stands for an infinite one

class BoundRows {
 public:
  explicit BoundRows(KnownAnswers& all) : all_(all) {}

  void of(const std::string& name, Bounded found, double value, double bound) {
    all_.push_back({name + ".value", found.value, value, std::max(1.0, std::abs(value))});
    all_.push_back({name + ".bound", std::isinf(found.bound) ? no_bound : found.bound, bound});
  }
  // Of exact operands: so many units in the last place.
  void rounded(const std::string& name, Bounded found, double value, double units) {
    of(name, {found.value, 0}, value, 0);
    const double size = units * std::abs(value);
    all_.push_back({name + ".rounding", found.bound / reference::rounding::unit, size, std::max(1.0, size)});
  }

 private:
  KnownAnswers& all_;
};

void add_arithmetic(BoundRows row) {
  const Bounded a(5, 0.25), b(-3, 0.5), none(1, 1), nothing(0, 4);
  row.of("sum", a + b, 2, 0.75);
  row.rounded("exact_sum", Bounded(5) + Bounded(-3), 2, 1);
  row.rounded("sum_with_zero", Bounded(5) + Bounded(0), 5, 0);
  row.rounded("zero_with_sum", Bounded(0) + Bounded(5), 5, 0);
  row.of("difference", a - b, 8, 0.75);
  row.of("negative", -a, -5, 0.25);
  row.of("product", a * b, -15, 2.5 + 0.75 + 0.125);
  row.rounded("exact_product", Bounded(3) * Bounded(7), 21, 1);
  row.of("quotient", Bounded(6, 0.25) / b, -2, (0.25 + 2 * 0.5) / 2.5);
  row.rounded("exact_quotient", Bounded(6) / Bounded(3), 2, 1);
  row.of("by_zero", a / none, 5, no_bound);
  row.of("absolute", abs(b), 3, 0.5);
  // The values of a first number, and all that the second covers.
  row.of("hull", hull(Bounded(2, 0.1), Bounded(3, 0.5)), 2, 1.5);
  row.of("wide_hull", hull(Bounded(2, 5), Bounded(3, 0.5)), 2, 5);
  const auto square = [](double x) { return Bounded(x) * Bounded(x); };
  row.of("interval", over_interval(square, Bounded(3, 1)), 9, 7);
  row.of("lower_part", over_interval([](double x) { return sqrt(Bounded(x)); }, Bounded(4, 3)), 2, 1);
  row.of("cut_interval", over_interval([](double x) { return sqrt(Bounded(x)); }, Bounded(4, 3), 2.25), 2,
         std::sqrt(7.0) - 2);
  row.of("exact_interval", over_interval(square, Bounded(3)), 9, 0);
}

void add_functions(BoundRows row) {
  // Below: 4 - 1.75 = 1.5^2; above less.
  row.of("root", sqrt(Bounded(4, 1.75)), 2, 0.5);
  row.of("root_to_zero", sqrt(Bounded(1, 2)), 1, 1);
  row.of("root_of_nothing", sqrt(Bounded(-1, 2)), 0, std::numbers::sqrt2);
  row.rounded("exact_root", sqrt(Bounded(9)), 3, 1);
  row.of("logarithm", log(Bounded(2, 0.5)), std::numbers::ln2, -std::log(0.75));
  row.of("near_logarithm", log(Bounded(2, 2e-4)), std::numbers::ln2, 1e-4 * (1 + 1e-4));
  row.of("logarithm_of_zero", log(Bounded(1, 1)), 0, no_bound);
  row.rounded("exact_logarithm", log(Bounded(8)), 3 * std::numbers::ln2, 2);
  row.of("exponential", expm1(Bounded(1, 0.5)), std::numbers::e - 1, std::exp(1.5) - std::numbers::e);
  row.rounded("exact_exponential", expm1(Bounded(1)), std::numbers::e - 1, 2);
  const double change = 3.1 * -std::log(0.75) + 0.1 * std::numbers::ln2;
  // A part in 1e12 is for the exponential's own rounding.
  row.of("power", pow(Bounded(2, 0.5), Bounded(3, 0.1)), 8, 8 * (std::exp(change) - 1) * (1 + 1e-12));
  const double small = 2 * 5e-6 * (1 + 5e-6);
  row.of("near_power", pow(Bounded(2, 1e-5), 2), 4, 4 * small * (1 + small));
  row.rounded("exact_power", pow(Bounded(2), 3), 8, 2);
  row.of("power_of_zero", pow(Bounded(0, 4), 0.5), 0, 2);
  row.of("unsure_power", pow(Bounded(0, 4), Bounded(0.5, 0.1)), 0, 2 * std::pow(4, 0.1));
  row.of("power_of_none", pow(Bounded(0), 0.5), 0, 0);
  row.of("power_that_may_fall", pow(Bounded(0, 4), Bounded(0.5, 0.6)), 0, no_bound);
  row.of("sine", sin(Bounded(1, 0.25)), std::sin(1), 0.25);
  row.of("sine_of_all", sin(Bounded(1, 5)), std::sin(1), 2);
  row.rounded("exact_sine", sin(Bounded(1)), std::sin(1), 2);
  row.of("cosine", cos(Bounded(1, 0.25)), std::cos(1), 0.25);
  row.of("cosine_of_all", cos(Bounded(1, 5)), std::cos(1), 2);
  row.rounded("exact_cosine", cos(Bounded(1)), std::cos(1), 2);
  row.of("arc", atan(Bounded(1, 0.5)), std::numbers::pi / 4, 0.5);
  row.rounded("exact_arc", atan(Bounded(1)), std::numbers::pi / 4, 2);
  row.of("angle", atan2(Bounded(3, 0.3), Bounded(4, 0.4)), std::atan2(3, 4), 0.5 / 4.5);
  row.of("angle_of_none", atan2(Bounded(3, 3), Bounded(4, 4)), std::atan2(3, 4), no_bound);
  row.rounded("exact_angle", atan2(Bounded(1), Bounded(1)), std::numbers::pi / 4, 2);
  row.of("area", asinh(Bounded(2, 1)), std::asinh(2), std::sqrt(0.5));
  row.of("area_about_zero", asinh(Bounded(-1, 2)), std::asinh(-1), 2);
  row.of("hyperbolic_sine", sinh(Bounded(-1, 0.5)), -std::sinh(1), 0.5 * std::cosh(1.5));
  row.rounded("exact_hyperbolic_sine", sinh(Bounded(1)), std::sinh(1), 4);
  row.of("hyperbolic_cosine", cosh(Bounded(-1, 0.5)), std::cosh(1), 0.5 * std::sinh(1.5));
  row.rounded("exact_hyperbolic_cosine", cosh(Bounded(1)), std::cosh(1), 4);
}

}  // namespace

KnownAnswers bound_answers() {
  KnownAnswers all;
  add_arithmetic(BoundRows(all));
  add_functions(BoundRows(all));
  const auto below = [&](const char* name, Bounded a, Bounded b, bool exact) {
    all.push_back(whether(name, certainly_below(a, b), exact));
  };
  below("below", {1, 0.25}, {2, 0.5}, true);
  below("touching", {1, 0.5}, {2, 0.5}, false);
  below("above", {2, 0.25}, {1, 0.25}, false);
  all.push_back({"lowest", lowest(Bounded(2, 0.5)), 1.5});
  all.push_back({"highest", highest(Bounded(2, 0.5)), 2.5});
  return all;
}

}  // namespace plumbline
