#include "cases/catalog/membrane/pendulum_run.hpp"

#include "cases/catalog/membrane/rotated_increments.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/run/extremes.hpp"
#include "reference/bar_pendulum.hpp"

namespace plumbline {
namespace {

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

}  // namespace

std::unique_ptr<Problem> pendulum_run(const Settings& settings) { return std::make_unique<PendulumRun>(settings); }

}  // namespace plumbline
