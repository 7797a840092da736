// York's dog-bone: the quarter of the bag of section 6.2, and the gas in it.
#pragma once

#include "cases/catalog/coupled/membrane.hpp"

namespace plumbline {

// The quarter's unstretched membrane as York's input gives it: 600 points of the volume 0.05^2/6.8207, thickness 0.1. m
inline constexpr double dog_bone_length = 600 * 0.05 * 0.05 / 6.8207 / 0.1;

// The gas's two polygons, together: area 0.47463 m^2. [York A.4.7]
Curve dog_bone_gas();

// A smooth outline from (0.5, 0) to (0, 1), of the length above. York prints neither the polygon nor a formula; this one
// keeps what he does print: the two ends, the smooth shape, and a distance of about 0.07 m from the gas. It is the polygon
// (0.5, 0) (0.5, y) (x, y) (x, 0.79) (0.45, 0.955) (0, 1) with its corners rounded by 0.06 m, y = 0.585 and x such that the
// length is right. segments: straight ones, of equal arcs of that outline.
Curve dog_bone_outline(int segments);

}  // namespace plumbline
