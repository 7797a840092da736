// The flows on which steps are timed, whose sums over a lattice are known in closed form, the bytes that a step moves, and what is
// made of measured speeds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/bench/bench_targets.hpp"
#include "cases/harness/bench/bench_work.hpp"

namespace plumbline {
namespace {

// Of n points at odd multiples of 1/(2 n).
double mean_of_half_wave(int n) { return 1 / (n * std::sin(std::numbers::pi / (2 * n))); }  // sin(pi x)
double left_of_wave(int n) { return 1 / (n * std::sin(std::numbers::pi / n)); }  // sin(2 pi x) at x < 1/2, over all
double arm_of_wave(int n) { return -left_of_wave(n) / 2; }                       // x sin(2 pi x)
double arm_of_cosine(int n) {                                                    // x cos(pi x)
  const double angle = std::numbers::pi / (2 * n), step = n * std::sin(angle);
  return -std::cos(angle) / (2 * step * step);
}

struct TimedFlow {
  BenchFlow flow;
  int cells, along;
  const char* name;
};

const std::vector<TimedFlow>& timed_flows() {
  static const std::vector<TimedFlow> all{
      {{1, false, "cubic", "flip", "musl", 80}, 10, 80, "1-D cubic flip musl"},
      {{2, false, "quadratic", "apic", "leapfrog", 600}, 6, 24, "2-D quadratic apic leapfrog"},
      {{2, true, "linear", "flip", "musl", 700}, 7, 28, "axisymmetric linear flip musl"},
      {{3, false, "quadratic", "apic", "energy", 1200}, 5, 10, "3-D quadratic apic energy"},
      {{2, false, "quadratic", "apic", "leapfrog", 10}, 4, 16, "2-D quadratic apic leapfrog"}};
  return all;
}

// Mean over the lattice of f(p).
template <class Of>
double mean(const Columns& points, const Of& of) {
  double sum = 0;
  for (int p = 0; p < points.points(); ++p) sum += of(p);
  return sum / points.points();
}

void add_scene(const TimedFlow& at, const Scene& scene, KnownAnswers& all) {
  const BenchFlow& flow = at.flow;
  const int dim = flow.dimension;
  const auto row = [&](const char* name, double found, double exact) {
    all.push_back({fmt::format("{}.{}", at.name, name), found, exact, std::max(1.0, exact)});
  };
  row("cells", flow.cells(), at.cells);
  row("points", scene.bodies[0].points.points(), std::pow(at.along, dim));
  row("per-cell", flow.ppc(), std::pow(at.along / at.cells, dim));
  row("width", scene.grid.h, 1.0 / at.cells);
  for (int d = 0; d < 3; ++d) row("cells-along", scene.grid.cells[static_cast<std::size_t>(d)], d < dim ? at.cells : 1);
  const double apic = flow.transfer == "apic" ? 1 : 0;
  row("sharpening", scene.sharpening, apic);
  row("exchange", scene.heat_exchange, apic);
  const bool closed = std::all_of(scene.grid.walls.begin(), scene.grid.walls.end(), [](const auto& sides) {
    return sides[0] == Wall::symmetry && sides[1] == Wall::symmetry;
  });
  all.push_back(yes(fmt::format("{}.closed", at.name), closed));
  all.push_back(whether(fmt::format("{}.rings", at.name), scene.grid.axisymmetric, flow.axisymmetric));
  all.push_back(yes(fmt::format("{}.called", at.name), flow.name() == at.name));
  all.push_back(yes(fmt::format("{}.possible", at.name), flow.is_possible()));
}

void add_flow(const TimedFlow& at, KnownAnswers& all) {
  const Scene scene = flow_scene(at.flow);
  add_scene(at, scene, all);
  const Columns& points = scene.bodies[0].points;
  const int dim = at.flow.dimension, n = at.along;
  const auto x = [&](int p, int d) { return points(column::position, d)[p]; };
  const auto v = [&](int p, int d) { return points(column::velocity, d)[p]; };
  const auto rho = [&](int p) { return points(column::density)[p]; };
  const auto row = [&](const char* name, double exact, const auto& of) {
    all.push_back({fmt::format("{}.{}", at.name, name), mean(points, of), exact});
  };
  row("place", 0.5 * dim, [&](int p) { return x(p, 0) + (dim > 1 ? x(p, 1) : 0) + (dim > 2 ? x(p, 2) : 0); });
  row("place-of-wave", 0.25 + arm_of_wave(n),
      [&](int p) { return x(p, 0) * (0.5 + std::sin(2 * std::numbers::pi * x(p, 0))); });
  row("volume", at.flow.axisymmetric ? 0.5 : 1, [&](int p) { return points(column::volume)[p] * points.points(); });
  row("mass", 0, [&](int p) { return points(column::mass)[p] - rho(p) * points(column::volume)[p]; });
  row("density", 1, rho);
  row("wave", 0.09 * std::pow(0.5, dim), [&](int p) { return (rho(p) - 1) * (rho(p) - 1); });
  row("energy", 2, [&](int p) { return points(column::energy)[p]; });
  row("hot", dim > 1 ? 0 : 0.3 * left_of_wave(n), [&](int p) { return (rho(p) - 1) * points(column::energy)[p]; });
  row("left", 2.5 * 0.125 + 1.5 * 0.375, [&](int p) { return points(column::energy)[p] * x(p, 0); });
  const double half = mean_of_half_wave(n), arm = arm_of_cosine(n);
  if (dim == 1) {
    row("momentum", 0.5 * half, [&](int p) { return v(p, 0); });
    row("dense", 0.3 * arm_of_wave(n), [&](int p) { return (rho(p) - 1) * x(p, 0); });
    return;
  }
  row("along", 0.5 * half * arm, [&](int p) { return v(p, 0) * x(p, 1); });
  row("across", -0.5 * half * arm, [&](int p) { return v(p, 1) * x(p, 0); });
  row("square", 0.25 * 0.25 * 2, [&](int p) { return v(p, 0) * v(p, 0) + v(p, 1) * v(p, 1); });
  if (dim > 2) row("up", 0.25 * half, [&](int p) { return v(p, 2); });
}

// Doubles that a step of a point reads and writes, pass by pass: with d directions and a components of affine velocity, c = 2 d + a + 2
// columns follow the order of the points, and the four of the stress where it is not made anew; a whole number counts half.
double moved(const BenchFlow& flow) {
  const double d = flow.dimension, a = flow.transfer == "apic" ? d * d : 0, c = 2 * d + a + 2;
  const double place = d + 0.5 + 0.5,
               order = d + 1 + 4 * 0.5 + 0.5 + 1 + 1;  // to find bins, and to sort without columns
  const double map = 2 * d + a + 1, forces = d + 2 + (flow.transfer == "apic" ? 3 : 0), rate = d + 1;
  if (flow.integrator == "musl") {
    const double power = 4, move = 4 * d + 1 + 3 * d, advance = 6, mass = d + 1, stress = d + 6, survey = 2 * d + 3;
    return order + 2.5 * (c + 4) + 2 * map + forces + 2 * rate + power + move + advance + place + mass + stress +
           survey;
  }
  const double stress = 2 * d + a + 2 + 5, finish = d + 6 + 2 * d + a + 3;
  const double common = order + 2.5 * c + map + stress + finish;
  if (flow.integrator == "leapfrog") return 3 * d + common;
  const double cooling = d + 4, moving = d;  // points of this one move with the grid, and forces are mapped twice
  return common + 2 * forces + cooling + moving;
}

void add_work(KnownAnswers& all) {
  for (const char* integrator : {"leapfrog", "energy", "musl"}) {
    for (const auto& [dim, rings] : {std::pair{1, false}, {2, false}, {2, true}, {3, false}}) {
      for (const char* transfer : {"apic", "flip"}) {
        if (integrator != std::string("musl") && transfer == std::string("flip")) continue;
        const BenchFlow flow{dim, rings, "quadratic", transfer, integrator, 100};
        const double exact = 8 * moved(flow);
        all.push_back({"bytes." + flow.name(), work_per_point(flow).value_or(PointWork{}).bytes, exact, exact});
      }
    }
  }
  const BenchFlow other{2, false, "quadratic", "flip", "rk4", 100}, none{2, false, "quadratic", "apic", "rk4", 100},
      unknown{2, false, "quadratic", "apic", "no such", 100};
  all.push_back(no("work.of-another", work_per_point(other).has_value()));
  all.push_back(yes("possible.rk4", other.is_possible()));
  all.push_back(no("possible.rk4-filtered", none.is_possible()));
  all.push_back(no("possible.unknown", unknown.is_possible()));
}

Json timed(const char* part, long points, int threads, double rate) {
  return {{"part", part}, {"points", points}, {"threads", threads}, {"particle_steps_per_s", rate}};
}

// A target counts as met on its bounds and between them.
void add_targets(KnownAnswers& all) {
  const auto met = [&](const char* name, double measured, std::optional<double> low, std::optional<double> high,
                       bool exact) {
    const Json entry = target_entry(name, "s", measured, low, high);
    all.push_back(whether(fmt::format("target.{}", name), entry.at("met").get<bool>(), exact));
    all.push_back(whether(fmt::format("target.{}.low", name), entry.at("low").is_null(), !low));
    all.push_back({fmt::format("target.{}.measured", name), entry.at("measured").get<double>(), measured});
  };
  met("any", 3, {}, {}, true);
  met("least", 3, 3.0, {}, true);
  met("below", 2.9, 3.0, {}, false);
  met("most", 3, {}, 3.0, true);
  met("above", 3.1, {}, 3.0, false);
  met("between", 3, 2.0, 4.0, true);

  // Costs of 1/6, 1/4, 1/2 on one thread and of 1/4.2, 1/3 on two; what is too small, of another part or alone does not count.
  const Json kernels{timed("scale", 8999, 1, 100),   timed("scale", 9000, 1, 4),   timed("scale", 100000, 1, 6),
                     timed("matrix", 50000, 1, 1),   timed("scale", 100000, 2, 3), timed("scale", 1000000, 1, 2),
                     timed("scale", 200000, 2, 4.2), timed("scale", 300000, 4, 1)};
  const std::vector<Json> targets = scale_targets(kernels);
  all.push_back({"scale.entries", static_cast<double>(targets.size()), 2});
  const double exact[] = {3, 1.4};
  const bool enough[] = {false, true};
  for (std::size_t k = 0; k < std::min(targets.size(), std::size(exact)); ++k) {
    all.push_back({"scale.ratio", targets[k].at("measured").get<double>(), exact[k]});
    all.push_back({"scale.most", targets[k].at("high").get<double>(), 1.5});
    all.push_back(whether("scale.met", targets[k].at("met").get<bool>(), enough[k]));
  }
}

}  // namespace

KnownAnswers flow_answers() {
  KnownAnswers all;
  for (const TimedFlow& at : timed_flows()) add_flow(at, all);
  add_work(all);
  add_targets(all);
  return all;
}

}  // namespace plumbline
