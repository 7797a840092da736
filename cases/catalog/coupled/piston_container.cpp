// A piston between a spring of membrane points and a closed column of gas. [York section 6.1] Long for three bodies in one
// scene and a history of each.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/coupled/crossings.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "reference/piston_container.hpp"

namespace plumbline::piston_container {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double york_density = 1e-3;  // of the spring in his input, kg/m^3

// One struct for points and reference.
struct Container : Parameters {
  reference::PistonContainerProblem problem;
  bool piston_alone = false, york_points = false;
  int mode = 1;
  double end_time = 0;

  explicit Container(Parameters given = {}) : Parameters(std::move(given)) {
    problem.mass = positive("mass", problem.mass, "kg", "of the piston");
    problem.spring_density = positive("spring_density", 1e-5, "kg/m^3", "density of the spring; York's input 1e-3");
    problem.spring_modulus = positive("spring_modulus", problem.spring_modulus, "Pa", "E of the spring: K = E/20");
    problem.bulk_modulus = positive("bulk_modulus", problem.bulk_modulus, "Pa", "beta of the gas");
    problem.gas_density = positive("gas_density", problem.gas_density, "kg/m^3", "density of the gas");
    problem.velocity = any_number("velocity", problem.velocity, "m/s", "of the piston at the start");
    piston_alone = one_of("start", "mode", {"mode", "piston"},
                          "everything starts in one mode, or the piston alone moves, as York's") == "piston";
    mode = integer({.name = "mode",
                    .value = 1.0,
                    .low = 1,
                    .high = 20,
                    .description = "number of the mode that everything starts in"});
    york_points = one_of("layout", "ends", {"ends", "york"},
                         "spring points at both ends, or half a spacing from them, as York's") == "york";
    end_time = positive("t_end", 0.015, "s", "end time");
  }

