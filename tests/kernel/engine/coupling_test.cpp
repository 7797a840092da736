// What membranes lose in maps and strains, and where it goes. [Coupling 1] And heat exchanged amid them. [Exchange 1]
#include <numbers>

#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::coupling_test {
namespace {

using scenes::Skin;
using scenes::Space;

// A step rounds each of a point's energies a few times, 1e-16 of it each; over 30 steps and a thousand terms of both
// signs that stays below this part of the energy there is.
constexpr double rounding = 1e-13;

double kept(const Simulation& run) {
  double sum = 0;
  for (const Body& body : run.scene().bodies) {
    if (body.points.has(column::kept_loss)) sum += scenes::sum_of(body, column::kept_loss);
  }
  return sum;
}
double heat(const Scene& scene) {
  double sum = 0;
  for (const Body& body : scene.bodies) {
    if (body.material->takes_heat()) sum += body.material->stored_energy(body.points, all_points(body.points));
  }
  return sum;
}
double lost(const Ledger& ledger) {
  return -(ledger.energy.flow(Flow::transfer) + ledger.energy.flow(Flow::constitutive));
}

struct Setting {
  Space space;
  Skin skin;
};
std::ostream& operator<<(std::ostream& out, const Setting& s) { return out << s.space << '_' << s.skin; }
std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (Space space : scenes::spaces) {
    for (Skin skin : scenes::skins) {
      if (lives_in(skin, space)) all.push_back({space, skin});
    }
  }
  return all;
}
class Coupling : public testing::TestWithParam<Setting> {
 protected:
  Scene mixed(const std::string& shape, const std::string& transfer, bool walled) const {
    return scenes::gas_and_skin(GetParam().skin, GetParam().space, shape, transfer, walled);
  }
};
INSTANTIATE_TEST_SUITE_P(Settings, Coupling, testing::ValuesIn(settings()), testing::PrintToStringParamName());

template <class Visit>
void for_each_way(Visit&& visit) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    for (const char* shape : {"quadratic", "cubic"}) {
      for (const char* transfer : {"apic", "pic"}) {
        SCOPED_TRACE(testing::Message() << integrator << ' ' << shape << ' ' << transfer);
        visit(integrator, shape, transfer);
      }
    }
  }
}

// The membrane to within 3e-2 of the low wall in x, so that it reaches nodes beyond, and the gas to half a cell from
// there, so that it does not.
void push_to_the_wall(Scene& scene) {
  for (Body& body : scene.bodies) {
    double* x = body.points(column::position);
    for (int p = 0; p < body.points.points(); ++p) x[p] = body.material->takes_heat() ? 0.08 + 0.75 * x[p] : x[p] - 0.1;
  }
}

// Kinetic, internal and elastic energy, and what waits at points, stay what they were, with all that acts on the way;
// so does the momentum where there are no walls. The membrane loses all the time, so it is not for nothing. [Coupling
// 1]
TEST_P(Coupling, NothingIsLost) {
  for_each_way([&](const char* integrator, const char* shape, const char* transfer) {
    for (const bool walled : {false, true}) {
      Scene scene = mixed(shape, transfer, walled);
      if (walled) push_to_the_wall(scene);
      scene.loss_to_gas = true;
      scene.heat_exchange = scene.sharpening = 1;
      scene.chain_relaxation = 0.5;
      scene.strain_smoothing = 0.1;
      if (!walled) std::swap(scene.bodies[0], scene.bodies[1]);
      Simulation run(scene, integrator, {0.3, 0.01});
      const double start = run.ledger().energy.initial();
      for (int k = 0; k < 30; ++k) {
        run.step(1);
        ASSERT_NEAR(run.ledger().energy.store() + kept(run), start, rounding * start) << "step " << k;
      }
      scenes::expect_ledger_closes(run.ledger(), rounding);
      if (walled) continue;
      for (const Account& momentum : run.ledger().momentum) {
        if (GetParam().space == Space::axisymmetric && &momentum == &run.ledger().momentum[0]) continue;  // hoops pull
        EXPECT_NEAR(momentum.store(), momentum.initial(), rounding * momentum.scale());
      }
    }
  });
}

