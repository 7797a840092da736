// The key `material` of cases whose solid may obey another law than theirs.
#pragma once

#include <memory>

#include "cases/harness/description/settings.hpp"
#include "kernel/materials/material.hpp"

namespace plumbline {

// "own", or any material that has the parameters youngs_modulus and density, is no chain and does not dissipate; finite: whose
// points carry their deformation gradient.
Key material_key(bool finite);

// The law that the settings choose, with the parameters of `own` that it has by the same name; others keep their defaults.
std::shared_ptr<const Material> chosen_material(const Settings& settings, std::shared_ptr<const Material> own);

}  // namespace plumbline
