// Gates that any contact law must meet, on two bodies that touch and whose nodes move at random.
#pragma once

#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "kernel/contact/contact.hpp"

namespace plumbline {

inline constexpr double least_slowed = 1e-6;  // of the approach speed, what contact has to take at least

// In each number of dimensions that the law is made for.
std::vector<MeasuredGate> contact_gates(const ContactEntry& law);

}  // namespace plumbline
