// A heavy bob on a string of membrane points swings in the plane. [York section 5.7] Long for its gates: two ways to know the
// strain, four meshes of York's, and three studies of what does not matter to the swing.
#include <algorithm>
#include <cmath>

#include "cases/catalog/membrane/rotated_increments.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "reference/bar_pendulum.hpp"
#include "reference/elastic_pendulum.hpp"

namespace plumbline {
namespace {

// One struct for points and reference.
struct Swing : Parameters {
  reference::ElasticPendulumProblem pendulum;
  std::string strain = text(strain_or_increments());
  int layers = integer({.name = "layers",
                        .value = 1.0,
                        .low = 1,
                        .high = 8,
                        .description = "of points through the thickness, each with its own share of the section"});
  bool york_box = one_of("box", "wide", {"wide", "york"}, "walls out of the string's reach, or York's box") == "york";
  std::string layout = one_of("layout", "ends", {"ends", "ppc", "york"},
                              "20, 40, 80, 320 points on York's meshes, half a segment's share at the ends; ppc points "
                              "a cell; or York's, all of them whole");
  double end_time = positive("t_end", 1.3, "s", "end time");

  explicit Swing(Parameters given = {}) : Parameters(std::move(given)) {
    pendulum.one_way = yes_or_no("one_way", pendulum.one_way, "whether the string carries no pressure");
    pendulum.youngs_modulus = positive("youngs_modulus", pendulum.youngs_modulus, "Pa", "E of the string");
    pendulum.area = positive("area", pendulum.area, "m^2", "section of the string");
    pendulum.density = positive("string_density", pendulum.density, "kg/m^3", "density of the string");
    pendulum.mass = positive("mass", pendulum.mass, "kg", "of the bob");
    pendulum.gravity = positive("gravity", pendulum.gravity, "m/s^2", "gravity");
  }

  // A key of this case alone: York's earlier way with strains is no choice for others.
  static Key strain_or_increments() {
    Key key = strain_key();
    key.choices.push_back("increments");
    key.description += "; or as York's first code did, increments rotated once";
    return key;
  }

  bool whole_ends() const { return layout == "york"; }
  // 20, 40, 80 and 320 points on York's four meshes [York Figs. 32-35], or as many as a share of the length has.
  int points(double cells, double ppc) const {
    if (layout != "ppc") return whole(std::round((cells < 40 ? 4 : 8) * cells));
    const double length = std::hypot(pendulum.bob_x - pendulum.pivot_x, pendulum.bob_y - pendulum.pivot_y);
    return 1 + std::max(1, whole(std::round(length * cells * ppc)));
  }
};

// York's box: 0.7 wide, rounded up to whole cells, its top at 1. The wide one keeps all other walls out of the string's
// reach and has its top where the string is held.
GridSpec swing_grid(const Swing& at, double h) {
  const double low = at.york_box ? 0 : -0.4;
  const double top = at.york_box ? 1 : at.pendulum.pivot_y;
  const auto cells = [h](double length) { return whole(std::ceil(length / h - 1e-9)); };
  GridSpec grid;
  grid.dim = 2;
  grid.h = h;
  grid.cells = {cells(at.york_box ? 0.7 : 1.6), cells(at.york_box ? 1 : 1.4), 1};
  grid.origin = {low, top - grid.cells[1] * h, 0};
  grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  grid.walls[1] = {Wall::symmetry, Wall::no_slip};
  return grid;
}

class PendulumRun final : public Problem {
 public:
  explicit PendulumRun(const Settings& settings) : settings_(settings), at_(settings), exact_(at_.pendulum) {}

  double end_time() const override { return at_.end_time; }

