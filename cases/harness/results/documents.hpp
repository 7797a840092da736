// Results as JSON, in the shapes of schema/plumbline.schema.json. Numbers that are not finite are null.
#pragma once

#include <vector>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/results/provenance.hpp"

namespace plumbline {

Json to_json(const Value& value);
Json to_json(const Settings& settings);
Json to_json(const Provenance& provenance);
Json to_json(const JudgedGate& gate);
Json to_json(const std::vector<JudgedGate>& gates);
Json to_json(const std::vector<NotApplicable>& all);
Json to_json(const Ledger& ledger, int dim, bool axisymmetric = false);
Json to_json(const std::vector<Measure>& measures);
Json to_json(const OrderFit& fit);

// The settings that differ from those of the scheme at so many cells: what --set needs beside --scheme and --cells. None
// where `scheme` is the name of another program.
Json choices(const Case& entry, const std::string& scheme, const Settings& settings);

// One run with the gates judged on it.
Json run_document(const RunResult& run, const std::vector<JudgedGate>& gates, const Provenance& provenance);

// One study: an entry of "studies".
Json study_document(const StudyResult& study, const std::vector<JudgedGate>& gates, const Provenance& provenance);

// Counts of verdicts by name.
Json counts_document(const std::vector<JudgedGate>& gates);

// What the report says of a case: statement, parameters, studies, gates with reasons.
Json catalog_entry(const Case& entry);

Json error_document(const UsageError& error);
Json error_document(const std::string& key, const std::string& message);

std::vector<Verdict> verdicts(const std::vector<JudgedGate>& gates);

}  // namespace plumbline
