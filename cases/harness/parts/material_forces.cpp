// Materials whose points pull at each other: their forces are the derivative of what they store, and balance.
#include <cmath>
#include <utility>

#include "cases/harness/parts/material_gates.hpp"
#include "cases/harness/parts/material_waves.hpp"
#include "cases/harness/parts/parts.hpp"
#include "cases/harness/parts/shape_probe.hpp"
#include "kernel/materials/segment_membrane.hpp"  // the column rest_length
#include "kernel/materials/surface_law.hpp"       // the column tangents

namespace plumbline {
namespace {

constexpr unsigned long forces_seed = 80;
constexpr int forces_points = 9, tries = 5;

// Points a unit apart on a curve, or of a surface on a part of one, moved by up to a fifth of it; each row a point.
class Pulling {
 public:
  Pulling(std::shared_ptr<const Material> material, std::size_t geometry, double density, ProbeRandom& random)
      : material_(std::move(material)) {
    context_.dim = geometry == 0 ? 1 : geometry == 3 ? 3 : 2;
    body_ = make_body("points", material_, forces_points, context_.dim, false);
    Eigen::MatrixXd x(forces_points, context_.dim);
    for (int p = 0; p < forces_points; ++p) {
      const double along = p % 3, across = p / 3;
      const double on_curve[3] = {1.0 + p, 0.05 * p * p, 0.2 * p};
      const double on_surface[3] = {along, across, 0.1 * along * along - 0.05 * along * across};
      for (int d = 0; d < context_.dim; ++d) x(p, d) = material_->surface() ? on_surface[d] : on_curve[d];
      points()(column::volume)[p] = 1;
      points()(column::mass)[p] = density;
    }
    at(x);
    know_rest();
    forces();  // the first are those of points at rest
    set_rest_lengths(x);
    at(x + 0.2 * any(random));
  }

  Columns& points() { return body_.points; }
  Eigen::MatrixXd any(ProbeRandom& random) const {
    return Eigen::MatrixXd::NullaryExpr(forces_points, context_.dim, [&] { return random(-1, 1); });
  }
  Eigen::MatrixXd places() { return column_of(column::position); }
  void at(const Eigen::MatrixXd& x) {
    for (int d = 0; d < context_.dim; ++d) {
      for (int p = 0; p < forces_points; ++p) points()(column::position, d)[p] = x(p, d);
    }
  }
  // N
  Eigen::MatrixXd forces() {
    material_->prepare_stress(points(), all_points(points()), context_);
    material_->evaluate_stress(points(), all_points(points()), context_);
    return -column_of(column::stress);  // of volumes of 1 m^3
  }
  // J, of where the points stand.
  double energy() {
    material_->advance(points(), all_points(points()), context_, step_of_difference);
    return material_->stored_energy(points(), all_points(points()));
  }

 private:
  void know_rest() {
    for (int p = 0; points().has(column::tangents) && p < forces_points; ++p) {
      points()(column::tangents, 0)[p] = points()(column::tangents, 4)[p] = 0.95;  // stretched by as much
    }
    if (const auto own = material_->of_rest(points())) material_ = own;
  }
  // Of chains, which have such a column.
  void set_rest_lengths(const Eigen::MatrixXd& x) {
    if (!points().has(column::rest_length)) return;
    for (int p = 0; p < forces_points; ++p) {
      const double length = (x.row((p + 1) % forces_points) - x.row(p)).norm();
      points()(column::rest_length)[p] = 0.95 * length;
    }
  }
  Eigen::MatrixXd column_of(const ColumnId& id) {
    Eigen::MatrixXd all(forces_points, context_.dim);
    for (int d = 0; d < context_.dim; ++d) {
      for (int p = 0; p < forces_points; ++p) all(p, d) = points()(id, d)[p];
    }
    return all;
  }

  std::shared_ptr<const Material> material_;
  MaterialContext context_;
  Body body_;
};

// F . u of a random displacement u less the fall of the energy along it, over |F| |u|.
double off_energy(Pulling& all, ProbeRandom& random) {
  const Eigen::MatrixXd x = all.places(), u = all.any(random), forces = all.forces();
  all.at(x + step_of_difference * u);
  const double high = all.energy();
  all.at(x - step_of_difference * u);
  const double low = all.energy();
  return std::abs(forces.cwiseProduct(u).sum() + (high - low) / (2 * step_of_difference)) / (forces.norm() * u.norm());
}

double off_balance(Pulling& all, ProbeRandom&) {
  const Eigen::MatrixXd forces = all.forces();
  return forces.colwise().sum().norm() / forces.rowwise().norm().sum();
}

double off_torque(Pulling& all, ProbeRandom&) {
  const Eigen::MatrixXd forces = all.forces(), x = all.places(), moments = x.transpose() * forces;
  return (moments - moments.transpose()).norm() / (x.norm() * forces.norm());
}

}  // namespace

std::vector<MeasuredGate> pulling_gates(const std::shared_ptr<const MaterialSubject>& subject, std::size_t geometry) {
  const std::string where = geometry_names()[geometry];
  const auto row = [&](const std::string& family, const std::string& name, const std::string& quantity, double bound,
                       Origin origin, const std::string& reason, const char* cause,
                       double (*measure)(Pulling&, ProbeRandom&)) {
    return MeasuredGate{family, gate_row(family, name + "/" + where, quantity, {{}, bound}, origin, reason), cause,
                        [subject, geometry, measure] {
                          ProbeRandom random(forces_seed);
                          double worst = 0;
                          for (int k = 0; k < tries; ++k) {
                            Pulling all(subject->made.front(), geometry, subject->density, random);
                            worst = worse(measure(all, random), worst);
                          }
                          return plain(worst);
                        }};
  };
  std::vector<MeasuredGate> all{
      row("energy", "derivative", "work of the forces along random displacements less the fall of the energy, relative",
          of_difference, Origin::theory,
          "the forces are the derivative of the energy; by differences of 1e-5, whose own errors are below 1e-7",
          "a modulus or a length of the force that is not the energy's", off_energy),
      row("momentum", "balance", "sum of the forces over the sum of their sizes", rounding_of_parts, Origin::identity,
          "points that pull at each other do so alike; roundings", "a force without its reaction", off_balance)};
  if (geometry > 0) {
    all.push_back(row("frame", "torque", "sum of x cross the forces, over |x| |F|", rounding_of_parts, Origin::identity,
                      "points that pull at each other do so along the line between them; roundings",
                      "a force that is not along the bond", off_torque));
  }
  return all;
}

}  // namespace plumbline
