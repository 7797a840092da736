// A problem of the stability laboratory: one self-registering file with statement, keys, and the patch that is stepped.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "cases/harness/laboratory/limits.hpp"
#include "cases/harness/laboratory/scene_contents.hpp"

namespace plumbline {

struct ProblemStatement {
  std::string name, title, source;
  std::string statement;               // paragraphs separated by blank lines
  std::vector<std::string> equations;  // Unicode text
  std::string sampled;                 // over what "stable" has been sampled, and over what not
};

struct ClosedForm {
  double limit = 0;  // in the problem's unit; infinite: none
  std::string source;
};

// Along which key a map goes, or the wave number ("theta"), or the step ("dt").
struct Axis {
  std::string key, label;
  std::vector<double> values;
};
// So many of them, at least two, the ends among them.
std::vector<double> evenly_spaced(double low, double high, int count);

// A map over two axes of one choice of settings. "limit": the largest step below which all are stable. "growth": the
// spectral radius over the wave number (x) and the step (y).
struct MapPlan {
  std::string kind = "limit";
  std::string title = {};
  std::string scheme = "default";
  std::vector<Override> overrides = {};
  Axis x = {}, y = {};
  std::vector<std::pair<double, double>> observe = {};  // limit maps: at these places runs look for the limit, too
};

// Order of accuracy in the step, the mesh held, with its 95 % confidence interval.
struct MeasuredOrder {
  double order = 0, low = 0, high = 0;
  std::optional<double> theory = {};
};

// Where points stand in their shares of a cell when one limit is to speak for all places: regular, between, and next to
// a face, where the limit is least.
inline constexpr std::array<double, 3> sampled_places{0.5, 0.25, 0.01};

// A place where a problem occurs in a scene that is to be run.
struct Occurrence {
  std::vector<Override> choices;  // beside those that the problem and the run have in common
  double factor = 1;              // its limit times fastest() and this is one of the run's Courant number
};

class StabilityProblem {
 public:
  virtual ~StabilityProblem() = default;
  virtual std::string name() const = 0;
  // NAME.md beside the code, sections Source, Physics, [Equations], Sampled: harness/prose.hpp.
  ProblemStatement statement() const;
  virtual Kind kind() const = 0;  // which schemes, and which keys beside its own
  // Whether points and grid take part. If not, the keys are its own and those of integrators, every integrator will do, and
  // there is no patch().
  virtual bool has_grid() const { return true; }
  virtual bool has_contact() const { return false; }  // else there is no key `contact`
  virtual std::vector<Key> keys() const = 0;          // its own
  // What it sets beside the scheme: points, positions, and all that a problem of a single method fixes.
  virtual std::vector<Override> choices(const std::string& scheme) const = 0;
  // Of one period and its margins. Ignores the extent where nothing repeats.
  virtual Patch patch(const Settings& settings, const Extent& extent) const;
  virtual Scan scan(const Settings&) const { return {}; }    // in units of the patch's time
  virtual Watch watch(const Settings&) const { return {}; }  // of runs
  virtual std::optional<ClosedForm> closed_form(const Settings&) const { return std::nullopt; }
  virtual std::string unit() const { return "h/c"; }
  // Speed of the fastest wave of all in units of c: limits times this are comparable, and Courant numbers of a run.
  virtual double fastest(const Settings&) const { return 1; }
  // Choices to fall back on, one after another, where an integrator cannot work with the problem's own: what methods of
  // lines need, and steps that give losses back.
  virtual std::vector<std::vector<Override>> concessions() const {
    return {{{"transfer", "flip"}}, {{"shape", "quadratic"}, {"transfer", "apic"}}};
  }
  // What the step says over the scan, limits to a relative `width`; and what runs show. Of the patch, unless a problem
  // knows better.
  virtual Prediction predicted(const Settings& settings, const Scan& scan, double width) const;
  Prediction predicted(const Settings& settings, double width) const {
    return predicted(settings, scan(settings), width);
  }
  virtual Observation observed(const Settings& settings, int reach) const;
  // Of each quantity whose error against an exact solution was measured over a sequence of steps.
  virtual std::map<std::string, MeasuredOrder> orders(const Settings&) const { return {}; }
  virtual std::vector<MapPlan> maps(Tier) const { return {}; }
  // The rows that it has in the list of an integrator's known limits (known_limits.hpp), each by what it sets beside
  // choices(); the first is the representative one. None: the problem is not in the list.
  virtual std::vector<std::vector<Override>> listed() const { return {}; }
  // Whether its rows are found in less than half a second: of explicit steps, and of those that reach everywhere.
  virtual bool quickly_listed(bool explicit_step) const { return explicit_step && compares_integrators(); }
  // Where it occurs in a scene (scene_limit.hpp), at the places of points that are sampled.
  virtual std::vector<Occurrence> occurrences(const SceneContents&) const { return {}; }
  // Whether it is so quick to examine that all problems together are with every integrator; else with the schemes alone.
  virtual bool compares_integrators() const { return false; }
};

const std::vector<const StabilityProblem*>& stability_problems();         // in the order of their names
const StabilityProblem& find_stability_problem(const std::string& name);  // UsageError with the nearest names

struct RegisterStabilityProblem {
  explicit RegisterStabilityProblem(const StabilityProblem* entry);
};
#define PLUMBLINE_STABILITY_PROBLEM(Type) \
  static const Type the_##Type;           \
  static const ::plumbline::RegisterStabilityProblem register_##Type { &the_##Type }

// The resolved choices: the keys of the kind but for those of runs (cells, cfl, dt, split), `positions`, and the problem's
// own. typed: "key=value" as given by --set. Throws UsageError, also for choices that cannot work together.
Settings stability_settings(const StabilityProblem& problem, const std::string& scheme,
                            const std::vector<Override>& overrides, const std::vector<std::string>& typed = {});

// How the laboratory steps it.
Experiment experiment_of(const StabilityProblem& problem, const Settings& settings);

// What was found for one choice of settings.
struct Configuration {
  const StabilityProblem* problem = nullptr;
  std::string scheme;
  Settings settings;
  std::string unit;
  Scan scan;
  Prediction predicted;
  std::optional<Observation> observed;
  std::optional<ClosedForm> closed_form;
  std::string sampled;
  std::map<std::string, MeasuredOrder> orders = {};  // by quantity; measured in runs
  std::string note = {};                             // why nothing was found
};
Configuration examine(const StabilityProblem& problem, const std::string& scheme, const Settings& settings,
                      bool with_runs);

struct StabilityMap {
  MapPlan plan;
  std::string id, integrator, shape, transfer, unit;
  std::vector<std::vector<double>> values;       // a row per y; limits: 0 where no step is stable
  std::vector<std::vector<double>> closed_form;  // the same, NaN where there is none; empty without any
  struct Observed {
    double x, y, low, high;
  };
  std::vector<Observed> observed;
};
StabilityMap draw_map(const StabilityProblem& problem, const MapPlan& plan, int threads);

// Every registered integrator, shape and transfer that work together.
struct Method {
  std::string integrator, shape, transfer;
  std::vector<Override> overrides() const;
};
std::vector<Method> methods(const std::vector<std::string>& shapes, const std::vector<std::string>& transfers);
// Those of them whose step reaches a few cells of a bar, not all of it: maps of the others cost too much.
std::vector<Method> explicit_methods(const std::vector<std::string>& shapes, const std::vector<std::string>& transfers);

}  // namespace plumbline
