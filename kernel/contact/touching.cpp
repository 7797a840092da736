#include "kernel/contact/touching.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/contact/near_points.hpp"
#include "kernel/contact/separation.hpp"
#include "kernel/contact/shared_nodes.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

template <int dim>
std::unique_ptr<Contact<dim>> make(const Grid<dim>& grid, int support) {
  return std::make_unique<TouchingContact<dim>>(grid, support);
}

const RegisterPart touching_entry(ContactEntry{
    {"touching", "normal impulses and Coulomb friction where points touch and approach",
     "reports/docs/theory/contact-and-coupling.md"},
    {make<1>, make<2>, make<3>},
    true});

}  // namespace

// Lowest node of the support, all of which is on the grid; shapes of an even number of nodes are anchored at the cell, others at
// the nearest node.
template <int dim>
int TouchingContact<dim>::lowest_node(const Vec& x) const {
  int node = 0;
  for (int d = 0; d < dim; ++d) {
    const double cells = std::clamp(grid_.logical(x[d], d), 0.0, 1.0 * grid_.cells(d));
    const int anchor = support_ % 2 == 0 ? std::min(static_cast<int>(cells), grid_.cells(d) - 1)
                                         : static_cast<int>(cells + 0.5);
    const int lowest = anchor - (support_ - 1) / 2 + Grid<dim>::ghosts;
    node += std::clamp(lowest, 0, grid_.nodes(d) - support_) * grid_.stride(d);
  }
  return node;
}

template <int dim>
template <class Visit>
void TouchingContact<dim>::for_support(int lowest, Visit&& visit) const {
  for (int z = 0; z < (dim > 2 ? support_ : 1); ++z) {
    for (int y = 0; y < (dim > 1 ? support_ : 1); ++y) {
      for (int x = 0; x < support_; ++x) {
        visit(lowest + x + (dim > 1 ? y * grid_.stride(1) : 0) + (dim > 2 ? z * grid_.stride(2) : 0));
      }
    }
  }
}

template <int dim>
auto TouchingContact<dim>::points_near(const Scene& scene, const std::vector<std::size_t>& field_of_body,
                                       std::size_t field, const std::vector<char>& shared) const -> std::vector<Near> {
  std::vector<Near> near;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (field_of_body[b] != field) continue;
    const Body& body = scene.bodies[b];
    for (int p = 0; p < body.points.points(); ++p) {
      Near point{Vec(), 0, 0, false};
      for (int d = 0; d < dim; ++d) point.x[d] = body.points(column::position, d)[p];
      point.lowest = lowest_node(point.x);
      bool any = false;
      for_support(point.lowest, [&](int node) { any = any || shared[static_cast<std::size_t>(node)]; });
      if (!any) continue;
      point.spacing = point_spacing(body, p, dim, scene.grid.axisymmetric);
      near.push_back(point);
    }
  }
  return near;
}

// [Touching 1]
template <int dim>
void TouchingContact<dim>::find_touching(std::vector<Near>& first, std::vector<Near>& second) const {
  double widest = 0;
  for (const Near& p : first) widest = std::max(widest, p.spacing);
  for (const Near& q : second) widest = std::max(widest, q.spacing);
  for_near<dim>(first, second, widest, [](Near& p, Near& q) {
    if ((p.x - q.x).norm() < 0.5 * (p.spacing + q.spacing)) p.touches = q.touches = true;
  });
}

template <int dim>
void TouchingContact<dim>::find_candidates(std::size_t a, std::size_t b, const std::vector<Near>& first,
                                           const std::vector<Near>& second) {
  struct Around {
    bool touches[2] = {false, false};
    Clouds<dim> clouds{};
  };
  std::map<int, Around> nodes;  // that carry a touching point
  const std::vector<Near>* const both[2] = {&first, &second};
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Near& p : *both[side]) {
      if (p.touches) for_support(p.lowest, [&](int node) { nodes[node].touches[side] = true; });
    }
  }
  std::erase_if(nodes, [](const auto& node) { return !node.second.touches[0] || !node.second.touches[1]; });
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Near& p : *both[side]) {
      for_support(p.lowest, [&](int node) {
        const auto found = nodes.find(node);
        if (found == nodes.end()) return;
        Clouds<dim>& clouds = found->second.clouds;
        (side == 0 ? clouds.first : clouds.second).push_back((p.x - grid_.position(node)) / grid_.h());
      });
    }
  }
  for (const auto& [node, around] : nodes) {
    const Vec across = along_walls<dim>(grid_, node, separating_direction<dim>(around.clouds, 0.5 * support_));
    if (across.norm() > 0) candidates_.push_back({{node, a, b, across.normalized(), 0}, false});  // [Touching 2]
  }
}

template <int dim>
void TouchingContact<dim>::find(const Scene& scene, const std::vector<std::size_t>& field_of_body,
                                const Fields& fields) {
  candidates_.clear();
  friction_ = scene.friction;
  for (std::size_t a = 0; a < fields.size(); ++a) {
    for (std::size_t b = a + 1; b < fields.size(); ++b) {
      std::vector<char> shared;
      for_shared_nodes(grid_, fields[a], fields[b], [&](int node) {
        if (shared.empty()) shared.resize(static_cast<std::size_t>(grid_.node_count()));
        shared[static_cast<std::size_t>(node)] = 1;
      });
      if (shared.empty()) continue;
      std::vector<Near> first = points_near(scene, field_of_body, a, shared);
      std::vector<Near> second = points_near(scene, field_of_body, b, shared);
      if (first.empty() || second.empty()) continue;
      find_touching(first, second);
      find_candidates(a, b, first, second);
    }
  }
  std::erase_if(candidates_, [&](const Candidate& c) {
    return beyond_wall(grid_, c.node) || !(reduced_mass(grid_, fields[c.a], fields[c.b], c.node) > 0);
  });
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& left, const Candidate& right) { return left.node < right.node; });
}

