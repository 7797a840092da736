// `plumbline reference oscillator-limits`
#include "reference/oscillator_limits.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::oscillator_limits {
namespace {

using Method = OscillatorMethod;

constexpr std::pair<const char*, Method> methods[] = {{"forward_euler", Method::forward_euler},
                                                      {"explicit_midpoint", Method::explicit_midpoint},
                                                      {"symplectic_euler", Method::symplectic_euler},
                                                      {"leapfrog", Method::leapfrog},
                                                      {"ssp_rk3", Method::ssp_rk3},
                                                      {"rk4", Method::rk4},
                                                      {"newmark_trapezoid", Method::newmark_trapezoid},
                                                      {"newmark_linear", Method::newmark_linear},
                                                      {"generalized_alpha", Method::generalized_alpha}};

class OscillatorLimitsReference : public Reference {
 public:
  std::string name() const override { return "oscillator-limits"; }
  std::string title() const override {
    return "Largest stable steps w dt of time integrators on the linear oscillator, orders, and growth a step";
  }
  std::string source() const override {
    return "Amplification matrices; G. M. Hulbert, J. Chung, 1996, doi 10.1016/S0045-7825(96)01036-5";
  }
  std::vector<Parameter> parameters() const override {
    return {{"rho_b", 1, 0, 1, false, false, "1", "spectral radius of generalized-alpha at its bifurcation"}};
  }
  Parameter abscissa() const override { return {"omega_dt", 0, 0, 1e3, false, false, "1", "step w dt of the rows"}; }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const double rho_b = s.at("rho_b");
    Answer answer;
    for (const auto& [name, method] : methods) {
      const Bounded limit = oscillator_limit(method, rho_b);
      if (std::isfinite(limit.value)) answer.add(std::string(name) + "_limit", limit);
    }
    answer.add("generalized_alpha_bifurcation", generalized_alpha_bifurcation_limit(rho_b));
    for (const auto& [name, method] : methods) answer.add(std::string(name) + "_order", oscillator_order(method));
    for (double step : at) {
      std::vector<std::pair<std::string, Bounded>> row;
      for (const auto& [name, method] : methods) {
        row.emplace_back(name, oscillator_growth(method, step, rho_b));
      }
      add_row(answer, "omega_dt", step, row);
    }
    return answer;
  }
};

const Registration registration{std::make_unique<OscillatorLimitsReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::oscillator_limits
