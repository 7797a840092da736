// What holds of a shape wherever a point stands, to rounding.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/parts/largest_entry.hpp"
#include "cases/harness/parts/shape_gates.hpp"

namespace plumbline {
namespace {

constexpr int identities_points = 200;
constexpr unsigned long identities_seed = 20;

std::vector<ProbePoint> anywhere(const ShapeProbe& probe) {
  return probe_points(probe.grid(), identities_points, identities_seed);
}

// Row by row the points, or nodes, m.
Eigen::MatrixXd places(const ShapeProbe& probe, const std::vector<ProbePoint>& points) {
  Eigen::MatrixXd x(static_cast<Eigen::Index>(points.size()), probe.grid().dim);
  for (Eigen::Index p = 0; p < x.rows(); ++p) {
    for (Eigen::Index d = 0; d < x.cols(); ++d)
      x(p, d) = points[static_cast<std::size_t>(p)].x[static_cast<std::size_t>(d)];
  }
  return x;
}
Eigen::MatrixXd node_places(const ShapeProbe& probe) {
  Eigen::MatrixXd x(probe.nodes(), probe.grid().dim);
  for (int i = 0; i < probe.nodes(); ++i) x.row(i) = probe.place(i);
  return x;
}
Eigen::MatrixXd ones(const ShapeProbe& probe) { return Eigen::MatrixXd::Ones(probe.nodes(), probe.grid().dim); }

double off_unity(const ShapeProbe& probe) {
  return largest_entry(probe.interpolated(anywhere(probe), ones(probe)).value.array() - 1.0);
}

double off_linear(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  return largest_entry(probe.interpolated(points, node_places(probe)).value - places(probe, points)) / probe.grid().h;
}

// sum_i grad N_ip = 0 and sum_i x_i grad N_ip = 1, the former in cells.
double off_gradient(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const Interpolated constant = probe.interpolated(points, ones(probe));
  const Interpolated linear = probe.interpolated(points, node_places(probe));
  double off = 0;
  for (std::size_t d = 0; d < constant.gradient.size(); ++d) {
    const auto direction = static_cast<Eigen::Index>(d);
    Eigen::MatrixXd slope = linear.gradient[d];
    slope.col(direction).array() -= 1.0;
    for (const double found : {probe.grid().h * largest_entry(constant.gradient[d]), largest_entry(slope)}) {
      if (!(found <= off)) off = found;
    }
  }
  return off;
}

// sum_i N_ip (x_i - x_p)_d^2 of each point and direction, in cells.
Eigen::MatrixXd second_moments(const ShapeProbe& probe, const std::vector<ProbePoint>& points) {
  const Eigen::MatrixXd x = places(probe, points), nodes = node_places(probe);
  const Eigen::RowVectorXd middle = nodes.colwise().mean();
  const Eigen::MatrixXd y = x.rowwise() - middle, z = nodes.rowwise() - middle;
  const Eigen::MatrixXd squares = probe.interpolated(points, z.array().square()).value,
                        firsts = probe.interpolated(points, z).value,
                        sums = probe.interpolated(points, ones(probe)).value;
  const double h = probe.grid().h;
  return (squares.array() - 2 * y.array() * firsts.array() + y.array().square() * sums.array()) / (h * h);
}

double off_inertia(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const double h = probe.grid().h;
  return largest_entry(probe.inertia(points) / (h * h) - second_moments(probe, points));
}

double off_constant_inertia(const ShapeProbe& probe, double claimed) {
  const double h = probe.grid().h;
  return largest_entry((probe.inertia(anywhere(probe)) / (h * h)).array() - claimed);
}

// What points take of an affine velocity, times h where it is C_p.
double off_affine(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const int dim = probe.grid().dim;
  const Eigen::Vector3d a{0.3, -0.7, 0.5};
  const Eigen::Matrix3d b = (Eigen::Matrix3d() << 0.4, -1.1, 0.6, 0.9, -0.2, 1.3, -0.8, 0.7, 0.5).finished();
  Eigen::MatrixXd off = probe.taken(points, a, b);
  const Eigen::MatrixXd x = places(probe, points), slope = b.topLeftCorner(dim, dim);
  off.leftCols(dim) -= (x * slope.transpose()).rowwise() + a.head(dim).transpose();
  for (int k = 0; k < dim * dim; ++k) off.col(dim + k).array() -= slope(k / dim, k % dim);
  off.rightCols(dim * dim) *= probe.grid().h;
  return largest_entry(off);
}

Eigen::VectorXd amounts() {
  ProbeRandom random(identities_seed + 1);
  return Eigen::VectorXd::NullaryExpr(identities_points, [&] { return random(0.5, 2); });
}

// What points put on nodes is the transpose of what they take: q . N u = u . N^T q, whatever q and u.
double off_adjoint(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const Eigen::VectorXd q = amounts(), u = random_field(probe, identities_seed + 2).col(0);
  const Eigen::VectorXd taken = probe.interpolated(points, u.replicate(1, probe.grid().dim)).value.col(0);
  const double work = q.dot(taken), scale = q.dot(taken.cwiseAbs());
  const double spread = u.dot(probe.spread(points, q)), mass = u.dot(probe.mapped_mass(points, q));
  return largest_entry(Eigen::Vector2d(spread - work, mass - work)) / scale;
}

// V_p = m_p / sum_i N_ip rho_i, and V_p = m_p sum_i N_ip v_i of specific volumes.
double off_volumes_read(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const Eigen::VectorXd m = amounts(), nodal = random_field(probe, identities_seed + 4).col(0).array() + 1.5;
  const Eigen::VectorXd here = probe.interpolated(points, nodal.replicate(1, probe.grid().dim)).value.col(0);
  const Eigen::VectorXd of_density = probe.read_off(points, m, nodal, false).cwiseProduct(here).cwiseQuotient(m),
                        of_volume = probe.read_off(points, m, nodal, true).cwiseQuotient(here.cwiseProduct(m));
  return largest_entry(
      Eigen::Vector2d(largest_entry(of_density.array() - 1.0), largest_entry(of_volume.array() - 1.0)));
}

// m_p sum_i N_ip |v_p + C (x_i - x_p) - u_i|^2 / 2 is what the map to the nodes takes from a point. [EC-APIC 1]
double off_loss(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = anywhere(probe);
  const Eigen::Index dim = probe.grid().dim, count = static_cast<Eigen::Index>(points.size());
  ProbeRandom random(identities_seed + 5);
  const Eigen::MatrixXd v = Eigen::MatrixXd::NullaryExpr(count, dim, [&] { return random(-1, 1); }),
                        c = Eigen::MatrixXd::NullaryExpr(dim, dim, [&] { return random(-1, 1) / probe.grid().h; }),
                        u = random_field(probe, identities_seed + 6), x = places(probe, points),
                        nodes = node_places(probe);
  const Eigen::VectorXd m = amounts(), lost = probe.lost(points, m, v, c, u);
  Eigen::VectorXd exact(count);
  for (Eigen::Index p = 0; p < count; ++p) {
    const Eigen::MatrixXd apart = ((nodes.rowwise() - x.row(p)) * c.transpose() - u).rowwise() + v.row(p);
    const Eigen::VectorXd square = 0.5 * m[p] * apart.rowwise().squaredNorm();
    exact[p] = probe.interpolated({points[static_cast<std::size_t>(p)]}, square.replicate(1, dim)).value(0, 0);
  }
  return largest_entry(lost - exact) / exact.maxCoeff();
}

// The power of stresses over the points is that of their forces over the nodes: u . f = -sum_p V_p sigma : grad u.
double off_power(const ShapeProbe& probe) {
  const std::vector<ProbePoint> points = probe_points(probe.grid(), identities_points, identities_seed, true);
  const GridSpec& grid = probe.grid();
  const Eigen::VectorXd volume = amounts();
  const Eigen::Matrix3d sigma = (Eigen::Matrix3d() << 1.2, 0.5, -0.4, 0.5, -0.8, 0.7, -0.4, 0.7, 0.9).finished();
  const double hoop = grid.axisymmetric ? 0.6 : 0;
  const Eigen::MatrixXd u = random_field(probe, identities_seed + 3);
  const Interpolated taken = probe.interpolated(points, u);
  Eigen::VectorXd power = Eigen::VectorXd::Zero(volume.size());
  for (int c = 0; c < grid.dim; ++c) {
    for (int d = 0; d < grid.dim; ++d) power += sigma(c, d) * taken.gradient[static_cast<std::size_t>(d)].col(c);
  }
  if (grid.axisymmetric) power += hoop * taken.value.col(0).cwiseQuotient(places(probe, points).col(0));
  const double work = -volume.dot(power), scale = volume.dot(power.cwiseAbs());
  return std::abs(u.cwiseProduct(probe.forces(points, volume, sigma, hoop)).sum() - work) / scale;
}

// Of the space between walls: its cells, rings of them per radian.
double off_volume(const ShapeSubject& subject) {
  const GridSpec& grid = subject.walled->grid();
  double space = 1, sum = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    const double extent = grid.cells[d] * grid.h;
    space *= grid.axisymmetric && d == 0 ? extent * (grid.origin[0] + extent / 2) : extent;
  }
  for (const double v : subject.walled->volumes()) sum += v;
  return std::abs(sum / space - 1);
}

// theta of the smoothing 1 - theta k^2 h^2 of one map is half the variance of the shape: half of D_p's mean over a cell.
double off_blur(const ShapeProbe& probe) {
  constexpr int places = 1000;
  const GridSpec& grid = probe.grid();
  std::vector<ProbePoint> points(places);
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p].half = grid.h / 4;
    for (std::size_t d = 0; d < 3; ++d) {
      points[p].x[d] = grid.origin[d] + grid.h * (1 + (static_cast<double>(p) + 0.5) / places);
    }
  }
  return std::abs(probe.inertia(points).col(0).mean() / (2 * grid.h * grid.h) - probe.blur());
}