// Without the key the same losses are booked, and the energy of the points goes down or up by them.
TEST_P(Coupling, WithoutItLossesAreBooked) {
  for_each_way([&](const char* integrator, const char* shape, const char* transfer) {
    Simulation run(mixed(shape, transfer, true), integrator, {0.3, 0.01});
    for (int k = 0; k < 30; ++k) run.step(1);
    scenes::expect_ledger_closes(run.ledger(), rounding);
    const Account& energy = run.ledger().energy;
    EXPECT_NEAR(energy.initial() - energy.store(), lost(run.ledger()), rounding * energy.scale());
    EXPECT_GT(std::abs(lost(run.ledger())), 1e6 * rounding * energy.scale());
    for (const Body& body : run.scene().bodies) {
      EXPECT_FALSE(body.points.has(column::kept_loss));
      EXPECT_EQ(body.points.has(column::transfer_loss), body.material->takes_heat());
    }
  });
}

// Beside a step that only books, the gas has after one step in addition just what the other one booked, and each point
//   m_p sum_i N_ip L_i / G_i,  L_i = sum_q loss_q N_iq, G_i = sum_p m_p N_ip,
// worked out here from the points; what falls on nodes without gas waits. Nothing else differs. [Coupling 1]
TEST_P(Coupling, GasTakesWhatFallsOnItsNodes) {
  const int dim = scenes::dim_of(GetParam().space);
  for_each_way([&](const char* integrator, const char* shape, const char* transfer) {
    const Space space = GetParam().space;
    const Scene start = scenes::gas_and_skin(GetParam().skin, space, shape, transfer, false, scenes::half_out(space));
    const double dt = 0.01;
    Scene giving = start;
    giving.loss_to_gas = true;
    Simulation off(start, integrator, {0.3, dt}), on(giving, integrator, {0.3, dt});
    const double before = std::string(integrator) == "leapfrog" ? dt / 2 : 0;
    const auto gas = scenes::places_of(start.bodies[0], dim, before);
    const auto skin = scenes::places_of(start.bodies[1], dim, before);
    off.step(1);
    on.step(1);
    const auto mass = scenes::by_id(on.scene().bodies[0], column::mass);
    const auto given = scenes::by_id(on.scene().bodies[1], column::transfer_loss);
    const auto waiting = scenes::by_id(on.scene().bodies[1], column::kept_loss);
    double all = 0, scale = 0, out = 0;
    for (double loss : given) {
      all += loss;
      scale += std::abs(loss);
    }
    EXPECT_NEAR(all, lost(off.ledger()), rounding * heat(on.scene()));
    EXPECT_NEAR(heat(on.scene()) - heat(off.scene()) + kept(on), all, rounding * heat(on.scene()));
    std::map<scenes::Node, double> bare, loss;
    for (std::size_t p = 0; p < gas.size(); ++p) {
      for (const auto& [node, n] : scenes::weights_at(shape, start.grid, gas[p])) bare[node] += n * mass[p];
    }
    for (std::size_t q = 0; q < skin.size(); ++q) {
      double missed = 0;
      for (const auto& [node, n] : scenes::weights_at(shape, start.grid, skin[q])) {
        loss[node] += n * given[q];
        if (!bare.contains(node)) missed += n;
      }
      EXPECT_NEAR(waiting[q], missed * given[q], 1e-14 * scale);
      out += missed;
    }
    EXPECT_GT(out, 0.05);
    const auto with = scenes::by_id(on.scene().bodies[0], column::energy),
               without = scenes::by_id(off.scene().bodies[0], column::energy);
    for (std::size_t p = 0; p < gas.size(); ++p) {
      double share = 0;
      for (const auto& [node, n] : scenes::weights_at(shape, start.grid, gas[p])) {
        if (n != 0 && loss.contains(node)) share += n * loss[node] / bare[node];
      }
      EXPECT_NEAR(with[p] - without[p], share, 1e-14 * with[p] + 1e-12 * std::abs(share)) << p;
    }
    for (const ColumnId* id : {&column::position, &column::velocity}) {
      for (int d = 0; d < dim; ++d) {
        for (std::size_t b = 0; b < 2; ++b) {
          EXPECT_EQ(scenes::by_id(on.scene().bodies[b], *id, d), scenes::by_id(off.scene().bodies[b], *id, d));
        }
      }
    }
  });
}

