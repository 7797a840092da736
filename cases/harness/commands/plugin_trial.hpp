// A plug-in tried in a process of its own, before it is let into this one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernel/choice.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {

// Integrators whose first steps ended the process, or did not end: what each did, by its name.
using Refusals = std::map<std::string, std::string>;

// What a library registers.
struct PluginEntries {
  std::vector<IntegratorEntry> integrators;
  std::vector<CollectedPart> parts;  // all else
};

// Loads the library in a child process and adds its parts there; makes and copies each integrator, asks what it has to say of itself
// and lets it take the steps that tell its traits. Whatever the library does there leaves this process as it is. Throws FileError where it
// cannot be loaded, registers nothing, or entries that find_fault() does not pass; where loading or one of those calls, other than a
// step, ends the process, throws, or takes longer than `limit` (s); and Interrupted.
Refusals try_plugin(const std::string& path, const std::string& file, double limit);

// Loads the library, its symbols for itself alone, and returns what it was to register. Throws FileError.
PluginEntries load_entries(const std::string& path, const std::string& file);

// What is wrong with what a plug-in registers: a name that is taken or malformed, texts that are no UTF-8, no make or copy.
// Empty: nothing.
std::string find_fault(const PluginEntries& entries);

}  // namespace plumbline
