#include "kernel/shapes/shape.hpp"

#include <stdexcept>
#include <utility>

#include "kernel/pack.hpp"

namespace plumbline {
namespace {

std::vector<ShapeEntry>& registered() {
  static std::vector<ShapeEntry> all;
  return all;
}

}  // namespace

const std::vector<ShapeEntry>& shapes() { return registered(); }

const ShapeEntry& shape_named(const std::string& name) { return named(registered(), name, ShapeEntry::kind); }

bool shape_offers(const std::string& shape, Trait trait) {
  const ShapeEntry* entry = find_named(registered(), shape);
  return entry && entry->offers.count(trait) > 0;
}

void add_part(ShapeEntry entry) {
  if (!std::apply([](auto... make) { return (make && ...); }, entry.loops))
    throw std::logic_error("shape " + entry.name + " has no loops for one of the geometries");
  if (entry.lanes > lanes) {
    throw std::logic_error("shape " + entry.name + " reads " + std::to_string(entry.lanes) +
                           " numbers side by side where arrays are made for " + std::to_string(lanes) +
                           ": compile it for the instruction set of this program, or an older one");
  }
  add_named(registered(), std::move(entry), ShapeEntry::kind);
}

}  // namespace plumbline
