#include "cases/catalog/solid/elastic_plastic_bar.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/schemes.hpp"
#include "kernel/materials/j2_plasticity.hpp"

namespace plumbline {
namespace {

using reference::Bounded;
using reference::ElasticPlasticState;

// What a point holds, by its columns.
struct PointState {
  double velocity, stress, lateral_stress, plastic_strain;
};

class ElasticPlasticBarProblem final : public Problem {
 public:
  ElasticPlasticBarProblem(const ElasticPlasticBar& bar, const Settings& settings)
      : settings_(settings),
        bar_(bar),
        exact_(bar.impact) {
    const Body body = points();
    start_.assign(body.points(column::position), body.points(column::position) + body.points.points());
  }

  double end_time() const override { return bar_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    scene.bodies.push_back(points());
    scene.pistons = {
        {.direction = 0, .side = 0, .position = 0, .velocity = bar_.impact.velocity, .rise = bar_.impact.rise_time}};
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    const Ledger& ledger = simulation.ledger();
    for (int p = 0; p < points.points(); ++p) violation_ = larger(violation_, violation(points, p));
    const double work = std::abs(ledger.energy.flow(Flow::walls));
    heat_off_ = larger(heat_off_, std::abs(ledger.stores.internal - plastic_heat(points) - ledger.viscous) / work);
    energy_off_ = larger(energy_off_, std::abs(ledger.energy.residual()) / work);
  }
  void history(Archive& archive) override {
    archive("violation", violation_);
    archive("heat_off", heat_off_);
    archive("energy_off", energy_off_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    const double time = simulation.time();
    std::vector<Measure> all;
    const auto add = [&](const std::string& name, const std::string& unit, double PointState::*computed,
                         Bounded ElasticPlasticState::*exact) {
      std::vector<FieldSample> samples;
      for (int p = 0; p < body.points.points(); ++p) {
        const Bounded right = exact_.state(start_of(body, p), time).*exact;
        samples.push_back({body.points(column::volume)[p], body.points(column::position)[p],
                           state(body.points, p).*computed, right.value, right.bound});
      }
      for (Measure& m : field_norms(name, unit, samples)) all.push_back(std::move(m));
    };
    add("velocity", "m/s", &PointState::velocity, &ElasticPlasticState::velocity);
    add("stress", "Pa", &PointState::stress, &ElasticPlasticState::stress);
    add("lateral_stress", "Pa", &PointState::lateral_stress, &ElasticPlasticState::lateral_stress);
    add("plastic_strain", "1", &PointState::plastic_strain, &ElasticPlasticState::plastic_strain);
    add_plateaus(body, time, all);
    const Bounded heat = exact_.heat(time);
    all.push_back(scalar_measure("plastic_heat", plastic_heat(body.points), heat.value, heat.bound, "J/m^2"));
    all.push_back(share_measure("yield_violation", violation_));
    all.push_back(share_measure("heat_off", heat_off_));
    all.push_back(share_measure("energy_off", energy_off_));
    const Account& energy = simulation.ledger().energy;
    all.push_back(share_measure("unlike_power", std::abs(energy.flow(Flow::constitutive) / energy.flow(Flow::walls))));
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    Profile profile;
    profile.abscissa = "x";
    profile.columns = {{"x", "m", "place in the undeformed plate", {}},
                       {"stress", "Pa", "axial stress", {}},
                       {"stress_reference", "Pa", "exact axial stress", {}},
                       {"lateral_stress", "Pa", "lateral stress", {}},
                       {"lateral_stress_reference", "Pa", "exact lateral stress", {}},
                       {"velocity", "m/s", "velocity", {}},
                       {"velocity_reference", "m/s", "exact velocity", {}},
                       {"plastic_strain", "1", "plastic strain", {}},
                       {"plastic_strain_reference", "1", "exact plastic strain", {}}};
    const Body& body = simulation.scene().bodies.front();
    std::vector<int> place(start_.size());
    for (int p = 0; p < body.points.points(); ++p) place[number_of(body, p)] = p;
    for (const int p : place) {
      const PointState here = state(body.points, p);
      const ElasticPlasticState right = exact_.state(start_of(body, p), simulation.time());
      const double row[] = {start_of(body, p),          here.stress,   right.stress.value,   here.lateral_stress,
                            right.lateral_stress.value, here.velocity, right.velocity.value, here.plastic_strain,
                            right.plastic_strain.value};
      for (std::size_t c = 0; c < profile.columns.size(); ++c) profile.columns[c].values.push_back(row[c]);
    }
    return profile;
  }

 private:
  static std::size_t number_of(const Body& body, int p) {
    return static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
  }
  double start_of(const Body& body, int p) const { return start_[number_of(body, p)]; }

  // The stress on a plane across x is all there is, the viscous one included; the lateral one is without it.
  static double elastic_stress(const Columns& points, int p) {
    return points(column::stress)[p] + points(column::viscous_pressure)[p];
  }
  static PointState state(const Columns& points, int p) {
    const double axial = elastic_stress(points, p), lateral = -0.5 * (3 * points(column::pressure)[p] + axial);
    return {points(column::velocity)[p], points(column::stress)[p], lateral, points(column::plastic_strain)[p]};
  }
  // Of Kirchhoff's stress: q is 3/2 of the deviation of the axial stress from the mean.
  double violation(const Columns& points, int p) const {
    const double deviation = elastic_stress(points, p) + points(column::pressure)[p];
    const double q = 1.5 * std::abs(deviation) * points(column::deformation)[p];
    const double yield = bar_.impact.yield_stress;
    return (q - yield - bar_.impact.hardening_modulus * points(column::plastic_strain)[p]) / yield;
  }
  double plastic_heat(const Columns& points) const {
    double sum = 0;
    for (int p = 0; p < points.points(); ++p) sum += points(column::mass)[p] * points(column::plastic_strain)[p];
    return sum * bar_.impact.yield_stress / bar_.impact.density;
  }

  // Of the points whose particles stand within, the value that is furthest from the exact one.
  double furthest(const Body& body, double low, double high, double PointState::*value, double exact) const {
    double found = std::nan("");
    for (int p = 0; p < body.points.points(); ++p) {
      if (start_of(body, p) < low || start_of(body, p) > high) continue;
      const double here = state(body.points, p).*value;
      if (!(std::abs(here - exact) <= std::abs(found - exact))) found = here;
    }
    return found;
  }
  void add_plateaus(const Body& body, double time, std::vector<Measure>& all) const {
    const auto& impact = bar_.impact;
    const double end_of_rise = time - impact.rise_time;
    const double yields = time - impact.rise_time * exact_.limit_velocity().value / impact.velocity;
    const double plateau = exact_.plastic_speed().value * end_of_rise;
    const double behind = exact_.plastic_speed().value * yields, ahead = exact_.elastic_speed().value * yields;
    const auto add = [&](const std::string& name, const std::string& unit, double low, double high,
                         double PointState::*value, const Bounded& exact) {
      all.push_back(
          scalar_measure(name, furthest(body, low, high, value, exact.value), exact.value, exact.bound, unit));
    };
    const double low = 0.25 * plateau, high = 0.5 * plateau;
    const ElasticPlasticState right = exact_.plateau();
    add("plateau_stress", "Pa", low, high, &PointState::stress, right.stress);
    add("plateau_lateral_stress", "Pa", low, high, &PointState::lateral_stress, right.lateral_stress);
    add("plateau_plastic_strain", "1", low, high, &PointState::plastic_strain, right.plastic_strain);
    const double width = ahead - behind;
    add("precursor_stress", "Pa", behind + 0.4 * width, behind + 0.6 * width, &PointState::stress,
        exact_.precursor().stress);
  }

  GridSpec grid() const {
    constexpr int margin = 2;  // cells beyond either end: the plate is compressed by less than one
    GridSpec grid;
    grid.h = bar_.length / settings_.number("cells");
    grid.cells[0] = settings_.integer("cells") + 2 * margin;
    grid.origin[0] = -margin * grid.h;
    return grid;
  }
  Body points() const {
    auto material = std::make_shared<J2Plasticity>();
    material->youngs_modulus = bar_.impact.youngs_modulus;
    material->poissons_ratio = bar_.impact.poissons_ratio;
    material->density = bar_.impact.density;
    material->yield_stress = bar_.impact.yield_stress;
    material->hardening_modulus = bar_.impact.hardening_modulus;
    material->viscosity_linear = bar_.viscosity_linear;
    return fill_solid("plate", material, {.low = {0, 0, 0}, .high = {bar_.length, 0, 0}}, bar_.impact.density,
                      settings_.integer("ppc"), grid());
  }

  Settings settings_;
  ElasticPlasticBar bar_;
  reference::ElasticPlasticImpact exact_;
  std::vector<double> start_;  // X by the point's number
  double violation_ = 0, heat_off_ = 0, energy_off_ = 0;
};

}  // namespace

std::unique_ptr<Problem> elastic_plastic_bar_problem(const ElasticPlasticBar& bar, const Settings& settings) {
  return std::make_unique<ElasticPlasticBarProblem>(bar, settings);
}

}  // namespace plumbline
