// What gates measure of points that pull at each other: of a material whose forces are wrong by known amounts, and of two blocks
// between whose points nothing pulls.
#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/parts/reading.hpp"
#include "cases/harness/parts/material_gates.hpp"
#include "cases/harness/parts/pair_gates.hpp"

namespace plumbline {
namespace {

constexpr double pull_flaw = 0.03;

// Springs to the origin of stiffness one, F = -x and E = |x|^2/2, of points with a volume of one; or forces that are no springs':
// along x alone, of a size that changes its sign from point to point, or across x.
enum class PullFlaw { energy, unbalanced, across };

class FlawedPull final : public Material {
 public:
  explicit FlawedPull(PullFlaw flaw) : flaw_(flaw) {}
  std::string name() const override { return "flawed-pull"; }
  StressMeasure measure() const override { return StressMeasure::point_force; }
  Store store() const override { return Store::elastic; }
  void add_columns(Columns& points, int dim) const override { points.add(column::strain, dim); }
  double advance(Columns&, PointRange, const MaterialContext&, double) const override { return 0; }
  std::vector<const ColumnId*> internal_variables(const MaterialContext&) const override { return {}; }
  std::vector<double> rates(const Columns&, const MaterialContext&) const override { return {}; }

  // The strain is where the points stand now: the energy is another where they have moved since.
  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    for (int p = range.first; p < range.last; ++p) {
      for (int d = 0; d < context.dim; ++d) {
        points(column::strain, d)[p] = points(column::position, d)[p];
        points(column::stress, d)[p] = -force(points, context.dim, p, d);
      }
    }
  }
  // Beside that of springs, |F| times the distance that all points have moved, up or down as the first of them goes along x.
  double stored_energy(const Columns& points, PointRange) const override {
    double energy = 0, forces = 0, moved = 0;
    const auto start = points.values(column::strain), now = points.values(column::position);
    for (std::size_t k = 0; k < now.size(); ++k) {
      energy += 0.5 * now[k] * now[k];
      forces += start[k] * start[k];
      moved += (now[k] - start[k]) * (now[k] - start[k]);
    }
    return energy + std::copysign(pull_flaw * std::sqrt(forces * moved), now[0] - start[0]);
  }
  StepBounds step_bounds(const Columns&, PointRange, int) const override { return {1, 0}; }
  Fault first_fault(const Columns&, PointRange) const override { return {}; }

 private:
  double force(const Columns& points, int dim, int p, int d) const {
    if (flaw_ == PullFlaw::energy) return -points(column::position, d)[p];
    if (flaw_ == PullFlaw::unbalanced) return d > 0 ? 0 : p % 2 == 0 ? 1 : -1;
    if (dim < 2 || d > 1) return 0;
    return d == 0 ? -points(column::position, 1)[p] : points(column::position, 0)[p];
  }

  PullFlaw flaw_;
};

double reading_of(PullFlaw flaw, const std::string& row) {
  MaterialEntry entry;
  entry.name = "flawed-pull";
  entry.parameters = [](const Material&) { return MaterialParameters{{"density", "kg/m^3", 1}}; };
  entry.make = [flaw](const std::map<std::string, double>&) { return std::make_shared<const FlawedPull>(flaw); };
  return reading(material_gates(entry), row);
}

}  // namespace

KnownAnswers pull_answers() {
  KnownAnswers all;
  for (const std::string where : {"line", "plane", "space"}) {
    all.push_back({"derivative." + where, reading_of(PullFlaw::energy, "energy/derivative/" + where), pull_flaw});
    // Five points one way, four the other.
    all.push_back({"balance." + where, reading_of(PullFlaw::unbalanced, "momentum/balance/" + where), 1.0 / 9});
  }
  // With S = sum x x^T and a quarter turn J of all x the moments are S J, and S J + J S = tr(S) J.
  all.push_back({"torque.plane", reading_of(PullFlaw::across, "frame/torque/plane"), std::numbers::sqrt2});

  // Blocks that nothing keeps apart pass through each other.
  ContactEntry none;
  none.name = "none";
  const std::vector<MeasuredGate> rows = pair_gates(none);
  for (const std::string where : {"line", "plane"}) {
    all.push_back({"approach." + where, reading(rows, "approach/" + where), 1});
    for (const std::string family : {"momentum/", "energy/", "release/"}) {
      all.push_back({family + where, reading(rows, family + where), 0});
    }
  }
  return all;
}

}  // namespace plumbline
