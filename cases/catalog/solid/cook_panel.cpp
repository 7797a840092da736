// Cook's panel: a tapered sheet of a material that hardly compresses, clamped and sheared, brought to rest by drag.
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/drag.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/shapes/domain_columns.hpp"
#include "reference/cook_panel.hpp"

namespace plumbline::cook_panel {
namespace {

constexpr double width = 48, left = 44, right = 16, top = 60;  // m; the lower left corner is the origin

struct Panel : Parameters {
  reference::CookPanelProblem problem;
  double share = 0, density = 0, drag = 0, ramp = 0, end_time = 0;

  explicit Panel(Parameters given = {}) : Parameters(std::move(given)) {
    problem.youngs_modulus = positive("youngs_modulus", problem.youngs_modulus, "Pa", "E");
    problem.poisson = number({.name = "poissons_ratio",
                              .value = problem.poisson,
                              .low = 0,
                              .high = 0.5,
                              .high_open = true,
                              .description = "Poisson's ratio"});
    problem.load = positive("load", problem.load, "N/m", "upwards, over the right side, per thickness");
    share = positive("share", 1e-4, "1", "of the load that is applied; displacements are divided by it");
    density = positive("initial_density", 1, "kg/m^3", "density");
    drag = positive("drag", 0.25, "1/s", "drag on the points, per mass and velocity");
    ramp = positive("ramp", 10, "s", "time over which the load grows");
    end_time = positive("t_end", 60, "s", "end time");
  }
};

// Points in columns of as many rows, each a parallelogram with two upright sides, which tile the panel.
class CookPanel final : public Problem {
 public:
  explicit CookPanel(const Settings& settings)
      : settings_(settings),
        at_(settings),
        exact_(reference::cook_panel(at_.problem)),
        columns_(settings.integer("cells") * settings.integer("ppc")),
        rows_(whole(std::round((left + right) / 2 / spacing()))) {}

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid.dim = 2;
    const double h = scene.grid.h = width / settings_.number("cells");
    constexpr int margin = 2;
    scene.grid.origin = {0, -margin * h, 0};
    scene.grid.cells = {settings_.integer("cells") + margin, whole(std::ceil(top / h)) + 2 * margin, 1};
    scene.grid.walls[0] = {Wall::no_slip, Wall::free};
    Body body = points();
    const Load pull_up = [at = at_, share = load_shares()](double time, Columns& points, std::span<const int> id) {
      const double done = std::min(1.0, time / at.ramp), grown = done * done * (3 - 2 * done);
      for (int p = 0; p < points.points(); ++p) {
        const double pull = grown * at.share * at.problem.load *
                            share[static_cast<std::size_t>(id[static_cast<std::size_t>(p)])];
        points(column::body_force)[p] = 0;
        points(column::body_force, 1)[p] = pull / points(column::mass)[p];
      }
    };
    body.load = with_drag(pull_up, at_.drag);
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    time_.push_back(simulation.time());
    corner_.push_back(corner(simulation.scene().bodies.front()));
  }
  void history(Archive& archive) override {
    archive("time", time_);
    archive("corner", corner_);
  }

  std::vector<Measure> measures(const Simulation&) const override {
    const auto last = std::lower_bound(time_.begin(), time_.end(), 0.8 * at_.end_time) - time_.begin();
    const auto [low, high] = std::minmax_element(corner_.begin() + last, corner_.end());
    const double end = corner_.back();
    return {scalar_measure("corner", end, exact_.corner.value, exact_.corner.bound, "m"),
            share_measure("unsettled", (*high - *low) / end)};
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", time_}, {"corner", "m", "displacement of the corner", corner_}};
    return profile;
  }

 private:
  double spacing() const { return width / columns_; }
  static double height(double x) { return left - (left - right) * x / width; }

  Body points() const {
    auto material = std::make_shared<NeoHookean>();
    material->youngs_modulus = at_.problem.youngs_modulus;
    material->poissons_ratio = at_.problem.poisson;
    material->density = at_.density;
    Body body = make_body("panel", std::move(material), columns_ * rows_, 2);
    body.spacing = spacing();
    body.points.add(column::half_edges_at_start, 4);
    for (int p = 0; p < columns_ * rows_; ++p) {
      const double x = (p / rows_ + 0.5) * spacing(), up = (p % rows_ + 0.5) / rows_;
      body.points(column::position, 0)[p] = x;
      body.points(column::position, 1)[p] = start_height(p);
      body.points(column::volume)[p] = spacing() * height(x) / rows_;
      body.points(column::mass)[p] = at_.density * body.points(column::volume)[p];
      const double rise = (left - (left - right) * up) / width;
      const double edges[] = {spacing() / 2, rise * spacing() / 2, 0, height(x) / rows_ / 2};
      for (int k = 0; k < 4; ++k) body.points(column::half_edges_at_start, k)[p] = edges[k];
    }
    return body;
  }
  double start_height(int p) const {
    const double x = (p / rows_ + 0.5) * spacing(), up = (p % rows_ + 0.5) / rows_;
    return left * x / width + up * height(x);
  }

