// `plumbline reference shu-osher`, `woodward-colella`, `gas-expansion`: flows without a closed solution.
#include "reference/converged_gas.hpp"

#include <algorithm>
#include <memory>

#include "reference/registry.hpp"

namespace plumbline::reference::catalog::converged_gas {
namespace {

const double infinity = rounding::infinity;

Parameter cells_parameter(double cells) {
  return {"cells", cells, 40, 20000, false, false, "1", "cells of the finest of three meshes"};
}

Parameter place(const char* key, double low, const char* description) {
  return {key, 0, low, infinity, false, true, "m", description};
}

void add_rows(Answer& answer, const ConvergedGas& gas, const std::string& key, std::span<const double> at) {
  for (double x : at) {
    const Sample s = gas.sample(x);
    answer.at.push_back({{key, x},
                         {"density", s.density.value},
                         {"velocity", s.velocity.value},
                         {"pressure", s.pressure.value},
                         {"energy", s.energy.value}});
    answer.at_bounds.push_back({{"density", s.density.bound},
                                {"velocity", s.velocity.bound},
                                {"pressure", s.pressure.bound},
                                {"energy", s.energy.bound}});
  }
}

/// What the reference says about itself: estimated mean errors, exact by definition.
void add_errors(Answer& answer, const ConvergedGas& gas) {
  answer.add("density_error", gas.error().density);
  answer.add("velocity_error", gas.error().velocity);
  answer.add("pressure_error", gas.error().pressure);
  answer.add("energy_error", gas.error().energy);
}

/// The strongest shock stands within three cells of the medium mesh of where the pressure rises most.
Bounded shock_position(const ConvergedGas& gas) {
  const LagrangianSolution& fine = gas.finest();
  const double at = gas.steepest();
  const std::size_t cell = fine.cell_of(at), last = fine.masses.size();
  const double low = fine.edges[cell > 6 ? cell - 6 : 0], high = fine.edges[std::min(cell + 6, last)];
  return {at, std::max(at - low, high - at)};
}

class ShuOsherReference : public Reference {
 public:
  std::string name() const override { return "shu-osher"; }
  std::string title() const override { return "Shock of Mach 3 into a density wave, computed, with estimated error"; }
  std::string source() const override { return "C.-W. Shu, S. Osher, J. Comput. Phys. 83 (1989) 32, example 8"; }
  std::vector<Parameter> parameters() const override {
    return {{"time", 1.8, 0, 2, true, false, "s", "time of the answer"},
            {"amplitude", 0.2, 0, 0.25, false, false, "kg/m^3", "of the density wave about 1"},
            {"wave_number", 5, 0, 20, false, false, "1/m", "of the density wave"},
            cells_parameter(shu_osher_cells)};
  }
  Parameter abscissa() const override { return place("x", -infinity, "position; the shock starts at -4"); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    std::unique_ptr<ConvergedGas> own;
    const auto defaults = complete(parameters(), {});
    if (s != defaults) {
      const auto problem = shu_osher_reference(s.at("time"), s.at("amplitude"), s.at("wave_number"));
      own = std::make_unique<ConvergedGas>(problem, static_cast<int>(s.at("cells")));
    }
    const ConvergedGas& gas = own ? *own : shu_osher();
    Answer answer;
    answer.add("shock_position", shock_position(gas));
    add_errors(answer, gas);
    add_rows(answer, gas, "x", at);
    return answer;
  }
};

class WoodwardColellaReference : public Reference {
 public:
  std::string name() const override { return "woodward-colella"; }
  std::string title() const override { return "Two blast waves between walls, computed, with estimated error"; }
  std::string source() const override { return "P. Woodward, P. Colella, J. Comput. Phys. 54 (1984) 115"; }
  std::vector<Parameter> parameters() const override {
    return {{"time", 0.038, 0, 0.05, true, false, "s", "time of the answer"}, cells_parameter(woodward_colella_cells)};
  }
  Parameter abscissa() const override { return place("x", 0, "position; walls at 0 and 1"); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    std::unique_ptr<ConvergedGas> own;
    if (s != complete(parameters(), {})) {
      own = std::make_unique<ConvergedGas>(woodward_colella_reference(s.at("time")), static_cast<int>(s.at("cells")));
    }
    const ConvergedGas& gas = own ? *own : woodward_colella();
    Answer answer;
    answer.add("shock_position", shock_position(gas));
    add_errors(answer, gas);
    add_rows(answer, gas, "x", at);
    return answer;
  }
};

class GasExpansionReference : public Reference {
 public:
  std::string name() const override { return "gas-expansion"; }
  std::string title() const override {
    return "Cylinder of gas (density 1, pressure 100, gamma 1.4) into vacuum, computed, with estimated error";
  }
  std::string source() const override { return "A. R. York II, SAND97-1893, section 4.2"; }
  std::vector<Parameter> parameters() const override {
    return {{"radius", 0.38, 0, infinity, true, true, "m", "of the gas at t = 0"},
            {"time", 0.005, 0, infinity, true, true, "s", "at most 0.8 radius/c0, c0 = 11.832 m/s"},
            cells_parameter(gas_expansion_cells)};
  }
  Parameter abscissa() const override { return place("r", 0, "radius"); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const double radius = s.at("radius"), time = s.at("time");
    const ConvergedGas& gas = gas_expansion(radius, time, static_cast<int>(s.at("cells")));
    Answer answer;
    answer.add("head", gas_expansion_head(radius, time));
    answer.add("front", gas_expansion_front(radius, time));
    add_errors(answer, gas);
    add_rows(answer, gas, "r", at);
    return answer;
  }
};

const Registration shu_osher_entry{std::make_unique<ShuOsherReference>()};
const Registration woodward_colella_entry{std::make_unique<WoodwardColellaReference>()};
const Registration gas_expansion_entry{std::make_unique<GasExpansionReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::converged_gas
