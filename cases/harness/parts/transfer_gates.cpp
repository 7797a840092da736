#include "cases/harness/parts/transfer_gates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases/harness/parts/largest_entry.hpp"
#include "cases/harness/parts/parts.hpp"
#include "cases/harness/parts/shape_probe.hpp"
#include "cases/harness/parts/transfer_probe.hpp"

namespace plumbline {
namespace {

constexpr int transfers_points = 300;
constexpr int passes = 3;
constexpr unsigned long transfers_seed = 60;

// A transfer under a shape in one geometry.
struct Subject {
  const TransferEntry* transfer;
  const ShapeEntry* shape;
  std::size_t geometry;
};

bool offers(const Choice& part, Trait trait) { return part.offers.count(trait) > 0; }

Scene scene_of(const Subject& subject, const std::array<std::array<Wall, 2>, 3>& walls) {
  Scene scene;
  scene.grid = probe_grid(subject.geometry, false);
  scene.grid.walls = walls;
  if (scene.grid.axisymmetric) scene.grid.walls[0][0] = Wall::symmetry;  // the axis
  scene.shape = subject.shape->name;
  scene.transfer = subject.transfer->name;
  return scene;
}

std::array<std::array<Wall, 2>, 3> on_all_sides(Wall wall) {
  std::array<std::array<Wall, 2>, 3> walls;
  walls.fill({wall, wall});
  return walls;
}

// At random, those of rings a tenth of a cell off the axis.
std::vector<Eigen::VectorXd> anywhere(const GridSpec& grid) {
  std::vector<Eigen::VectorXd> places;
  for (const ProbePoint& point : probe_points(grid, transfers_points, transfers_seed, true)) {
    places.push_back(Eigen::Map<const Eigen::VectorXd>(point.x.data(), grid.dim));
  }
  return places;
}

std::vector<double> masses() {
  ProbeRandom random(transfers_seed + 1);
  std::vector<double> all(transfers_points);
  for (double& m : all) m = random(0.5, 2);
  return all;
}

// Velocities within 1, and C_p that adds as much a cell.
MotionAt at_random(const GridSpec& grid) {
  auto random = std::make_shared<ProbeRandom>(transfers_seed + 2);
  return [grid, random](const Eigen::VectorXd&) {
    const auto any = [&] { return (*random)(-1, 1); };
    return PointMotion{Eigen::VectorXd::NullaryExpr(grid.dim, any),
                       Eigen::MatrixXd::NullaryExpr(grid.dim, grid.dim, any) / grid.h};
  };
}

TransferProbe probe_of(const Scene& scene, const MotionAt& motion) {
  return {scene, anywhere(scene.grid), masses(), motion};
}
TransferProbe probe_at_random(const Scene& scene) { return probe_of(scene, at_random(scene.grid)); }

// Change of sum m v along one direction in a few passes, over sum m |v|.
double momentum_lost(const Scene& scene, std::size_t along) {
  TransferProbe probe = probe_at_random(scene);
  const Totals before = probe.totals();
  for (int k = 0; k < passes; ++k) probe.pass(0.01 * scene.grid.h, false);
  return std::abs(probe.totals().momentum[along] - before.momentum[along]) / before.momentum_scale;
}

double momentum_lost_in_the_open(const Subject& subject) {
  const Scene scene = scene_of(subject, on_all_sides(Wall::free));
  double worst = 0;
  for (std::size_t d = scene.grid.axisymmetric ? 1 : 0; d < static_cast<std::size_t>(scene.grid.dim); ++d) {
    worst = worse(momentum_lost(scene, d), worst);
  }
  return worst;
}

// Frictionless walls across one direction after another: what goes along them stays.
double momentum_lost_along_walls(const Subject& subject) {
  const auto dim = static_cast<std::size_t>(probe_grid(subject.geometry, false).dim);
  double worst = 0;
  for (std::size_t across = 0; across < dim; ++across) {
    auto walls = on_all_sides(Wall::free);
    walls[across] = {Wall::symmetry, Wall::symmetry};
    const Scene scene = scene_of(subject, walls);
    for (std::size_t d = scene.grid.axisymmetric ? 1 : 0; d < dim; ++d) {
      if (d != across) worst = worse(momentum_lost(scene, d), worst);
    }
  }
  return worst;
}

// Points that fall, move and come back from walls: the ledger's residual of an account, relative.
double residual(const Subject& subject, const std::function<double(const Ledger&)>& of) {
  double worst = 0;
  for (const Wall wall : {Wall::symmetry, Wall::no_slip, Wall::free}) {
    Scene scene = scene_of(subject, on_all_sides(wall));
    scene.gravity = {wall == Wall::free ? 0 : 0.3, -0.2, 0.4};
    TransferProbe probe = probe_at_random(scene);
    for (int k = 0; k < passes; ++k) probe.pass(0.05 * scene.grid.h, wall != Wall::free);
    worst = worse(of(probe.ledger()), worst);
  }
  return worst;
}

double momentum_residual(const Subject& subject) {
  return residual(subject, [](const Ledger& ledger) {
    double worst = 0;
    for (const Account& account : ledger.momentum) worst = worse(account.relative_drift(true), worst);
    return worst;
  });
}
double energy_residual(const Subject& subject) {
  return residual(subject, [](const Ledger& ledger) { return ledger.energy.relative_drift(true); });
}

double angular_momentum_lost(const Subject& subject) {
  TransferProbe probe = probe_at_random(scene_of(subject, on_all_sides(Wall::free)));
  const Totals before = probe.totals();
  for (int k = 0; k < passes; ++k) probe.pass(0.01, false);
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    worst = worse(std::abs(probe.totals().angular_momentum[k] - before.angular_momentum[k]) / before.angular_scale,
                  worst);
  }
  return worst;
}

// Kinetic energy, that of C_p with it, after each pass without forces over that before, less 1: the most.
double energy_growth(const Subject& subject) {
  TransferProbe probe = probe_at_random(scene_of(subject, on_all_sides(Wall::free)));
  double worst = -1, before = probe.totals().energy.kinetic;
  for (int k = 0; k < passes; ++k) {
    probe.pass(0.01, false);
    const double now = probe.totals().energy.kinetic;
    worst = worse(now / before - 1, worst);
    before = now;
  }
  return worst;
}

// What uniform velocities and a uniform pull make of velocities and places, less what they must: v + b dt and x + (v + b dt) dt.
double off_uniform(const Subject& subject) {
  Scene scene = scene_of(subject, on_all_sides(Wall::free));
  const int first = scene.grid.axisymmetric ? 1 : 0;  // nothing moves uniformly along the radius
  Eigen::VectorXd v = Eigen::Vector3d(0.4, -0.3, 0.5).head(scene.grid.dim),
                  b = Eigen::Vector3d(0.3, 0.7, -0.2).head(scene.grid.dim);
  v.head(first).setZero();
  b.head(first).setZero();
  for (int d = 0; d < scene.grid.dim; ++d) scene.gravity[static_cast<std::size_t>(d)] = b[d];
  const double dt = 0.1 * scene.grid.h;
  std::vector<Eigen::VectorXd> inside = anywhere(scene.grid);
  const Eigen::Map<const Eigen::VectorXd> origin(scene.grid.origin.data(), scene.grid.dim);
  for (Eigen::VectorXd& x : inside) {  // so that none leaves the grid
    for (int d = 0; d < scene.grid.dim; ++d) {
      const double extent = scene.grid.cells[static_cast<std::size_t>(d)] * scene.grid.h;
      x[d] = origin[d] + 0.1 * extent + 0.8 * (x[d] - origin[d]);
    }
  }
  TransferProbe probe(scene, inside, masses(), [&](const Eigen::VectorXd& x) {
    return PointMotion{v, Eigen::MatrixXd::Zero(x.size(), x.size())};
  });
  const Eigen::MatrixXd before = probe.places();
  probe.pass(dt, true);
  const Eigen::RowVectorXd end = (v + dt * b).transpose();
  return worse(largest_entry(probe.velocities().rowwise() - end),
               largest_entry((probe.places() - before).rowwise() - dt * end) / dt);
}

// Change of an affine velocity in a pass: of v_p, and of C_p times h.
double off_affine(const Subject& subject) {
  const Scene scene = scene_of(subject, on_all_sides(Wall::free));
  const int dim = scene.grid.dim;
  Eigen::MatrixXd b =
      (Eigen::Matrix3d() << 0.4, -1.1, 0.6, 0.9, -0.2, 1.3, -0.8, 0.7, 0.5).finished().topLeftCorner(dim, dim);
  if (scene.grid.axisymmetric) b(0, 1) = b(1, 0) = 0;  // smooth at the axis
  TransferProbe probe = probe_of(scene, [&](const Eigen::VectorXd& x) { return PointMotion{b * x, b}; });
  const Eigen::MatrixXd velocity = probe.velocities(), affine = probe.affine();
  probe.pass(0.01, false);
  return worse(largest_entry(probe.velocities() - velocity), scene.grid.h * largest_entry(probe.affine() - affine));
}

double velocity_change(const Subject& subject) {
  TransferProbe probe = probe_at_random(scene_of(subject, on_all_sides(Wall::free)));
  const Eigen::MatrixXd before = probe.velocities();
  probe.pass(0.01, false);
  return largest_entry(probe.velocities() - before);
}

// Pairs of points in one place with velocities that the grid cannot tell apart: how much theirs differ after a pass.
double twins_apart(const Subject& subject) {
  const Scene scene = scene_of(subject, on_all_sides(Wall::free));
  std::vector<Eigen::VectorXd> places = anywhere(scene.grid);
  for (std::size_t p = 0; p + 1 < places.size(); p += 2) places[p + 1] = places[p];
  TransferProbe probe(scene, places, masses(), at_random(scene.grid));
  probe.pass(0.01, false);
  const Eigen::MatrixXd after = probe.velocities();
  double worst = 0;
  for (Eigen::Index p = 0; p + 1 < after.rows(); p += 2) worst = worse((after.row(p + 1) - after.row(p)).norm(), worst);
  return worst;
}

// Whether the shape has what exact conservation of angular momentum wants.
bool keeps_angular_momentum(const Subject& subject) {
  const GridSpec grid = probe_grid(subject.geometry, false);
  return subject.transfer->does.affine && offers(*subject.shape, Trait::constant_inertia) && grid.dim > 1 &&
         !grid.axisymmetric;
}

void add_gates(const Subject& subject, std::vector<MeasuredGate>& all) {
  const std::string where = geometry_names()[subject.geometry];
  const auto row = [&](const std::string& family, const std::string& name, const std::string& quantity, Origin origin,
                       const std::string& reason, const char* cause, double (*measure)(const Subject&)) {
    all.push_back({family,
                   gate_row(family, name + "/" + where, quantity, {{}, rounding_of_parts}, origin,
                            reason + "; roundings of a few hundred points"),
                   cause, [subject, measure] { return plain(measure(subject)); }});
  };
  constexpr const char* lost = "a part of the velocity that no other point or node gets";
  row("momentum", "open", "change of sum m v over sum m |v| in three passes, of random velocities", Origin::identity,
      "nothing acts on the points", lost, momentum_lost_in_the_open);
  if (probe_grid(subject.geometry, false).dim > 1) {
    row("momentum", "along-walls", "change of sum m v along frictionless walls over sum m |v|, of random velocities",
        Origin::identity, "frictionless walls act across themselves alone", lost, momentum_lost_along_walls);
  }
  row("momentum", "booked", "residual of momentum between walls of each kind, of points that fall and move, relative",
      Origin::identity, "momentum changes by what walls and gravity give, and the ledger tells it",
      "what walls give in one of the two maps, or what of it points take", momentum_residual);
  row("energy", "booked", "residual of energy between walls of each kind, of points that fall and move, relative",
      Origin::identity, "what the maps take is known, and the ledger tells it", "the loss of another transfer is told",
      energy_residual);
  row("energy", "growth", "kinetic energy after a pass without forces over that before, less 1, of random velocities",
      Origin::theory, "a filter takes from each wave between nothing and all", "a filter that overshoots",
      energy_growth);
  row("reproduction", "uniform", "velocities and displacements of uniform motion under a uniform pull, less exact ones",
      Origin::identity, "uniform motion is kept, and a uniform pull accelerates all points alike",
      "weights of the two maps, or the pull, lack a factor", off_uniform);
  if (subject.transfer->does.affine) {
    row("reproduction", "affine", "velocity and C_p, in cells, of affine motion after a pass, less those before",
        Origin::identity, "the transfer claims to carry affine velocities", "C_p, or D_p, of another convention",
        off_affine);
  }
  if (keeps_angular_momentum(subject)) {
    row("momentum", "angular", "change of angular momentum over sum m |x| |v| in three passes, of random velocities",
        Origin::identity, "affine velocities keep angular momentum where D_p is the same everywhere", lost,
        angular_momentum_lost);
  }
  if (offers(*subject.transfer, Trait::unfiltered_velocities)) {
    row("claims", "unfiltered", "largest change of a velocity in a pass without forces, of random velocities",
        Origin::identity, "the transfer offers the trait unfiltered-velocities", "the grid's velocity is taken in part",
        velocity_change);
  }
  if (offers(*subject.transfer, Trait::returnable_loss)) {
    row("claims", "taken", "velocities of two points in one place after a pass, their difference", Origin::identity,
        "the transfer offers the trait returnable-loss: points take velocities that the grid has",
        "points keep a part of their own velocity", twins_apart);
  }
}

}  // namespace

std::vector<MeasuredGate> transfer_gates(const TransferEntry& transfer, const ShapeEntry& shape) {
  std::vector<MeasuredGate> all;
  for (std::size_t geometry = 0; geometry < geometry_names().size(); ++geometry) {
    add_gates({&transfer, &shape, geometry}, all);
  }
  std::vector<MeasuredGate> filters = transfer_filter_gates(transfer, shape);
  std::move(filters.begin(), filters.end(), std::back_inserter(all));
  return all;
}

}  // namespace plumbline
