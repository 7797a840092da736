#include "reference/two_bar.hpp"

#include <cmath>
#include <stdexcept>

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

constexpr int corners = 4, unknowns = 8;

}  // namespace

// By 2 x 2 Gauss points, plane stress.
RectangleStiffness rectangle_stiffness(const TwoBarProblem& p, double width, double height) {
  const double at[corners][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double modulus = p.youngs_modulus / (1 - p.poisson * p.poisson), shear = 0.5 * (1 - p.poisson) * modulus;
  RectangleStiffness stiffness{};
  for (const auto& corner : at) {
    const double xi = corner[0] / std::sqrt(3.0), eta = corner[1] / std::sqrt(3.0);
    double slope[corners][2];
    for (int a = 0; a < corners; ++a) {
      slope[a][0] = at[a][0] * (1 + at[a][1] * eta) / (2 * width);
      slope[a][1] = at[a][1] * (1 + at[a][0] * xi) / (2 * height);
    }
    for (int a = 0; a < corners; ++a) {
      for (int b = 0; b < corners; ++b) {
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            const double across = slope[a][1 - i] * slope[b][1 - j], own = slope[a][i] * slope[b][j];
            const double value = modulus * (i == j ? 1 : p.poisson) * own + shear * across;
            stiffness[2 * a + i][2 * b + j] += 0.25 * width * height * value;
          }
        }
      }
    }
  }
  return stiffness;
}

namespace {

/// The upper half of one bar, from the wall at x = 0, moving to it at speed 1 (all is linear in the speed).
class HalfBar {
 public:
  HalfBar(const TwoBarProblem& p, int elements, int aspect)
      : columns_(elements),
        rows_(std::max(2, static_cast<int>(std::lround(0.5 * p.height / (aspect * p.width / elements))))),
        width_(p.width / elements),
        height_(0.5 * p.height / rows_),
        step_(width_ / std::sqrt(p.youngs_modulus / ((1 - p.poisson * p.poisson) * p.density))),
        stiffness_(rectangle_stiffness(p, width_, height_)),
        mass_(nodes()),
        moved_(2 * nodes()),
        velocity_(2 * nodes()),
        force_(2 * nodes()) {
    for_each_element([&](const std::array<std::size_t, corners>& at) {
      for (std::size_t node : at) mass_[node] += 0.25 * p.density * width_ * height_;
    });
    for (std::size_t node = 0; node < nodes(); ++node) velocity_[2 * node] = -1;
  }

  double step() const { return step_; }
  double contact_work() const { return contact_work_; }
  double impulse() const { return impulse_; }

  double momentum() const {
    double sum = 0;
    for (std::size_t node = 0; node < nodes(); ++node) sum += mass_[node] * velocity_[2 * node];
    return sum;
  }

  /// What central differences conserve: velocities half a step before, displacements from either side of them.
  double energy() {
    internal_forces();
    double sum = 0;
    for (std::size_t k = 0; k < velocity_.size(); ++k) {
      const double before = moved_[k] - step_ * velocity_[k];
      sum += 0.5 * mass_[k / 2] * velocity_[k] * velocity_[k] - 0.5 * force_[k] * before;
    }
    return sum;
  }

  /// One step of central differences [Hughes 9.1]; the mean contact force over it.
  double advance() {
    internal_forces();
    for (std::size_t k = 0; k < velocity_.size(); ++k) {
      const double earlier = velocity_[k];
      velocity_[k] += step_ * force_[k] / mass_[k / 2];
      force_[k] = earlier;  // kept for the work of the contact
    }
    for (int i = 0; i <= columns_; ++i) velocity_[2 * node(i, 0) + 1] = 0;  // symmetry
    const double push = touch();
    for (std::size_t k = 0; k < moved_.size(); ++k) moved_[k] += step_ * velocity_[k];
    impulse_ += push;
    return push / step_;
  }

 private:
  std::size_t nodes() const { return static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1); }
  std::size_t node(int i, int j) const { return static_cast<std::size_t>(j * (columns_ + 1) + i); }

