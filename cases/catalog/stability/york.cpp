// York's own test of his analysis: five points, one a cell.
#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/catalog/stability/york_bar.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

class York final : public StabilityProblem {
 public:
  std::string name() const override { return "york"; }
  Kind kind() const override { return Kind::solid; }
  bool compares_integrators() const override { return true; }
  std::vector<Key> keys() const override {
    return {{.name = "at",
             .value = "centres",
             .choices = {"centres", "sides"},
             .description = "where points stand in their cells"},
            {.name = "ends",
             .value = "held",
             .choices = {"held", "free"},
             .description = "the nodes at both ends of the five cells"}};
  }
  std::vector<Override> choices(const std::string&) const override {
    return {{"shape", "linear"}, {"transfer", "flip"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 1.0}};
  }
  Patch patch(const Settings& settings, const Extent&) const override {
    Patch patch = YorkBar{york_offset(settings.text("at")), settings.text("ends") == "held"}.patch();
    patch.scene.shape = settings.text("shape");
    patch.scene.transfer = settings.text("transfer");
    patch.scene.transfer_order = settings.integer("transfer_order");
    return patch;
  }
  Scan scan(const Settings&) const override { return {.low = 0.2, .high = 4, .steps = 20}; }
  // Below its limit the double mode of points beside the sides may swing to 1e4 times a perturbation.
  Watch watch(const Settings&) const override {
    Watch watch;
    watch.width = 5e-4;
    watch.grown = 1e7;
    watch.grown_slowly = 1e5;
    return watch;
  }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    const auto scheme = map_scheme(s);
    if (!scheme || s.text("ends") != "free") return std::nullopt;
    const auto points = reference::york_points(york_offset(s.text("at")));
    return ClosedForm{reference::free_bar_courant_limit(*scheme, points, 1).value,
                      "largest eigenvalue of a symmetric matrix, reference/mpm_amplification.hpp"};
  }
};

PLUMBLINE_STABILITY_PROBLEM(York);

}  // namespace
}  // namespace plumbline
