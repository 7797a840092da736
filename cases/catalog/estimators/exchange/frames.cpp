// Which snapshots are taken of a run, and of which points: bodies that move as a whole, without a force.
#include "cases/harness/run/frames.hpp"

#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/given_stress.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/measures.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

constexpr int numbered_points = 20, threaded_points = 5;
constexpr double drift_x = 0.5, drift_y = -0.25;  // m/s, of all points

double place_of_number(int number, int direction) {
  return direction == 0 ? 1.25 + 0.125 * (number % 7) : 2.5 + 0.0625 * number;
}
double place_on_thread(int number, int direction) { return 1.5 + (direction == 0 ? 0.15 : 0.2) * number; }

void put_points(Body& body, double (*place)(int, int)) {
  for (int p = 0; p < body.points.points(); ++p) {
    for (int d = 0; d < 2; ++d) body.points(column::position, d)[p] = place(p, d);
    body.points(column::velocity, 0)[p] = drift_x;
    body.points(column::velocity, 1)[p] = drift_y;
    body.points(column::mass)[p] = body.points(column::volume)[p] = 0.0625;
  }
}

// A solid whose points the engine sorts, and a chain beside it: neither has a stress.
Scene drifting_scene() {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.h = 0.5;
  scene.grid.cells = {10, 10, 1};
  auto thread = std::make_shared<UniaxialMembrane>();
  thread->youngs_modulus = thread->density = 1;
  scene.bodies.push_back(
      make_body("solid", std::make_shared<GivenStress>(StressMeasure::symmetric), numbered_points, 2));
  scene.bodies.push_back(make_body("thread", thread, threaded_points, 2));
  put_points(scene.bodies[0], place_of_number);
  put_points(scene.bodies[1], place_on_thread);
  return scene;
}

// A run of one second, looked at as experiments do; `broken_off`: the recorder is written down and read again after each look.
FrameSet frames_of_drift(const FrameRequest& request, double dt, bool broken_off = false) {
  Simulation simulation(drifting_scene(), "usl", {.dt = dt});
  auto recorder = std::make_unique<FrameRecorder>(request, simulation.scene(), 1);
  const auto look = [&](const Simulation& at) {
    recorder->look(at);
    if (!broken_off) return;
    Archive written;
    recorder->history(written);
    const Archive::Table kept = written.take();
    Archive read(kept);
    recorder = std::make_unique<FrameRecorder>(request, at.scene(), 1);
    recorder->history(read);
  };
  look(simulation);
  simulation.run_until(1, look);
  return recorder->take();
}

void add_instants(const std::string& name, const FrameSet& set, const std::vector<double>& exact, KnownAnswers& all) {
  all.push_back({name + ".count", static_cast<double>(set.frames.size()), static_cast<double>(exact.size())});
  for (std::size_t k = 0; k < std::min(set.frames.size(), exact.size()); ++k) {
    all.push_back({name + "." + std::to_string(k), set.frames[k].time, exact[k]});
  }
}

// Instants that are wanted lie between steps, upon steps that rounding leaves a little before them, or closer than these.
void add_all_instants(KnownAnswers& all) {
  add_instants("between", frames_of_drift({3, 0}, 0.3), {0, 0.6, 1}, all);
  add_instants("upon", frames_of_drift({6, 0}, 0.1), {0, 0.2, 0.4, 0.6, 0.8, 1}, all);
  add_instants("after", frames_of_drift({4, 0}, 0.05), {0, 0.35, 0.7, 1}, all);
  add_instants("closer", frames_of_drift({9, 0}, 0.3), {0, 0.3, 0.6, 0.9, 1}, all);
  add_instants("none", frames_of_drift({0, 0}, 0.3), {}, all);
  all.push_back({"none.bodies", static_cast<double>(frames_of_drift({0, 0}, 0.3).bodies.size()), 0});
}

// Of points with these numbers, and of the whole chain after them.
void add_points(const std::string& name, const FrameSet& set, const std::vector<int>& numbers, double every,
                KnownAnswers& all) {
  all.push_back({name + ".every", static_cast<double>(set.every), every});
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    const Frame& frame = set.frames[k];
    const std::string here = name + "." + std::to_string(k);
    std::vector<double> ids, places, velocities;
    const auto add = [&](int number, double (*place)(int, int)) {
      ids.push_back(number);
      for (const double x : {place(number, 0) + drift_x * frame.time, place(number, 1) + drift_y * frame.time, 0.0})
        places.push_back(x);
      for (const double v : {drift_x, drift_y, 0.0}) velocities.push_back(v);
    };
    for (const int number : numbers) add(number, place_of_number);
    for (int number = 0; number < threaded_points; ++number) add(number, place_on_thread);
    const std::vector<double> points{static_cast<double>(numbers.size()), threaded_points};
    all.push_back({here + ".points", farthest(frame.points, points), 0});
    all.push_back({here + ".id", farthest(frame.id, ids), 0});
    all.push_back({here + ".position", farthest(frame.position, places), 0});
    all.push_back({here + ".velocity", farthest(frame.velocity, velocities), 0});
    all.push_back({here + ".stresses", static_cast<double>(frame.stress.size()), static_cast<double>(ids.size())});
    all.push_back({here + ".pressures", static_cast<double>(frame.pressure.size()), static_cast<double>(ids.size())});
  }
}

