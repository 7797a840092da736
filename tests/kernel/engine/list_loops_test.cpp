// The two implementations of the loops between points and nodes, one against the other: product shapes by packs and bins, and the
// same shapes as lists of nodes.
#include "kernel/engine/loops/list_entry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/shapes/cpdi.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::list_loops_test {
namespace {

// A product shape as a list.
template <class S>
struct Listed {
  template <int dim>
  class Of final : public ListedShape<dim> {
   public:
    explicit Of(const Grid<dim>& grid) : grid_(grid) {}
    ShapeTraits traits() const override { return {S::support, S::blur, S::fixed_inertia, S::boxes}; }

    void list(const Columns&, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const override {
      for (int p = range.first; p < range.last; ++p) {
        int anchor[dim];
        double w[dim][S::support], slope[dim][S::support];
        for (int d = 0; d < dim; ++d) {
          double local;
          anchor[d] = S::anchor(grid_.logical(at.x[d][p], d), grid_.cells(d), local);
          if constexpr (S::boxes) {
            const double half = std::clamp(at.half_size[d][p] / grid_.h(), S::narrowest, S::widest);
            S::weights(local, half, w[d]);
            S::gradients(local, half, slope[d]);
          } else {
            S::weights(local, w[d]);
            S::gradients(local, slope[d]);
          }
        }
        list_products(anchor, w, slope, nodes);
        nodes.end_point();
      }
    }

   private:
    void list_products(const int (&anchor)[dim], const double (&w)[dim][S::support],
                       const double (&slope)[dim][S::support], NodeList<dim>& nodes) const {
      constexpr int s = S::support;
      for (int k = 0; k < (dim == 1 ? s : dim == 2 ? s * s : s * s * s); ++k) {
        const int offset[3] = {k % s, k / s % s, k / s / s};
        int node = 0;
        double value = 1;
        Eigen::Matrix<double, dim, 1> gradient = Eigen::Matrix<double, dim, 1>::Constant(1 / grid_.h());
        for (int d = 0; d < dim; ++d) {
          node += (anchor[d] + offset[d] + S::first + Grid<dim>::ghosts) * grid_.stride(d);
          value *= w[d][offset[d]];
          for (int e = 0; e < dim; ++e) gradient[e] *= d == e ? slope[d][offset[d]] : w[d][offset[d]];
        }
        nodes.add(node, value, gradient);
      }
    }
    Grid<dim> grid_;
  };
};

// Both sides of a comparison, of some tens of terms each.
void expect_alike(std::span<const double> own, std::span<const double> other, const std::string& what) {
  double largest = 0, apart = 0;
  ASSERT_EQ(own.size(), other.size());
  for (std::size_t k = 0; k < own.size(); ++k) {
    largest = std::max(largest, std::abs(other[k]));
    apart = std::max(apart, std::abs(own[k] - other[k]));
  }
  EXPECT_LE(apart, 2e-13 * largest) << what;
}
void expect_alike(double own, double other, const std::string& what) {
  expect_alike(std::span(&own, 1), std::span(&other, 1), what);
}
void expect_alike(const Turn& own, const Turn& other, double scale, const std::string& what) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(own[k], other[k], 1e-13 * scale) << what;
}

// A grid's cells, and how far at most corners lie from their points, in cells; 0: some are as far as may be, and further.
struct Layout {
  std::array<int, 3> cells = {5, 4, 4};
  double reach = 0;
};

template <class Geometry>
class Pair {
 public:
  static constexpr int dim = Geometry::dim;
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Loops = PointLoops<Geometry>;

  Pair(const ShapeEntry& products, const ShapeEntry& lists, const Transfer& transfer,
       std::shared_ptr<const Material> material, const Layout& layout)
      : reach_(layout.reach),
        spec_(grid_of(layout.cells)),
        grid_(spec_),
        products_(std::get<MakeLoops<Geometry>>(products.loops)(spec_, transfer)),
        lists_(std::get<MakeLoops<Geometry>>(lists.loops)(spec_, transfer)),
        body_(make_body("body", std::move(material), 60, dim, Geometry::axisymmetric)),
        field_(grid_) {
    body_.points.add(column::affine, dim * dim);
    body_.points.add(column::half_size, dim);
    body_.points.add(column::transfer_loss);
    fill();
    std::vector<int> own(60), other(60);
    EXPECT_TRUE(products_->find_lowest(body_.points, {0, 60}, own.data()));
    EXPECT_TRUE(lists_->find_lowest(body_.points, {0, 60}, other.data()));
    EXPECT_EQ(own, other);
    at_.bins.build(own);
    at_.release();
  }