// A membrane by itself keeps all that it lost, and the gas far away goes on bit for bit as without it. When gas comes,
// it has all that fell on its nodes: points whose nodes all carry gas have nothing left. [Coupling 1]
TEST_P(Coupling, LossesWaitForGas) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    Scene scene = mixed("quadratic", "apic", false);
    scene.loss_to_gas = true;
    scene.grid.cells[0] += 10;
    const auto move_gas = [](Columns& gas, double by) {
      for (int p = 0; p < gas.points(); ++p) gas(column::position)[p] += by;
    };
    move_gas(scene.bodies[0].points, 0.9);
    Scene without = scene;
    without.bodies.pop_back();
    Simulation run(scene, integrator, {0.3, 0.01}), alone(without, integrator, {0.3, 0.01});
    const double start = run.ledger().energy.initial();
    for (int k = 0; k < 10; ++k) {
      run.step(1);
      alone.step(1);
      ASSERT_TRUE(scenes::same_bits(run.scene().bodies[0], alone.scene().bodies[0])) << "step " << k;
    }
    EXPECT_NEAR(kept(run), lost(run.ledger()), rounding * start);
    EXPECT_GT(std::abs(kept(run)), 1e6 * rounding * start);
    Checkpoint checkpoint = run.save();
    move_gas(checkpoint.points[0], -0.9);
    checkpoint.step_limit.reset();
    run.restore(checkpoint);
    for (int k = 0; k < 20; ++k) {
      run.step(1);
      ASSERT_NEAR(run.ledger().energy.store() + kept(run), start, rounding * start) << "step " << k;
      if (k > 0) continue;
      int emptied = 0;
      for (double left : scenes::by_id(run.scene().bodies[1], column::kept_loss)) emptied += left == 0;
      EXPECT_GE(emptied, 6);
    }
  }
}

// The stages one by one do what the one pass does. [Coupling 1]
TEST_P(Coupling, StagesOneByOneAreTheSame) {
  for (const char* shape : {"quadratic", "cubic"}) {
    Scene fused = mixed(shape, "apic", true);
    fused.loss_to_gas = true;
    fused.chain_relaxation = 0.5;
    fused.strain_smoothing = 0.2;
    Scene single = fused;
    Ledger fused_ledger, single_ledger;
    const auto one = make_engine(fused, fused_ledger, {true, true}),
               by_one = make_engine(single, single_ledger, {true, true});
    const double dt = 0.01;
    for (Engine* engine : {one.get(), by_one.get()}) {
      engine->initialise();
      for (int k = 0; k < 5; ++k) {
        engine->locate_points();
        engine->map_mass_and_momentum();
        engine->evaluate_stress(NodalVelocity::start);
        engine->map_forces();
        engine->advance_momentum(dt);
        if (engine == one.get()) {
          engine->finish_points(dt, {});
        } else {
          engine->move_points(dt);
          engine->strain_points(dt, NodalVelocity::midpoint);
          engine->return_transfer_loss();
        }
      }
    }
    for (std::size_t b = 0; b < 2; ++b) {
      for (const ColumnId* id : {&column::position, &column::velocity, &column::energy, &column::strain}) {
        if (!fused.bodies[b].points.has(*id)) continue;
        const auto left = scenes::by_id(fused.bodies[b], *id), right = scenes::by_id(single.bodies[b], *id);
        for (std::size_t p = 0; p < left.size(); ++p) EXPECT_NEAR(left[p], right[p], 1e-12) << id->name();
      }
    }
  }
}

