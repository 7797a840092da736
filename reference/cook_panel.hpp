#pragma once
// Cook's panel: a tapered sheet clamped on one side and sheared on the other, plane strain, small strains (R. D. Cook, J. Struct.
// Div. ASCE 100, 1974, 1851; its nearly incompressible form: J. C. Simo, M. S. Rifai, doi 10.1002/nme.1620290802). By finite elements:
// bilinear with one dilatation an element, on meshes that are finer towards the sides, where stresses are singular or their
// derivatives are; extrapolated from three of them.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Corners (0, 0), (48, 44), (48, 60), (0, 44), m. All positive, 0 <= poisson < 1/2.
struct CookPanelProblem {
  double youngs_modulus = 240.565;  // E, Pa
  double poisson = 0.4999;          // nu
  double load = 100;                // upwards, evenly over the right side, N per metre of thickness
};

struct CookPanel {
  Bounded corner;  // upward displacement of (48, 60), m
  Bounded work;    // of the load: half of it times the mean upward displacement of the right side, J/m
};

/// The bounds are estimates: by how much extrapolations with the order seen and with second order differ. Throws ParameterError with the key of a
/// value out of range.
CookPanel cook_panel(const CookPanelProblem& problem);

/// On one mesh of `elements` by `elements`, 2 to 128, without a bound.
CookPanel cook_panel_on(const CookPanelProblem& problem, int elements);

}  // namespace plumbline::reference
