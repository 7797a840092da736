// Gates that any time integrator must meet: a row each, whose bound follows from theory and needs nothing from the author.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/integrators/subject.hpp"
#include "cases/harness/judge/measured_gates.hpp"

namespace plumbline {

// Core gates take seconds and are always judged.
enum class Effort { core, whole };

struct IntegratorGate {
  std::string family;       // consistency, order, stability, energy, invariance, jumps, identities
  Gate gate;                // its id begins with the family
  std::string explanation;  // what usually causes a miss
  // The number; throws CannotWork where the integrator cannot be judged so.
  std::function<Measured(const Subject&)> measure;
  Effort effort = Effort::whole;
};

// All rows of an effort (the whole holds the core), claims included, family by family.
std::vector<IntegratorGate> integrator_gates(const Subject& subject, Effort effort);
const std::vector<std::string>& gate_families();

// The rows of each family.
std::vector<IntegratorGate> consistency_gates();
std::vector<IntegratorGate> order_gates(const Subject& subject);
std::vector<IntegratorGate> stability_gates(const Subject& subject);
std::vector<IntegratorGate> energy_gates(const Subject& subject);
std::vector<IntegratorGate> invariance_gates(const Subject& subject);
std::vector<IntegratorGate> jump_gates();
std::vector<IntegratorGate> identity_gates(const Subject& subject);

}  // namespace plumbline