  Scene scene() const override {
    const reference::ElasticPendulumProblem& p = at_.pendulum;
    const double cells = settings_.number("cells");
    const int points = at_.points(cells, settings_.number("ppc"));
    Scene scene;
    scene.grid = swing_grid(at_, 1 / cells);
    scene.gravity[1] = -p.gravity;
    for (int k = 0; k < at_.layers; ++k) {
      const double aside = thickness * ((k + 0.5) / at_.layers - 0.5), share = 1.0 / at_.layers;
      const StringState state = straight_string({p.pivot_x + aside, p.pivot_y}, {p.bob_x + aside, p.bob_y}, points);
      Body body = string_body(k == 0 ? "string" : "layer-" + std::to_string(k + 1), at_.strain,
                              {p.youngs_modulus, p.area * share, p.density, p.one_way}, state, 2,
                              at_.whole_ends() ? StringEnds::whole : StringEnds::half);
      if (at_.strain == "increments") rotate_increments_once(body);
      double& bob = body.points(column::mass)[points - 1];
      bob = share * p.mass + (at_.whole_ends() ? 0 : bob);
      scene.bodies.push_back(std::move(body));
    }
    apply_choices(settings_, scene);
    return scene;
  }

  // The angle is that of the line from the first to the last point. [York Fig. 37]
  void observe(const Simulation& simulation) override {
    const Columns& points = simulation.scene().bodies.front().points;
    const double *x = points(column::position), *y = points(column::position, 1);
    const int last = points.points() - 1;
    times_.push_back(simulation.time());
    angle_.push_back(std::atan2(x[last] - x[0], y[0] - y[last]));
    length_.push_back(chord_length(points));
    misalignment_ = larger(misalignment_, misalignment(points));
    kinetic_.push_back(simulation.ledger().stores.kinetic);
    elastic_.push_back(simulation.ledger().stores.elastic);
    if (frames_.size() < frames && simulation.time() >= frame(frames_.size())) keep_frame(points);
    squares_.points += points.points();
    squares_.aside += squared_distances_to_chord(points);
    if (points.has(column::tangent)) watch_stress(simulation.scene());
  }
  void history(Archive& archive) override {
    archive("times", times_);
    archive("angle", angle_);
    archive("length", length_);
    archive("kinetic", kinetic_);
    archive("elastic", elastic_);
    archive("misalignment", misalignment_);
    archive("frames", frames_);
    archive("squares", squares_);
    archive("least_tension", least_tension_);
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const double none = std::nan("");
    const auto turns = find_extremes(times_, angle_, angle_noise);
    const auto loss = [&](std::size_t turn) {  // all of it, of a bob that does not come so far
      return turns.size() < turn ? 1.0 : 1 - std::abs(turns[turn - 1].value / exact_.angle().value);
    };
    const auto exact_turns = exact_.extremes(2);
    const auto exact_loss = [&](std::size_t turn) {
      const reference::Bounded ratio = exact_turns[turn].angle / exact_.angle();
      return reference::Bounded{1 - std::abs(ratio.value), ratio.bound};
    };
    const auto measure = [](const char* name, double value, reference::Bounded exact, const char* unit) {
      Measure m = scalar_measure(name, value, exact.value, exact.bound, unit);
      if (m.unit == "1") m.scale = 1;
      return m;
    };
    std::vector<Measure> all;
    const double period = exact_.heavy_period().value;
    if (at_.end_time > period) {
      all = {measure("period", turns.size() < 2 ? none : turns[1].time, exact_.heavy_period(), "s"),
             measure("amplitude_loss", loss(2), exact_loss(2), "1")};
    }
    if (at_.end_time > 0.6 * period) all.push_back(measure("half_loss", loss(1), exact_loss(1), "1"));
    for (const Measure& m :
         {measure("length_drift", mean_length() / exact_.length().value - 1, mean_exact_length(), "1"),
          share_measure("misalignment", misalignment_ / exact_.length().value),
          share_measure("mean_misalignment", std::sqrt(squares_.aside / squares_.points) / exact_.length().value),
          share_measure("off_tangent", share_of(squares_.off_tangent)),
          share_measure("stress_spread", share_of(squares_.spread)),
          scalar_measure("least_tension", least_tension_ / stress_at_rest(), 0, 0, "1"), drift_measure(simulation)}) {
      all.push_back(m);
    }
    if (!frames_.empty()) all.push_back(scalar_measure("from_fem", from_fem(), 0, 0, "m"));
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", {}},
                       {"angle", "rad", "angle of the line from the first to the last point", {}},
                       {"angle_reference", "rad", "angle of the elastic pendulum", {}},
                       {"length", "m", "length of that line", {}},
                       {"length_reference", "m", "length of the elastic pendulum", {}},
                       {"kinetic_energy", "J", "kinetic energy", {}},
                       {"elastic_energy", "J", "energy of the string", {}}};
    const std::vector<std::size_t> rows = thinned_rows(times_.size(), 800);
    const auto states = exact_.at(times_of(rows));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t k = rows[r];
      add_row(profile, {times_[k], angle_[k], states[r].angle.value, length_[k], states[r].length.value, kinetic_[k],
                        elastic_[k]});
    }
    return profile;
  }

