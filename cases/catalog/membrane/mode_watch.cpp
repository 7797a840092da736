#include "cases/catalog/membrane/mode_watch.hpp"

#include <algorithm>
#include <cmath>

#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/run/extremes.hpp"

namespace plumbline {

void ModeWatch::observe(const Simulation& simulation) {
  const Columns& points = simulation.scene().bodies.front().points;
  const double *x = points(column::position, direction_), *m = points(column::mass);
  double moment = 0, weight = 0;
  for (int p = 0; p < points.points(); ++p) {
    const double phi = shape_[static_cast<std::size_t>(p)];
    moment += m[p] * (x[p] - rest_) * phi;
    weight += m[p] * phi * phi;
  }
  const double q = moment / weight;
  double rest = 0;
  for (int p = 0; p < points.points(); ++p) {
    const double u = x[p] - rest_ - q * shape_[static_cast<std::size_t>(p)];
    rest += m[p] * u * u;
  }
  times_.push_back(simulation.time());
  coordinate_.push_back(q);
  impurity_ = std::sqrt(rest / weight) / std::abs(coordinate_.front());
}

void ModeWatch::history(Archive& archive) {
  archive("times", times_);
  archive("coordinate", coordinate_);
  archive("impurity", impurity_);
}

std::optional<double> ModeWatch::period() const {
  std::vector<double> zeros;
  for (std::size_t k = 1; k < times_.size() && zeros.size() < 3; ++k) {
    const double a = coordinate_[k - 1], b = coordinate_[k];
    if ((a > 0) != (b > 0)) zeros.push_back(times_[k - 1] + (times_[k] - times_[k - 1]) * a / (a - b));
  }
  if (zeros.size() < 3) return {};
  return zeros[2] - zeros[0];
}

std::optional<double> ModeWatch::amplitude_loss() const {
  const double start = coordinate_.front(), noise = 1e-5 * std::abs(start);
  const auto turns = find_extremes(times_, coordinate_, noise);
  if (turns.size() < 2) return {};
  return 1 - turns[1].value / start;
}

std::vector<Measure> ModeWatch::measures(const Simulation& simulation, reference::Bounded exact_period) const {
  const double none = std::nan("");
  return {scalar_measure("period", period().value_or(none), exact_period.value, exact_period.bound, "s"),
          share_measure("amplitude_loss", amplitude_loss().value_or(none)), share_measure("impurity", impurity()),
          drift_measure(simulation)};
}

Profile ModeWatch::profile(std::string label, std::string exact_label,
                           const std::function<double(double)>& exact) const {
  return thinned_history({{"time", "s", "time", {}},
                          {"coordinate", "m", std::move(label), {}},
                          {"coordinate_reference", "m", std::move(exact_label), {}}},
                         times_.size(), 800, [&](std::size_t k) {
                           return std::vector{times_[k], coordinate_[k], exact(times_[k])};
                         });
}

int cells_beside(double h) { return std::max(2, whole(std::round(0.4 / h))); }

}  // namespace plumbline
