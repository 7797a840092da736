// Schemes: every numerical choice by one name. `default` is one definition per kind of scene; no case may change it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/harness/description/settings.hpp"
#include "kernel/scene.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// What a scene consists of; decides which keys exist and which default holds.
enum class Kind { gas, membrane, solid, coupled };

std::string name(Kind kind);
std::vector<std::string> scheme_names();  // default, york1997
std::string scheme_title(const std::string& scheme);
std::string scheme_source(const std::string& scheme);

// The keys that every case of a kind has, with the values of `default`.
std::vector<Key> kind_keys(Kind kind);

// Puts the choices of the settings' kind into the scene: shape, transfer and its order; of solids the contact, with a
// velocity field for each body; of coupled scenes all beside points and step, with the fields that the bodies name.
void apply_choices(const Settings& settings, Scene& scene);

// The values chosen for the parameters of the settings' integrator, by name.
std::map<std::string, double> integrator_parameters(const Settings& settings);

// Throws MissingTraits where an integrator cannot work with the settings' shape and transfer.
void refuse_lacks(const IntegratorEntry& integrator, const Settings& settings);

// What a scheme sets among them; empty for `default`.
std::vector<Override> scheme_choices(const std::string& scheme, Kind kind);

}  // namespace plumbline