 private:
  // Of the angle, rad: the bob's bounce on the string, 200 to the swing's 5 rad/s, shakes it by less. The parabola at a turn
  // reaches ten times as deep, which leaves out 1e-7 of the amplitude.
  static constexpr double angle_noise = 5e-5;

  static constexpr double thickness = 0.1;  // t of York's Table 1, m
  static constexpr std::size_t frames = 5;  // of his pictures, those of the first swing
  static double frame(std::size_t k) { return 0.25 * (static_cast<double>(k) + 1); }  // s, Figs. 32-36

  // What is summed over all points and steps.
  struct Squares {
    double points = 0, aside = 0, stress = 0, off_tangent = 0, spread = 0;
    void history(Archive& archive) {
      archive("points", points);
      archive("aside", aside);
      archive("stress", stress);
      archive("off_tangent", off_tangent);
      archive("spread", spread);
    }
  };
  double share_of(double square) const { return squares_.stress > 0 ? std::sqrt(square / squares_.stress) : 0; }

  double stress_at_rest() const { return at_.pendulum.mass * at_.pendulum.gravity / at_.pendulum.area; }

  void keep_frame(const Columns& points) {
    std::vector<double> places;
    for (int p = 0; p < points.points(); ++p) {
      places.insert(places.end(), {points(column::position)[p], points(column::position, 1)[p]});
    }
    frames_.push_back(std::move(places));
  }

  // Stress that does not lie along the tangent, that differs between the outer layers, and the least along the tangent.
  void watch_stress(const Scene& scene) {
    const Columns &points = scene.bodies.front().points, &other = scene.bodies.back().points;
    const double *xx = points(column::stress), *yy = points(column::stress, 1), *xy = points(column::stress, 2);
    const double *tx = points(column::tangent), *ty = points(column::tangent, 1);
    for (int p = 0; p < points.points(); ++p) {
      const double along = xx[p] * tx[p] * tx[p] + yy[p] * ty[p] * ty[p] + 2 * xy[p] * tx[p] * ty[p];
      const double x = xx[p] - along * tx[p] * tx[p], y = yy[p] - along * ty[p] * ty[p],
                   shear = xy[p] - along * tx[p] * ty[p];
      const double apart = (xx[p] + yy[p] - other(column::stress)[p] - other(column::stress, 1)[p]) / 2;
      squares_.stress += xx[p] * xx[p] + yy[p] * yy[p] + 2 * xy[p] * xy[p];
      squares_.off_tangent += x * x + y * y + 2 * shear * shear;
      squares_.spread += apart * apart;
      least_tension_ = smaller(least_tension_, along);
    }
  }

