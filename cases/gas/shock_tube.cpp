#include "cases/gas/shock_tube.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cases/harness/errors.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

Key positive(std::string name, double value, std::string unit, std::string description) {
  return {.name = std::move(name),
          .value = value,
          .unit = std::move(unit),
          .low = 0,
          .low_open = true,
          .description = std::move(description)};
}

// Points at the middles of `count` equal intervals of [from, to].
struct Layer {
  double from, to;
  int count;
  reference::GasState state;
};

class ShockTubeProblem final : public Problem {
 public:
  ShockTubeProblem(const ShockTube& tube, const Settings& settings)
      : tube_(tube),
        settings_(settings),
        exact_(tube.states) {}

  double end_time() const override { return tube_.end_time; }

  Scene scene() const override {
    Scene scene;
    const double h = 1.0 / settings_.number("cells"), offset = settings_.number("offset");
    scene.grid.dim = 1;
    scene.grid.h = h;
    scene.grid.origin[0] = tube_.low - offset * h;
    const int inside = static_cast<int>(std::lround((tube_.high - tube_.low) / h));
    scene.grid.cells[0] = inside + (offset > 0 ? 1 : 0);
    scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
    scene.shape = settings_.text("shape");
    scene.transfer = settings_.text("transfer");
    scene.density = density_method(settings_.text("density"));
    scene.bodies.push_back(body(scene.grid));
    return scene;
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Columns& points = simulation.scene().bodies.front().points;
    std::vector<FieldSample> density, velocity, pressure, energy;
    double covered = 0;
    for (int p = 0; p < points.points(); ++p) {
      const double x = points(column::position)[p], rho = points(column::density)[p];
      const double volume = points(column::mass)[p] / rho;
      const reference::Sample exact = sample(x, simulation.time());
      const auto add = [&](auto& field, double computed, const reference::Bounded& value) {
        field.push_back({volume, x, computed, value.value, value.bound});
      };
      covered += volume;
      add(density, rho, exact.density);
      add(velocity, points(column::velocity)[p], exact.velocity);
      add(pressure, points(column::pressure)[p], exact.pressure);
      add(energy, points(column::energy)[p], exact.energy);
    }
    std::vector<Measure> all;
    const auto append = [&](const std::vector<Measure>& norms) { all.insert(all.end(), norms.begin(), norms.end()); };
    append(field_norms("density", "kg/m^3", density));
    append(field_norms("velocity", "m/s", velocity));
    append(field_norms("pressure", "Pa", pressure));
    append(field_norms("energy", "J/kg", energy));
    const GridSpec& grid = simulation.scene().grid;
    all.push_back(scalar_measure("coverage", covered / (grid.h * grid.cells[0]), 1.0, 0.0, "1"));
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    const auto n = static_cast<std::size_t>(body.points.points());
    const auto column_of = [&](const ColumnId& id, const char* name, const char* label) {
      ProfileColumn values{name, id.unit(), label, std::vector<double>(n)};
      for (std::size_t p = 0; p < n; ++p) values.values[static_cast<std::size_t>(body.id[p])] = body.points(id)[p];
      return values;
    };
    Profile profile;
    profile.columns = {column_of(column::position, "x", "position"),
                       column_of(column::mass, "mass", "point mass"),
                       column_of(column::density, "density", "density"),
                       column_of(column::velocity, "velocity", "velocity"),
                       column_of(column::pressure, "pressure", "pressure"),
                       column_of(column::energy, "energy", "specific internal energy")};
    std::vector<ProfileColumn> exact{{"density_reference", "kg/m^3", "exact density", {}},
                                     {"velocity_reference", "m/s", "exact velocity", {}},
                                     {"pressure_reference", "Pa", "exact pressure", {}},
                                     {"energy_reference", "J/kg", "exact specific internal energy", {}}};
    ProfileColumn volume{"volume", "m^3", "point volume", {}};
    for (std::size_t p = 0; p < n; ++p) {
      const reference::Sample at = sample(profile.columns[0].values[p], simulation.time());
      exact[0].values.push_back(at.density.value);
      exact[1].values.push_back(at.velocity.value);
      exact[2].values.push_back(at.pressure.value);
      exact[3].values.push_back(at.energy.value);
      volume.values.push_back(profile.columns[1].values[p] / profile.columns[2].values[p]);
    }
    profile.columns.push_back(std::move(volume));
    profile.columns.insert(profile.columns.end(), exact.begin(), exact.end());
    return profile;
  }

