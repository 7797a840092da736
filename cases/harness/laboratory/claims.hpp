// What integrators claim (kernel/time_integrator.hpp), as the laboratory reads it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cases/harness/laboratory/step_map.hpp"

namespace plumbline {

// With the values of its parameters. Throws std::invalid_argument for a value out of range.
Claims claims_of(const IntegratorChoice& choice);

// Of a class and a field as OrderClaim has them.
std::optional<double> claimed_order(const Claims& claims, const std::string& of, const std::string& field);

// "2.0000/omega", "no limit", "no stable step".
std::string oscillator_limit_in_words(double limit);

// What is claimed, by the family of gates that judges it: order, stability, energy, invariance. Without what is not claimed.
std::map<std::string, std::string> claims_in_words(const Claims& claims);

}  // namespace plumbline
