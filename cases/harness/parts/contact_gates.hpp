// Gates that any contact law must meet, on two bodies that touch and whose nodes move at random.
#pragma once

#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "kernel/contact/contact.hpp"

namespace plumbline {

// In each number of dimensions that the law is made for.
std::vector<MeasuredGate> contact_gates(const ContactEntry& law);

}  // namespace plumbline
