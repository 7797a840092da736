// A simulation at one instant, as numbers by name.
#pragma once

#include <string>

#include "cases/harness/description/archive.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

// Writes the state, or puts a simulation of the same scene, integrator and step control into the state that was written: it
// goes on to the same bits. Of the integrator that is what it names: parameters(), memory() and kept(). Throws ArchiveError
// if the state cannot be one of this scene.
void archive_simulation(Archive& archive, Simulation& simulation, const std::string& integrator);

}  // namespace plumbline
