// The amplification matrix of a step, by differentiating the step itself, and its spectral radius over wave numbers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

#include "cases/harness/laboratory/patch.hpp"
#include "cases/harness/laboratory/step_map.hpp"

namespace plumbline {

using WaveNumber = std::array<double, 2>;  // per period in each direction of the lattice, (-pi, pi]

// How far off the derivatives are, and how they were found.
struct Differences {
  double size = 0;   // of the changes made to the state, in its units
  double error = 0;  // largest difference of an entry from what changes of another size give
};

// However small the changes, the step stops on an inadmissible state.
struct NotStepped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What the points of one period become after a step when those of another change: one block per distance in periods.
class Amplification {
 public:
  // Differentiates about the patch's own state. The patch holds one period and its margin. Points whose columns nothing
  // depends on, or that stay as they are whatever happens, are left out: they belong to the eigenvalues 0 and 1.
  // Throws NotStepped.
  Amplification(const Patch& patch, const IntegratorChoice& integrator, Positions positions, double dt);

  int unknowns() const { return unknowns_; }
  const Differences& differences() const { return differences_; }
  // Largest entry among blocks of the outermost periods; what is cut off is about as large.
  double tail() const { return tail_; }

  // Sum over distances n of A_n exp(-i theta n).
  Eigen::MatrixXcd at(const WaveNumber& theta) const;
  // Largest modulus of an eigenvalue.
  double spectral_radius(const WaveNumber& theta) const;

 private:
  using Blocks = std::map<Patch::Period, Eigen::MatrixXd>;
  static Blocks differentiate(const Patch& patch, StepMap& map, Differences& differences);
  void drop_idle();

  int directions_ = 0, unknowns_ = 0;
  Blocks blocks_;
  Differences differences_;
  double tail_ = 0;
};

// The largest spectral radius over all wave numbers, and where. Samples first, then climbs from the best samples and from
// the hints: close to a limit only waves of a narrow band grow, and all others have the radius one.
struct WorstWave {
  double radius = 0;
  WaveNumber theta{};
};
WorstWave worst_wave(const Amplification& amplification, int directions, const std::vector<WaveNumber>& hints = {});

}  // namespace plumbline
