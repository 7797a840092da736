#include "cases/harness/description/case_gate.hpp"

#include <utility>

namespace plumbline {

CaseGate CaseGate::on(std::string other_study) && {
  study = std::move(other_study);
  return std::move(*this);
}

CaseGate CaseGate::beside(std::vector<std::string> studies) && {
  also = std::move(studies);
  return std::move(*this);
}

CaseGate CaseGate::in(Tier lowest) && {
  tier = lowest;
  return std::move(*this);
}

CaseGate CaseGate::fails(std::string cause, Range band, std::string measured_on) && {
  gate.expected_failure = ExpectedFailure{std::move(cause), band, {}, std::move(measured_on)};
  return std::move(*this);
}

CaseGate CaseGate::or_stops(StopBand band) && {
  gate.expected_failure->stops = std::move(band);
  return std::move(*this);
}

}  // namespace plumbline
