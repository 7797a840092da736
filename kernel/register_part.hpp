// Registers a shape, transfer, contact law or material where it is defined, in the tree or in a plug-in. Included by the files that
// define such a part and by no header that others include: the stamp changes with every header that a part may see.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kernel/choice.hpp"
#include "kernel/part_header_hash.hpp"  // made by the build: PLUMBLINE_PART_HEADERS
#include "kernel/plugin_stamp.hpp"

namespace plumbline {

// Of the file that includes this, one in each object that registers a part: hence `static`.
[[gnu::section(PLUMBLINE_STAMP_SECTION)]] static constexpr PluginStamp part_stamp_of_this_file = plugin_stamp(
    "parts", PLUMBLINE_PART_HEADERS,
    {sizeof(std::size_t), sizeof(std::string), sizeof(std::vector<double>), sizeof(std::function<void()>),
     sizeof(Choice), sizeof(CollectedPart), alignof(CollectedPart)});

// What the kernel's own parts were built against.
const PluginStamp& part_stamp();

// Throws std::logic_error for any other.
void want_part_stamp(const PluginStamp& built_against);

// Entry: ShapeEntry, TransferEntry, ContactEntry or MaterialEntry. Registers at start, or when a plug-in is loaded. A name that is
// taken already or malformed, what is incomplete, or a stamp other than the kernel's throws std::logic_error, but for what is
// registered under collect_parts().
template <class Entry>
struct RegisterPart {
  explicit RegisterPart(Entry entry, const PluginStamp& built_against = part_stamp_of_this_file) {
    register_or_collect({Entry::kind, entry.name, entry.title, entry.source, [entry, built_against] {
                           want_part_stamp(built_against);
                           add_part(entry);
                         }});
  }
};

}  // namespace plumbline
