// A flat ring of membrane, clamped at both rims of which one is turned, wrinkles everywhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/surface_case.hpp"
#include "cases/catalog/membrane/twisted_ring.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

class TwistedAnnulusRun final : public Problem {
 public:
  explicit TwistedAnnulusRun(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        ring_(at_, settings_.number("cells") * std::sqrt(settings_.number("ppc"))) {
    const Body start = scene().bodies.front();
    for (int p = 0; p < start.points.points(); ++p) start_.push_back(ring_.seat(start.points, p));
    first_ = forces_of(start);
  }

  double end_time() const override { return at_.end * at_.size / at_.speed(); }

  Scene scene() const override {
    Scene scene;
    scene.grid = surface_grid(at_, settings_, at_.size, 0);
    Body body = surface_body("ring", at_.choice, ring_.points(), scene.grid.h,
                             [this](const Columns& points) { return ring_.images(points, at_.rows); });
    const auto none = [](double, const Columns&) { return 0.0; };
    press(body, at_, none, at_.drag * at_.speed() / at_.size);
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    const RingForces now = forces_of(simulation.scene().bodies.front());
    rows_.push_back({simulation.time(), now.torque, now.energy});
  }
  void history(Archive& archive) override { archive("rows", rows_); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    std::vector<Measure> all;
    const auto add = [&](const std::string& prefix, const RingForces& forces) {
      const auto against = [&](const char* name, double value, const reference::Bounded& exact, const char* unit) {
        all.push_back(scalar_measure(prefix + name, value, exact.value, exact.bound, unit));
      };
      against("torque", forces.torque, ring_.exact().torque(), "N m");
      against("energy", forces.energy, ring_.exact().energy(), "J");
      all.push_back(share_measure(prefix + "uneven", forces.uneven));
      all.push_back(share_measure(prefix + "crooked", forces.crooked));
      all.push_back(share_measure(prefix + "across", forces.across));
    };
    add("start_", first_);
    add("", forces_of(body));
    std::vector<ErrorSample> radial, around, stress;
    for (int p = 0; p < body.points.points(); ++p) {
      const Seat& seat = start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
      const reference::AnnulusPoint& exact = ring_.exact_at(seat.ring);
      const double x = body.points(column::position, 0)[p], y = body.points(column::position, 1)[p];
      const double volume = body.points(column::volume)[p], r = std::hypot(x, y), should = exact.radius.value;
      const double turned = std::remainder(std::atan2(y, x) - seat.angle, 2 * std::numbers::pi);
      radial.push_back({volume, std::abs(r - should), std::abs(should - ring_.radius(seat.ring)), exact.radius.bound});
      around.push_back({volume, should * std::abs(turned - exact.turned.value), should * std::abs(exact.turned.value),
                        should * exact.turned.bound});
      stress.push_back({volume, std::abs(largest_stress(body.points, p, at_.choice.law) - exact.stress.value),
                        exact.stress.value, exact.stress.bound});
    }
    const auto append = [&](const char* name, const char* unit, const std::vector<ErrorSample>& samples) {
      for (Measure& norm : error_norms(name, unit, samples)) all.push_back(std::move(norm));
    };
    append("radial", "m", radial);
    append("around", "m", around);
    append("stress", "Pa", stress);
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    std::vector<std::pair<double, int>> order;
    for (int p = 0; p < body.points.points(); ++p) order.emplace_back(seat_of(body, p).ring, p);
    std::sort(order.begin(), order.end());
    std::vector<double> radius, stress, exact, moment;
    for (const auto& [ring, p] : order) {
      radius.push_back(ring_.radius(seat_of(body, p).ring));
      stress.push_back(largest_stress(body.points, p, at_.choice.law));
      exact.push_back(ring_.exact_at(seat_of(body, p).ring).stress.value);
    }
    Profile profile;
    profile.abscissa = "radius";
    profile.columns = {{"radius", "m", "distance from the axis at rest", radius},
                       {"stress", "Pa", "stress along the lines of tension", stress},
                       {"exact", "Pa", "exact stress along the lines of tension", exact}};
    return profile;
  }

 private:
  const Seat& seat_of(const Body& body, int p) const {
    return start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
  }
  RingForces forces_of(const Body& body) const {
    std::vector<double> radii;
    for (int p = 0; p < body.points.points(); ++p) radii.push_back(ring_.radius(seat_of(body, p).ring));
    return ring_forces(body.points, radii, at_.choice.law, ring_.exact());
  }

  Settings settings_;
  TwistedAnnulus at_;
  TwistedRing ring_;
  std::vector<Seat> start_;  // by the points' numbers
  RingForces first_{};
  std::vector<std::array<double, 3>> rows_;
};

const std::vector<double> meshes{8, 10, 12, 16, 24};

std::vector<CaseGate> gates() { return {}; }

Case twisted_annulus() {
  return {.name = "twisted-annulus",
          .kind = Kind::membrane,
          .keys = TwistedAnnulus().keys(),
          .sets = {{"cells", 8.0}, {"poissons_ratio", 0.1}},
          .york_step = courant_number(0.3),
          .problem = run_of<TwistedAnnulusRun>,
          .studies = {study("default", "default", "Order 2.", {8}).in_full(meshes).pictured(2, 8),
                      study("two-way", "a sheet that carries compression", "Another equilibrium: no order.", {8})
                          .with({{"compression", "carried"}})},
          .gates = gates(),
          .levels = meshes};
}
PLUMBLINE_CASE(twisted_annulus);

}  // namespace
}  // namespace plumbline
