// What a scene asks of an integrator that does not offer it, as the error of a call.
#pragma once

#include "cases/harness/description/case.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline {

inline MissingTraits cannot_run(const Case& entry, const Settings& settings, const CannotWork& parts) {
  return {"integrator", settings.text("integrator"), "another integrator, or other choices", "case=" + entry.name,
          parts.lacks};
}

}  // namespace plumbline
