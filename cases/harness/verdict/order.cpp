#include "cases/harness/verdict/order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/verdict/line_fit.hpp"
#include "cases/harness/verdict/student.hpp"

namespace plumbline {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_error(double value) { return std::isfinite(value) && value > 0; }
bool is_bound(double value) { return std::isfinite(value) && value >= 0; }

std::string defect(const Level& level) {
  if (!is_error(level.h)) return "a level has no positive, finite h";
  if (!is_error(level.error)) return "a level has no positive, finite error";
  if (!std::all_of(level.offset_errors.begin(), level.offset_errors.end(), is_error))
    return "an offset of a level has no positive, finite error";
  if (!is_bound(level.rounding)) return "a level has no finite rounding level";
  if (!is_bound(level.reference_bound)) return "a level has no finite bound of the reference";
  return {};
}

// `levels` sorted from coarse to fine.
std::string defect(const std::vector<Level>& levels) {
  if (levels.empty()) return "no levels";
  for (const Level& level : levels)
    if (auto why = defect(level); !why.empty()) return why;
  for (std::size_t k = 1; k < levels.size(); ++k)
    if (!(levels[k].h < levels[k - 1].h)) return "two levels have the same h";
  return {};
}

struct Scatter {
  double mean;      // of ln E over the offsets
  double variance;  // sample variance of ln E
};

Scatter scatter_of(const std::vector<double>& errors) {
  const double count = static_cast<double>(errors.size());
  double mean = 0, squares = 0;
  for (double error : errors) mean += std::log(error) / count;
  for (double error : errors) squares += (std::log(error) - mean) * (std::log(error) - mean);
  return {mean, squares / (count - 1)};
}

std::string why_unused(const Level& level, double error) {
  if (!level.dropped.empty()) return "dropped by the case: " + level.dropped;
  if (error <= rounding_factor * level.rounding) return "error within ten times rounding";
  if (level.reference_bound > reference_share * error) return "bound of the reference above 5 % of the error";
  return {};
}

// Offsets weigh only if every level the case keeps has enough of them.
Weighting applicable(const std::vector<Level>& levels, Weighting wanted) {
  const bool enough = std::all_of(levels.begin(), levels.end(), [](const Level& level) {
    return !level.dropped.empty() || level.offset_errors.size() >= least_offsets;
  });
  return wanted == Weighting::offsets && enough ? Weighting::offsets : Weighting::equal;
}

// What enters the fit: ln E over ln h, and sample variances of ln E over the offsets; 0 where the fit takes none.
struct Selected {
  std::vector<FitPoint> points;
  std::vector<double> variances;
};

// Fills the lists that speak of every level.
Selected select(const std::vector<Level>& levels, OrderFit& fit) {
  Selected used;
  for (const Level& level : levels) {
    const bool weighted = fit.weighting == Weighting::offsets && level.offset_errors.size() >= least_offsets;
    const Scatter scatter = weighted ? scatter_of(level.offset_errors) : Scatter{std::log(level.error), 0};
    const double error = weighted ? std::exp(scatter.mean) : level.error;
    fit.h.push_back(level.h);
    fit.error.push_back(error);
    fit.why_unused.push_back(why_unused(level, error));
    fit.used.push_back(fit.why_unused.back().empty());
    if (!fit.used.back()) continue;
    used.points.push_back({std::log(level.h), scatter.mean});
    used.variances.push_back(scatter.variance);
  }
  return used;
}

void weigh(Selected& used) {
  double floor_squared = reference_share * reference_share;
  for (const double v : used.variances) floor_squared += v / static_cast<double>(used.variances.size());
  for (std::size_t k = 0; k < used.points.size(); ++k) used.points[k].weight = 1 / (used.variances[k] + floor_squared);
}

void add_checks(const std::vector<FitPoint>& points, OrderFit& fit) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    fit.plateau.push_back(std::exp(points[k].y - fit.order * points[k].x));
    if (k > 0) fit.pairwise.push_back((points[k].y - points[k - 1].y) / (points[k].x - points[k - 1].x));
    if (points.size() > 2) {
      std::vector<FitPoint> others = points;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      fit.leave_one_out.push_back(fit_line(others).slope);
    }
  }
}

bool is_asymptotic(const OrderFit& fit) {
  if (fit.pairwise.size() < 3) return false;
  const auto [smallest, largest] = std::minmax_element(fit.plateau.end() - 3, fit.plateau.end());
  return *largest <= (1 + asymptotic_plateau) * *smallest &&
         std::all_of(fit.pairwise.end() - 3, fit.pairwise.end(),
                     [&](double order) { return std::abs(order - fit.order) <= asymptotic_order; });
}

void add_interval(const StraightLine& line, std::size_t count, OrderFit& fit) {
  fit.low = -infinity;
  fit.high = infinity;
  if (count < 3) return;
  const double half_width = student_quantile(static_cast<double>(count) - 2) * line.slope_error;
  fit.low = fit.order - half_width;
  fit.high = fit.order + half_width;
}

OrderFit without_numbers() {
  OrderFit fit;
  fit.order = fit.low = fit.high = fit.constant = not_a_number;
  return fit;
}

}  // namespace

OrderFit fit_order(std::span<const Level> given, Weighting weighting) {
  std::vector<Level> levels(given.begin(), given.end());
  OrderFit fit = without_numbers();
  for (const Level& level : levels)  // a NaN cannot be sorted
    if (!is_error(level.h)) fit.reason = defect(level);
  if (fit.reason.empty()) {
    std::sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) { return a.h > b.h; });
    fit.reason = defect(levels);
  }
  fit.invalid = !fit.reason.empty();
  if (fit.invalid) return fit;

  fit.weighting = applicable(levels, weighting);
  Selected used = select(levels, fit);
  weigh(used);
  const std::vector<FitPoint>& points = used.points;
  if (points.size() >= 2) {
    const StraightLine line = fit_line(points);
    fit.order = line.slope;
    fit.constant = std::exp(line.intercept);
    add_interval(line, points.size(), fit);
    add_checks(points, fit);
    fit.asymptotic = is_asymptotic(fit);
  }
  if (points.size() < least_levels)
    fit.reason = std::to_string(points.size()) + " of " + std::to_string(levels.size()) + " levels can be used, " +
                 std::to_string(least_levels) + " are needed";
  else if (!std::isfinite(fit.low) || !std::isfinite(fit.high))
    fit.reason = "the fit is not finite";
  fit.usable = fit.reason.empty();
  return fit;
}

}  // namespace plumbline
