// York's contact-release: normals from colours, his three criteria, and common velocities.
#include <cmath>

#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::york_test {
namespace {

using meetings::block;
using meetings::elastic_body;
using meetings::Meeting;
using Vec = Eigen::Vector2d;

double spline(double u) {
  const double a = std::abs(u);
  return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
}

// sum_c grad N_i(x_c) chi_c with chi_c summed over all points of a body. [York 9.10, 9.11]
Vec naive_normal(const Body& body, const Vec& node, double h) {
  Vec n = Vec::Zero();
  for (int k = 0; k < 4; ++k) {
    const Vec side(k % 2 ? -1 : 1, k / 2 ? -1 : 1), centre = node + 0.5 * h * side;
    double chi = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      chi += spline((body.points(column::position, 0)[p] - centre[0]) / h) *
             spline((body.points(column::position, 1)[p] - centre[1]) / h);
    }
    n += -side / (2 * h) * chi;  // grad N_i at the centre of a cell
  }
  return n.norm() > 0 ? Vec(n / n.norm()) : n;
}

Meeting<2> squares(unsigned long seed) {
  const double s = 0.05;
  Meeting<2> meeting(scenes::plane(20, 20, 0.1),
                     {elastic_body("a", 2, scenes::jittered(block({0.5, 0.5, 0}, {10, 10, 1}, s), 0.01, 2, seed), s),
                      elastic_body("b", 2, scenes::jittered(block({1.03, 0.6, 0}, {10, 10, 1}, s), 0.01, 2, 7), s)});
  meeting.randomise(seed);
  return meeting;
}

// Exactly the nodes that the criteria, evaluated on normals summed naively, put in contact. [York 9.7, 9.8, 9.9]
TEST(York, CriteriaWithNaiveNormals) {
  int different = 0;
  for (unsigned long seed = 1; seed <= 2; ++seed) {
    std::set<int> found[3];
    const Meeting<2> points = squares(seed);
    std::vector<Vec> normals[2];
    for (int node = 0; node < points.grid.node_count(); ++node) {
      for (std::size_t b = 0; b < 2; ++b) {
        normals[b].push_back(naive_normal(points.scene.bodies[b], points.grid.position(node), 0.1));
      }
    }
    for (int which = 0; which < 3; ++which) {
      Meeting<2> meeting = squares(seed);
      std::set<int> expected;
      for (int node = 0; node < meeting.grid.node_count(); ++node) {
        const auto i = static_cast<std::size_t>(node);
        const Vec n1 = normals[0][i], n2 = normals[1][i];
        const double m1 = meeting.fields[0].mass[i], m2 = meeting.fields[1].mass[i];
        const Vec v1 = meeting.fields[0].start[i], v2 = meeting.fields[1].start[i],
                  cm = (m1 * v1 + m2 * v2) / (m1 + m2);
        const bool contact = which == 0   ? (v1 - v2).dot(n1) > 0                            // [York 9.7]
                             : which == 1 ? (v1 - cm).dot(n1) > 0                            // [York 9.8]
                                          : (v1 - cm).dot(n1) > 0 || (v2 - cm).dot(n2) > 0;  // [York 9.9]
        if (contact) expected.insert(node);
      }
      const char* names[] = {"york-9.7", "york-9.8", "york-9.9"};
      meeting.meet(names[which]);
      found[which] = meeting.nodes();
      EXPECT_EQ(found[which], expected) << names[which];
    }
    EXPECT_EQ(found[0], found[1]) << "v1 - v_cm points where v1 - v2 does";
    different += found[2] != found[0];
  }
  EXPECT_GT(different, 0);
}

// A straight side far from corners: normals along x. [York 9.11]
TEST(York, NormalsOfAStraightSide) {
  const double s = 0.05;
  for (double across : {0.0, 100.0, -100.0}) {
    Meeting<2> meeting(scenes::plane(20, 20, 0.1), {elastic_body("a", 2, block({0.5, 0.3, 0}, {10, 28, 1}, s), s),
                                                    elastic_body("b", 2, block({1.05, 0.3, 0}, {10, 28, 1}, s), s)});
    for (double closing : {1e-6, -1e-6}) {
      meeting.move(0, Vec(closing, across));
      meeting.meet("york-9.7");
      for (int node = 0; node < meeting.grid.node_count(); ++node) {
        const Vec x = meeting.grid.position(node);
        if (std::abs(x[1] - 1) > 0.31 || x[0] < 0.95 || x[0] > 1.05) continue;
        EXPECT_EQ(meeting.nodes().count(node), closing > 0 ? 1u : 0u) << x.transpose();
      }
    }
  }
}

