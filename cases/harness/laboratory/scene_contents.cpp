#include "cases/harness/laboratory/scene_contents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace plumbline {
namespace {

using Matter = SceneContents::Matter;
using Cell = std::array<int, 3>;
using Place = std::array<double, 3>;  // in cells from the lowest node lines

constexpr double rounding = 1e-6;  // of a point's box, in shares of its width

Matter matter_of(const Material& material) {
  if (material.has_density()) return Matter::gas;
  return material.chain() ? Matter::chain : Matter::solid;
}

// Which cells of the grid the bodies of one velocity field fill.
class Filling {
 public:
  Filling(const Scene& scene, const std::string& field) : scene_(scene), grid_(scene.grid) {
    for (int d = 0; d < grid_.dim; ++d) stride_[at(d + 1)] = stride_[at(d)] * grid_.cells[at(d)];
    filled_.assign(static_cast<std::size_t>(stride_[at(grid_.dim)]), false);
    for (const Body& body : scene.bodies) {
      if (body.field == field) fill(body);
    }
  }

  // Whether the body ends where neither a wall, a piston nor the others of its field go on.
  bool ends_free(const Body& body) const {
    if (matter_of(*body.material) == Matter::chain) return chain_ends_free(body);
    bool free = false;
    for_cells_of(body, [&](const Cell& cell) {
      for (int d = 0; d < grid_.dim; ++d) {
        for (const int side : {-1, 1}) {
          Cell beyond = cell;
          beyond[at(d)] += side;
          free = free || is_open(beyond);
        }
      }
    });
    return free;
  }

 private:
  static std::size_t at(int d) { return static_cast<std::size_t>(d); }

  Place place(const Body& body, int p) const {
    Place x{};
    for (int d = 0; d < grid_.dim; ++d) {
      x[at(d)] = (body.points(column::position, d)[p] - grid_.origin[at(d)]) / grid_.h;
    }
    return x;
  }
  Cell cell_of(const Place& x) const {
    Cell cell{};
    for (int d = 0; d < grid_.dim; ++d) cell[at(d)] = static_cast<int>(std::floor(x[at(d)]));
    return cell;
  }
  bool inside(const Cell& cell) const {
    for (int d = 0; d < grid_.dim; ++d) {
      if (cell[at(d)] < 0 || cell[at(d)] >= grid_.cells[at(d)]) return false;
    }
    return true;
  }
  std::size_t index(const Cell& cell) const {
    int sum = 0;
    for (int d = 0; d < grid_.dim; ++d) sum += cell[at(d)] * stride_[at(d)];
    return static_cast<std::size_t>(sum);
  }

  // The cells of the grid that a point's box lies in, of each point in turn; of a chain those that its points stand in.
  template <class Visit>
  void for_cells_of(const Body& body, const Visit& visit) const {
    const bool chain = matter_of(*body.material) == Matter::chain;
    for (int p = 0; p < body.points.points(); ++p) {
      const double spacing = point_spacing(body, p, grid_.dim, grid_.axisymmetric) / grid_.h;
      const double half = chain ? 0 : 0.5 * spacing * (1 - rounding);
      Place low = place(body, p), high = low;
      for (int d = 0; d < grid_.dim; ++d) {
        low[at(d)] -= half;
        high[at(d)] += half;
      }
      const Cell first = cell_of(low), last = cell_of(high);
      for (int i = first[0]; i <= last[0]; ++i) {
        for (int j = first[1]; j <= last[1]; ++j) {
          for (int k = first[2]; k <= last[2]; ++k) {
            if (inside({i, j, k})) visit(Cell{i, j, k});
          }
        }
      }
    }
  }
  void fill(const Body& body) {
    for_cells_of(body, [&](const Cell& cell) { filled_[index(cell)] = true; });
  }

  bool behind_piston(const Cell& cell) const {
    return std::any_of(scene_.pistons.begin(), scene_.pistons.end(), [&](const Piston& piston) {
      const double plane = (piston.position - grid_.origin[at(piston.direction)]) / grid_.h;
      const double middle = cell[at(piston.direction)] + 0.5;
      return piston.side == 0 ? middle < plane : middle > plane;
    });
  }

  // Nothing there that would keep a node between this cell and its neighbour heavy, or still.
  bool is_open(const Cell& cell) const {
    for (int d = 0; d < grid_.dim; ++d) {
      const int side = cell[at(d)] < 0 ? 0 : 1;
      if (cell[at(d)] >= 0 && cell[at(d)] < grid_.cells[at(d)]) continue;
      return grid_.walls[at(d)][at(side)] == Wall::free && !behind_piston(cell);
    }
    return !filled_[index(cell)] && !behind_piston(cell);
  }

