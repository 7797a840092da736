// How much one step lets the worst state grow, on the problems that every integrator can step.
#pragma once

#include <functional>
#include <vector>

#include "cases/harness/integrators/subject.hpp"
#include "cases/harness/laboratory/limits.hpp"

namespace plumbline {

// Limits of York's step, with which steps are compared: of the oscillator 1/omega, of a bar with a point in the middle of
// each cell and linear shapes h/c.
inline constexpr double limit_of_york = 2;

// At limit_of_york / 2, 4, ... 32, the smallest last: the logarithm of the spectral radius of one step.
struct SmallSteps {
  std::vector<double> dt, growth;
  double power = 0;  // of dt with which the growth at the two smallest steps falls; 0 where it is rounding
};
// Of a step whose spectral radius is known.
SmallSteps small_steps(const std::function<double(double dt)>& radius);
SmallSteps small_steps_on_oscillator(const Subject& subject);
// An infinite bar, positions held; under FLIP where the integrator can work with it. Throws CannotWork.
SmallSteps small_steps_on_bar(const Subject& subject);

// The same bar's largest stable step, h/c, at most York's; 0: none is. Throws CannotWork.
double limit_on_bar(const Subject& subject);

// The first step beyond which not all smaller ones are stable, 1/omega; 0: none is; infinite: no limit was found.
double limit_on_oscillator(const Subject& subject);

}  // namespace plumbline
