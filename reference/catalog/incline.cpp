// `plumbline reference incline`: rows of velocity and way over time.
#include "reference/incline.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::incline {
namespace {

class InclineReference : public Reference {
 public:
  std::string name() const override { return "incline"; }
  std::string title() const override {
    return "A rigid block and a rigid disk on an incline with Coulomb friction: sliding, sticking, rolling";
  }
  std::string source() const override { return "H. Goldstein, Classical Mechanics, section 1.4; C. A. Coulomb 1785"; }
  std::vector<Parameter> parameters() const override {
    const InclineProblem p;
    return {not_negative("slope", p.slope, "1", "tan(theta)"),
            not_negative("friction", p.friction, "1", "coefficient mu"),
            positive_parameter("gravity", p.gravity, "m/s^2", "when it has grown"),
            not_negative("rise", p.rise, "s", "in which gravity grows from zero")};
  }
  Parameter abscissa() const override { return time_abscissa(); }

 private:
  static Parameter not_negative(const std::string& key, double value, const std::string& unit,
                                const std::string& description) {
    return {key, value, 0, rounding::infinity, false, true, unit, description};
  }

  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const Incline incline({s.at("slope"), s.at("friction"), s.at("gravity"), s.at("rise")});
    const Bounded block = incline.block_acceleration(), disk = incline.disk_acceleration();
    Answer answer;
    answer.add("block_acceleration", block);
    answer.add("disk_acceleration", disk);
    answer.add("disk_spin_up", incline.disk_spin_up());
    answer.add("normal_acceleration", incline.across());
    for (const double time : at) {
      const Bounded during = incline.velocity_time(time), squared = incline.way_time(time);
      add_row(answer, "time", time,
              {{"block_velocity", block * during},
               {"block_way", block * squared},
               {"block_friction_work", incline.block_friction_work(time)},
               {"disk_velocity", disk * during},
               {"disk_way", disk * squared}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<InclineReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::incline