  // Root of the mean square of the points' distances to the same places of the string by finite elements, over the
  // frames that the run reached.
  double from_fem() const {
    std::vector<double> at;
    for (std::size_t k = 0; k < frames_.size(); ++k) at.push_back(frame(k));
    const auto nodes = reference::bar_pendulum(at_.pendulum, fem_elements, at);
    double square = 0, count = 0;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const std::size_t points = frames_[k].size() / 2;
      for (std::size_t p = 0; p < points; ++p) {
        const double place = static_cast<double>(p) / static_cast<double>(points - 1) * fem_elements;
        const auto e = static_cast<std::size_t>(std::min(std::floor(place), fem_elements - 1.0));
        for (std::size_t d = 0; d < 2; ++d) {
          const double from = nodes[k][e][d], to = nodes[k][e + 1][d];
          const double off = frames_[k][2 * p + d] - from - (place - static_cast<double>(e)) * (to - from);
          square += off * off;
        }
        ++count;
      }
    }
    return std::sqrt(square / count);
  }
  static constexpr int fem_elements = 39;  // between as many nodes as York's second mesh has points

  std::vector<double> times_of(const std::vector<std::size_t>& rows) const {
    std::vector<double> times;
    for (const std::size_t k : rows) times.push_back(times_[k]);
    return times;
  }

  double mean_length() const {
    double sum = 0;
    for (const double length : length_) sum += length;
    return sum / static_cast<double>(length_.size());
  }

  // Of the exact length over the same times, as a share of the length at the start.
  reference::Bounded mean_exact_length() const {
    const auto states = exact_.at(times_of(thinned_rows(times_.size(), 2000)));
    reference::Bounded sum;
    for (const reference::PendulumState& state : states) sum = sum + state.length;
    return sum / static_cast<double>(states.size()) / exact_.length() - 1.0;
  }

  Settings settings_;
  Swing at_;
  reference::ElasticPendulum exact_;
  std::vector<double> times_, angle_, length_, kinetic_, elastic_;
  double misalignment_ = 0, least_tension_ = 0;
  std::vector<std::vector<double>> frames_;  // x, y of the points
  Squares squares_;
};

std::vector<StudyPlan> studies() {
  return {
      study("default", "default, the walls out of reach",
            "Order 2: the bob's kernel adds the inertia m h^2/4 about the pivot.", {5, 10, 20})
          .in_full({5, 10, 20, 40})
          .pictured(27, 20),
      study("york1997", "York's two coarser meshes in his box", "Fig. 37: the loss shrinks with refinement.", {10})
          .of_york()
          .in_full({5, 10})
          .pictured(36, 10),
      study("york-fine", "York's two finer meshes in his box", "Fig. 37: the loss shrinks with refinement.", {20, 40})
          .of_york()
          .in(Tier::full),
      study("york-half", "York's third mesh, half a swing", "Fig. 37: the loss shrinks with refinement.", {20})
          .of_york()
          .with({{"t_end", 0.75}})
          .in(Tier::full),
      study("york-swing", "York's finest mesh, one swing", "Fig. 37: the loss shrinks with refinement.", {40})
          .of_york()
          .with({{"t_end", 1.25}})
          .in(Tier::full),
      study("york-free", "York's second mesh without the one-way law", "Fig. 38: points align less well.", {10})
          .of_york()
          .with({{"one_way", "no"}})
          .pictured(36),
      study("york-increments", "York's second mesh, strain increments rotated once",
            "Section 5.4.2: what York's code did before it kept the total strain along the tangent.", {10})
          .of_york()
          .with({{"strain", "increments"}, {"t_end", 0.05}}),
      study("york-layers", "York's second mesh, two layers of points through the thickness",
            "Section 5.4.5: nothing makes their stresses equal.", {10})
          .of_york()
          .with({{"layers", 2.0}, {"t_end", 0.25}}),
      study("free", "default without the one-way law", "The bounce on the string is too fast to matter to the swing.",
            {10})
          .with({{"one_way", "no"}})
          .in(Tier::full),
      study("box", "default in York's box", "A wall within a kernel of the bob mirrors it.", {5, 10, 20})
          .with({{"box", "york"}})
          .in(Tier::full),
      accumulated_study("As the default: the string is hardly stretched.", {10}).in_full({5, 10, 20, 40})};
}

// The period's error over T h^2/(8 L^2).
const Number period_constant = number_at(
    "error of the period over T h^2/(8 L^2) at 20 cells", "period", 20,
    [](const RunResult& run, const Measure& period) {
      const double length = reference::ElasticPendulum({}).length().value;
      return Measured::of(period.error * 8 * length * length / (*period.reference * run.h * run.h));
    });

// The least ratio of the errors at two levels that the reference's own bound leaves.
Number least_ratio(const std::string& measure, double coarse, double fine) {
  return number_of(measure + " at " + to_text(coarse) + " over " + to_text(fine),
                   [=](const StudyResult& s) {
                     const Measure *a = s.level(coarse)->run.find(measure), *b = s.level(fine)->run.find(measure);
                     if (!a || !b) throw std::runtime_error("a run has no " + measure);
                     return Measured::of((a->error - a->reference_bound) / (b->error + b->reference_bound));
                   },
                   {coarse, fine});
}