  void compare() {
    compare_shapes();
    const bool gas = body_.material->takes_heat();
    to_nodes("mass and momentum", [&](const Loops& loops, const Chunk& c, auto& field) {
      loops.map_mass_and_momentum(body_, at_, c, field);
      return 0.0;
    });
    to_nodes("momentum", [&](const Loops& loops, const Chunk& c, auto& field) {
      loops.map_momentum(body_, at_, c, field);
      return 0.0;
    });
    for (const bool exchange : {false, gas}) {
      to_nodes("forces", [&](const Loops& loops, const Chunk& c, auto& field) {
        return loops.map_forces(body_, at_, c, exchange ? Shares::heat : Shares::none, field);
      });
    }
    to_nodes("spread", [&](const Loops& loops, const Chunk& c, auto& field) {
      const typename Loops::Spread all[] = {
          {body_.points(column::velocity), body_.points(column::mass), component(field.force, 0), dim},
          {body_.points(column::volume), nullptr, field.gas.heat.data(), 1}};
      loops.spread(body_.points, at_, c, all);
      return 0.0;
    });
    to_points("gather", [&](const Loops& loops, Body& body, const Chunk& c) {
      const typename Loops::Gather all[] = {{component(field_.start, dim - 1), dim, body.points(column::volume)},
                                            {field_.gas.density.data(), 1, body.points(column::transfer_loss)}};
      loops.gather(body.points, at_, c, all);
      return MotionSums{};
    });
    to_points("loss and rates", [&](const Loops& loops, Body& body, const Chunk& c) {
      MotionSums sums;
      sums.lost = loops.gather_start(body, at_, c, {.loss = &field_.start, .rates = &field_.midpoint});
      return sums;
    });
    for (const bool specific : {false, true}) {
      to_points("start", [&](const Loops& loops, Body& body, const Chunk& c) {
        MotionSums sums;
        sums.lost = loops.gather_start(
            body, at_, c,
            {.loss = &field_.start, .rates = &field_.midpoint, .density = &field_.gas.density, .specific = specific});
        return sums;
      });
    }
    compare_motions(gas);
    scenes::Random random(12);
    field_.held(field_.gas.kept);  // with the filter of gases
    for (double& share : field_.gas.kept) share = random(0.1, 0.9);
    compare_motions(gas);
    compare_surveys();
  }

 private:
  static GridSpec grid_of(const std::array<int, 3>& cells) {
    const scenes::Space space = Geometry::axisymmetric ? scenes::Space::axisymmetric : scenes::space_of(dim);
    const Wall s = Wall::symmetry, n = Wall::no_slip, f = Wall::free;
    return scenes::box(space, cells, 0.3, scenes::walls(s, f, n, f, f, s));
  }

  void fill() {
    scenes::Random random(11);
    const auto numbers = [&](const ColumnId& id, double low, double high) {
      if (!body_.points.has(id)) return;
      for (double& value : body_.points.values(id)) value = random(low, high);
    };
    for (int d = 0; d < dim; ++d) {
      for (int p = 0; p < 60; ++p) body_.points(column::position, d)[p] = random(0.03, 0.3 * grid_.cells(d) - 0.03);
    }
    for (const ColumnId* id : {&column::velocity, &column::affine, &column::stress, &column::strain_rate})
      numbers(*id, -1, 1);
    for (const ColumnId* id : {&column::mass, &column::volume, &column::density, &column::energy,
                               &column::transfer_loss, &column::rest_length})
      numbers(*id, 0.5, 1.5);
    numbers(column::half_size, 0.04, 0.14);
    if constexpr (dim == 2) {
      if (lists_->follows()) shear_domains(random);
    }
    hold(field_);
    for (auto* nodes : {&field_.start, &field_.end, &field_.midpoint, &field_.corrected.filtered}) {
      for (Vec& value : *nodes) {
        for (int d = 0; d < dim; ++d) value[d] = random(-1, 1);
      }
    }
    for (auto* nodes : {&field_.gas.density, &field_.gas.heat, &field_.gas.exchange}) {
      for (double& value : *nodes) value = random(0.1, 1);
    }
  }

