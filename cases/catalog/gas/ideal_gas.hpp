// The gas of a scene, with the artificial viscosity that is chosen.
#pragma once

#include <memory>

#include "cases/harness/description/settings.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {

// gamma > 1. Keys: viscosity.linear, viscosity.quadratic and viscosity.closing.
inline std::shared_ptr<IdealGas> chosen_gas(const Settings& settings, double gamma) {
  auto gas = std::make_shared<IdealGas>();
  gas->gamma = gamma;
  gas->viscosity_linear = settings.number("viscosity.linear");
  gas->viscosity_quadratic = settings.number("viscosity.quadratic");
  gas->limits_viscosity = settings.text("viscosity.closing") == "limited";
  return gas;
}

}  // namespace plumbline