// What may be seen of a string's mean length in Fig. 37.
constexpr double unbroken = 0.01;

// How many runs stop, or end with a string that has torn.
const Number torn_runs = number_of("runs that stop or whose string tears", [](const StudyResult& s) {
  double torn = 0;
  for (const StudyLevel& at : s.levels) {
    torn += !at.run.finished || !(std::abs(*at.run.find("length_drift")->value) <= unbroken) ? 1 : 0;
  }
  return Measured::of(torn);
});

// Of what the bob has lost of its amplitude; all of it, of a run that stops before its end.
double lost(const StudyResult& study, const std::string& measure, double level) {
  const RunResult& run = study.level(level)->run;
  return run.finished ? run.find(measure)->error : 1;
}

// What was lost on one mesh of a study over what was on a finer one of another.
Number loss_over(const std::string& measure, const std::string& study, double coarse, const std::string& other,
                 double fine) {
  return number_of(measure + " at " + to_text(coarse) + " over " + to_text(fine), [=](const StudyResult& s) {
    const auto of = [&s](const std::string& id) -> const StudyResult& { return id == s.plan.id ? s : *s.sibling(id); };
    return Measured::of(lost(of(study), measure, coarse) / lost(of(other), measure, fine));
  });
}

// What was lost at 20 over what a power of h leaves between 10 and 40.
const Number loss_between = number_of(
    "amplitude_loss at 20 over the geometric mean of 10 and 40", [](const StudyResult& s) {
      const std::string measure = "amplitude_loss";
      return Measured::of(lost(*s.sibling("york-fine"), measure, 20) /
                          std::sqrt(lost(*s.sibling("york1997"), measure, 10) * lost(s, measure, 40)));
    });

// A measure over that of another study, at 10.
Number over_sibling(const std::string& measure, const std::string& other) {
  return number_of(measure + " at 10 over that of " + other,
                   [=](const StudyResult& s) {
                     const RunResult &own = s.level(10)->run, &its = s.sibling(other)->level(10)->run;
                     for (const RunResult* run : {&own, &its}) {
                       if (const auto stop = stop_of(*run)) return *stop;
                     }
                     return Measured::of(own.find(measure)->error / its.find(measure)->error);
                   },
                   {10});
}

// Of a rigid pendulum at the bottom, m/s.
double fastest_bob() {
  const reference::ElasticPendulum swing({});
  return std::sqrt(2 * swing.problem().gravity * swing.length().value * (1 - std::cos(swing.angle().value)));
}