// Behind a wall the bodies go on: a side that meets it has the same normals there.
TEST(York, NormalsOfAStraightSideBesideWalls) {
  const double s = 0.05;
  for (Wall wall : {Wall::symmetry, Wall::no_slip}) {
    Meeting<2> meeting(scenes::plane(20, 20, 0.1, scenes::walls(Wall::free, Wall::free, wall, wall)),
                       {elastic_body("a", 2, block({0.5, 0, 0}, {10, 40, 1}, s), s),
                        elastic_body("b", 2, block({1.05, 0, 0}, {10, 40, 1}, s), s)});
    for (double across : {100.0, -100.0}) {
      for (double closing : {1e-6, -1e-6}) {
        meeting.move(0, Vec(closing, across));
        meeting.meet("york-9.7");
        for (int j = 0; j <= 20; ++j) {
          EXPECT_EQ(meeting.nodes().count(meetings::node_of(meeting.grid, 10, j)), closing > 0 ? 1u : 0u) << j;
        }
      }
    }
  }
}

// In common: the start, what the forces change, and so the end. [York 9.1, 9.2]
TEST(York, CommonVelocitiesAndAcceleration) {
  for (unsigned long seed = 1; seed <= 3; ++seed) {
    Meeting<2> meeting = squares(seed);
    const auto before = meeting.fields;
    const Vec momentum = meeting.momentum();
    const auto angular = meeting.angular_momentum();
    meeting.meet("york-9.7");
    ASSERT_GE(meeting.changes.size(), 20u);
    for (const auto& c : meeting.changes) {
      const auto i = static_cast<std::size_t>(c.node);
      const double m1 = before[0].mass[i], m2 = before[1].mass[i];
      const Vec start = (m1 * before[0].start[i] + m2 * before[1].start[i]) / (m1 + m2);
      const Vec end = (m1 * before[0].end[i] + m2 * before[1].end[i]) / (m1 + m2);
      for (const auto& field : meeting.fields) {
        EXPECT_NEAR((field.start[i] - start).norm(), 0, 1e-14);
        EXPECT_NEAR((field.end[i] - end).norm(), 0, 1e-14);
        EXPECT_NEAR((field.midpoint[i] - 0.5 * (start + end)).norm(), 0, 1e-14);
      }
    }
    EXPECT_NEAR((meeting.momentum() - momentum).norm(), 0, 1e-12);
    EXPECT_NEAR(meeting.angular_momentum()[0], angular[0], 1e-12);
    EXPECT_NEAR(meeting.impulse().norm(), 0, 1e-13);
  }
}

// The second pass of a step starts from the same nodes and the velocities each field had of its own. [York 9.2]
TEST(York, ASecondPassTakesTheSameNodes) {
  Meeting<2> meeting = squares(2);
  const auto contact = make_contact<2>("york-9.7", meeting.grid, 3);
  meeting.meet(*contact);
  const auto first = meeting.changes;
  for (auto& field : meeting.fields) {
    for (std::size_t i = 0; i < field.end.size(); ++i) field.end[i] = field.start[i] + Vec(0.1, 0.2) / field.mass[i];
  }
  meeting.meet(*contact, false);
  ASSERT_EQ(meeting.changes.size(), first.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(meeting.changes[k].own_start, first[k].own_start);
    EXPECT_EQ(meeting.changes[k].start, first[k].start);
  }
}

// Where a third body meets two in contact, all move in common and momentum is kept.
TEST(York, ThreeBodiesAtANode) {
  Meeting<2> meeting = meetings::three_round_a_corner(1.0);
  const Vec momentum = meeting.momentum();
  meeting.meet("york-9.7");
  EXPECT_NEAR((meeting.momentum() - momentum).norm(), 0, 1e-12);
  const auto i = static_cast<std::size_t>(meetings::node_of(meeting.grid, 10, 10));
  EXPECT_EQ(meeting.fields[0].end[i], meeting.fields[1].end[i]);
  EXPECT_EQ(meeting.fields[0].end[i], meeting.fields[2].end[i]);
}

TEST(Contact, UnknownNames) {
  const Grid<2> grid(scenes::plane(4, 4, 1));
  EXPECT_EQ(make_contact<2>("none", grid, 3), nullptr);
  EXPECT_THROW(make_contact<2>("sticky", grid, 3), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::york_test
