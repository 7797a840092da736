// The same scene, the same maps and the same steps under two integrators: what is filtered or mapped once a step cancels, and
// their difference vanishes with the step for every consistent scheme of any order. Blind to errors in space.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/integrators/extrapolation.hpp"
#include "cases/harness/integrators/small_scenes.hpp"
#include "cases/harness/integrators/subject.hpp"

namespace plumbline {

// Positions (as distances from where the points started) and velocities of all points of all bodies by their numbers, at the
// scene's end after so many steps (pairs of steps where they alternate). Throws as Simulation does.
std::vector<double> state_at_end(const SmallScene& small, Scene scene, const IntegratorChoice& integrator, int steps);

// The same of any scene: a column's components of all points of all bodies by their numbers.
std::vector<double> column_by_number(const Scene& scene, const ColumnId& id);

// The integrator that another is compared with under a transfer: one whose own consistency is proven on exact solutions, and
// never itself. Of methods that return losses the other one that does, where a gas would take them as heat.
IntegratorChoice yardstick(const Subject& subject, const Scene& scene);

// Difference of the integrator, in so many steps, and its yardstick, in units of the largest distance and speed. Where the
// transfer filters, the yardstick's steps are as many as the integrator's maps: both are filtered equally often.
std::vector<double> difference_at(const Subject& subject, const SmallScene& small, int steps);

}  // namespace plumbline
