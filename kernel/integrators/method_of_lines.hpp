// Integrators that see the semi-discrete equations alone: a state, and its rate of change.
#pragma once

#include "kernel/time_integrator.hpp"

namespace plumbline {

class MethodOfLines : public TimeIntegrator {
 public:
  std::string refusal(const std::string& /*shape*/, const std::string& transfer) const override {
    if (transfer == "flip") return {};
    return "rates of change want the transfer flip: other transfers filter velocities once a step";
  }
  bool evaluates_stress_first() const override { return true; }
};

}  // namespace plumbline
