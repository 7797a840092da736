// A case: one self-registering file with statement and source, set-up, reference, what is measured, and acceptance
// with the reason for each number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/case_gate.hpp"
#include "cases/harness/description/measures.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/description/settings.hpp"
#include "cases/harness/description/study_plan.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

class Archive;

// What the report says of a case before any number.
struct Statement {
  std::string name, title, source, claim;
  std::string physics;                 // paragraphs separated by blank lines
  std::vector<std::string> equations;  // Unicode text
  std::string sketch;                  // inline SVG, currentColor
  std::string cells_along;             // what `cells` counts; empty of trials
  std::string reference_name, reference_text, reference_bound;
  struct TheoryOrder {
    std::string measure;
    double order;
    std::string why;
  };
  std::vector<TheoryOrder> theory_orders;
  std::vector<std::string> known_limits;
};

// One run in the making: the scene, and what is observed and measured of it. Reference and scene come from one struct
// of parameters.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual Scene scene() const = 0;
  // What is foreseen where scene() computes its start by a run or solves for it: without either, the same grid, kinds of bodies and
  // numbers of points in a state whose steps are about as long; and the time in s, >= 0, that scene() steps through.
  virtual Scene unprepared() const { return scene(); }
  virtual double preparation() const { return 0; }
  virtual double end_time() const = 0;
  virtual void observe(const Simulation&) {}  // after each step
  // All that observe() has changed, by name, for a run that is taken up again (archive.hpp). What the settings and the scene
  // determine is made anew and has no place here.
  virtual void history(Archive&) {}
  // After the run; densities are fresh.
  virtual std::vector<Measure> measures(const Simulation& simulation) const = 0;
  virtual Profile profile(const Simulation& simulation) const = 0;
};

// Another method on the same problem, to show errors beside what they cost. Not judged.
struct Comparator {
  struct Level {
    double cells = 0;
    std::int64_t steps = 0, cell_steps = 0;
    double wall_s = 0;                                        // one core
    std::vector<std::pair<std::string, double>> errors = {};  // by measure, the same at each level
  };
  std::string name, title;
  std::vector<Level> levels = {};
};

// What is judged without a run: a named computation with what it measures, as a table of the laboratory.
struct Findings {
  std::vector<Measure> measures;
  Profile profile;
};
struct Trial {
  std::string name, title, why;
  std::function<Findings()> find;
  Tier tier = Tier::quick;             // the lowest that makes it
  std::vector<Override> choices = {};  // of a look at one scheme: what it is the default but for
};

// A case is a value, made by a function without arguments that PLUMBLINE_CASE registers. What it says in words stands in
// NAME.md and NAME.svg beside the code (prose.hpp).
struct Case {
  std::string name;
  Kind kind = Kind::gas;
  std::vector<Key> keys = {};  // of its parameters (parameters.hpp)
  // What it sets beside the scheme, points and end for example: under every scheme, and under york1997 besides.
  std::vector<Override> sets = {}, york1997 = {};
  // The step of york1997, dt or cfl, where neither is given.
  std::function<Override(const Settings&)> york_step = {};
  std::function<std::unique_ptr<Problem>(const Settings& settings)> problem = {};
  std::vector<Trial> trials = {};  // instead of a problem, and of all choices but that of the trial: trial_case()
  std::vector<StudyPlan> studies = {};
  std::vector<CaseGate> gates = {};
  std::vector<double> levels = {};  // of `converge` without --cells
  bool any_integrator = false;      // generic gates for every registered integrator
  Traits needs = {};                // of an integrator, for a run to arrive at its end, beside what the scene needs
  // Measures that some runs of the case do not have, with the reason: they may be no numbers. All others have to be.
  std::map<std::string, std::string> may_be_undefined = {};
  // Run with a study in cells of the default scheme, at its levels, for the problem that the settings describe.
  std::function<std::vector<Comparator>(const Settings&, const std::vector<double>& cells)> comparators = {};
  // As the compiler was told it, "/.../cases/catalog/gas/sod.cpp"; set where the case is registered.
  std::string source_file = {};

  Statement statement() const;
  // Of a case of trials, the one that the settings name.
  const Trial& trial(const Settings& settings) const;
  // The resolved choices of a run. `typed`: "key=value" as given by --set. Throws UsageError, also where neither cfl
  // nor dt is left set.
  Settings settings(const std::string& scheme, const std::vector<Override>& overrides,
                    const std::vector<std::string>& typed = {}) const;
};

// A case of trials. Each is a study whose only level is trial_level, its id the trial's name.
Case trial_case(std::string name, std::vector<Trial> trials, std::vector<CaseGate> gates);
inline constexpr double trial_level = 1;

// Case::problem of a Problem that is made from the settings alone.
template <class Run>
std::unique_ptr<Problem> run_of(const Settings& settings) {
  return std::make_unique<Run>(settings);
}

// Case::york_step: a fixed step of so many seconds over the number of cells; a Courant number.
std::function<Override(const Settings&)> step_over_cells(double dt);
std::function<Override(const Settings&)> courant_number(double cfl);

const std::vector<const Case*>& cases();         // in the order of their names
const Case& find_case(const std::string& name);  // UsageError with the nearest names

// `file`: where it is called, which g++ and clang++ both put there; clang++ 14 has no std::source_location.
struct RegisterCases {
  explicit RegisterCases(std::vector<Case> (*make)(), const char* file = __builtin_FILE());
  explicit RegisterCases(Case (*make)(), const char* file = __builtin_FILE());
};

#define PLUMBLINE_CASE(function) \
  static const ::plumbline::RegisterCases register_##function { function }

}  // namespace plumbline
