#include "kernel/normals/membrane_tangents.hpp"

#include <stdexcept>

namespace plumbline {

MembraneTangents::MembraneTangents(const std::string& method) : method_(method) {
  bool known = false;
  for (const Choice& choice : normals_methods()) known = known || choice.name == method;
  if (!known) throw std::invalid_argument("no method of normals " + method);
}

void MembraneTangents::find(const GridSpec& grid, std::vector<Body>& bodies) {
  if (!given_by(method_) || grid.dim != 2) return;
  while (methods_.size() < bodies.size()) methods_.push_back(make_normals(method_));
  for (auto& component : gas_) component.clear();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!methods_[b]->sees_others() || bodies[b].chain) continue;
    for (int d = 0; d < 2; ++d) {
      const double* x = bodies[b].points(column::position, d);
      gas_[d].insert(gas_[d].end(), x, x + bodies[b].points.points());
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Columns& points = bodies[b].points;
    if (!bodies[b].chain || !points.has(column::tangent)) continue;
    const auto n = static_cast<std::size_t>(points.points());
    double *tx = points(column::tangent), *ty = points(column::tangent, 1);
    for (auto& normal : normal_) normal.resize(n);
    for (std::size_t p = 0; p < n; ++p) {
      normal_[0][p] = -ty[p];
      normal_[1][p] = tx[p];
    }
    const double *x = points(column::position), *y = points(column::position, 1);
    methods_[b]->find({grid, {x, n}, {y, n}, gas_[0], gas_[1], normal_[0], normal_[1]}, normal_[0], normal_[1]);
    for (std::size_t p = 0; p < n; ++p) {
      tx[p] = normal_[1][p];
      ty[p] = -normal_[0][p];
    }
  }
}

}  // namespace plumbline
