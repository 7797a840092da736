// Set-up of an engine, and the stage that finds where points stand.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
Mechanics<G>::Mechanics(Scene& scene, Ledger& ledger, const EngineOptions& options)
    : scene_(scene),
      ledger_(ledger),
      options_(options),
      transfer_(transfer_choice(scene.transfer, scene.transfer_order)),
      loops_(make_point_loops<G>(scene, transfer_)),
      shape_(loops_->shape()),
      grid_(scene.grid),
      walls_(grid_),
      pistons_(scene),
      sharpening_(grid_, scene.sharpening * shape_.blur),
      inverse_volume_(loops_->inverse_volumes()),
      tangents_(scene.normals) {
  if ((transfer_.increments || transfer_.order > 0) && !pistons_.none()) {
    throw std::invalid_argument("pistons cannot work with the transfer " + scene.transfer +
                                ": its points do not take the velocity that a piston gives its nodes");
  }
  for (int d = 0; d < dim; ++d) gravity_[d] = scene.gravity[static_cast<std::size_t>(d)];
  contact_ = make_contact<dim>(scene.contact, grid_, shape_.support);
  loaded_ = !gravity_.isZero(0);
  long points = 0;
  for (const Body& body : scene.bodies) points += body.points.points();
  if (points < fewest_shared) options_.threads = 1;
  std::vector<std::string> names;
  for (Body& body : scene.bodies) {
    const auto found = std::find(names.begin(), names.end(), body.field);
    const bool first_of_field = found == names.end();
    Located at;
    at.field = static_cast<std::size_t>(found - names.begin());
    if (first_of_field) {
      names.push_back(body.field);
      fields_.emplace_back(grid_);
    }
    alone_.resize(fields_.size(), true);
    if (!first_of_field) alone_[at.field] = false;
    at.weights.lowest.resize(static_cast<std::size_t>(body.points.points()));
    located_.push_back(std::move(at));
    loaded_ = loaded_ || body.load;
    refuse_other_geometry(body);
    if (transfer_.affine) body.points.add(column::affine, dim * dim);
    if (shape_.boxes) add_boxes(body);
    if (options.keep_loss && body.material->takes_heat()) body.points.add(column::transfer_loss);
  }
  refuse_relaxation();
  for (const Body& body : scene.bodies) {
    if (body.enclosure && dim != 2) {
      throw std::invalid_argument("body " + body.name +
                                  ": only in two dimensions does a chain of points enclose a gas");
    }
    if (body.enclosure && scene.density != DensityMethod::grid) {
      throw std::invalid_argument("body " + body.name + ": an enclosed gas needs the density method grid");
    }
  }
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Field& field = field_of(b);
    const auto other = [&](std::size_t o) {
      return located_[o].field == located_[b].field &&
             scene.bodies[o].material->takes_heat() != scene.bodies[b].material->takes_heat();
    };
    for (std::size_t o = 0; o < located_.size(); ++o) {
      if (!other(o) || mixed(field)) continue;
      field.add_gas_arrays(grid_);
    }
  }
  for (std::size_t b = 0; b < located_.size(); ++b) {
    if (!hands_over(b)) continue;
    scene.bodies[b].points.add(column::transfer_loss);
    scene.bodies[b].points.add(column::kept_loss);
  }
}

// Moving points without their velocities changes the inertia of boxes, and with it energy that is nobody's.
template <class G>
void Mechanics<G>::refuse_relaxation() const {
  if (transfer_.affine && !shape_.fixed_inertia && scene_.chain_relaxation > 0) {
    throw std::invalid_argument("chains cannot be relaxed with the shape " + scene_.shape + " and the transfer " +
                                scene_.transfer + ": the affine inertia of points would change as they are moved");
  }
}

