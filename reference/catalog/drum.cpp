// `plumbline reference drum` and `plumbline reference prestretched-drum`
#include "reference/drum.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::drum {
namespace {

Parameter around_parameter() { return {"around", 0, 0, 100, false, false, "1", "nodal diameters of the mode"}; }
Parameter across_parameter() { return {"across", 1, 1, 1000, false, false, "1", "nodal circles, with the rim"}; }

class AnyDrum : public Reference {
 public:
  std::string source() const override { return "Lord Rayleigh, The Theory of Sound, sections 199-206"; }
  Parameter abscissa() const override {
    return {"position", 0, 0, rounding::infinity, false, true, "m", "distance from the middle"};
  }

 protected:
  static Answer answer_of(const Drum& drum, const std::map<std::string, double>& s, std::span<const double> at) {
    const int around = whole_number(s, "around"), across = whole_number(s, "across");
    Answer answer;
    answer.add("tension", drum.tension());
    answer.add("area_density", drum.area_density());
    answer.add("wave_speed", drum.wave_speed());
    answer.add("omega", drum.omega(around, across));
    for (double r : at) add_row(answer, "position", r, {{"shape", drum.shape(around, r, across)}});
    return answer;
  }
};

class DrumReference : public AnyDrum {
 public:
  std::string name() const override { return "drum"; }
  std::string title() const override {
    return "Small vibration of a circular membrane under uniform tension, one mode";
  }
  std::vector<Parameter> parameters() const override {
    const DrumProblem p;
    return {positive_parameter("radius", p.radius, "m", "of the fixed rim"),
            positive_parameter("tension", p.tension, "N/m", "force per length"),
            positive_parameter("area_density", p.area_density, "kg/m^2", "mass per area of the taut membrane"),
            around_parameter(), across_parameter()};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    return answer_of(Drum(DrumProblem{s.at("radius"), s.at("tension"), s.at("area_density")}), s, at);
  }
};

class PrestretchedDrumReference : public AnyDrum {
 public:
  std::string name() const override { return "prestretched-drum"; }
  std::string title() const override {
    return "Small vibration of a circular sheet of St. Venant and Kirchhoff, stretched alike along both tangents, one "
           "mode";
  }
  std::vector<Parameter> parameters() const override {
    const PrestretchedSheet p;
    return {positive_parameter("youngs_modulus", p.youngs_modulus, "Pa", "Young's modulus"),
            {"poisson_ratio", p.poisson_ratio, -1, 0.5, true, false, "1", "Poisson's ratio"},
            positive_parameter("thickness", p.thickness, "m", "at rest"),
            positive_parameter("density", p.density, "kg/m^3", "at rest"),
            {"stretch", p.stretch, 1, rounding::infinity, true, true, "1", "of every tangent"},
            positive_parameter("radius", p.radius, "m", "of the fixed rim, of the stretched sheet"),
            around_parameter(),
            across_parameter()};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const PrestretchedSheet sheet{s.at("youngs_modulus"), s.at("poisson_ratio"), s.at("thickness"),
                                  s.at("density"),        s.at("stretch"),       s.at("radius")};
    return answer_of(drum_of(sheet), s, at);
  }
};

const Registration drum{std::make_unique<DrumReference>()};
const Registration prestretched{std::make_unique<PrestretchedDrumReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::drum
