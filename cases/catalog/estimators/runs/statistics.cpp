#include <cmath>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/runs/closed_forms.hpp"
#include "cases/harness/compare/bands.hpp"
#include "cases/harness/compare/two_samples.hpp"
#include "cases/harness/integrators/cost.hpp"
#include "cases/harness/verdict/line_fit.hpp"
#include "cases/harness/verdict/order.hpp"
#include "cases/harness/verdict/student.hpp"

namespace plumbline {
namespace {

constexpr double scatter = 0.03;  // of logarithms

// Three points of weights 1, 2 and 1 whose line, by hand, is (8 + 5 x)/19.
const std::vector<FitPoint> weighted_points{{0, 0, 1}, {1, 1, 2}, {3, 1, 1}};
const double weighted_slope = 5.0 / 19, weighted_intercept = 8.0 / 19, weighted_error = 4 * std::sqrt(2.0) / 19;

}  // namespace

KnownAnswers line_answers() {
  std::vector<FitPoint> points;
  for (const auto& [x, off] : {std::pair{-2.0, 1.0}, {-1.0, -2.0}, {0.0, 0.0}, {1.0, 2.0}, {2.0, -1.0}}) {
    points.push_back({x, 3 - 0.5 * x + scatter * off});
  }
  const StraightLine line = fit_line(points), weighted = fit_line(weighted_points),
                     two = fit_line(std::vector<FitPoint>{{1, 2}, {3, -4}});
  return {{"line.slope", line.slope, -0.5},
          {"line.intercept", line.intercept, 3},
          {"line.slope_error", line.slope_error, scatter / std::sqrt(3.0)},
          {"weighted.slope", weighted.slope, weighted_slope},
          {"weighted.intercept", weighted.intercept, weighted_intercept},
          {"weighted.slope_error", weighted.slope_error, weighted_error},
          {"two.slope", two.slope, -3},
          {"two.intercept", two.intercept, 5},
          {"two.slope_error_unknown", std::isinf(two.slope_error) ? 1.0 : 0.0, 1},
          {"student.1", student_quantile(1), student_of_one(), student_of_one()},
          {"student.2", student_quantile(2), student_of_two(), student_of_two()},
          {"student.4", student_quantile(4), student_of_four(), student_of_four()},
          {"student.0_unknown", std::isinf(student_quantile(0)) ? 1.0 : 0.0, 1}};
}

namespace {

Level level_of(double h, double error) {
  Level level;
  level.h = h;
  level.error = error;
  return level;
}

// E = c h^p, of which the logarithms are off by `residuals` times the scatter. From fine to coarse: a fit sorts them.
std::vector<Level> power_law(double c, double p, const std::vector<double>& residuals) {
  std::vector<Level> levels;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    const double h = std::ldexp(1.0, static_cast<int>(k) - 6);
    levels.push_back(level_of(h, c * std::pow(h, p) * std::exp(scatter * residuals[k])));
  }
  return levels;
}

// The weighted points as logarithms of h and of errors, whose weights follow from the scatter over the offsets: of the middle
// level none, of the others 0.0075 = (4/3) 0.075^2, with which the floor is 0.0075, too.
std::vector<Level> offset_levels() {
  std::vector<Level> levels;
  for (const FitPoint& point : weighted_points) {
    const double off = point.weight == 2 ? 0 : 0.075;
    Level level = level_of(std::exp(point.x), 1);
    for (const double sign : {1, 1, -1, -1}) level.offset_errors.push_back(std::exp(point.y + sign * off));
    levels.push_back(level);
  }
  return levels;
}

double used_levels(const OrderFit& fit) {
  double count = 0;
  for (const bool used : fit.used) count += used;
  return count;
}

void add_fit(const std::string& name, const OrderFit& fit, double order, double half_width, double constant,
             KnownAnswers& all) {
  all.push_back({name + ".order", fit.order, order});
  all.push_back({name + ".low", fit.low, order - half_width});
  all.push_back({name + ".high", fit.high, order + half_width});
  all.push_back({name + ".constant", fit.constant, constant, constant});
}

}  // namespace

