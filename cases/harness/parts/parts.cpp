#include "cases/harness/parts/parts.hpp"

#include <algorithm>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/parts/contact_gates.hpp"
#include "cases/harness/parts/material_gates.hpp"
#include "cases/harness/parts/shape_gates.hpp"
#include "cases/harness/parts/transfer_gates.hpp"

namespace plumbline {
namespace {

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& all) {
  std::vector<std::string> names;
  for (const Entry& entry : all) names.push_back(entry.name);
  return names;
}

void want_name(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) throw unknown_name(what, name, known);
}

bool is_red(const JudgedGate& gate) {
  const std::vector<Verdict> one{gate.judgement.verdict};
  return exit_status(one, false) != 0;
}

}  // namespace

const std::vector<PartKind>& part_kinds() {
  static const std::vector<PartKind> all{
      {"shape", [] { return names_of(shapes()); },
       [](const std::string& name, const std::string&) { return shape_gates(shape_named(name)); }},
      {"transfer", [] { return names_of(transfers()); },
       [](const std::string& name, const std::string& shape) {
         return transfer_gates(transfer_named(name), shape_named(shape));
       }},
      {"material", [] { return names_of(materials()); },
       [](const std::string& name, const std::string&) { return material_gates(material_named(name)); }},
      {"contact", [] { return names_of(contacts()); },
       [](const std::string& name, const std::string&) { return contact_gates(named(contacts(), name, "contact")); }}};
  return all;
}

JudgedPart judge_part(const PartKind& kind, const std::string& name, const PartJudging& how) {
  want_name(kind.name, name, kind.names());
  want_name("shape", how.shape, names_of(shapes()));
  const std::vector<MeasuredGate> rows = kind.gates(name, how.shape);
  JudgedPart found;
  found.declared = static_cast<int>(rows.size());
  for (GateOutcome& outcome :
       judge_side_by_side(kind.name, name, rows, {how.threads, how.until_red, is_red, {}, how.progress})) {
    if (outcome.judged) found.gates.push_back(std::move(*outcome.judged));
    if (outcome.not_applicable) found.not_applicable.push_back(std::move(*outcome.not_applicable));
  }
  return found;
}

}  // namespace plumbline
