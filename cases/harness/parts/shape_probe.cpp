#include "cases/harness/parts/shape_probe.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "kernel/engine/placing.hpp"
#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {
namespace {

Scene scene_of(const std::string& shape, const GridSpec& grid) {
  Scene scene;
  scene.grid = grid;
  scene.shape = shape;
  scene.transfer = "apic";
  return scene;
}

template <class Geometry>
class Probe final : public ShapeProbe {
 public:
  static constexpr int dim = Geometry::dim;
  using Space = Discretisation<Geometry>;
  using Vec = typename Space::Vec;
  using Loops = typename Space::Loops;
  using Points = std::vector<ProbePoint>;

  Probe(const std::string& shape, const GridSpec& grid) : spec_(grid), space_(scene_of(shape, grid), 1) {}

  const GridSpec& grid() const override { return spec_; }
  int support() const override { return space_.shape.support; }
  double blur() const override { return space_.shape.blur; }
  int nodes() const override { return space_.grid.node_count(); }
  Eigen::RowVectorXd place(int node) const override { return space_.grid.position(node).transpose(); }
  std::array<int, 3> index(int node) const override {
    std::array<int, 3> index{};
    for (int d = 0; d < dim; ++d) index[static_cast<std::size_t>(d)] = space_.grid.index(node, d);
    return index;
  }
  bool inside(const ProbePoint& point) const override {
    int lowest = 0;
    return space_.loops->find_lowest(body_at({point}).points, {0, 1}, &lowest);
  }

  Interpolated interpolated(const Points& points, const Eigen::MatrixXd& u) const override {
    Body body = body_at(points);
    const Weights<dim> at = weights_of(body);
    const std::vector<Vec> nodal = vectors(u);
    std::vector<std::vector<double>> values(dim, std::vector<double>(points.size() + lanes));
    std::vector<typename Loops::Gather> wanted;
    for (int d = 0; d < dim; ++d) {
      wanted.push_back({component(nodal, d), dim, values[static_cast<std::size_t>(d)].data()});
    }
    space_.gather(body.points, at, wanted);
    space_.for_chunks(at, [&](const Chunk& chunk) { space_.loops->gather_start(body, at, chunk, {.rates = &nodal}); });
    const Eigen::Index count = body.points.points();
    Interpolated all{Eigen::MatrixXd(count, dim), std::vector<Eigen::MatrixXd>(dim, Eigen::MatrixXd(count, dim))};
    for (int c = 0; c < dim; ++c) {
      all.value.col(c) = Eigen::Map<Eigen::VectorXd>(values[static_cast<std::size_t>(c)].data(), count);
      for (int d = 0; d < dim; ++d) {
        all.gradient[static_cast<std::size_t>(d)].col(c) = Eigen::Map<Eigen::VectorXd>(
            body.points(column::strain_rate, c * dim + d), count);
      }
    }
    return all;
  }

  Eigen::VectorXd spread(const Points& points, const Eigen::VectorXd& q) const override {
    const Body body = body_at(points);
    std::vector<double> values(q.data(), q.data() + q.size());
    values.resize(points.size() + lanes);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(nodes());
    const typename Loops::Spread one{values.data(), nullptr, sums.data(), 1};
    space_.spread(body.points, weights_of(body), {&one, 1});
    return sums;
  }

  Eigen::VectorXd mapped_mass(const Points& points, const Eigen::VectorXd& m) const override {
    Body body = body_at(points);
    for (int p = 0; p < body.points.points(); ++p) body.points(column::mass)[p] = m[p];
    const Weights<dim> at = weights_of(body);
    VelocityField<dim> field(space_.grid);
    space_.for_chunks_writing_nodes(
        at, [&](const Chunk& chunk) { space_.loops->map_mass_and_momentum(body, at, chunk, field); });
    return Eigen::Map<Eigen::VectorXd>(field.mass.data(), nodes());
  }

  Eigen::MatrixXd forces(const Points& points, const Eigen::VectorXd& volume, const Eigen::Matrix3d& sigma,
                         double hoop) const override {
    Body body = body_at(points);
    for (int p = 0; p < body.points.points(); ++p) {
      body.points(column::volume)[p] = volume[p];
      for (int k = 0; k < dim * dim; ++k) body.points(column::stress, k)[p] = sigma(k / dim, k % dim);
      if (Geometry::axisymmetric) body.points(column::stress, dim * dim)[p] = hoop;
    }
    const Weights<dim> at = weights_of(body);
    VelocityField<dim> field(space_.grid);
    space_.for_chunks_writing_nodes(
        at, [&](const Chunk& chunk) { space_.loops->map_forces(body, at, chunk, Shares::none, field); });
    Eigen::MatrixXd all(nodes(), dim);
    for (int i = 0; i < all.rows(); ++i) all.row(i) = field.force[static_cast<std::size_t>(i)].transpose();
    return all;
  }

