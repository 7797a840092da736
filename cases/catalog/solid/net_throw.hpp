// A rigid ball thrown back by a taut net without mass and friction.
#pragma once

namespace plumbline {

// The net is a straight line between two supports, unstretched; the ball, a disk, meets it in the middle at right
// angles. Lengths in m; mass in kg and stiffness E A in N, both per depth.
struct NetBall {
  double radius = 0, mass = 0, speed = 0;  // > 0
  double length = 0;                       // between the supports, > 2 radius
  double stiffness = 0;                    // tension over strain, > 0
};

struct NetThrow {
  double duration = 0;  // from touch to leaving, s
  double deepest = 0;   // how far the net's middle is pushed, m
  double force = 0;     // at the deepest place, N
};

// Net length with its middle pushed by `depth`: two tangents and the arc between them.
double net_length(const NetBall& ball, double depth);
// Force on the ball, N.
double net_force(const NetBall& ball, double depth);
// The motion conserves energy, so the depth is where the net's energy is that of the ball at the start, and the time
// the integral of dx / v, its singular end taken out by x = depth sin. Errors below 1e-9.
NetThrow throw_of_net(const NetBall& ball);

}  // namespace plumbline
