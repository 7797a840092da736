#include "cases/harness/parts/transfer_probe.hpp"

#include <utility>

#include "kernel/materials/neo_hookean.hpp"

namespace plumbline {
namespace {

// Carries no stress.
Body loose_body(const GridSpec& grid, const std::vector<Eigen::VectorXd>& places, const std::vector<double>& masses) {
  auto material = std::make_shared<NeoHookean>();
  material->density = 1;
  Body body = make_body("points", material, static_cast<int>(places.size()), grid.dim, grid.axisymmetric);
  body.spacing = grid.h / 2;
  for (int p = 0; p < body.points.points(); ++p) {
    const auto k = static_cast<std::size_t>(p);
    body.points(column::mass)[p] = body.points(column::volume)[p] = masses[k];
    for (int d = 0; d < grid.dim; ++d) body.points(column::position, d)[p] = places[k][d];
  }
  return body;
}

}  // namespace

TransferProbe::TransferProbe(Scene scene, const std::vector<Eigen::VectorXd>& places, const std::vector<double>& masses,
                             const MotionAt& motion)
    : scene_(std::move(scene)) {
  const int dim = scene_.grid.dim;
  scene_.bodies = {loose_body(scene_.grid, places, masses)};
  engine_ = make_engine(scene_, ledger_, {});
  Columns& points = scene_.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) {
    const PointMotion here = motion(places[static_cast<std::size_t>(p)]);
    for (int d = 0; d < dim; ++d) points(column::velocity, d)[p] = here.velocity[d];
    for (int k = 0; points.has(column::affine) && k < dim * dim; ++k) {
      points(column::affine, k)[p] = here.affine(k / dim, k % dim);
    }
  }
  engine_->initialise();
  ledger_.open(engine_->totals());
}

void TransferProbe::pass(double dt, bool moving) {
  engine_->set_time(time_);
  engine_->locate_points();
  engine_->map_mass_and_momentum();
  engine_->map_forces();
  engine_->advance_momentum(dt);
  if (moving) {
    engine_->move_points(dt, NodalVelocity::end);
  } else {
    engine_->kick_points(dt);
  }
  if (!engine_->survey().admissible) stop_at_inadmissible(scene_);
  ledger_.close_step(engine_->totals());
  time_ += dt;
}

Eigen::MatrixXd TransferProbe::column_of(const ColumnId& id) const {
  const Body& body = scene_.bodies[0];
  Eigen::MatrixXd all(body.points.points(), body.points.components(id));
  for (int k = 0; k < all.cols(); ++k) {
    for (int p = 0; p < all.rows(); ++p) all(body.id[static_cast<std::size_t>(p)], k) = body.points(id, k)[p];
  }
  return all;
}

}  // namespace plumbline
