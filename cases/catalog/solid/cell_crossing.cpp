// What a point does to the forces when it crosses a cell side. [York section A.2] Long for its three scenes: his snapshot of
// forces, the spring that it stands in, and points that drift.
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline::cell_crossing {
namespace {

struct Choices : Parameters {
  std::string problem = one_of("problem", "drift", {"forces", "spring", "drift"},
                               "York's forces, his spring, or a stressed body that drifts");
  double stretch = number(
      {.name = "stretch", .value = 1.1, .low = 0.7, .high = 1.4, .description = "of the body that drifts"});
  double periods = positive("periods", 50, "1", "of the spring");

  explicit Choices(Parameters given = {}) : Parameters(std::move(given)) {}
};

// --- York's ten points --------------------------------------------------------------------------------------------------

// Layout and modulus of his section 5.5 with which the printed stresses put point 6 at the side; the section follows from
// the printed forces. What he does not print is the load: here the spring starts with a velocity.
constexpr int ten = 10;
constexpr double modulus = 1e6, section = 0.05, light = 0.1, top = 2.0, spring_h = 0.1;
constexpr double first = 0.01, apart = 0.1 / 3;  // of point 1 from the top, between points, unstretched
constexpr double point_volume = section * apart;

// Stresses before point 6 crosses and after: those of the second and third cell as printed, those of the first and
// fourth from the force on the upper node, and from the force on the lower node before.
struct Snapshot {
  std::array<double, ten> stress, below;  // Pa; distance below the top, m
};
Snapshot snapshot(bool crossed) {
  const double first_cell = crossed ? 125839 : 124352, upper = crossed ? 123274 : 123034;
  const double lower = crossed ? 179802 : 181170, fourth = 87750;
  Snapshot s;
  s.stress = {first_cell, first_cell, first_cell, upper, upper, upper, lower, lower, fourth, fourth};
  for (int k = 0; k < ten; ++k) {
    const double strain = k < 6 ? 0.124 : 0.18, from = first + std::min(k, 5) * apart;
    s.below[static_cast<std::size_t>(k)] = from * 1.124 + (k > 5 ? (k - 5) * apart * (1 + strain) : 0);
  }
  s.below[5] = crossed ? 2 * spring_h + 1e-4 : 2 * spring_h - 1e-4;
  return s;
}

std::shared_ptr<LinearElastic> spring_material() {
  auto material = std::make_shared<LinearElastic>();
  material->youngs_modulus = modulus;
  material->density = light;
  return material;
}

// Of each point the share of a cell's stress, that of the mean of its points on the whole of its cell, that makes the forces
// those of cell-centred stresses. [York section 5.4.3]
void take_cell_stresses(Snapshot& s) {
  std::array<double, 6> sum{}, count{};
  const auto cell = [&s](std::size_t k) { return static_cast<std::size_t>(s.below[k] / spring_h); };
  for (std::size_t k = 0; k < ten; ++k) {
    sum[cell(k)] += s.stress[k];
    ++count[cell(k)];
  }
  for (std::size_t k = 0; k < ten; ++k) {
    const double mean = sum[cell(k)] / count[cell(k)];
    s.stress[k] = mean * section * spring_h / (count[cell(k)] * point_volume);
  }
}

Body spring_body(std::string name) {
  Body body = make_body(std::move(name), spring_material(), ten, 1);
  body.spacing = apart;
  for (int p = 0; p < ten; ++p) {
    body.points(column::volume)[p] = point_volume;
    body.points(column::mass)[p] = light * point_volume * (p == ten - 1 ? 100 : 1);  // [York A.2]: 100 x the others
  }
  return body;
}

// Forces on the nodes one, two and three cells below the top from the accelerations that the step gave the points: those of
// two points in a cell give those of its two nodes, and masses make forces of them. True of linear shapes with FLIP.
std::array<double, 3> nodal_forces(const Body& body, double dt) {
  std::array<double, ten> acceleration{}, cell{};
  std::array<double, 6> mass{};
  for (int p = 0; p < ten; ++p) {
    const auto k = static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
    acceleration[k] = body.points(column::velocity)[p] / dt;
    cell[k] = (top - body.points(column::position)[p]) / spring_h;
    const auto node = static_cast<std::size_t>(cell[k]);
    const double share = cell[k] - std::floor(cell[k]);
    mass[node] += body.points(column::mass)[p] * (1 - share);
    mass[node + 1] += body.points(column::mass)[p] * share;
  }
  // Of the line through the accelerations of points a and b, the value at a node.
  const auto at_node = [&](std::size_t a, std::size_t b, int node) {
    return acceleration[a] + (acceleration[b] - acceleration[a]) * (node - cell[a]) / (cell[b] - cell[a]);
  };
  return {mass[1] * at_node(3, 4, 1), mass[2] * at_node(3, 4, 2), mass[3] * at_node(6, 7, 3)};
}

GridSpec spring_grid(int cells, double h) {
  GridSpec grid;
  grid.h = h;
  grid.cells[0] = cells;
  grid.origin[0] = top - cells * h;
  grid.walls[0] = {Wall::free, Wall::symmetry};
  return grid;
}

class ForcesProblem final : public Problem {
 public:
  explicit ForcesProblem(const Settings& settings) : settings_(settings) {}
  double end_time() const override { return dt; }
  // Both instants in one scene, each with the points' own stresses and with those of cells, ten cells apart: all but the
  // first hang from nothing, which nodes below the first do not see.
  Scene scene() const override {
    Scene scene;
    scene.grid = spring_grid(50, spring_h);
    for (int b = 0; b < 4; ++b) {
      Snapshot s = snapshot(b % 2 == 1);
      if (b > 1) take_cell_stresses(s);
      Body body = spring_body(std::array{"before", "after", "before-cell", "after-cell"}[static_cast<std::size_t>(b)]);
      for (int p = 0; p < ten; ++p) {
        const auto k = static_cast<std::size_t>(p);
        body.points(column::position)[p] = top - s.below[k] - b * shift;
        body.points(column::strain)[p] = s.stress[k] / modulus;
      }
      scene.bodies.push_back(std::move(body));
    }
    apply_choices(settings_, scene);
    return scene;
  }
  std::vector<Measure> measures(const Simulation& simulation) const override {
    const std::array<double, 6> printed{66, 111, 3114, 2183, -3940, 5123};
    std::vector<Measure> all;
    std::array<double, 4> middle{};
    for (std::size_t b = 0; b < 4; ++b) {
      Body body = simulation.scene().bodies[b];
      for (int p = 0; p < ten; ++p) body.points(column::position)[p] += static_cast<double>(b) * shift;
      const std::array<double, 3> forces = nodal_forces(body, dt);
      middle[b] = forces[1];
      if (b > 1) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string name = std::string("force_") + std::array{"upper", "middle", "lower"}[k] +
                                 (b == 0 ? "_before" : "_after");
        all.push_back(scalar_measure(name, forces[k], printed[3 * b + k], 0.5, "N"));
      }
    }
    const double jump = middle[1] - middle[0], of_cells = middle[3] - middle[2];
    all.push_back(scalar_measure("jump_of_cell_stresses", std::abs(of_cells / jump), 0, 0, "1"));
    return all;
  }
  Profile profile(const Simulation&) const override { return {}; }

 private:
  static constexpr double dt = 1e-12, shift = 1.0;
  Settings settings_;
};

// The spring set swinging with the strain that his printed stresses show, and its energy.
class SpringProblem final : public Problem {
 public:
  explicit SpringProblem(const Settings& settings) : settings_(settings), periods_(Choices(settings).periods) {}
  double end_time() const override { return periods_ * period(); }
  Scene scene() const override {
    Scene scene;
    const double h = 1 / settings_.number("cells");
    scene.grid = spring_grid(whole(std::round(1 / h)), h);
    Body body = spring_body("spring");
    for (int p = 0; p < ten; ++p) {
      const double below = first + p * apart;
      body.points(column::position)[p] = top - below;
      body.points(column::velocity)[p] = -largest_strain * omega() * below;
    }
    if (settings_.text("transfer") == "apic") {
      body.points.add(column::affine);
      for (int p = 0; p < ten; ++p) body.points(column::affine)[p] = largest_strain * omega();
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }
  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Body& body = simulation.scene().bodies.front();
    for (int p = 0; p < ten; ++p) {
      if (body.id[static_cast<std::size_t>(p)] != 5) continue;
      const double cell = (top - body.points(column::position)[p]) * settings_.number("cells");
      if (cell_ >= 0 && std::floor(cell) != cell_) ++crossings_;
      cell_ = std::floor(cell);
    }
    rows_.push_back({simulation.time(), simulation.ledger().stores.total()});
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("cell", cell_);
    archive("crossings", crossings_);
    archive("rows", rows_);
  }
  std::vector<Measure> measures(const Simulation& simulation) const override {
    const double start = simulation.ledger().initial_stores.total();
    double highest = rows_.front()[1];
    for (const auto& row : rows_) highest = larger(highest, row[1]);
    return {scalar_measure("energy_gain", highest / start - 1, 0, 0, "1"),
            scalar_measure("energy_end", rows_.back()[1] / start - 1, 0, 0, "1"),
            scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"),
            scalar_measure("crossings", static_cast<double>(crossings_), 0, 0, "1")};
  }
  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}}, {"energy", "J", "energy of all points", {}}}, rows_);
  }

 private:
  static constexpr double largest_strain = 0.14;
  // The heavy point and a third of the others on the spring's stiffness.
  static double omega() {
    const double length = first + (ten - 1) * apart, mass = light * point_volume * (100 + 3);
    return std::sqrt(modulus * section / length / mass);
  }
  static double period() { return 2 * std::acos(-1.0) / omega(); }

  Settings settings_;
  double periods_;
  EnergyWatch energy_;
  double cell_ = -1;
  long crossings_ = 0;
  std::vector<std::array<double, 2>> rows_;  // time, energy
};

