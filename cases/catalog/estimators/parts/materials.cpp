// What gates of materials measure of a solid that is wrong by known amounts. Gates strain points at random rates and take what
// is wrong over the sizes of stress and rate: here it is made in proportion to these, so that each gate has to measure the
// same number at every point, in every state and geometry.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/parts/reading.hpp"
#include "cases/harness/parts/material_gates.hpp"
#include "cases/harness/parts/shape_probe.hpp"
#include "kernel/points/column_names.hpp"

namespace plumbline {
namespace {

constexpr double solid_flaw = 0.03;
constexpr double stiffness = 50, solid_density = 2;  // Pa, kg/m^3
const double solid_speed = std::sqrt(stiffness / solid_density);

// How much is wrong; |s| and |L| are the sizes of the stress and of the velocity gradient.
struct SolidFlaws {
  double energy = 0;        // stored besides the work, over V |s| (|L| + |hoop rate|)
  double told = 0;          // told of the energy that is stored, over all of it
  double rate = 0;          // of internal variables, over that of advance()
  double spin = 0;          // change of the stress besides that of turning, over |s| |w|
  double spin_energy = 0;   // stored by a spin, over V |s| |w|
  double speed = 0;         // of the step, over that of waves
  double motion = 0;        // added to it where points move, over that of waves
  double against = 0;       // stress that a rate adds against itself, over |s|
  double against_hoop = 0;  // the same around the axis, over |s| |L| / |hoop rate|
  double viscosity = 0;     // Pa s; then there is no other stress
  double heat_told = 0;     // over the viscous heat
  double cooling = 0;       // 1/s: heat that goes over the energy; what is stored is J/m^3 then
  bool dissipative = false;
  int faulty = -1;  // the point that is called inadmissible, whatever its state
};

// s' = w s - s w + E (L + L^T)/2 with the spin w, and E times the rate around an axis: the fastest wave in any direction has the
// speed sqrt(E/rho). Volumes stay. What is stored is added up from the work.
class FlawedSolid final : public Material {
 public:
  explicit FlawedSolid(const SolidFlaws& flaws) : flaws_(flaws) {}
  std::string name() const override { return "flawed-solid"; }
  StressMeasure measure() const override { return StressMeasure::full; }
  Store store() const override { return Store::elastic; }
  bool dissipates() const override { return flaws_.dissipative; }
  void add_columns(Columns& points, int) const override {
    points.add(column::strain, points.components(column::stress));  // holds the stress
    points.add(column::transfer_loss);                              // and this what is stored, J
  }

  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override {
    const double before = stored_energy(points, range);
    for (int p = range.first; p < range.last; ++p) {
      const State now = state(points, context.dim, p);
      const auto [change, hoop] = stress_rate(now);
      points(column::transfer_loss)[p] += dt * stored_rate(points, now, p);
      set(points, column::strain, p, now.stress + dt * change, now.hoop + dt * hoop);
    }
    const double after = stored_energy(points, range);
    return after - before + flaws_.told * std::max(std::abs(after), std::abs(before));
  }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override { return {&column::strain}; }
  std::vector<double> rates(const Columns& points, const MaterialContext& context) const override {
    Columns all = points;
    for (int p = 0; p < points.points(); ++p) {
      const auto [change, hoop] = stress_rate(state(points, context.dim, p));
      set(all, column::strain, p, (1 + flaws_.rate) * change, (1 + flaws_.rate) * hoop);
    }
    const auto values = all.values(column::strain);
    return {values.begin(), values.end()};
  }

  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    for (int p = range.first; p < range.last; ++p) {
      const State now = state(points, context.dim, p);
      Eigen::MatrixXd stress = now.stress;
      double hoop = now.hoop;
      const double size = now.stress.norm(), rate = now.gradient.norm();
      if (rate > 0) stress -= flaws_.against * size / rate * now.gradient;
      if (now.hoop_rate != 0) hoop -= flaws_.against_hoop * size * rate / now.hoop_rate;
      if (flaws_.viscosity > 0) {
        stress = flaws_.viscosity * now.gradient;
        hoop = flaws_.viscosity * now.hoop_rate;
      }
      set(points, column::stress, p, stress, hoop);
    }
  }
  double viscous_heat(const Columns& points, PointRange range, const MaterialContext& context,
                      double dt) const override {
    double heat = 0;
    for (int p = range.first; p < range.last; ++p) {
      const State now = state(points, context.dim, p);
      const double power = points(column::volume)[p] * flaws_.viscosity * now.gradient.squaredNorm();
      heat += dt * (power * (1 + flaws_.heat_told) +
                    points(column::volume)[p] * flaws_.viscosity * now.hoop_rate * now.hoop_rate);
    }
    return heat;
  }
  double stored_energy(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) sum += energy(points, p);
    return sum;
  }
  double heat(const Columns& points, PointRange range) const override {
    double sum = 0;
    for (int p = range.first; p < range.last; ++p) sum -= flaws_.cooling * points(column::transfer_loss)[p];
    return sum;
  }
  StepBounds step_bounds(const Columns& points, PointRange range, int dim) const override {
    const double moving = fastest_point(points, range, dim);
    return {(1 + flaws_.speed + (moving > 0 ? flaws_.motion : 0)) * solid_speed + moving, 0};
  }
  Fault first_fault(const Columns&, PointRange) const override {
    if (flaws_.faulty < 0) return {};
    return {flaws_.faulty, "strain", 0, "flawed"};
  }

 private:
  struct State {
    Eigen::MatrixXd gradient, stress;
    double hoop_rate = 0, hoop = 0;
  };