  std::vector<std::array<int, 3>> lowest(const Points& points) const override {
    const Body body = body_at(points);
    const Bins& bins = weights_of(body).bins;
    std::vector<std::array<int, 3>> all;
    for (int bin = 0; bin < bins.bins(); ++bin) {
      all.insert(all.end(), static_cast<std::size_t>(bins.end(bin) - bins.start(bin)), index(bins.node(bin)));
    }
    return all;
  }

  Eigen::MatrixXd inertia(const Points& points) const override {
    const Body body = body_at(points);
    Eigen::MatrixXd all(body.points.points(), dim);
    for (int p = 0; p < all.rows(); ++p) {
      for (int d = 0; d < dim; ++d) all(p, d) = space_.loops->inertia(body.points, d, p);
    }
    return all;
  }

  Eigen::MatrixXd taken(const Points& points, const Eigen::Vector3d& a, const Eigen::Matrix3d& b) const override {
    Body body = body_at(points);
    const Weights<dim> at = weights_of(body);
    VelocityField<dim> field(space_.grid);
    for (int i = 0; i < nodes(); ++i) {
      field.end[static_cast<std::size_t>(i)] = a.head<dim>() + b.topLeftCorner<dim, dim>() * space_.grid.position(i);
    }
    space_.for_chunks(
        at, [&](const Chunk& chunk) { space_.loops->gather_motion(body, at, chunk, field, {.dt = 0, .drift = {}}); });
    Eigen::MatrixXd all(body.points.points(), dim + dim * dim);
    for (int p = 0; p < all.rows(); ++p) {
      for (int d = 0; d < dim; ++d) all(p, d) = body.points(column::velocity, d)[p];
      for (int k = 0; k < dim * dim; ++k) all(p, dim + k) = body.points(column::affine, k)[p];
    }
    return all;
  }

  Eigen::VectorXd read_off(const Points& points, const Eigen::VectorXd& m, const Eigen::VectorXd& nodal,
                           bool specific) const override {
    Body body = body_at(points);
    for (int p = 0; p < body.points.points(); ++p) body.points(column::mass)[p] = m[p];
    const std::vector<double> values(nodal.data(), nodal.data() + nodal.size());
    const Weights<dim> at = weights_of(body);
    space_.for_chunks(at, [&](const Chunk& chunk) {
      space_.loops->gather_start(body, at, chunk, {.density = &values, .specific = specific});
    });
    return Eigen::Map<Eigen::VectorXd>(body.points(column::volume), body.points.points());
  }

  Eigen::VectorXd lost(const Points& points, const Eigen::VectorXd& m, const Eigen::MatrixXd& v,
                       const Eigen::MatrixXd& c, const Eigen::MatrixXd& u) const override {
    Body body = body_at(points);
    body.points.add(column::transfer_loss);
    for (int p = 0; p < body.points.points(); ++p) {
      body.points(column::mass)[p] = m[p];
      for (int d = 0; d < dim; ++d) body.points(column::velocity, d)[p] = v(p, d);
      for (int k = 0; k < dim * dim; ++k) body.points(column::affine, k)[p] = c(k / dim, k % dim);
    }
    const Weights<dim> at = weights_of(body);
    const std::vector<Vec> nodal = vectors(u);
    space_.for_chunks(at, [&](const Chunk& chunk) { space_.loops->gather_start(body, at, chunk, {.loss = &nodal}); });
    return Eigen::Map<Eigen::VectorXd>(body.points(column::transfer_loss), body.points.points());
  }

  std::vector<double> volumes() const override {
    std::vector<double> all = space_.loops->inverse_volumes();
    for (double& v : all) v = v > 0 ? 1 / v : 0;
    return all;
  }

