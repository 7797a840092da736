// Pressures of gases as points read them off the grid. What presses on the nodes is V_p p_p = (gamma - 1) m_p e_p of many points, and it is
// even where densities and energies jump and the pressure does not; a point's own energy times a density that maps have spread is not.
//   p_i = sum_p V_p p_p N_ip / |cell_i|, sharpened to p^_i as densities are [Read-off 1],
//   p_p <- p_p + sum_i N_ip chi_i (p^_i - p_p),  chi_i as [Quadrature 1] has it, eps = 0.3.                    [Read-off 2]
// Where pressures vary within three nodes, in shocks, steep expansions and at the edge of a gas in vacuum, what maps smooth is
// the larger error, and points keep their own. No step sees it: stresses are evaluated anew.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/density/read_off.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/neighbours.hpp"
#include "kernel/pressure_quadrature.hpp"

namespace plumbline {

template <class Geometry>
class Pressures {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Field = typename Space::Field;

  // sharpening: how much of the maps' smoothing is undone, as of densities.
  Pressures(const Space& space, DensityMethod method, double sharpening)
      : space_(space),
        read_off_(space.grid, sharpening * space.shape.blur),
        method_(method) {}

  // Of a gas whose column `pressure`, if it has one, is that of its energies and volumes. Enclosed gas, whose volumes are no cells',
  // keeps it.
  void read(Body& body, const Weights<dim>& at, const Field& field) {
    const bool gas = body.material->has_density() && body.points.has(column::pressure);
    if (!gas || method_ != DensityMethod::grid || body.enclosure || at.kept()) return;
    std::vector<double> nodal(field.mass.size(), 0.0);
    double* const pressure = body.points(column::pressure);
    const std::array<typename Space::Loops::Spread, 1> sums{{{pressure, body.points(column::volume), nodal.data(), 1}}};
    space_.spread(body.points, at, sums);
    space_.walls.fold_even(field, nodal);
    field.for_touched(
        space_.grid, [&](std::size_t i) { nodal[i] *= space_.inverse_volumes[i]; }, space_.threads);
    std::vector<double> share = shares(field, nodal);
    read_off_.apply(field, nodal, space_.threads);
    field.for_touched(
        space_.grid, [&](std::size_t i) { nodal[i] *= share[i]; }, space_.threads);
    space_.walls.extend_even(field, nodal);
    space_.walls.extend_even(field, share);
    const auto points = static_cast<std::size_t>(body.points.points());
    std::vector<double> read(points), taken(points);
    const std::array<typename Space::Loops::Gather, 2> reads{
        {{nodal.data(), 1, read.data()}, {share.data(), 1, taken.data()}}};
    space_.gather(body.points, at, reads);
    for (std::size_t p = 0; p < points; ++p) pressure[p] = read[p] + (1 - taken[p]) * pressure[p];
  }

 private:
  static constexpr double evenness = 0.3;
  static constexpr int reach = 3;  // nodes whose kernels overlap

  // chi of each node, from pressures as mapped. Beyond a body's edge there is none, and nothing is even.
  std::vector<double> shares(const Field& field, const std::vector<double>& mapped) const {
    std::vector<double> low = mapped, high = mapped, next_low(mapped.size()), next_high(mapped.size());
    for (int step = 0; step < dim * reach; ++step) {
      next_low = low;
      next_high = high;
      for_sides(space_.grid, field, space_.threads, [&](int node, int d, const Side& below, const Side& above) {
        if (d != step / reach) return;
        const auto i = static_cast<std::size_t>(node), under = static_cast<std::size_t>(below.node),
                   over = static_cast<std::size_t>(above.node);
        next_low[i] = std::min(next_low[i], std::min(below.share * low[under], above.share * low[over]));
        next_high[i] = std::max(next_high[i], std::max(below.share * high[under], above.share * high[over]));
      });
      std::swap(low, next_low);
      std::swap(high, next_high);
    }
    field.for_touched(
        space_.grid, [&](std::size_t i) { next_low[i] = even_share(low[i], high[i], evenness); }, space_.threads);
    return next_low;
  }

  const Space& space_;
  ReadOff<dim> read_off_;
  DensityMethod method_;
};

}  // namespace plumbline
