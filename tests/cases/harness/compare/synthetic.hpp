// Snapshots made up for tests: a study of a power law, its gates, a limit of the step, times.
#pragma once

#include <cmath>
#include <vector>

#include "cases/harness/compare/snapshot.hpp"

namespace plumbline {

inline Json synthetic_gate(const std::string& id, const std::string& verdict, double high) {
  return {{"id", id},
          {"case", "toy"},
          {"scheme", "default"},
          {"study", "cells"},
          {"quantity", "density.L1 at 100"},
          {"expected", {{"low", nullptr}, {"high", high}}},
          {"measured", 0.005},
          {"verdict", verdict},
          {"band", nullptr}};
}

struct SyntheticStudy {
  double order = 2, constant = 1;
  std::vector<double> cells{50, 71, 100, 141, 200, 283};
  std::vector<double> noise{};  // factors of the errors, by level
  bool stops = false;           // its finest level does

  double error(std::size_t k) const {
    return constant * std::pow(cells[k], -order) * (k < noise.size() ? noise[k] : 1);
  }
  Json document() const {
    Json levels = Json::array();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const bool stopped = stops && k + 1 == cells.size();
      Json measures{{"density.L1", {{"error", error(k)}, {"relative_error", error(k)}, {"reference_bound", 0}}}};
      levels.push_back({{"value", cells[k]},
                        {"h", 1 / cells[k]},
                        {"finished", !stopped},
                        {"stop", stopped ? Json{{"step", 7}, {"reason", "density is not positive"}} : Json(nullptr)},
                        {"measures", stopped ? Json::object() : measures}});
    }
    return {{"case", "toy"},
            {"scheme", "default"},
            {"id", "cells"},
            {"vary", "cells"},
            {"settings", {{"cells", cells.front()}, {"transfer", "apic"}}},
            {"levels", levels},
            {"measures",
             {{"density.L1",
               {{"order", order}, {"order_low", order - 0.1}, {"order_high", order + 0.1}, {"constant", constant}}}}},
            {"provenance", {{"started", "2026-11-21T00:00:00Z"}}}};
  }
};

inline Json synthetic_stability(double limit, double low, double high) {
  return {{"problem", "bar"},
          {"configurations",
           {{{"integrator", "musl"},
             {"settings", {{"N", 0.3}}},
             {"unit", "h/c"},
             {"predicted", {{{"low", 0}, {"high", limit}}}},
             {"closed_form", nullptr},
             {"observed", {{{"low", low}, {"high", high}}}},
             {"always", nullptr},
             {"growth", Json::array()}}}}};
}

inline Json synthetic_costs(const std::vector<double>& wall_s, Json instructions = nullptr,
                            const std::string& cpu = "some") {
  return {{"machine", {{"cpu", cpu}, {"compiler", "g++ 12"}}},
          {"runs",
           {{{"case", "toy"},
             {"scheme", "default"},
             {"study", "cells"},
             {"vary", "cells"},
             {"value", 100},
             {"wall_s", wall_s},
             {"instructions", std::move(instructions)}}}}};
}

// One of everything.
struct Synthetic {
  std::vector<Json> gates{synthetic_gate("cells/density", "PASS", 0.007), synthetic_gate("cells/mass", "PASS", 1e-12)};
  SyntheticStudy study{};
  Json stability = synthetic_stability(1.8, 1.79, 1.81);
  Json costs = synthetic_costs({1.00, 1.01, 1.02, 0.99, 1.00});

  Snapshot snapshot() const {
    Snapshot s;
    take_verdicts({{"tier", "quick"}, {"gates", gates}},
                  {{"started", "2026-11-21T00:00:00Z"}, {"version", "1.0.0"}, {"git", "abc"}, {"dirty", false}}, s);
    take_study(study.document(), "study-toy.h5", s);
    take_stability(stability, s);
    take_costs(costs, s);
    return s;
  }
};

}  // namespace plumbline
