// What gates of integrators measure of integrators whose steps are known in closed form: Runge-Kutta's on linear springs, where a
// step multiplies each eigenvector by a polynomial of its eigenvalue, and points that fall, which any of order two carries exactly.
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/oscillators.hpp"
#include "cases/harness/integrators/pairs.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {
namespace {

using Complex = std::complex<double>;

// exp(z) to the power of z that is the order of a Runge-Kutta step with as many stages.
Complex runge_kutta(Complex z, int order) {
  Complex sum = 1, power = 1;
  for (int k = 1; k <= order; ++k) sum += power *= z / static_cast<double>(k);
  return sum;
}

// u = g + Re(c exp(lambda t)), v = Re(c lambda exp(lambda t)), of a spring with a damper; `factor` stands for exp(lambda t).
struct LinearMotion {
  Complex c, lambda;
  double g;

  explicit LinearMotion(const reference::SpringOscillatorProblem& problem)
      : lambda(-problem.damping, std::sqrt(1 - problem.damping * problem.damping)),
        g(problem.gravity) {
    const double u = problem.displacement - g;
    c = {u, -(problem.velocity + problem.damping * u) / lambda.imag()};
  }
  double displacement(Complex factor) const { return g + (c * factor).real(); }
  double velocity(Complex factor) const { return (c * lambda * factor).real(); }
};

void add_errors(KnownAnswers& all) {
  constexpr int steps = 7;
  for (const OscillatorScene& scene : oscillator_scenes()) {
    if (scene.problem.law != reference::SpringLaw::linear) continue;
    const LinearMotion motion(scene.problem);
    const double dt = scene.end / steps;
    for (const auto& [name, order] : {std::pair{"rk4", 4}, std::pair{"ssp-rk3", 3}}) {
      Complex factor = 1;
      for (int k = 0; k < steps; ++k) {
        const double first = scene.variable_steps ? dt / 1.7 : dt;
        factor *= runge_kutta(first * motion.lambda, order);
        if (scene.variable_steps) factor *= runge_kutta((dt - first) * motion.lambda, order);
      }
      const Complex exact = std::exp(scene.end * motion.lambda);
      const double scale = std::hypot(scene.problem.displacement, scene.problem.velocity) +
                           std::abs(scene.problem.gravity);
      const double place = (motion.displacement(factor) - motion.displacement(exact)) / scale,
                   speed = (motion.velocity(factor) - motion.velocity(exact)) / scale;
      const std::vector<double> found = oscillator_errors(Subject({name, {}}), scene, steps);
      const double wanted[] = {place, speed, place};
      for (std::size_t k = 0; k < 3; ++k) all.push_back({scene.name + "." + name, found.at(k), wanted[k]});
    }
  }
  // Without steps and with them, as matrices of the laboratory have it.
  for (const double damping : {0.0, 0.1}) {
    reference::SpringOscillatorProblem problem{.damping = damping, .displacement = 0.4, .velocity = -0.7};
    const LinearMotion motion(problem);
    const Eigen::Vector2d start(0.4, -0.7), exact = exact_oscillation(damping, start, 2.5),
                                            stepped = oscillation({"rk4", {}}, damping, start, 2.5, 5);
    const Complex factor = std::exp(2.5 * motion.lambda), of_steps = std::pow(runge_kutta(0.5 * motion.lambda, 4), 5);
    all.push_back({"exact.displacement", exact[0], motion.displacement(factor)});
    all.push_back({"exact.velocity", exact[1], motion.velocity(factor)});
    all.push_back({"stepped.displacement", stepped[0], motion.displacement(of_steps)});
    all.push_back({"stepped.velocity", stepped[1], motion.velocity(of_steps)});
  }
}

// Of order three a step multiplies the size by |R|, |R|^2 = 1 - x^4/12 + x^6/36 with x = omega dt, of order four by
// |R|^2 = 1 - x^6/72 + x^8/576.
double square_of_step(int order, double x) {
  return order == 3 ? 1 - std::pow(x, 4) / 12 + std::pow(x, 6) / 36 : 1 - std::pow(x, 6) / 72 + std::pow(x, 8) / 576;
}

// Stable up to 1/omega times sqrt(3) and 2 sqrt(2). Energies fall by the square a step, the same in each period: the slope of their
// logarithms has no scatter, and 1e-10 stands in its place.
void add_growth(KnownAnswers& all) {
  for (const auto& [name, order] : {std::pair{"rk4", 4}, std::pair{"ssp-rk3", 3}}) {
    const std::string in = std::string(name) + ".";
    const Subject subject({name, {}});
    const double limit = order == 3 ? std::numbers::sqrt3 : 2 * std::numbers::sqrt2;
    all.push_back({in + "limit", limit_on_oscillator(subject), limit, limit});
    const double x = limit_of_york / 32;
    const SmallSteps small = small_steps_on_oscillator(subject);
    all.push_back({in + "smallest", small.dt.back(), x});
    all.push_back({in + "growth", small.growth.back(), 0.5 * std::log(square_of_step(order, x))});
    const double half = 0.5 * std::min(limit, limit_of_york), steps = std::ceil(2 * std::numbers::pi / half);
    const double slope = steps * std::log(square_of_step(order, 2 * std::numbers::pi / steps));
    for (const IntegratorGate& row : energy_gates(subject)) {
      if (row.gate.id != "energy/oscillator/growth") continue;
      all.push_back({in + "energy", row.measure(subject).value.value_or(NAN), slope / 1e-10, std::abs(slope) / 1e-10});
    }
  }
  for (const char* name : {"usf", "usl", "musl", "leapfrog"}) {
    all.push_back({std::string(name) + ".limit", limit_on_oscillator(Subject({name, {}})), 2, 2});
  }
  const double none = limit_on_oscillator(Subject({"implicit-midpoint", {}}));
  all.push_back(yes("implicit-midpoint.limit", std::isinf(none)));
}

// Two clouds of gas without pressure, far from each other.
constexpr int falling_points = 4;
constexpr std::array<std::array<double, 2>, 2> thrown{{{0.3, -0.1}, {-0.2, 0.25}}};  // m/s
constexpr std::array<double, 3> fall{0.05, -0.15, 0};                                // m/s^2

Scene falling_clouds() {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {24, 12, 1};
  scene.gravity = fall;
  for (std::size_t b = 0; b < thrown.size(); ++b) {
    Body cloud = make_body("cloud" + std::to_string(b), std::make_shared<IdealGas>(), falling_points, 2);
    for (int p = 0; p < falling_points; ++p) {
      cloud.points(column::position, 0)[p] = 6.25 + 12 * static_cast<double>(b) - 0.5 * (p % 2);
      cloud.points(column::position, 1)[p] = 6.25 - 0.5 * std::floor(p / 2);
      for (int d = 0; d < 2; ++d) cloud.points(column::velocity, d)[p] = thrown[b][static_cast<std::size_t>(d)];
      for (const ColumnId* id : {&column::mass, &column::volume, &column::density}) cloud.points(*id)[p] = 0.25;
    }
    scene.bodies.push_back(std::move(cloud));
  }
  return scene;
}

void add_falling(KnownAnswers& all) {
  for (const bool variable : {false, true}) {
    SmallScene small{"clouds", "", 2, falling_clouds, {"quadratic", "flip"}};
    small.variable_steps = variable;
    const std::vector<double> found = state_at_end(small, workable(small, "rk4"), {"rk4", {}}, 4);
    std::size_t k = 0;
    for (const bool velocities : {false, true}) {
      for (const auto& start : thrown) {
        for (std::size_t d = 0; d < 2; ++d) {
          const double end = velocities ? start[d] + 2 * fall[d] : 2 * start[d] + 2 * fall[d];
          for (int p = 0; p < falling_points; ++p) all.push_back({"clouds.state", found.at(k++), end});
        }
      }
    }
    all.push_back({"clouds.numbers", static_cast<double>(found.size()), static_cast<double>(k)});
  }
  // Points stand as their numbers say.
  Scene scene = falling_clouds();
  scene.bodies[0].id = {2, 0, 3, 1};
  const std::vector<double> sorted = column_by_number(scene, column::position);
  const double exact[] = {5.75, 5.75, 6.25, 6.25, 6.25, 5.75, 6.25, 5.75};
  for (std::size_t k = 0; k < std::size(exact); ++k) all.push_back({"numbered.place", sorted.at(k), exact[k]});

  const Scene image = mirrored(falling_clouds()), turned = with_axes_exchanged(falling_clouds());
  const Columns &there = image.bodies[1].points, &across = turned.bodies[1].points;
  const auto row = [&](const char* name, double value, double answer) { all.push_back({name, value, answer}); };
  row("mirror.place", there(column::position, 0)[1], 24 - 17.75);
  row("mirror.height", there(column::position, 1)[3], 5.75);
  row("mirror.speed", there(column::velocity, 0)[1], 0.2);
  row("mirror.rise", there(column::velocity, 1)[1], 0.25);
  row("mirror.gravity", image.gravity[0], -fall[0]);
  row("mirror.fall", image.gravity[1], fall[1]);
  row("exchanged.place", across(column::position, 0)[3], 5.75);
  row("exchanged.height", across(column::position, 1)[1], 17.75);
  row("exchanged.speed", across(column::velocity, 0)[0], 0.25);
  row("exchanged.cells", turned.grid.cells[0], 12);
  row("exchanged.gravity", turned.gravity[0], fall[1]);
}

// With which integrator another is compared: never with itself, and with one that returns losses as it does.
void add_yardsticks(KnownAnswers& all) {
  const auto row = [&](const char* subject, const char* transfer, bool gas, const char* exact) {
    Scene scene = falling_clouds();
    scene.transfer = transfer;
    auto solid = std::make_shared<NeoHookean>();
    solid->density = solid->youngs_modulus = 1;
    if (!gas) scene.bodies = {make_body("solid", solid, 1, 2)};
    const std::string found = yardstick(Subject({subject, {}}), scene).name;
    all.push_back(yes(std::string("yardstick.") + subject, found == exact));
  };
  row("musl", "flip", true, "rk4");
  row("rk4", "flip", true, "ssp-rk3");
  row("leapfrog", "apic", true, "energy");
  row("energy", "apic", true, "leapfrog");
  row("leapfrog", "apic", false, "midpoint");
  row("musl", "apic", true, "midpoint");
  row("midpoint", "apic", false, "musl");
}

}  // namespace

KnownAnswers oscillation_answers() {
  KnownAnswers all;
  add_errors(all);
  add_growth(all);
  add_falling(all);
  add_yardsticks(all);
  return all;
}

}  // namespace plumbline
