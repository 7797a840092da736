// How York's code knew a string's strain before it kept the total along the tangent. [York section 5.4.2]
#pragma once

#include "kernel/points/body.hpp"

namespace plumbline {

// The body's points, of a UniaxialMembrane in the plane, sum their stress in the global frame instead: each increment of
// tangential strain is rotated there once, with the tangent of its step, and stays as the string turns. It is wrong, and is
// there to show what that does.
void rotate_increments_once(Body& body);

}  // namespace plumbline
