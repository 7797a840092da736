// Contact where points really touch: pairs, normals, impulses.
#include <Eigen/LU>
#include <cmath>

#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::touching_test {
namespace {

using meetings::block;
using meetings::elastic_body;
using meetings::Meeting;
using scenes::Place;

// Two rods on a line with a gap between their ends.
Meeting<1> rods(double gap, double h = 0.1, double spacing = 0.05) {
  Meeting<1> rods(scenes::line(20, h), {elastic_body("a", 1, block({0.4, 0, 0}, {8, 1, 1}, spacing), spacing),
                                        elastic_body("b", 1, block({0.8 + gap, 0, 0}, {8, 1, 1}, spacing), spacing)});
  rods.move(0, Eigen::Matrix<double, 1, 1>(1.0));
  return rods;
}

// Points touch when they are closer than half the sum of their spacings: ends without a gap. [Touching 1]
TEST(Touching, RodsTouchWhereTheirEndsMeet) {
  for (double gap : {1e-9, 0.01, 0.06, 0.3}) {
    Meeting<1> apart = rods(gap);
    apart.meet("touching");
    EXPECT_TRUE(apart.changes.empty()) << gap;
  }
  for (double overlap : {1e-9, 0.01, 0.03}) {
    Meeting<1> meeting = rods(-overlap);
    meeting.meet("touching");
    EXPECT_FALSE(meeting.changes.empty()) << overlap;
    for (const auto& c : meeting.changes) {  // equal masses share the velocity 1
      EXPECT_NEAR(0.5 * (c.start[0] + c.end[0]), 0.5, 1e-15);
    }
  }
}

// Nodes that carry a touching point of each body, no others: the end points at 0.775 and 0.824 reach three nodes each.
TEST(Touching, CandidatesCarryATouchingPointOfEachBody) {
  Meeting<1> meeting = rods(-0.001);
  meeting.meet("touching", 3);
  EXPECT_EQ(meeting.nodes(), (std::set<int>{8, 9, 10}));  // 0.7, 0.8, 0.9, behind one ghost
  Meeting<1> narrow = rods(-0.001);
  narrow.meet("touching", 2);
  EXPECT_EQ(narrow.nodes(), (std::set<int>{9}));  // tents of 0.775 and 0.824 share the node between them
  Meeting<1> wide = rods(-0.001);
  wide.meet("touching", 4);
  EXPECT_EQ(wide.nodes(), (std::set<int>{8, 9, 10}));  // 0.6 ... 0.9 and 0.7 ... 1.0
}

// Spacings of either body count.
TEST(Touching, EachBodyBringsItsOwnSpacing) {
  const auto at = [](double x) {
    Meeting<1> meeting(scenes::line(20, 0.1),
                       {elastic_body("a", 1, {{1, 0, 0}}, 0.05), elastic_body("b", 1, {{x, 0, 0}}, 0.02)});
    meeting.move(0, Eigen::Matrix<double, 1, 1>(1.0));
    meeting.meet("touching");
    return !meeting.changes.empty();
  };
  EXPECT_TRUE(at(1.0349));
  EXPECT_FALSE(at(1.0351));
}

TEST(Touching, BodiesThatPartAreLeftAlone) {
  Meeting<1> meeting = rods(-0.01);
  meeting.move(0, Eigen::Matrix<double, 1, 1>(-1.0));
  meeting.meet("touching");
  EXPECT_TRUE(meeting.changes.empty());
}

// Normals from a straight face: the plane has no slope along it where the clouds are mirror images.
// [Touching 2]
TEST(Touching, NormalsOfStraightFaces) {
  const double s = 0.05, h = 0.1;
  for (int d = 0; d < 2; ++d) {
    const Place second = d == 0 ? Place{0.999, 0.5, 0} : Place{0.5, 0.999, 0};
    Meeting<2> meeting(scenes::plane(20, 20, h), {elastic_body("a", 2, block({0.5, 0.5, 0}, {10, 10, 1}, s), s),
                                                  elastic_body("b", 2, block(second, {10, 10, 1}, s), s)});
    Eigen::Vector2d towards = Eigen::Vector2d::Zero(), across = Eigen::Vector2d::Zero();
    towards[d] = 1;
    across[1 - d] = 0.7;
    meeting.move(0, towards + across);
    meeting.meet("touching");
    EXPECT_GE(meeting.nodes().size(), 3u * 6u);
    int straight = 0;
    for (const auto& c : meeting.changes) {
      const double along = meeting.grid.position(c.node)[1 - d];
      if (along < 0.64 || along > 0.86) continue;  // whose support ends beyond a corner
      ++straight;
      const Eigen::Vector2d given = c.end - c.own_end;
      EXPECT_NEAR(std::abs(given[d]), 1, 1e-13);  // equal masses exchange the normal velocity
      EXPECT_NEAR(given[1 - d], 0, 1e-13);        // frictionless
    }
    EXPECT_GE(straight, 2 * 3 * 2);
  }
}

// Clouds that are mirror images in the diagonal: its normal, at nodes on it.
TEST(Touching, NormalOfADiagonalFace) {
  const double s = 0.05;
  std::vector<Place> below, above;
  for (const Place& x : block({0.5, 0.5, 0}, {16, 16, 1}, s)) {
    if (x[0] - x[1] > 0.01) below.push_back({x[0] - 0.02, x[1], 0});
    if (x[1] - x[0] > 0.01) above.push_back({x[0], x[1] - 0.02, 0});
  }
  Meeting<2> meeting(scenes::plane(20, 20, 0.1), {elastic_body("a", 2, below, s), elastic_body("b", 2, above, s)});
  meeting.move(0, Eigen::Vector2d(-1, 1));
  meeting.meet("touching");
  int on_it = 0;
  for (const auto& c : meeting.changes) {
    const auto x = meeting.grid.position(c.node);
    if (std::abs(x[0] - x[1]) > 1e-9 || x[0] < 0.6 || x[0] > 1.2) continue;
    ++on_it;
    const Eigen::Vector2d given = c.end - c.own_end;
    EXPECT_NEAR(given[0], -given[1], 1e-12);
  }
  EXPECT_GE(on_it, 10);
}

TEST(Touching, NormalInSpace) {
  const double s = 0.05;
  Meeting<3> meeting(scenes::box(scenes::Space::solid, {10, 10, 12}, 0.1),
                     {elastic_body("a", 3, block({0.2, 0.2, 0.2}, {12, 12, 6}, s), s),
                      elastic_body("b", 3, block({0.2, 0.2, 0.499}, {12, 12, 6}, s), s)});
  meeting.move(0, Eigen::Vector3d(0.3, 0.2, 1));
  meeting.meet("touching");
  int inner = 0;
  for (const auto& c : meeting.changes) {
    const auto x = meeting.grid.position(c.node);
    if (std::max(std::abs(x[0] - 0.5), std::abs(x[1] - 0.5)) > 0.05) continue;
    ++inner;
    const Eigen::Vector3d given = c.end - c.own_end;
    EXPECT_NEAR(given.head<2>().norm(), 0, 1e-13);
    EXPECT_NEAR(std::abs(given[2]), 1, 1e-13);
  }
  EXPECT_GE(inner, 2 * 3);
}

Meeting<2> squares(unsigned long seed) {
  const double s = 0.05;
  Meeting<2> meeting(scenes::plane(20, 20, 0.1),
                     {elastic_body("a", 2, scenes::jittered(block({0.5, 0.5, 0}, {10, 10, 1}, s), 0.01, 2, seed), s),
                      elastic_body("b", 2, scenes::jittered(block({0.98, 0.6, 0}, {10, 10, 1}, s), 0.01, 2, 7), s)});
  meeting.randomise(seed);
  return meeting;
}

// Impulses are equal and opposite, at one place: linear and angular momentum. [Touching 3]
TEST(Touching, ImpulsesConserveMomentumAndAngularMomentum) {
  for (unsigned long seed = 1; seed <= 5; ++seed) {
    Meeting<2> meeting = squares(seed);
    const auto momentum = meeting.momentum();
    const auto angular = meeting.angular_momentum();
    meeting.meet("touching");
    ASSERT_GE(meeting.changes.size(), 10u);
    EXPECT_NEAR((meeting.momentum() - momentum).norm(), 0, 1e-12);
    EXPECT_NEAR(meeting.angular_momentum()[0], angular[0], 1e-12);
    EXPECT_NEAR(meeting.impulse().norm(), 0, 1e-13);
  }
}

// The direction of every impulse is that of the points around the node taken naively. [Touching 2]
TEST(Touching, NormalsOfUnevenClouds) {
  Meeting<2> meeting = squares(3);
  meeting.meet("touching");
  for (const auto& c : meeting.changes) {
    const Eigen::Vector2d node = meeting.grid.position(c.node), given = c.end - c.own_end;
    Clouds<2> clouds;
    for (std::size_t b = 0; b < 2; ++b) {
      const Columns& points = meeting.scene.bodies[b].points;
      for (int p = 0; p < points.points(); ++p) {
        const Eigen::Vector2d x(points(column::position, 0)[p], points(column::position, 1)[p]);
        (b == 0 ? clouds.first : clouds.second).push_back((x - node) / 0.1);
      }
    }
    const Eigen::Vector2d n = separating_direction<2>(clouds, 1.5);
    EXPECT_NEAR(given[0] * n[1] - given[1] * n[0], 0, 1e-10 * given.norm());
  }
}

// Mid-step the normal velocities are common, so the impulses do no work; a second pass finds the same
// nodes. [Touching 3]
TEST(Touching, ImpulsesDoNoWork) {
  for (unsigned long seed = 1; seed <= 5; ++seed) {
    Meeting<2> meeting = squares(seed);
    const auto contact = make_contact<2>("touching", meeting.grid, 3);
    meeting.meet(*contact);
    const auto first = meeting.nodes();
    for (bool again : {false, true}) {
      if (again) {
        meeting.randomise(seed + 100);
        meeting.meet(*contact, false);
        EXPECT_EQ(meeting.nodes(), first);
      }
      double work = 0, moved = 0;
      for (const auto& c : meeting.changes) {
        const Eigen::Vector2d impulse = c.mass * (c.end - c.own_end);
        work += impulse.dot(0.5 * (c.start + c.end));
        moved += impulse.norm();
      }
      EXPECT_GT(moved, 0.1);
      EXPECT_NEAR(work, 0, 1e-14 * moved);
    }
  }
}

TEST(Touching, TangentialVelocitiesAreLeftAlone) {
  Meeting<2> meeting = squares(3);
  meeting.meet("touching");
  for (std::size_t k = 0; k + 1 < meeting.changes.size(); k += 2) {
    const auto &a = meeting.changes[k], &b = meeting.changes[k + 1];
    ASSERT_EQ(a.node, b.node);
    const Eigen::Vector2d to_a = a.end - a.own_end, jump = 0.5 * (a.own_start + a.own_end - b.own_start - b.own_end);
    const Eigen::Vector2d n = -to_a.normalized();  // from a to b
    EXPECT_GT(jump.dot(n), 0);
    const Eigen::Vector2d common = 0.5 * (a.start + a.end - b.start - b.end);
    EXPECT_NEAR(common.dot(n), 0, 1e-14);
    EXPECT_NEAR((common - jump + jump.dot(n) * n).norm(), 0, 1e-14);
  }
}

// Three bodies round a corner: momentum is kept and no work done, pair by pair that would not be so. [Touching 3]
TEST(Touching, ThreeBodiesAtANode) {
  Meeting<2> meeting = meetings::three_round_a_corner(0.98);
  const auto momentum = meeting.momentum();
  meeting.meet("touching");
  EXPECT_NEAR((meeting.momentum() - momentum).norm(), 0, 1e-12);
  int three = 0;
  for (const int node : meeting.nodes()) {
    std::vector<ContactChange<2>> here;
    for (const auto& c : meeting.changes) {
      if (c.node == node) here.push_back(c);
    }
    if (here.size() == 3) ++three;
    double own = 0, scale = 0;
    for (const auto& c : here) {
      const Eigen::Vector2d impulse = c.mass * (c.end - c.own_end);
      own += impulse.dot(0.5 * (c.start + c.end));
      scale += impulse.norm();
    }
    EXPECT_NEAR(own, 0, 1e-13 * scale) << node;
  }
  EXPECT_GT(three, 0);
}

// A wall takes what would push a node into it, and a node beyond it mirrors another.
TEST(Touching, NodesOnWallsAreNotPushedIntoThem) {
  const double s = 0.05;
  for (Wall wall : {Wall::symmetry, Wall::no_slip}) {
    Meeting<2> meeting(scenes::plane(20, 20, 0.1, scenes::walls(Wall::free, Wall::free, wall, Wall::free)),
                       {elastic_body("a", 2, block({0.5, 0, 0}, {10, 10, 1}, s), s),
                        elastic_body("b", 2, block({0.98, 0, 0}, {10, 12, 1}, s), s)});
    meeting.move(0, Eigen::Vector2d(1, 0.5));
    meeting.meet("touching");
    bool on_wall = false;
    for (const auto& c : meeting.changes) {
      const double y = meeting.grid.position(c.node)[1];
      EXPECT_GT(y, -0.05);
      if (y > 0.05) continue;
      on_wall = true;
      EXPECT_EQ(c.end[1], c.own_end[1]);
    }
    EXPECT_EQ(on_wall, wall == Wall::symmetry);
  }
}

}  // namespace
}  // namespace plumbline::touching_test
