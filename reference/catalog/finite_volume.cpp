// `plumbline reference finite-volume`: the comparator on a Riemann tube. Its bounds are no estimate: the exact
// solution is known, so each is the distance to it.
#include "reference/finite_volume.hpp"

#include <algorithm>

#include "reference/registry.hpp"

namespace plumbline::reference::catalog::finite_volume {
namespace {

Bounded against(double value, Bounded exact) { return {value, std::abs(value - exact.value) + exact.bound}; }

class FiniteVolumeReference : public Reference {
 public:
  std::string name() const override { return "finite-volume"; }
  std::string title() const override {
    return "Riemann problem in a tube [0, 1] by finite volumes (MUSCL-Hancock, HLLC, van Leer's limiter)";
  }
  std::string source() const override {
    return "E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., 2009, 10.4 and 14.4";
  }
  std::vector<Parameter> parameters() const override {
    const double infinity = rounding::infinity;
    return {{"left.density", 1, 0, infinity, true, true, "kg/m^3", "density left of the diaphragm"},
            {"left.velocity", 0, -infinity, infinity, true, true, "m/s", "velocity left of the diaphragm"},
            {"left.pressure", 1, 0, infinity, true, true, "Pa", "pressure left of the diaphragm"},
            {"right.density", 0.125, 0, infinity, true, true, "kg/m^3", "density right of the diaphragm"},
            {"right.velocity", 0, -infinity, infinity, true, true, "m/s", "velocity right of the diaphragm"},
            {"right.pressure", 0.1, 0, infinity, true, true, "Pa", "pressure right of the diaphragm"},
            {"gamma", 1.4, 1, infinity, true, true, "1", "ratio of specific heats"},
            {"diaphragm", 0.5, 0, 1, true, true, "m", "its position"},
            {"time", 0.143, 0, infinity, true, true, "s", "time of the answer, before a wave reaches an end"},
            {"cells", 400, 2, 20000, false, false, "1", "cells of the tube"},
            {"courant", 0.8, 0, 1, true, true, "1", "Courant number"}};
  }
  Parameter abscissa() const override { return {"x", 0, 0, 1, false, false, "m", "position"}; }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const RiemannSolution exact({{s.at("left.density"), s.at("left.velocity"), s.at("left.pressure")},
                                 {s.at("right.density"), s.at("right.velocity"), s.at("right.pressure")},
                                 s.at("gamma")});
    const double diaphragm = s.at("diaphragm"), time = s.at("time");
    const GasProblem tube = riemann_tube(exact.problem(), diaphragm, time);
    const auto solution = solve_finite_volume(tube, static_cast<int>(s.at("cells")), s.at("courant"));
    auto exact_at = [&](double x) { return exact.sample((x - diaphragm) / time); };
    const GasFields errors = mean_errors(solution, [&](double x) {
      const Sample sample = exact_at(x);
      return GasState{sample.density.value, sample.velocity.value, sample.pressure.value};
    });
    Answer answer;
    answer.add("cell_steps", static_cast<double>(solution.cell_steps()));
    answer.add("density_error", errors.density);
    answer.add("velocity_error", errors.velocity);
    answer.add("pressure_error", errors.pressure);
    answer.add("energy_error", errors.energy);
    for (double x : at) {
      const auto cell = std::min(static_cast<std::size_t>(x / solution.width()), solution.cells.size() - 1);
      const GasState& gas = solution.cells[cell];
      const Sample sample = exact_at(x);
      const Bounded density = against(gas.density, sample.density), velocity = against(gas.velocity, sample.velocity);
      const Bounded pressure = against(gas.pressure, sample.pressure);
      const Bounded energy = against(gas.pressure / ((s.at("gamma") - 1) * gas.density), sample.energy);
      answer.at.push_back({{"x", x},
                           {"density", density.value},
                           {"velocity", velocity.value},
                           {"pressure", pressure.value},
                           {"energy", energy.value}});
      answer.at_bounds.push_back({{"density", density.bound},
                                  {"velocity", velocity.bound},
                                  {"pressure", pressure.bound},
                                  {"energy", energy.bound}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<FiniteVolumeReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::finite_volume
