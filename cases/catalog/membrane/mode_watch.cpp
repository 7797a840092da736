#include "cases/catalog/membrane/mode_watch.hpp"

#include <cmath>

#include "cases/harness/description/archive.hpp"
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

std::vector<std::size_t> thinned_rows(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < count; k += count / most + 1) rows.push_back(k);
  return rows;
}

}  // namespace plumbline
