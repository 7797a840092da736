// `plumbline reference rotating-disk`
#include "reference/rotating_disk.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::rotating_disk {
namespace {

class RotatingDiskReference : public Reference {
 public:
  std::string name() const override { return "rotating-disk"; }
  std::string title() const override { return "Solid elastic disk that turns steadily, small strains"; }
  std::string source() const override {
    return "S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., section 32";
  }
  std::vector<Parameter> parameters() const override {
    const RotatingDiskProblem p;
    return {positive_parameter("radius", p.radius, "m", "of the disk at rest"),
            positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson", p.poisson, -1, 0.5, true, true, "1", "Poisson's ratio"},
            positive_parameter("density", p.density, "kg/m^3", "density"),
            finite_parameter("angular_velocity", p.angular_velocity, "1/s", "angular velocity"),
            {"plane_strain", 0, 0, 1, false, false, "1", "0: plane stress, 1: plane strain"}};
  }
  Parameter abscissa() const override {
    return {"radius", 0, 0, rounding::infinity, false, true, "m", "distance from the axis, at rest"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PlaneState plane = switched_on(s, "plane_strain") ? PlaneState::strain : PlaneState::stress;
    const RotatingDisk disk(
        {s.at("radius"), s.at("youngs_modulus"), s.at("poisson"), s.at("density"), s.at("angular_velocity"), plane});
    Answer answer;
    answer.add("centre_stress", disk.centre_stress());
    answer.add("angular_momentum", disk.angular_momentum());
    answer.add("kinetic_energy", disk.kinetic_energy());
    answer.add("strain_energy", disk.strain_energy());
    answer.add("rim_displacement", disk.displacement(disk.problem().radius));
    for (double radius : at) {
      add_row(answer, "radius", radius,
              {{"displacement", disk.displacement(radius)},
               {"radial_stress", disk.radial_stress(radius)},
               {"hoop_stress", disk.hoop_stress(radius)},
               {"axial_stress", disk.axial_stress(radius)}});
    }
    return answer;
  }
};

const Registration registration{std::make_unique<RotatingDiskReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::rotating_disk