  // Of the load, by the point's number. Points stand half a spacing and more from the side that is loaded: forces of the last two
  // columns have its resultant and its moment there.
  std::vector<double> load_shares() const {
    std::vector<double> shares(static_cast<std::size_t>(columns_ * rows_));
    for (int k = 0; k < rows_; ++k) {
      shares[shares.size() - 1 - static_cast<std::size_t>(k)] = 1.5 / rows_;
      shares[shares.size() - 1 - static_cast<std::size_t>(rows_ + k)] = -0.5 / rows_;
    }
    return shares;
  }

  // Upward displacement of the corner at the top right for the whole load, from the point beside it.
  double corner(const Body& body) const {
    const int last = columns_ * rows_ - 1;
    const int p = static_cast<int>(std::find(body.id.begin(), body.id.end(), last) - body.id.begin());
    const double beside = spacing() / 2, below = top - start_height(last);
    const double moved = body.points(column::position, 1)[p] - start_height(last) +
                         body.points(column::deformation, 2)[p] * beside +
                         (body.points(column::deformation, 3)[p] - 1) * below;
    return moved / at_.share;
  }

  Settings settings_;
  Panel at_;
  reference::CookPanel exact_;
  int columns_, rows_;
  std::vector<double> time_, corner_;
};

const std::vector<double> coarse{6}, all_levels{6, 12, 24};

std::vector<StudyPlan> studies() {
  return {
      study("default", "dilatation by cells", "One volume a cell to keep is less than its nodes can do.", coarse)
          .in_full(all_levels),
      study("points", "dilatation by points", "Four volumes a cell to keep are more than its nodes can do: it locks.",
            coarse)
          .with({{"dilatation", "point"}})
          .in_full(all_levels),
      study("compressible", "Poisson's ratio 0.3, which shares nothing", "What is left where nothing locks.", {6, 12})
          .with({{"poissons_ratio", 0.3}})
          .in_full(all_levels)};
}

Number relative_error(double level) {
  return number_at("error of the corner's displacement over it", "corner", level,
                   [](const RunResult&, const Measure& m) { return Measured::of(m.error / m.scale); });
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  const std::string locked = "each point of a cell keeps its own volume, four to the two displacements of its node";
  for (const std::string study : {"default", "compressible"}) {
    all.push_back(gate(study + "/corner-6", relative_error(6), at_most(0.08),
                       requirement("the two per cent of four times as many cells, at first order: singular corners")));
    all.push_back(gate(study + "/corner-24", relative_error(24), at_most(0.02), requirement("two per cent at 24 cells"))
                      .in(Tier::full));
    for (const double level : {6, 24}) {
      all.push_back(
          gate(study + "/settled-" + std::to_string(whole(level)), value_at("unsettled", level), at_most(0.01),
               requirement("the corner moves by less than half of what it may be wrong by while as much drag acts "
                           "as brings the slowest mode to a fifth"))
              .in(level > 6 ? Tier::full : Tier::quick));
    }
  }
  all.push_back(gate("points/corner-24", value_at("corner", 24), at_least(7.9), requirement("two per cent at 24 cells"))
                    .in(Tier::full)
                    .fails(locked, {4.4, 5.0}, "2026-11-27 8b1c539"));
  all.push_back(
      gate("points/corner-6", value_at("corner", 6), at_least(7.4), requirement("as with dilatation by cells"))
          .fails(locked, {2.4, 3.2}, "2026-11-27 8b1c539"));
  return all;
}

Case cook_panel() {
  return {.name = "cook-panel",
          .kind = Kind::solid,
          .keys = Panel().keys(),
          .sets = {{"cells", 12.0}, {"shape", "cpdi"}},
          .york1997 = {{"shape", "linear"}},
          .york_step = courant_number(published_courant),
          .problem = run_of<CookPanel>,
          .studies = studies(),
          .gates = gates(),
          .levels = all_levels};
}
PLUMBLINE_CASE(cook_panel);

}  // namespace
}  // namespace plumbline::cook_panel