// Boxes start as cubes of the points' spacing.
template <class G>
void Mechanics<G>::add_boxes(Body& body) const {
  if (body.points.has(column::half_size)) return;
  body.points.add(column::half_size, dim);
  const bool deform = scene_.shape == "contiguous-gimp" && body.points.has(column::deformation);
  if (deform) body.points.add(column::half_size_at_start, dim);
  for (int p = 0; p < body.points.points(); ++p) {
    const double half = 0.5 * point_spacing(body, p, dim, G::axisymmetric);
    for (int d = 0; d < dim; ++d) {
      body.points(column::half_size, d)[p] = half;
      if (deform) body.points(column::half_size_at_start, d)[p] = half;
    }
  }
}

// A box follows its point's deformation by its second moments: l_d^2 = sum_e F_de^2 l0_e^2, whatever the rotation. With
// it changes the inertia of the point's affine velocity, whose energy and spin are booked. [GIMP 2]
template <class G>
void Mechanics<G>::deform_boxes(Body& body) {
  Columns& points = body.points;
  if (!shape_.boxes || !points.has(column::half_size_at_start)) return;
  double energy = 0;
  Turn spin{};
  for (int p = 0; p < points.points(); ++p) {
    double change[dim];  // of D
    for (int d = 0; d < dim; ++d) {
      double& half = points(column::half_size, d)[p];
      const double before = loops_->inertia(points, d, p);
      double square = 0;
      for (int e = 0; e < dim; ++e) {
        const double edge = points(column::deformation, d * dim + e)[p] * points(column::half_size_at_start, e)[p];
        square += edge * edge;
      }
      half = std::sqrt(square);  // [GIMP 2]
      change[d] = points(column::mass)[p] * (loops_->inertia(points, d, p) - before);
    }
    if (transfer_.affine) {
      const auto c = [&](int d, int e) { return points(column::affine, d * dim + e)[p]; };
      for (int d = 0; d < dim; ++d) {
        for (int e = 0; e < dim; ++e) energy += 0.5 * change[e] * c(d, e) * c(d, e);
      }
      for (int k = 0; k < rotations; ++k) {
        const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
        spin[about + static_cast<std::size_t>(k)] += change[a] * c(b, a) - change[b] * c(a, b);
      }
    }
  }
  ledger_.energy.book(Flow::transfer, energy);
  for (std::size_t k = 0; k < 3; ++k) ledger_.angular_momentum[k].book(Flow::transfer, spin[k]);
}

// A body made for another dimension or geometry would be read beyond its columns.
template <class G>
void Mechanics<G>::refuse_other_geometry(const Body& body) {
  if (body.points.points() == 0) return;
  const auto expect = [&](const ColumnId& id, int components) {
    const int found = body.points.components(id);
    if (found == components) return;
    throw std::invalid_argument("body " + body.name + " has " + std::to_string(found) + " components of " + id.name() +
                                "; its material and the grid's geometry want " + std::to_string(components));
  };
  expect(column::position, dim);
  expect(column::velocity, dim);
  expect(column::stress, stress_components(body.material->measure(), dim, G::axisymmetric));
  const bool tangents = body.material->measure() != StressMeasure::point_force;
  if (body.chain && tangents && (G::axisymmetric || dim > 2)) {
    throw std::invalid_argument("body " + body.name + ": a chain of membrane points lives on a line or in the plane");
  }
}

template <class G>
auto Mechanics<G>::nodal(const Field& field, NodalVelocity which) const -> const std::vector<Vec>& {
  switch (which == NodalVelocity::current ? current_ : which) {
    case NodalVelocity::end:
      return field.end;
    case NodalVelocity::midpoint:
      return field.midpoint;
    case NodalVelocity::remapped:
      return field.remapped;
    default:
      return field.start;
  }
}

template <class G>
void Mechanics<G>::place(const Body& body, Weights<dim>& at) const {
  const int points = body.points.points();
  std::vector<char> outside(static_cast<std::size_t>(1 + points / place_stretch));
  for_each_piece(static_cast<int>(outside.size()), options_.threads, [&](int piece) {
    const int first = piece * place_stretch;
    const PointRange range{first, std::min(first + place_stretch, points)};
    outside[static_cast<std::size_t>(piece)] = !loops_->find_lowest(body.points, range, at.lowest.data());
  });
  if (std::find(outside.begin(), outside.end(), 1) == outside.end()) return;
  for (int d = 0; d < dim; ++d) {
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = grid_.logical(body.points(column::position, d)[p], d);
      if (x >= -on_side && x <= grid_.cells(d) + on_side) continue;
      throw InadmissibleState("a point left the grid", body.name, body.id[static_cast<std::size_t>(p)],
                              column::position.name(), body.points(column::position, d)[p]);
    }
  }
}

