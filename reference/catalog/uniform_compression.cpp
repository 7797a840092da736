// `plumbline reference uniform-compression`
#include "reference/uniform_compression.hpp"

#include "reference/catalog/flow_answer.hpp"

namespace plumbline::reference::catalog::uniform_compression {
namespace {

class UniformCompressionReference : public Reference {
 public:
  std::string name() const override { return "uniform-compression"; }
  std::string title() const override { return "Uniform compression of an ideal gas with one kind of viscosity"; }
  std::string source() const override {
    return "integral of the energy equation with the stress of York, SAND97-1893, eqs. 4.1 and 4.11";
  }

  std::vector<Parameter> parameters() const override {
    const UniformCompressionProblem p;
    const double infinity = rounding::infinity;
    return {dimension_parameter(p.dimension),
            {"rate", p.rate, -infinity, infinity, true, true, "1/s", "a of the stretch 1 - a t"},
            {"viscosity", p.viscosity, 0, infinity, false, true, "Pa s", "physical viscosity"},
            {"linear", p.linear, 0, infinity, false, true, "m", "c_L h, where there is no other viscosity"},
            {"quadratic", p.quadratic, 0, infinity, false, true, "m^2", "c_Q h^2"},
            positive_parameter("density", p.density, "kg/m^3", "density at t = 0"),
            positive_parameter("pressure", p.pressure, "Pa", "pressure at t = 0"),
            gamma_parameter(p.gamma),
            time_parameter(0.5)};
  }
  Parameter abscissa() const override { return position_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const UniformCompression gas({dimension_of(s), s.at("rate"), s.at("viscosity"), s.at("linear"), s.at("quadratic"),
                                  s.at("density"), s.at("pressure"), s.at("gamma")});
    const double time = s.at("time");
    Answer answer;
    answer.add("stretch", gas.stretch(time));
    answer.add("isentropic_energy", gas.isentropic_energy(time));
    answer.add("viscous_heat", gas.viscous_heat(time));
    for (double x : at) add_row(answer, "position", x, gas.sample(x, time));
    return answer;
  }
};

const Registration registration{std::make_unique<UniformCompressionReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::uniform_compression