  // A cell beyond either end, straight on. The next cell is that of a closed chain's other end.
  bool chain_ends_free(const Body& body) const {
    const int last = body.points.points() - 1;
    if (last == 0) return true;
    const auto ends_at = [&](int end, int before) {
      const Place x = place(body, end), y = place(body, before);
      double length = 0;
      for (int d = 0; d < grid_.dim; ++d) length += (x[at(d)] - y[at(d)]) * (x[at(d)] - y[at(d)]);
      Place beyond = x;
      for (int d = 0; d < grid_.dim; ++d) beyond[at(d)] += (x[at(d)] - y[at(d)]) / std::sqrt(length);
      return is_open(cell_of(beyond));
    };
    return ends_at(0, 1) || ends_at(last, last - 1);
  }

  const Scene& scene_;
  const GridSpec& grid_;
  std::array<int, 4> stride_{1, 0, 0, 0};
  std::vector<bool> filled_;
};

// Of the widest points. Those hardly wider than their share of a cell count as in it.
int fewest_per_cell(const Body& body, const GridSpec& grid) {
  double widest = 0;
  for (int p = 0; p < body.points.points(); ++p) {
    widest = std::max(widest, point_spacing(body, p, grid.dim, grid.axisymmetric));
  }
  constexpr double hardly = 0.1;
  return std::clamp(static_cast<int>(std::floor(grid.h / widest + hardly)), 1, SceneContents::most_per_cell);
}

SceneContents::Part part_of(const Body& body, const GridSpec& grid) {
  SceneContents::Part part;
  part.body = body.name;
  part.matter = matter_of(*body.material);
  part.per_cell = fewest_per_cell(body, grid);
  part.segments = body.material->measure() == StressMeasure::point_force;
  Columns still = body.points;
  for (int d = 0; d < grid.dim; ++d) {
    std::fill_n(still(column::velocity, d), still.points(), 0.0);
  }
  const StepBounds bounds = body.material->step_bounds(still, all_points(still), grid.dim);
  part.speed = bounds.fastest;
  part.diffusivity = bounds.diffusivity;
  return part;
}

// The middle one of all points' masses over what `share` gives: what hangs on single points does not count.
template <class Share>
double middle_mass(const Body& body, const Share& share) {
  std::vector<double> all;
  for (int p = 0; p < body.points.points(); ++p) all.push_back(body.points(column::mass)[p] / share(p));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

SceneContents::Coupling coupling_of(const Body& gas, const Body& chain, const GridSpec& grid) {
  SceneContents::Coupling found{part_of(gas, grid), part_of(chain, grid)};
  const double density = middle_mass(gas, [&](int p) { return gas.points(column::volume)[p]; });
  // per length of the chain; around the axis per radian
  const double line = middle_mass(chain, [&](int p) {
    const double around = grid.axisymmetric ? std::max(chain.points(column::position)[p], grid.h) : 1.0;
    return point_spacing(chain, p, grid.dim, grid.axisymmetric) * around;
  });
  const double speeds = found.chain.speed / found.gas.speed;
  found.density_ratio = line / (density * std::pow(grid.h, grid.dim - 1));
  found.stiffness_ratio = found.density_ratio * speeds * speeds;
  return found;
}

}  // namespace

std::vector<SceneContents::Part> SceneContents::of(Matter matter) const {
  std::vector<Part> found;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(found),
               [&](const Part& part) { return part.matter == matter; });
  return found;
}

SceneContents contents_of(const Scene& scene) {
  SceneContents contents;
  contents.dim = scene.grid.dim;
  contents.axisymmetric = scene.grid.axisymmetric;
  contents.h = scene.grid.h;
  std::set<std::string> fields;
  for (const Body& body : scene.bodies) {
    if (body.points.points() > 0) fields.insert(body.field);
  }
  contents.contact = scene.contact != "none" && fields.size() > 1;
  for (const std::string& field : fields) {
    const Filling filling(scene, field);
    for (const Body& body : scene.bodies) {
      if (body.field != field || body.points.points() == 0) continue;
      contents.parts.push_back(part_of(body, scene.grid));
      contents.parts.back().free_edge = filling.ends_free(body);
      for (const Body& other : scene.bodies) {
        if (other.field != field || other.points.points() == 0) continue;
        if (matter_of(*body.material) != Matter::gas || matter_of(*other.material) != Matter::chain) continue;
        contents.couplings.push_back(coupling_of(body, other, scene.grid));
      }
    }
  }
  return contents;
}

}  // namespace plumbline