// --- a stressed body that drifts ----------------------------------------------------------------------------------------

// A long bar, stretched evenly, moves over `drift` cells at the speed of sound. Nothing holds its ends, so waves run in from
// them, in the body no faster than sound: what lies further from both ends than they can run, and `guard` cells, does not
// know of them and must drift on unaccelerated.
class DriftProblem final : public Problem {
 public:
  explicit DriftProblem(const Settings& settings)
      : settings_(settings),
        h_(1 / settings.number("cells")),
        stretch_(Choices(settings).stretch) {
    material_ = std::make_shared<NeoHookean>();
    material_->youngs_modulus = modulus;
    material_->density = light;
  }
  double end_time() const override { return drift * h_ / speed(); }
  Scene scene() const override {
    Scene scene;
    const double apart_now = h_ / settings_.number("ppc") * stretch_;
    const int points = whole(std::round(length() / apart_now));
    scene.grid.h = h_;
    scene.grid.cells[0] = whole(std::ceil((length() + drift * h_) / h_)) + 40;
    scene.grid.origin[0] = -20 * h_;
    Body body = make_body("bar", material_, points, 1);
    body.spacing = apart_now / stretch_;
    for (int p = 0; p < points; ++p) {
      body.points(column::position)[p] = (p + 0.5) * apart_now;
      body.points(column::velocity)[p] = speed();
      body.points(column::deformation)[p] = stretch_;
      body.points(column::mass)[p] = light * apart_now / stretch_;
      body.points(column::volume)[p] = apart_now;
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }
  void observe(const Simulation& simulation) override {
    const Body& body = simulation.scene().bodies.front();
    const auto count = static_cast<std::size_t>(body.points.points());
    if (before_.empty()) before_.assign(count, speed());
    const double middle = 0.5 * length() + speed() * simulation.time();
    for (std::size_t p = 0; p < count; ++p) {
      const auto k = static_cast<std::size_t>(body.id[p]);
      const double v = body.points(column::velocity)[p];
      if (std::abs(body.points(column::position)[p] - middle) < judged / 2 * h_) {
        const double a = (v - before_[k]) / simulation.last_dt();
        square_ += a * a;
        peak_ = larger(peak_, std::abs(a));
        ++samples_;
      }
      before_[k] = v;
    }
  }
  void history(Archive& archive) override {
    archive("before", before_);
    archive("square", square_);
    archive("peak", peak_);
    archive("samples", samples_);
  }
  std::vector<Measure> measures(const Simulation&) const override {
    const double scale = stress() / (light * h_);
    return {scalar_measure("noise_rms", std::sqrt(square_ / static_cast<double>(samples_)) / scale, 0, 0, "1"),
            scalar_measure("noise_peak", peak_ / scale, 0, 0, "1")};
  }
  Profile profile(const Simulation& simulation) const override {
    Profile profile;
    profile.columns = {{"x", "m", "x", {}}, {"velocity", "m/s", "velocity less that of the drift", {}}};
    const Body& body = simulation.scene().bodies.front();
    for (int p = 0; p < body.points.points(); ++p) {
      profile.columns[0].values.push_back(body.points(column::position)[p]);
      profile.columns[1].values.push_back(body.points(column::velocity)[p] - speed());
    }
    return profile;
  }

 private:
  static constexpr double drift = 100, judged = 20, guard = 30;  // cells
  static double speed() { return std::sqrt(modulus / light); }
  // Waves in the stretched body run no faster than `fastest` of the speed of sound at rest.
  double length() const {
    const double fastest = std::sqrt((stretch_ * stretch_ + 1) / 2) + 0.1;
    return (2 * drift * fastest + judged + 2 * guard) * h_;
  }
  double stress() const {
    const LameConstants c = material_->constants();
    return std::abs(c.mu * (stretch_ - 1 / stretch_) + c.lambda * std::log(stretch_) / stretch_);
  }

  Settings settings_;
  double h_, stretch_;
  std::shared_ptr<NeoHookean> material_;
  std::vector<double> before_;
  double square_ = 0, peak_ = 0;
  long samples_ = 0;
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const std::string problem = Choices(settings).problem;
  if (problem == "forces") return std::make_unique<ForcesProblem>(settings);
  if (problem == "spring") return std::make_unique<SpringProblem>(settings);
  return std::make_unique<DriftProblem>(settings);
}

std::vector<StudyPlan> studies() {
  const std::string one = "One mesh.", noise = "One mesh: the noise does not depend on h.";
  const Override spring{"problem", "spring"};
  std::vector<StudyPlan> all{
      study("york1997", "York's forces", "One instant.", {10}).of_york().with({{"problem", "forces"}}),
      study("spring-york1997", "York's spring, york1997", one, {10}).of_york().with({spring}),
      study("spring", "York's spring, default", one, {10}).with({spring}),
      study("spring-quadratic", "York's spring, quadratic B-splines", one, {10}).with({spring, {"shape", "quadratic"}}),
      study("default", "drift, contiguous-gimp", noise, {10})};
  all.push_back(study("points", "drift, york1997, more points a cell",
                      "Not an order: a point's share of a force falls.", {2, 4, 8})
                    .of_york()
                    .over(Vary::ppc));
  for (const std::string shape : {"gimp", "linear", "quadratic", "cubic"}) {
    all.push_back(study(shape, "drift, " + shape, noise, {10}).with({{"shape", shape}}));
  }
  return all;
}

// Of all points and steps.
double noise_of(const StudyResult& study) {
  const Measure* noise = study.levels.front().run.find("noise_rms");
  if (!noise) throw std::runtime_error("the run has no noise_rms");
  return *noise->value;
}
const Number noise_over_linear = number_of(
    "rms of accelerations over that of linear shapes",
    [](const StudyResult& s) { return Measured::of(noise_of(s) / noise_of(*s.sibling("linear"))); }, {10});

CaseGate as_printed(const std::string& force, double printed) {
  return gate("york1997/" + force, value_at(force, 10), between(printed - 3, printed + 3),
              literature("as printed; 3 N for the weight of the points, about 1 N, and stresses printed to a unit, six "
                         "of which count a sixtieth each"));
}

CaseGate fewer_noise_gate(double points, double than) {
  return gate(
      "points/noise-" + to_text(points), ratio_of("noise_rms", points, than), at_most(std::sqrt(0.5)),
      theory("York, section 5.4.3: more points a cell overwhelm the noise of the one that crosses. Twice as many "
             "with half the force each, that cross independently, make the root of a half of it; evenly spaced "
             "ones, as these at the start, less"));
}

// How much the force on the middle node jumps with cell-centred stresses, N: by hand from the printed stresses, a cell of
// stress s pulling with s times the section. The point that has crossed has the stress of the upper cell's others.
constexpr double cell_jump = section * (((123274 + 2 * 179802) / 3.0 - 123274) - (181170 - 123034)),
                 printed_jump = -3940 - 111;

std::vector<CaseGate> gates() {
  return {
      as_printed("force_middle_before", 111),
      as_printed("force_middle_after", -3940),
      as_printed("force_lower_after", 5123),
      gate("york1997/cell-stress", value_at("jump_of_cell_stresses", 10),
           between(cell_jump / printed_jump - 0.003, cell_jump / printed_jump + 0.003),
           theory("York, section 5.4.3: cell-centred stresses were somewhat successful against the noise: the force on "
                  "the middle node jumps by a quarter of what it does, by hand from the printed stresses; 0.003 for "
                  "3 N in each force, of 4051")),
      fewer_noise_gate(4, 2),
      fewer_noise_gate(8, 4),
      gate("default/noise-ratio", noise_over_linear, at_most(0.01),
           requirement("at least 100 times below that of linear shapes: boxes are used to be rid of that noise"))
          .beside({"linear"}),
      gate("default/rounding", value_at("noise_peak", 10), at_most(1e-10),
           identity("boxes that tile a uniformly stressed body: inner nodes get the same stress times N(+) - N(-), "
                    "which is zero but for rounding")),
      energy_monotone_gate("spring-quadratic"),
      gate("spring/energy-monotone", value_at("energy_rise", 10), at_most(1e-13),
           theory("of linear elasticity the midpoint step raises the energy in no step where the inertia of "
                  "kernels is constant"))
          .fails("the affine inertia of boxes depends on where in the cell they stand: a point that moves carries "
                 "its affine velocity to another inertia",
                 {1.0e-3, 1.22e-3}, "2026-11-23 5825b24"),
      recorded("spring-york1997/energy-gain", value_at("energy_gain", 10), 0.0091914, 0.1, "2026-11-21 a96ec71",
               "how high the energy of York's spring stands above its start, the history of his claim; chaotic in "
               "its details, hence 10 %")};
}

Case cell_crossing() {
  return {.name = "cell-crossing",
          .kind = Kind::solid,
          .keys = Choices().keys(),
          .sets = {{"cells", 10.0}},
          .york_step = courant_number(0.057),  // of York's spring, section 5.5: 1.8e-6 s at h = 0.1 with c = 3162
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = {10}};
}
PLUMBLINE_CASE(cell_crossing);

}  // namespace
}  // namespace plumbline::cell_crossing
