// One mass on springs whose exact motion is known, behind the stages of a step: no maps take part.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/integrators/subject.hpp"
#include "reference/spring_oscillator.hpp"

namespace plumbline {

struct OscillatorScene {
  std::string name, what;
  reference::SpringOscillatorProblem problem;
  double end = 3;               // 1/omega
  bool variable_steps = false;  // steps alternate between 1 and 0.7 of a size
};

const std::vector<OscillatorScene>& oscillator_scenes();

// Errors of displacement, velocity and place at the end, in units of the largest displacement and speed at the start. Times
// in 1/omega. Throws as the integrator does.
std::vector<double> oscillator_errors(const Subject& subject, const OscillatorScene& scene, int steps);

}  // namespace plumbline
