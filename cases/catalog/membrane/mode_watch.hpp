// One mode of a string, watched while it swings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/measures.hpp"
#include "kernel/simulation.hpp"
#include "reference/bounded.hpp"

namespace plumbline {

class Archive;

// The coordinate q of a mode of shape phi: displacements u_p = q phi_p, weighted by mass,
//   q = sum_p m_p u_p phi_p / sum_p m_p phi_p^2,
// so that what other modes add counts as little as orthogonality allows.
class ModeWatch {
 public:
  // The displacement is the component `direction` of the position from `rest` (m). shape: phi_p, one a point.
  // start: q at t = 0, not 0, released from rest.
  ModeWatch(std::vector<double> shape, double rest, int direction, double start)
      : shape_(std::move(shape)),
        rest_(rest),
        direction_(direction),
        times_{0},
        coordinate_{start} {}

  void observe(const Simulation& simulation);  // the first body's points, in the order of `shape`
  void history(Archive& archive);

  const std::vector<double>& times() const { return times_; }
  const std::vector<double>& coordinate() const { return coordinate_; }

  // From the first zero of q to the third. Empty if there are fewer.
  std::optional<double> period() const;
  // 1 - q/q(0) at the end of the first period. Empty before it.
  std::optional<double> amplitude_loss() const;
  // What is not the mode at the last look: sqrt(sum m (u - q phi)^2 / sum m phi^2) over |q(0)|.
  double impurity() const { return impurity_; }

  // Of a run: the period against the exact one, what the amplitude loses, the impurity and the drift of energy.
  std::vector<Measure> measures(const Simulation& simulation, reference::Bounded exact_period) const;
  // q over time beside the exact one. The labels say what is drawn.
  Profile profile(std::string label, std::string exact_label, const std::function<double(double)>& exact) const;

 private:
  std::vector<double> shape_;
  double rest_;
  int direction_;
  std::vector<double> times_, coordinate_;
  double impurity_ = 0;
};

// Cells between a string that swings and a wall beside it: 0.4 m, two at least.
int cells_beside(double h);

}  // namespace plumbline
