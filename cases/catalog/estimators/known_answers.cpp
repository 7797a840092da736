#include "cases/catalog/estimators/known_answers.hpp"

#include <cmath>
#include <utility>

#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {
namespace {

// Over the scale.
double deviation(const KnownAnswer& answer) { return std::abs(answer.found - answer.exact) / answer.scale; }

// Of answers that are off by more than the tolerance each is a measure of its own.
Findings compared(const KnownAnswers& answers, double tolerance) {
  ProfileColumn number{"number", "1", "number of the answer", {}}, found{"found", "1", "found", {}},
      exact{"exact", "1", "closed form", {}}, deviations{"deviation", "1", "deviation", {}};
  Findings findings;
  double largest = 0;
  for (const KnownAnswer& answer : answers) {
    const double off = deviation(answer);
    number.values.push_back(static_cast<double>(number.values.size() + 1));
    found.values.push_back(answer.found);
    exact.values.push_back(answer.exact);
    deviations.values.push_back(off);
    largest = larger(largest, off);
    if (!(off <= tolerance))
      findings.measures.push_back(scalar_measure(answer.name, answer.found, answer.exact, 0, "1"));
  }
  findings.measures.push_back(finding("deviation", largest));
  findings.measures.push_back(finding("answers", static_cast<double>(answers.size())));
  findings.profile.abscissa = "number";
  findings.profile.columns = {std::move(number), std::move(found), std::move(exact), std::move(deviations)};
  return findings;
}

}  // namespace

Case known_answers_case(std::string name, const std::vector<KnownTrial>& trials) {
  std::vector<Trial> all;
  std::vector<CaseGate> gates;
  for (const KnownTrial& one : trials) {
    all.push_back({one.name, one.title, one.why, [one] { return compared(one.answers(), one.tolerance); }});
    gates.push_back(gate(std::string(one.name) + "/deviation", value_of("deviation"), at_most(one.tolerance),
                         identity(one.reason)));
  }
  return trial_case(std::move(name), std::move(all), std::move(gates));
}

}  // namespace plumbline
