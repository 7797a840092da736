#include "kernel/ledger.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline {
namespace {

TEST(Ledger, ResidualIsWhatNoFlowExplains) {
  Account account;
  account.open(10, 10);
  account.book(Flow::walls, 3);
  account.book(Flow::transfer, -1);
  account.close(12, 12);
  EXPECT_EQ(account.residual(), 0);
  account.book(Flow::body_force, 0.5);
  account.close(12, 8);
  EXPECT_EQ(account.residual(), -0.5);
  EXPECT_EQ(account.flow(Flow::walls), 3);
  EXPECT_EQ(account.booked(), 4.5);
  EXPECT_EQ(account.scale(), 12);  // the largest so far
  EXPECT_EQ(account.relative_drift(false), 0.5 / 12);
  EXPECT_EQ(account.relative_drift(true), 0.5 / 16.5);
}

TEST(Ledger, TheLargestResidualStays) {
  Account account;
  account.open(1, 1);
  account.close(1.5, 1);
  account.close(1, 1);
  EXPECT_EQ(account.residual(), 0);
  EXPECT_EQ(account.largest_residual(), 0.5);
}

TEST(Ledger, ANonFiniteStoreShows) {
  Account account;
  account.open(1, 1);
  account.close(std::numeric_limits<double>::quiet_NaN(), 1);
  EXPECT_TRUE(std::isnan(account.relative_drift(false)));
}

TEST(Ledger, NothingHappenedIsNoDrift) {
  Account account;
  account.open(0, 0);
  account.close(0, 0);
  EXPECT_EQ(account.relative_drift(true), 0);
}

// Mass is compared with what the grid got: points cannot lose mass, a map can. [York 3.15]
TEST(Ledger, MassIsComparedWithTheGrid) {
  Totals totals;
  totals.mass = 2;
  totals.grid_mass = 2;
  Ledger ledger;
  ledger.open(totals);
  totals.grid_mass = 1.5;
  ledger.close_step(totals);
  EXPECT_EQ(ledger.mass.residual(), -0.5);
}

TEST(Ledger, StoresAddUp) {
  Totals totals;
  totals.energy = {1, 2, 4};
  Ledger ledger;
  ledger.open(totals);
  EXPECT_EQ(ledger.energy.initial(), 7);
  totals.energy.kinetic = 2;
  ledger.energy.book(Flow::body_force, 1);
  ledger.close_step(totals);
  EXPECT_EQ(ledger.energy.residual(), 0);
  EXPECT_EQ(ledger.stores.kinetic, 2);
  EXPECT_EQ(ledger.initial_stores.kinetic, 1);
}

TEST(Ledger, NamesItsFlowsInTheirOrder) {
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::walls)], "walls");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::body_force)], "body_force");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::contact)], "contact");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::transfer)], "transfer");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::constitutive)], "constitutive");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::integration)], "integration");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::released)], "released");
}

}  // namespace
}  // namespace plumbline
