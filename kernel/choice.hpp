// Parts of a scheme that are chosen by name. Each registers itself where it is defined.
#pragma once

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kernel/traits.hpp"

namespace plumbline {

// `needs`: what a part wants of an integrator; `offers`: what an integrator may want of it.
struct Choice {
  std::string name, title, source;
  Traits offers = {}, needs = {};
};

// Why a part cannot be called so; empty if it can. Allowed are 1 to 63 characters of a-z, 0-9, `.`, `_` and `-`, the first a
// letter or a digit: names become parts of the names of files and of keys.
std::string name_refusal(const std::string& name);

// The entry of that name, nullptr if there is none.
template <class Entry>
const Entry* find_named(const std::vector<Entry>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// The same; throws std::invalid_argument that names the kind of part where there is none.
template <class Entry>
const Entry& named(const std::vector<Entry>& all, const std::string& name, const std::string& kind) {
  if (const Entry* entry = find_named(all, name)) return *entry;
  throw std::invalid_argument("no " + kind + " " + name);
}

// Takes an entry in, in the order of names. Throws std::logic_error for a name that is taken or malformed.
template <class Entry>
void add_named(std::vector<Entry>& all, Entry entry, const std::string& kind) {
  if (find_named(all, entry.name)) throw std::logic_error(kind + " " + entry.name + " is registered twice");
  if (const std::string why = name_refusal(entry.name); !why.empty()) {
    throw std::logic_error(kind + " '" + entry.name + "': " + why);
  }
  const auto place = std::upper_bound(all.begin(), all.end(), entry,
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  all.insert(place, std::move(entry));
}

// A part that is to be registered, and what does it, as add_named() would.
struct CollectedPart {
  std::string kind, name, title, source;  // kind: "shape"
  std::function<void()> add;
};

// Calls `load` and returns what was handed to register_or_collect() meanwhile, unchecked and in its order, and registers nothing:
// where a shared library is loaded, an exception would end the program. Not for several threads at once.
std::vector<CollectedPart> collect_parts(const std::function<void()>& load);

// Calls part.add, unless parts are collected.
void register_or_collect(CollectedPart part);

}  // namespace plumbline
