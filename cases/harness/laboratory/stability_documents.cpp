#include "cases/harness/laboratory/stability_documents.hpp"
#include "kernel/transfers/transfer.hpp"

#include <cmath>

namespace plumbline {
namespace {

Json real(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json rows(const std::vector<std::vector<double>>& table) {
  Json all = Json::array();
  for (const auto& row : table) {
    Json line = Json::array();
    for (const double x : row) line.push_back(real(x));
    all.push_back(line);
  }
  return all;
}

Json growth(const std::vector<Growth>& found, bool with_waves) {
  Json all = Json::array();
  for (const Growth& g : found) {
    Json entry{{"dt", g.dt}, {"per_step", real(g.per_step)}};
    if (with_waves) entry["wave_number"] = {g.theta[0], g.theta[1]};
    all.push_back(entry);
  }
  return all;
}

Json axis(const Axis& of) { return {{"name", of.key}, {"label", of.label}, {"values", of.values}}; }

}  // namespace

Json to_json(const Configuration& found) {
  const Prediction& p = found.predicted;
  Json document{{"integrator", found.settings.text("integrator")},
                {"scheme", found.scheme},
                {"settings", to_json(found.settings)},
                {"unit", found.unit},
                {"predicted", Json::array()},
                {"closed_form", nullptr},
                {"observed", Json::array()},
                {"always", nullptr},
                {"growth", growth(p.growth, true)}};
  for (const StableInterval& i : p.stable) document["predicted"].push_back({{"low", i.low}, {"high", real(i.high)}});
  if (found.closed_form) {
    document["closed_form"] = real(found.closed_form->limit);
    document["closed_form_source"] = found.closed_form->source;
  }
  if (p.always_stable()) document["always"] = "stable";
  if (p.always_unstable() && found.note.empty()) document["always"] = "unstable";
  if (found.observed) {
    for (const Bracket& b : found.observed->brackets)
      document["observed"].push_back({{"low", b.low}, {"high", b.high}});
    document["observed_growth"] = growth(found.observed->growth, false);
  }
  document["scanned"] = {{"low", found.scan.low}, {"high", found.scan.high}, {"steps", found.scan.steps}};
  document["threshold"] = stable_radius - 1;
  document["differences"] = {{"size", p.differences.size}, {"error", p.differences.error}};
  document["reach"] = p.reach;
  document["degrees_of_freedom"] = p.unknowns;
  document["sampled"] = found.sampled;
  for (const auto& [quantity, order] : found.orders) {
    Json& entry = document["orders"][quantity];
    entry = {{"order", real(order.order)}, {"low", real(order.low)}, {"high", real(order.high)}};
    if (order.theory) entry["theory"] = *order.theory;
  }
  if (!found.note.empty()) document["note"] = found.note;
  return document;
}

Json to_json(const StabilityMap& map) {
  Json document{{"id", map.id},
                {"title", map.plan.title},
                {"kind", map.plan.kind},
                {"scheme", map.plan.scheme},
                {"integrator", map.integrator},
                {"shape", map.shape},
                {"transfer", map.transfer},
                {"unit", map.unit},
                {"x", axis(map.plan.x)},
                {"y", axis(map.plan.y)},
                {"values", rows(map.values)},
                {"observed", Json::array()}};
  if (!map.closed_form.empty()) document["closed_form"] = rows(map.closed_form);
  for (const auto& seen : map.observed) {
    document["observed"].push_back(
        {{"x", real(seen.x)}, {"y", real(seen.y)}, {"low", real(seen.low)}, {"high", real(seen.high)}});
  }
  return document;
}

Json to_json(const SafeStep& safe) {
  Json document{{"integrator", safe.method.integrator},
                {"shape", safe.method.shape},
                {"transfer", transfer_in_words(safe.method.transfer, safe.order)},
                {"ppc", safe.ppc},
                {"limit", real(safe.limit)},
                {"offset", safe.place},
                {"regular", real(safe.regular)},
                {"edge", real(safe.edge)},
                {"edge_depth", safe.edge_depth},
                {"always", nullptr}};
  if (safe.worst() == 0 && safe.regular == 0) document["always"] = "unstable";
  if (std::isinf(safe.worst())) document["always"] = "stable";
  return document;
}

Json to_json(const KnownLimit& row) {
  return {{"problem", row.problem->name()},
          {"choices", row.words()},
          {"unit", row.unit},
          {"limit", real(row.limit)},
          {"endless", std::isinf(row.limit)},
          {"closed_form", row.closed_form ? real(row.closed_form->limit) : Json(nullptr)},
          {"growth", row.no_stable_step() ? real(row.growth.per_step) : Json(nullptr)},
          {"smallest", row.smallest},
          {"note", row.note}};
}

Json to_json(const KnownList& list) {
  Json document{{"integrator", list.integrator.name},
                {"parameters", list.integrator.parameters},
                {"problems", Json::array()},
                {"rows", Json::array()}};
  for (const StabilityProblem* problem : list.problems) document["problems"].push_back(problem->name());
  for (const KnownLimit& row : list.rows) document["rows"].push_back(to_json(row));
  return document;
}

Json to_json(const SmallestKnown& smallest) {
  if (smallest.limit == 0) return nullptr;
  return {{"problem", smallest.problem},
          {"choices", smallest.words},
          {"limit", smallest.limit},
          {"is_this", smallest.is_this}};
}

Json problem_document(const StabilityProblem& problem) {
  const ProblemStatement s = problem.statement();
  return {{"problem", s.name},        {"title", s.title},         {"source", s.source},
          {"statement", s.statement}, {"equations", s.equations}, {"configurations", Json::array()}};
}

}  // namespace plumbline
