// `plumbline reference mpm-stability`, points everywhere, and `mpm-edge-stability`, a bar with free ends.
#include <utility>

#include "reference/catalog/stability_parameters.hpp"

namespace plumbline::reference::catalog::mpm_stability {
namespace {

class LatticeStability : public Reference {
 public:
  std::string name() const override { return "mpm-stability"; }
  std::string title() const override {
    return "Largest stable step of the material-point method on an elastic bar, regular points everywhere";
  }
  std::string source() const override { return "Bloch waves, amplification matrix of the whole step"; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> all = scheme_parameters();
    all.insert(all.begin(), {{"points_per_cell", 2, 1, 16, false, false, "1", "points of each cell"},
                             {"offset", 0, -1, 1, false, false, "1", "of all points from the regular places, cells"},
                             {"courant", 1, 0, 100, true, false, "1", "Courant number of the rows"}});
    return all;
  }
  Parameter abscissa() const override {
    return {"wave_number", 0, 0, 3.15, false, false, "1", "phase of the wave a cell, rad"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const MapScheme scheme = map_scheme(s);
    const int per_cell = whole_number(s, "points_per_cell");
    const std::vector<double> points = regular_points(per_cell, s.at("offset"));
    const WorstOffset worst = worst_rigid_offset(scheme, per_cell);
    Answer answer;
    answer.add("courant_limit", periodic_courant_limit(scheme, points));
    answer.add("worst_offset_limit", worst.limit);
    answer.add("worst_offset", worst.offset);
    for (double theta : at) {
      add_row(answer, "wave_number", theta, {{"growth", wave_growth(scheme, points, theta, s.at("courant"))}});
    }
    return answer;
  }
};

class EdgeStability : public Reference {
 public:
  std::string name() const override { return "mpm-edge-stability"; }
  std::string title() const override {
    return "Largest stable step of the material-point method on an elastic bar with free ends between nodes";
  }
  std::string source() const override { return "Amplification matrix of the whole step"; }
  std::vector<Parameter> parameters() const override {
    std::vector<Parameter> all = scheme_parameters();
    all.insert(all.begin(), {{"points_per_cell", 2, 1, 8, false, false, "1", "points a cell"},
                             {"cells", 8, 1, 40, false, false, "1", "length of the bar, in cells"},
                             {"depth", 0.25, 0, 1, true, false, "1",
                              "of the leading point in a cell that no other point touches, at most the spacing"}});
    return all;
  }
  Parameter abscissa() const override {
    return {"length", 8, 1, 40, false, false, "1", "of another bar with the same leading point, in cells"};
  }

 private:
  Answer solve(const std::map<std::string, double>& s, std::span<const double> at) const override {
    const MapScheme scheme = map_scheme(s);
    const int per_cell = whole_number(s, "points_per_cell");
    auto limit = [&](int cells) {
      return free_bar_courant_limit(scheme, edge_points(per_cell, cells, s.at("depth")), 1.0 / per_cell);
    };
    Answer answer;
    answer.add("courant_limit", limit(whole_number(s, "cells")));
    for (double cells : at) add_row(answer, "length", cells, {{"courant_limit", limit(static_cast<int>(cells))}});
    return answer;
  }
};

const Registration lattice{std::make_unique<LatticeStability>()};
const Registration edge{std::make_unique<EdgeStability>()};

}  // namespace
}  // namespace plumbline::reference::catalog::mpm_stability
