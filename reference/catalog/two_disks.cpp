// `plumbline reference two-disks`: rows of the free flight before the impact.
#include "reference/two_disks.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::two_disks {
namespace {

class TwoDisksReference : public Reference {
 public:
  std::string name() const override { return "two-disks"; }
  std::string title() const override {
    return "Two elastic disks on collision course: first touch, momentum, energy; the impact has no closed solution";
  }
  std::string source() const override {
    return "D. Sulsky, Z. Chen, H. L. Schreyer, Comput. Methods Appl. Mech. Eng. 118 (1994) 179";
  }
  std::vector<Parameter> parameters() const override {
    const TwoDisksProblem p;
    return {finite_parameter("left_x", p.left_x, "m", "centre of one disk"),
            finite_parameter("left_y", p.left_y, "m", "centre of one disk"),
            finite_parameter("right_x", p.right_x, "m", "centre of the other disk"),
            finite_parameter("right_y", p.right_y, "m", "centre of the other disk"),
            positive_parameter("radius", p.radius, "m", "of both"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson", p.poisson, -1, 0.5, true, true, "1", "Poisson's ratio"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            positive_parameter("speed", p.speed, "m/s", "of each, against the other")};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const TwoDisks disks({s.at("left_x"), s.at("left_y"), s.at("right_x"), s.at("right_y"), s.at("radius"),
                          s.at("youngs_modulus"), s.at("poisson"), s.at("density"), s.at("speed")});
    Answer answer;
    answer.add("contact_time", disks.contact_time());
    answer.add("contact_x", disks.contact_x());
    answer.add("contact_y", disks.contact_y());
    answer.add("energy", disks.energy());
    answer.add("momentum_of_one", disks.momentum_of_one());
    answer.add("mass", disks.mass());
    answer.add("wave_speed", disks.wave_speed());
    answer.add("crossing_time", disks.crossing_time());
    for (double time : at) {
      if (!(time <= disks.contact_time().value)) throw ParameterError("time", time, "not after the first touch");
      add_row(answer, "time", time, {{"gap", disks.gap() - Bounded(2) * disks.problem().speed * time}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<TwoDisksReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::two_disks
