// What the laboratory found, as JSON in the shapes of schema/plumbline.schema.json.
#pragma once

#include "cases/harness/laboratory/known_limits.hpp"
#include "cases/harness/laboratory/safe_step.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {

Json to_json(const Configuration& found);
Json to_json(const StabilityMap& map);
Json to_json(const SafeStep& safe);
Json to_json(const KnownLimit& row);
Json to_json(const KnownList& list);
Json to_json(const SmallestKnown& smallest);  // null where there is none

// Name, title, source, statement and equations of a problem, with its configurations to be filled in.
Json problem_document(const StabilityProblem& problem);

}  // namespace plumbline
