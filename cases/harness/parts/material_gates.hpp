// Gates that any material must meet, in each geometry.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "cases/harness/parts/material_probe.hpp"
#include "kernel/materials/material_entry.hpp"

namespace plumbline {

// A material as it is judged. Numbers that are zero by default are given values by their units; of those without a unit, and of
// viscosities, both are tried. Besides the entry's own examples.
struct MaterialSubject {
  explicit MaterialSubject(const MaterialEntry& entry);
  std::vector<std::shared_ptr<const Material>> made;  // one to three, of which each has to meet the gates
  double density = 1;                                 // of its undeformed points, kg/m^3
};

std::vector<MeasuredGate> material_gates(const MaterialEntry& entry);

// The rows of one geometry of a material whose points bear forces (StressMeasure::point_force).
std::vector<MeasuredGate> pulling_gates(const std::shared_ptr<const MaterialSubject>& subject, std::size_t geometry);

}  // namespace plumbline
