// `plumbline reference two-bar`: --at N1,N2,... gives what single meshes of that many elements answer.
#include "reference/two_bar.hpp"

#include <cmath>

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::two_bar {
namespace {

class TwoBarReference : public Reference {
 public:
  std::string name() const override { return "two-bar"; }
  std::string title() const override {
    return "Impact of two equal elastic bars in plane stress, by finite elements, with estimated error";
  }
  std::string source() const override { return "A. R. York II, SAND97-1893, appendix A.1; own finite elements"; }
  std::vector<Parameter> parameters() const override {
    const TwoBarProblem p;
    return {positive_parameter("width", p.width, "m", "of each bar, along the impact"),
            positive_parameter("height", p.height, "m", "of each bar, at least a quarter of the width"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson", p.poisson, 0, 0.45, false, false, "1", "Poisson's ratio"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("speed", p.speed, "m/s", "of the one bar; the other rests"),
            {"elements", 80, 32, 1000, false, false, "1", "through the width, of the finest of three meshes"}};
  }
  Parameter abscissa() const override {
    return {"elements", 0, 8, 1000, false, false, "1", "through the width of a single mesh"};
  }

 private:
  /// The bounds of the rows are the distances from the extrapolated value; energy is conserved in truth.
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const TwoBarProblem problem{s.at("width"),   s.at("height"),  s.at("youngs_modulus"),
                                s.at("poisson"), s.at("density"), s.at("speed")};
    const TwoBar bars(problem, static_cast<int>(s.at("elements")));
    Answer answer;
    answer.add("restitution", bars.restitution());
    answer.add("contact_duration", bars.contact_duration());
    answer.add("peak_force", bars.peak_force());
    answer.add("impulse", bars.impulse());
    answer.add("velocity_of_hit_bar", bars.velocity_of_hit_bar());
    answer.add("velocity_of_hitting_bar", bars.velocity_of_hitting_bar());
    answer.add("vibration_share", bars.vibration_share());
    answer.add("wave_speed", bars.wave_speed());
    for (double elements : at) {
      const TwoBarRun run = run_two_bar(problem, static_cast<int>(elements));
      const Bounded truth = bars.restitution();
      const double distance = std::abs(run.restitution - truth.value) + truth.bound;
      add_row(answer, "elements", elements,
              {{"restitution", {run.restitution, distance}},
               {"energy_kept", {run.energy_kept, std::abs(1 - run.energy_kept) + 1e-12}}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<TwoBarReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::two_bar
