// What gas cases have in common: York's choices for a case of his kind, and gates.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// York's own points and step for a gas that he did not run: three points a cell, and the Courant number of his Sod run,
// dt = 1e-4 s at h = 0.01 m with c + |u| up to 2.1 m/s. [York 4.1]
extern const std::vector<Override> york_points;
Override york_step(const Settings& settings);

// Case::problem of the flow that follows from the settings.
std::function<std::unique_ptr<Problem>(const Settings&)> gas_run(std::function<GasFlow(const Settings&)> flow_of);

// The same flow with its mirror image in the place of the wall at the lower end of the axis, judged above it alone: what
// walls reflect - states, densities, slopes - must be what the gas beyond them would be.
GasFlow with_mirror_image(GasFlow flow);

// The gates of a study in which a field's error falls: the estimate at least `order`, the low end of
// its interval at least 0.1 below that.
std::vector<CaseGate> required_order(const std::string& study, const std::string& measure, double order,
                                     const std::string& reason);
// Energy closes to rounding; the points fill their space.
CaseGate energy_gate(const std::string& study);
CaseGate coverage_gate(const std::string& study, double level);

// That two runs of one flow have the same numbers at a level: the largest relative difference of the norms of the
// errors in density, velocity, pressure and energy.
CaseGate same_numbers_gate(const std::string& study, const std::string& as, double level);

// That a run of with_mirror_image() has the numbers of the one with the wall: differences over the
// larger of a field's norm and its error's.
CaseGate mirror_gate(const std::string& study, const std::string& as, double level);

// The error of a measure at a level. Throws std::runtime_error where there is none.
double error_in(const StudyResult& study, const std::string& measure, double level);
// The same over that of another study of the case at the same level. `named`: that study in words.
Number error_over(const std::string& measure, const std::string& other, const std::string& named, double level);

}  // namespace plumbline