  // Edges of domains, turned and sheared, some of them cut where they reach further than the support: by one edge, or by both
  // together along one axis, xx + xy or yx + yy = 1.3 cells of 0.3 m.
  void shear_domains(scenes::Random& random) {
    body_.points.add(column::half_edges, dim * dim);
    for (int p = 0; p < body_.points.points(); ++p) {
      const double long_edge = p % 7 == 0 ? 1.1 : random(0.05, 0.3), angle = random(-3, 3),
                   short_edge = random(0.05, 0.1);
      const double edges[] = {long_edge * std::cos(angle), long_edge * std::sin(angle),
                              -short_edge * std::sin(angle + 0.5), short_edge * std::cos(angle + 0.5)};
      const double along_x[] = {0.21, 0.03, -0.18, -0.06}, along_y[] = {-0.06, 0.18, 0.03, 0.21};
      const double* chosen = p % 7 == 3 ? along_x : p % 7 == 5 ? along_y : edges;
      const double extent = std::max(std::abs(chosen[0]) + std::abs(chosen[2]),
                                     std::abs(chosen[1]) + std::abs(chosen[3]));
      const double factor = reach_ > 0 ? 0.3 * reach_ / extent : 1;
      for (int k = 0; k < dim * dim; ++k) body_.points(column::half_edges, k)[p] = factor * chosen[k];
    }
  }

  void compare_shapes() const {
    EXPECT_EQ(lists_->shape().support, products_->shape().support);
    // By fewer probes: exact for quadratics, the radius included.
    if (lists_->shape().support == 3 && !lists_->shape().boxes)
      expect_alike(lists_->inverse_volumes(), products_->inverse_volumes(), "volumes");
    for (int d = 0; d < dim; ++d)
      expect_alike(lists_->inertia(body_.points, d, 3), products_->inertia(body_.points, d, 3), "inertia");
    Body moved = body_;
    for (int d = 0; d < dim; ++d) {
      for (int p = 0; p < 60; ++p) {
        double& x = moved.points(column::position, d)[p];
        x = std::min(x + 0.1, 0.3 * grid_.cells(d));
      }
    }
    std::vector<int> own(60), other(60);
    EXPECT_TRUE(lists_->find_lowest(moved.points, {0, 60}, own.data()));
    EXPECT_TRUE(products_->find_lowest(moved.points, {0, 60}, other.data()));
    EXPECT_EQ(own, other);
    const bool one_block = grid_.nodes(0) == lists_->shape().support && grid_.nodes(dim - 1) == grid_.nodes(0);
    EXPECT_EQ(at_.bins.hold(own), one_block);
    moved.points(column::position)[5] = -1;
    EXPECT_FALSE(lists_->find_lowest(moved.points, {0, 60}, own.data()));
  }

  // The arrays that loops read and write without asking whether a scene needs them.
  static void hold(VelocityField<dim>& field) {
    field.held(field.corrected.filtered);
    for (std::vector<double>* array : {&field.gas.density, &field.gas.heat, &field.gas.exchange}) field.held(*array);
  }

  template <class Map>
  void to_nodes(const std::string& what, Map&& map) const {
    VelocityField<dim> own(grid_), other(grid_);
    hold(own);
    hold(other);
    for (const Chunk& chunk : at_.bins.chunks())
      expect_alike(map(*lists_, chunk, own), map(*products_, chunk, other), what + " sum");
    const auto flat = [](const std::vector<Vec>& nodes) { return std::span(nodes.front().data(), nodes.size() * dim); };
    expect_alike(own.mass, other.mass, what);
    expect_alike(flat(own.momentum), flat(other.momentum), what);
    expect_alike(flat(own.force), flat(other.force), what);
    expect_alike(own.gas.heat, other.gas.heat, what);
    expect_alike(own.gas.exchange, other.gas.exchange, what);
  }

  template <class Map>
  void to_points(const std::string& what, Map&& map) const {
    Body own = body_, other = body_;
    MotionSums a, b;
    for (const Chunk& chunk : at_.bins.chunks()) {
      a += map(*lists_, own, chunk);
      b += map(*products_, other, chunk);
    }
    for (const ColumnId* id : {&column::position, &column::velocity, &column::affine, &column::strain_rate,
                               &column::volume, &column::energy, &column::transfer_loss}) {
      if (own.points.has(*id))
        expect_alike(std::as_const(own.points).values(*id), std::as_const(other.points).values(*id),
                     what + " " + id->name());
    }
    expect_alike(a.lost, b.lost, what + " lost");
    expect_alike(a.torque, b.torque, 60, what + " torque");
    expect_alike(a.moved, b.moved, 60, what + " moved");
    EXPECT_EQ(a.too_far, b.too_far);
  }

