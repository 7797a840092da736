// Two blocks fill a channel and meet at a flat face between its walls: one step, of which contact is all.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline::contact_wall {
namespace {

constexpr double height = 1, density = 1, youngs_modulus = 1;  // c = 1 m/s
constexpr int long_blocks = 3, margin = 2;                     // cells along the channel
constexpr double step = 1e-3;                                  // over h/c: stresses change a velocity by its square

struct Blocks : Parameters {
  using Parameters::Parameters;
  double speed = positive("speed", 1e-4, "m/s", "that the velocities of the left block are shares of");
  double towards = any_number("towards", 1, "1", "share of it towards the right block; below 0 they part");
  double along = any_number("along", 0, "1", "share of it along the faces");
};

class ContactWall final : public Problem {
 public:
  explicit ContactWall(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        start_(motion_of(block(1), 2).position[0]) {}

  double end_time() const override { return step * grid().h * std::sqrt(density / youngs_modulus); }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    for (const int which : {0, 1}) scene.bodies.push_back(block(which));
    Columns& moving = scene.bodies.front().points;
    std::fill_n(moving(column::velocity, 0), moving.points(), at_.towards * at_.speed);
    std::fill_n(moving(column::velocity, 1), moving.points(), at_.along * at_.speed);
    apply_choices(settings_, scene);
    return scene;
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& right = simulation.scene().bodies[1];
    const BodyMotion motion = motion_of(right, 2);
    double aside = 0;
    for (int p = 0; p < right.points.points(); ++p)
      aside = larger(aside, std::abs(right.points(column::velocity, 1)[p]) / at_.speed);
    // The nodes of the face bear half a cell of each block.
    const double share = motion.mass / (0.5 * density * grid().h * height * at_.speed);
    return {share_measure("taken", share * motion.velocity[0]), share_measure("aside", aside),
            share_measure("moved", share * (motion.position[0] - start_) / simulation.time())};
  }

  Profile profile(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies[1].points;
    const auto values = [&](const ColumnId& column, int d) {
      return std::vector<double>(points(column, d), points(column, d) + points.points());
    };
    Profile profile;
    profile.abscissa = "y";
    profile.columns = {
        {"y", "m", "y", values(column::position, 1)},
        {"velocity_x", "m/s", "velocity of the right block along the channel", values(column::velocity, 0)},
        {"velocity_y", "m/s", "and across it", values(column::velocity, 1)}};
    return profile;
  }

 private:
  GridSpec grid() const {
    GridSpec grid;
    grid.dim = 2;
    grid.h = height / settings_.number("cells");
    grid.cells = {2 * (margin + long_blocks), settings_.integer("cells"), 1};
    grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    return grid;
  }

  Body block(int which) const {
    auto elastic = std::make_shared<LinearElastic>();
    elastic->youngs_modulus = youngs_modulus;
    elastic->density = density;
    const GridSpec on = grid();
    const double from = (margin + which * long_blocks) * on.h;
    const SolidShape shape{{from, 0, 0}, {from + long_blocks * on.h, height, 0}};
    Body body = fill_solid(which == 0 ? "left" : "right", elastic, shape, density, settings_.integer("ppc"), on);
    constexpr double rounding = 1e-9;  // points touch where they are nearer than their spacing
    body.spacing *= 1 + rounding;
    return body;
  }

  Settings settings_;
  Blocks at_;
  double start_;  // where the right block stands
};

constexpr double cells = 6;

StudyPlan meeting(std::string id, std::string title, double towards, double along) {
  return study(std::move(id), std::move(title), "One step.", {cells}).with({{"towards", towards}, {"along", along}});
}

StudyPlan of_york(std::string id, std::string title, std::string criterion, double towards) {
  return study(std::move(id), std::move(title), "One step.", {cells})
      .of_york()
      .with({{"contact", std::move(criterion)}, {"towards", towards}, {"along", 1.0}});
}

constexpr double hardly = 0.01;  // of York's studies: a normal tilted further takes the one motion for the other

std::vector<StudyPlan> studies() {
  return {meeting("default", "head-on", 1, 0),
          meeting("sliding", "sliding as fast as meeting", 1, 1),
          meeting("parting", "sliding, and parting by a hundredth of that", -hardly, 1),
          of_york("york1997", "York's criterion 9.7, sliding, and meeting by a hundredth of that", "york-9.7", hardly),
          of_york("york-parting", "York's criterion 9.7, sliding, and parting by a hundredth", "york-9.7", -hardly),
          of_york("york-9.9-parting", "the same with criterion 9.9", "york-9.9", -hardly)};
}

std::vector<CaseGate> gates() {
  const Because straight = identity(
      "the impulse acts along the normal, which is that of the channel, but for rounding and a way of 1e-7 cells");
  const Because none = identity("bodies that part do not touch, however fast they slide");
  const Because none_but_places = identity("bodies that part do not touch; ways of 1e-8 m are known to 1e-8");
  const auto judged = [&](const std::string& study, const std::string& measure, double exact, const std::string& why) {
    return gate(
        study + "/" + measure, value_at(measure, cells), between(exact * (1 - 1e-4), exact * (1 + 1e-4)),
        theory(why + "; stresses of the step change that by (c dt/h)^2 = 1e-6, and ways of 1e-10 m are known to 1e-5"));
  };
  std::vector<CaseGate> all;
  for (const std::string study : {"default", "sliding"}) {
    all.push_back(judged(study, "taken", 1, "nodes of equal mass exchange their velocities along the normal"));
    all.push_back(judged(study, "moved", 0.5, "in the middle of the step they have the mean of both"));
    all.push_back(gate(study + "/aside", value_at("aside", cells), at_most(1e-6), straight));
  }
  all.push_back(
      judged("york1997", "moved", 0.5 * hardly, "nodes of equal mass get one velocity, along the whole face"));
  for (const std::string study : {"parting", "york-parting", "york-9.9-parting"}) {
    all.push_back(gate(study + "/taken", value_at("taken", cells), exactly(0), none));
    all.push_back(gate(study + "/aside", value_at("aside", cells), exactly(0), none));
    all.push_back(gate(study + "/moved", value_at("moved", cells), between(-1e-5, 1e-5), none_but_places));
  }
  return all;
}

Case contact_wall() {
  return {.name = "contact-wall",
          .kind = Kind::solid,
          .keys = Blocks().keys(),
          .sets = {{"cells", cells}},
          .york_step = courant_number(0.5),
          .problem = run_of<ContactWall>,
          .studies = studies(),
          .gates = gates(),
          .levels = {cells}};
}
PLUMBLINE_CASE(contact_wall);

}  // namespace
}  // namespace plumbline::contact_wall
