// Places in space, found by where they are.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace plumbline {

// size: edge of the cubes that places are sorted into, m, > 0.
class Cubes {
 public:
  Cubes(std::vector<Eigen::Vector3d> places, double size) : places_(std::move(places)), size_(size) {
    for (std::size_t k = 0; k < places_.size(); ++k) held_[cube(places_[k])].push_back(k);
  }

  const Eigen::Vector3d& place(std::size_t k) const { return places_[k]; }

  // visit(k) for all places in the cube of x and in those beside it, each closer than `size` among them.
  template <class Visit>
  void for_near(const Eigen::Vector3d& x, Visit&& visit) const {
    const auto [i, j, k] = cube(x);
    for (long a = i - 1; a <= i + 1; ++a) {
      for (long b = j - 1; b <= j + 1; ++b) {
        for (long c = k - 1; c <= k + 1; ++c) {
          const auto found = held_.find({a, b, c});
          if (found == held_.end()) continue;
          for (const std::size_t n : found->second) visit(n);
        }
      }
    }
  }

 private:
  using Cube = std::tuple<long, long, long>;
  Cube cube(const Eigen::Vector3d& x) const {
    return {std::lround(std::floor(x[0] / size_)), std::lround(std::floor(x[1] / size_)),
            std::lround(std::floor(x[2] / size_))};
  }

  std::vector<Eigen::Vector3d> places_;
  double size_;
  std::map<Cube, std::vector<std::size_t>> held_;
};

}  // namespace plumbline
