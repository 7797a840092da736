// Taylor's test: a copper cylinder strikes a rigid wall, and its end spreads like a mushroom.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/catalog/solid/taylor_rod.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline::taylor_bar {
namespace {

struct Bar : Parameters {
  TaylorRod rod;

  explicit Bar(Parameters given = {}) : Parameters(std::move(given)) {
    rod.length = positive("length", rod.length, "m", "L");
    rod.radius = positive("radius", rod.radius, "m", "R");
    rod.velocity = positive("velocity", rod.velocity, "m/s", "V, towards the wall");
    rod.youngs_modulus = positive("youngs_modulus", rod.youngs_modulus, "Pa", "E");
    rod.poissons_ratio = number(poisson_key(rod.poissons_ratio));
    rod.density = positive("initial_density", rod.density, "kg/m^3", "density");
    rod.yield_stress = positive("yield_stress", rod.yield_stress, "Pa", "Y, of the metal without plastic strain");
    rod.hardening_modulus = not_negative("hardening_modulus", rod.hardening_modulus, "Pa",
                                         "H, of Y over the plastic strain");
    rod.viscosity_linear = number({.name = "viscosity_linear",
                                   .value = 0.1,
                                   .low = 0,
                                   .high = 0.5,
                                   .description = "c_L of the solid's artificial viscosity",
                                   .method = true});
    rod.end_time = positive("t_end", rod.end_time, "s", "end time");
  }
};

std::unique_ptr<Problem> run(const Settings& settings) { return taylor_rod_problem(Bar(settings).rod, settings); }

const std::vector<double> coarse{3, 4}, levels{4, 6, 8, 12, 16};
const std::vector<double> early{8, 12, 16, 24, 32}, early_fine{8, 16, 24, 32, 48, 64};

std::vector<StudyPlan> studies() {
  const std::string half =
      "Shocks, the faster one linear, that the viscosity spreads as the root of h: order 1/2 and more.";
  return {study("default", "default",
                "Nothing exact to compare with; shocks and a corner that folds allow first order.", coarse)
              .in_full(levels)
              .pictured(25),
          study("domains", "CPDI, domains that shear with the points", "As the default's boxes.", {4})
              .with({{"shape", "cpdi"}})
              .in_full({4, 8}),
          study("unshared", "each point bears pressure by its own dilatation",
                "Flow that keeps each point's volume locks.", {4})
              .with({{"dilatation", "point"}}),
          study("cubic", "cubic B-splines", "Too smooth for a pressure of each point.", {4})
              .with({{"shape", "cubic"}})
              .in_full({4, 8}),
          // Until R/(2 c_e), of as much of the rod as the faster wave runs through meanwhile.
          study("face", "default, the first instant", half, early)
              .with({{"t_end", 3.4e-7}, {"length", 2e-3}, {"viscosity_linear", 0.3}})
              .in_full(early_fine)};
}

// The largest of a measure over all runs of the study.
Number largest(const std::string& measure, const std::string& words) {
  return number_of(words, [measure](const StudyResult& study) {
    double most = 0;
    for (const double value : values_of(study, measure)) most = larger(most, value);
    return Measured::of(most);
  });
}
Number least(const std::string& measure, const std::string& words) {
  return number_of(words, [measure](const StudyResult& study) {
    std::vector<double> values = values_of(study, measure);
    double found = values.front();
    for (const double value : values) found = smaller(found, value);
    return Measured::of(found);
  });
}

std::vector<CaseGate> of_every(const std::string& study) {
  const auto rounding = [&](const std::string& id, const std::string& measure, const std::string& words,
                            const std::string& why) {
    return gate(study + "/" + id, largest(measure, words), at_most(1e-12), identity(why));
  };
  return {
      rounding("start", "start", "kinetic energy of the points at the start less the rod's, over it",
               "rings have the masses of the rod's parts; roundings of sums"),
      rounding("yield", "yield_off",
               "largest excess of q over the yield stress, and of points that flow its distance, over Y",
               "a return ends on the surface; roundings of the stresses"),
      gate(study + "/flow-back", largest("flow_back", "largest fall of a point's plastic strain in a step"), at_most(0),
           identity("a return adds plastic strain or none")),
      rounding("volume", "volume_off", "largest |ln det F - trace of the elastic strain|",
               "flow is without trace; roundings of the steps"),
      rounding("shared-dilatation", "shared_off",
               "mass times the dilatation that cells share less that of the points, over the latter's sum of sizes",
               "a mean over a cell has the sum of what it is the mean of; roundings of the steps"),
      rounding("store", "store_off",
               "elastic energy less that of the strains and H alpha^2/2, over the energy at the start",
               "the same strains, summed twice"),
      rounding("heat", "heat_off", "internal energy less Y alpha and heat by viscosity, over the energy at the start",
               "what plastic flow and viscosity dissipate is heat; roundings of sums"),
      rounding("heat-fall", "heat_fall", "largest fall of the internal energy in a step, over the energy at the start",
               "neither plastic flow nor viscosity cools; roundings of sums"),
      rounding("energy", "energy_off", "energy that no flow accounts for, over that at the start",
               "stores and losses are booked one by one; roundings of sums"),
      rounding("momentum", "momentum_off", "momentum along the axis that is not the wall's, over that at the start",
               "nothing else pushes along the axis; roundings of sums"),
      rounding("wall-work", "wall_work", "work of the wall, over the energy at the start", "the wall stands still"),
      rounding("lines-excess", "lines_excess", "largest |ln stretch| of a line along the axis less the plastic strain",
               "a step of flow stretches no line by more than the exponential of its plastic strain, in exact numbers "
               "too; near the axis, where flow is uniaxial, by no less"),
      gate(study + "/plastic-work", largest("plastic_work", "work of plastic flow over the energy at the start"),
           at_most(1), theory("the wall does no work: all of it is the rod's own energy")),
      gate(study + "/lines-kept", least("lines_kept", "mean stretch of lines along the axis over the least one"),
           at_least(1),
           theory("the energy at the start, spent on flow of the same strain everywhere, stretches lines by the least; "
                  "Jensen's inequality"))};
}

// v(h) -> v(0) at order one or more: the slope |dv/dh| does not grow as h falls.
CaseGate settles(const std::string& measure) {
  const auto growth = [measure](const StudyResult& study) {
    const std::vector<double> values = values_of(study, measure);
    double most = 0, before = 0;
    for (std::size_t k = 1; k < values.size(); ++k) {
      const double slope = std::abs((values[k] - values[k - 1]) / (study.levels[k].h - study.levels[k - 1].h));
      if (k > 1) most = larger(most, slope / before);
      before = slope;
    }
    return Measured::of(most);
  };
  return gate(
             "default/" + measure + "-settles",
             number_of("largest growth of the slope of the " + measure + " over h, from one pair of meshes to the next",
                       growth, levels),
             at_most(1), theory("what converges at first order or better has a slope that stays or falls"))
      .in(Tier::full);
}

// A pressure that alternates from point to point by a tenth of the yield stress hides none of it.
CaseGate alternation(const std::string& study, double level) {
  return gate(study + "/alternation-" + to_text(level), value_at("alternation", level), at_most(0.1),
              requirement("a tenth of the yield stress, by which stresses are looked at"));
}

std::vector<CaseGate> of_pressure() {
  const std::string locked =
      "each of the four points of a cell keeps its volume in plastic flow, which leaves the two "
      "displacements of its node nothing else to do: pressures alternate along the axis";
  return {alternation("default", 4), alternation("default", 16).in(Tier::full), alternation("cubic", 4),
          alternation("unshared", 4).fails(locked, {1.4, 1.88}, "2026-11-27 fbdb40b")};
}

std::vector<CaseGate> of_face() {
  const auto off = [](double level) {
    return number_at("stress behind the plastic shock, less the exact one, over it", "face_plateau", level,
                     [](const RunResult&, const Measure& m) { return Measured::of(m.error / m.scale); });
  };
  const std::string hundredth = "a hundredth, a quarter of what small strains leave out";
  const std::string shared =
      "cells share the dilatation that a shock makes, and points take theirs along to other cells: what the stress "
      "behind it is off by falls with h from here on";
  return {gate("face/velocity.L1-order", fitted_order_of("face_velocity.L1"), at_least(0.4),
               theory("1/2 of jumps that are spread over the root of h t, less 0.1 for coarse meshes")),
          gate("face/plateau-32", off(32), at_most(0.01), requirement(hundredth))
              .fails(shared, {0.0087, 0.0114}, "2026-11-28 557069b"),
          gate("face/plateau-64", off(64), at_most(0.01), requirement(hundredth)).in(Tier::full)};
}

std::vector<CaseGate> gates() {
  return joined({of_every("default"),
                 of_every("domains"),
                 of_every("cubic"),
                 of_face(),
                 of_pressure(),
                 {settles("length"), settles("radius")}});
}

Case taylor_bar() {
  const std::string late = "none once waves from the rod's side have come to the middle of the face";
  return {.name = "taylor-bar",
          .kind = Kind::solid,
          .keys = Bar().keys(),
          .sets = {{"cells", 8.0}},
          .york_step = courant_number(published_courant),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = levels,
          .may_be_undefined = {{"face_stress.L1", late},
                               {"face_velocity.L1", late},
                               {"face_plastic_strain.L1", late},
                               {"face_plateau", late}}};
}
PLUMBLINE_CASE(taylor_bar);

}  // namespace
}  // namespace plumbline::taylor_bar
