// A case: one self-registering file with statement and source, set-up, reference, what is measured, and acceptance
// with the reason for each number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/description/measures.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/description/settings.hpp"
#include "cases/harness/verdict/verdict.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

class Archive;

enum class Tier { quick, full };

// What the report says of a case before any number.
struct Statement {
  std::string name, title, source, claim;
  std::string physics;                 // paragraphs separated by blank lines
  std::vector<std::string> equations;  // Unicode text
  std::string sketch;                  // inline SVG, currentColor
  std::string cells_along;             // what `cells` counts
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
  virtual double end_time() const = 0;
  virtual void observe(const Simulation&) {}  // after each step
  // All that observe() has changed, by name, for a run that is taken up again (archive.hpp). What the settings and the scene
  // determine is made anew and has no place here.
  virtual void history(Archive&) {}
  // After the run; densities are fresh.
  virtual std::vector<Measure> measures(const Simulation& simulation) const = 0;
  virtual Profile profile(const Simulation& simulation) const = 0;
};

// What is refined.
enum class Vary { cells, dt, ppc, offset };
std::string name(Vary vary);
Vary vary_from(const std::string& name);  // UsageError

struct StudyResult;

// A refinement study that verify runs: a scheme with overrides, varied over values.
struct StudyPlan {
  std::string id, title;
  std::string why;  // the order that theory allows, and why
  std::string scheme = "default";
  std::vector<Override> overrides = {};
  Vary vary = Vary::cells;
  std::vector<double> values = {};       // cells; factors of the step for dt; points per cell; offsets
  Tier tier = Tier::quick;               // the lowest tier that runs it
  std::vector<double> full_values = {};  // replaces `values` in the full tier, if not empty
  bool offsets_in_full = false;          // the full tier repeats each level at four sub-cell offsets
  int frames = 0;                        // 2 ... 100: so many snapshots of its last level for the report's pictures
  std::optional<double> frames_at = {};  // of the level with this value instead
};

// A gate on a study: which number, and what it must be.
struct CaseGate {
  std::string study;  // StudyPlan::id
  Gate gate;
  std::vector<double> levels;  // the levels that the number needs; empty: the whole study
  std::function<Measured(const StudyResult&)> measure;
  Tier tier = Tier::quick;
  std::vector<std::string> also = {};  // further studies it compares with, by StudyResult::sibling
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

class Case {
 public:
  virtual ~Case() = default;
  virtual std::string name() const = 0;
  virtual Statement statement() const;  // NAME.md and NAME.svg beside the code: harness/prose.hpp
  virtual Kind kind() const = 0;
  virtual std::vector<Key> keys() const = 0;                                          // the case's own
  virtual std::vector<Override> points_and_end(const std::string& scheme) const = 0;  // what it sets beside the scheme
  // Choices that follow from others, after all have been set (York's step in proportion to h). Unset keys only.
  virtual void derive(Settings&, const std::string& /*scheme*/) const {}
  virtual std::unique_ptr<Problem> problem(const Settings& settings) const = 0;
  virtual std::vector<StudyPlan> studies() const = 0;
  virtual std::vector<CaseGate> gates() const = 0;
  virtual bool any_integrator() const { return false; }    // generic gates for every registered integrator
  virtual bool takes_integrators() const { return true; }  // whether what it judges depends on the integrator
  virtual std::vector<double> default_levels() const = 0;  // of `converge` without --cells
  // What an integrator must offer for a run to arrive at its end, beside what the scene needs of it.
  virtual Traits needs() const { return {}; }
  // Measures that some runs of the case do not have, with the reason: they may be no numbers. All others have to be.
  virtual std::map<std::string, std::string> may_be_undefined() const { return {}; }
  // Run with a study in cells of the default scheme, at its levels, for the problem that the settings describe.
  virtual std::vector<Comparator> comparators(const Settings& /*settings*/,
                                              const std::vector<double>& /*cells*/) const {
    return {};
  }

  // The resolved choices of a run. `typed`: "key=value" as given by --set. Throws UsageError, also where neither cfl
  // nor dt is left set.
  Settings settings(const std::string& scheme, const std::vector<Override>& overrides,
                    const std::vector<std::string>& typed = {}) const;
};

const std::vector<const Case*>& cases();         // in the order of their names
const Case& find_case(const std::string& name);  // UsageError with the nearest names

// `file`: where it is called, which g++ and clang++ both put there; clang++ 14 has no std::source_location.
struct RegisterCase {
  explicit RegisterCase(const Case* entry, const char* file = __builtin_FILE());
};
// The file that registers a case, as the compiler was told it: "/.../cases/catalog/gas/sod.cpp". Several may share one.
const std::string& source_file(const Case& entry);

#define PLUMBLINE_CASE(Type)    \
  static const Type the_##Type; \
  static const ::plumbline::RegisterCase register_##Type { &the_##Type }

}  // namespace plumbline
