// An elastic bar whose points stand irregularly.
#include <cmath>
#include <random>

#include "cases/harness/laboratory/problem.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {
namespace {

// Points of a period of `cells` cells, in cells: the regular ones, each moved at random by up to `jitter` of half a
// spacing.
std::vector<double> irregular_points(int cells, int ppc, double jitter, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<double> all;
  for (int k = 0; k < cells * ppc; ++k) {
    const double uniform = 2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1;
    all.push_back((k + 0.5 + 0.5 * jitter * uniform) / ppc);
  }
  return all;
}

class Irregular final : public StabilityProblem {
 public:
  std::string name() const override { return "irregular"; }
  Kind kind() const override { return Kind::solid; }
  std::vector<Key> keys() const override {
    return {
        {.name = "period",
         .value = 4.0,
         .low = 1,
         .high = 50,
         .integer = true,
         .description = "of the layout, in cells"},
        {.name = "jitter",
         .value = 0.9,
         .low = 0,
         .high = 1,
         .high_open = true,
         .description = "how far points stand from where regular ones would, in halves of their spacing"},
        {.name = "seed", .value = 1.0, .low = 0, .high = 1e9, .integer = true, .description = "of the random places"}};
  }
  std::vector<Override> choices(const std::string&) const override {
    return {
        {"shape", "quadratic"}, {"transfer", "apic"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 2.0}};
  }
  Patch patch(const Settings& s, const Extent& extent) const override {
    const int cells = s.integer("period"), periods = extent.core + 2 * extent.margin;
    const auto seed = static_cast<unsigned long>(s.integer("seed"));
    const std::vector<double> places = irregular_points(cells, s.integer("ppc"), s.number("jitter"), seed);
    Patch patch;
    patch.directions = 1;
    patch.step[0] = {static_cast<double>(cells), 0, 0};
    patch.scene.grid.cells[0] = cells * periods;
    patch.scene.shape = s.text("shape");
    patch.scene.transfer = s.text("transfer");
    patch.scene.transfer_order = s.integer("transfer_order");
    auto law = std::make_shared<LinearElastic>();
    law->youngs_modulus = law->density = 1;
    const auto count = static_cast<int>(places.size());
    Body body = make_body("bar", law, count * periods, 1);
    body.spacing = 1.0 / s.integer("ppc");
    patch.places.emplace_back();
    for (int p = 0; p < count * periods; ++p) {
      body.points(column::position)[p] = p / count * cells + places[static_cast<std::size_t>(p % count)];
      body.points(column::mass)[p] = body.points(column::volume)[p] = body.spacing;
      patch.places[0].push_back({{p / count - extent.margin, 0}, p % count});
    }
    patch.scene.bodies.push_back(std::move(body));
    return patch;
  }
  Scan scan(const Settings&) const override { return {0.001, 3, 20}; }
};

PLUMBLINE_STABILITY_PROBLEM(Irregular);

}  // namespace
}  // namespace plumbline