// One of n: numbers k of which the fraction of k (sqrt(5) - 1)/2 is below 1/n. What chains leave is for the others.
std::vector<int> kept_numbers(int every) {
  std::vector<int> kept;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  for (int k = 0; k < numbered_points; ++k) {
    if (every == 1 || golden * k - std::floor(golden * k) < 1.0 / every) kept.push_back(k);
  }
  return kept;
}
void add_thinning(KnownAnswers& all) {
  const auto thinned = [&](const std::string& name, long most, int every) {
    add_points(name, frames_of_drift({2, most}, 0.25), kept_numbers(every), every, all);
  };
  all.push_back({"half", static_cast<double>(kept_numbers(2).size()), 10});
  thinned("all", 0, 1);
  thinned("enough", numbered_points + threaded_points, 1);
  thinned("one_too_few", numbered_points + threaded_points - 1, 2);
  thinned("half", numbered_points / 2 + threaded_points, 2);
  thinned("third", 7 + threaded_points, 3);
  thinned("chains_alone", 3, numbered_points);
}

void add_broken_off(KnownAnswers& all) {
  const FrameSet whole = frames_of_drift({5, 12}, 0.1), parts = frames_of_drift({5, 12}, 0.1, true);
  add_instants("broken_off", parts, {0, 0.3, 0.5, 0.8, 1}, all);
  add_points("broken_off", parts, kept_numbers(3), 3, all);
  double different = 0;
  for (std::size_t k = 0; k < std::min(whole.frames.size(), parts.frames.size()); ++k) {
    const auto unlike = [](const std::vector<float>& a, const std::vector<float>& b) {
      return farthest(a, std::vector<double>(b.begin(), b.end()));
    };
    different = larger(different, unlike(parts.frames[k].stress, whole.frames[k].stress));
    different = larger(different, unlike(parts.frames[k].pressure, whole.frames[k].pressure));
  }
  all.push_back({"broken_off.values", different, 0});
}

// Whether five frames of what is kept of them, with another entry, are refused where `count` are wanted.
bool refuses_frames(int count, const std::string& entry, const std::vector<double>& values) {
  const Simulation simulation(drifting_scene(), "usl", {.dt = 0.1});
  FrameRecorder writer({5, 0}, simulation.scene(), 1), reader({count, 0}, simulation.scene(), 1);
  writer.look(simulation);
  Archive written;
  writer.history(written);
  Archive::Table kept = written.take();
  if (!entry.empty()) kept[entry] = values;
  Archive read(kept);
  return throws<ArchiveError>([&] { reader.history(read); });
}
void add_refused_frames(KnownAnswers& all) {
  const auto refused = [&](const std::string& name, bool found, bool exact) {
    all.push_back(whether("refused." + name, found, exact));
  };
  refused("as_kept", refuses_frames(5, "", {}), false);
  refused("as_many", refuses_frames(1, "", {}), false);
  refused("more", refuses_frames(0, "", {}), true);
  refused("less_than_none", refuses_frames(5, "count", {-1}), true);
  refused("time_of_another", refuses_frames(5, "time", {0, 1}), true);
}

void add_both(const std::string& name, const FrameRequest& one, const FrameRequest& other, double count, double most,
              KnownAnswers& all) {
  for (const auto& [order, both] : {std::pair{".", of_both(one, other)}, std::pair{".turned.", of_both(other, one)}}) {
    all.push_back({name + order + "count", static_cast<double>(both.count), count});
    all.push_back({name + order + "most_points", static_cast<double>(both.most_points), most});
  }
}

}  // namespace

KnownAnswers frame_answers() {
  KnownAnswers all;
  add_all_instants(all);
  add_thinning(all);
  add_broken_off(all);
  add_refused_frames(all);
  add_both("neither", {0, 7}, {0, 9}, 0, 0, all);
  add_both("one", {4, 7}, {0, 9}, 4, 7, all);
  add_both("two", {4, 7}, {3, 9}, 4, 9, all);
  add_both("all_points", {4, 7}, {5, 0}, 5, 0, all);
  return all;
}

}  // namespace plumbline
