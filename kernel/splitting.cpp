#include "kernel/splitting.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/geometry.hpp"
#include "kernel/parallel.hpp"
#include "kernel/rotations.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

// D over h^2; without an affine transfer there is none to keep, and d is bounded as by quadratic shapes.
double inertia_of(const std::string& shape) {
  return shape_named(shape_offers(shape, Trait::constant_inertia) ? shape : "quadratic").inertia;
}

// The points of a body that have outgrown the kernel, in their order. Almost always none: one look at one column.
std::vector<int> outgrown(const Columns& points, const GridSpec& grid, double largest, int threads) {
  constexpr int stretch = 4096;
  const int count = points.points();
  const double *volume = points(column::volume), *radius = points(column::position);
  const auto beyond = [&](int p) {
    return volume[p] > (grid.axisymmetric ? largest * std::max(radius[p], grid.h / 2) : largest);
  };
  std::vector<char> any(static_cast<std::size_t>((count + stretch - 1) / stretch));
  for_each_piece(static_cast<int>(any.size()), threads, [&](int piece) {
    const int first = piece * stretch, last = std::min(first + stretch, count);
    bool found = false;
    for (int p = first; p < last; ++p) found |= beyond(p);
    any[static_cast<std::size_t>(piece)] = found;
  });
  std::vector<int> found;
  for (std::size_t piece = 0; piece < any.size(); ++piece) {
    if (!any[piece]) continue;
    const int first = static_cast<int>(piece) * stretch;
    for (int p = first; p < std::min(first + stretch, count); ++p) {
      if (beyond(p)) found.push_back(p);
    }
  }
  return found;
}

class Splitter {
 public:
  Splitter(const Scene& scene, Body& body, double time, Ledger& ledger)
      : grid_(scene.grid),
        body_(body),
        ledger_(ledger),
        affine_(body.points.has(column::affine)),
        inertia_(inertia_of(scene.shape) * grid_.h * grid_.h) {
    for (int d = 0; d < grid_.dim; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      low_[d] = grid_.origin[axis];
      high_[d] = grid_.origin[axis] + grid_.h * grid_.cells[axis];
    }
    for (const Piston& piston : scene.pistons) {
      const double face = piston.place_at(time);
      double& side = piston.side == 0 ? low_[piston.direction] : high_[piston.direction];
      side = piston.side == 0 ? std::max(side, face) : std::min(side, face);
    }
  }

  // Of the points that are too large, those that still grow, by more than rounding. Gas that is squeezed, or only moves,
  // is thin at a free surface alone, and only in the eyes of a kernel that sees vacuum there. Nor does it help a gas so
  // cold that no signal crosses a cell while it doubles: its points fly apart whether there are two or one. What was
  // halved often is spray at the edge of vacuum, whose motion becomes heat.
  std::vector<int> growing(std::vector<int> points) const {
    const std::vector<int> halved = halvings();
    std::erase_if(points, [&](int p) {
      if (halved[static_cast<std::size_t>(body_.id[static_cast<std::size_t>(p)])] >= most_halvings) return true;
      if (!affine_) return false;
      const int n = direction(p);
      const double stretch = c(p, n, n) * grid_.h, v = speed(p);
      const double sound = body_.material->step_bounds(body_.points, {p, p + 1}, grid_.dim).fastest - v;
      return !(stretch > 0 && stretch < sound && expansion(p) * grid_.h > 1e-9 * v);
    });
    return points;
  }

