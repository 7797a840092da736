// What contact between points promises, on two blocks that meet and part.
#pragma once

#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "kernel/contact/contact.hpp"

namespace plumbline {

// Of a law by pairs of points, which must outlive them.
std::vector<MeasuredGate> pair_gates(const ContactEntry& law);

}  // namespace plumbline
