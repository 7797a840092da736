#include "cases/catalog/solid/taylor_rod.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/catalog/solid/rod_points.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "reference/plate_impact.hpp"

namespace plumbline {
namespace {

// Published, of the rod as TaylorRod has it unless said otherwise: the middle of the figures in taylor-bar.md, and half of their
// spread. Of other rods there is none.
struct Published {
  double length = 0, length_bound = 0, radius = 0, radius_bound = 0;  // m
};
Published published(TaylorRod rod) {
  rod.viscosity_linear = TaylorRod().viscosity_linear;
  if (rod != TaylorRod()) return {};
  return {21.45e-3, 0.03e-3, 7.20e-3, 0.09e-3};
}

class TaylorRodProblem final : public Problem {
 public:
  TaylorRodProblem(const TaylorRod& rod, const Settings& settings)
      : settings_(settings),
        rod_(rod),
        face_({rod.youngs_modulus, rod.poissons_ratio, rod.density, rod.yield_stress, rod.hardening_modulus,
               rod.velocity}) {
    if (rod_.length < grid().h) {
      throw UsageError(
          "length", to_text(rod_.length), fmt::format("[{:g}, inf) m", grid().h), {},
          fmt::format("length={:g} m: the rod is shorter than a cell, radius/cells = {:g} m", rod_.length, grid().h));
    }
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p)
      start_.push_back({body.points(column::position, 0)[p], body.points(column::position, 1)[p]});
    plastic_.assign(start_.size(), 0);
  }

