// A share of the points' own velocities is kept: between FLIP and PIC. [Blend 1]
#include <cmath>
#include <stdexcept>

#include "kernel/register_part.hpp"
#include "kernel/transfers/transfer.hpp"
#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::blend_test {
namespace {

// A transfer of that share, registered when first asked for: other tests count those of the program.
std::string blend(double keep) {
  const std::string name = "test_keep_" + std::to_string(keep);
  if (!find_named(transfers(), name))
    RegisterPart(TransferEntry{{name, "for tests", "-", {}, {Trait::forward_steps}}, {.keep = keep}});
  return name;
}

Simulation stepped(scenes::Space space, const std::string& transfer, const std::string& integrator, int steps) {
  Simulation run(scenes::rough_gas(space, "quadratic", transfer), integrator, {0.2, 1e-3});
  for (int k = 0; k < steps; ++k) run.step(1);
  return run;
}

TEST(Blend, PointsHaveTheSharesOfBoth) {
  for (const scenes::Space space : scenes::spaces) {
    const int dim = scenes::dim_of(space);
    const Simulation flip = stepped(space, "flip", "usl", 1), pic = stepped(space, "pic", "usl", 1);
    for (const double keep : {0.05, 0.5, 0.97}) {
      const Simulation both = stepped(space, blend(keep), "usl", 1);
      for (int d = 0; d < dim; ++d) {
        const auto f = scenes::by_id(flip.scene().bodies[0], column::velocity, d),
                   p = scenes::by_id(pic.scene().bodies[0], column::velocity, d),
                   b = scenes::by_id(both.scene().bodies[0], column::velocity, d);
        for (std::size_t k = 0; k < b.size(); ++k) EXPECT_NEAR(b[k], keep * f[k] + (1 - keep) * p[k], 1e-15);
      }
    }
  }
}

// All of it and none of it are FLIP and PIC to the last bit.
TEST(Blend, EndsAreFlipAndPic) {
  for (const auto& [keep, name] : {std::pair{1.0, "flip"}, std::pair{0.0, "pic"}}) {
    const Simulation own = stepped(scenes::Space::plane, blend(keep), "musl", 20),
                     other = stepped(scenes::Space::plane, name, "musl", 20);
    scenes::expect_same_ledger(own.ledger(), other.ledger());
    EXPECT_EQ(scenes::by_id(own.scene().bodies[0], column::velocity),
              scenes::by_id(other.scene().bodies[0], column::velocity));
  }
}

// The loss is that of both maps in their shares, and what is between the two results: all of it is booked. Sums of some
// thousand terms, some of them differences: 1e-13.
TEST(Blend, LedgerClosesAtWalls) {
  for (const scenes::Space space : scenes::spaces) {
    for (const char* integrator : {"musl", "usl", "usf", "midpoint"}) {
      for (const double keep : {0.05, 0.5, 0.97}) {
        SCOPED_TRACE(testing::Message() << space << ' ' << integrator << ' ' << keep);
        const Simulation run = stepped(space, blend(keep), integrator, 30);
        scenes::expect_ledger_closes(run.ledger(), 1e-13);
        EXPECT_LT(run.ledger().energy.flow(Flow::transfer), -1e-3 * run.ledger().energy.scale());
      }
    }
  }
}

// Contact that changes velocities of the start, and contact that does not.
TEST(Blend, LedgerClosesWithContact) {
  using meetings::block;
  using meetings::elastic_body;
  const double s = 0.05;
  for (const char* contact : {"york-9.7", "touching"}) {
    for (const double keep : {0.05, 0.5, 0.97}) {
      SCOPED_TRACE(testing::Message() << contact << ' ' << keep);
      Scene scene;
      scene.grid = scenes::plane(20, 16, 0.1);
      scene.bodies = {elastic_body("a", 2, block({0.4, 0.5, 0}, {8, 10, 1}, s), s, {1, 0.1, 0}),
                      elastic_body("b", 2, block({0.82, 0.6, 0}, {8, 10, 1}, s), s)};
      scene.transfer = blend(keep);
      scene.contact = contact;
      Simulation run(scene, "midpoint", {.dt = 1e-3});
      for (int k = 0; k < 60; ++k) run.step(1e-3);
      scenes::expect_ledger_closes(run.ledger(), 1e-13);
      double fastest = 0;
      for (const double v : scenes::by_id(run.scene().bodies[1], column::velocity)) fastest = std::max(fastest, v);
      EXPECT_GT(fastest, 1e-2) << "they met";
    }
  }
}

TEST(Blend, OthersAreRefused) {
  const auto register_one = [](Transfer does, bool has_order) {
    RegisterPart(TransferEntry{{"test_refused", "", ""}, does, has_order});
  };
  EXPECT_THROW(register_one({.keep = 1.1}, false), std::logic_error);
  EXPECT_THROW(register_one({.keep = -0.1}, false), std::logic_error);
  EXPECT_THROW(register_one({.keep = std::nan("")}, false), std::logic_error);
  EXPECT_THROW(register_one({.affine = true, .keep = 0.5}, false), std::logic_error);
  EXPECT_THROW(register_one({.keep = 0.5}, true), std::logic_error);
  EXPECT_EQ(find_named(transfers(), "test_refused"), nullptr);
}

}  // namespace
}  // namespace plumbline::blend_test
