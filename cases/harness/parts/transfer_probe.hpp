// Free bodies whose velocities go to the grid and back by one transfer, through the stages of a step.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cases/harness/parts/probe_random.hpp"
#include "kernel/mechanics.hpp"

namespace plumbline {

// v_p (dim numbers), and C_p row by row (dim^2, for transfers that are affine) at a place.
struct PointMotion {
  Eigen::VectorXd velocity;
  Eigen::MatrixXd affine;
};
using MotionAt = std::function<PointMotion(const Eigen::VectorXd& x)>;

class TransferProbe {
 public:
  // The scene has a grid, and names shape and transfer; points without stress are put at `places`, m, with these masses.
  TransferProbe(Scene scene, const std::vector<Eigen::VectorXd>& places, const std::vector<double>& masses,
                const MotionAt& motion);

  // One step: to the grid and back over dt, s. moving: points change their places, too.
  void pass(double dt, bool moving);

  // Row by row the points as they were put in.
  Eigen::MatrixXd velocities() const { return column_of(column::velocity); }
  Eigen::MatrixXd affine() const { return column_of(column::affine); }
  Eigen::MatrixXd places() const { return column_of(column::position); }
  Totals totals() const { return engine_->totals(); }
  const Ledger& ledger() const { return ledger_; }

 private:
  Eigen::MatrixXd column_of(const ColumnId& id) const;

  Scene scene_;
  Ledger ledger_;
  std::unique_ptr<Engine> engine_;
  double time_ = 0;
};

}  // namespace plumbline
