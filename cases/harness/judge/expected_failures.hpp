// Whose failures the expected ones are: those of York's scheme and figures, of other schemes, or of the default scheme,
// which is the list that a user of the default has to know.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

enum class FailureOf { york, other, standard };
inline constexpr std::array all_failures_of{FailureOf::york, FailureOf::other, FailureOf::standard};

// Spelled as in results: "york1997", "other", "default".
std::string_view name(FailureOf whose);

// York's: a study of the scheme york1997 or of one of his methods (a choice of the scheme whose value begins with "york"), or a
// gate on a published number of a case whose source is York's report. The default's: a study of the scheme `default` whose
// overrides leave every choice of the scheme, and the case's own of the method, as it is. Mesh, step, points per cell and keys of
// the problem are no choices.
// A trial that looks at one scheme says what it is the default but for; any other looks at what its gate's id names:
// york1997, or a shape, transfer or integrator.
FailureOf failure_of(const Case& entry, const StudyPlan& plan, const Gate& gate);

// The same of a gate that was judged; by the name of its scheme alone where its case or study is not registered.
FailureOf failure_of(const JudgedGate& judged);

struct FailureCounts {
  std::array<int, all_failures_of.size()> by_owner{};
  int operator[](FailureOf whose) const { return by_owner[static_cast<std::size_t>(whose)]; }
  int total() const;
};
// Of the gates that failed as expected.
FailureCounts expected_failures(const std::vector<JudgedGate>& gates);

// "63 expected: 37 York's own, 11 of other schemes, 15 of the default"; empty if there is none.
std::string words(const FailureCounts& counts);

}  // namespace plumbline
