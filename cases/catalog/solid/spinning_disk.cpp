// A disk that turns steadily: stress without motion of its own.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "cases/catalog/solid/annulus_points.hpp"
#include "cases/catalog/solid/collision.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/description/solid_material.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/rotating_disk.hpp"

namespace plumbline::spinning_disk {
namespace {

// One struct for points and reference.
struct Disk : Parameters {
  reference::RotatingDiskProblem disk;
  double turns = 0;
  AnnulusLayout layout = nullptr;

  explicit Disk(Parameters given = {}) : Parameters(std::move(given)) {
    disk.plane = reference::PlaneState::strain;
    disk.radius = positive("radius", disk.radius, "m", "R");
    disk.youngs_modulus = positive("youngs_modulus", disk.youngs_modulus, "Pa", "E");
    disk.poisson = number(poisson_key(disk.poisson));
    disk.density = positive("initial_density", disk.density, "kg/m^3", "density");
    disk.angular_velocity = positive("angular_velocity", 1.5, "1/s", "ω");
    turns = positive("turns", 1, "1", "turns to the end");
    layout = annulus_layout(text(layout_key("cut")));
    text(material_key(true));
  }
};

class SpinningDisk final : public Problem {
 public:
  explicit SpinningDisk(const Settings& settings) : settings_(settings), at_(settings), exact_(at_.disk) {
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p) {
      start_.push_back({body.points(column::position, 0)[p], body.points(column::position, 1)[p]});
    }
  }

  double end_time() const override { return at_.turns * 2 * std::numbers::pi / std::abs(at_.disk.angular_velocity); }

