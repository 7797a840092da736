#include "kernel/materials/material_entry.hpp"

#include "kernel/choice.hpp"

namespace plumbline {
namespace {

std::vector<MaterialEntry>& registered() {
  static std::vector<MaterialEntry> all;
  return all;
}

}  // namespace

const std::vector<MaterialEntry>& materials() { return registered(); }

const MaterialEntry& material_named(const std::string& name) { return named(registered(), name, "material"); }

MaterialParameters parameters_of(const Material& material) {
  return material_named(material.name()).parameters(material);
}

void add_part(MaterialEntry entry) {
  if (!entry.parameters || !entry.make)
    throw std::logic_error("material " + entry.name + " can neither be read nor made");
  add_named(registered(), std::move(entry), MaterialEntry::kind);
}

}  // namespace plumbline
