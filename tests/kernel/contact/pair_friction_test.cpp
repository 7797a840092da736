// Where pairs of points rub, and by how much. [Pairs 4, 5]
#include "kernel/contact/pair_friction.hpp"

#include <map>

#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::pair_friction_test {
namespace {

using meetings::elastic_body;
using meetings::Meeting;
using meetings::node_of;

constexpr double h = 0.1, dt = 0.02;

template <int dim>
using V = Eigen::Matrix<double, dim, 1>;

template <int dim>
Meeting<dim> two_fields() {
  return {scenes::box(scenes::space_of(dim), {10, 10, 10}, h),
          {elastic_body("a", dim, {{0.5, 0.5, 0.5}}, 0.05), elastic_body("b", dim, {{0.5, 0.6, 0.5}}, 0.05)}};
}

template <int dim>
std::vector<ContactChange<dim>> rub_once(Meeting<dim>& meeting, const std::vector<PressedPair<dim>>& pressed,
                                         double friction) {
  PairFriction<dim> rubbing(meeting.grid, friction);
  rubbing.find(pressed, meeting.field_of_body, meeting.fields, dt);
  std::vector<ContactChange<dim>> changes;
  rubbing.apply(meeting.fields, [&](const ContactChange<dim>& change) { changes.push_back(change); });
  return changes;
}

// By hand, on a square of nodes: tents .3 .2, .7 .2, .3 .8, .7 .8 at masses between the bodies 3/4, 2/3, 1/2, 0.
TEST(PairFriction, NodesHaveSharesByTentsAndMasses) {
  Meeting<2> meeting = two_fields<2>();
  const int nodes[] = {node_of(meeting.grid, 4, 5), node_of(meeting.grid, 5, 5), node_of(meeting.grid, 4, 6),
                       node_of(meeting.grid, 5, 6)};
  const double first[] = {1, 1, 1, 0}, second[] = {3, 2, 1, 5}, tents[] = {0.06, 0.14, 0.24, 0.56};
  double shares[4], sum = 0;
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(nodes[k]);
    meeting.fields[0].mass[i] = first[k];
    meeting.fields[1].mass[i] = second[k];
    sum += shares[k] = tents[k] * first[k] * second[k] / (first[k] + second[k]);
  }
  meeting.move(0, {100, 0});
  const double force = 8, friction = 0.25;
  const auto changes = rub_once<2>(meeting, {{0, 1, {0.47, 0.58}, {0, force}}}, friction);
  ASSERT_EQ(changes.size(), 6u);
  std::map<int, V<2>> given;
  for (std::size_t k = 0; k < changes.size(); k += 2) {
    given[changes[k].node] = changes[k + 1].mass * (changes[k + 1].end - changes[k + 1].own_end);
    EXPECT_NEAR((changes[k].mass * (changes[k].end - changes[k].own_end) + given[changes[k].node]).norm(), 0, 1e-13);
  }
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR((given.at(nodes[k]) - V<2>(friction * force * dt * shares[k] / sum, 0)).norm(), 0, 1e-13) << k;
}

// What slips less than mu |f| dt/2 allows is stopped; the bodies' masses at the node are 1 and 3.
template <int dim>
void expect_sticks_and_slips() {
  for (const double slip : {0.1, 0.3}) {
    Meeting<dim> meeting = two_fields<dim>();
    std::fill(meeting.fields[1].mass.begin(), meeting.fields[1].mass.end(), 3.0);
    V<dim> along = V<dim>::Zero(), up = V<dim>::Zero(), place = V<dim>::Constant(0.5);
    along[0] = slip;
    up[1] = 1;
    meeting.move(0, along - 7 * up);
    const double limit = 0.5 * 30 * dt / 2;  // .15 of an impulse that 3/4 of a slip takes
    const auto changes = rub_once<dim>(meeting, {{0, 1, place, 30 * up}}, 0.5);
    ASSERT_EQ(changes.size(), 2u);
    const double held = std::min(0.75 * slip, limit);
    EXPECT_NEAR(((changes[0].start + changes[0].end) / 2 - (along * (1 - held / slip) - 7 * up)).norm(), 0, 1e-14);
    EXPECT_NEAR(((changes[1].start + changes[1].end) / 2 - along * (held / 3 / slip)).norm(), 0, 1e-14);
  }
}
TEST(PairFriction, SticksUpToTheLimitAndSlipsBeyond) {
  expect_sticks_and_slips<2>();
  expect_sticks_and_slips<3>();
}

// Two bodies of one field press a third between them in their order: both pairs press the fields together.
TEST(PairFriction, PairsOfTwoFieldsAddWhicheverBodyComesFirst) {
  Meeting<2> meeting = two_fields<2>();
  meeting.field_of_body = {0, 1, 0};
  meeting.move(0, {1, 0});
  const auto changes = rub_once<2>(meeting, {{0, 1, {0.5, 0.5}, {0, 4}}, {1, 2, {0.5, 0.5}, {0, -6}}}, 0.5);
  ASSERT_EQ(changes.size(), 2u);
  const double given = 0.5 * (4 + 6) * dt;
  EXPECT_NEAR((changes[0].end - V<2>(1 - given, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((changes[1].end - V<2>(given, 0)).norm(), 0, 1e-15);
}

TEST(PairFriction, NothingWhereNothingPressesOrOneBodyIsAlone) {
  Meeting<2> meeting = two_fields<2>();
  meeting.move(0, {1, 0});
  EXPECT_TRUE(rub_once<2>(meeting, {}, 0.5).empty());
  std::fill(meeting.fields[1].mass.begin(), meeting.fields[1].mass.end(), 0.0);
  EXPECT_TRUE(rub_once<2>(meeting, {{0, 1, {0.47, 0.58}, {0, 8}}}, 0.5).empty());
}

}  // namespace
}  // namespace plumbline::pair_friction_test
