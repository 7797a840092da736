// The twisted annulus: its keys, its points where the exact solution has them, and what it is measured by.
#pragma once

#include <vector>

#include "cases/catalog/membrane/surface_case.hpp"
#include "reference/twisted_annulus.hpp"

namespace plumbline {

// One struct for points and reference. Times are in outer radii over the speed of waves at rest.
struct TwistedAnnulus : SurfaceCase {
  double inner, twist, drag, end, rows;

  explicit TwistedAnnulus(Parameters given = {});

  double inner_radius() const { return inner * size; }
  // UsageError "twist" or "poissons_ratio" where it would not be wrinkled everywhere.
  reference::TwistedAnnulus exact() const;
};

// Where a point was at rest: its ring, counted from the inner rim, and the angle from x.
struct Seat {
  int ring;
  double angle;
};

// Points in rings of equal width at rest, as many in each and on the same radii: each point of a ring has the same neighbours, and the
// image of each is the point's own reflection at the place on the rim of its radius. Reflected there, small parts of the ring and of
// its images are each other, and a uniform stress leaves no force on the points before the rim.
class TwistedRing {
 public:
  // So many spacings to the outer radius.
  TwistedRing(const TwistedAnnulus& at, double spacings);

  const reference::TwistedAnnulus& exact() const { return exact_; }
  double radius(int ring) const { return inner_ + (ring + 0.5) * wide_; }  // at rest, m
  const reference::AnnulusPoint& exact_at(int ring) const { return rings_[static_cast<std::size_t>(ring)]; }

  std::vector<SurfacePoint> points() const;
  // Of a point that stands as at the start.
  Seat seat(const Columns& points, int p) const;
  // Behind both rims, of as many rings.
  std::vector<OddImage> images(const Columns& points, double rows) const;

 private:
  double inner_, outer_, twist_, wide_;
  int count_;  // points of a ring
  reference::TwistedAnnulus exact_;
  std::vector<reference::AnnulusPoint> rings_;
};

// Of the nominal stress, Pa: the larger principal one of S_ab.
double largest_stress(const Columns& points, int p, const SurfaceLaw& law);

struct RingForces {
  double torque;  // mean over the radii of that through a ring of material, over the exact one
  double energy;  // over the exact one
  double uneven;  // torque through the rings, root mean square of what it is off their mean, over the exact one
  double
      crooked;  // distance from the axis of the lines along the larger principal stress, root mean square error, over the exact one
  double across;  // root mean square of the smaller principal stress, over that of the exact stress
};

// ring: of each point.
RingForces ring_forces(const Columns& points, const std::vector<int>& ring, const SurfaceLaw& law,
                       const TwistedRing& exact);

}  // namespace plumbline
