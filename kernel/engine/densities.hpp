// Densities by the scene's method. Those of the grid:
//   rho_i = M_i / |cell_i|, V_p = m_p / sum_i N_ip rho_i [EC-APIC 2]
// and of an enclosed gas the inverse, v_i = |cell_i| / M_i with what of the cell lies inside, V_p = m_p sum_i N_ip v_i:
// volumes of points then sum to the enclosed one, whatever the points' places. [Coupling 4]
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "kernel/density/cell_density.hpp"
#include "kernel/density/read_off.hpp"
#include "kernel/engine/placing.hpp"

namespace plumbline {

template <class Geometry>
class Densities {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Field = typename Space::Field;

  // sharpening: how much of the maps' smoothing is undone, as of forces.
  Densities(const Space& space, DensityMethod method, double sharpening = 0)
      : space_(space),
        placing_(space),
        read_off_(space.grid, sharpening * space.shape.blur),
        method_(method) {}

  // What the points of a body take their volumes from.
  struct Source {
    const std::vector<double>* nodes = nullptr;  // null: not from nodes
    bool specific = false;                       // `nodes` are specific volumes
    std::optional<Weights<dim>> elsewhere;  // where the points stand now, if they have moved since they were located
  };

  // Finds the nodal densities, or sets the points' own where the method needs no nodes of the step. own_mass: the mass on
  // the field's nodes, or of its gas, is that of this body alone.
  Source find(const std::vector<Body>& bodies, Body& body, const Weights<dim>& at, Field& field, bool own_mass) {
    if (!body.material->has_density() || method_ == DensityMethod::continuity) return {};
    if (method_ != DensityMethod::grid) {
      cell_density<dim>(space_.grid, body.points, method_ == DensityMethod::quadratic);
      return {};
    }
    Source source;
    if (at.kept()) source.elsewhere = placing_.here(body);
    Field* of = &field;
    if (at.kept() || !own_mass) {
      if (!own_field_) own_field_.emplace(space_.grid, Field::Holding::mass);
      of = &*own_field_;
      map_own_mass(body.points, source.elsewhere ? *source.elsewhere : at, *of);
    }
    find_nodal(bodies, body, of == &field ? field.mass_of_gas() : of->mass, *of);
    source.nodes = &of->gas.density;
    source.specific = body.enclosure.has_value();
    return source;
  }

 private:
  void map_own_mass(const Columns& points, const Weights<dim>& at, Field& field) const {
    space_.touch_alone(at, field);
    const typename Space::Loops::Spread mass[] = {{points(column::mass), nullptr, field.mass.data(), 1}};
    space_.spread(points, at, mass);
    space_.walls.fold_mass(field);
  }

  void find_nodal(const std::vector<Body>& bodies, const Body& body, const std::vector<double>& mass, Field& field) {
    if (body.enclosure) {
      space_.loops->find_enclosed_volumes(chain_of(bodies, body).points, body.enclosure->corners, enclosed_);
      space_.walls.fold_even(field, enclosed_);
    }
    std::vector<double>& density = field.held(field.gas.density);
    field.for_touched(
        space_.grid,
        [&](std::size_t i) {
          density[i] = !body.enclosure        ? mass[i] * space_.inverse_volumes[i]
                       : mass[i] > least_mass ? enclosed_[i] / mass[i]
                                              : 0.0;
        },
        space_.threads);
    if (!body.enclosure) read_off_.apply(field, density, space_.threads);
    space_.walls.extend_even(field, density);
  }

  static const Body& chain_of(const std::vector<Body>& bodies, const Body& body) {
    const auto chain = std::find_if(bodies.begin(), bodies.end(),
                                    [&](const Body& other) { return other.name == body.enclosure->chain; });
    if (chain != bodies.end()) return *chain;
    throw std::invalid_argument("body " + body.name + " names the enclosure " + body.enclosure->chain +
                                ", which is no body of the scene");
  }

  const Space& space_;
  Placing<Geometry> placing_;
  ReadOff<dim> read_off_;
  DensityMethod method_;
  std::vector<double> enclosed_;    // |cell_i| inside the enclosure last asked for
  std::optional<Field> own_field_;  // one body's mass alone
};

}  // namespace plumbline
