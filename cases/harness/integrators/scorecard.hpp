// What is known of an integrator on one page: its gates by family, claims, limits, error against cost, beside another's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/integrators/judge.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {

// The integrator's own half, as JSON documents have it (definition `scorecard_half` of the schema): sentence, verdict, claimed
// and measured by family, limits with the smallest first. What judging has found before is not found again. Costs are added
// by add_costs.
Json scorecard_half(const Subject& subject, const JudgedIntegrator& judged, const JudgingOptions& options);

// Error against cost of both, timed in turns; into each half.
void add_costs(const Subject& mine, Json& my_half, const Subject& other, Json& other_half);

// Both halves in one: mine, with `against` (null for none), the factors of cost and what to do next.
Json scorecard(Json mine, const Json& against, const JudgedIntegrator& judged);

// For people: lines of at most 150 characters.
std::vector<std::string> scorecard_lines(const Json& scorecard);

// The integrator that another is set beside where none is named: that of the default scheme of solids, or York's.
std::string usual_opponent(const std::string& integrator);

}  // namespace plumbline
