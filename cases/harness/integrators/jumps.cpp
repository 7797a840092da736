// Jumps that run along a bar and through a gas, and two bars that collide.
#include <algorithm>
#include <cmath>

#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {
namespace {

struct Refinement {
  const char* case_name;
  std::vector<double> cells;
};
const Refinement bar{"bar-riemann", {50, 70, 100, 140, 200}}, tube{"sod", {50, 70, 100, 140, 200}},
    collision{"two-bar", {20, 40}};

// The case's default scheme with the integrator, at these meshes.
const StudyResult& study_of(const Refinement& refinement, const Subject& subject) {
  return subject.once<StudyResult>(std::string("study/") + refinement.case_name, [&] {
    const Case& entry = find_case(refinement.case_name);
    StudyPlan plan = integrator_plan(entry, subject.name());
    plan.values = refinement.cells;
    for (const auto& [key, value] : subject.choice().parameters) plan.overrides.emplace_back(key, value);
    return run_study(entry, plan, planned_runs(entry, plan, Tier::quick), 1);
  });
}

Measured fitted(const StudyResult& study, const std::string& measure) {
  for (const StudyLevel& at : study.levels) {
    if (const auto stop = stop_of(at.run)) return *stop;
  }
  const OrderFit* fit = study.fit(measure);
  Measured measured = plain(fit ? fit->order : std::nan(""));
  measured.invalid = !fit || fit->invalid;
  return measured;
}

IntegratorGate order_row(const Refinement& of, const std::string& measure, double least, const std::string& why) {
  return {"jumps",
          gate_row("jumps", std::string(of.case_name) + "/" + measure, "fitted order in h of " + measure, {least, {}},
                   Origin::theory, why),
          "a jump is raised, smeared or carried with another speed: forces, strains or motion of different instants",
          [&of, measure](const Subject& s) { return fitted(study_of(of, s), measure); }};
}

// Where maps' losses are returned the shock of a gas heats as it must, and errors fall with h; elsewhere its place and
// pressure are off by what the maps take, and errors fall, but not with h.
Measured shock_order(const Subject& subject) {
  if (subject.traits().offers.count(Trait::returned_loss) == 0) {
    throw CannotWork({{Trait::returned_loss, "an order of shocks", "integrator " + subject.name()}});
  }
  return fitted(study_of(tube, subject), "density.L1");
}

Measured fall(const Refinement& of, const std::string& measure, const Subject& subject) {
  const StudyResult& study = study_of(of, subject);
  const Measured first = fitted(study, measure);  // says where a run stopped
  if (first.stopped || first.invalid) return first;
  const Measure* coarse = study.levels.front().run.find(measure);
  const Measure* fine = study.levels.back().run.find(measure);
  return plain(fine->error / coarse->error);
}

IntegratorGate fall_row(const Refinement& of, const std::string& measure) {
  return {"jumps",
          gate_row("jumps", std::string(of.case_name) + "/" + measure + "-falls",
                   "error of " + measure + " at the finest mesh over that at the coarsest", {{}, 1.0}, Origin::theory,
                   "a finer mesh carries a jump more exactly"),
          "an error that does not depend on the mesh: a defect of the step",
          [&of, measure](const Subject& s) { return fall(of, measure, s); }};
}

// The largest of read(run) over the meshes of the collision.
template <class Read>
Measured largest_in_collision(const Subject& subject, Read&& read) {
  double largest = 0;
  for (const StudyLevel& at : study_of(collision, subject).levels) {
    if (const auto stop = stop_of(at.run)) return *stop;
    largest = larger(largest, read(at.run));
  }
  return plain(largest);
}

}  // namespace

std::vector<IntegratorGate> jump_gates() {
  constexpr const char* trains =
      "dispersion of second order makes trains of waves of a jump, order 1/2 in the mean; 0.2 for meshes on which "
      "their "
      "width, (t h^2)^(1/3), is still a tenth of the bar";
  std::vector<IntegratorGate> all{order_row(bar, "velocity.L1", 0.3, trains), order_row(bar, "stress.L1", 0.3, trains),
                                  order_row(bar, "displacement.L1", 0.9,
                                            "4/3 where dispersion of second order leads, 1 where dissipation of first "
                                            "order does; 0.1 for coarse meshes")};
  for (const char* measure : {"velocity.L1", "stress.L1", "displacement.L1"}) all.push_back(fall_row(bar, measure));
  all.push_back({"jumps",
                 gate_row("jumps", "sod/density.L1", "fitted order in h of density.L1", {0.8, {}}, Origin::theory,
                          "1 at jumps where maps' losses are returned; 0.2 for coarse meshes"),
                 "losses of the maps are not returned in full, or at another point", shock_order});
  for (const char* measure : {"density.L1", "velocity.L1", "pressure.L1"}) all.push_back(fall_row(tube, measure));
  all.push_back(
      {"jumps",
       gate_row("jumps", "two-bar/momentum", "relative drift of momentum of two bars that collide", {{}, 1e-12},
                Origin::identity, "contact forces are opposite and equal; 1e-12 for roundings of sums"),
       "a velocity is changed beside the stages", [](const Subject& s) {
         return largest_in_collision(s,
                                     [](const RunResult& run) { return run.ledger.momentum[0].relative_drift(true); });
       }});
  all.push_back(
      {"jumps",
       gate_row("jumps", "two-bar/energy", "relative residual of the energy of two bars that collide", {{}, 1e-12},
                Origin::identity, "contact brings no energy that is not booked; 1e-12 for roundings"),
       "a velocity or a strain is changed beside the stages", [](const Subject& s) {
         return largest_in_collision(s, [](const RunResult& run) { return run.ledger.energy.relative_drift(false); });
       }});
  return all;
}

}  // namespace plumbline
