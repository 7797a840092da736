// Schemes: every numerical choice by one name. `default` is one definition per kind of scene; no case may change it.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cases/harness/description/settings.hpp"
#include "kernel/scene.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// What a scene consists of; decides which keys exist and which default holds.
enum class Kind { gas, membrane, solid, coupled };
inline constexpr std::array all_kinds{Kind::gas, Kind::membrane, Kind::solid, Kind::coupled};

std::string name(Kind kind);
std::vector<std::string> scheme_names();  // default, york1997
std::string scheme_title(const std::string& scheme);
std::string scheme_source(const std::string& scheme);

// The keys that every case of a kind has, with the values of `default`.
std::vector<Key> kind_keys(Kind kind);

// Puts the choices of the settings' kind into the scene, whose bodies are there: shape, transfer and its order; of gas all beside
// points and step; of solids the contact, with a velocity field for each body; of coupled scenes both, with the fields that the
// bodies name.
void apply_choices(const Settings& settings, Scene& scene);

// What a registered integrator lets its users choose.
std::vector<Key> integrator_keys(const IntegratorEntry& entry);
// The values chosen for the parameters of the settings' integrator, by name.
std::map<std::string, double> integrator_parameters(const Settings& settings);

// Throws MissingTraits where an integrator cannot work with the settings' shape and transfer.
void refuse_lacks(const IntegratorEntry& integrator, const Settings& settings);

// Their values under a scheme, but for what integrators let their users choose; cases set points and end beside them.
std::vector<Override> scheme_values(const std::string& scheme, Kind kind);

// Those that are others than under `default`.
std::vector<Override> scheme_choices(const std::string& scheme, Kind kind);

}  // namespace plumbline
