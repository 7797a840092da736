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

void Ledger::open(const Totals& totals) {
  mass.open(totals.mass, totals.mass);
  for (std::size_t d = 0; d < 2; ++d) momentum[d].open(totals.momentum[d], totals.momentum_scale[d]);
  angular_momentum.open(totals.angular_momentum, totals.angular_scale);
  energy.open(totals.energy.total(), totals.energy.total());
  initial_stores = stores = totals.energy;
  viscous = 0;
}

void Ledger::close_step(const Totals& totals) {
  mass.close(totals.grid_mass, totals.mass);
  for (std::size_t d = 0; d < 2; ++d) momentum[d].close(totals.momentum[d], totals.momentum_scale[d]);
  angular_momentum.close(totals.angular_momentum, totals.angular_scale);
  energy.close(totals.energy.total(), totals.energy.total());
  stores = totals.energy;
}

}  // namespace plumbline
