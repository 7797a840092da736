// `plumbline reference circular-membrane` and `plumbline reference mylar-balloon`
#include "reference/circular_membrane.hpp"

#include "reference/catalog/parameters.hpp"

namespace plumbline::reference::catalog::circular_membrane {
namespace {

class AnyCircularMembrane : public Reference {
 public:
  std::vector<Parameter> parameters() const override {
    return {{"load", default_load(), 1e-9, 1, false, false, "1", "pressure times radius over E times thickness"},
            {"poisson_ratio", 0.3, 0, 0.5, false, false, "1", "Poisson's ratio"},
            positive_parameter("radius", 1, "m", "of the flat sheet at rest")};
  }
  Parameter abscissa() const override {
    return {"position", 0, 0, rounding::infinity, false, true, "m", "distance from the middle at rest"};
  }

 protected:
  static CircularMembraneProblem problem_of(const std::map<std::string, double>& s) {
    return {s.at("load"), s.at("poisson_ratio"), s.at("radius")};
  }
  template <class Membrane>
  static void add_rows(Answer& answer, const Membrane& membrane, std::span<const double> at) {
    for (double s : at) {
      const MembranePoint p = membrane.at(s);
      add_row(answer, "position", s,
              {{"radius", p.radius},
               {"height", p.height},
               {"meridian_stress", p.meridian_stress},
               {"hoop_stress", p.hoop_stress},
               {"meridian_stretch", p.meridian_stretch}});
    }
  }

 private:
  virtual double default_load() const = 0;
};

class CircularMembraneReference : public AnyCircularMembrane {
 public:
  std::string name() const override { return "circular-membrane"; }
  std::string title() const override { return "Circular membrane with a clamped rim under pressure, finite strains"; }
  std::string source() const override {
    return "H. Hencky, Z. Math. Phys. 63 (1915) 311, and W. B. Fichter, NASA TP-3658 (1997), for small loads; derived";
  }

 private:
  double default_load() const override { return CircularMembraneProblem().load; }
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const CircularMembrane membrane(problem_of(s));
    Answer answer;
    answer.add("height", membrane.height());
    answer.add("stress", membrane.stress());
    answer.add("volume", membrane.volume());
    add_rows(answer, membrane, at);
    return answer;
  }
};

class MylarBalloonReference : public AnyCircularMembrane {
 public:
  std::string name() const override { return "mylar-balloon"; }
  std::string title() const override {
    return "Balloon of two circular sheets that wrinkle, sewn at the rim, under pressure";
  }
  std::string source() const override {
    return "W. Paulsen, Amer. Math. Monthly 101 (1994) 953 (inextensible); A. C. Pipkin, IMA J. Appl. Math. 36 (1986) "
           "85 "
           "(tension field); derived";
  }

 private:
  double default_load() const override { return 0.01; }
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const MylarBalloon balloon(problem_of(s));
    Answer answer;
    answer.add("rim_radius", balloon.rim_radius());
    answer.add("half_height", balloon.half_height());
    answer.add("volume", balloon.volume());
    answer.add("stress", balloon.stress());
    answer.add("taut_radius", balloon.taut_radius());
    add_rows(answer, balloon, at);
    return answer;
  }
};

const Registration clamped{std::make_unique<CircularMembraneReference>()};
const Registration balloon{std::make_unique<MylarBalloonReference>()};

}  // namespace
}  // namespace plumbline::reference::catalog::circular_membrane
