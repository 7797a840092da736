#include "cases/catalog/coupled/radial_mode.hpp"

#include <cmath>

#include "cases/catalog/coupled/damped_wave.hpp"

namespace plumbline {
namespace {

std::array<double, 3> place_of(const Body& body, int p, int dim) {
  std::array<double, 3> x{};
  for (int d = 0; d < dim; ++d) x[static_cast<std::size_t>(d)] = body.points(column::position, d)[p];
  return x;
}

std::size_t id_of(const Body& body, int p) { return static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]); }

}  // namespace

ModeAt RadialMode::at(const std::array<double, 3>& place) const {
  ModeAt here;
  const double r = std::hypot(place[0], place[1], place[2]);
  if (r == 0) return here;
  const auto [outward, slope] = profile_(r);
  const double around = outward / r;
  for (std::size_t d = 0; d < 3; ++d) {
    const double along = place[d] / r;
    here.displacement[d] = outward * along;
    for (std::size_t e = 0; e < 3; ++e) {
      here.gradient[d][e] = (slope - around) * along * (place[e] / r) + (d == e ? around : 0.0);
    }
  }
  return here;
}

void start_mode(Scene& scene, const RadialMode& mode, double velocity) {
  const int dim = scene.grid.dim;
  const bool affine = scene.transfer == "apic";
  for (Body& body : scene.bodies) {
    if (affine && !body.points.has(column::affine)) body.points.add(column::affine, dim * dim);
    for (int p = 0; p < body.points.points(); ++p) {
      const ModeAt at = mode.at(place_of(body, p, dim));
      for (int d = 0; d < dim; ++d) {
        const auto k = static_cast<std::size_t>(d);
        body.points(column::velocity, d)[p] = velocity * at.displacement[k];
        if (!affine) continue;
        for (int e = 0; e < dim; ++e) {
          body.points(column::affine, dim * d + e)[p] = velocity * at.gradient[k][static_cast<std::size_t>(e)];
        }
      }
    }
  }
}

ModeShare::ModeShare(const Scene& start, const RadialMode& mode) {
  for (const Body& body : start.bodies) {
    std::vector<std::array<double, 3>> shape(static_cast<std::size_t>(body.points.points()));
    for (int p = 0; p < body.points.points(); ++p) {
      const auto& phi = shape[id_of(body, p)] = mode.at(place_of(body, p, start.grid.dim)).displacement;
      weight_ += body.points(column::mass)[p] * (phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2]);
    }
    shapes_.push_back(std::move(shape));
  }
}

double ModeShare::of(const Scene& scene) const {
  double moment = 0;
  for (std::size_t b = 0; b < shapes_.size(); ++b) {
    const Body& body = scene.bodies[b];
    for (int p = 0; p < body.points.points(); ++p) {
      const auto& phi = shapes_[b][id_of(body, p)];
      double along = 0;
      for (int d = 0; d < scene.grid.dim; ++d)
        along += body.points(column::velocity, d)[p] * phi[static_cast<std::size_t>(d)];
      moment += body.points(column::mass)[p] * along;
    }
  }
  return moment / weight_;
}

void ModeRecord::observe(double time, const Scene& now, const std::function<Scene()>& start) {
  if (!share_) share_.emplace(start(), mode_);
  times_.push_back(time);
  shares_.push_back(share_->of(now));
}

void ModeRecord::history(Archive& archive) {
  archive("times", times_);
  archive("shares", shares_);
}

std::vector<Measure> ModeRecord::measures(reference::Bounded omega) const {
  const auto wave = shares_.front() == 0 ? std::nullopt : damped_wave(times_, shares_);
  const double none = std::nan("");
  return {scalar_measure("omega", wave ? wave->omega : none, omega.value, omega.bound, "rad/s"),
          share_measure("damping", wave ? wave->damping : none)};
}

Profile ModeRecord::profile(const std::string& where, double omega) const {
  std::vector<std::array<double, 3>> rows;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    rows.push_back({times_[k], shares_[k], shares_.front() * std::cos(omega * times_[k])});
  }
  return history_profile({{"time", "s", "time", {}},
                          {"velocity", "m/s", "the mode's velocity at the " + where, {}},
                          {"velocity_reference", "m/s", "exact velocity of the " + where, {}}},
                         rows);
}

}  // namespace plumbline
