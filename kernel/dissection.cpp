#include "kernel/dissection.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plumbline {
namespace {

using UnknownPlaces = std::vector<Eigen::Vector3d>;
using Sparse = Eigen::SparseMatrix<double>;

constexpr std::size_t smallest_halved = 200;  // unknowns: a dense matrix of so many fits a cache

// The coordinate in which the unknowns reach farthest.
int longest_side(const std::vector<int>& unknowns, const UnknownPlaces& places) {
  Eigen::Vector3d low = places[static_cast<std::size_t>(unknowns.front())], high = low;
  for (const int u : unknowns) {
    low = low.cwiseMin(places[static_cast<std::size_t>(u)]);
    high = high.cwiseMax(places[static_cast<std::size_t>(u)]);
  }
  int side = 0;
  (high - low).maxCoeff(&side);
  return side;
}

struct Halves {
  std::vector<int> first, second, between;  // no unknown of `first` couples with one of `second`
};
Halves halved(std::vector<int> unknowns, const Sparse& matrix, const UnknownPlaces& places) {
  const int side = longest_side(unknowns, places);
  std::stable_sort(unknowns.begin(), unknowns.end(), [&](int a, int b) {
    return places[static_cast<std::size_t>(a)][side] < places[static_cast<std::size_t>(b)][side];
  });
  const auto middle = unknowns.begin() + static_cast<std::ptrdiff_t>(unknowns.size() / 2);
  Halves halves;
  halves.first.assign(unknowns.begin(), middle);
  std::vector<bool> in_first(places.size(), false);
  for (const int u : halves.first) in_first[static_cast<std::size_t>(u)] = true;
  for (auto u = middle; u != unknowns.end(); ++u) {
    bool couples = false;
    for (Sparse::InnerIterator entry(matrix, *u); entry; ++entry)
      couples = couples || in_first[static_cast<std::size_t>(entry.row())];
    (couples ? halves.between : halves.second).push_back(*u);
  }
  return halves;
}

std::size_t at(int k) { return static_cast<std::size_t>(k); }

}  // namespace

DissectedCholesky::DissectedCholesky(const Sparse& matrix, const UnknownPlaces& places) : turn_(places.size()) {
  if (matrix.rows() != matrix.cols() || matrix.rows() != static_cast<int>(places.size())) {
    throw std::invalid_argument("a matrix of " + std::to_string(matrix.rows()) + " rows and " +
                                std::to_string(matrix.cols()) + " columns has " + std::to_string(places.size()) +
                                " places");
  }
  std::vector<int> all(places.size());
  for (std::size_t u = 0; u < all.size(); ++u) all[u] = static_cast<int>(u);
  if (!all.empty()) dissect(std::move(all), matrix, places);
  std::vector<Eigen::MatrixXd> updates(fronts_.size());
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    find_later(fronts_[f], matrix);
    updates[f] = eliminate(fronts_[f], matrix, updates);
  }
}

// Returns the front eliminated last.
int DissectedCholesky::dissect(std::vector<int> unknowns, const Sparse& matrix, const UnknownPlaces& places) {
  Front front;
  if (unknowns.size() > smallest_halved) {
    Halves halves = halved(std::move(unknowns), matrix, places);
    front.parts.push_back(dissect(std::move(halves.first), matrix, places));
    if (!halves.second.empty()) front.parts.push_back(dissect(std::move(halves.second), matrix, places));
    unknowns = std::move(halves.between);
  }
  front.first = static_cast<int>(unknown_.size());
  for (const int u : unknowns) {
    turn_[at(u)] = static_cast<int>(unknown_.size());
    unknown_.push_back(u);
  }
  front.end = static_cast<int>(unknown_.size());
  fronts_.push_back(std::move(front));
  return static_cast<int>(fronts_.size()) - 1;
}

void DissectedCholesky::find_later(Front& front, const Sparse& matrix) const {
  std::vector<int>& later = front.later;
  for (int k = front.first; k < front.end; ++k) {
    for (Sparse::InnerIterator entry(matrix, unknown_[at(k)]); entry; ++entry)
      later.push_back(turn_[at(static_cast<int>(entry.row()))]);
  }
  for (const int part : front.parts)
    later.insert(later.end(), fronts_[at(part)].later.begin(), fronts_[at(part)].later.end());
  std::sort(later.begin(), later.end());
  later.erase(std::unique(later.begin(), later.end()), later.end());
  later.erase(later.begin(), std::lower_bound(later.begin(), later.end(), front.end));
}

// Returns what is to be added to the entries of its later unknowns, lower triangle.
Eigen::MatrixXd DissectedCholesky::eliminate(Front& front, const Sparse& matrix,
                                             std::vector<Eigen::MatrixXd>& updates) {
  const int own = front.end - front.first, later = static_cast<int>(front.later.size());
  const auto place_of = [&](int turn) {
    if (turn < front.end) return turn - front.first;
    return own + static_cast<int>(std::lower_bound(front.later.begin(), front.later.end(), turn) - front.later.begin());
  };
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(own + later, own + later);
  for (int k = front.first; k < front.end; ++k) {
    for (Sparse::InnerIterator entry(matrix, unknown_[at(k)]); entry; ++entry) {
      const int turn = turn_[at(static_cast<int>(entry.row()))];
      if (turn >= k) all(place_of(turn), k - front.first) = entry.value();
    }
  }
  for (const int part : front.parts) {
    std::vector<int> places;
    for (const int turn : fronts_[at(part)].later) places.push_back(place_of(turn));
    const Eigen::MatrixXd& update = updates[at(part)];
    for (int j = 0; j < update.cols(); ++j) {
      for (int i = j; i < update.rows(); ++i) all(places[at(i)], places[at(j)]) += update(i, j);
    }
    updates[at(part)].resize(0, 0);
  }
  const Eigen::LLT<Eigen::MatrixXd> factors(all.topLeftCorner(own, own));
  if (factors.info() != Eigen::Success) throw std::invalid_argument("a matrix is not positive definite");
  front.own = factors.matrixL();
  front.below = all.bottomLeftCorner(later, own);
  front.own.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(front.below);
  Eigen::MatrixXd update = all.bottomRightCorner(later, later);
  update.selfadjointView<Eigen::Lower>().rankUpdate(front.below, -1);
  return update;
}

Eigen::VectorXd DissectedCholesky::solve(const Eigen::VectorXd& right) const {
  if (right.size() != static_cast<int>(unknown_.size())) {
    throw std::invalid_argument("a right side of " + std::to_string(right.size()) + " numbers for " +
                                std::to_string(unknown_.size()) + " unknowns");
  }
  Eigen::VectorXd by_turn(right.size());
  for (int k = 0; k < right.size(); ++k) by_turn[k] = right[unknown_[at(k)]];
  for (const Front& front : fronts_) {
    auto own = by_turn.segment(front.first, front.end - front.first);
    front.own.triangularView<Eigen::Lower>().solveInPlace(own);
    const Eigen::VectorXd gives = front.below * own;
    for (std::size_t k = 0; k < front.later.size(); ++k) by_turn[front.later[k]] -= gives[static_cast<int>(k)];
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    auto own = by_turn.segment(front->first, front->end - front->first);
    Eigen::VectorXd later(static_cast<int>(front->later.size()));
    for (std::size_t k = 0; k < front->later.size(); ++k) later[static_cast<int>(k)] = by_turn[front->later[k]];
    own -= front->below.transpose() * later;
    front->own.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
  Eigen::VectorXd found(right.size());
  for (int k = 0; k < right.size(); ++k) found[unknown_[at(k)]] = by_turn[k];
  return found;
}

}  // namespace plumbline
