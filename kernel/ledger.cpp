#include "kernel/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline {

void Account::open(double store, double scale) {
  *this = Account{};
  initial_ = store_ = store;
  scale_ = scale;
}

void Account::close(double store, double scale) {
  store_ = store;
  double flows = 0;
  for (const RunningSum& f : flows_) flows += f.value();
  residual_ = (store - initial_) - flows;
  // A value that is not a number stays: no later step may hide it.
  if (!std::isnan(largest_residual_) && !(std::abs(residual_) <= std::abs(largest_residual_)))
    largest_residual_ = residual_;
  scale_ = std::max(scale_, scale);
}

double Account::relative_drift(bool with_booked) const {
  const double scale = scale_ + (with_booked ? booked_ : 0.0);
  if (largest_residual_ == 0) return 0;
  return std::abs(largest_residual_) / scale;
}

Totals& Totals::operator+=(const Totals& o) {
  mass += o.mass;
  momentum_scale += o.momentum_scale;
  angular_scale += o.angular_scale;
  for (std::size_t d = 0; d < 3; ++d) {
    momentum[d] += o.momentum[d];
    angular_momentum[d] += o.angular_momentum[d];
  }
  energy.kinetic += o.energy.kinetic;
  energy.internal += o.energy.internal;
  energy.elastic += o.energy.elastic;
  return *this;
}

void Ledger::open(const Totals& totals) {
  mass.open(totals.mass, totals.mass);
  for (std::size_t d = 0; d < 3; ++d) {
    momentum[d].open(totals.momentum[d], totals.momentum_scale);
    angular_momentum[d].open(totals.angular_momentum[d], totals.angular_scale);
  }
  energy.open(totals.energy.total(), totals.energy.total());
  initial_stores = stores = totals.energy;
  viscous = 0;
}

void Ledger::close_step(const Totals& totals) {
  mass.close(totals.grid_mass, totals.mass);
  for (std::size_t d = 0; d < 3; ++d) {
    momentum[d].close(totals.momentum[d], totals.momentum_scale);
    angular_momentum[d].close(totals.angular_momentum[d], totals.angular_scale);
  }
  energy.close(totals.energy.total(), totals.energy.total());
  stores = totals.energy;
}

std::vector<std::pair<std::string, const Account*>> Ledger::accounts(int dim, bool axisymmetric) const {
  std::vector<std::pair<std::string, const Account*>> all{{"mass", &mass}};
  const std::string axes[] = {"_x", "_y", "_z"};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) all.push_back({"momentum" + axes[d], &momentum[d]});
  if (dim == 2 && !axisymmetric) all.push_back({"angular_momentum", &angular_momentum[2]});
  for (std::size_t d = 0; dim == 3 && d < 3; ++d) all.push_back({"angular_momentum" + axes[d], &angular_momentum[d]});
  all.push_back({"energy", &energy});
  return all;
}

}  // namespace plumbline
