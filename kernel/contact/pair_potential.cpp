#include "kernel/contact/pair_potential.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "kernel/contact/contact.hpp"
#include "kernel/contact/near_points.hpp"
#include "kernel/register_part.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {
namespace {

constexpr double pair_stiffness = 1.0 / 4;  // K over the modulus
constexpr double most_spacing = 2.0 / 3;    // of points that rub, over that of nodes: h + l/2 - r_0/2 is h/2 or more
constexpr double pairs_kept_within = 1.25;  // reaches; who comes from further away in a step presses in the next

template <int dim>
std::unique_ptr<Contact<dim>> nothing_at_nodes(const Grid<dim>&, int) {
  return nullptr;
}

const RegisterPart pairs_entry(ContactEntry{
    {"pairs", "a potential of the distances between points of two bodies, and Coulomb friction where they press",
     "reports/docs/theory/contact-and-coupling.md"},
    {nothing_at_nodes<1>, nothing_at_nodes<2>, nothing_at_nodes<3>},
    true,
    true});

template <int dim>
using Axes = std::array<const double*, dim>;

template <int dim>
Axes<dim> axes(const Columns& points, const ColumnId& id) {
  Axes<dim> all;
  for (int d = 0; d < dim; ++d) all[static_cast<std::size_t>(d)] = points(id, d);
  return all;
}

template <int dim>
Eigen::Matrix<double, dim, 1> at(const Axes<dim>& axes, int p) {
  Eigen::Matrix<double, dim, 1> value;
  for (int d = 0; d < dim; ++d) value[d] = axes[static_cast<std::size_t>(d)][p];
  return value;
}

template <int dim>
struct BoundingBox {
  Eigen::Array<double, dim, 1> low, high;
  explicit BoundingBox(const Columns& points) {
    for (int d = 0; d < dim; ++d) {
      const double* x = points(column::position, d);
      const auto [least, most] = std::minmax_element(x, x + points.points());
      low[d] = *least;
      high[d] = *most;
    }
  }
};

// Spacings of a body's points at rest.
class Spacings {
 public:
  Spacings(const Body& body, int dim, double density)
      : given_(body.spacing),
        mass_(body.points(column::mass)),
        density_(density),
        power_(1.0 / dim) {}
  double operator()(int p) const { return given_ > 0 ? given_ : std::pow(mass_[p] / density_, power_); }
  double widest(int points) const {
    return given_ > 0 ? given_ : std::pow(*std::max_element(mass_, mass_ + points) / density_, power_);
  }

 private:
  double given_;
  const double* mass_;
  double density_, power_;
};

double widest_spacing(const Body& body, int dim) {
  if (body.points.points() == 0) return 0;
  return Spacings(body, dim, body.material->rest(dim)->density).widest(body.points.points());
}

template <int dim>
struct PointOfPair {
  Eigen::Matrix<double, dim, 1> x;
  int point;
  double spacing, stiffness;
};

// Points of a body that stand nearer than `far` to the box about another.
template <int dim>
std::vector<PointOfPair<dim>> points_near(const Body& body, const RestState& rest, const BoundingBox<dim>& box,
                                          double far) {
  const Spacings spacings(body, dim, rest.density);
  const Axes<dim> position = axes<dim>(body.points, column::position);
  std::vector<PointOfPair<dim>> all;
  for (int p = 0; p < body.points.points(); ++p) {
    const Eigen::Matrix<double, dim, 1> x = at<dim>(position, p);
    if (!((x.array() >= box.low - far) && (x.array() <= box.high + far)).all()) continue;
    const double spacing = spacings(p);
    all.push_back({x, p, spacing, pair_stiffness * rest.modulus * std::pow(spacing, dim - 2)});  // [Pairs 2]
  }
  return all;
}

// The mean of max(0, s)^3 while s goes from one value to another.
double mean_cube(double start, double end) {
  const double least = std::min(start, end), most = std::max(start, end);
  if (least >= 0) return (least + most) * (least * least + most * most) / 4;
  return most > 0 ? std::pow(most, 4) / (4 * (most - least)) : 0.0;
}

template <int dim>
double energy_of_pairs(const Scene& scene) {
  PairPotential<dim> pairs;
  pairs.find(scene.bodies);
  return pairs.energy(scene.bodies);
}

}  // namespace

template <int dim>
void PairPotential<dim>::find(const std::vector<Body>& bodies) {
  pairs_.clear();
  involved_.assign(bodies.size(), false);
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const bool points = bodies[a].points.points() > 0 && bodies[b].points.points() > 0;
      if (points && bodies[a].field != bodies[b].field) find_between(bodies, a, b);
    }
  }
}

