// All parts of the step. Included only by the files that instantiate it, one a geometry.
#pragma once

#include "kernel/engine/method_of_lines.hpp"
#include "kernel/engine/set_up.hpp"
#include "kernel/engine/strain.hpp"
#include "kernel/engine/survey.hpp"
#include "kernel/engine/to_grid.hpp"
#include "kernel/engine/to_points.hpp"

namespace plumbline {

template <class Geometry>
std::unique_ptr<Engine> make_engine_of(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  return std::make_unique<Mechanics<Geometry>>(scene, ledger, options);
}

}  // namespace plumbline
