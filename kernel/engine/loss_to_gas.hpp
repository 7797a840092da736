// What bodies without an energy equation lose to the maps goes to the gas at their nodes. [Coupling 1]
#pragma once

#include <vector>

#include "kernel/engine/discretisation.hpp"

namespace plumbline {

template <class Geometry>
class LossToGas {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Field = typename Space::Field;

  LossToGas(const Space& space, bool wanted) : space_(space), wanted_(wanted) {}

  // Whether what the body loses goes to gas of its field.
  bool gives(const Body& body, const Field& field) const {
    return wanted_ && field.mixed() && !body.material->takes_heat();
  }

  void clear(Field& field) const {
    if (wanted_ && field.mixed()) field.for_touched(space_.grid, [&](std::size_t i) { field.gas.loss[i] = 0; });
  }

  // Adds L_i = sum_p (loss_p + kept_p) N_ip. What falls on nodes without gas the point keeps until there is some:
  // kept_p = (loss_p + kept_p) sum_{i: G_i = 0} N_ip, G_i the mass of gas.
  void give(Body& body, const Weights<dim>& at, Field& field) const {
    if (!gives(body, field)) return;
    const int n = body.points.points();
    const double* loss = body.points(column::transfer_loss);
    double* waiting = body.points(column::kept_loss);
    std::vector<double> bare(field.gas.mass.size()), without_gas(static_cast<std::size_t>(n + lanes));
    field.for_touched(space_.grid, [&](std::size_t i) { bare[i] = field.gas.mass[i] > least_mass ? 0.0 : 1.0; });
    const typename Space::Loops::Spread all[] = {{waiting, nullptr, field.gas.loss.data(), 1}};
    const typename Space::Loops::Gather rest[] = {{bare.data(), 1, without_gas.data()}};
    for (int p = 0; p < n; ++p) waiting[p] += loss[p];
    space_.spread(body.points, at, all);
    space_.gather(body.points, at, rest);
    for (int p = 0; p < n; ++p) waiting[p] *= without_gas[static_cast<std::size_t>(p)];
  }

  // L_i / G_i once all have given.
  void divide(Field& field) const {
    if (wanted_ && field.mixed()) space_.divide_sums(field, field.gas.mass, field.gas.loss);
  }

  // Adds to what a gas point lost itself its share of what others lost at its nodes, m_p sum_i N_ip L_i / G_i.
  void take(Body& body, const Weights<dim>& at, const Field& field) const {
    if (!wanted_ || !field.mixed()) return;
    const double* mass = body.points(column::mass);
    double* loss = body.points(column::transfer_loss);
    std::vector<double> share(static_cast<std::size_t>(body.points.points() + lanes));
    const typename Space::Loops::Gather shares[] = {{field.gas.loss.data(), 1, share.data()}};
    space_.gather(body.points, at, shares);
    for (int p = 0; p < body.points.points(); ++p) loss[p] += mass[p] * share[static_cast<std::size_t>(p)];
  }

 private:
  const Space& space_;
  bool wanted_;
};

}  // namespace plumbline