// Heat exchanged through nodes that the gas shares: none is made or lost, and no point gets colder than the coldest,
// however much of the nodes' mass is the membrane's. [Exchange 1]
TEST_P(Coupling, ExchangedHeatStaysInTheGas) {
  const Space space = GetParam().space;
  const int dim = scenes::dim_of(space);
  for (const char* integrator : {"leapfrog", "energy"}) {
    for (const double kappa : {1.0, 1e6}) {
      Scene scene = mixed("cubic", "apic", false);
      for (Body& body : scene.bodies) {
        body.points.add(column::affine, dim * dim);
        for (int d = 0; d < dim; ++d) {
          for (int p = 0; p < body.points.points(); ++p) {
            body.points(column::velocity, d)[p] = -2 * body.points(column::position, d)[p];
            body.points(column::affine, d * dim + d)[p] = -2;
          }
        }
      }
      const auto mass = scenes::by_id(scene.bodies[0], column::mass);
      const auto start = scenes::by_id(scene.bodies[0], column::energy);
      std::vector<double> energy[2];
      for (const int on : {0, 1}) {
        scene.heat_exchange = on * kappa;
        Simulation run(scene, integrator, {0.3, 1e-3});
        run.step(1);
        scenes::expect_ledger_closes(run.ledger(), rounding);
        energy[on] = scenes::by_id(run.scene().bodies[0], column::energy);
      }
      const auto [coldest, hottest] = std::minmax_element(start.begin(), start.end());
      double gain = 0, moved = 0;
      for (std::size_t p = 0; p < mass.size(); ++p) {
        const double change = energy[1][p] - energy[0][p];
        gain += mass[p] * change;
        moved += mass[p] * std::abs(change);
        EXPECT_GE(start[p] + change, *coldest - 1e-15);
        EXPECT_LE(start[p] + change, *hottest + 1e-15);
      }
      EXPECT_NEAR(gain, 0, 1e-15 * static_cast<double>(mass.size()));
      EXPECT_GT(moved, 1e-6);
    }
  }
}

// A run taken up again from what was saved goes on bit for bit, with what waits.
TEST_P(Coupling, GoesOnFromACheckpoint) {
  const Space space = GetParam().space;
  Scene scene = scenes::gas_and_skin(GetParam().skin, space, "cubic", "apic", false, scenes::half_out(space));
  scene.loss_to_gas = true;
  scene.chain_relaxation = 0.5;
  scene.strain_smoothing = 0.1;
  Simulation run(scene, "leapfrog", {0.3, 0.01}), again(scene, "leapfrog", {0.3, 0.01});
  for (int k = 0; k < 4; ++k) run.step(1);
  again.restore(run.save());
  for (int k = 0; k < 4; ++k) {
    run.step(1);
    again.step(1);
  }
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_TRUE(scenes::same_bits(run.scene().bodies[b], again.scene().bodies[b]));
  }
  EXPECT_EQ(scenes::by_id(run.scene().bodies[1], column::kept_loss),
            scenes::by_id(again.scene().bodies[1], column::kept_loss));
  scenes::expect_same_ledger(run.ledger(), again.ledger());
}

// Of elastic solids the gas gets what the maps lose. What the work of their stress and their energy differ by stays
// booked. [Coupling 1]
TEST(CouplingSolids, GiveWhatTheMapsLose) {
  for (const Space space : scenes::spaces) {
    for (const scenes::Law law : {scenes::Law::hooke, scenes::Law::neo_hookean}) {
      for (const char* integrator : {"leapfrog", "energy"}) {
        Scene scene = scenes::gas_and_skin(Skin::segments, space, "cubic", "apic", true);
        scene.bodies[1] = scenes::rough_solid(law, scene).bodies[0];
        scene.loss_to_gas = true;
        Simulation run(scene, integrator, {0.3, 0.005});
        for (int k = 0; k < 10; ++k) run.step(1);
        const Account& energy = run.ledger().energy;
        EXPECT_NEAR(energy.store() + kept(run), energy.initial() + energy.flow(Flow::constitutive),
                    rounding * energy.scale())
            << space << ' ' << law << ' ' << integrator;
        EXPECT_GT(std::abs(energy.flow(Flow::constitutive)), 0);
        scenes::expect_ledger_closes(run.ledger(), 1e-12);
      }
    }
  }
}

// A gas alone, or a membrane in a field of its own, does not notice the key: not a bit changes. [Coupling 1]
TEST(CouplingAlone, TheKeyChangesNothing) {
  for (const Space space : scenes::spaces) {
    for (const bool with_membrane : {false, true}) {
      Scene scene = scenes::gas_and_skin(Skin::segments, space, "cubic", "apic", true);
      scene.bodies[1].field = "its own";
      if (!with_membrane) scene.bodies.pop_back();
      Scene keyed = scene;
      keyed.loss_to_gas = true;
      Simulation run(scene, "leapfrog", {0.3, {}, 1}), other(keyed, "leapfrog", {0.3, {}, 1});
      for (int k = 0; k < 10; ++k) {
        run.step(1);
        other.step(1);
      }
      for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        EXPECT_TRUE(scenes::same_bits(run.scene().bodies[b], other.scene().bodies[b])) << space;
      }
      scenes::expect_same_ledger(run.ledger(), other.ledger());
    }
  }
}

