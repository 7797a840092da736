// `plumbline reference gas-ring`
#include "reference/gas_ring.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::gas_ring {
namespace {

class GasRingReference : public Reference {
 public:
  std::string name() const override { return "gas-ring"; }
  std::string title() const override { return "Breathing of an elastic ring around a gas at rest, small"; }
  std::string source() const override {
    return "acoustics of a disc (Bessel functions) with the ring's equation of motion, derived";
  }

  std::vector<Parameter> parameters() const override {
    const GasRingProblem p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus of the ring"),
            {"poisson_ratio", p.poisson_ratio, -0.5, 0.5, true, true, "1", "of the ring, held out of the plane"},
            positive_parameter("thickness", p.thickness, "m",
                               "of the ring: unstretched (segments), at rest under the pressure (accumulated)"),
            positive_parameter("radius", p.radius, "m", "of the ring at rest under the pressure"),
            positive_parameter("line_mass", p.line_mass, "kg/m^2", "of the ring per length at rest and per depth"),
            positive_parameter("pressure", p.pressure, "Pa", "of the gas; none outside"),
            positive_parameter("gas_density", p.gas_density, "kg/m^3", "gas"),
            {"gamma", p.gamma, 1, rounding::infinity, true, true, "1", "ratio of the gas's specific heats"},
            {"law", 0, 0, 2, false, false, "1", "tension by 0: stretch of segments, 1: accumulated strain, 2: none"},
            finite_parameter("velocity", p.velocity, "m/s", "of the ring, at t = 0 of a mode"),
            {"mode", 1, 1, GasRing::most_mode, false, false, "1", "of the rows, a whole number from 1"}};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const GasRing ring({s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"), s.at("radius"),
                        s.at("line_mass"), s.at("pressure"), s.at("gas_density"), s.at("gamma"),
                        static_cast<RingLaw>(whole_number(s, "law")), s.at("velocity")});
    const int mode = whole_number(s, "mode");
    Answer answer;
    answer.add("strain", ring.strain());
    answer.add("unstretched_radius", ring.unstretched_radius());
    answer.add("ring_stiffness", ring.ring_stiffness());
    answer.add("dry_omega", ring.dry_omega());
    answer.add("quasi_static_omega", ring.quasi_static_omega());
    for (int n = 1; n <= 10; ++n) answer.add("omega_" + std::to_string(n), ring.omega(n));
    answer.add("period", ring.period(mode));
    answer.add("modal_mass", ring.modal_mass(mode));
    answer.add("mode_energy", ring.mode_energy(mode));
    answer.add("shape_half", ring.shape(0.5 * s.at("radius"), mode));
    answer.add("pressure_shape_centre", ring.pressure_shape(0, mode));
    answer.add("pressure_shape_ring", ring.pressure_shape(s.at("radius"), mode));
    for (double time : at) {
      add_row(answer, "time", time,
              {{"displacement", ring.displacement(time, mode)},
               {"velocity", ring.velocity(time, mode)},
               {"pressure_change", ring.pressure_change(s.at("radius"), time, mode)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<GasRingReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::gas_ring