 private:
  reference::Sample sample(double x, double time) const { return exact_.sample((x - tube_.diaphragm) / time); }

  // The tube's ends reach the walls, wherever a shifted grid puts them.
  Body body(const GridSpec& grid) const {
    const double h = grid.h, low = grid.origin[0], high = low + h * grid.cells[0];
    const auto& [left, right] = std::pair{tube_.states.left, tube_.states.right};
    const double ppc = settings_.number("ppc"), densest = std::max(left.density, right.density);
    const auto layer = [&](double from, double to, const reference::GasState& state) {
      const double share = settings_.text("points") == "equal-mass" ? state.density / densest : 1.0;
      return Layer{from, to, std::max(1, static_cast<int>(std::lround((to - from) / h * ppc * share))), state};
    };
    const std::vector<Layer> layers{layer(low, tube_.diaphragm, left), layer(tube_.diaphragm, high, right)};
    auto gas = std::make_shared<IdealGas>();
    gas->gamma = tube_.states.gamma;
    gas->viscosity_linear = settings_.number("viscosity.linear");
    gas->viscosity_quadratic = settings_.number("viscosity.quadratic");
    Body body = make_body("gas", gas, layers[0].count + layers[1].count, 1);
    int p = 0;
    for (const Layer& at : layers) {
      const double spacing = (at.to - at.from) / at.count;
      for (int k = 0; k < at.count; ++k, ++p) {
        body.points(column::position)[p] = at.from + (k + 0.5) * spacing;
        body.points(column::velocity)[p] = at.state.velocity;
        body.points(column::mass)[p] = at.state.density * spacing;
        body.points(column::volume)[p] = spacing;
        body.points(column::density)[p] = at.state.density;
        body.points(column::energy)[p] = at.state.pressure / ((gas->gamma - 1) * at.state.density);
      }
    }
    return body;
  }

  ShockTube tube_;
  Settings settings_;
  reference::RiemannSolution exact_;
};

}  // namespace

std::vector<Key> shock_tube_keys(const ShockTube& tube) {
  const auto velocity = [](std::string name, double value, std::string description) {
    return Key{.name = std::move(name), .value = value, .unit = "m/s", .description = std::move(description)};
  };
  const auto& [left, right, gamma] = tube.states;
  return {positive("left.density", left.density, "kg/m^3", "density left of the diaphragm"),
          velocity("left.velocity", left.velocity, "velocity left of the diaphragm"),
          positive("left.pressure", left.pressure, "Pa", "pressure left of the diaphragm"),
          positive("right.density", right.density, "kg/m^3", "density right of the diaphragm"),
          velocity("right.velocity", right.velocity, "velocity right of the diaphragm"),
          positive("right.pressure", right.pressure, "Pa", "pressure right of the diaphragm"),
          {.name = "gamma",
           .value = gamma,
           .low = 1,
           .high = 10,
           .low_open = true,
           .description = "ratio of specific heats"},
          {.name = "diaphragm",
           .value = tube.diaphragm,
           .unit = "m",
           .low = tube.low,
           .high = tube.high,
           .low_open = true,
           .high_open = true,
           .description = "position of the diaphragm"},
          positive("t_end", tube.end_time, "s", "end time")};
}

ShockTube shock_tube_from(const Settings& settings, const ShockTube& defaults) {
  ShockTube tube = defaults;
  tube.states.left = {settings.number("left.density"), settings.number("left.velocity"),
                      settings.number("left.pressure")};
  tube.states.right = {settings.number("right.density"), settings.number("right.velocity"),
                       settings.number("right.pressure")};
  tube.states.gamma = settings.number("gamma");
  tube.diaphragm = settings.number("diaphragm");
  tube.end_time = settings.number("t_end");
  return tube;
}

std::unique_ptr<Problem> shock_tube_problem(const ShockTube& tube, const Settings& settings) {
  return std::make_unique<ShockTubeProblem>(tube, settings);
}

}  // namespace plumbline
