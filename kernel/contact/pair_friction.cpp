#include "kernel/contact/pair_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace plumbline {

template <int dim>
void PairFriction<dim>::find(const std::vector<PressedPair<dim>>& pressed,
                             const std::vector<std::size_t>& field_of_body, const Fields& fields, double dt) {
  std::map<std::tuple<int, std::size_t, std::size_t>, Vec> forces;  // node, fields
  for (const PressedPair<dim>& pair : pressed) {
    const std::size_t own = field_of_body[pair.a], other = field_of_body[pair.b];
    const std::size_t a = std::min(own, other), b = std::max(own, other);
    constexpr int corners = 1 << dim;
    std::array<int, corners> nodes{};
    std::array<double, corners> shares{};
    double sum = 0;
    for (int k = 0; k < corners; ++k) {
      const auto at = static_cast<std::size_t>(k);
      double tent = 1;
      for (int d = 0; d < dim; ++d) {
        const double x = std::clamp(grid_.logical(pair.middle[d], d), 0.0, 1.0 * grid_.cells(d));
        const int cell = std::min(static_cast<int>(x), grid_.cells(d) - 1), upper = k >> d & 1;
        tent *= upper ? x - cell : 1 - (x - cell);
        nodes[at] += (cell + upper + Grid<dim>::ghosts) * grid_.stride(d);
      }
      sum += shares[at] = tent * reduced_mass(grid_, fields[a], fields[b], nodes[at]);
    }
    if (sum == 0) continue;  // the bodies share none of these nodes
    const Vec force = own < other ? pair.force : Vec(-pair.force);
    for (std::size_t k = 0; k < corners; ++k) {
      if (shares[k] == 0) continue;
      auto& at = forces.try_emplace({nodes[k], a, b}, Vec::Zero()).first->second;
      at += shares[k] / sum * force;  // [Pairs 4]
    }
  }
  rubbing_.clear();
  for (const auto& [where, force] : forces) {
    const auto& [node, a, b] = where;
    if (const double size = force.norm(); size > 0)
      rubbing_.push_back({node, a, b, force / size, coefficient_ * size * dt / 2});
  }
}

template <int dim>
void PairFriction<dim>::apply(Fields& fields, const typename Contact<dim>::Visit& visit) {
  std::vector<RubbingPair<dim>*> pairs;
  std::vector<std::size_t> involved;
  for (std::size_t k = 0; k < rubbing_.size(); ++k) {
    RubbingPair<dim>& pair = rubbing_[k];
    pairs.push_back(&pair);
    involved.insert(involved.end(), {pair.a, pair.b});
    if (k + 1 < rubbing_.size() && rubbing_[k + 1].node == pair.node) continue;
    rub<dim>(grid_, fields, std::span<RubbingPair<dim>* const>(pairs), &VelocityField<dim>::midpoint,
             [] {});  // [Pairs 5]
    std::sort(involved.begin(), involved.end());
    involved.erase(std::unique(involved.begin(), involved.end()), involved.end());
    visit_changed(fields, pair.node, involved, visit);
    pairs.clear();
    involved.clear();
  }
}

template class PairFriction<1>;
template class PairFriction<2>;
template class PairFriction<3>;

}  // namespace plumbline
