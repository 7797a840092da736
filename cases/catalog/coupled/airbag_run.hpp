// One run of a probe that falls on York's airbag.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/coupled/airbag_start.hpp"
#include "cases/harness/description/case.hpp"

namespace plumbline {

// What York's two simulations differ in. York, Table 7
struct AirbagSpec {
  std::string name;
  double mass = 0;    // of the probe, kg
  double radius = 0;  // of the probe, m
  double speed = 0;   // at impact, m/s
  double crown = 0;   // height of the bag's pole in York's outline, m
  double end_time = 0;
};

std::unique_ptr<Problem> airbag_run(const AirbagSpec& spec, const Settings& settings);

// The probe, a solid cylinder 80 mm high with its face at the height `face`, at rest: rows of points about h/ppc apart
// that fill it exactly, the density such that it has its mass.
Body airbag_probe(const AirbagSpec& spec, const GridSpec& grid, int ppc, double face);

}  // namespace plumbline