  double end_time() const override { return rod_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    scene.bodies.push_back(points());
    Columns& all = scene.bodies.front().points;
    std::fill_n(all(column::velocity, 1), all.points(), -rod_.velocity);
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const Body& body = simulation.scene().bodies.front();
    const Ledger& ledger = simulation.ledger();
    const double start = ledger.initial_stores.total();
    const RodPoints at(body, law());
    for (int p = 0; p < body.points.points(); ++p) {
      double& before = plastic_[number_of(body, p)];
      const double now = body.points(column::plastic_strain)[p], beyond = at.beyond_yield(p);
      yield_off_ = larger(yield_off_, now > before ? std::abs(beyond) : beyond);
      flow_back_ = larger(flow_back_, before - now);
      volume_off_ = larger(volume_off_, at.volume_off(p));
      before = now;
    }
    const RodSums sums = at.sums();
    store_off_ = larger(store_off_, std::abs(ledger.stores.elastic - sums.elastic - sums.hardening) / start);
    const double heat = ledger.stores.internal;
    heat_off_ = larger(heat_off_, std::abs(heat - sums.heat - ledger.viscous) / start);
    heat_fall_ = larger(heat_fall_, (heat_ - heat) / start);
    heat_ = heat;
    energy_off_ = larger(energy_off_, std::abs(ledger.energy.residual()) / start);
    const Account& along = ledger.momentum[1];
    momentum_off_ = larger(momentum_off_,
                           std::abs((along.store() - along.initial() - along.flow(Flow::walls)) / along.initial()));
  }
  void history(Archive& archive) override {
    archive("plastic", plastic_);
    archive("yield_off", yield_off_);
    archive("flow_back", flow_back_);
    archive("store_off", store_off_);
    archive("volume_off", volume_off_);
    archive("heat", heat_);
    archive("heat_off", heat_off_);
    archive("heat_fall", heat_fall_);
    archive("energy_off", energy_off_);
    archive("momentum_off", momentum_off_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    const Ledger& ledger = simulation.ledger();
    const RodPoints at(body, law());
    const RodShape shape = at.shape();
    const RodSums sums = at.sums();
    const double start = ledger.initial_stores.total();
    const Published then = published(rod_);
    const int across = settings_.integer("cells") * settings_.integer("ppc");
    const double estimate = rod_.length *
                            std::exp(-rod_.density * rod_.velocity * rod_.velocity / 2 / rod_.yield_stress);
    std::vector<Measure> all{scalar_measure("length", shape.length, then.length, then.length_bound, "m"),
                             scalar_measure("radius", shape.radius, then.radius, then.radius_bound, "m"),
                             scalar_measure("estimate", estimate, shape.length, 0, "m"),
                             scalar_measure("plastic_strain", at.largest_plastic_strain(), 0, 0, "1"),
                             share_measure("lines_kept", at.mean_of_lines() / least_of_lines(), 1),
                             share_measure("lines_excess", at.excess_of_lines()),
                             share_measure("yield_off", yield_off_),
                             share_measure("flow_back", flow_back_),
                             share_measure("volume_off", volume_off_),
                             share_measure("store_off", store_off_),
                             share_measure("shared_off", at.shared_off()),
                             share_measure("heat_off", heat_off_),
                             share_measure("heat_fall", heat_fall_),
                             share_measure("energy_off", energy_off_),
                             share_measure("momentum_off", momentum_off_),
                             share_measure("wall_work", std::abs(ledger.energy.flow(Flow::walls)) / start),
                             share_measure("start", std::abs(ledger.initial_stores.kinetic / energy() - 1)),
                             share_measure("kinetic", ledger.stores.kinetic / start),
                             share_measure("elastic", sums.elastic / start),
                             share_measure("heat", ledger.stores.internal / start),
                             share_measure("hardening", sums.hardening / start),
                             share_measure("lost", 1 - ledger.stores.total() / start),
                             share_measure("plastic_work", (sums.heat + sums.hardening) / start),
                             scalar_measure("alternation", at.alternation(across) / rod_.yield_stress, 0, 0, "1")};
    add_face(body, simulation.time(), all);
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    Profile profile;
    profile.abscissa = "z";
    profile.columns = {{"z", "m", "height over the wall", {}},
                       {"radius", "m", "how far the rod reaches there", {}},
                       {"plastic_strain_axis", "1", "plastic strain at the axis", {}},
                       {"plastic_strain_largest", "1", "largest plastic strain at the height", {}}};
    for (const RodSlice& slice : RodPoints(simulation.scene().bodies.front(), law()).slices(grid().h)) {
      const double row[] = {slice.height, slice.radius, slice.axis, slice.largest};
      for (std::size_t c = 0; c < profile.columns.size(); ++c) profile.columns[c].values.push_back(row[c]);
    }
    return profile;
  }

 private:
  static std::size_t number_of(const Body& body, int p) {
    return static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
  }
  RodLaw law() const {
    const double e = rod_.youngs_modulus, nu = rod_.poissons_ratio;
    return {e / (3 * (1 - 2 * nu)), e / (2 * (1 + nu)), rod_.density, rod_.yield_stress, rod_.hardening_modulus};
  }

  // rho V^2/2 of the undeformed volume, J per radian.
  double energy() const {
    return 0.25 * rod_.density * rod_.velocity * rod_.velocity * rod_.radius * rod_.radius * rod_.length;
  }

  // Of all work that flow can be given, rho V^2/2 a volume, the mean strain is at most that of an even one, since Y a + H a^2/2 is
  // convex; and the mean stretch of lines is at least the exponential of the mean of its logarithm, >= -a.  [Taylor 1]
  double least_of_lines() const {
    const double y = rod_.yield_stress, h = rod_.hardening_modulus,
                 work = 0.5 * rod_.density * rod_.velocity * rod_.velocity;
    return std::exp(-2 * work / (y + std::sqrt(y * y + 2 * h * work)));
  }

  // Nothing that the rod's side sends has come to the middle of the face by R/(2 c_e): it is struck as a plate is.
  void add_face(const Body& body, double time, std::vector<Measure>& all) const {
    const Columns& points = body.points;
    const RodPoints at(body, law());
    const bool undisturbed = time <= 0.5 * rod_.radius / face_.elastic_speed().value;
    const double wave = face_.plastic_speed().value * time;
    std::vector<FieldSample> stress, velocity, plastic;
    double sum = 0, volume = 0;
    for (int p = 0; undisturbed && p < points.points(); ++p) {
      const std::array<double, 2>& from = start_[number_of(body, p)];
      if (from[0] > 0.2 * rod_.radius) continue;
      const reference::PlateState exact = face_.state(from[1], time);
      const auto add = [&](std::vector<FieldSample>& to, double computed, const reference::Bounded& right) {
        to.push_back({points(column::volume)[p], from[1], computed, right.value, right.bound});
      };
      add(stress, at.axial_stress(p), exact.stress);
      add(velocity, rod_.velocity + points(column::velocity, 1)[p], exact.velocity);
      add(plastic, points(column::plastic_strain)[p], exact.plastic_strain);
      if (from[1] < 0.25 * wave || from[1] > 0.5 * wave) continue;
      sum += points(column::volume)[p] * at.axial_stress(p);
      volume += points(column::volume)[p];
    }
    const auto add_norm = [&](const std::string& name, const std::string& unit,
                              const std::vector<FieldSample>& samples) {
      Measure norm = field_norms(name, unit, samples).front();
      if (!undisturbed) norm.error = norm.scale = std::nan(""), norm.reference_bound = 0;
      all.push_back(norm);
    };
    add_norm("face_stress", "Pa", stress);
    add_norm("face_velocity", "m/s", velocity);
    add_norm("face_plastic_strain", "1", plastic);
    const reference::Bounded right = face_.plateau().stress;
    all.push_back(scalar_measure("face_plateau", sum / volume, right.value, right.bound, "Pa"));
  }

  GridSpec grid() const {
    constexpr int margin = 3;
    GridSpec grid;
    grid.dim = 2;
    grid.axisymmetric = true;
    grid.h = rod_.radius / settings_.number("cells");
    grid.cells = {3 * settings_.integer("cells") + margin, whole(std::ceil(rod_.length / grid.h)) + margin, 1};
    grid.walls[0] = {Wall::symmetry, Wall::free};
    grid.walls[1] = {Wall::symmetry, Wall::free};
    return grid;
  }
  std::shared_ptr<J2Plasticity> material() const {
    auto material = std::make_shared<J2Plasticity>();
    material->youngs_modulus = rod_.youngs_modulus;
    material->poissons_ratio = rod_.poissons_ratio;
    material->density = rod_.density;
    material->yield_stress = rod_.yield_stress;
    material->hardening_modulus = rod_.hardening_modulus;
    material->viscosity_linear = rod_.viscosity_linear;
    return material;
  }
  Body points() const {
    const double spacing = grid().h / settings_.integer("ppc");
    return rod_points(material(), rod_.length, rod_.radius, spacing, rod_.density);
  }

  Settings settings_;
  TaylorRod rod_;
  reference::PlateImpact face_;
  std::vector<std::array<double, 2>> start_;  // r, z at rest by the point's number
  std::vector<double> plastic_;               // alpha after the last step, by the same
  double yield_off_ = -1, flow_back_ = 0, volume_off_ = 0, store_off_ = 0, heat_ = 0, heat_off_ = 0, heat_fall_ = 0,
         energy_off_ = 0, momentum_off_ = 0;
};

}  // namespace

std::unique_ptr<Problem> taylor_rod_problem(const TaylorRod& rod, const Settings& settings) {
  return std::make_unique<TaylorRodProblem>(rod, settings);
}

}  // namespace plumbline
