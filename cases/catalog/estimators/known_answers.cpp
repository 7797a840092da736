#include "cases/catalog/estimators/known_answers.hpp"

#include <cmath>
#include <utility>

#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {
namespace {

// |found - exact| over the scale; infinite where one of the two is.
double off(const KnownAnswer& answer) {
  if (answer.found == answer.exact) return 0;
  return std::abs(answer.found - answer.exact) / answer.scale;
}

Findings compared(const KnownAnswers& answers) {
  ProfileColumn number{"number", "1", "number of the answer", {}}, deviations{"deviation", "1", "deviation", {}};
  Findings findings;
  double largest = 0;
  for (const KnownAnswer& answer : answers) {
    findings.measures.push_back(finding(answer.name, off(answer)));
    number.values.push_back(static_cast<double>(number.values.size() + 1));
    deviations.values.push_back(off(answer));
    largest = larger(largest, off(answer));
  }
  findings.measures.push_back(finding("deviation", largest));
  findings.profile.abscissa = "number";
  findings.profile.columns = {std::move(number), std::move(deviations)};
  return findings;
}

}  // namespace

Case known_answers_case(std::string name, const std::vector<KnownTrial>& trials) {
  std::vector<Trial> all;
  std::vector<CaseGate> gates;
  for (const KnownTrial& one : trials) {
    all.push_back({one.name, one.title, one.why, [answers = one.answers] { return compared(answers()); }});
    gates.push_back(gate(std::string(one.name) + "/deviation", value_of("deviation"), at_most(one.tolerance),
                         identity(one.reason)));
  }
  return trial_case(std::move(name), std::move(all), std::move(gates));
}

}  // namespace plumbline
