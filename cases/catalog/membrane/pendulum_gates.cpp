#include "cases/catalog/membrane/pendulum_gates.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/elastic_pendulum.hpp"

namespace plumbline {
namespace {

// The period's error over T h^2/(8 L^2).
const Number period_constant = number_at(
    "error of the period over T h^2/(8 L^2) at 20 cells", "period", 20,
    [](const RunResult& run, const Measure& period) {
      const double length = reference::ElasticPendulum({}).length().value;
      return Measured::of(period.error * 8 * length * length / (*period.reference * run.h * run.h));
    });

// The least ratio of the errors at two levels that the reference's own bound leaves.
Number least_ratio(const std::string& measure, double coarse, double fine) {
  return number_of(measure + " at " + to_text(coarse) + " over " + to_text(fine),
                   [=](const StudyResult& s) {
                     const Measure *a = s.level(coarse)->run.find(measure), *b = s.level(fine)->run.find(measure);
                     if (!a || !b) throw std::runtime_error("a run has no " + measure);
                     return Measured::of((a->error - a->reference_bound) / (b->error + b->reference_bound));
                   },
                   {coarse, fine});
}

// What may be seen of a string's mean length in Fig. 37.
constexpr double unbroken = 0.01;

// How many runs stop, or end with a string that has torn.
const Number torn_runs = number_of("runs that stop or whose string tears", [](const StudyResult& s) {
  double torn = 0;
  for (const StudyLevel& at : s.levels) {
    torn += !at.run.finished || !(std::abs(*at.run.find("length_drift")->value) <= unbroken) ? 1 : 0;
  }
  return Measured::of(torn);
});

// Of what the bob has lost of its amplitude; all of it, of a run that stops before its end.
double lost(const StudyResult& study, const std::string& measure, double level) {
  const RunResult& run = study.level(level)->run;
  return run.finished ? run.find(measure)->error : 1;
}

// What was lost on one mesh of a study over what was on a finer one of another.
Number loss_over(const std::string& measure, const std::string& study, double coarse, const std::string& other,
                 double fine) {
  return number_of(measure + " at " + to_text(coarse) + " over " + to_text(fine), [=](const StudyResult& s) {
    const auto of = [&s](const std::string& id) -> const StudyResult& { return id == s.plan.id ? s : *s.sibling(id); };
    return Measured::of(lost(of(study), measure, coarse) / lost(of(other), measure, fine));
  });
}

// What was lost at 20 over what a power of h leaves between 10 and 40.
const Number loss_between = number_of(
    "amplitude_loss at 20 over the geometric mean of 10 and 40", [](const StudyResult& s) {
      const std::string measure = "amplitude_loss";
      return Measured::of(lost(*s.sibling("york-fine"), measure, 20) /
                          std::sqrt(lost(*s.sibling("york1997"), measure, 10) * lost(s, measure, 40)));
    });

// A measure over that of another study, at 10.
Number over_sibling(const std::string& measure, const std::string& other) {
  return number_of(measure + " at 10 over that of " + other,
                   [=](const StudyResult& s) {
                     const RunResult &own = s.level(10)->run, &its = s.sibling(other)->level(10)->run;
                     for (const RunResult* run : {&own, &its}) {
                       if (const auto stop = stop_of(*run)) return *stop;
                     }
                     return Measured::of(own.find(measure)->error / its.find(measure)->error);
                   },
                   {10});
}

// Of a rigid pendulum at the bottom, m/s.
double fastest_bob() {
  const reference::ElasticPendulum swing({});
  return std::sqrt(2 * swing.problem().gravity * swing.length().value * (1 - std::cos(swing.angle().value)));
}

}  // namespace

std::vector<CaseGate> pendulum_gates() {
  const double heavy_period = reference::ElasticPendulum({}).heavy_period().value, tenth_percent = 1e-3 * heavy_period;
  const double last_frame = 1.25;  // s
  const std::string bands = "2026-11-23 5825b24";
  std::vector<CaseGate> all;
  for (const std::string study : {"default", "accumulated"}) {
    const Tier tier = study == "default" ? Tier::quick : Tier::full;
    all.push_back(
        gate(study + "/period-20", error_at("period", 20), at_most(tenth_percent),
             requirement("within 0.1 % of the elastic pendulum; the bob's smeared inertia makes h^2/(8 L^2) = 0.06 %"))
            .in(tier));
    all.push_back(gate(study + "/loss-20", error_at("amplitude_loss", 20), at_most(1e-3),
                       requirement("at most 0.1 % in a whole swing: the amplitude would halve in seven hundred"))
                      .in(tier));
    all.push_back(gate(study + "/aligned-20", value_at("misalignment", 20), at_most(0.1 / 79),
                       requirement("points on the chord: York judges by eye, where points touch; a tenth of their "
                                   "spacing, L/79, is not seen"))
                      .in(tier));
  }
  for (const std::string measure : {"period", "amplitude_loss"}) {
    for (const auto& [coarse, fine] : {std::pair{5.0, 10.0}, {10.0, 20.0}, {20.0, 40.0}}) {
      all.push_back(gate("default/" + measure + "-" + to_text(coarse) + "-" + to_text(fine),
                         least_ratio(measure, coarse, fine), at_least(std::pow(2, 1.5)),
                         theory("order 2 divides it by 4 at every halving of h; 2^1.5, half an order less, for coarse "
                                "meshes. The bound of the reference counts against it"))
                        .in(fine == 40 ? Tier::full : Tier::quick));
    }
  }
  const std::vector<CaseGate> rows{
      gate("default/period-constant-20", period_constant, between(0.92, 1.08),
           theory("the bob's kernel turns with the string and adds the inertia m h^2/4: too long by the share h^2/(8 "
                  "L^2); 7 % for the next order, h/L, and 1 % for the bound of the reference")),
      gate("box/period-20", error_at("period", 20), at_most(tenth_percent),
           requirement("within 0.1 % of the elastic pendulum, as in the wide box: two cells to the wall"))
          .in(Tier::full),
      gate("box/period-10", error_at("period", 10), at_most(4 * tenth_percent),
           theory("four times what is required at half the cell, as at second order"))
          .fails("the left wall stands one cell from the bob at its release, within its kernel, and mirrors it",
                 {0.028, 0.0345}, bands)
          .in(Tier::full),
      gate("free/loss-10", value_at("amplitude_loss", 10), at_most(4e-3),
           theory("the one-way law does not matter to the swing: at most four times what is required at half the cell, "
                  "as at second order"))
          .in(Tier::full)};

  const Because figure = literature("the loss shrinks with refinement, Fig. 37");
  const Because near_figure = literature(
      "Fig. 37 spans 1.8 s; York sees reasonable agreement: 3 % of a period can be told there");
  const Because untorn = literature(
      "Fig. 37 shows swings to 1.8 s, so the string is whole; it stretches by 0.001, and a hundredth of its length "
      "cannot be seen there");
  const std::string torn =
      "the noise of its light points tears the string, at h = 0.05 in some runs from 1.0 s on, at 0.025 from 1.3 s: "
      "the bob "
      "falls to the floor and lies there with a velocity in the null space of the maps; some of the runs whose masses "
      "differ by 1e-14 of themselves stop";
  const Because tangent = literature(
      "York, section 5.4.2: the stress is tangent where the total strain is kept along the tangent; to rounding");
  const Because similar = literature(
      "York, section 5.7.3: without the one-way law the results are similar; as near to the finite elements "
      "as is asked of those with it");
  const Because towards_fem = literature(
      "York, section 5.7: convergence towards the finite elements, whose frames Fig. 36 shows");
  const std::vector<CaseGate> sections{
      gate("york1997/frames-10", value_at("from_fem", 10), at_most(0.03 * heavy_period * fastest_bob()),
           literature("Fig. 36 beside Fig. 33, frames until 1.25 s: York sees reasonable agreement; 3 % of a period, "
                      "which can be told in Fig. 37, at the bob's greatest speed")),
      gate("default/frames-5-10", ratio_of("from_fem", 5, 10), at_least(1), towards_fem),
      gate("default/frames-10-20", ratio_of("from_fem", 10, 20), at_least(1), towards_fem),
      gate("default/frames-20", value_at("from_fem", 20), at_most(1e-3 * last_frame * fastest_bob()),
           requirement("late by at most 0.1 % of the 1.25 s until the last frame, as is asked of the period, at the "
                       "bob's greatest speed")),
      gate("york-free/misaligned", over_sibling("mean_misalignment", "york1997"), at_least(1.01),
           literature("York, section 5.7.3, Fig. 38: without the one-way law points are not aligned as well; a "
                      "hundredth, for a law without any effect"))
          .beside({"york1997"}),
      gate("york-free/frames-10", value_at("from_fem", 10), at_most(0.03 * heavy_period * fastest_bob()), similar),
      gate("york-free/compressed", value_at("least_tension", 10), at_most(-0.01),
           literature("York, section 5.7.3, Fig. 38: what may misalign points is that oscillations along the string "
                      "compress some; a hundredth of the stress at rest, for none")),
      gate("york1997/tangent", value_at("off_tangent", 10), at_most(1e-12), tangent),
      gate("york-increments/tangent", value_at("off_tangent", 10), at_most(1e-12), tangent)
          .fails("what was summed stays where it was as the string turns: a twentieth of a second on, its forces push "
                 "the points 2.5 % of the length off the chord, and soon after out of the grid",
                 {0.080, 0.105}, "2026-11-26 efaf9f4"),
      gate("york-layers/constant-stress", value_at("stress_spread", 10), at_most(0.1),
           literature("York, section 5.4.5: stress must be constant through the thickness, a tenth of it left"))
          .fails("each layer hangs from the wall by itself and has a tangential strain of its own: as the string turns "
                 "about its end one is stretched and the other is let go, as in a bent plate; by 0.1 s the "
                 "difference is 0.43 of the stress",
                 {0.52, 0.69}, "2026-11-26 efaf9f4")};

  // Once the string has torn, a run is as roundings will: these bands hold what ensembles of runs show (ci/ensembles).
  const StopBand on_20{95000, 175000, "velocity"}, on_40{270000, 350000, "position"};
  const std::vector<CaseGate> york{
      gate("york-fine/length-20", value_at("length_drift", 20), between(-unbroken, unbroken), untorn)
          .fails(torn, {0.02, 0.28}, bands)
          .or_stops(on_20)
          .in(Tier::full),
      gate("york-fine/length-40", value_at("length_drift", 40), between(-unbroken, unbroken), untorn)
          .fails(torn, {0.0101, 0.12}, bands)
          .or_stops(on_40)
          .in(Tier::full),
      gate("york-fine/finite", torn_runs, exactly(0), untorn).fails(torn, {2, 2}, bands).in(Tier::full),
      gate("york1997/period-10", error_at("period", 10), at_most(0.03 * heavy_period), near_figure),
      gate("york1997/period-5", error_at("period", 5), at_most(0.03 * heavy_period), near_figure)
          .fails("the bob starts half a cell from the left wall and never swings across", {0.93, 1.13}, bands)
          .in(Tier::full),
      gate("york-half/half-loss-10-20", loss_over("half_loss", "york1997", 10, "york-half", 20), at_least(1), figure)
          .beside({"york1997"})
          .in(Tier::full),
      gate("york-half/half-loss-20-40", loss_over("half_loss", "york-half", 20, "york-swing", 40), at_least(1), figure)
          .beside({"york-swing"})
          .in(Tier::full),
      gate("york-swing/loss-10-40", loss_over("amplitude_loss", "york1997", 10, "york-swing", 40), at_least(1), figure)
          .beside({"york1997"})
          .in(Tier::full),
      gate("york-swing/loss-20", loss_between, at_most(1),
           theory("the loss shrinks with refinement, Fig. 37: as a power of h, of which the mesh between two has the "
                  "geometric mean"))
          .beside({"york1997", "york-fine"})
          .fails(
              "on the way back at h = 0.05 the light points of the string keep, under FLIP and linear shapes, what "
              "noise each crossing of a cell's side gives them, leave the chord by a tenth of its length and tear "
              "the string: in some of the runs that differ by roundings the bob comes back, a tenth of its amplitude "
              "short, in others it does not, or the run stops",
              {1.05, 27}, bands)
          .in(Tier::full)};
  return joined({all, rows, sections, york});
}

}  // namespace plumbline