  // In the steady state: moved outwards, stretched and turning.
  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    Body body = points();
    const double omega = at_.disk.angular_velocity;
    const bool affine = settings_.text("transfer") == "apic";
    if (affine) body.points.add(column::affine, 4);
    for (int p = 0; p < body.points.points(); ++p) {
      const auto [x, y] = start_[static_cast<std::size_t>(p)];
      const double r = std::hypot(x, y), grown = 1 + exact_.displacement(r).value / r;
      const auto [radial, hoop] = strains(r);
      body.points(column::position, 0)[p] = x * grown;
      body.points(column::position, 1)[p] = y * grown;
      body.points(column::velocity, 0)[p] = -omega * y * grown;
      body.points(column::velocity, 1)[p] = omega * x * grown;
      const double c = x / r, s = y / r, mixed = (radial - hoop) * c * s;
      const double f[] = {1 + radial * c * c + hoop * s * s, mixed, mixed, 1 + radial * s * s + hoop * c * c};
      const double spin[] = {0, -omega, omega, 0};
      for (int k = 0; k < 4; ++k) {
        body.points(column::deformation, k)[p] = f[k];
        if (affine) body.points(column::affine, k)[p] = spin[k];
      }
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Account& spin = simulation.ledger().angular_momentum[2];
    spin_change_ = larger(spin_change_, std::abs(spin.store() / spin.initial() - 1));
    if (simulation.time() < end_time() * static_cast<double>(seen_) / instants) return;
    while (end_time() * static_cast<double>(seen_) / instants <= simulation.time()) ++seen_;
    double error = 0, scale = 0;
    for (const ErrorSample& s : stress_errors(simulation)) {
      error += s.volume * s.error * s.error;
      scale += s.volume * s.scale * s.scale;
    }
    times_.push_back(simulation.time());
    errors_.push_back(std::sqrt(error / scale));
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("spin_change", spin_change_);
    archive("seen", seen_);
    archive("times", times_);
    archive("errors", errors_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const std::vector<ErrorSample> samples = stress_errors(simulation);
    std::vector<Measure> all = error_norms("stress", "Pa", samples);
    double sum = 0, worst = 0, bound = 0;
    for (const double error : errors_) {
      sum += error;
      worst = larger(worst, error);
    }
    for (const ErrorSample& s : samples) bound = larger(bound, s.bound);
    bound /= exact_.centre_stress().value;
    all.push_back(scalar_measure("stress.mean_error", sum / static_cast<double>(errors_.size()), 0, bound, "1"));
    all.push_back(scalar_measure("stress.worst_error", worst, 0, bound, "1"));
    const reference::Bounded centre = exact_.centre_stress();
    all.push_back(scalar_measure("centre_stress", centre_stress(simulation), centre.value, centre.bound, "Pa"));
    all.push_back(scalar_measure("angular_momentum_change", spin_change_, 0, 0, "1"));
    all.push_back(scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"));
    all.push_back(scalar_measure("energy_lost", 1 - energy_.kept(), 0, 0, "1"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", times_},
                       {"stress_error", "1", "error of the stress over the stress, root mean square", errors_}};
    return profile;
  }

 private:
  static constexpr int instants = 100;  // at which the stress is judged, evenly spaced

  // Hooke's law in plane strain.
  std::pair<double, double> strains(double r) const {
    const double nu = at_.disk.poisson, plane = nu / (1 - nu);
    const double modulus = at_.disk.youngs_modulus / (1 - nu * nu);
    const double radial = exact_.radial_stress(r).value, hoop = exact_.hoop_stress(r).value;
    return {(radial - plane * hoop) / modulus, (hoop - plane * radial) / modulus};
  }

  // Of all three components against the exact ones in the axes that turn with the point; the scale is the stress at the
  // centre.
  std::vector<ErrorSample> stress_errors(const Simulation& simulation) const {
    const Body& body = simulation.scene().bodies.front();
    std::vector<ErrorSample> samples;
    for (int p = 0; p < body.points.points(); ++p) {
      const auto [x, y] = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      const reference::Bounded radial = exact_.radial_stress(std::hypot(x, y)),
                               hoop = exact_.hoop_stress(std::hypot(x, y));
      const double px = body.points(column::position, 0)[p], py = body.points(column::position, 1)[p];
      const double r = std::hypot(px, py), c = px / r, s = py / r, mixed = (radial.value - hoop.value) * c * s;
      const double exact[] = {radial.value * c * c + hoop.value * s * s, mixed, mixed,
                              radial.value * s * s + hoop.value * c * c};
      double square = 0;
      for (int k = 0; k < 4; ++k) square += std::pow(body.points(column::stress, k)[p] - exact[k], 2);
      samples.push_back({body.points(column::volume)[p], std::sqrt(square), std::hypot(radial.value, hoop.value),
                         radial.bound + hoop.bound});
    }
    return samples;
  }

  // Mean of (sigma_xx + sigma_yy)/2 within a quarter of the radius, less what it is exactly off the centre's there:
  // (sigma_r + sigma_theta)/2 falls with r^2, and r^2 has the mean a^2/2 in a disk of radius a.
  double centre_stress(const Simulation& simulation) const {
    const Body& body = simulation.scene().bodies.front();
    double sum = 0, volume = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const auto [x, y] = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      const double r = std::hypot(x, y);
      if (r > 0.25 * at_.disk.radius) continue;
      const double off = exact_.centre_stress().value -
                         0.5 * (exact_.radial_stress(r).value + exact_.hoop_stress(r).value);
      const double v = body.points(column::volume)[p];
      sum += v * (0.5 * (body.points(column::stress, 0)[p] + body.points(column::stress, 3)[p]) + off);
      volume += v;
    }
    return sum / volume;
  }

  GridSpec grid() const {
    GridSpec grid;
    grid.dim = 2;
    grid.h = at_.disk.radius / settings_.number("cells");
    const int half = settings_.integer("cells") + 3;
    grid.cells = {2 * half, 2 * half, 1};
    // The axis at no special place of a cell.
    grid.origin = {-(half - 0.3) * grid.h, -(half - 0.4) * grid.h, 0};
    return grid;
  }

  Body points() const {
    const reference::RotatingDiskProblem& disk = at_.disk;
    auto material = std::make_shared<NeoHookean>();
    material->youngs_modulus = disk.youngs_modulus;
    material->poissons_ratio = disk.poisson;
    material->density = disk.density;
    return at_.layout("disk", chosen_material(settings_, material), {0, disk.radius}, disk.density,
                      settings_.integer("ppc"), grid());
  }

  Settings settings_;
  Disk at_;
  reference::RotatingDisk exact_;
  std::vector<std::array<double, 2>> start_;  // X by the point's number
  EnergyWatch energy_;
  double spin_change_ = 0;
  long seen_ = 0;
  std::vector<double> times_, errors_;
};

std::vector<StudyPlan> studies() {
  return {study("default", "default", "One turn. The step's error in the angular momentum is of second order.", {4})
              .in_full({4, 5, 6, 8, 11})};
}

std::vector<CaseGate> gates() {
  return {gate("default/centre-stress-4", value_at("centre_stress", 4), between(0.95 * 0.964286, 1.05 * 0.964286),
               requirement("within 5 % of (3 + nu')/8 rho omega^2 R^2, the mean over a sixteenth of the area: stresses "
                           "that the maps make up stay below 5e-6 of E")),
          gate("default/angular-momentum-4", value_at("angular_momentum_change", 4), at_most(1e-3),
               requirement("a thousandth over a turn at four cells along the radius: the spin would halve in seven "
                           "hundred turns")),
          recorded("default/stress-4", value_at("stress.mean_error", 4), 0.11376, 0.1, "2026-11-21 a96ec71",
                   "how far the stress of single points scatters; nothing else should move it"),
          gate("default/angular-momentum-order", fitted_order_of("angular_momentum_change"), at_least(1.8),
               theory("the step is of second order and follows h; 0.2 for coarse meshes"))
              .in(Tier::full)};
}

Case spinning_disk() {
  return {.name = "spinning-disk",
          .kind = Kind::solid,
          .keys = Disk().keys(),
          .sets = {{"cells", 8.0}},
          .york_step = courant_number(0.2),
          .problem = run_of<SpinningDisk>,
          .studies = studies(),
          .gates = gates(),
          .levels = {4, 5, 6, 8, 11}};
}
PLUMBLINE_CASE(spinning_disk);

}  // namespace
}  // namespace plumbline::spinning_disk
