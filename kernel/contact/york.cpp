#include "kernel/contact/york.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/contact/shared_nodes.hpp"
#include "kernel/register_part.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {
namespace {

template <int dim, YorkCriterion criterion>
std::unique_ptr<Contact<dim>> make(const Grid<dim>& grid, int) {
  return std::make_unique<YorkContact<dim>>(grid, criterion);
}

template <YorkCriterion criterion>
ContactEntry law(std::string name, std::string title, std::string source) {
  return {{std::move(name), std::move(title), std::move(source)},
          {make<1, criterion>, make<2, criterion>, make<3, criterion>}};
}

const RegisterPart against_other(law<YorkCriterion::against_other>(
    "york-9.7", "common motion where body 1 moves into body 2, along the normal of body 1", "York 1997, (9.7)"));
const RegisterPart against_centre(law<YorkCriterion::against_centre>("york-9.8",
                                                                     "the same, seen from the centre of mass",
                                                                     "York 1997, (9.8)"));
const RegisterPart if_both_agree(law<YorkCriterion::both>("york-9.9", "the same, release only if both bodies agree",
                                                          "York 1997, (9.9)"));

}  // namespace

// chi at the cell centres, numbered as the cell's lowest node. [York 9.10]
template <int dim>
std::vector<double> YorkContact<dim>::colour(const Scene& scene, const std::vector<std::size_t>& field_of_body,
                                             std::size_t field) const {
  std::vector<double> chi(static_cast<std::size_t>(grid_.node_count()));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (field_of_body[b] != field) continue;
    const Columns& points = scene.bodies[b].points;
    for (int p = 0; p < points.points(); ++p) {
      int cell[dim];
      double weights[dim][3];
      for (int d = 0; d < dim; ++d) {
        double local;
        cell[d] = Quadratic::anchor(grid_.logical(points(column::position, d)[p], d) - 0.5, 0, local);
        Quadratic::weights(local, weights[d]);
      }
      for (int k = 0; k < (dim == 1 ? 3 : dim == 2 ? 9 : 27); ++k) {
        const int offset[3] = {k % 3, k / 3 % 3, k / 9};
        int node = 0;
        double weight = 1;
        bool inside = true;
        for (int d = 0; d < dim; ++d) {
          const int index = cell[d] + offset[d] - 1 + Grid<dim>::ghosts;
          inside = inside && index >= 0 && index < grid_.nodes(d);
          node += index * grid_.stride(d);
          weight *= weights[d][offset[d]];
        }
        if (inside) chi[static_cast<std::size_t>(node)] += weight;
      }
    }
  }
  mirror(chi);
  return chi;
}

// Behind a wall a body goes on as its mirror image: the cells on either side of it have one colour, that of both.
template <int dim>
void YorkContact<dim>::mirror(std::vector<double>& chi) const {
  for (int d = 0; d < dim; ++d) {
    for (int node = 0; node < grid_.node_count(); ++node) {
      const int cell = grid_.index(node, d);
      const bool low = cell == Grid<dim>::ghosts - 1, high = cell == grid_.nodes(d) - 1 - Grid<dim>::ghosts;
      if (!(low || high) || grid_.wall(d, low ? 0 : 1) == Wall::free) continue;
      double &beyond = chi[static_cast<std::size_t>(node)],
             &before = chi[static_cast<std::size_t>(node + (low ? 1 : -1) * grid_.stride(d))];
      beyond = before += beyond;
    }
  }
}

// The gradients of a node's tent at the centres of the cells around it. [York 9.11]
template <int dim>
auto YorkContact<dim>::outward_normal(const std::vector<double>& chi, int node) const -> Vec {
  Vec gradient = Vec::Zero();
  constexpr int corners = 1 << dim;
  for (int k = 0; k < corners; ++k) {
    int cell = node;
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const int below = k >> d & 1;
      const int index = grid_.index(node, d) - below;
      inside = inside && index >= 0 && index < grid_.nodes(d) - 1;
      cell -= below * grid_.stride(d);
    }
    if (!inside) continue;
    for (int d = 0; d < dim; ++d) gradient[d] += (k >> d & 1 ? -1 : 1) * chi[static_cast<std::size_t>(cell)];
  }
  return -gradient.stableNormalized();
}

