// A gas around the axis.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "cases/catalog/stability/gas_patch.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

struct Box {
  bool axis = true;
  int width = 5, height = 2;  // cells
};

Box box_of(const Settings& s) { return {s.text("geometry") == "axis", s.integer("width"), s.integer("height")}; }

int lines_per_cell(const Settings& s) { return whole(std::round(std::sqrt(s.number("ppc")))); }

// Rings in the middles of equal strips, in proportion to their radius.
Body gas_body(const Settings& s, const Box& box) {
  const int per_cell = lines_per_cell(s);
  const int across = box.width * per_cell, up = box.height * per_cell;
  Body body = make_body("gas", gas_material(s, 0, Side::closing, false), across * up, 2, box.axis);
  std::size_t p = 0;
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i, ++p) {
      const double r = (i + 0.5) / per_cell;
      body.points(column::position, 0)[p] = r;
      body.points(column::position, 1)[p] = (j + 0.5) / per_cell;
      put_gas(body.points, p, (box.axis ? r : 1.0) / (per_cell * per_cell));
    }
  }
  return body;
}

Patch box_patch(const Settings& s) {
  const Box box = box_of(s);
  Patch patch;
  GridSpec& grid = patch.scene.grid;
  grid.dim = 2;
  grid.axisymmetric = box.axis;
  grid.cells = {box.width, box.height, 1};
  for (std::size_t d = 0; d < 2; ++d) grid.walls[d] = {Wall::symmetry, Wall::symmetry};
  patch.scene.bodies.push_back(gas_body(s, box));
  apply_choices(s, patch.scene);
  patch.places.emplace_back(patch.scene.bodies[0].id.size());
  for (std::size_t p = 0; p < patch.places[0].size(); ++p) patch.places[0][p].member = static_cast<int>(p);
  return patch;
}

// What the rings move with after a short step, ring by ring along one line, with `change` added to their energies.
Eigen::VectorXd velocities_after(const Patch& patch, const Settings& s, const Eigen::VectorXd& change) {
  constexpr double dt = 0.01;
  Patch changed = patch;
  Columns& points = changed.scene.bodies[0].points;
  const auto rings = static_cast<int>(change.size());
  for (int p = 0; p < points.points(); ++p) points(column::energy)[p] += change[p % rings];
  StepMap map(changed.scene, {}, {s.text("integrator"), integrator_parameters(s)}, Positions::frozen, dt);
  map.step();
  const std::vector<double> state = map.state();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(rings);
  for (std::size_t k = 0; k < state.size(); ++k) {
    const StepMap::Entry& entry = map.entry(k);
    const bool radial = map.is_velocity(k) && map.name(k).ends_with("velocity 0");
    if (radial && entry.point < rings) found[entry.point] = state[k];
  }
  return found;
}

// Smooth shapes do not take the sums over rings next to the axis for integrals, and push a uniform gas about there. The
// smallest change of the rings' energies that leaves no force is what they rest with.
void bring_to_rest(Patch& patch, const Settings& s, int rings) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(rings), start = velocities_after(patch, s, none);
  if (start.cwiseAbs().maxCoeff() < 1e-14) return;
  Eigen::MatrixXd response(rings, rings);
  constexpr double size = 1e-2;
  for (int k = 0; k < rings; ++k) {
    Eigen::VectorXd change = none;
    change[k] = size;
    response.col(k) = (velocities_after(patch, s, change) - start) / size;
  }
  const Eigen::VectorXd change = least_squares(response, -start, 1e-9);
  Columns& points = patch.scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) points(column::energy)[p] += change[p % rings];
}

class AxisymmetricGas final : public StabilityProblem {
 public:
  std::string name() const override { return "axisymmetric"; }
  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override {
    return {
        {.name = "geometry",
         .value = "axis",
         .choices = {"axis", "plane"},
         .description = "rings around the axis at x = 0, or the same box in the plane"},
        {.name = "width", .value = 5.0, .low = 2, .high = 20, .integer = true, .description = "of the box, in cells"},
        {.name = "height", .value = 2.0, .low = 2, .high = 20, .integer = true, .description = "of the box, in cells"}};
  }
  std::vector<Override> choices(const std::string&) const override { return {{"ppc", 4.0}, {"positions", "frozen"}}; }
  Patch patch(const Settings& s, const Extent&) const override {
    Patch patch = box_patch(s);
    const auto rings = static_cast<int>(patch.places[0].size()) / (s.integer("height") * lines_per_cell(s));
    if (s.text("geometry") == "axis") bring_to_rest(patch, s, rings);
    return patch;
  }
  Scan scan(const Settings&) const override { return {.low = 0.4, .high = 4, .steps = 6}; }
  Watch watch(const Settings&) const override {
    Watch watch;
    watch.core = 1;
    watch.steps = 600;
    watch.grown = 1e6;
    watch.grown_slowly = 1e3;
    return watch;
  }
  std::vector<std::vector<Override>> listed() const override { return {{{"width", 1.0 * narrow}}}; }
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    if (!scene.axisymmetric) return all;
    for (const SceneContents::Part& gas : scene.of(SceneContents::Matter::gas)) {
      const int across = std::min(gas.per_cell, 2);  // more cost much
      all.push_back({{{"ppc", 1.0 * across * across}, {"width", 1.0 * narrow}}});
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    std::vector<MapPlan> all;
    if (tier == Tier::quick) return all;
    for (const std::string scheme : {"default", "york1997"}) {
      for (const std::string geometry : {"axis", "plane"}) {
        all.push_back({.title = "largest stable step, " + geometry,
                       .scheme = scheme,
                       .overrides = {{"geometry", geometry}},
                       .x = {"width", "radius of the can, cells", {2, 3, 4, 5, 6}},
                       .y = {"ppc", "rings per cell", {1, 4, 9}}});
      }
    }
    return all;
  }

 private:
  static constexpr int narrow = 2;  // cells in radius: most of the can is next to the axis, and costs least
};

PLUMBLINE_STABILITY_PROBLEM(AxisymmetricGas);

}  // namespace
}  // namespace plumbline
