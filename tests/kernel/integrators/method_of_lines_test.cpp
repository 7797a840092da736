// Integrators that see the semi-discrete equations alone: a state, and its rate of change.
#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::method_of_lines_test {
namespace {

constexpr const char* methods[] = {"ssp-rk3", "rk4", "generalized-alpha", "implicit-midpoint"};

TEST(MethodOfLines, WantsFlip) {
  for (const char* name : methods) {
    const IntegratorEntry& entry = *find_integrator(name);
    for (const char* transfer : {"pic", "apic", "xpic", "fmpm"})
      EXPECT_FALSE(lacks(entry, "cubic", transfer).empty()) << name;
    EXPECT_TRUE(lacks(entry, "linear", "flip").empty()) << name;
    EXPECT_THROW(Simulation(scenes::rough_gas(1, "quadratic", "apic"), name, {0.1, {}}), std::invalid_argument) << name;
  }
}

// What states set by hand change is booked: mass, momenta and energy close to a few hundred roundings of their scales.
TEST(MethodOfLines, TheLedgerCloses) {
  for (const char* name : methods) {
    for (const int dim : {1, 2}) {
      SCOPED_TRACE(testing::Message() << name << ", " << dim);
      Simulation run(scenes::rough_gas(dim, "quadratic", "flip"), name, {0.2, {}});
      for (int k = 0; k < 8; ++k) run.step(1);
      scenes::expect_ledger_closes(run.ledger(), 1e-13);
      EXPECT_NE(run.ledger().energy.flow(Flow::integration), 0);
    }
  }
}

}  // namespace
}  // namespace plumbline::method_of_lines_test
