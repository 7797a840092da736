#include "cases/harness/integrators/scorecard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/harness/integrators/cost.hpp"
#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/laboratory/claims.hpp"
#include "cases/harness/laboratory/known_limits.hpp"
#include "cases/harness/laboratory/stability_documents.hpp"

namespace plumbline {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

const JudgedGate* find(const JudgedIntegrator& judged, const std::string& id) {
  for (const JudgedGate& gate : judged.gates) {
    if (gate.gate.id == id) return &gate;
  }
  return nullptr;
}

std::vector<const JudgedGate*> of_family(const JudgedIntegrator& judged, const std::string& family) {
  std::vector<const JudgedGate*> all;
  for (const JudgedGate& gate : judged.gates) {
    if (gate.study == family) all.push_back(&gate);
  }
  return all;
}

Verdict verdict_of(const std::vector<const JudgedGate*>& gates) {
  std::vector<Verdict> all;
  for (const JudgedGate* gate : gates) all.push_back(gate->judgement.verdict);
  return overall(all);
}

std::string order_text(const JudgedIntegrator& judged, const std::string& field) {
  const JudgedGate* gate = find(judged, "order/oscillator/" + field);
  return gate && gate->measured.value ? fmt::format("{:.3f}", *gate->measured.value) : "n/a";
}

// The integer that an order with its interval supports: the largest that is not above it by more than a tenth.
std::string supported_order(const JudgedIntegrator& judged) {
  const JudgedGate* gate = find(judged, "order/oscillator/displacement");
  if (!gate || !gate->measured.interval) return "unknown";
  return fmt::format("{}", std::max(0, static_cast<int>(std::floor(gate->measured.interval->first + 0.1))));
}

std::string energy_text(const JudgedIntegrator& judged) {
  const JudgedGate* gate = find(judged, "energy/oscillator/growth");
  if (!gate || !gate->measured.value) return "unknown";
  const double growth = *gate->measured.value;
  return growth > 1 ? "growing" : growth < -1 ? "decaying" : "bounded";
}

std::string measured_text(const std::string& family, const Subject& subject, const JudgedIntegrator& judged) {
  const auto gates = of_family(judged, family);
  if (family == "order") {
    return fmt::format("displacement {}, velocity {}", order_text(judged, "displacement"),
                       order_text(judged, "velocity"));
  }
  if (family == "stability")
    return fmt::format("{} on the oscillator", oscillator_limit_in_words(limit_on_oscillator(subject)));
  if (family == "energy") return energy_text(judged);
  if (family == "consistency") {
    double largest = 0;
    for (const JudgedGate* gate : gates) largest = std::max(largest, gate->measured.value.value_or(0));
    return fmt::format("at most {:.1e} left for dt -> 0", largest);
  }
  const auto met = std::count_if(gates.begin(), gates.end(), [](const JudgedGate* gate) { return !is_red(*gate); });
  return gates.empty() ? "not judged" : fmt::format("{} of {} gates met", met, gates.size());
}

std::string sentence(const Subject& subject, const JudgedIntegrator& judged) {
  const Verdict consistent = verdict_of(of_family(judged, "consistency"));
  const std::string first = consistent == Verdict::pass || consistent == Verdict::xfail ? "consistent"
                            : consistent == Verdict::inconclusive ? "consistent as far as can be told"
                                                                  : "not consistent";
  const double limit = limit_on_oscillator(subject);
  const std::string step = std::isinf(limit) ? "stable at every step"
                           : limit > 0       ? fmt::format("stable up to {:.4f}/omega", limit)
                                             : "without a stable step";
  return fmt::format("{}: {}, of order {} (displacement {}, velocity {}), {} on an oscillator, energy {}.",
                     subject.name(), first, supported_order(judged), order_text(judged, "displacement"),
                     order_text(judged, "velocity"), step, energy_text(judged));
}

Json family_rows(const Subject& subject, const JudgedIntegrator& judged) {
  Json rows = Json::array();
  const std::map<std::string, std::string> claims = claims_in_words(subject.claims());
  for (const std::string& family : gate_families()) {
    const auto gates = of_family(judged, family);
    Json red = Json::array();
    for (const JudgedGate* gate : gates) {
      if (is_red(*gate)) red.push_back(gate->gate.id);
    }
    const auto claimed = claims.find(family);
    rows.push_back({{"family", family},
                    {"claimed", claimed == claims.end() ? Json(nullptr) : Json(claimed->second)},
                    {"measured", gates.empty() ? "not judged" : measured_text(family, subject, judged)},
                    {"verdict", name(verdict_of(gates))},
                    {"gates", gates.size()},
                    {"red", red}});
  }
  return rows;
}

Json limit_rows(const Subject& subject, const JudgingOptions& options) {
  constexpr std::array quick{"oscillator", "bar", "bar-edge"};  // of the core set
  const bool whole = options.effort == Effort::whole, far = whole && reaches_far(subject.choice());
  std::vector<const StabilityProblem*> problems;
  for (const StabilityProblem* problem : stability_problems()) {
    const bool is_quick = std::find(quick.begin(), quick.end(), problem->name()) != quick.end();
    if (is_quick || (whole && (!far || problem->quickly_listed(false)))) problems.push_back(problem);
  }
  Json rows = Json::array();
  for (const KnownLimit& row : limits_of(subject.choice(), options.threads, problems)) {
    rows.push_back(to_json(row));
  }
  return rows;
}

Json curve_document(const CostCurve& curve) {
  Json levels = Json::array();
  for (const CostLevel& level : curve.levels) {
    levels.push_back({{"cells", level.cells},
                      {"error", number(level.error)},
                      {"particle_steps", level.particle_steps},
                      {"wall_s", level.wall_s}});
  }
  return {{"case", curve.case_name}, {"measure", curve.measure}, {"levels", levels}, {"note", curve.note}};
}

CostCurve curve_from(const Json& document) {
  CostCurve curve{document.at("case"), document.at("measure"), {}, document.at("note")};
  for (const Json& level : document.at("levels")) {
    curve.levels.push_back({level.at("cells"), level.at("error"), level.at("particle_steps"), level.at("wall_s")});
  }
  return curve;
}

Json factor_document(const CostFactor& factor) {
  return {{"case", factor.case_name},
          {"factor", factor.factor ? number(*factor.factor) : Json(nullptr)},
          {"low", factor.factor ? number(factor.low) : Json(nullptr)},
          {"high", factor.factor ? number(factor.high) : Json(nullptr)},
          {"note", factor.note}};
}

std::string factor_text(const Json& factor) {
  if (factor.at("factor").is_null()) return "n/a: " + factor.at("note").get<std::string>();
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", factor.at("factor").get<double>(), factor.at("low").get<double>(),
                     factor.at("high").get<double>());
}

}  // namespace

