// Pressures of gases as points read them off the grid. What presses on the nodes is V_p p_p = (gamma - 1) m_p e_p of many points, and it is
// even where densities and energies jump and the pressure does not; a point's own energy times a density that maps have spread is not.
//   p_i = sum_p V_p p_p N_ip / |cell_i|, sharpened as densities are [Read-off 1],  p_p <- sum_i N_ip p_i     [Read-off 2]
// No step sees it: stresses are evaluated anew.
#pragma once

#include <array>
#include <vector>

#include "kernel/density/read_off.hpp"
#include "kernel/engine/layout.hpp"

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
    read_off_.apply(field, nodal, space_.threads);
    space_.walls.extend_even(field, nodal);
    const std::array<typename Space::Loops::Gather, 1> read{{{nodal.data(), 1, pressure}}};
    space_.gather(body.points, at, read);
  }

 private:
  const Space& space_;
  ReadOff<dim> read_off_;
  DensityMethod method_;
};

}  // namespace plumbline
