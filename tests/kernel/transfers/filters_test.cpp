// The transfers xpic and fmpm against matrices: S takes nodal values to the points, S+ takes the points' to the nodes, both
// written out entry by entry, walls as images.
#include <gmock/gmock.h>
#include <Eigen/Core>

#include "kernel/transfers/transfer.hpp"
#include "tests/kernel/dense.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::filters_test {
namespace {

using Dense = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using testing::HasSubstr;

// --- names ----------------------------------------------------------------------------------------------------------

TEST(TransferChoice, KnowsItsNames) {
  EXPECT_FALSE(transfer_of("pic", 2).affine);
  EXPECT_EQ(transfer_of("pic", 2).keep, 0);
  EXPECT_EQ(transfer_of("pic", 2).order, 0);
  EXPECT_EQ(transfer_of("flip", 2).keep, 1);
  EXPECT_TRUE(transfer_of("apic", 2).affine);
  EXPECT_EQ(transfer_of("xpic", 3).order, 3);
  EXPECT_FALSE(transfer_of("xpic", 3).filters_end);
  EXPECT_EQ(transfer_of("fmpm", 5).order, 5);
  EXPECT_TRUE(transfer_of("fmpm", 5).filters_end);
}

TEST(TransferChoice, SaysWhatItDoesNotHave) {
  const auto refusal = [](const std::string& name, int order) -> std::string {
    try {
      transfer_of(name, order);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal("tpic", 2), HasSubstr("tpic"));
  for (const char* name : {"xpic", "fmpm"}) {
    for (int order : {0, -3}) {
      EXPECT_THAT(refusal(name, order), HasSubstr(name));
      EXPECT_THAT(refusal(name, order), HasSubstr(std::to_string(order)));
    }
    EXPECT_EQ(refusal(name, 1), "");
  }
  EXPECT_EQ(refusal("flip", 0), "");  // which has no order
  Scene scene = scenes::rough_gas(2, "quadratic", "fmpm");
  scene.transfer_order = 0;
  EXPECT_THROW(Simulation(scene, "usl", {}), std::invalid_argument);
}

TEST(Filters, RefusePistons) {
  for (const char* transfer : {"xpic", "fmpm"}) {
    Scene scene = scenes::rough_gas(2, "quadratic", transfer);
    scene.pistons = {{0, 0, 0.1, 0.1}};
    EXPECT_THROW(Simulation(scene, "usl", {}), std::invalid_argument) << transfer;
  }
}

// --- one step against matrices --------------------------------------------------------------------------------------

// Gas without pressure in a box that is symmetric or sticks on its low sides, pulled by gravity.
Scene dust(int dim, Wall low, const std::string& shape, const std::string& transfer, int order, int per_cell = 2) {
  const Wall f = Wall::free;
  const GridSpec grid = dim == 1 ? scenes::line(6, 0.1, scenes::walls(low, f))
                                 : scenes::plane(5, 4, 0.1, scenes::walls(low, f, low, f));
  const auto places = scenes::jittered(scenes::lattice(grid, per_cell, {0, 0, 0}, {3, 3, 1}), 0.04 / per_cell, dim);
  scenes::Random random(31);
  Scene scene = scenes::scene_of(
      grid,
      {scenes::gas_body({}, dim, places, scenes::lattice_volume(grid, per_cell),
                        [&](auto&) {
                          return scenes::GasState{random(0.5, 1.5), 0, {random(-0.4, 0.4), random(-0.4, 0.4), 0}};
                        })},
      shape, transfer, {2, -3});
  scene.transfer_order = order;
  return scene;
}

double weight(const std::string& shape, double u) {
  const double a = std::abs(u);
  if (shape == "linear") return std::max(0.0, 1 - a);
  if (shape == "quadratic") return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
  return a < 1 ? 2.0 / 3 - a * a + a * a * a / 2 : a < 2 ? std::pow(2 - a, 3) / 6 : 0;
}

// S of velocity component `component`, or of masses (-1): node lines of a walled side carry their images with the sign that
// the component has there, and none where it is odd.
Dense matrix(const Scene& scene, int component) {
  const GridSpec& grid = scene.grid;
  const Columns& points = scene.bodies[0].points;
  const auto along = [&](int d, double x, int k) {
    const double u = (x - grid.origin[static_cast<std::size_t>(d)]) / grid.h;
    const Wall wall = grid.walls[static_cast<std::size_t>(d)][0];
    if (wall == Wall::free) return weight(scene.shape, u - k);
    const bool odd = component >= 0 && (wall == Wall::no_slip || component == d);
    if (k < 0 || (k == 0 && odd)) return 0.0;
    return weight(scene.shape, u - k) + (k == 0 ? 0 : (odd ? -1 : 1) * weight(scene.shape, u + k));
  };
  const int first = -1, nodes[2] = {grid.cells[0] + 3, grid.dim > 1 ? grid.cells[1] + 3 : 1};
  Dense s = Dense::Zero(points.points(), nodes[0] * nodes[1]);
  for (int p = 0; p < points.points(); ++p) {
    for (int j = 0; j < nodes[1]; ++j) {
      for (int i = 0; i < nodes[0]; ++i) {
        double n = along(0, points(column::position)[p], first + i);
        if (grid.dim > 1) n *= along(1, points(column::position, 1)[p], first + j);
        s(p, i + nodes[0] * j) = n;
      }
    }
  }
  return s;
}

struct Maps {
  Dense s, back;  // S, S+
  Column v;       // of the points
  double pull;
  Maps(const Scene& scene, int component)
      : s(matrix(scene, component)),
        pull(scene.gravity[static_cast<std::size_t>(component)]) {
    const Columns& points = scene.bodies[0].points;
    const auto m = Eigen::Map<const Column>(points(column::mass), points.points());
    const Column mass = matrix(scene, -1).transpose() * m;
    back = s.transpose() * m.asDiagonal();
    for (int i = 0; i < mass.size(); ++i) back.row(i) *= mass[i] > 1e-14 ? 1 / mass[i] : 0.0;
    v = Eigen::Map<const Column>(points(column::velocity, component), points.points());
  }
  Column start() const { return back * v; }
  Column acceleration() const { return back * Column::Constant(v.size(), pull); }  // M_i b, folded as all forces are
  // sum_{j < m} (1 - P)^j u with P = S+ S.
  Column filtered(Column u, int m) const {
    Column sum = u;
    for (int j = 1; j < m; ++j) {
      u -= back * (s * u);
      sum += u;
    }
    return sum;
  }
};

std::vector<double> velocities_after(const Scene& made, double dt, int component) {
  Scene scene = made;
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->map_forces();
  engine->advance_momentum(dt);
  engine->kick_points(dt);
  return scenes::by_id(scene.bodies[0], column::velocity, component);
}

template <class Check>
void for_scenes(const std::string& transfer, const std::vector<int>& orders, Check&& check) {
  for (int dim : {1, 2}) {
    for (Wall low : {Wall::free, Wall::symmetry, Wall::no_slip}) {
      for (const char* shape : {"linear", "quadratic", "cubic"}) {
        for (int order : orders) {
          SCOPED_TRACE(testing::Message()
                       << dim << "-D, wall " << static_cast<int>(low) << ", " << shape << ", m = " << order);
          check(dust(dim, low, shape, transfer, order));
        }
      }
    }
  }
}

// v_p = sum_i N_ip (w_i + dt a_i), w = sum_{j < m} (1 - P)^j v. A hundred terms of order one, m times: 1e-13. [XPIC 1]
TEST(Xpic, IsItsFormula) {
  const double dt = 0.01;
  for_scenes("xpic", {1, 2, 3, 7}, [&](const Scene& scene) {
    for (int d = 0; d < scene.grid.dim; ++d) {
      const Maps maps(scene, d);
      const Column expected = maps.s * (maps.filtered(maps.start(), scene.transfer_order) + dt * maps.acceleration());
      const auto v = velocities_after(scene, dt, d);
      for (std::size_t p = 0; p < v.size(); ++p) ASSERT_NEAR(v[p], expected[static_cast<int>(p)], 1e-13);
    }
  });
}

// v_p = sum_i N_ip w_i, w = sum_{j < m} (1 - P)^j v~. [FMPM 1]
TEST(Fmpm, IsItsFormula) {
  const double dt = 0.01;
  for_scenes("fmpm", {1, 2, 3, 7}, [&](const Scene& scene) {
    for (int d = 0; d < scene.grid.dim; ++d) {
      const Maps maps(scene, d);
      const Column expected = maps.s * maps.filtered(maps.start() + dt * maps.acceleration(), scene.transfer_order);
      const auto v = velocities_after(scene, dt, d);
      for (std::size_t p = 0; p < v.size(); ++p) ASSERT_NEAR(v[p], expected[static_cast<int>(p)], 1e-13);
    }
  });
}

// Of order one both are pic. [XPIC 1] [FMPM 1]
TEST(Filters, OfOrderOneArePic) {
  for (const char* transfer : {"xpic", "fmpm"}) {
    for_scenes(transfer, {1}, [&](const Scene& scene) {
      Scene pic = scene;
      pic.transfer = "pic";
      for (int d = 0; d < scene.grid.dim; ++d) {
        const auto v = velocities_after(scene, 0.01, d), expected = velocities_after(pic, 0.01, d);
        for (std::size_t p = 0; p < v.size(); ++p) ASSERT_NEAR(v[p], expected[p], 1e-15);
      }
    });
  }
}

// Large m: what xpic keeps of the points' velocity tends to its projection on what nodes can make, orthogonal under the
// masses, and with more nodes than points to all of it, so to flip. What is left decays by 1 - lambda a term, lambda the least
// eigenvalue of S S+ that is not zero; here below 1e-7 of velocities below one. [XPIC 1]
TEST(Xpic, TendsToFlipWithoutWhatNoNodeSees) {
  const double dt = 0.01;
  for (const int per_cell : {1, 2}) {
    for (int dim : {1, 2}) {
      Scene scene = dust(dim, Wall::free, "linear", "xpic", 1, per_cell);
      const Columns& points = scene.bodies[0].points;
      for (int d = 0; d < dim; ++d) {
        const Maps maps(scene, d);
        const Column root = Eigen::Map<const Column>(points(column::mass), points.points()).cwiseSqrt();
        const Dense symmetric = root.asDiagonal() * maps.s * maps.back * root.cwiseInverse().asDiagonal();
        const auto [values, vectors] = dense::symmetric_spectrum(symmetric);
        Column kept = Column::Zero(points.points()), scaled = root.cwiseProduct(maps.v);
        double least = 1;
        for (int k = 0; k < points.points(); ++k) {
          if (values[k] < 1e-9) continue;
          least = std::min(least, values[k]);
          kept += vectors.col(k) * vectors.col(k).dot(scaled);
        }
        kept = kept.cwiseQuotient(root) + dt * maps.s * maps.acceleration();
        scene.transfer_order = static_cast<int>(std::ceil(std::log(1e-8) / std::log1p(-least)));
        ASSERT_LT(scene.transfer_order, 200000);
        const auto v = velocities_after(scene, dt, d);
        for (std::size_t p = 0; p < v.size(); ++p) EXPECT_NEAR(v[p], kept[static_cast<int>(p)], 1e-7);
        if (per_cell > 1 || dim > 1) continue;
        Scene flip = scene;
        flip.transfer = "flip";
        const auto expected = velocities_after(flip, dt, d);
        for (std::size_t p = 0; p < v.size(); ++p) EXPECT_NEAR(v[p], expected[p], 1e-7);
      }
    }
  }
}

// Large m: the velocities of fmpm are those whose momentum the full mass matrix S^T m S gives. [FMPM 1]
TEST(Fmpm, TendsToTheFullMassMatrix) {
  const double dt = 0.01;
  Scene scene = dust(1, Wall::free, "quadratic", "fmpm", 1, 4);
  const Columns& points = scene.bodies[0].points;
  const Maps maps(scene, 0);
  const auto m = Eigen::Map<const Column>(points(column::mass), points.points());
  const Dense full = maps.s.transpose() * m.asDiagonal() * maps.s;
  const Column momentum = maps.s.transpose() * m.cwiseProduct(maps.v) + dt * maps.pull * (maps.s.transpose() * m);
  const Column w = dense::solve(full, momentum);
  const Column expected = maps.s * w;
  const Dense symmetric = m.cwiseSqrt().asDiagonal() * maps.s * maps.back * m.cwiseSqrt().cwiseInverse().asDiagonal();
  const auto [values, vectors] = dense::symmetric_spectrum(symmetric);
  double least = 1;
  for (double value : values) {
    if (value > 1e-9) least = std::min(least, value);
  }
  scene.transfer_order = static_cast<int>(std::ceil(std::log(1e-9) / std::log1p(-least)));
  ASSERT_LT(scene.transfer_order, 200000);
  const auto v = velocities_after(scene, dt, 0);
  for (std::size_t p = 0; p < v.size(); ++p) EXPECT_NEAR(v[p], expected[static_cast<int>(p)], 1e-7);
}

// --- runs -----------------------------------------------------------------------------------------------------------

// Every account closes, for gases and solids, whatever m; and where there are no walls, none gives an impulse: the filter
// leaves the grid's momentum. [XPIC 1] [FMPM 1]
TEST(Filters, TheLedgerCloses) {
  for (const char* transfer : {"xpic", "fmpm"}) {
    for (scenes::Space space : scenes::spaces) {
      for (const char* shape : {"quadratic", "contiguous-gimp"}) {
        for (int order : {1, 2, 5}) {
          for (const bool walled : {false, true}) {
            SCOPED_TRACE(testing::Message() << transfer << ' ' << order << ", " << space << ", " << shape);
            const Scene gas = walled ? scenes::rough_gas(space, shape, transfer)
                                     : scenes::rough_gas_in_space(space, shape, transfer, scenes::no_gravity);
            for (Scene scene : {gas, scenes::rough_solid(scenes::Law::neo_hookean, gas)}) {
              scene.transfer_order = order;
              Simulation run(std::move(scene), "musl", {0.2, {}});
              for (int k = 0; k < 8; ++k) run.step(1);
              const Ledger& ledger = run.ledger();
              scenes::expect_ledger_closes(ledger, 1e-13);
              if (walled) continue;
              for (std::size_t d = space == scenes::Space::axisymmetric ? 1 : 0; d < 3; ++d) {
                EXPECT_NEAR(ledger.momentum[d].flow(Flow::walls), 0, 1e-14 * ledger.momentum[d].scale());
                EXPECT_NEAR(ledger.momentum[d].store(), ledger.momentum[d].initial(),
                            1e-14 * ledger.momentum[d].scale());
              }
            }
          }
        }
      }
    }
  }
}

// A uniform velocity is kept by all of them, and with m >= 2 a linear one loses less than with pic: for the lattice of a shape
// the map and back damps the wave number k by S(k)^2, m terms by (1 - S^2)^m. [XPIC 1] [FMPM 1]
TEST(Filters, LoseLessWithEachTerm) {
  for (const char* transfer : {"xpic", "fmpm"}) {
    double before = 1;
    for (int order : {1, 2, 4, 8}) {
      const int cells = 32;
      const GridSpec grid = scenes::line(cells, 1.0, scenes::walls(Wall::symmetry, Wall::symmetry));
      const double wave = std::acos(-1.0) * 4 / cells;
      Scene scene = scenes::scene_of(grid,
                                     {scenes::gas_body({}, 1, scenes::lattice(grid, 4), 0.25,
                                                       [&](const scenes::Place& x) {
                                                         return scenes::GasState{1, 0, {std::sin(wave * x[0]), 0, 0}};
                                                       })},
                                     "quadratic", transfer);
      scene.transfer_order = order;
      const auto v = velocities_after(scene, 0, 0);
      const auto x = scenes::by_id(scene.bodies[0], column::position);
      double amplitude = 0;
      for (std::size_t p = 0; p < v.size(); ++p)
        amplitude += 2 * v[p] * std::sin(wave * x[p]) / static_cast<double>(v.size());
      const double s = std::pow(std::sin(wave / 2) / (wave / 2), 3);  // transform of the quadratic spline
      // Images of the wave beyond the grid's wave numbers are below (k / 2 pi)^3 of it.
      EXPECT_NEAR(1 - amplitude, std::pow(1 - s * s, order), 5e-4) << order;
      EXPECT_LT(1 - amplitude, before);
      before = 1 - amplitude;
    }
  }
}

}  // namespace
}  // namespace plumbline::filters_test