  double length() const { return problem.gas_length + problem.spring_length; }
};

// Without memory of a reference state a fluid cannot have p = -beta div U: its points carry their strain. [York 6.1]
Body gas_body(const reference::PistonContainerProblem& p, int points) {
  auto gas = std::make_shared<LinearElastic>();
  gas->youngs_modulus = p.bulk_modulus;
  gas->poissons_ratio = 0;
  gas->density = p.gas_density;
  Body body = make_body("gas", gas, points, 1);
  body.spacing = p.gas_length / points;
  for (int k = 0; k < points; ++k) {
    body.points(column::position)[k] = (k + 0.5) * body.spacing;
    body.points(column::volume)[k] = p.area * body.spacing;
    body.points(column::mass)[k] = p.gas_density * p.area * body.spacing;
  }
  return body;
}

// The first point is the piston. York's points stand half a spacing from either end, all of them. [York A.4.10]
Body spring_body(const Container& at, int segments, const std::string& strain) {
  const reference::PistonContainerProblem& p = at.problem;
  const double shift = at.york_points ? 0.5 * p.spring_length / segments : 0.0;
  const int points = at.york_points ? segments : segments + 1;
  const StringState state = straight_string({p.gas_length + shift, 0.0}, {at.length() - shift, 0.0}, points);
  Body body = string_body("spring", strain, {p.spring_modulus, p.area, p.spring_density, false}, state, 1,
                          at.york_points ? StringEnds::whole : StringEnds::half);
  double& piston = body.points(column::mass)[0];
  piston = at.york_points ? p.mass : piston + p.mass;
  return body;
}

// Everything starts with the mode's velocity, each point with its slope as far as the transfer carries it.
void start_mode(Body& body, const Container& at, const reference::PistonContainer& exact, bool affine) {
  const double far = at.length(), v = at.problem.velocity;
  if (affine) body.points.add(column::affine, 1);
  for (int k = 0; k < body.points.points(); ++k) {
    const double y = std::min(far, body.points(column::position)[k]);
    body.points(column::velocity)[k] = v * exact.shape(y, at.mode).value;
    if (affine) body.points(column::affine)[k] = v * exact.slope(y, at.mode).value;
  }
}

class PistonContainerRun final : public Problem {
 public:
  explicit PistonContainerRun(const Settings& settings) : settings_(settings), at_(settings), exact_(at_.problem) {}

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 1;
    scene.grid.h = h();
    scene.grid.cells[0] = settings_.integer("cells");
    scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
    scene.bodies.push_back(gas_body(at_.problem, points_along(at_.problem.gas_length, "ppc")));
    scene.bodies.push_back(spring());
    if (at_.piston_alone) {
      scene.bodies[1].points(column::velocity)[0] = at_.problem.velocity;
    } else {
      const bool affine = settings_.text("transfer") == "apic";
      for (Body& body : scene.bodies) start_mode(body, at_, exact_, affine);
    }
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies[1].points;
    if (times_.empty()) {
      times_.push_back(0);
      displacement_.push_back(0);
      start_ = spring().points(column::position)[0];
    }
    times_.push_back(simulation.time());
    displacement_.push_back(points(column::position)[0] - start_);
  }
  void history(Archive& archive) override {
    archive("start", start_);
    archive("times", times_);
    archive("displacement", displacement_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const reference::Bounded right = at_.piston_alone ? omega_read() : exact_.omega(at_.mode);
    reference::PistonContainerProblem light = at_.problem;
    light.spring_density = 0;
    const reference::Bounded massless = reference::PistonContainer(light).omega();
    const double omega = at_.piston_alone ? read(displacement_) : fitted();
    const Account& energy = simulation.ledger().energy;
    double lost = 0;
    for (const Flow flow : {Flow::integration, Flow::transfer, Flow::constitutive}) lost += energy.flow(flow);
    return {scalar_measure("omega", omega, right.value, right.bound, "1/s"),
            scalar_measure("omega_massless", omega, massless.value, massless.bound, "1/s"), displacement_measure(),
            share_measure("energy_drift", lost / energy.scale())};
  }

  Profile profile(const Simulation&) const override {
    std::vector<std::array<double, 3>> rows;
    const std::size_t every = times_.size() / 1500 + 1;
    for (std::size_t k = 0; k < times_.size(); k += every) {
      rows.push_back({times_[k], displacement_[k], exact_at(times_[k]).value});
    }
    return history_profile({{"time", "s", "time", {}},
                            {"displacement", "m", "displacement of the piston", {}},
                            {"displacement_reference", "m", "exact displacement", {}}},
                           rows);
  }

 private:
  double h() const { return at_.length() / settings_.integer("cells"); }
  int points_along(double length, const char* per_cell) const {
    return std::max(2, whole(std::round(length / h() * settings_.number(per_cell))));
  }
  Body spring() const {
    return spring_body(at_, points_along(at_.problem.spring_length, "membrane.ppc"), settings_.text("membrane.strain"));
  }

  reference::Bounded exact_at(double time) const {
    return at_.piston_alone ? exact_.displacement(time) : exact_.mode_displacement(time, at_.mode);
  }

  double fitted() const { return 2 * pi / crossing_period(times_, displacement_).value_or(std::nan("")); }

  // What York reads off his figure: the time between extremes of the same kind.
  double read(const std::vector<double>& displacement) const {
    return 2 * pi / mean_period(find_extremes(times_, displacement)).value_or(std::nan(""));
  }

  // The same off the exact motion, sampled at the same times.
  reference::Bounded omega_read() const {
    std::vector<double> exact;
    double bound = 0;
    for (const double t : times_) {
      const reference::Bounded u = exact_at(t);
      exact.push_back(u.value);
      bound = std::max(bound, u.bound);
    }
    return {read(exact), bound};
  }

  // Largest error over time, as a share of v/omega.
  Measure displacement_measure() const {
    const double amplitude = std::abs(at_.problem.velocity) / exact_.omega(at_.mode).value;
    Measure m;
    m.name = "displacement.worst";
    m.unit = "m";
    m.scale = amplitude;
    const std::size_t every = times_.size() / 2000 + 1;
    for (std::size_t k = 0; k < times_.size(); k += every) {
      const reference::Bounded u = exact_at(times_[k]);
      m.error = larger(m.error, std::abs(displacement_[k] - u.value));
      m.reference_bound = std::max(m.reference_bound, u.bound);
    }
    return m;
  }

  Settings settings_;
  Container at_;
  reference::PistonContainer exact_;
  double start_ = 0;
  std::vector<double> times_, displacement_;
};

// The heavy point's kernel moves with the gas beside it, v (1 + s x), s the gas's slope at the piston, and has the
// inertia m D s^2 beside its mass: D = h^2/3 of the cubic shapes. Sharpening makes the strain rates of its three nodes,
// m/6, 2m/3, m/6, larger than their slope by 1 + theta K/M = 1 + 1.6/6 = 19/15: the gas's slope is reached by one
// smaller by that. A leapfrog's frequency is too high by (omega tau)^2/24.
Measured omega_error_over_theory(const RunResult& run, const Measure& omega) {
  const reference::PistonContainerProblem problem = Container(run.settings).problem;
  const reference::PistonContainer exact(problem);
  const double s = exact.slope(problem.gas_length).value * 15.0 / 19;
  const double inertia = problem.mass * run.h * run.h / 3 * s * s / exact.modal_mass().value;
  const double turn = exact.omega().value * run.dt;
  const double theory = exact.omega().value * (turn * turn / 24 - inertia / 2);
  Measured measured = Measured::of((*omega.value - *omega.reference) / theory);
  measured.reference_bound = omega.reference_bound / std::abs(theory);
  measured.scale = 1;
  return measured;
}

std::vector<StudyPlan> studies() {
  const std::string order = "Order 2: the inertia that the piston's kernel adds.";
  const std::vector<double> levels{20, 28, 40, 56, 80}, finer{20, 28, 40, 56, 80, 160};
  const std::vector<Override> heavy_piston{{"mass", 1.0}, {"t_end", 0.035}};
  const auto mode = [](const std::string& id, const char* title, double number) {
    return study(id, title, "The coupled roots one by one: the step is the gas's, and the spring's waves are damped.",
                 {40, 80, 160})
        .with({{"spring_density", york_density}, {"mode", number}})
        .in(Tier::full);
  };
  return {study("default", "default, m = 0.1", order, finer).in_full({20, 28, 40, 56, 80, 160, 320}),
          study("heavy-piston", "default, m = 1", order, levels).with(heavy_piston).in_full(finer),
          study("york1997", "York's input, m = 0.1", "One mesh.", {40}).of_york(),
          study("york-heavy-piston", "York's input, m = 1", "One mesh.", {40}).of_york().with(heavy_piston),
          study("york-step", "York's input, his printed step", "3.1 times the limit of stability.", {40})
              .of_york()
              .with({{"dt", 5e-5}}),
          study("heavy-spring", "default, York's heavy spring, the piston starts alone", "Two modes at once.", {40, 80})
              .with({{"spring_density", york_density}, {"start", "piston"}})
              .in_full({40, 80, 160}),
          mode("heavy-spring-4", "default, York's heavy spring in its fourth mode", 4),
          mode("heavy-spring-5", "default, York's heavy spring in its fifth mode", 5)};
}

const Number omega_constant = number_at("error of omega over that of theory at 80 cells", "omega", 80,
                                        omega_error_over_theory);

std::vector<CaseGate> gates() {
  const Because massless = requirement(
      "within 0.1 % of (6.2), a spring without mass; this one has at most 0.2 % of the piston's");
  const Because order = theory("order 2; 0.2 for the coarse meshes and the interval");
  const Because constant = theory(
      "inertia of the piston's kernel (15/19)^2 m s^2 h^2/3 and the step's (omega tau)^2/24; 3 % for the next order, "
      "h/L = 1/40");
  const Because reading = requirement(
      "within 1 % of what the exact motion of piston, gas and heavy spring reads between its extremes: about what the "
      "two digits that he prints can tell");
  const Because apart = requirement(
      "York's input within 1 % of the exact frequency; its two modes of the piston are 5 % apart");
  const auto of_periods = [](double shortest, double longest) { return between(2 * pi / longest, 2 * pi / shortest); };
  return {
      gate("default/omega-160", error_at("omega_massless", 160), at_most(1e-3 * 886.43), massless),
      gate("heavy-piston/omega-160", error_at("omega_massless", 160), at_most(1e-3 * 281.15), massless).in(Tier::full),
      gate("default/omega-order", order_of("omega"), at_least(1.8), order),
      gate("default/omega-constant", omega_constant, between(0.97, 1.03), constant),
      gate("heavy-piston/omega-order", order_of("omega"), at_least(1.8), order),
      gate("heavy-piston/omega-constant", omega_constant, between(0.97, 1.03), constant),

      gate("york1997/omega", error_at("omega", 40), at_most(8.859), reading),
      gate("york1997/printed", value_at("omega", 40), of_periods(0.00705, 0.00715),
           literature("his Table 3: 0.0071 s, half of the last digit")),
      gate("york-heavy-piston/omega", error_at("omega", 40), at_most(2.8096), reading),
      gate("york-heavy-piston/printed", value_at("omega", 40), of_periods(0.0215, 0.0225),
           literature("his Table 3: 0.022 s, half of the last digit")),
      gate("york-step/finite", stopped_run(), exactly(0),
           identity("every run arrives at its end with admissible values"))
          .fails("his printed step, 5e-5 s, is 3.1 times the limit 2 h/c: the shortest wave grows by more than 30 a "
                 "step, from 1 m/s to a cell a step within a few",
                 {})
          .or_stops({3, 12, "velocity"}),

      gate("heavy-spring/omega-80", error_at("omega", 80), at_most(0.01 * 885.9), apart),
      gate("heavy-spring-4/omega-160", error_at("omega", 160), at_most(0.01 * 865.43), apart).in(Tier::full),
      gate("heavy-spring-5/omega-160", error_at("omega", 160), at_most(0.01 * 909.37), apart).in(Tier::full)};
}

// Half the limit of one point a cell, C = 2; York's printed 5e-5 s is C = 6.3 at h = 1.
Override half_the_limit(const Settings& settings) {
  const reference::PistonContainerProblem gas = Container(settings).problem;
  return {"dt", 40 / settings.number("cells") / std::sqrt(gas.bulk_modulus / gas.gas_density)};
}

Case piston_container() {
  return {.name = "piston-container",
          .kind = Kind::coupled,
          .keys = Container().keys(),
          .sets = {{"cells", 40.0}},
          .york1997 = {{"ppc", 1.0},
                       {"membrane.ppc", 1.0},
                       {"layout", "york"},
                       {"start", "piston"},
                       {"spring_density", york_density}},
          .york_step = half_the_limit,
          .problem = run_of<PistonContainerRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {20, 40, 80, 160}};
}
PLUMBLINE_CASE(piston_container);

}  // namespace
}  // namespace plumbline::piston_container
