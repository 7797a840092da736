#include "cases/catalog/coupled/airbag_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "reference/airbag_lumped.hpp"
#include "reference/argument.hpp"

namespace plumbline {
namespace {

constexpr double probe_modulus = 5e7, probe_poisson = 0.3, probe_height = 0.08;  // York 6.3.1, A.4.8
constexpr int probe_ppc = 2;                                                     // and direction
constexpr double whole_turn = 2 * std::numbers::pi;

// Bounds from outside the run: what a bag as long along the meridian as this ever got does at most to the probe.
struct Limits {
  double displacement = 0, rebound = 0;
};

// A number without a reference.
Measure reported(std::string name, double value, std::string unit) {
  Measure measure;
  measure.name = std::move(name);
  measure.scale = std::abs(value);
  measure.value = value;
  measure.unit = std::move(unit);
  return measure;
}

class AirbagRun final : public Problem {
 public:
  AirbagRun(const AirbagSpec& defaults, const Settings& settings)
      : settings_(settings),
        at_(defaults, settings),
        grid_(airbag_grid(settings.integer("cells"))) {
    if (settings.text("membrane.strain") != "segments") {
      throw UsageError("membrane.strain", settings.text("membrane.strain"), "segments", {"segments"},
                       "membrane.strain=accumulated knows no hoop strain: a bag of revolution needs segments");
    }
  }

  double end_time() const override { return at_.spec.end_time; }

  Scene scene() const override { return with_probe(blown_up()); }
  Scene unprepared() const override { return with_probe(flat()); }
  double preparation() const override { return blowing_time; }

