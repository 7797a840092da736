// What gates of materials measure of a rod that is wrong by known amounts: on a line tensors have one component, and what a
// random rate makes of them cancels.
#include <cmath>

#include "cases/catalog/estimators/known_answers.hpp"
#include "cases/catalog/estimators/reading.hpp"
#include "cases/harness/parts/material_gates.hpp"
#include "kernel/points/column_names.hpp"

namespace plumbline {
namespace {

constexpr double rod_flaw = 0.03;                  // relative
constexpr double stiffness = 50, rod_density = 2;  // Pa, kg/m^3
const double rod_speed = std::sqrt(stiffness / rod_density);

struct RodFlaws {
  double energy = 0, told = 0, rate = 0, speed = 0, motion = 0, heat_told = 0;  // relative
  double added = 0;    // stress that a rate adds against itself, over the elastic one
  double viscous = 0;  // Pa s
  double cooling =
      0;  // heat that a second takes back, over the energy, 1/s; the rod stores as much as its volume then, J/m^3
  bool elastic = true;  // else it has viscosity alone
  bool dissipative = false;
  int faulty = -1;  // the point that is called inadmissible, whatever its state
};

// The stress is E e, of strains that are added up, in volumes that stay.
class FlawedRod final : public Material {
 public:
  explicit FlawedRod(const RodFlaws& flaws) : flaws_(flaws) {}
  std::string name() const override { return "flawed-rod"; }
  void add_columns(Columns& points, int) const override {
    points.add(column::strain, points.components(column::stress));
  }
  Store store() const override { return Store::elastic; }
  bool dissipates() const override { return flaws_.dissipative; }

  double advance(Columns& points, PointRange range, const MaterialContext&, double dt) const override {
    double told = 0;
    for (int p = range.first; p < range.last; ++p) {
      const double before = energy(points, p);
      points(column::strain)[p] += dt * (flaws_.cooling > 0 ? 1 : points(column::strain_rate)[p]);
      told += energy(points, p) - before;
    }
    double size = stored_energy(points, range);
    size = std::max(size, size - told);
    return told + flaws_.told * size;
  }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override { return {&column::strain}; }
  std::vector<double> rates(const Columns& points, const MaterialContext&) const override {
    std::vector<double> all(points.values(column::strain).size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = (1 + flaws_.rate) * points.values(column::strain_rate)[k];
    return all;
  }
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext&) const override {
    for (int p = range.first; p < range.last; ++p) {
      const double rate = points(column::strain_rate)[p];
      const double elastic = flaws_.elastic ? stiffness * points(column::strain)[p] : 0;
      const double against = rate == 0 ? 0 : -std::copysign(flaws_.added * elastic, rate);
      points(column::stress)[p] = elastic + against + flaws_.viscous * rate;
    }
  }
  double viscous_heat(const Columns& points, PointRange range, const MaterialContext&, double dt) const override {
    double heat = 0;
    for (int p = range.first; p < range.last; ++p) {
      const double rate = points(column::strain_rate)[p];
      heat += dt * points(column::volume)[p] * flaws_.viscous * rate * rate;
    }
    return (1 + flaws_.heat_told) * heat;
  }
  double stored_energy(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) sum += energy(points, p);
    return sum;
  }
  double heat(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) {
      sum -= flaws_.cooling * points(column::volume)[p] * points(column::strain)[p];
    }
    return sum;
  }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    const double moving = fastest_point(points, range, dim);
    const double more = moving > 0 ? moving + flaws_.motion * rod_speed : 0;
    return {(1 + flaws_.speed) * rod_speed + more, 0};
  }
  Fault first_fault(const Columns&, PointRange) const override {
    if (flaws_.faulty < 0) return {};
    return {flaws_.faulty, "strain", 0, "flawed"};
  }

 private:
  double energy(const Columns& points, int p) const {
    const double strain = points(column::strain)[p], volume = points(column::volume)[p];
    if (flaws_.cooling > 0) return volume;
    return (1 + flaws_.energy) * volume * stiffness * strain * strain / 2;
  }

  RodFlaws flaws_;
};

double reading_of_rod(const RodFlaws& flaws, const std::string& row) {
  MaterialEntry entry;
  entry.name = "flawed-rod";
  entry.parameters = [](const Material&) { return MaterialParameters{{"density", "kg/m^3", rod_density}}; };
  entry.make = [flaws](const std::map<std::string, double>&) { return std::make_shared<const FlawedRod>(flaws); };
  return reading(material_gates(entry), row + "/line");
}

}  // namespace

KnownAnswers material_answers() {
  KnownAnswers all;
  const auto add = [&](const std::string& row, const RodFlaws& flaws, double exact) {
    all.push_back({std::to_string(all.size()) + "." + row, reading_of_rod(flaws, row), exact});
  };
  add("energy/derivative", {.energy = rod_flaw}, rod_flaw);
  add("energy/derivative", {.energy = -rod_flaw, .dissipative = true}, rod_flaw);
  add("energy/told", {.told = rod_flaw}, rod_flaw);
  add("energy/told", {.told = -rod_flaw}, rod_flaw);
  add("rates/advance", {.rate = rod_flaw}, rod_flaw);
  add("rates/advance", {.rate = -rod_flaw, .dissipative = true}, rod_flaw);
  add("speed/small-strains", {.speed = -rod_flaw}, rod_flaw);
  add("speed/small-strains", {.speed = rod_flaw}, -rod_flaw);
  add("speed/excess", {.speed = rod_flaw}, rod_flaw);
  add("speed/strained", {.speed = -rod_flaw}, rod_flaw);
  add("speed/motion", {.motion = rod_flaw}, rod_flaw);
  add("speed/motion", {.motion = -rod_flaw}, rod_flaw);
  add("entropy/production", {.added = rod_flaw}, rod_flaw / (1 + rod_flaw));
  add("entropy/told", {.heat_told = rod_flaw, .viscous = 0.4, .elastic = false}, rod_flaw);
  add("entropy/told", {.heat_told = -rod_flaw, .viscous = 0.4, .elastic = false}, rod_flaw);
  add("entropy/heat", {.cooling = rod_flaw, .dissipative = true},
      0.01 * rod_flaw);  // over the time of the gate, 0.01 s
  // Strains that are no number, and infinite ones, go unnamed; of a fault that is none the good state counts, too.
  add("faults/named", {}, 2);
  add("faults/named", {.faulty = 0}, 3);
  return all;
}

}  // namespace plumbline
