// Two bodies side by side along x, from wall to wall, whose nodes are given random velocities; and what contact makes of them.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "cases/harness/parts/probe_random.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/engine/placing.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {

// At the start of the step and at its end without contact. Speeds are about one; along x, approaching and parting bodies have 0.5
// to 1.5 of it against each other, and all else is at most 0.3.
enum class Motion { approaching, parting, any };

template <int dim>
class Encounter {
 public:
  using Geometry = std::conditional_t<dim == 1, Line, std::conditional_t<dim == 2, Plane, Solid>>;
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Fields = std::vector<VelocityField<dim>>;
  using Changes = std::vector<ContactChange<dim>>;

  // What one force pass is before contact and after, and the changes that contact told.
  struct Pass {
    Fields before, after;
    Changes told;
  };

  explicit Encounter(const ContactEntry& law) : scene_(two_blocks()), space_(scene_, 1) {
    law_ = std::get<MakeContact<dim>>(law.make)(space_.grid, space_.shape.support);
    for (const Body& body : scene_.bodies) fields_.push_back(mapped(body));
  }

  const Grid<dim>& grid() const { return space_.grid; }

  // The first pass of a step.
  Pass meet(Motion motion, ProbeRandom& random) {
    for (std::size_t f = 0; f < fields_.size(); ++f) set_velocities(fields_[f], sign(motion, f), random);
    if (law_) law_->find(scene_, {0, 1}, fields_);
    return apply(true);
  }
  // Another one of the same step, with velocities of another motion at its end.
  Pass meet_again(Motion motion, ProbeRandom& random) {
    for (std::size_t f = 0; f < fields_.size(); ++f) set_end(fields_[f], sign(motion, f), random);
    return apply(false);
  }
  // Velocities mapped anew; nothing is told of these.
  Pass remap(ProbeRandom& random) {
    for (VelocityField<dim>& field : fields_) {
      auto& remapped = field.held(field.remapped);
      for_nodes(field, [&](int node) { at(remapped, node) = velocity(node, 0, random); });
    }
    Pass pass{fields_, {}, {}};
    if (law_) law_->apply_to_remapped(fields_);
    pass.after = fields_;
    return pass;
  }

  // visit(node) for those with mass of the field, ghosts apart.
  template <class Visit>
  void for_nodes(const VelocityField<dim>& field, Visit&& visit) const {
    field.for_touched(space_.grid, [&](std::size_t i) {
      const int node = static_cast<int>(i);
      if (field.mass[i] > 1e-12 * largest_mass_ && on_grid(node)) visit(node);
    });
  }

 private:
  static Scene two_blocks() {
    Scene scene;
    scene.grid.dim = dim;
    scene.grid.h = 0.3;
    scene.grid.origin = {0.7, -0.4, 0.2};
    scene.grid.cells = {10, dim > 1 ? 4 : 1, dim > 2 ? 3 : 1};
    for (std::size_t d = 1; d < dim; ++d) scene.grid.walls[d] = {Wall::symmetry, Wall::symmetry};
    scene.bodies = {block("left", 1, scene.grid), block("right", 4.95, scene.grid)};
    return scene;
  }

  // Four cells along x from the one of number `first`, two points a cell and direction.
  static Body block(const std::string& name, double first, const GridSpec& grid) {
    const int along[3] = {8, 2 * grid.cells[1], 2 * grid.cells[2]};
    const int count = along[0] * (dim > 1 ? along[1] : 1) * (dim > 2 ? along[2] : 1);
    Body body = make_body(name, std::make_shared<NeoHookean>(), count, dim);
    body.field = name;
    body.spacing = grid.h / 2;
    for (int p = 0; p < count; ++p) {
      const int index[3] = {p % along[0], p / along[0] % along[1], p / (along[0] * along[1])};
      for (int d = 0; d < dim; ++d) {
        const double x = (d == 0 ? first : 0) + (index[d] + 0.5) / 2;
        body.points(column::position, d)[p] = grid.origin[static_cast<std::size_t>(d)] + x * grid.h;
      }
      body.points(column::volume)[p] = std::pow(body.spacing, dim);
      body.points(column::mass)[p] = (name == "left" ? 1 : 2) * body.points(column::volume)[p];
    }
    return body;
  }

  VelocityField<dim> mapped(const Body& body) {
    VelocityField<dim> field(space_.grid);
    const Weights<dim> weights = Placing<Geometry>(space_).here(body);
    space_.touch_alone(weights, field);
    space_.for_chunks_writing_nodes(weights, [&](const Chunk& chunk) {
      const typename Discretisation<Geometry>::Loops::Spread one{body.points(column::mass), nullptr, field.mass.data(),
                                                                 1};
      space_.loops->spread(body.points, weights, chunk, {&one, 1});
    });
    space_.walls.fold_mass(field);
    largest_mass_ = std::max(largest_mass_, *std::max_element(field.mass.begin(), field.mass.end()));
    return field;
  }

  static double sign(Motion motion, std::size_t field) {
    if (motion == Motion::any) return 0;
    return (motion == Motion::approaching) == (field == 0) ? 1 : -1;
  }
  static Vec& at(std::vector<Vec>& nodes, int node) { return nodes[static_cast<std::size_t>(node)]; }

  bool on_grid(int node) const {
    for (int d = 0; d < dim; ++d) {
      const int index = space_.grid.index(node, d) - Grid<dim>::ghosts;
      if (index < 0 || index > space_.grid.cells(d)) return false;
    }
    return true;
  }

  // sign: of the motion along x; 0: any.
  Vec velocity(int node, double sign, ProbeRandom& random) const {
    Vec v;
    for (int d = 0; d < dim; ++d) {
      const int index = space_.grid.index(node, d) - Grid<dim>::ghosts;
      const bool on_wall = d > 0 && (index == 0 || index == space_.grid.cells(d));
      v[d] = on_wall ? 0 : sign == 0 ? random(-1, 1) : d == 0 ? sign * random(0.5, 1.5) : random(-0.3, 0.3);
    }
    return v;
  }

  void set_velocities(VelocityField<dim>& field, double sign, ProbeRandom& random) {
    for_nodes(field, [&](int node) { at(field.start, node) = velocity(node, sign, random); });
    set_end(field, sign, random);
  }
  void set_end(VelocityField<dim>& field, double sign, ProbeRandom& random) {
    for_nodes(field, [&](int node) {
      at(field.end, node) = velocity(node, sign, random);
      at(field.midpoint, node) = 0.5 * (at(field.start, node) + at(field.end, node));
    });
  }

  Pass apply(bool decide) {
    Pass pass{fields_, {}, {}};
    const double dt = 0.1 * space_.grid.h();
    if (law_) law_->apply(fields_, dt, decide, [&](const ContactChange<dim>& c) { pass.told.push_back(c); });
    pass.after = fields_;
    return pass;
  }

  Scene scene_;
  Discretisation<Geometry> space_;
  std::unique_ptr<Contact<dim>> law_;
  Fields fields_;
  double largest_mass_ = 0;
};

}  // namespace plumbline
