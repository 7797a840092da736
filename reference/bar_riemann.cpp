#include "reference/bar_riemann.hpp"

#include <algorithm>

#include "reference/argument.hpp"

namespace plumbline::reference {
namespace {

void check_problem(const BarRiemannProblem& problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_positive("density", problem.density);
  check_positive("area", problem.area);
  check_positive("length", problem.length);
  check_finite("left", problem.left);
  if (problem.pieces.empty() || problem.pieces.front().from != problem.left) {
    throw ParameterError("from", problem.pieces.empty() ? 0 : problem.pieces.front().from, "the first piece at left");
  }
  for (std::size_t i = 0; i < problem.pieces.size(); ++i) {
    const BarPiece& piece = problem.pieces[i];
    const bool in_order = i == 0 || piece.from > problem.pieces[i - 1].from;
    if (!in_order || !(piece.from < problem.left + problem.length)) {
      throw ParameterError("from", piece.from, "pieces in order inside the bar");
    }
    check_finite("velocity", piece.velocity);
    check_finite("stress", piece.stress);
  }
}

const BarPiece& piece_at(const BarRiemannProblem& problem, double x) {
  std::size_t i = problem.pieces.size() - 1;
  while (i > 0 && x < problem.pieces[i].from) --i;
  return problem.pieces[i];
}

double sign_of(BarEnd end) { return end == BarEnd::free ? 1 : -1; }

/// The length of a piece.
Bounded extent(const BarRiemannProblem& problem, std::size_t i) {
  const Bounded start = Bounded(problem.pieces[i].from) - problem.left;
  if (i + 1 == problem.pieces.size()) return Bounded(problem.length) - start;
  return Bounded(problem.pieces[i + 1].from) - problem.pieces[i].from;
}

}  // namespace

std::vector<BarPiece> left_half_moves() { return {{0, 1, 0}, {0.5, 0, 0}}; }

BarRiemann::BarRiemann(const BarRiemannProblem& problem) : problem_(problem) {
  check_problem(problem);
  speed_ = sqrt(Bounded(problem.youngs_modulus) / problem.density);
  impedance_ = sqrt(Bounded(problem.youngs_modulus) * problem.density);
  std::vector<WaveStep> rightward, leftward;
  for (std::size_t i = 0; i < problem.pieces.size(); ++i) {
    const BarPiece& piece = problem.pieces[i];
    const Bounded start = Bounded(piece.from) - problem.left, v(piece.velocity), s = Bounded(piece.stress) / impedance_;
    rightward.push_back({start, v - s, v + s});
    leftward.push_back({Bounded(problem.length) - start - extent(problem, i), v + s, v - s});
  }
  std::reverse(leftward.begin(), leftward.end());
  leftward.front().from = 0.0;
  const double left = sign_of(problem.left_end), right = sign_of(problem.right_end);
  rightward_ = UnfoldedWave(rightward, problem.length, left, right);
  leftward_ = UnfoldedWave(leftward, problem.length, right, left);
}

// u_t = (w+ + w-)/2, and each invariant passes x at the speed c: u = (int_{x-ct}^x w+ + int_x^{x+ct} w-)/(2 c).
BarState BarRiemann::state(Bounded x, Bounded time) const {
  const double L = problem_.length;
  const Bounded place = x - problem_.left, mirrored = Bounded(L) - place;
  const double margin = place.bound + 4 * rounding::unit * (std::abs(problem_.left) + L);
  if (!(place.value >= -margin && place.value <= L + margin))
    throw ParameterError("position", x.value, "inside the bar");
  check_finite("time", time.value);
  if (highest(time) < 0) throw ParameterError("time", time.value, "[0, inf)");
  if (time.value == 0 && time.bound == 0 && x.bound == 0) {
    const BarPiece& piece = piece_at(problem_, x.value);
    return {0.0, piece.velocity, piece.stress};
  }
  const Bounded travelled = speed_ * time;
  const Bounded right = rightward_.value(place - travelled), left = leftward_.value(mirrored - travelled);
  const Bounded passed = rightward_.integral(place) - rightward_.integral(place - travelled) +
                         leftward_.integral(mirrored) - leftward_.integral(mirrored - travelled);
  return {Bounded(0.5) * passed / speed_, Bounded(0.5) * (right + left), Bounded(0.5) * impedance_ * (left - right)};
}

Bounded BarRiemann::energy() const {
  Bounded total = 0.0;
  for (std::size_t i = 0; i < problem_.pieces.size(); ++i) {
    const Bounded v(problem_.pieces[i].velocity), s(problem_.pieces[i].stress);
    const Bounded density = Bounded(problem_.density) * v * v + s * s / problem_.youngs_modulus;
    total = total + Bounded(0.5) * problem_.area * extent(problem_, i) * density;
  }
  return total;
}

Bounded BarRiemann::momentum() const {
  Bounded total = 0.0;
  for (std::size_t i = 0; i < problem_.pieces.size(); ++i) {
    total = total + Bounded(problem_.density) * problem_.area * extent(problem_, i) * problem_.pieces[i].velocity;
  }
  return total;
}

}  // namespace plumbline::reference