  template <class Visit>
  void for_each_element(const Visit& visit) const {
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) visit({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  }

  void internal_forces() {
    std::fill(force_.begin(), force_.end(), 0.0);
    for_each_element([&](const std::array<std::size_t, corners>& at) {
      double local[unknowns], pull[unknowns] = {};
      for (int a = 0; a < unknowns; ++a) local[a] = moved_[2 * at[a / 2] + a % 2];
      for (int b = 0; b < unknowns; ++b) {
        for (int a = 0; a < unknowns; ++a) pull[a] += stiffness_[b][a] * local[b];
      }
      for (int a = 0; a < unknowns; ++a) force_[2 * at[a / 2] + a % 2] -= pull[a];
    });
  }

  /// Nodes of the face that would pass the wall stop at it; the impulse that it takes.
  double touch() {
    double push = 0;
    for (int j = 0; j <= rows_; ++j) {
      const std::size_t k = 2 * node(0, j);
      const double allowed = -moved_[k] / step_;
      if (velocity_[k] >= allowed) continue;
      const double own = mass_[k / 2] * (allowed - velocity_[k]);
      contact_work_ += 0.5 * own * (allowed + force_[k]);
      push += own;
      velocity_[k] = allowed;
    }
    return push;
  }

  int columns_, rows_;
  double width_, height_, step_;
  RectangleStiffness stiffness_;
  std::vector<double> mass_, moved_, velocity_, force_;
  double contact_work_ = 0, impulse_ = 0;
};

void check_two_bar(const TwoBarProblem& p) {
  check_positive("width", p.width);
  check_positive("height", p.height);
  check_positive("youngs_modulus", p.youngs_modulus);
  check_within("poisson", p.poisson, 0, 0.45);
  check_positive("density", p.density);
  check_positive("speed", p.speed);
  if (!(p.height >= 0.25 * p.width)) throw ParameterError("height", p.height, "at least a quarter of the width");
}

}  // namespace

TwoBarRun run_two_bar(const TwoBarProblem& problem, int elements, int aspect) {
  check_two_bar(problem);
  check_within("elements", elements, 8, 5000);
  check_within("aspect", aspect, 1, 16);
  HalfBar bar(problem, elements, aspect);
  TwoBarRun run;
  run.elements = elements;
  run.aspect = aspect;
  run.step = bar.step();
  const double mass = -bar.momentum(), before = 0.5 * mass;  // at speed 1
  const int steps = 3 * elements;                            // half as long again as the contact
  for (int n = 0; n < steps; ++n) {
    run.time.push_back(n * bar.step());
    run.force.push_back(problem.speed * bar.advance());  // both halves at half the relative speed
  }
  run.restitution = bar.momentum() / mass;
  run.energy_kept = bar.energy() / before;
  run.contact_work = bar.contact_work() / before;
  run.impulse = bar.impulse() / mass;
  if (!(run.energy_kept <= 1 + 1e-9)) throw std::domain_error("two_bar: the mesh is not stable for this problem");
  return run;
}

namespace {

/// First order removed from two meshes, the second twice as fine.
double extrapolated(const TwoBarRun& coarse, const TwoBarRun& fine) {
  return 2 * fine.restitution - coarse.restitution;
}

/// End of the last step whose force is above a hundredth of the first.
double force_ends(const TwoBarRun& run) {
  std::size_t last = 0;
  for (std::size_t n = 0; n < run.force.size(); ++n) {
    if (run.force[n] > 0.01 * run.force[0]) last = n;
  }
  return run.time[last] + 0.5 * run.step;
}

}  // namespace

Bounded plane_wave_speed(const TwoBarProblem& problem) {
  const Bounded nu(problem.poisson), stiff = Bounded(problem.youngs_modulus) / ((Bounded(1) - nu) * (Bounded(1) + nu));
  return sqrt(stiff / problem.density);
}

Bounded plane_contact_duration(const TwoBarProblem& problem) {
  return Bounded(2) * problem.width / plane_wave_speed(problem);
}

TwoBar::TwoBar(const TwoBarProblem& problem, int elements) : problem_(problem) {
  check_two_bar(problem);
  check_within("elements", elements, 32, 5000);
  const int quarter = elements / 4;
  for (int n : {quarter, 2 * quarter, 4 * quarter}) runs_.push_back(run_two_bar(problem, n));
  const TwoBarRun other_coarse = run_two_bar(problem, 2 * quarter, 8), other = run_two_bar(problem, 4 * quarter, 8);

  const double value = extrapolated(runs_[1], runs_[2]);
  const double meshes = std::abs(value - extrapolated(runs_[0], runs_[1]));
  const double aspects = std::abs(value - extrapolated(other_coarse, other));
  const double correction = std::abs(value - finest().restitution);
  restitution_ = {value, 3 * std::max(meshes, aspects) + 0.1 * correction};

  wave_speed_ = plane_wave_speed(problem);
  peak_force_ = Bounded(0.5) * problem.density * wave_speed_ * problem.speed * problem.height;
  duration_ = plane_contact_duration(problem);
  const double ends = force_ends(finest());
  if (std::abs(ends - duration_.value) > 2 * finest().step) duration_ = hull(duration_, {ends, finest().step});
}

Bounded TwoBar::impulse() const {
  const Bounded mass = Bounded(problem_.density) * problem_.width * problem_.height;
  return Bounded(0.5) * mass * problem_.speed * (Bounded(1) + restitution_);
}
Bounded TwoBar::velocity_of_hit_bar() const { return Bounded(0.5) * problem_.speed * (Bounded(1) + restitution_); }
Bounded TwoBar::velocity_of_hitting_bar() const { return Bounded(0.5) * problem_.speed * (Bounded(1) - restitution_); }
Bounded TwoBar::translation_share() const { return restitution_ * restitution_; }
Bounded TwoBar::vibration_share() const { return Bounded(1) - restitution_ * restitution_; }

}  // namespace plumbline::reference