TEST(CouplingAlone, StepsThatReturnNoLossRefuse) {
  Scene scene = scenes::gas_and_skin(Skin::segments, Space::plane, "quadratic", "apic", true);
  scene.loss_to_gas = true;
  for (const IntegratorEntry& entry : integrators()) {
    if (!lacks(entry, scene.shape, scene.transfer).empty()) continue;
    if (traits_of(entry).offers.count(Trait::returned_loss) > 0) {
      EXPECT_NO_THROW(Simulation(scene, entry.name, {0.3, {}, 1})) << entry.name;
      continue;
    }
    try {
      const Simulation run(scene, entry.name, {0.3, {}, 1});
      ADD_FAILURE() << entry.name << " took it";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(entry.name), std::string::npos) << error.what();
    }
  }
}

// [Filter 1]
TEST(CouplingAlone, AFilterAtARateRefusesContactThatChangesTheStart) {
  Scene scene = scenes::gas_and_skin(Skin::segments, Space::plane, "quadratic", "apic", true);
  scene.bodies[1].field = "its own";
  for (const char* contact : {"touching", "york-9.7"}) {
    for (const double rate : {0.0, 2.0}) {
      scene.contact = contact;
      scene.filter.sound = rate;
      const auto make = [&] { const Simulation run(scene, "leapfrog", {0.3, {}, 1}); };
      if (rate == 0 || scene.contact == "touching")
        EXPECT_NO_THROW(make()) << contact;
      else
        EXPECT_THROW(make(), std::invalid_argument);
    }
  }
}

// A field of 4,400 gas points and a membrane of 600: enough for threads to share in every loop.
Scene wide(Skin skin) {
  const GridSpec grid = scenes::plane(24, 24, 0.1, scenes::walls_everywhere(Wall::symmetry));
  const auto places = scenes::jittered(scenes::lattice(grid, 3, {1, 1, 0}, {23, 23, 1}), 0.012, 2);
  scenes::Random random(9);
  Body gas = scenes::gas_body(scenes::rough_law(), 2, places, scenes::lattice_volume(grid, 3), [&](auto&) {
    return scenes::GasState{random(0.5, 1.5), random(1, 2), {random(-0.4, 0.4), random(-0.4, 0.4), 0}};
  });
  std::vector<scenes::Place> ring;
  for (int k = 0; k < 600; ++k) {
    const double a = 2 * std::numbers::pi * k / 600;
    ring.push_back({1.2 + 0.9 * std::cos(a), 1.2 + 1.0 * std::sin(a), 0});
  }
  Body membrane = scenes::skin_body(skin, Space::plane, ring, 0.02 * 0.01);
  for (int p = 0; p < 600; ++p) {
    for (int d = 0; d < 2; ++d) membrane.points(column::velocity, d)[p] = random(-0.3, 0.3);
  }
  Scene scene = scenes::scene_of(grid, {std::move(gas), std::move(membrane)}, "cubic", "apic");
  scene.loss_to_gas = true;
  scene.sharpening = scene.heat_exchange = 1;
  scene.chain_relaxation = 0.5;
  scene.strain_smoothing = 0.1;
  return scene;
}

// Bit for bit, the waiting losses too.
TEST(CouplingThreads, NoResultDependsOnThem) {
  for (const Skin skin : {Skin::closed_segments, Skin::plane_stress}) {
    for (const char* integrator : {"leapfrog", "energy"}) {
      Simulation one(wide(skin), integrator, {0.3, {}, 1});
      for (int k = 0; k < 3; ++k) one.step(1);
      for (const int threads : {2, 3}) {
        Simulation more(wide(skin), integrator, {0.3, {}, threads});
        for (int k = 0; k < 3; ++k) more.step(1);
        for (std::size_t b = 0; b < 2; ++b) {
          EXPECT_TRUE(scenes::same_bits(one.scene().bodies[b], more.scene().bodies[b])) << skin << ' ' << threads;
        }
        EXPECT_EQ(scenes::by_id(one.scene().bodies[1], column::kept_loss),
                  scenes::by_id(more.scene().bodies[1], column::kept_loss));
        scenes::expect_same_ledger(one.ledger(), more.ledger());
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::coupling_test