template <int dim>
void PairPotential<dim>::find_between(const std::vector<Body>& bodies, std::size_t a, std::size_t b) {
  const RestState first_rest = *bodies[a].material->rest(dim), second_rest = *bodies[b].material->rest(dim);
  const double widest = std::max(widest_spacing(bodies[a], dim), widest_spacing(bodies[b], dim));
  const double far = pairs_kept_within * pair_reach * widest;
  const BoundingBox<dim> first_box(bodies[a].points), second_box(bodies[b].points);
  if ((first_box.low - far > second_box.high).any() || (second_box.low - far > first_box.high).any()) return;
  auto first = points_near<dim>(bodies[a], first_rest, second_box, far);
  auto second = points_near<dim>(bodies[b], second_rest, first_box, far);
  for_near<dim>(first, second, far, [&](const PointOfPair<dim>& p, const PointOfPair<dim>& q) {
    const double spacing = 0.5 * (p.spacing + q.spacing), reach = pair_reach * spacing;
    if (!((q.x - p.x).norm() < pairs_kept_within * reach)) return;
    const double stiffness = 2 * p.stiffness * q.stiffness / (p.stiffness + q.stiffness);
    pairs_.push_back({a, b, p.point, q.point, reach, stiffness / (spacing * spacing), Vec::Zero()});
    involved_[a] = involved_[b] = true;
  });
}

template <int dim>
void PairPotential<dim>::press(std::vector<Body>& bodies, double time) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!involved_[b]) continue;
    const auto force = bodies[b].points.values(column::contact_force);
    std::fill(force.begin(), force.end(), 0.0);
  }
  for (Pair& pair : pairs_) {
    pair.force.setZero();
    Columns &first = bodies[pair.a].points, &second = bodies[pair.b].points;
    const auto apart = [&](const ColumnId& id) {
      return Vec(at<dim>(axes<dim>(second, id), pair.q) - at<dim>(axes<dim>(first, id), pair.p));
    };
    const Vec between = apart(column::position);
    const double r = between.norm();
    const Vec then = time > 0 ? Vec(between + time * apart(column::contact_velocity)) : between;
    const double end = then.norm(), both = r + end;
    if (both == 0) continue;  // no direction is known; the next step moves them
    pair.force = pair.stiffness * mean_cube(pair.reach - r, pair.reach - end) / both * (between + then);  // [Pairs 3]
    for (int d = 0; d < dim; ++d) {
      first(column::contact_force, d)[pair.p] -= pair.force[d];
      second(column::contact_force, d)[pair.q] += pair.force[d];
    }
  }
}

template <int dim>
auto PairPotential<dim>::pressed(const std::vector<Body>& bodies) const -> std::vector<PressedPair<dim>> {
  std::vector<PressedPair<dim>> all;
  for (const Pair& pair : pairs_) {
    if (pair.force.isZero(0)) continue;
    const Vec p = at<dim>(axes<dim>(bodies[pair.a].points, column::position), pair.p),
              q = at<dim>(axes<dim>(bodies[pair.b].points, column::position), pair.q);
    all.push_back({pair.a, pair.b, (p + q) / 2, pair.force});
  }
  return all;
}

template <int dim>
double PairPotential<dim>::energy(const std::vector<Body>& bodies) const {
  double sum = 0;
  for (const Pair& pair : pairs_) {
    const Vec p = at<dim>(axes<dim>(bodies[pair.a].points, column::position), pair.p),
              q = at<dim>(axes<dim>(bodies[pair.b].points, column::position), pair.q);
    const double overlap = std::max(0.0, pair.reach - (q - p).norm());
    sum += pair.stiffness / 4 * std::pow(overlap, 4);  // [Pairs 1]
  }
  return sum;
}

template class PairPotential<1>;
template class PairPotential<2>;
template class PairPotential<3>;

bool meets_by_pairs(const Scene& scene) { return named(contacts(), scene.contact, ContactEntry::kind).by_pairs; }

void check_pairs(const Scene& scene) {
  if (!meets_by_pairs(scene)) return;
  if (scene.grid.axisymmetric) {
    throw std::invalid_argument("the contact law " + scene.contact +
                                " works on a line, in the plane and in space, not about an axis");
  }
  for (const Body& body : scene.bodies) {
    if (body.material->rest(scene.grid.dim)) continue;
    throw std::invalid_argument("the contact law " + scene.contact + " is one of solids: the material of body " +
                                body.name + ", " + body.material->name() + ", has no modulus of compression at rest");
  }
  if (scene.friction == 0) return;
  const std::string rubbing = "friction of the contact law " + scene.contact + " is that of nodes which bodies share: ";
  if (shape_named(scene.shape).at_start || !shape_offers(scene.shape, Trait::smooth_gradients))
    throw std::invalid_argument(rubbing + "the shape " + scene.shape + " does not reach the other body's");
  for (const Body& body : scene.bodies) {
    if (widest_spacing(body, scene.grid.dim) <= most_spacing * scene.grid.h) continue;
    throw std::invalid_argument(rubbing + "points of body " + body.name + " are more than two thirds of a cell apart");
  }
}

double contact_energy(const Scene& scene) {
  if (!meets_by_pairs(scene)) return 0;
  if (scene.grid.dim == 1) return energy_of_pairs<1>(scene);
  return scene.grid.dim == 2 ? energy_of_pairs<2>(scene) : energy_of_pairs<3>(scene);
}

}  // namespace plumbline
