#include "cases/catalog/estimators/parts/flawed_shape.hpp"

#include <utility>

namespace plumbline {
namespace {

class FlawedShape final : public ShapeProbe {
 public:
  using Points = std::vector<ProbePoint>;
  FlawedShape(std::unique_ptr<ShapeProbe> shape, const ShapeFlaws& flaws) : of_(std::move(shape)), flaws_(flaws) {}

  const GridSpec& grid() const override { return of_->grid(); }
  int support() const override { return of_->support(); }
  double blur() const override { return of_->blur() + flaws_.blur; }
  int nodes() const override { return of_->nodes(); }
  Eigen::RowVectorXd place(int node) const override { return of_->place(node); }
  std::array<int, 3> index(int node) const override { return of_->index(node); }
  bool inside(const ProbePoint& point) const override {
    return flaws_.inside ? flaws_.inside(point) : of_->inside(point);
  }

  Interpolated interpolated(const Points& points, const Eigen::MatrixXd& u) const override {
    Interpolated all = of_->interpolated(points, u);
    const double h = grid().h;
    const bool constant = (u.rowwise() - u.row(0)).isZero(0);
    for (Eigen::Index p = 0; p < all.value.rows(); ++p) {
      const double beyond = (points[static_cast<std::size_t>(p)].x[0] - flaws_.from) / h;
      all.value.row(p).array() += flaws_.value + (beyond > 0 ? flaws_.jump + flaws_.kink * beyond : 0);
      all.gradient[0].row(p).array() += beyond > 0 ? flaws_.kink / h : 0;
      for (std::size_t d = 0; d < all.gradient.size(); ++d) {
        if (flaws_.direction >= 0 && static_cast<std::size_t>(flaws_.direction) != d) continue;
        all.gradient[d].row(p).array() += (constant ? flaws_.constant_slope : flaws_.slope) / h;
      }
    }
    return all;
  }
  Eigen::VectorXd spread(const Points& points, const Eigen::VectorXd& q) const override {
    return of_->spread(points, q);
  }
  Eigen::VectorXd mapped_mass(const Points& points, const Eigen::VectorXd& m) const override {
    return of_->mapped_mass(points, m);
  }
  Eigen::MatrixXd forces(const Points& points, const Eigen::VectorXd& volume, const Eigen::Matrix3d& sigma,
                         double hoop) const override {
    return of_->forces(points, volume, sigma, hoop);
  }
  std::vector<std::array<int, 3>> lowest(const Points& points) const override {
    std::vector<std::array<int, 3>> all = of_->lowest(points);
    for (std::array<int, 3>& node : all) node[0] += flaws_.lowest;
    return all;
  }
  Eigen::MatrixXd inertia(const Points& points) const override {
    return of_->inertia(points).array() + flaws_.inertia * grid().h * grid().h;
  }
  Eigen::MatrixXd taken(const Points& points, const Eigen::Vector3d& a, const Eigen::Matrix3d& b) const override {
    Eigen::MatrixXd all = of_->taken(points, a, b);
    all.leftCols(grid().dim).array() += flaws_.taken_velocity;
    all.rightCols(grid().dim * grid().dim).array() += flaws_.taken_slope / grid().h;
    return all;
  }
  Eigen::VectorXd read_off(const Points& points, const Eigen::VectorXd& m, const Eigen::VectorXd& nodal,
                           bool specific) const override {
    return of_->read_off(points, m, nodal, specific);
  }
  Eigen::VectorXd lost(const Points& points, const Eigen::VectorXd& m, const Eigen::MatrixXd& v,
                       const Eigen::MatrixXd& c, const Eigen::MatrixXd& u) const override {
    return of_->lost(points, m, v, c, u);
  }
  std::vector<double> volumes() const override {
    std::vector<double> all = of_->volumes();
    for (double& volume : all) volume *= 1 + flaws_.volume;
    return all;
  }

 private:
  std::unique_ptr<ShapeProbe> of_;
  ShapeFlaws flaws_;
};

class OneNode final : public ShapeProbe {
 public:
  using Points = std::vector<ProbePoint>;
  OneNode(std::size_t geometry, const MapFlaws& flaws) : grid_(probe_grid(geometry, false)), flaws_(flaws) {}