  void observe(const Simulation& simulation) override {
    const auto& bodies = simulation.scene().bodies;
    if (history_.empty()) start_elastic_ = whole_turn * simulation.ledger().initial_stores.elastic;
    const BodyMotion probe = motion_of(bodies[2], 2);
    const EnergyStores& stores = simulation.ledger().stores;
    const double volume = enclosed_volume(bodies[1]);
    const double pressure = (bag_gamma - 1) * stores.internal / volume;  // [York 4.4]
    meridian_ = std::max(meridian_, length(outline(bodies[1], {})));
    history_.push_back({simulation.time(), start_height() + 0.5 * probe_height - probe.position[1], probe.velocity[1],
                        pressure - at_.pressures.outside, whole_turn * volume, whole_turn * stores.kinetic,
                        whole_turn * stores.elastic, highest_point(bodies[1], 0)});
  }
  void history(Archive& archive) override {
    archive("start_elastic", start_elastic_);
    archive("meridian", meridian_);
    archive("rows", history_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const auto& bodies = simulation.scene().bodies;
    const auto deepest = std::max_element(history_.begin(), history_.end(),
                                          [](const auto& a, const auto& b) { return a[1] < b[1]; });
    const auto highest = std::max_element(history_.begin(), history_.end(),
                                          [](const auto& a, const auto& b) { return a[3] < b[3]; });
    const auto widest = std::max_element(history_.begin(), history_.end(),
                                         [](const auto& a, const auto& b) { return a[7] < b[7]; });
    const Curve polygon = outline(bodies[1], {});
    int escaped = 0;
    double gas_volume = 0;
    const Columns& gas = bodies[0].points;
    for (int p = 0; p < gas.points(); ++p) {
      gas_volume += gas(column::volume)[p];
      if (!inside(polygon, gas(column::position)[p], gas(column::position, 1)[p])) ++escaped;
    }
    const double rebound = motion_of(bodies[2], 2).velocity[1];
    const double apart = lowest_point(bodies[2], 1) - highest_point(bodies[1], 1);
    std::vector<Measure> all{reported("max_displacement", (*deepest)[1], "m"),
                             reported("time_of_max", (*deepest)[0], "s"),
                             reported("rebound_velocity", rebound, "m/s"),
                             reported("energy_returned", rebound * rebound / (at_.spec.speed * at_.spec.speed), "1"),
                             reported("peak_pressure", (*highest)[3], "Pa"),
                             reported("escaped_points", escaped, "1"),
                             scalar_measure("volume_ratio", gas_volume / enclosed(polygon, true), 1, 0, "1"),
                             reported("apart", apart, "m"),
                             reported("largest_radius", (*widest)[7], "m"),
                             reported("start_height", start_height(), "m"),
                             reported("start_volume", start_volume(), "m^3")};
    if (const auto limits = this->limits()) {
      all.push_back(reported("displacement_limit", limits->displacement, "m"));
      all.push_back(reported("rebound_limit", limits->rebound, "m/s"));
    }
    return all;
  }

  Profile profile(const Simulation&) const override {
    return history_profile({{"time", "s", "time", {}},
                            {"displacement", "m", "displacement of the probe since impact", {}},
                            {"probe_velocity", "m/s", "velocity of the probe, upwards", {}},
                            {"pressure", "Pa", "mean pressure of the gas above that outside", {}},
                            {"volume", "m^3", "volume of the bag", {}},
                            {"kinetic_energy", "J", "kinetic energy of all", {}},
                            {"elastic_energy", "J", "strain energy of all", {}},
                            {"widest", "m", "largest radius of the bag", {}}},
                           history_);
  }

 private:
  double start_height() const { return highest_point(blown_up().skin, 1); }  // of the pole, where the probe is first
  double start_volume() const { return whole_turn * enclosed_volume(blown_up().skin); }

  Scene with_probe(const Bag& bag) const {
    Scene scene;
    scene.grid = grid_;
    scene.bodies = {bag.gas, bag.skin, airbag_probe(at_.spec, grid_, probe_ppc, highest_point(bag.skin, 1))};
    if (density_method(settings_.text("density")) == DensityMethod::grid) {
      scene.bodies[0].enclosure = Enclosure{"bag", {}};
    }
    scene.bodies[1].load = [outside = at_.pressures.outside, tethered = at_.tethered, tether = bag.tether](
                               double, Columns& points, std::span<const int>) {
      for (int d = 0; d < 2; ++d) std::fill_n(points(column::body_force, d), points.points(), 0.0);
      add_outside_pressure(points, outside);
      if (tethered) add_tether(points, tether);
    };
    Columns& probe = scene.bodies[2].points;
    std::fill_n(probe(column::velocity, 1), probe.points(), -at_.spec.speed);
    scene.bodies[2].field = "probe";
    apply_choices(settings_, scene);
    return scene;
  }

  // The energy that the skin held at first counts with the probe's; for the rebound so does what the gas can do
  // besides, at most its excess pressure times the volume that the skin could open. None where the model has no answer.
  std::optional<Limits> limits() const {
    const AirbagSpec& probe = at_.spec;
    const auto& [inside, outside] = at_.pressures;
    const double energy = 0.5 * probe.mass * probe.speed * probe.speed + start_elastic_;
    try {
      const reference::AirbagLumped lumped({.mass = probe.mass,
                                            .probe_radius = probe.radius,
                                            .speed = std::sqrt(2 * energy / probe.mass),
                                            .meridian = meridian_,
                                            .height = start_height(),
                                            .gamma = bag_gamma,
                                            .pressure = inside,
                                            .ambient_pressure = outside,
                                            .gas_volume = start_volume()});
      const double opened = lumped.bag().free_volume().value - start_volume();
      const double swelling = (inside - outside) * std::max(0.0, opened);
      return Limits{lumped.displacement_limit().value, std::sqrt(2 * (energy + swelling) / probe.mass)};
    } catch (const reference::ParameterError&) {
      return std::nullopt;
    }
  }

  Bag flat() const {
    return unstretched_bag(grid_, settings_.integer("ppc"), settings_.number("membrane.ppc"), at_.spec.crown,
                           at_.pressures, chosen_gas(settings_, bag_gamma));
  }
  // Computed where it is first needed: by far the most that a problem of this case costs.
  const Bag& blown_up() const {
    if (!blown_up_) blown_up_ = inflate(flat(), grid_, at_.pressures);
    return *blown_up_;
  }

  Settings settings_;
  AirbagParameters at_;
  GridSpec grid_;
  mutable std::optional<Bag> blown_up_;
  double start_elastic_ = 0, meridian_ = 0;
  std::vector<std::array<double, 8>> history_;
};

}  // namespace

std::function<std::unique_ptr<Problem>(const Settings&)> airbag_run(const AirbagSpec& defaults) {
  return [defaults](const Settings& settings) { return std::make_unique<AirbagRun>(defaults, settings); };
}

Body airbag_probe(const AirbagSpec& spec, const GridSpec& grid, int ppc, double face) {
  auto elastic = std::make_shared<LinearElastic>();
  elastic->youngs_modulus = probe_modulus;
  elastic->poissons_ratio = probe_poisson;
  elastic->density = spec.mass / (std::numbers::pi * spec.radius * spec.radius * probe_height);
  const double wanted = grid.h / ppc;
  const int across = std::max(1, whole(std::round(spec.radius / wanted)));
  const int up = std::max(1, whole(std::round(probe_height / wanted)));
  const double wide = spec.radius / across, high = probe_height / up;
  Body body = make_body("probe", elastic, across * up, 2, true);
  body.spacing = std::sqrt(wide * high);
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i) {
      const int p = j * across + i;
      const double r = (i + 0.5) * wide;
      body.points(column::position)[p] = r;
      body.points(column::position, 1)[p] = face + (j + 0.5) * high;
      body.points(column::volume)[p] = r * wide * high;
      body.points(column::mass)[p] = elastic->density * r * wide * high;
    }
  }
  return body;
}

}  // namespace plumbline