// How strongly to push each pair apart so that no pair closes along its normal: of one pair s M_a M_b / (M_a + M_b), of
// several that meet at a node the solution of G M^-1 G^T lambda = G v, an M-orthogonal projection too. [Touching 3]
template <int dim>
Eigen::VectorXd TouchingContact<dim>::pushes(const Fields& fields, const Pairs& pairs, Velocities<dim> of) const {
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd compliance(count, count);
  Eigen::VectorXd closing(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const Candidate& c = *pairs[static_cast<std::size_t>(r)];
    const auto i = static_cast<std::size_t>(c.node);
    closing[r] = ((fields[c.a].*of)[i] - (fields[c.b].*of)[i]).dot(c.normal);
    const auto sign = [](const Candidate& at, std::size_t field) { return (at.a == field) - (at.b == field); };
    for (Eigen::Index s = 0; s < count; ++s) {
      const Candidate& other = *pairs[static_cast<std::size_t>(s)];
      const double mobility = sign(other, c.a) / fields[c.a].mass[i] - sign(other, c.b) / fields[c.b].mass[i];
      compliance(r, s) = mobility * c.normal.dot(other.normal);
    }
  }
  if (count == 1) return closing / compliance(0, 0);
  return compliance.completeOrthogonalDecomposition().solve(closing);
}

template <int dim>
Eigen::VectorXd TouchingContact<dim>::push_apart(Fields& fields, const Pairs& pairs, Velocities<dim> of) const {
  const Eigen::VectorXd push = pushes(fields, pairs, of);
  for (std::size_t r = 0; r < pairs.size(); ++r) {
    exchange<dim>(fields, *pairs[r], of, push[static_cast<Eigen::Index>(r)] * pairs[r]->normal);
  }
  return push;
}

template <int dim>
void TouchingContact<dim>::limit_friction(const Pairs& pairs, const Eigen::VectorXd& push) const {
  for (std::size_t r = 0; r < pairs.size(); ++r) {
    pairs[r]->most_held = friction_ * std::max(0.0, push[static_cast<Eigen::Index>(r)]);
  }
}

// Bodies that have been pushed apart, and are again where several meet. [Touching 4]
template <int dim>
void TouchingContact<dim>::rub_each_other(Fields& fields, const Pairs& pairs, Velocities<dim> of) const {
  if (friction_ > 0)
    rub<dim>(grid_, fields, std::span<Candidate* const>(pairs), of, [&] { push_apart(fields, pairs, of); });
}

// Calls work(pairs) for the pairs of each node that `keep` keeps, node by node.
template <int dim>
template <class Keep, class Work>
void TouchingContact<dim>::for_nodes(Keep&& keep, Work&& work) {
  Pairs pairs;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (keep(candidates_[k])) pairs.push_back(&candidates_[k]);
    if (k + 1 < candidates_.size() && candidates_[k + 1].node == candidates_[k].node) continue;
    if (!pairs.empty()) work(pairs);
    pairs.clear();
  }
}

template <int dim>
void TouchingContact<dim>::apply(Fields& fields, double, bool decide, const typename Contact<dim>::Visit& visit) {
  const auto closes = [&](Candidate& c) {
    const auto i = static_cast<std::size_t>(c.node);
    if (decide) c.active = (fields[c.a].midpoint[i] - fields[c.b].midpoint[i]).dot(c.normal) > 0;
    return c.active;
  };
  for_nodes(closes, [&](const Pairs& pairs) {
    std::vector<std::size_t> involved;
    for (const Candidate* c : pairs) involved.insert(involved.end(), {c->a, c->b});
    std::sort(involved.begin(), involved.end());
    involved.erase(std::unique(involved.begin(), involved.end()), involved.end());
    const Eigen::VectorXd push = push_apart(fields, pairs, &VelocityField<dim>::midpoint);  // [Touching 3]
    if (decide) limit_friction(pairs, push);
    rub_each_other(fields, pairs, &VelocityField<dim>::midpoint);
    visit_changed(fields, pairs.front()->node, involved, visit);
  });
}

// Velocities mapped anew become common along the normal where they approach, and rub as far as that pushes.
template <int dim>
void TouchingContact<dim>::apply_to_remapped(Fields& fields) {
  const auto closes = [&](Candidate& c) {
    const auto i = static_cast<std::size_t>(c.node);
    return c.active && (fields[c.a].remapped[i] - fields[c.b].remapped[i]).dot(c.normal) > 0;
  };
  for_nodes(closes, [&](const Pairs& pairs) {
    limit_friction(pairs, push_apart(fields, pairs, &VelocityField<dim>::remapped));
    rub_each_other(fields, pairs, &VelocityField<dim>::remapped);
  });
}

template class TouchingContact<1>;
template class TouchingContact<2>;
template class TouchingContact<3>;

}  // namespace plumbline
