// Clouds of points and nodal velocities set by hand, and what contact makes of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "kernel/contact/contact.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/rotations.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::meetings {

using scenes::Place;

inline Body elastic_body(const std::string& name, int dim, const std::vector<Place>& places, double spacing,
                         Place velocity = {0, 0, 0}) {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = 100;
  law->poissons_ratio = 0.3;
  law->density = 1;
  Body body = make_body(name, law, static_cast<int>(places.size()), dim);
  body.field = name;
  body.spacing = spacing;
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (int d = 0; d < dim; ++d) {
      body.points(column::position, d)[p] = places[p][static_cast<std::size_t>(d)];
      body.points(column::velocity, d)[p] = velocity[static_cast<std::size_t>(d)];
    }
    body.points(column::volume)[p] = body.points(column::mass)[p] = std::pow(spacing, dim);
  }
  return body;
}

// Points with `spacing` in the box from low, `count` in each direction.
inline std::vector<Place> block(Place low, std::array<int, 3> count, double spacing) {
  std::vector<Place> places;
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        places.push_back({low[0] + (i + 0.5) * spacing, low[1] + (j + 0.5) * spacing, low[2] + (k + 0.5) * spacing});
      }
    }
  }
  return places;
}

// Nodal fields of some bodies, all nodes touched with random masses, and what a contact made of them.
template <int dim>
struct Meeting {
  using Vec = Eigen::Matrix<double, dim, 1>;
  Scene scene;
  Grid<dim> grid;
  std::vector<VelocityField<dim>> fields;
  std::vector<std::size_t> field_of_body;
  std::vector<ContactChange<dim>> changes;

  Meeting(const GridSpec& spec, std::vector<Body> bodies) : grid(spec) {
    scene.grid = spec;
    scene.bodies = std::move(bodies);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      fields.emplace_back(grid);
      field_of_body.push_back(b);
      for (auto& range : fields.back().touched) range = {0, grid.row_length()};
      std::fill(fields.back().mass.begin(), fields.back().mass.end(), 1.0);
    }
  }

  // The same velocity at all nodes of a field, at rest otherwise: no force acts.
  void move(std::size_t field, const Vec& velocity) {
    for (auto* of : {&fields[field].start, &fields[field].end, &fields[field].midpoint}) {
      std::fill(of->begin(), of->end(), velocity);
    }
  }
  void randomise(unsigned long seed) {
    scenes::Random random(seed);
    for (auto& field : fields) {
      for (std::size_t i = 0; i < field.mass.size(); ++i) {
        field.mass[i] = random(0.01, 2);
        for (int d = 0; d < dim; ++d) {
          field.start[i][d] = random(-1, 1);
          field.end[i][d] = random(-1, 1);
        }
        field.midpoint[i] = 0.5 * (field.start[i] + field.end[i]);
      }
    }
  }
  void meet(Contact<dim>& contact, bool decide = true) {
    if (decide) contact.find(scene, field_of_body, fields);
    changes.clear();
    contact.apply(fields, 0.1, decide, [&](const ContactChange<dim>& c) { changes.push_back(c); });
  }
  void meet(const std::string& name, int support = 3) {
    const auto contact = make_contact<dim>(name, grid, support);
    meet(*contact);
  }
  std::set<int> nodes() const {
    std::set<int> all;
    for (const auto& c : changes) all.insert(c.node);
    return all;
  }
  // Sum of the impulses, and of their moments.
  Vec impulse() const {
    Vec sum = Vec::Zero();
    for (const auto& c : changes) sum += c.mass * ((c.end - c.start) - (c.own_end - c.own_start));
    return sum;
  }
  Vec momentum() const {
    Vec sum = Vec::Zero();
    for (const auto& field : fields) {
      for (std::size_t i = 0; i < field.mass.size(); ++i) sum += field.mass[i] * field.end[i];
    }
    return sum;
  }
  Spin<dim> angular_momentum() const {
    Spin<dim> sum = Spin<dim>::Zero();
    for (const auto& field : fields) {
      for (std::size_t i = 0; i < field.mass.size(); ++i) {
        sum += cross<dim>(grid.position(static_cast<int>(i)), Vec(field.mass[i] * field.end[i]));
      }
    }
    return sum;
  }
};

inline int node_of(const Grid<2>& grid, int i, int j) {
  return (i + Grid<2>::ghosts) + (j + Grid<2>::ghosts) * grid.stride(1);
}

// Three blocks round a corner that close in on each other, two of them `near` the first, with random masses.
inline Meeting<2> three_round_a_corner(double near) {
  const double s = 0.05;
  Meeting<2> meeting(scenes::plane(20, 20, 0.1), {elastic_body("a", 2, block({0.5, 0.5, 0}, {10, 10, 1}, s), s),
                                                  elastic_body("b", 2, block({near, 0.6, 0}, {10, 8, 1}, s), s),
                                                  elastic_body("c", 2, block({0.7, near, 0}, {10, 10, 1}, s), s)});
  meeting.randomise(5);
  meeting.move(0, {1, 1});
  meeting.move(1, {-1, 0.2});
  meeting.move(2, {-0.2, -1});
  return meeting;
}

// The velocities and the ledger after 40 steps of `midpoint` are the same on one thread and on four.
inline void expect_threads_do_not_matter(const Scene& scene) {
  const auto run = [&](int threads) {
    Simulation simulation(scene, "midpoint", {.dt = 1e-3, .threads = threads});
    for (int step = 0; step < 40; ++step) simulation.step(1e-3);
    return simulation.save();
  };
  const Checkpoint one = run(1), four = run(4);
  scenes::expect_same_ledger(one.ledger, four.ledger);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto left = one.points[b].values(column::velocity), right = four.points[b].values(column::velocity);
    EXPECT_TRUE(std::equal(left.begin(), left.end(), right.begin(), right.end()));
  }
}

}  // namespace plumbline::meetings