// By lowest node, and by number where that is the same.
template <class G>
bool Mechanics<G>::in_order(const Body& body, const Weights<dim>& at) {
  for (std::size_t p = 1; p < at.lowest.size(); ++p) {
    const int step = at.lowest[p] - at.lowest[p - 1];
    if (step < 0 || (step == 0 && body.id[p] < body.id[p - 1])) return false;
  }
  return true;
}

// Points are sorted whenever one has changed its bin; a chain keeps its order.
template <class G>
bool Mechanics<G>::sort_points(Body& body, Weights<dim>& at) {
  if (body.chain || in_order(body, at)) return false;
  const std::span<const int> order = at.bins_hold
                                         ? bin_sort_.sort_again(at.bins, at.lowest, body.id, grid_.node_count())
                                         : bin_sort_.sort(at.lowest, body.id, grid_.node_count());
  std::vector<ColumnId> stale{column::transfer_loss};
  if (scene_.density != DensityMethod::continuity) stale.push_back(column::density);
  if (options_.evaluates_stress_first) {
    stale.push_back(column::strain_rate);
    if (body.material->has_density()) {
      stale.push_back(column::stress);
      stale.push_back(column::volume);
      stale.push_back(column::pressure);
    }
  }
  body.points.reorder(order, stale, options_.threads);
  const auto reorder = [&](std::vector<int>& values) {
    spare_.resize(values.size());
    for_each_index(static_cast<int>(order.size()), options_.threads, [&](int k) {
      const auto at_k = static_cast<std::size_t>(k);
      spare_[at_k] = values[static_cast<std::size_t>(order[at_k])];
    });
    std::swap(spare_, values);
  };
  reorder(body.id);
  reorder(at.lowest);
  return true;
}

// Marks the nodes that the points reach.
template <class G>
void Mechanics<G>::touch(const Weights<dim>& at, Field& field) const {
  const int length = grid_.row_length();
  for (int bin = 0; bin < at.bins.bins(); ++bin) {
    const int node = at.bins.node(bin), row = node / length, first = node - row * length, last = first + shape_.support;
    for (int z = 0; z < (dim > 2 ? shape_.support : 1); ++z) {
      for (int y = 0; y < (dim > 1 ? shape_.support : 1); ++y) {
        int here = row + y;
        if constexpr (dim > 2) here += z * (grid_.stride(2) / length);
        auto& range = field.touched[static_cast<std::size_t>(here)];
        range = range.first == range.second ? std::pair{first, last}
                                            : std::pair{std::min(range.first, first), std::max(range.second, last)};
      }
    }
  }
}

// The same of one body's points alone, with no mass yet.
template <class G>
void Mechanics<G>::touch_alone(const Weights<dim>& at, Field& field) const {
  std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  touch(at, field);
  walls_.include_mirrors(field.touched);
  field.for_touched(grid_, [&](std::size_t i) { field.mass[i] = 0; });
}

template <class G>
void Mechanics<G>::locate_points() {
  for (Field& field : fields_) std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    Weights<dim>& at = located_[b].weights;
    deform_boxes(body);
    at.release();
    place(body, at);
    if (sorting_) sort_points(body, at);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, sorting_ && !body.chain);
    at.bins_hold = sorting_ && !body.chain;
    touch(at, field_of(b));
  }
  for (Field& field : fields_) walls_.include_mirrors(field.touched);
  pending_ = Pending{};
  places_known_ = true;
  moved_ = forces_mapped_ = false;
  load_ahead_ = 0;
  tangents_.find(scene_.grid, scene_.bodies);
  rate_of_ = NodalVelocity::current;
  pending_strain_dt_ = pending_stored_ = 0;
}

}  // namespace plumbline
