#pragma once
// Two equal elastic bars meet face to face (York, appendix A.1): frictionless faces that press but do not pull. By
// symmetry it is one bar that meets a smooth rigid wall at half the relative speed, and half of that bar; a small
// finite-element code answers it, since no closed solution is known. Tag [Hughes 9.1]: T. J. R. Hughes, The Finite
// Element Method, 1987, chapter 9: bilinear elements, lumped masses, central differences.
//
// Steps are dt = (length of an element)/c, c = sqrt(E/((1 - nu^2) rho)): at this step, the limit of stability, linear
// elements carry plane waves exactly, and the impact *is* a plane wave from the face at first. Elements that are four
// times as high as long keep the other motions inside the limit. What is left of the error is first order, mostly the
// kinetic energy of the half elements at the face, 1/(2 n) of all, that an impact of lumped masses loses.
#include <array>
#include <vector>

#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Two bars of the same size and plane-stress material; forces and masses per thickness. All positive, poisson in
/// [0, 0.45], height at least width/4. Defaults: York's.
struct TwoBarProblem {
  double width = 1.25;  // of each bar, along the impact
  double height = 4.5;
  double youngs_modulus = 1e5;
  double poisson = 0.3;
  double density = 1;
  double speed = 2;  // relative; one bar rests before
};

/// Of a plane wave along a bar, which its height keeps from contracting, m/s.
Bounded plane_wave_speed(const TwoBarProblem& problem);
/// 2 width/c, s: the plane front, which nothing overtakes, is back at the whole face at once with tension.
Bounded plane_contact_duration(const TwoBarProblem& problem);

/// Of a bilinear rectangle of these sides and unit thickness, B^T D B integrated exactly [Hughes 9.1]: forces by
/// displacements, x and y of the corners in turn, anticlockwise from the lower left.
using RectangleStiffness = std::array<std::array<double, 8>, 8>;
RectangleStiffness rectangle_stiffness(const TwoBarProblem& problem, double width, double height);

/// One mesh: `elements` through the width, `aspect` times as high as long (rounded so that they fill the height).
struct TwoBarRun {
  int elements = 0, aspect = 0;
  double step = 0;
  double restitution = 0;           // relative speed of the centres of mass after over before
  double energy_kept = 0;           // total energy after over before, in the frame of the common centre of mass
  double contact_work = 0;          // by the contact forces, in the same unit: 1 + contact_work = energy_kept
  double impulse = 0;               // on one bar, over its momentum before: 1 + restitution
  std::vector<double> time, force;  // total contact force at each step, from 0
};

/// Throws ParameterError for a problem out of range or fewer than 8 elements.
TwoBarRun run_two_bar(const TwoBarProblem& problem, int elements, int aspect = 4);

/// Bounds of what the meshes answer are estimates from their differences, not proofs: three times the largest of the
/// differences between the extrapolated values of two meshes and of two aspects, plus a tenth of what the last
/// halving of the elements changed.
class TwoBar {
 public:
  /// Meshes of `elements`/4, /2 and /1, and the finer two again with another aspect (0.05 s for 80, 0.3 s for 160).
  /// Throws ParameterError.
  explicit TwoBar(const TwoBarProblem& problem = {}, int elements = 80);

  const TwoBarProblem& problem() const { return problem_; }
  const std::vector<TwoBarRun>& runs() const { return runs_; }  // aspect 4, coarsest first
  const TwoBarRun& finest() const { return runs_.back(); }

  Bounded wave_speed() const { return wave_speed_; }
  Bounded restitution() const { return restitution_; }
  /// plane_contact_duration(). The bound covers the finest mesh too where its force lasts longer or less long by more
  /// than two steps.
  Bounded contact_duration() const { return duration_; }
  Bounded peak_force() const { return peak_force_; }  // at first touch: rho c speed/2 times height
  Bounded impulse() const;                            // on one bar: mass speed/2 (1 + restitution)
  Bounded velocity_of_hit_bar() const;                // the one at rest before
  Bounded velocity_of_hitting_bar() const;
  /// Shares of the kinetic energy before, seen from the common centre of mass; they add to 1.
  Bounded translation_share() const;  // restitution^2
  Bounded vibration_share() const;

 private:
  TwoBarProblem problem_;
  std::vector<TwoBarRun> runs_;
  Bounded wave_speed_, restitution_, duration_, peak_force_;
};

}  // namespace plumbline::reference
