#include "cases/harness/parts/pair_gates.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "cases/harness/parts/contact_gates.hpp"
#include "cases/harness/parts/parts.hpp"
#include "kernel/contact/pair_potential.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

constexpr double cell = 0.3, approach_speed = 1, lasts = 0.5;  // m, m/s, s: they meet after .06 s and for about .25

// Four cells along x from `first` cells on, two points a cell and direction.
Body block(const std::string& name, int dim, double first, double speed) {
  const int count[3] = {8, dim > 1 ? 6 : 1, dim > 2 ? 4 : 1};
  auto elastic = std::make_shared<LinearElastic>();
  elastic->youngs_modulus = 100;
  elastic->poissons_ratio = 0.3;
  elastic->density = 1;
  Body body = make_body(name, elastic, count[0] * count[1] * count[2], dim);
  body.field = name;
  body.spacing = cell / 2;
  for (int p = 0; p < body.points.points(); ++p) {
    const int index[3] = {p % count[0], p / count[0] % count[1], p / (count[0] * count[1])};
    for (int d = 0; d < dim; ++d)
      body.points(column::position, d)[p] = cell * ((d == 0 ? first : 2) + (index[d] + 0.5) / 2);
    body.points(column::volume)[p] = body.points(column::mass)[p] = std::pow(body.spacing, dim);
    body.points(column::velocity)[p] = speed;
  }
  return body;
}

// Off centre, so that they turn, too.
Scene two_blocks(const ContactEntry& law, int dim) {
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.h = cell;
  scene.grid.cells = {14, dim > 1 ? 9 : 1, dim > 2 ? 8 : 1};
  scene.shape = "quadratic";
  scene.transfer = "apic";
  scene.contact = law.name;
  scene.bodies = {block("left", dim, 2, approach_speed), block("right", dim, 6.5, 0)};
  for (int d = 1; d < dim; ++d) {
    double* x = scene.bodies[1].points(column::position, d);
    std::for_each(x, x + scene.bodies[1].points.points(), [](double& at) { at += 0.4 * cell; });
  }
  return scene;
}

struct Meeting {
  double momentum = 0;  // largest deviation, over m v
  double energy = 0;    // largest rise in a step, over that of the start
  double speed = 0;     // with which they approach at the end, over that of the start
  double left = 0;      // energy of their pairs at the end, over that of the start
};

Meeting meeting_of(const ContactEntry& law, int dim) {
  Simulation simulation(two_blocks(law, dim), "midpoint", {0.5, {}});
  const double start = simulation.ledger().initial_stores.total();
  double last = start + contact_energy(simulation.scene());
  Meeting found;
  simulation.run_until(lasts, [&](const Simulation& now) {
    const double energy = now.ledger().stores.total() + contact_energy(now.scene());
    found.energy = worse((energy - last) / start, found.energy);
    last = energy;
    for (int d = 0; d < dim; ++d) {
      const Account& account = now.ledger().momentum[static_cast<std::size_t>(d)];
      found.momentum = worse(std::abs(account.store() - account.initial()) / account.scale(), found.momentum);
    }
  });
  const auto speed = [&](std::size_t b) {
    const Columns& points = simulation.scene().bodies[b].points;
    const auto v = points.values(column::velocity).first(static_cast<std::size_t>(points.points()));
    double sum = 0;
    for (const double one : v) sum += one;
    return sum / points.points();
  };
  found.speed = (speed(0) - speed(1)) / approach_speed;
  found.left = contact_energy(simulation.scene()) / start;
  return found;
}

}  // namespace

std::vector<MeasuredGate> pair_gates(const ContactEntry& law) {
  std::vector<MeasuredGate> all;
  const char* const spaces[] = {"line", "plane", "space"};
  for (int dim = 1; dim <= 3; ++dim) {
    const auto row = [&](const std::string& family, const std::string& quantity, double bound, Origin origin,
                         const std::string& reason, const char* cause, double Meeting::*measure) {
      all.push_back({family, gate_row(family, spaces[dim - 1], quantity, {{}, bound}, origin, reason), cause,
                     [&law, dim, measure] { return plain(meeting_of(law, dim).*measure); }});
    };
    row("momentum", "largest change of the momentum of both, over the larger of their shares", rounding_of_parts,
        Origin::identity, "what one body gets the other gives; a few thousand roundings",
        "forces on two points that are not opposite", &Meeting::momentum);
    row("energy", "largest rise in a step, with the energy of the pairs, over that of the start", rounding_of_parts,
        Origin::theory, "springs raise no energy by the step midpoint, nor do those that open and close",
        "a force that is not the mean slope of its potential", &Meeting::energy);
    row("approach", "share of the approach speed that is left", 1 - least_slowed, Origin::theory,
        "bodies that touch and approach are slowed down", "contact is not found, or does nothing", &Meeting::speed);
    row("release", "energy of the pairs once the bodies have parted, over that of the start", 0, Origin::theory,
        "bodies that have parted are let go", "a reach without end, or bodies that stick", &Meeting::left);
  }
  return all;
}

}  // namespace plumbline
