// A gas flow with one coordinate and a known solution, as a run: scene, measures and profile of any such case in any
// geometry.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "cases/catalog/gas/fill.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/run/judged_at_end.hpp"
#include "reference/gas_problem.hpp"
#include "reference/riemann.hpp"

namespace plumbline {

// A sample without its bounds.
inline reference::GasState state_of(const reference::Sample& at) {
  return {at.density.value, at.velocity.value, at.pressure.value};
}

// A point as the reference sees it, in the moving frame.
struct GasSample {
  double coordinate, volume;           // m, m^3
  double density, velocity, pressure;  // velocity: along the flow
  double energy;                       // J/kg
};

// What a case states. The flow has one coordinate s(x) - a place along an axis, a radius - and its velocity one
// direction n(x), a unit vector. Lengths in m, times in s.
struct GasFlow {
  int dim = 1;
  bool axisymmetric = false;
  double cells_along = 1;                                      // the length that `cells` counts
  Position low{}, high{1, 1, 1};                               // the statement's domain at t = 0
  int axis = 0;                                                // along which the gas is stratified
  int lines = 2;                                               // of points a cell across the axis
  std::vector<double> jumps;                                   // of the state along the axis, at t = 0
  std::function<reference::GasState(double s)> initial;        // density along the axis alone
  std::function<reference::Sample(double s, double t)> exact;  // t > 0
  std::function<reference::GasFields()> exact_error;   // mean |error| of `exact`, where that is known better than by
                                                       // adding up its bounds
  std::function<double(const Position&)> coordinate;   // default: the place along the axis
  std::function<Position(const Position&)> direction;  // default: along the axis
  std::string abscissa = "x";                          // what profiles call the coordinate
  double gamma = 1.4, viscosity = 0;                   // viscosity: mu, Pa s
  double end_time = 1;                                 // > 0

  // Gas in the state of the ends is added beyond both ends of the axis, so that nothing that walls do reaches the
  // domain; rounded up to whole cells.
  std::array<double, 2> margin{0, 0};
  // Empty grid beyond both ends of the gas, for gas or pistons that move there; rounded up to whole cells.
  std::array<double, 2> space{0, 0};
  std::array<std::array<Wall, 2>, 3> walls{
      {{Wall::symmetry, Wall::symmetry}, {Wall::symmetry, Wall::symmetry}, {Wall::symmetry, Wall::symmetry}}};
  // Ends of the gas along the axis that are pistons, each with its velocity.
  std::array<std::optional<double>, 2> pistons{};
  // Everything is seen from a frame that moves along the axis: the gas and its pistons have this velocity beside their
  // own, and `exact` and the measures are of the moving frame.
  double frame_velocity = 0;
  // Where points are judged at the end, of the coordinate in the moving frame. Default: everywhere between walls and
  // pistons, and no further than the domain where the gas goes on beyond it.
  std::optional<Interval> judged;
  bool filled = true;  // gas fills its space to the end, so that `coverage` means something
  // Points are judged only where this holds, too; of their place at the end. Default: everywhere.
  std::function<bool(const Position&)> inside;
  // Fills the scene with gas. Default: the whole box, as `initial` says.
  std::function<Body(std::shared_ptr<const IdealGas>, const PointRule&, const GridSpec&)> fill;
  std::function<void(const Simulation&)> observe;  // after each step
  std::function<void(Archive&)> history;           // of what `observe` saw; see Problem
  std::vector<std::string> seen_on_the_way;        // names of further measures that are made of what `observe` saw
  // Measures beside the norms, of the points where they are judged.
  std::function<std::vector<Measure>(const std::vector<GasSample>& points, double time)> further;
};

// Keys `cells`, `ppc`, `points`, `offset`, ... as every gas case has them. A shift of the grid moves walls at the gas's
// ends by less than a cell and the gas with them, so that the gas always ends on them.
//
// Measures: density, pressure, energy (per mass), and velocity: the length of the vector v_p - u n; each L1, L2, Linf
// over the points judged, weighted with V_p = m_p / rho_p. `coverage`: volume of the points over that of the space
// where they are judged; a point across the end of that space counts with its share inside, V_p^(1/dim) long.
class GasProblem final : public Problem, public JudgedAtEnd {
 public:
  GasProblem(GasFlow flow, Settings settings);

  double end_time() const override { return flow_.end_time; }
  Scene scene() const override;
  void observe(const Simulation& simulation) override {
    if (flow_.observe) flow_.observe(simulation);
  }
  void history(Archive& archive) override {
    if (flow_.history) flow_.history(archive);
  }
  std::vector<std::string> seen_on_the_way() const override { return flow_.seen_on_the_way; }
  std::vector<Measure> measures(const Simulation& simulation) const override;
  Profile profile(const Simulation& simulation) const override;

 private:
  // The grid and the gas's ends along the axis, for the settings' mesh.
  struct Layout {
    GridSpec grid;
    Interval gas;
  };
  Layout layout() const;
  Body body(const Layout& at) const;
  Interval judged() const;
  double judged_space() const;
  double share_judged(double coordinate, double volume) const;

  // A point as the reference sees it.
  struct Seen {
    double coordinate;  // in the moving frame
    Position direction;
    Position velocity;  // in the moving frame
    bool inside;
  };
  Seen seen(const Columns& points, int p, double time) const;

  GasFlow flow_;
  Settings settings_;
};

std::unique_ptr<Problem> gas_problem(const GasFlow& flow, const Settings& settings);

}  // namespace plumbline
