// Layers of points that carry stress along a tangent, now and later.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "kernel/points/body.hpp"

namespace plumbline::kernel_functions::layers_trial {
namespace {

constexpr double layer_modulus = 2.3, layer_ratio = 0.3, layer_density = 1.4;
constexpr int layer_points = 5;

double layer_volume(int p) { return 0.3 + 0.08 * p; }
// Some are stretched, and some slack.
double strain_at(int p) { return 0.12 - 0.07 * p; }
double angle_at(int p) { return 0.4 + 1.1 * p; }

// E eps t t of the strain, and of what rates make of it. [York 5.2, 5.5]
void add_layer(const std::string& name, UniaxialMembrane& law, double modulus, int dim, KnownAnswers& all) {
  const std::shared_ptr<const Material> material(&law, [](const Material*) {});
  Columns points = make_body("points", material, layer_points, dim).points;
  points.add(column::transfer_loss);
  const double rate[] = {0.7, -0.45, 0.3};
  std::vector<double> along, strain;
  double motion = 0;
  for (int p = 0; p < layer_points; ++p) {
    const double size = p % 2 == 0 ? 1 : -1.3, c = std::cos(angle_at(p)), s = std::sin(angle_at(p));
    points(column::volume)[p] = layer_volume(p);
    strain.push_back(points(column::strain)[p] = strain_at(p));
    for (int k = 0; k < (dim == 1 ? 1 : 3); ++k) {
      points(column::strain_rate, k)[p] = size * rate[k];
      points(column::stress, k)[p] = 0.2 * k - 0.1 * p + 0.5;
    }
    for (int d = 0; d < dim; ++d) points(column::velocity, d)[p] = 0.2 * p - 0.3 + 0.5 * d;
    motion = std::max(motion, std::hypot(0.2 * p - 0.3, dim == 2 ? 0.2 * p + 0.2 : 0));
    if (dim == 1) {
      along.push_back(size * rate[0]);
      continue;
    }
    points(column::tangent)[p] = c;
    points(column::tangent, 1)[p] = s;
    along.push_back(size * (rate[0] * c * c + rate[1] * s * s + rate[2] * c * s));
  }
  const auto carried = [&](double eps) { return law.one_way && eps < 0 ? 0.0 : eps; };
  const auto energy = [&](double eps) { return modulus / 2 * carried(eps) * carried(eps); };
  MaterialContext context;
  context.dim = dim;
  context.tangents_given = true;
  // Losses and energies of a step, by the stresses that the columns hold.
  constexpr double dt = 0.13;
  const std::vector<double> rates = law.rates(points, context);
  double stored = 0, kept = 0;
  std::vector<double> loss(1, 0.0);
  for (int p = 0; p < layer_points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    all.push_back({name + ".rate" + std::to_string(p), rates[at], along[at]});
    if (p == 0) continue;
    double power = 0;
    for (int k = 0; k < (dim == 1 ? 1 : 3); ++k)
      power += points(column::stress, k)[p] * points(column::strain_rate, k)[p];
    const double gained = layer_volume(p) * (energy(strain[at] + dt * along[at]) - energy(strain[at]));
    strain[at] += dt * along[at];
    stored += gained;
    kept += layer_volume(p) * energy(strain[at]);
    loss.push_back(dt * layer_volume(p) * power - gained);
  }
  all.push_back({name + ".stored", law.advance(points, {1, layer_points}, context, dt), stored});
  all.push_back({name + ".kept", law.stored_energy(points, {1, layer_points}), kept});
  for (int p = 0; p < layer_points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    all.push_back({name + ".strain" + std::to_string(p), points(column::strain)[p], strain[at]});
    all.push_back({name + ".loss" + std::to_string(p), points(column::transfer_loss)[p], loss[at]});
  }
  for (const double ahead : {0.0, 0.2, -0.17}) {
    context.ahead = ahead;
    law.evaluate_stress(points, all_points(points), context);
    for (int p = 0; p < layer_points; ++p) {
      const auto at = static_cast<std::size_t>(p);
      const double pull = modulus * carried(strain[at] + ahead * along[at]);
      const double c = dim == 1 ? 1 : std::cos(angle_at(p)), s = std::sin(angle_at(p)), exact[] = {c * c, s * s, c * s};
      for (int k = 0; k < (dim == 1 ? 1 : 3); ++k) {
        all.push_back({name + ".stress" + std::to_string(k) + "." + std::to_string(p) + ".at" + std::to_string(ahead),
                       points(column::stress, k)[p], pull * exact[k]});
      }
    }
  }
  all.push_back({name + ".fastest", law.step_bounds(points, all_points(points), dim).fastest,
                 std::sqrt(modulus / layer_density) + motion});
  // Strains that something else sets: what they store comes from the losses.
  std::vector<double> given;
  double change = 0;
  for (int p = 0; p < layer_points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    given.push_back(0.05 * p - 0.08);
    const double gained = layer_volume(p) * (energy(given[at]) - energy(strain[at]));
    change += gained;
    loss[at] -= gained;
  }
  all.push_back({name + ".set", law.set_strain(points, given), change});
  for (int p = 0; p < layer_points; ++p) {
    const auto at = static_cast<std::size_t>(p);
    all.push_back({name + ".set_strain" + std::to_string(p), points(column::strain)[p], given[at]});
    all.push_back({name + ".set_loss" + std::to_string(p), points(column::transfer_loss)[p], loss[at]});
  }
}

}  // namespace

KnownAnswers layer_answers() {
  KnownAnswers all;
  for (const int dim : {1, 2}) {
    for (const bool one_way : {false, true}) {
      UniaxialMembrane plain;
      PlaneStressMembrane wide;
      wide.poissons_ratio = layer_ratio;
      for (UniaxialMembrane* law : {&plain, static_cast<UniaxialMembrane*>(&wide)}) {
        law->youngs_modulus = layer_modulus;
        law->density = layer_density;
        law->one_way = one_way;
        const double share = law == &plain ? 1 : 1 - layer_ratio * layer_ratio;
        add_layer((law == &plain ? "layer" : "wide") + std::to_string(dim) + (one_way ? ".one_way" : ""), *law,
                  layer_modulus / share, dim, all);
      }
    }
  }
  return all;
}

}  // namespace plumbline::kernel_functions::layers_trial