  void split(const std::vector<int>& parents) {
    const int before = body_.points.points();
    body_.points.append_copies(parents);
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const int parent = parents[k], child = before + static_cast<int>(k);
      body_.split_from.push_back(body_.id[static_cast<std::size_t>(parent)]);
      body_.id.push_back(child);
      part(parent, child);
    }
  }

 private:
  static constexpr int most_halvings = 3;  // reports/docs/theory/gases.md, "Points that outgrow the kernel", says why

  // By id: how often a point, and what it comes from, was split.
  std::vector<int> halvings() const {
    std::vector<int> times(static_cast<std::size_t>(body_.points.points()), 0);
    std::size_t half = times.size() - body_.split_from.size();
    for (const int parent : body_.split_from) times[half++] = ++times[static_cast<std::size_t>(parent)];
    return times;
  }

  double c(int p, int row, int column) const {
    return affine_ ? body_.points(column::affine, row * grid_.dim + column)[p] : 0.0;
  }

  double speed(int p) const {
    double square = 0;
    for (int d = 0; d < grid_.dim; ++d) square += std::pow(body_.points(column::velocity, d)[p], 2);
    return std::sqrt(square);
  }

  // Rate at which the point's volume grows, 1/s: the trace of C, and of a ring v_r / r.
  double expansion(int p) const {
    double rate = 0;
    for (int d = 0; d < grid_.dim; ++d) rate += c(p, d, d);
    const double r = body_.points(column::position)[p];
    return grid_.axisymmetric && r > 0 ? rate + body_.points(column::velocity)[p] / r : rate;
  }

  int direction(int p) const {
    if (!affine_) return body_.id[static_cast<std::size_t>(p)] % grid_.dim;
    int widest = 0;
    for (int d = 1; d < grid_.dim; ++d) {
      if (c(p, d, d) > c(p, widest, widest)) widest = d;
    }
    return widest;
  }

  void part(int p, int q) {
    Columns& points = body_.points;
    const int n = direction(p);
    double* x = points(column::position, n);
    double volume = points(column::volume)[p];
    if (grid_.axisymmetric) volume /= std::max(points(column::position)[p], grid_.h / 2);
    const double distance = std::max(0.0, std::min(x[p] - low_[n], high_[n] - x[p]));
    const double d = std::min({std::pow(volume, 1.0 / grid_.dim) / 4, std::sqrt(inertia_), distance});
    const double s = std::sqrt(std::max(0.0, 1 - d * d / inertia_));
    for (const ColumnId* id : {&column::mass, &column::volume}) {
      points(*id)[p] /= 2;
      points(*id)[q] = points(*id)[p];
    }
    book_spin(p, n, 2 * points(column::mass)[p] * inertia_ * s * (1 - s));
    x[p] -= d;  // [Splitting 1]
    x[q] += d;
    for (int row = 0; affine_ && row < grid_.dim; ++row) {
      const double apart = d * c(p, row, n);
      points(column::velocity, row)[p] -= apart;  // [Splitting 1]
      points(column::velocity, row)[q] += apart;
      double* stretch = points(column::affine, row * grid_.dim + n);
      stretch[p] *= s;  // [Splitting 2]
      stretch[q] = stretch[p];
    }
  }

  // [Splitting 3]; amount: m D s (1 - s).
  void book_spin(int p, int n, double amount) {
    if (!affine_ || grid_.axisymmetric || grid_.dim == 1) return;
    for (int k = 0; k < (grid_.dim == 2 ? 1 : 3); ++k) {
      const int a = grid_.dim == 2 ? 0 : rotation_axis<3>(k, 0), b = grid_.dim == 2 ? 1 : rotation_axis<3>(k, 1);
      const double turn = (a == n ? c(p, b, n) : 0.0) - (b == n ? c(p, a, n) : 0.0);
      const std::size_t about = grid_.dim == 2 ? 2 : static_cast<std::size_t>(k);
      ledger_.angular_momentum[about].book(Flow::integration, amount * turn);
    }
  }

  const GridSpec& grid_;
  Body& body_;
  Ledger& ledger_;
  bool affine_;
  double inertia_;  // D, m^2
  double low_[3]{}, high_[3]{};
};

}  // namespace

std::string splitting_refusal(const std::string& shape, const std::string& transfer) {
  if (!transfer_of(transfer, 1).affine || shape_offers(shape, Trait::constant_inertia)) return {};
  return "halves take over the point's affine velocity, whose inertia under " + shape +
         " shapes depends on where they stand";
}

int split_points(Scene& scene, double time, int threads, Ledger& ledger) {
  if (scene.split <= 0) return 0;
  const double largest = scene.split * std::pow(scene.grid.h, scene.grid.dim);
  int came = 0;
  for (Body& body : scene.bodies) {
    if (!body.material->has_density() || body.points.points() == 0) continue;
    const std::vector<int> large = outgrown(body.points, scene.grid, largest, threads);
    if (large.empty()) continue;
    Splitter splitter(scene, body, time, ledger);
    const std::vector<int> parents = splitter.growing(large);
    if (parents.empty()) continue;
    splitter.split(parents);
    came += static_cast<int>(parents.size());
  }
  return came;
}

}  // namespace plumbline
