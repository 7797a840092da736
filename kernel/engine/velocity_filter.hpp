// w of the transfers xpic and fmpm: the velocity whose smoothing by a map is undone by m terms. [XPIC 1] [FMPM 1]
#pragma once

#include <array>
#include <vector>

#include "kernel/engine/discretisation.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

template <class Geometry>
class VelocityFilter {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Vec = typename Space::Vec;
  using Field = typename Space::Field;
  // Points of the field, and where they stand.
  using Group = std::vector<std::pair<const Columns*, const Weights<dim>*>>;

  explicit VelocityFilter(const Space& space) : space_(space) {}

  bool none() const { return space_.transfer.order == 0; }

  // Sets field.corrected.filtered from its start and end. Its momentum is that of the grid but for what walls give meanwhile: `given`
  // and the turn of it are added to.
  void apply(const Group& group, Field& field, Vec& given, Spin<dim>& turn) const {
    const bool of_end = space_.transfer.filters_end;
    std::vector<Vec> left = of_end ? field.end : field.start, passed(left.size(), Vec::Zero());
    field.corrected.filtered = left;
    for (int j = 1; j < space_.transfer.order; ++j) {
      pass_to_points_and_back(group, field, left, passed);
      field.for_touched(space_.grid, [&](std::size_t i) {
        left[i] -= passed[i];
        field.corrected.filtered[i] += left[i];  // [XPIC 1] [FMPM 1]
      });
    }
    field.for_touched(space_.grid, [&](std::size_t i) {
      if (!of_end) field.corrected.filtered[i] += field.end[i] - field.start[i];  // [XPIC 1]
    });
    space_.walls.extend(field, field.corrected.filtered);
    field.for_touched(space_.grid, [&](std::size_t i) {
      const Vec change = field.unfolded.mass[i] * (field.corrected.filtered[i] - field.end[i]);
      given += change;
      turn += cross<dim>(space_.grid.position(static_cast<int>(i)), change);
    });
  }

 private:
  // to = P from: what the nodes have of `from` after it went to the points and back.
  void pass_to_points_and_back(const Group& group, Field& field, const std::vector<Vec>& from,
                               std::vector<Vec>& to) const {
    field.for_touched(space_.grid, [&](std::size_t i) { field.momentum[i].setZero(); });
    for (const auto& [points, at] : group) {
      const int n = points->points();
      std::vector<double> seen(static_cast<std::size_t>(dim * n + lanes));
      std::array<typename Space::Loops::Gather, dim> there;
      std::array<typename Space::Loops::Spread, dim> back;
      for (int d = 0; d < dim; ++d) {
        const auto k = static_cast<std::size_t>(d);
        there[k] = {component(from, d), dim, seen.data() + d * n};
        back[k] = {seen.data() + d * n, (*points)(column::mass), component(field.momentum, d), dim};
      }
      space_.gather(*points, *at, there);
      space_.spread(*points, *at, back);
    }
    space_.walls.fold(field, field.momentum);
    space_.divide_by_mass(field, field.momentum, to);
  }

  const Space& space_;
};

}  // namespace plumbline