 private:
  // Of a material whose points are strained by the whole velocity gradient.
  Body body_at(const Points& points) const {
    Body body = make_body("points", std::make_shared<NeoHookean>(), static_cast<int>(points.size()), dim,
                          Geometry::axisymmetric);
    body.points.add(column::affine, dim * dim);
    if (space_.shape.boxes) body.points.add(column::half_size, dim);
    for (int p = 0; p < body.points.points(); ++p) {
      const ProbePoint& point = points[static_cast<std::size_t>(p)];
      body.points(column::mass)[p] = body.points(column::volume)[p] = 1;
      for (int d = 0; d < dim; ++d) {
        body.points(column::position, d)[p] = point.x[static_cast<std::size_t>(d)];
        if (space_.shape.boxes) body.points(column::half_size, d)[p] = point.half;
      }
    }
    if (space_.loops->follows()) space_.loops->follow(body.points);
    return body;
  }

  // Of a nodal field, row by row the nodes.
  std::vector<Vec> vectors(const Eigen::MatrixXd& u) const {
    std::vector<Vec> nodal(static_cast<std::size_t>(nodes()));
    for (int i = 0; i < nodes(); ++i) nodal[static_cast<std::size_t>(i)] = u.row(i).transpose();
    return nodal;
  }

  Weights<dim> weights_of(const Body& body) const {
    Weights<dim> at = Placing<Geometry>(space_).here(body);
    for (int bin = 0; bin < at.bins.bins(); ++bin) {
      for (int d = 0; d < dim; ++d) {
        const int node = at.bins.node(bin);
        const bool on_grid = node >= 0 && node < nodes();
        if (on_grid && space_.grid.index(node, d) + space_.shape.support <= space_.grid.nodes(d)) continue;
        throw std::logic_error("a point on the grid reaches beyond its ghost nodes");
      }
    }
    return at;
  }

  GridSpec spec_;
  Space space_;
};

template <std::size_t geometry>
using GeometryOf = std::tuple_element_t<geometry, std::tuple<Line, Plane, Axisymmetric, Solid>>;

// call(std::integral_constant) of the geometry of that number.
template <class Call>
auto of_geometry(std::size_t geometry, Call&& call) {
  switch (geometry) {
    case 0:
      return call(std::integral_constant<std::size_t, 0>{});
    case 1:
      return call(std::integral_constant<std::size_t, 1>{});
    case 2:
      return call(std::integral_constant<std::size_t, 2>{});
    default:
      return call(std::integral_constant<std::size_t, 3>{});
  }
}

// A place along a direction of so many cells, in cells.
double coordinate(ProbeRandom& random, int cells, double least) {
  double x = random(least, cells);
  if (random(0, 1) < 1.0 / 3) {
    x = std::round(2 * x) / 2;
    const double side = random(-1, 1);
    if (side < -0.3) x = std::nextafter(x, 0.0);
    if (side > 0.3) x = std::nextafter(x, 2.0 * cells);
  }
  return std::max(x, least);
}

}  // namespace

const std::vector<std::string>& geometry_names() {
  static const std::vector<std::string> all{"line", "plane", "rings", "space"};
  return all;
}

GridSpec probe_grid(std::size_t geometry, bool walls) {
  const bool rings = geometry == 2;
  GridSpec grid;
  grid.dim = geometry == 0 ? 1 : geometry == 3 ? 3 : 2;
  grid.axisymmetric = rings;
  grid.h = 0.3;
  grid.origin = {rings ? 0.0 : 0.7, -0.4, 0.2};
  const std::array<int, 3> cells = geometry == 0   ? std::array{9, 1, 1}
                                   : geometry == 3 ? std::array{3, 4, 2}
                                                   : std::array{5, 4, 1};
  grid.cells = cells;
  if (walls) grid.walls.fill({Wall::symmetry, Wall::symmetry});
  return grid;
}

std::unique_ptr<ShapeProbe> probe(const ShapeEntry& shape, std::size_t geometry, const GridSpec& grid) {
  return of_geometry(geometry, [&](auto k) -> std::unique_ptr<ShapeProbe> {
    return std::make_unique<Probe<GeometryOf<k()>>>(shape.name, grid);
  });
}

std::vector<ProbePoint> probe_points(const GridSpec& grid, int count, unsigned long seed, bool off_axis) {
  constexpr double least_half = 0.1, widest_half = 0.5;  // of boxes, in cells: up to half a cell on each side
  ProbeRandom random(seed);
  std::vector<ProbePoint> points(static_cast<std::size_t>(count));
  for (ProbePoint& point : points) {
    point.half = grid.h * random(least_half, widest_half);
    for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
      const double least = off_axis && grid.axisymmetric && d == 0 ? 0.1 : 0;
      point.x[d] = grid.origin[d] + grid.h * coordinate(random, grid.cells[d], least);
    }
  }
  return points;
}

}  // namespace plumbline
