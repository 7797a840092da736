// One swing of a heavy bob on a string of membrane points. [York section 5.7]
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/files/whole.hpp"
#include "reference/elastic_pendulum.hpp"

namespace plumbline {

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

// Case::problem.
std::unique_ptr<Problem> pendulum_run(const Settings& settings);

}  // namespace plumbline
