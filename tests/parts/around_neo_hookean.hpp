// The neo-Hookean material, for wrong ones that differ from it in one function.
#pragma once

#include <string>

#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/register_part.hpp"
#include "tests/parts/around.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {

struct AroundNeoHookean : Around<NeoHookean> {
  double youngs_modulus = 0, poissons_ratio = 0, density = 0;

  NeoHookean right() const override {
    NeoHookean material;
    material.youngs_modulus = youngs_modulus;
    material.poissons_ratio = poissons_ratio;
    material.density = density;
    return material;
  }
};

// M is derived from AroundNeoHookean.
template <class M>
MaterialEntry material(const std::string& defect) {
  return material_entry<M>(defect, here,
                           {{"youngs_modulus", "Pa", &M::youngs_modulus},
                            {"poissons_ratio", "1", &M::poissons_ratio},
                            {"density", "kg/m^3", &M::density}});
}

}  // namespace plumbline::wrong
