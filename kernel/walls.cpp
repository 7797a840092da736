#include "kernel/walls.hpp"

#include <cstdlib>

namespace plumbline {
namespace {

template <int dim>
Eigen::Matrix<double, dim, 1> mirrored(Eigen::Matrix<double, dim, 1> value, int normal, bool no_slip) {
  if (no_slip) return -value;
  value[normal] = -value[normal];
  return value;
}

template <int dim>
Eigen::Matrix<double, dim, 1> constrained(Eigen::Matrix<double, dim, 1> value, int normal, bool no_slip) {
  if (no_slip) return Eigen::Matrix<double, dim, 1>::Zero();
  value[normal] = 0.0;
  return value;
}

}  // namespace

template <int dim>
template <class Ghost, class OnWall>
void Walls<dim>::for_walls(const VelocityField<dim>& field, int d, Ghost&& ghost, OnWall&& wall) const {
  for (int side = 0; side < 2; ++side) {
    if (grid_.wall(d, side) == Wall::free) continue;
    const bool no_slip = grid_.wall(d, side) == Wall::no_slip;
    const int outward = side == 0 ? -1 : 1;
    const int line = side == 0 ? Grid<dim>::ghosts : grid_.nodes(d) - 1 - Grid<dim>::ghosts;
    if (d == 0) {
      for (int row = 0; row < grid_.rows(); ++row) {
        const auto [first, last] = field.touched[static_cast<std::size_t>(row)];
        const int base = row * grid_.row_length();
        const int g = line + outward;
        if (g >= first && g < last) ghost(base + g, base + line - outward, no_slip);
        if (line >= first && line < last) wall(base + line, no_slip);
      }
    } else if constexpr (dim > 1) {
      // Ghosts of lower directions are theirs: they fold them before, and fill them after, in these rows too.
      const int low = grid_.wall(0, 0) == Wall::free ? 0 : Grid<dim>::ghosts;
      const int high = grid_.nodes(0) - (grid_.wall(0, 1) == Wall::free ? 0 : Grid<dim>::ghosts);
      const int length = grid_.row_length(), step = grid_.stride(d) / length;  // rows from line to line
      const auto for_row = [&](int row, auto&& visit) {
        const auto [first, last] = field.touched[static_cast<std::size_t>(row)];
        for (int i = std::max(first, low); i < std::min(last, high); ++i) visit(row * length + i);
      };
      for (int row = 0; row < grid_.rows(); ++row) {
        if (grid_.row_index(row, d) != line || ghost_of_lower(row, d)) continue;
        const int inward = -2 * outward * step * length;
        for_row(row + outward * step, [&](int i) { ghost(i, i + inward, no_slip); });
        for_row(row, [&](int i) { wall(i, no_slip); });
      }
    }
  }
}

// Whether a row lies beyond a wall of a direction in 1 ... d-1.
template <int dim>
bool Walls<dim>::ghost_of_lower(int row, int d) const {
  for (int e = 1; e < d; ++e) {
    const int index = grid_.row_index(row, e);
    if (index < Grid<dim>::ghosts && grid_.wall(e, 0) != Wall::free) return true;
    if (index > grid_.nodes(e) - 1 - Grid<dim>::ghosts && grid_.wall(e, 1) != Wall::free) return true;
  }
  return false;
}

template <int dim>
void Walls<dim>::include_mirrors(std::vector<std::pair<int, int>>& touched) const {
  for (int side = 0; side < 2; ++side) {
    if (grid_.wall(0, side) == Wall::free) continue;
    const int line = side == 0 ? Grid<dim>::ghosts : grid_.nodes(0) - 1 - Grid<dim>::ghosts;
    for (auto& [first, last] : touched) {
      if (first >= last) continue;
      if (side == 0 && first < line) last = std::max(last, 2 * line - first + 1);
      if (side == 1 && last - 1 > line) first = std::min(first, 2 * line - (last - 1));
    }
  }
  for (int d = 1; d < dim; ++d) {
    for (int side = 0; side < 2; ++side) {
      if (grid_.wall(d, side) == Wall::free) continue;
      const int beyond = side == 0 ? 0 : grid_.nodes(d) - 1;
      const int inward = (side == 0 ? 2 : -2) * grid_.stride(d) / grid_.row_length();
      for (int row = 0; row < grid_.rows(); ++row) {
        if (grid_.row_index(row, d) != beyond) continue;
        const auto ghosts = touched[static_cast<std::size_t>(row)];
        auto& inside = touched[static_cast<std::size_t>(row + inward)];
        if (ghosts.first >= ghosts.second) continue;
        if (inside.first >= inside.second) inside = ghosts;
        inside = {std::min(inside.first, ghosts.first), std::max(inside.second, ghosts.second)};
      }
    }
  }
}

template <int dim>
void Walls<dim>::fold_mass(VelocityField<dim>& field) const {
  fold_even(field, field.mass);
}

template <int dim>
void Walls<dim>::fold_even(const VelocityField<dim>& field, std::vector<double>& values) const {
  for (int d = 0; d < dim; ++d) {
    for_walls(
        field, d,
        [&](int g, int m, bool) { values[static_cast<std::size_t>(m)] += values[static_cast<std::size_t>(g)]; },
        [](int, bool) {});
  }
}

template <int dim>
WallAction<dim> Walls<dim>::fold(const VelocityField<dim>& field, std::vector<Vec>& values) const {
  WallAction<dim> action;
  for (int d = 0; d < dim; ++d) {
    for_walls(
        field, d,
        [&](int g, int m, bool no_slip) {
          const Vec beyond = values[static_cast<std::size_t>(g)];
          const Vec folded = mirrored<dim>(beyond, d, no_slip);
          values[static_cast<std::size_t>(m)] += folded;
          values[static_cast<std::size_t>(g)].setZero();
          action.linear += folded - beyond;
          action.angular += cross<dim>(grid_.position(m), folded) - cross<dim>(grid_.position(g), beyond);
        },
        [&](int w, bool no_slip) {
          Vec& value = values[static_cast<std::size_t>(w)];
          const Vec kept = constrained<dim>(value, d, no_slip);
          action.linear += kept - value;
          action.angular += cross<dim>(grid_.position(w), Vec(kept - value));
          value = kept;
        });
  }
  return action;
}

template <int dim>
void Walls<dim>::extend(const VelocityField<dim>& field, std::vector<Vec>& velocity) const {
  for (int d = dim - 1; d >= 0; --d) {
    for_walls(
        field, d,
        [&](int g, int m, bool no_slip) {
          velocity[static_cast<std::size_t>(g)] = mirrored<dim>(velocity[static_cast<std::size_t>(m)], d, no_slip);
        },
        [&](int w, bool no_slip) {
          velocity[static_cast<std::size_t>(w)] = constrained<dim>(velocity[static_cast<std::size_t>(w)], d, no_slip);
        });
  }
}

template <int dim>
void Walls<dim>::extend_even(const VelocityField<dim>& field, std::vector<double>& values) const {
  for (int d = dim - 1; d >= 0; --d) {
    for_walls(
        field, d,
        [&](int g, int m, bool) { values[static_cast<std::size_t>(g)] = values[static_cast<std::size_t>(m)]; },
        [](int, bool) {});
  }
}

template <int dim>
void Walls<dim>::extend_flow(const VelocityField<dim>& field, std::vector<Vec>& faces,
                             std::vector<Vec>& stretch) const {
  for (int d = dim - 1; d >= 0; --d) {
    for_walls(
        field, d,
        [&](int g, int m, bool) {
          const auto ghost = static_cast<std::size_t>(g), mirror = static_cast<std::size_t>(m);
          const int below = m -
                            std::abs(g - m) / 2;  // the face above it is what the one above the ghost is an image of
          faces[ghost] = faces[mirror];
          faces[ghost][d] = -faces[static_cast<std::size_t>(below)][d];
          stretch[ghost] = stretch[mirror];
        },
        [](int, bool) {});
  }
}

template <int dim>
WallAction<dim> Walls<dim>::extension_impulse(const VelocityField<dim>& field, const std::vector<Vec>& u) const {
  // Folding moved masses direction by direction; a ghost of the second direction passed on what it got from the first,
  // so the masses met here are the ones that were moved.
  WallAction<dim> action;
  for (int d = 0; d < dim; ++d) {
    for_walls(
        field, d,
        [&](int g, int m, bool) {
          const double mass = field.mass[static_cast<std::size_t>(g)];
          const Vec beyond = mass * u[static_cast<std::size_t>(g)], inside = mass * u[static_cast<std::size_t>(m)];
          action.linear += beyond - inside;
          action.angular += cross<dim>(grid_.position(g), beyond) - cross<dim>(grid_.position(m), inside);
        },
        [](int, bool) {});
  }
  return action;
}

template class Walls<1>;
template class Walls<2>;
template class Walls<3>;

}  // namespace plumbline