KnownAnswers order_answers() {
  KnownAnswers all;
  const std::vector<Level> scattered = power_law(0.7, 1.8, {off_line.begin(), off_line.end()});
  const OrderFit fit = fit_order(scattered, Weighting::equal);
  add_fit("scattered", fit, 1.8, student_of_four() * slope_error_of_six(scatter), 0.7, all);
  const double first = 1.8 + 2 * scatter / std::numbers::ln2;  // between residuals -1 and 1 towards coarser levels
  all.push_back({"scattered.pairwise_coarse", fit.pairwise.front(), first});
  all.push_back({"scattered.pairwise_fine", fit.pairwise.back(), 2 * 1.8 - first});
  all.push_back({"scattered.plateau", fit.plateau.front(), 0.7 * std::exp(scatter)});
  all.push_back({"scattered.usable", static_cast<double>(fit.usable), 1});
  all.push_back({"scattered.asymptotic", static_cast<double>(fit.asymptotic), 1});

  // A law without scatter, whichever levels are left out; h and errors of any size.
  std::vector<Level> exact = power_law(2e-5, 2.5, {0, 0, 0, 0, 0, 0, 0});
  exact[0].rounding = 1.01 * exact[0].error / rounding_factor;
  exact[1].reference_bound = 1.01 * reference_share * exact[1].error;
  exact[2].rounding = 0.99 * exact[2].error / rounding_factor;
  exact[2].reference_bound = 0.99 * reference_share * exact[2].error;
  const OrderFit without = fit_order(exact, Weighting::equal);
  add_fit("exact", without, 2.5, 0, 2e-5, all);
  all.push_back({"exact.used", used_levels(without), 5});
  all.push_back({"exact.without_one", without.leave_one_out.front(), 2.5});
  exact[3].dropped = "for a reason";
  const OrderFit four = fit_order(exact, Weighting::equal);
  all.push_back({"exact.four_used", used_levels(four), 4});
  all.push_back({"exact.four_usable", static_cast<double>(four.usable), 0});

  // Of three levels the plateau may vary by 15 %, and orders between neighbours by 0.15. Curved by c a level, in the logarithm, the
  // finest of six have orders off by 4 c/ln 2 and a plateau that varies by exp(6 c); one level off by d has d/ln 2 and exp(d).
  const auto asymptotic = [&](const std::string& name, const std::vector<double>& residuals, bool exact_answer) {
    const OrderFit found = fit_order(power_law(1, 1, residuals), Weighting::equal);
    all.push_back({name, static_cast<double>(found.asymptotic), exact_answer ? 1.0 : 0.0});
  };
  const auto curved = [](double c) {
    std::vector<double> residuals;
    for (int k = 0; k < 6; ++k) residuals.push_back(c / scatter * k * k);
    return residuals;
  };
  asymptotic("curved", curved(0.025), false);
  asymptotic("curved_less", curved(0.022), true);
  asymptotic("off", {0, 0.12 / scatter, 0, 0, 0, 0}, false);
  asymptotic("off_less", {0, 0.09 / scatter, 0, 0, 0, 0}, true);

  const OrderFit weighted = fit_order(offset_levels(), Weighting::offsets);
  add_fit("offsets", weighted, weighted_slope, student_of_one() * weighted_error, std::exp(weighted_intercept), all);
  std::vector<Level> few = offset_levels();
  few[0].offset_errors.pop_back();
  const OrderFit equal = fit_order(few, Weighting::offsets);  // their errors are all 1 then
  all.push_back({"few_offsets.order", equal.order, 0});
  all.push_back({"no_levels.invalid", static_cast<double>(fit_order({}, Weighting::equal).invalid), 1});
  return all;
}

namespace {

// Ratios second_j/first_i are all powers 3^0 ... 3^(m n - 1).
TimeRatio ratio_of_powers(int m, int n) {
  std::vector<double> first, second;
  for (int i = 0; i < m; ++i) first.push_back(std::pow(3.0, -i));
  for (int j = 0; j < n; ++j) second.push_back(std::pow(3.0, m * j));
  return time_ratio(first, second);
}

CostCurve power_curve(double factor, std::vector<double> errors, std::vector<double> repetitions) {
  CostCurve curve{"a case", "a measure"};
  for (const double error : errors) {
    CostLevel level{.error = error};
    for (const double times : repetitions) level.wall_s.push_back(factor * times * std::pow(error, -1.5));
    curve.levels.push_back(level);
  }
  return curve;
}

}  // namespace

KnownAnswers sample_answers() {
  KnownAnswers all;
  // Of the C(m + n, m) orders of both samples 1, 2, 4, 7, 12 have a statistic of at most 0, 1, 2, 3, 4. The interval leaves out, at
  // either end, as many ratios as the largest statistic that 2.5 % of the orders do not exceed: 0 of 70, where one order is 1.4 %,
  // 2 of 252, where four are 1.6 %, 3 of 330, where seven are 2.1 % [H. B. Mann, D. R. Whitney, doi 10.1214/aoms/1177730491].
  for (const auto& [m, n, cut] : {std::tuple{4, 4, 0}, {5, 5, 2}, {4, 7, 3}, {7, 4, 3}}) {
    const TimeRatio ratio = ratio_of_powers(m, n);
    const std::string name = "ratio." + std::to_string(m) + "." + std::to_string(n);
    const double last = m * n - 1;
    all.push_back({name + ".low", std::log(ratio.low) / std::log(3.0), static_cast<double>(cut), last});
    all.push_back({name + ".estimate", std::log(ratio.estimate) / std::log(3.0), last / 2, last});
    all.push_back({name + ".high", std::log(ratio.high) / std::log(3.0), last - cut, last});
  }
  const TimeRatio few = ratio_of_powers(3, 3);
  all.push_back({"ratio.3.3.low", few.low, 0});
  all.push_back(yes("ratio.3.3.high_unknown", std::isinf(few.high)));

  const Range band = widened({"", "", "", {0.3, -0.1, 0.2}, {}});
  all.push_back({"band.low", band.low.value_or(NAN), -0.3});
  all.push_back({"band.high", band.high.value_or(NAN), 0.5});

  // Seconds over errors are parallel in logarithms: the factor is the same at every error both have.
  const CostCurve mine = power_curve(3, {0.1, 0.02, 0.004}, {1, 2, 8}),
                  other = power_curve(1, {0.3, 0.05, 0.003}, {1, 1, 1});
  const CostFactor factor = cost_factor(mine, other);
  all.push_back({"cost.factor", factor.factor.value_or(NAN), 6});
  all.push_back({"cost.low", factor.low, 3});
  all.push_back({"cost.high", factor.high, 24, 24});
  const CostFactor none = cost_factor(power_curve(3, {0.1, 0.09}, {1}), power_curve(1, {0.05, 0.01}, {1}));
  all.push_back({"cost.apart", static_cast<double>(none.factor.has_value()), 0});
  const CostFactor middle = median_of({{"", 2, 1, 3}, {"", {}, 0, 0}, {"", 8, 4, 27}}).value_or(CostFactor{});
  all.push_back({"cost.median", middle.factor.value_or(NAN), 4});
  all.push_back({"cost.median_low", middle.low, 2});
  all.push_back({"cost.median_high", middle.high, 9});
  return all;
}

}  // namespace plumbline