constexpr double blur_sum = 1e-5;  // a mean of n places is off by slopes of order one over n^2 where D_p has kinks

constexpr const char* weights_wrong =
    "a weight of one node, or the nodes that a point reaches where its cell or a wall begins";
constexpr const char* inertia_wrong =
    "the inertia D_p or the weights of the affine part do not belong to the shape's values";

}  // namespace

std::vector<MeasuredGate> shape_identity_gates(const SharedSubject& subject) {
  const std::string where = geometry_names()[subject->geometry];
  const std::string tried = ", at 200 points, walls, node lines and cells' middles among them";
  const auto both = [&](double (*off)(const ShapeProbe&)) {
    return [subject, off] { return plain(subject->larger_of_both(off)); };
  };
  const auto row = [&](const std::string& family, const std::string& name, const std::string& quantity,
                       const std::string& reason, const char* cause, std::function<Measured()> measure) {
    return MeasuredGate{family,
                        gate_row(family, name.empty() ? where : name + "/" + where, quantity, {{}, shape_rounding},
                                 Origin::identity, reason + "; a few thousand roundings"),
                        cause, std::move(measure)};
  };
  std::vector<MeasuredGate> all{
      row("unity", "", "sum_i N_ip less 1" + tried, "mass goes to the nodes whole, and uniform motion comes back",
          weights_wrong, both(off_unity)),
      row("linear", "", "sum_i N_ip x_i less x_p, in cells" + tried,
          "linear fields are reproduced: the centre of mass stays, and interpolation is of order 2", weights_wrong,
          both(off_linear)),
      row("gradient", "sums", "sum_i grad N_ip, and sum_i x_i grad N_ip less 1" + tried,
          "the gradients of a constant and of a linear field", "a gradient of one node, or its unit: 1/h",
          both(off_gradient)),
      row("adjoint", "values",
          "q . (N u) less u . (N^T q) over |q| . |N u|, of random u and q, masses and other values",
          "points put on nodes by the weights by which they take from them, or energy is not kept",
          "different weights to the nodes and back", both(off_adjoint)),
      row("adjoint", "forces",
          "power of stresses over random nodal velocities less that of their nodal forces, relative",
          "the power of the stresses is that of their forces, or energy is not kept",
          "forces and strain rates come from different gradients", both(off_power)),
      row("inertia", "second-moment", "D_p less sum_i N_ip (x_i - x_p)^2, in cells" + tried,
          "D_p is the second moment of the weights", inertia_wrong, both(off_inertia)),
      row("inertia", "affine", "what points take of an affine velocity, less it" + tried,
          "affine velocities are reproduced by value and by C_p", inertia_wrong, both(off_affine)),
      row("volume", "", "sum of the nodes' volumes over the space between walls, less 1",
          "the nodes share the space out, as the weights add up to 1", "volumes of nodes at walls, or beyond them",
          [subject] { return plain(off_volume(*subject)); }),
      row("volume", "read",
          "V_p that points take from random nodal densities, and specific volumes, over m_p and the mean of these, "
          "less 1",
          "points read densities off by the weights by which they put their mass on the nodes",
          "other weights, or the density where the specific volume is meant", both(off_volumes_read)),
      row("adjoint", "loss",
          "kinetic energy that the map takes from points less m_p sum_i N_ip |v_p + C_p (x_i - x_p) - u_i|^2 / 2, of "
          "random u, relative to the most",
          "what the map takes is known to each point, or energy is not returned",
          "a term of the loss, or the inertia of the affine part", both(off_loss))};
  all.push_back({"inertia",
                 gate_row("inertia", "blur/" + where,
                          "half the mean of D_p over a cell less the shape's blur, in cells; boxes of half a cell",
                          {{}, blur_sum}, Origin::theory,
                          "sharpening undoes the smoothing by half the variance of the shape; the mean of 1000 places"),
                 inertia_wrong, [subject] { return plain(off_blur(*subject->walled)); }});
  if (subject->entry->offers.count(Trait::constant_inertia) > 0) {
    all.push_back(row("inertia", "constant", "D_p in cells less what the shape says of it" + tried,
                      "the shape offers the trait constant-inertia", inertia_wrong, [subject] {
                        const double claimed = subject->entry->inertia;
                        return plain(subject->larger_of_both(
                            [&](const ShapeProbe& probe) { return off_constant_inertia(probe, claimed); }));
                      }));
  }
  return all;
}

}  // namespace plumbline
