#include "kernel/shapes/shape.hpp"

#include <utility>

namespace plumbline {
namespace {

std::vector<ShapeEntry>& registered() {
  static std::vector<ShapeEntry> all;
  return all;
}

}  // namespace

const std::vector<ShapeEntry>& shapes() { return registered(); }

const ShapeEntry& shape_named(const std::string& name) { return named(registered(), name, "shape"); }

bool shape_offers(const std::string& shape, Trait trait) {
  const ShapeEntry* entry = find_named(registered(), shape);
  return entry && entry->offers.count(trait) > 0;
}

RegisterShape::RegisterShape(ShapeEntry entry) { add_named(registered(), std::move(entry), "shape"); }

}  // namespace plumbline
