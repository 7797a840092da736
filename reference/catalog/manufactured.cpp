// `plumbline reference mms-bar`, `mms-axis-aligned`, `mms-ring`, `mms-vortex`: rows along x at one time.
#include "reference/manufactured/manufactured.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::manufactured {
namespace {

using Settings = std::map<std::string, double>;

Parameter youngs_parameter(double value) {
  return positive_parameter("youngs_modulus", value, "Pa", "Young's modulus");
}
Parameter poisson_parameter(double value) { return {"poisson", value, -1, 0.5, true, true, "1", "Poisson's ratio"}; }
Parameter density_parameter(double value) { return positive_parameter("density", value, "kg/m^3", "initial density"); }

/// xx, xy, ... for the components of a tensor.
std::string component(int i, int j) { return {"xyz"[i], "xyz"[j]}; }

void add_state(Answer& answer, double x, const ManufacturedState<Bounded>& state, int dim) {
  std::vector<std::pair<std::string, Bounded>> row;
  const std::pair<std::string, const Vector<Bounded>&> vectors[] = {{"displacement_", state.displacement},
                                                                    {"velocity_", state.velocity},
                                                                    {"acceleration_", state.acceleration},
                                                                    {"body_force_", state.body_force}};
  for (const auto& [name, vector] : vectors) {
    for (int i = 0; i < dim; ++i) row.emplace_back(name + "xyz"[i], vector[i]);
  }
  const std::pair<std::string, const Tensor<Bounded>&> tensors[] = {{"deformation_", state.deformation},
                                                                    {"stress_", state.stress}};
  for (const auto& [name, tensor] : tensors) {
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) row.emplace_back(name + component(i, j), tensor[dim * i + j]);
    }
  }
  add_row(answer, "x", x, row);
}

class ManufacturedReference : public Reference {
 public:
  Parameter abscissa() const override {
    return finite_parameter("x", 0, "m", "first initial coordinate of a material point");
  }

 private:
  virtual std::unique_ptr<ManufacturedSolution> make(const Settings& settings) const = 0;

  Answer solve(const Settings& s, std::span<const double> at) const override {
    const std::unique_ptr<ManufacturedSolution> solution = make(s);
    Answer answer;
    answer.add("lambda", solution->lame().lambda);
    answer.add("mu", solution->lame().mu);
    answer.add("wave_speed", solution->wave_speed());
    for (double x : at) {
      const double position[] = {x, s.count("y") ? s.at("y") : 0, s.count("z") ? s.at("z") : 0};
      add_state(answer, x, solution->state(position, s.at("time")), solution->dimension());
    }
    return answer;
  }
};

class BarReference : public ManufacturedReference {
 public:
  std::string name() const override { return "mms-bar"; }
  std::string title() const override { return "Manufactured: u = A sin(pi X/L) sin(pi c t/L) in a neo-Hookean bar"; }
  std::string source() const override {
    return "P. C. Wallstedt, J. E. Guilkey, J. Comput. Phys. 227 (2008) 9628; M. Steffen et al., CMES 31 (2008) 107";
  }
  std::vector<Parameter> parameters() const override {
    const AxisAlignedProblem p = mms_bar_problem();
    return {youngs_parameter(p.youngs_modulus),
            poisson_parameter(p.poisson),
            density_parameter(p.density),
            positive_parameter("length", p.length, "m", "L, fixed at both ends"),
            finite_parameter("amplitude", p.amplitude, "m", "A, below L/pi"),
            time_parameter(0.005)};
  }

 private:
  std::unique_ptr<ManufacturedSolution> make(const Settings& s) const override {
    AxisAlignedProblem p = mms_bar_problem(s.at("amplitude"));
    p.youngs_modulus = s.at("youngs_modulus");
    p.poisson = s.at("poisson");
    p.density = s.at("density");
    p.length = s.at("length");
    return mms_axis_aligned(p);
  }
};