std::vector<CaseGate> gates() {
  const double heavy_period = reference::ElasticPendulum({}).heavy_period().value, tenth_percent = 1e-3 * heavy_period;
  const double last_frame = 1.25;  // s
  const std::string bands = "2026-11-23 5825b24";
  std::vector<CaseGate> all;
  for (const std::string study : {"default", "accumulated"}) {
    const Tier tier = study == "default" ? Tier::quick : Tier::full;
    all.push_back(
        gate(study + "/period-20", error_at("period", 20), at_most(tenth_percent),
             requirement("within 0.1 % of the elastic pendulum; the bob's smeared inertia makes h^2/(8 L^2) = 0.06 %"))
            .in(tier));
    all.push_back(gate(study + "/loss-20", error_at("amplitude_loss", 20), at_most(1e-3),
                       requirement("at most 0.1 % in a whole swing: the amplitude would halve in seven hundred"))
                      .in(tier));
    all.push_back(gate(study + "/aligned-20", value_at("misalignment", 20), at_most(0.1 / 79),
                       requirement("points on the chord: York judges by eye, where points touch; a tenth of their "
                                   "spacing, L/79, is not seen"))
                      .in(tier));
  }
  for (const std::string measure : {"period", "amplitude_loss"}) {
    for (const auto& [coarse, fine] : {std::pair{5.0, 10.0}, {10.0, 20.0}, {20.0, 40.0}}) {
      all.push_back(gate("default/" + measure + "-" + to_text(coarse) + "-" + to_text(fine),
                         least_ratio(measure, coarse, fine), at_least(std::pow(2, 1.5)),
                         theory("order 2 divides it by 4 at every halving of h; 2^1.5, half an order less, for coarse "
                                "meshes. The bound of the reference counts against it"))
                        .in(fine == 40 ? Tier::full : Tier::quick));
    }
  }
  const std::vector<CaseGate> rows{
      gate("default/period-constant-20", period_constant, between(0.92, 1.08),
           theory("the bob's kernel turns with the string and adds the inertia m h^2/4: too long by the share h^2/(8 "
                  "L^2); 7 % for the next order, h/L, and 1 % for the bound of the reference")),
      gate("box/period-20", error_at("period", 20), at_most(tenth_percent),
           requirement("within 0.1 % of the elastic pendulum, as in the wide box: two cells to the wall"))
          .in(Tier::full),
      gate("box/period-10", error_at("period", 10), at_most(4 * tenth_percent),
           theory("four times what is required at half the cell, as at second order"))
          .fails("the left wall stands one cell from the bob at its release, within its kernel, and mirrors it",
                 {0.028, 0.0345}, bands)
          .in(Tier::full),
      gate("free/loss-10", value_at("amplitude_loss", 10), at_most(4e-3),
           theory("the one-way law does not matter to the swing: at most four times what is required at half the cell, "
                  "as at second order"))
          .in(Tier::full)};

  const Because figure = literature("the loss shrinks with refinement, Fig. 37");
  const Because near_figure = literature(
      "Fig. 37 spans 1.8 s; York sees reasonable agreement: 3 % of a period can be told there");
  const Because untorn = literature(
      "Fig. 37 shows swings to 1.8 s, so the string is whole; it stretches by 0.001, and a hundredth of its length "
      "cannot be seen there");
  const std::string torn =
      "the noise of its light points tears the string, at h = 0.05 in some runs from 1.0 s on, at 0.025 from 1.3 s: "
      "the bob "
      "falls to the floor and lies there with a velocity in the null space of the maps; some of the runs whose masses "
      "differ by 1e-14 of themselves stop";
  const Because tangent = literature(
      "York, section 5.4.2: the stress is tangent where the total strain is kept along the tangent; to rounding");
  const Because similar = literature(
      "York, section 5.7.3: without the one-way law the results are similar; as near to the finite elements "
      "as is asked of those with it");
  const Because towards_fem = literature(
      "York, section 5.7: convergence towards the finite elements, whose frames Fig. 36 shows");
  const std::vector<CaseGate> sections{
      gate("york1997/frames-10", value_at("from_fem", 10), at_most(0.03 * heavy_period * fastest_bob()),
           literature("Fig. 36 beside Fig. 33, frames until 1.25 s: York sees reasonable agreement; 3 % of a period, "
                      "which can be told in Fig. 37, at the bob's greatest speed")),
      gate("default/frames-5-10", ratio_of("from_fem", 5, 10), at_least(1), towards_fem),
      gate("default/frames-10-20", ratio_of("from_fem", 10, 20), at_least(1), towards_fem),
      gate("default/frames-20", value_at("from_fem", 20), at_most(1e-3 * last_frame * fastest_bob()),
           requirement("late by at most 0.1 % of the 1.25 s until the last frame, as is asked of the period, at the "
                       "bob's greatest speed")),
      gate("york-free/misaligned", over_sibling("mean_misalignment", "york1997"), at_least(1.01),
           literature("York, section 5.7.3, Fig. 38: without the one-way law points are not aligned as well; a "
                      "hundredth, for a law without any effect"))
          .beside({"york1997"}),
      gate("york-free/frames-10", value_at("from_fem", 10), at_most(0.03 * heavy_period * fastest_bob()), similar),
      gate("york-free/compressed", value_at("least_tension", 10), at_most(-0.01),
           literature("York, section 5.7.3, Fig. 38: what may misalign points is that oscillations along the string "
                      "compress some; a hundredth of the stress at rest, for none")),
      gate("york1997/tangent", value_at("off_tangent", 10), at_most(1e-12), tangent),
      gate("york-increments/tangent", value_at("off_tangent", 10), at_most(1e-12), tangent)
          .fails("what was summed stays where it was as the string turns: a twentieth of a second on, its forces push "
                 "the points 2.5 % of the length off the chord, and soon after out of the grid",
                 {0.080, 0.105}, "2026-11-26 efaf9f4"),
      gate("york-layers/constant-stress", value_at("stress_spread", 10), at_most(0.1),
           literature("York, section 5.4.5: stress must be constant through the thickness, a tenth of it left"))
          .fails("each layer hangs from the wall by itself and has a tangential strain of its own: as the string turns "
                 "about its end one is stretched and the other is let go, as in a bent plate; by 0.1 s the "
                 "difference is 0.43 of the stress",
                 {0.52, 0.69}, "2026-11-26 efaf9f4")};

  // Once the string has torn, a run is as roundings will: these bands hold what ensembles of runs show (ci/ensembles).
  const StopBand on_20{95000, 175000, "velocity"}, on_40{270000, 350000, "position"};
  const std::vector<CaseGate> york{
      gate("york-fine/length-20", value_at("length_drift", 20), between(-unbroken, unbroken), untorn)
          .fails(torn, {0.02, 0.28}, bands)
          .or_stops(on_20)
          .in(Tier::full),
      gate("york-fine/length-40", value_at("length_drift", 40), between(-unbroken, unbroken), untorn)
          .fails(torn, {0.0101, 0.12}, bands)
          .or_stops(on_40)
          .in(Tier::full),
      gate("york-fine/finite", torn_runs, exactly(0), untorn).fails(torn, {2, 2}, bands).in(Tier::full),
      gate("york1997/period-10", error_at("period", 10), at_most(0.03 * heavy_period), near_figure),
      gate("york1997/period-5", error_at("period", 5), at_most(0.03 * heavy_period), near_figure)
          .fails("the bob starts half a cell from the left wall and never swings across", {0.93, 1.13}, bands)
          .in(Tier::full),
      gate("york-half/half-loss-10-20", loss_over("half_loss", "york1997", 10, "york-half", 20), at_least(1), figure)
          .beside({"york1997"})
          .in(Tier::full),
      gate("york-half/half-loss-20-40", loss_over("half_loss", "york-half", 20, "york-swing", 40), at_least(1), figure)
          .beside({"york-swing"})
          .in(Tier::full),
      gate("york-swing/loss-10-40", loss_over("amplitude_loss", "york1997", 10, "york-swing", 40), at_least(1), figure)
          .beside({"york1997"})
          .in(Tier::full),
      gate("york-swing/loss-20", loss_between, at_most(1),
           theory("the loss shrinks with refinement, Fig. 37: as a power of h, of which the mesh between two has the "
                  "geometric mean"))
          .beside({"york1997", "york-fine"})
          .fails(
              "on the way back at h = 0.05 the light points of the string keep, under FLIP and linear shapes, what "
              "noise each crossing of a cell's side gives them, leave the chord by a tenth of its length and tear "
              "the string: in some of the runs that differ by roundings the bob comes back, a tenth of its amplitude "
              "short, in others it does not, or the run stops",
              {1.05, 27}, bands)
          .in(Tier::full)};
  return joined({all, rows, sections, york});
}

Case pendulum() {
  return {.name = "pendulum",
          .kind = Kind::membrane,
          .keys = Swing().keys(),
          .sets = {{"cells", 20.0}},
          .york1997 = {{"cells", 10.0}, {"box", "york"}, {"layout", "york"}, {"t_end", 1.75}, york_strain()},
          .york_step = step_over_cells(2e-4),  // 2e-5 s at h = 0.1 [York A.4.5]
          .problem = run_of<PendulumRun>,
          .studies = studies(),
          .gates = gates(),
          .levels = {5, 10, 20},
          .may_be_undefined = {{"period", "a bob that does not come back has none"}}};
}
PLUMBLINE_CASE(pendulum);

}  // namespace
}  // namespace plumbline