template <int dim>
bool YorkContact<dim>::in_contact(const Vec& v1, const Vec& v2, const Vec& centre, const Vec& n1, const Vec& n2) const {
  if (criterion_ == YorkCriterion::against_other) return (v1 - v2).dot(n1) > 0;       // [York 9.7]
  if (criterion_ == YorkCriterion::against_centre) return (v1 - centre).dot(n1) > 0;  // [York 9.8]
  return (v1 - centre).dot(n1) > 0 || (v2 - centre).dot(n2) > 0;                      // [York 9.9]
}

// Fields a and b meet at a node: whoever moves with one of them there, moves with both.
template <int dim>
void YorkContact<dim>::join(int node, std::size_t a, std::size_t b) {
  Node joined{node, {a, b}, {}};
  std::erase_if(nodes_, [&](const Node& other) {
    if (other.node != node) return false;
    const bool together = std::any_of(other.fields.begin(), other.fields.end(),
                                      [&](std::size_t f) { return f == a || f == b; });
    if (together) joined.fields.insert(joined.fields.end(), other.fields.begin(), other.fields.end());
    return together;
  });
  std::sort(joined.fields.begin(), joined.fields.end());
  joined.fields.erase(std::unique(joined.fields.begin(), joined.fields.end()), joined.fields.end());
  nodes_.push_back(std::move(joined));
}

template <int dim>
void YorkContact<dim>::find(const Scene& scene, const std::vector<std::size_t>& field_of_body, const Fields& fields) {
  nodes_.clear();
  std::vector<std::vector<double>> chi;
  for (std::size_t f = 0; f < fields.size(); ++f) chi.push_back(colour(scene, field_of_body, f));
  for (std::size_t a = 0; a < fields.size(); ++a) {
    for (std::size_t b = a + 1; b < fields.size(); ++b) {
      for_shared_nodes(grid_, fields[a], fields[b], [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        const double ma = fields[a].mass[i], mb = fields[b].mass[i];
        const Vec va = fields[a].start[i], vb = fields[b].start[i], centre = (ma * va + mb * vb) / (ma + mb);
        if (!in_contact(va, vb, centre, outward_normal(chi[a], node), outward_normal(chi[b], node))) return;
        if (fields.size() > 2) {
          join(node, a, b);
        } else {
          nodes_.push_back({node, {a, b}, {}});
        }
      });
    }
  }
  for (Node& n : nodes_) {
    for (const std::size_t f : n.fields) n.own.push_back(fields[f].start[static_cast<std::size_t>(n.node)]);
  }
}

template <int dim>
void YorkContact<dim>::apply(Fields& fields, double, bool, const typename Contact<dim>::Visit& visit) {
  for (const Node& n : nodes_) {
    const auto i = static_cast<std::size_t>(n.node);
    double mass = 0;
    Vec start = Vec::Zero(), kick = Vec::Zero();
    std::vector<Vec> kicks;
    for (std::size_t k = 0; k < n.fields.size(); ++k) {
      const VelocityField<dim>& field = fields[n.fields[k]];
      kicks.push_back(field.end[i] - field.start[i]);
      mass += field.mass[i];
      start += field.mass[i] * n.own[k];
      kick += field.mass[i] * kicks.back();
    }
    start /= mass;
    const Vec end = start + kick / mass;  // [York 9.1, 9.2]
    for (std::size_t k = 0; k < n.fields.size(); ++k) {
      VelocityField<dim>& field = fields[n.fields[k]];
      visit({n.node, field.mass[i], n.own[k], n.own[k] + kicks[k], start, end});
      field.start[i] = start;
      field.end[i] = end;
      field.midpoint[i] = 0.5 * (start + end);
    }
  }
}

template <int dim>
void YorkContact<dim>::apply_to_remapped(Fields& fields) {
  for (const Node& n : nodes_) {
    const auto i = static_cast<std::size_t>(n.node);
    double mass = 0;
    Vec momentum = Vec::Zero();
    for (const std::size_t f : n.fields) {
      mass += fields[f].mass[i];
      momentum += fields[f].mass[i] * fields[f].remapped[i];
    }
    for (const std::size_t f : n.fields) fields[f].remapped[i] = momentum / mass;
  }
}

template class YorkContact<1>;
template class YorkContact<2>;
template class YorkContact<3>;

}  // namespace plumbline