class AxisAlignedReference : public ManufacturedReference {
 public:
  std::string name() const override { return "mms-axis-aligned"; }
  std::string title() const override {
    return "Manufactured: u_i = A sin(pi X_i/L) sin(pi c t/L + pi phase_i) in a neo-Hookean square or cube";
  }
  std::string source() const override { return "P. C. Wallstedt, J. E. Guilkey, J. Comput. Phys. 227 (2008) 9628"; }
  std::vector<Parameter> parameters() const override {
    const AxisAlignedProblem p = mms_square_problem();
    return {{"dimension", 2, 1, 3, false, false, "1", "a whole number"},
            youngs_parameter(p.youngs_modulus),
            poisson_parameter(p.poisson),
            density_parameter(p.density),
            positive_parameter("length", p.length, "m", "L"),
            finite_parameter("amplitude", p.amplitude, "m", "A, below L/pi"),
            finite_parameter("phase_x", p.phase[0], "pi", "of the first displacement"),
            finite_parameter("phase_y", p.phase[1], "pi", "of the second; 2/3 in three dimensions"),
            finite_parameter("phase_z", p.phase[2], "pi", "of the third; 4/3 in three dimensions"),
            finite_parameter("y", 0.25, "m", "second initial coordinate"),
            finite_parameter("z", 0.25, "m", "third initial coordinate"),
            time_parameter(0.0075)};
  }

 private:
  std::unique_ptr<ManufacturedSolution> make(const Settings& s) const override {
    return mms_axis_aligned({whole_number(s, "dimension"),
                             s.at("youngs_modulus"),
                             s.at("poisson"),
                             s.at("density"),
                             s.at("length"),
                             s.at("amplitude"),
                             {s.at("phase_x"), s.at("phase_y"), s.at("phase_z")}});
  }
};

class RingReference : public ManufacturedReference {
 public:
  std::string name() const override { return "mms-ring"; }
  std::string title() const override {
    return "Manufactured: neo-Hookean ring, nu = 0, that swings radially, both edges free";
  }
  std::string source() const override { return "P. C. Wallstedt, J. E. Guilkey, J. Comput. Phys. 227 (2008) 9628"; }
  std::vector<Parameter> parameters() const override {
    const RingProblem p;
    return {youngs_parameter(p.youngs_modulus),
            density_parameter(p.density),
            positive_parameter("inner", p.inner, "m", "radius of the inner edge"),
            positive_parameter("outer", p.outer, "m", "radius of the outer edge"),
            finite_parameter("amplitude", p.amplitude, "m", "displacement of the outer edge at t = 0"),
            finite_parameter("y", 0, "m", "second initial coordinate"),
            time_parameter(0)};
  }

 private:
  std::unique_ptr<ManufacturedSolution> make(const Settings& s) const override {
    return mms_ring({s.at("youngs_modulus"), s.at("density"), s.at("inner"), s.at("outer"), s.at("amplitude")});
  }
};

class VortexReference : public ManufacturedReference {
 public:
  std::string name() const override { return "mms-vortex"; }
  std::string title() const override {
    return "Manufactured: the generalised vortex, circles of a neo-Hookean ring turn by A sin(pi t/T) h(R)";
  }
  std::string source() const override { return "K. Kamojjala et al., Eng. Comput. 31 (2015) 193"; }
  std::vector<Parameter> parameters() const override {
    const VortexProblem p;
    return {youngs_parameter(p.youngs_modulus),
            poisson_parameter(p.poisson),
            density_parameter(p.density),
            positive_parameter("inner", p.inner, "m", "radius of the inner edge"),
            positive_parameter("outer", p.outer, "m", "radius of the outer edge"),
            finite_parameter("amplitude", p.amplitude, "rad", "largest angle"),
            positive_parameter("period", p.period, "s", "T"),
            finite_parameter("y", 0, "m", "second initial coordinate"),
            time_parameter(0.5)};
  }

 private:
  std::unique_ptr<ManufacturedSolution> make(const Settings& s) const override {
    return mms_vortex({s.at("youngs_modulus"), s.at("poisson"), s.at("density"), s.at("inner"), s.at("outer"),
                       s.at("amplitude"), s.at("period")});
  }
};

const Registration bar{std::make_unique<BarReference>()};
const Registration axis_aligned{std::make_unique<AxisAlignedReference>()};
const Registration ring{std::make_unique<RingReference>()};
const Registration vortex{std::make_unique<VortexReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::manufactured