std::string usual_opponent(const std::string& integrator) { return integrator == "midpoint" ? "musl" : "midpoint"; }

Json scorecard_half(const Subject& subject, const JudgedIntegrator& judged, const JudgingOptions& options) {
  std::vector<Verdict> verdicts;
  for (const JudgedGate& gate : judged.gates) verdicts.push_back(gate.judgement.verdict);
  Json needs = Json::array();
  for (const Trait trait : subject.traits().needs) needs.push_back(name(trait));
  Json offers = Json::array();
  for (const Trait trait : subject.traits().offers) offers.push_back(name(trait));
  return {{"integrator", subject.name()},
          {"title", subject.entry().title},
          {"source", subject.entry().source},
          {"parameters", subject.choice().parameters},
          {"effort", options.effort == Effort::core ? "core" : "whole"},
          {"sentence", sentence(subject, judged)},
          {"verdict", name(overall(verdicts))},
          {"needs", needs},
          {"offers", offers},
          {"families", family_rows(subject, judged)},
          {"limits", limit_rows(subject, options)},
          {"cost", Json::array()}};
}

void add_costs(const Subject& mine, Json& my_half, const Subject& other, Json& other_half) {
  const auto curves = cost_curves({&mine, &other});
  for (const CostCurve& curve : curves[0]) my_half["cost"].push_back(curve_document(curve));
  for (const CostCurve& curve : curves[1]) other_half["cost"].push_back(curve_document(curve));
}

Json scorecard(Json mine, const Json& against, const JudgedIntegrator& judged) {
  Json card = std::move(mine);
  std::vector<CostFactor> factors;
  card["factors"] = Json::array();
  card["against"] = against;
  for (const Json& own : card["cost"]) {
    if (against.is_null()) break;
    for (const Json& theirs : against.at("cost")) {
      if (theirs.at("case") != own.at("case")) continue;
      factors.push_back(cost_factor(curve_from(own), curve_from(theirs)));
      card["factors"].push_back(factor_document(factors.back()));
    }
  }
  const auto median = median_of(factors);
  card["factor"] = median ? factor_document(*median) : Json(nullptr);
  card["next"] = nullptr;
  for (const JudgedGate& gate : judged.gates) {
    if (gate.explanation.empty()) continue;
    card["next"] = gate.gate.id + ": " + gate.explanation;
    break;
  }
  return card;
}

std::vector<std::string> scorecard_lines(const Json& card) {
  const auto text = [](const Json& value) { return value.is_null() ? std::string("-") : value.get<std::string>(); };
  const Json& against = card.at("against");
  std::vector<std::string> lines{"", card.at("sentence")};
  lines.push_back(fmt::format("  {:12} {:12} {:38} {:36} {}", "gates", "verdict", "claimed", "measured",
                              against.is_null() ? "" : text(against.at("integrator"))));
  for (std::size_t k = 0; k < card.at("families").size(); ++k) {
    const Json& row = card.at("families")[k];
    lines.push_back(fmt::format("  {:12} {:12} {:38} {:36} {}", text(row.at("family")), text(row.at("verdict")),
                                text(row.at("claimed")), text(row.at("measured")),
                                against.is_null() ? "" : text(against.at("families")[k].at("measured"))));
  }
  lines.push_back("  largest stable steps, the smallest first:");
  for (const Json& row : card.at("limits")) {
    const std::string limit = row.at("endless").get<bool>() ? "no limit"
                              : row.at("limit").is_null()   ? "n/a: " + text(row.at("note"))
                              : row.at("limit").get<double>() == 0
                                  ? "no stable step"
                                  : fmt::format("{:.6g} {}", row.at("limit").get<double>(), text(row.at("unit")));
    lines.push_back(fmt::format("    {:16} {} {}{}", text(row.at("problem")), limit, text(row.at("choices")),
                                row.at("smallest").get<bool>() ? "  (the smallest of these)" : ""));
  }
  if (!card.at("factors").empty()) {
    lines.push_back(fmt::format("  cost at equal error over that of {} (least, most of repeated timings):",
                                text(against.at("integrator"))));
    for (const Json& row : card.at("factors"))
      lines.push_back(fmt::format("    {:16} {}", text(row.at("case")), factor_text(row)));
    if (!card.at("factor").is_null())
      lines.push_back(fmt::format("    {:16} {}", "median", factor_text(card.at("factor"))));
  }
  if (!card.at("next").is_null()) lines.push_back("  next: " + text(card.at("next")));
  return lines;
}

}  // namespace plumbline