  const GridSpec& grid() const override { return grid_; }
  int support() const override { return 1; }
  double blur() const override { return 0; }
  int nodes() const override { return 1; }
  Eigen::RowVectorXd place(int) const override { return Eigen::RowVectorXd::Constant(grid_.dim, 0.4); }
  std::array<int, 3> index(int) const override { return {}; }
  bool inside(const ProbePoint&) const override { return true; }

  Interpolated interpolated(const Points& points, const Eigen::MatrixXd& u) const override {
    const Eigen::MatrixXd value = u.row(0).replicate(static_cast<Eigen::Index>(points.size()), 1);
    return {value, std::vector<Eigen::MatrixXd>(static_cast<std::size_t>(grid_.dim), slope() * value)};
  }
  Eigen::VectorXd spread(const Points&, const Eigen::VectorXd& q) const override {
    return Eigen::VectorXd::Constant(1, (1 + flaws_.spread) * q.sum());
  }
  Eigen::VectorXd mapped_mass(const Points&, const Eigen::VectorXd& m) const override {
    return Eigen::VectorXd::Constant(1, (1 + flaws_.mass) * m.sum());
  }
  Eigen::MatrixXd forces(const Points& points, const Eigen::VectorXd& volume, const Eigen::Matrix3d& sigma,
                         double hoop) const override {
    Eigen::MatrixXd force(1, grid_.dim);
    for (Eigen::Index c = 0; c < grid_.dim; ++c)
      force(0, c) = -slope() * volume.sum() * sigma.row(c).head(grid_.dim).sum();
    for (std::size_t p = 0; grid_.axisymmetric && p < points.size(); ++p) {
      force(0, 0) -= volume[static_cast<Eigen::Index>(p)] * hoop / points[p].x[0];
    }
    return (1 + flaws_.force) * force;
  }
  std::vector<std::array<int, 3>> lowest(const Points& points) const override {
    return std::vector<std::array<int, 3>>(points.size());
  }
  Eigen::MatrixXd inertia(const Points& points) const override {
    return Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), grid_.dim);
  }
  Eigen::MatrixXd taken(const Points& points, const Eigen::Vector3d&, const Eigen::Matrix3d&) const override {
    return Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), grid_.dim + grid_.dim * grid_.dim);
  }
  Eigen::VectorXd read_off(const Points&, const Eigen::VectorXd& m, const Eigen::VectorXd& nodal,
                           bool specific) const override {
    return specific ? (1 + flaws_.specific) * nodal[0] * m : (1 + flaws_.density) / nodal[0] * m;
  }
  Eigen::VectorXd lost(const Points& points, const Eigen::VectorXd& m, const Eigen::MatrixXd& v,
                       const Eigen::MatrixXd& c, const Eigen::MatrixXd& u) const override {
    Eigen::VectorXd all(m.size());
    for (Eigen::Index p = 0; p < m.size(); ++p) {
      const auto x = Eigen::Map<const Eigen::VectorXd>(points[static_cast<std::size_t>(p)].x.data(), grid_.dim);
      const Eigen::VectorXd apart = v.row(p).transpose() + c * (place(0).transpose() - x) - u.row(0).transpose();
      all[p] = (1 + flaws_.loss) * m[p] * apart.squaredNorm() / 2;
    }
    return all;
  }
  std::vector<double> volumes() const override { return {1}; }

 private:
  double slope() const { return grid_.axisymmetric ? 0 : 1; }

  GridSpec grid_;
  MapFlaws flaws_;
};

}  // namespace

std::unique_ptr<ShapeProbe> flawed(std::unique_ptr<ShapeProbe> shape, const ShapeFlaws& flaws) {
  return std::make_unique<FlawedShape>(std::move(shape), flaws);
}

std::unique_ptr<ShapeProbe> one_node(std::size_t geometry, const MapFlaws& flaws) {
  return std::make_unique<OneNode>(geometry, flaws);
}

}  // namespace plumbline