  void compare_motions(bool gas) const {
    for (const std::optional<double> drift : {std::optional<double>{}, std::optional<double>{0.01}}) {
      const std::vector<Vec>* const nodes[][2] = {{nullptr, nullptr},
                                                  {&field_.midpoint, nullptr},
                                                  {&field_.midpoint, &field_.start},
                                                  {&field_.midpoint, &field_.midpoint}};
      for (const auto& [straining, carrying] : nodes) {
        if (drift && carrying) continue;
        const typename Loops::Motion motion{
            .dt = 0.01, .drift = drift, .straining = straining, .carrying = carrying, .exchange = carrying && gas};
        to_points("motion", [&](const Loops& loops, Body& body, const Chunk& c) {
          Weights<dim> at = at_;
          at.keep(body.points);
          return loops.gather_motion(body, at, c, field_, motion);
        });
      }
    }
  }

  void compare_surveys() const {
    const Survey own = lists_->survey(body_, {0, 60}), other = products_->survey(body_, {0, 60});
    expect_alike(own.totals.mass, other.totals.mass, "mass");
    expect_alike(own.totals.energy.total(), other.totals.energy.total(), "energy");
    expect_alike(own.totals.momentum_scale, other.totals.momentum_scale, "momentum scale");
    expect_alike(own.totals.angular_scale, other.totals.angular_scale, "angular scale");
    expect_alike(own.totals.momentum, other.totals.momentum, 60, "momentum");
    expect_alike(own.totals.angular_momentum, other.totals.angular_momentum, 60, "angular momentum");
    EXPECT_EQ(own.admissible, other.admissible);
    EXPECT_EQ(own.bounds.fastest, other.bounds.fastest);
  }

  double reach_;
  GridSpec spec_;
  Grid<dim> grid_;
  std::unique_ptr<const Loops> products_, lists_;
  Body body_;
  VelocityField<dim> field_;
  Weights<dim> at_;
};

template <class Geometry>
void compare_loops(const ShapeEntry& products, const ShapeEntry& lists, const Layout& layout = {}) {
  const auto neo_hookean = std::make_shared<NeoHookean>();
  neo_hookean->youngs_modulus = neo_hookean->density = 1;
  const auto hooke = std::make_shared<LinearElastic>();
  hooke->youngs_modulus = hooke->density = 1;
  const auto chain = std::make_shared<SegmentMembrane>();
  chain->youngs_modulus = chain->density = chain->section = 1;
  std::vector<std::shared_ptr<const Material>> materials{std::make_shared<IdealGas>(scenes::inviscid_law()),
                                                         std::make_shared<IdealGas>(scenes::rough_law()), neo_hookean,
                                                         hooke, chain};
  std::vector<Transfer> transfers{{.keep = 0.7}};
  for (const char* name : {"apic", "flip", "pic", "xpic", "fmpm"}) transfers.push_back(transfer_of(name, 2));
  for (const auto& material : materials) {
    for (const Transfer& transfer : transfers) {
      SCOPED_TRACE(testing::Message() << products.name << ' ' << material->name() << ' ' << transfer.affine << ' '
                                      << transfer.keep << ' ' << transfer.order);
      Pair<Geometry>(products, lists, transfer, material, layout).compare();
    }
  }
}

template <class S>
void compare_geometries(const std::string& name) {
  const ShapeEntry lists = list_entry<Listed<S>::template Of>(name, "", "");
  const ShapeEntry& products = shape_named(name);
  compare_loops<Line>(products, lists);
  compare_loops<Plane>(products, lists);
  compare_loops<Axisymmetric>(products, lists);
  compare_loops<Solid>(products, lists);
}

TEST(ListLoops, OfQuadraticsAreThoseOfTheirProducts) { compare_geometries<Quadratic>("quadratic"); }
TEST(ListLoops, OfCubicsAreThoseOfTheirProducts) { compare_geometries<Cubic>("cubic"); }
TEST(ListLoops, OfBoxesAreThoseOfTheirProducts) { compare_geometries<Gimp>("gimp"); }

// The loops by packs: where all domains are narrow, where some need four nodes in a row, and where a block of six is more than
// the grid has.
TEST(ListLoops, OfDomainsAreThoseOfTheirCorners) {
  const ShapeEntry lists = list_entry<Cpdi>("cpdi", "", "");
  for (const Layout& layout :
       {Layout{}, Layout{.reach = 0.45}, Layout{.reach = 0.75}, Layout{{2, 2, 1}}, Layout{{1, 2, 1}}}) {
    compare_loops<Plane>(shape_named("cpdi"), lists, layout);
    compare_loops<Axisymmetric>(shape_named("cpdi"), lists, layout);
  }
}

}  // namespace
}  // namespace plumbline::list_loops_test