  static State state(const Columns& points, int dim, int p) {
    State now{Eigen::MatrixXd(dim, dim), Eigen::MatrixXd(dim, dim)};
    for (int k = 0; k < dim * dim; ++k) {
      now.gradient(k / dim, k % dim) = points(column::strain_rate, k)[p];
      now.stress(k / dim, k % dim) = points(column::strain, k)[p];
    }
    if (points.components(column::strain) == dim * dim) return now;
    now.hoop_rate = points(column::strain_rate, dim * dim)[p];
    now.hoop = points(column::strain, dim * dim)[p];
    return now;
  }
  static void set(Columns& points, const ColumnId& id, int p, const Eigen::MatrixXd& tensor, double hoop) {
    const int dim = static_cast<int>(tensor.rows());
    for (int k = 0; k < dim * dim; ++k) points(id, k)[p] = tensor(k / dim, k % dim);
    if (points.components(id) > dim * dim) points(id, dim * dim)[p] = hoop;
  }

  // Of the stress, and of that around an axis.
  std::pair<Eigen::MatrixXd, double> stress_rate(const State& now) const {
    const Eigen::MatrixXd spin = (now.gradient - now.gradient.transpose()) / 2;
    const Eigen::MatrixXd strain = (now.gradient + now.gradient.transpose()) / 2;
    Eigen::MatrixXd change = spin * now.stress - now.stress * spin + stiffness * strain;
    change(0, 0) += flaws_.spin * now.stress.norm() * spin.norm();
    return {change, stiffness * now.hoop_rate};
  }
  double stored_rate(const Columns& points, const State& now, int p) const {
    if (flaws_.cooling > 0) return points(column::volume)[p];
    const double size = now.stress.norm() + std::abs(now.hoop), rate = now.gradient.norm() + std::abs(now.hoop_rate);
    const double power = now.stress.cwiseProduct(now.gradient).sum() + now.hoop * now.hoop_rate;
    const Eigen::MatrixXd spin = (now.gradient - now.gradient.transpose()) / 2;
    return points(column::volume)[p] *
           (power + flaws_.energy * size * rate + flaws_.spin_energy * now.stress.norm() * spin.norm());
  }
  double energy(const Columns& points, int p) const {
    return flaws_.cooling > 0 ? points(column::volume)[p] : points(column::transfer_loss)[p];
  }

  SolidFlaws flaws_;
};

std::vector<MeasuredGate> gates_of_solid(const SolidFlaws& flaws) {
  MaterialEntry entry;
  entry.name = "flawed-solid";
  entry.parameters = [](const Material&) { return MaterialParameters{{"density", "kg/m^3", solid_density}}; };
  entry.make = [flaws](const std::map<std::string, double>&) { return std::make_shared<const FlawedSolid>(flaws); };
  return material_gates(entry);
}

}  // namespace

KnownAnswers material_answers() {
  KnownAnswers all;
  int number = 0;
  const auto add = [&](const std::string& row, const SolidFlaws& flaws, double exact,
                       const std::vector<std::string>& where = geometry_names()) {
    const std::vector<MeasuredGate> rows = gates_of_solid(flaws);
    for (const std::string& geometry : where) {
      const std::string id = row + "/" + geometry;
      all.push_back({std::to_string(number) + "." + id, reading(rows, id), exact});
    }
    ++number;
  };
  const std::vector<std::string> turning{"plane", "space"}, with_waves{"line", "plane", "space"};
  add("energy/derivative", {.energy = solid_flaw}, solid_flaw);
  add("energy/derivative", {.energy = -solid_flaw, .dissipative = true}, solid_flaw);
  add("energy/told", {.told = solid_flaw}, solid_flaw);
  add("energy/told", {.told = -solid_flaw}, solid_flaw);
  add("rates/advance", {.rate = solid_flaw}, solid_flaw);
  add("rates/advance", {.rate = -solid_flaw, .dissipative = true}, solid_flaw);
  add("frame/spin", {.spin = solid_flaw}, solid_flaw, turning);
  add("frame/spin", {.spin_energy = -solid_flaw}, solid_flaw, turning);
  add("speed/small-strains", {.speed = -solid_flaw}, solid_flaw, with_waves);
  add("speed/small-strains", {.speed = solid_flaw}, -solid_flaw, with_waves);
  add("speed/excess", {.speed = solid_flaw}, solid_flaw, with_waves);
  add("speed/motion", {.motion = solid_flaw}, solid_flaw);
  add("speed/motion", {.motion = -solid_flaw}, solid_flaw);
  add("entropy/production", {.against = solid_flaw}, solid_flaw / (1 + solid_flaw));
  add("entropy/production", {.against_hoop = solid_flaw}, solid_flaw, {"rings"});
  add("entropy/told", {.viscosity = 0.4, .heat_told = solid_flaw}, solid_flaw);
  add("entropy/told", {.viscosity = 0.4, .heat_told = -solid_flaw}, solid_flaw);
  add("entropy/heat", {.cooling = solid_flaw, .dissipative = true},
      0.01 * solid_flaw);  // in 0.01 s, as the gate strains
  // Stresses that are no number, and infinite ones, go unnamed; where all states are called faulty, good ones are, too.
  for (const auto& [geometry, components] : {std::pair{"line", 1}, {"plane", 4}, {"rings", 5}, {"space", 9}}) {
    add("faults/named", {}, 2 * components, {geometry});
    add("faults/named", {.faulty = 0}, 2 * components + 1, {geometry});
  }
  return all;
}

}  // namespace plumbline
