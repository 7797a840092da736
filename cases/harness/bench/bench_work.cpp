#include "cases/harness/bench/bench_work.hpp"

#include "cases/harness/bench/bench_trace.hpp"
#include "kernel/rotations.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "kernel/stencil.hpp"

namespace plumbline {
namespace {

// One pass over the points, in doubles per point; what a pass reads and then writes counts twice. A chunk of points stays
// in the cache during a pass, so that loops which follow each other on a chunk share what they read.
struct Pass {
  double read = 0, written = 0;
  int operations = 0;
};

constexpr double whole_number = 0.5;  // of a double

template <int dim, class Shape>
class Passes {
 public:
  explicit Passes(const BenchFlow& flow)
      : affine_(flow.transfer == "apic"),
        increments_(flow.transfer == "flip"),
        axisymmetric_(flow.axisymmetric),
        exchange_(!increments_) {}

  PointWork of(const std::string& integrator) {
    if (integrator == "leapfrog") {
      // drift_points; locate_points, map_mass_and_momentum; stress and forces in one pass; the rest is another.
      for (const Pass& pass : {drift(), sort(true), map(true), stress(true), forces(true), finish(true)}) add(pass);
    } else if (integrator == "energy") {
      // reverse_cooling() wants the midpoint strain rates; somewhere in a flow with shocks it changes a point, and forces
      // are mapped again.
      for (const Pass& pass :
           {sort(true), map(true), stress(true), forces(false), cooling(), forces(false), finish(false)})
        add(pass);
    } else {
      // map_mass_and_momentum, map_forces; move_points: strain rates, their power, then the points move; map_momentum;
      // update_stress: strain rates, advance, the density from a map of its own, and the survey.
      for (const Pass& pass : {sort(false), map(true), forces(false), rates(), power(), move(), map(false), rates(),
                               advance(), place_again(), mass_alone(), density_and_stress(), survey()})
        add(pass);
    }
    return work_;
  }

 private:
  using Kernel = Stencil<dim, Shape, Traced>;
  static constexpr int nodes = Kernel::nodes;
  static constexpr double vector = dim;
  double tensor() const { return affine_ ? dim * dim : 0; }

  void add(const Pass& pass) {
    work_.bytes += 8 * (pass.read + pass.written);
    work_.operations += pass.operations;
  }

  // --- counting
  static Traced given() { return Traced::input(); }
  void begin() {
    Trace::current() = Trace();
    results_.clear();
  }
  void keep(const Traced& result) { results_.push_back(result.at()); }
  int counted() const { return Trace::current().operations(results_); }
  Kernel stencil() const {
    Traced local[dim];
    for (Traced& x : local) x = (given() - given()) * given() - given();
    return Kernel(local, 2.0);  // a cell size that is not 1: its factors count
  }
  Jet<dim, Traced> jet(const Kernel& weights) const {
    Traced field[nodes];
    for (Traced& f : field) f = given();
    return weights.gather_array([&](int k) { return field[k]; });
  }
  struct Sums {
    Traced at[nodes];
    Sums() {
      for (Traced& s : at) s = given();
    }
  };
  void keep(const Sums& sums) {
    for (const Traced& s : sums.at) keep(s);
  }

  // --- what loops do with a point
  void scatter(const Kernel& weights, const Traced& value) {
    Sums sums;
    weights.spread(value, sums.at, 1);
    keep(sums);
  }
  void scatter_momentum(const Kernel& weights, const Traced& m, bool with_mass) {
    Traced shares[nodes];
    weights.find_weights(m, shares);
    if (with_mass) {
      Sums sums;
      for (int k = 0; k < nodes; ++k) sums.at[k] += shares[k];
      keep(sums);
    }
    for (int d = 0; d < dim; ++d) {
      Sums sums;
      const Traced v = given();
      if (affine_) {
        Traced slope[dim];
        for (Traced& s : slope) s = given();
        weights.spread_moment(shares, v, slope, sums.at, 1);
      } else {
        for (int k = 0; k < nodes; ++k) sums.at[k] += shares[k] * v;
      }
      keep(sums);
    }
  }
  void strain_rate(const Kernel& weights) {
    Traced divergence;
    for (int d = 0; d < dim; ++d) {
      const auto u = jet(weights);
      divergence += u.gradient[d];
      if (axisymmetric_ && d == 0) divergence += u.value / given();
    }
    keep(divergence);
  }
  void density(const Kernel& weights) { keep(given() / jet(weights).value); }
  // Lost by the map to the grid: gather_start.
  void map_loss(const Kernel& weights) {
    Traced apart, spread = jet(weights).value;
    for (int d = 0; d < dim; ++d) {
      const auto u = jet(weights);
      const Traced off = given() - given() - u.value;
      apart += off * off;
      spread -= u.value * u.value;
      for (int e = 0; affine_ && e < dim; ++e) {
        const Traced twist = given() - u.affine[e];
        apart += weights.inertia(e) * twist * twist;
        spread -= weights.inertia(e) * u.affine[e] * u.affine[e];
      }
    }
    keep(given() + 0.5 * given() * (apart + function_of(spread, 0.0)));
  }
  void equation_of_state(bool ahead) {  // p = (gamma - 1) rho e, q = rho (c_Q h div v) h div v
    const Traced rho = given() / given(), divergence = given(), e = given();
    const Traced z = given() * divergence;
    const Traced later = ahead ? function_of(e * (1.0 - z), e / (1.0 + z)) : e;
    const Traced p = given() * rho * later, closing = function_of(-divergence * given(), 0.0);
    keep(p);
    keep(p + rho * closing * (given() * function_of(given() * later, 0.0) + given() * closing));
  }
  void stress_power() { keep(given() + given() * given() * given() * given()); }  // dt V sigma div v, summed
  void viscous_power() { keep(given() + given() * given() * (given() + given()) * given()); }
  void heat() { keep(given() + given() * given() * given() * given() / given()); }
  void exchange(const Kernel& weights) {
    const Traced e = given();
    keep(e + (jet(weights).value - jet(weights).value * e));
  }
  // New velocities, what the map to the points lost, and the torque: gather_motion.
  void motion(const Kernel& weights, bool drifts) {
    Traced square = jet(weights).value;
    for (int d = 0; d < dim; ++d) {
      const auto u = jet(weights);
      const Traced v = u.value + given();
      const auto a = increments_ ? jet(weights) : u;
      const Traced v_new = increments_ ? given() + a.value : v;
      square -= a.value * a.value;
      keep(v_new);
      const Traced step = given() * (drifts ? v_new : v);
      keep(function_of(step, given()));
      keep(given() + step);
      for (int e = 0; affine_ && e < dim; ++e) {
        keep(a.affine[e]);
        square -= weights.inertia(e) * a.affine[e] * a.affine[e];
      }
    }
    keep(given() + 0.5 * given() * function_of(square, 0.0));
    for (int k = 0; k < rotation_count<dim> && !axisymmetric_; ++k) {
      if (!affine_) keep(given() + given() * (given() * given() - given() * given()));
      if (!drifts) keep(given() + given() * given() * (given() * given() - given() * given()));
    }
  }
  // Sums for the ledger, bounds of the next step, checks.
  void survey_point() {
    const Traced m = given(), e = given();
    Traced square, distance, v[dim], x[dim];
    for (int d = 0; d < dim; ++d) {
      v[d] = given();
      x[d] = given();
      square += v[d] * v[d];
      distance += x[d] * x[d];
      keep(given() + m * v[d]);
    }
    const Traced speed = function_of(square, 0.0);
    keep(given() + m * speed);
    keep(given() + m * speed * function_of(distance, 0.0));
    Traced all = square;
    for (int k = 0; affine_ && k < dim * dim; ++k) {
      const Traced c = given();
      all += 0.3 * c * c;
    }
    keep(given() + m);
    keep(given() + 0.5 * m * all);
    for (int k = 0; k < rotation_count<dim> && !axisymmetric_; ++k) {
      Traced turn = given() * given() - given() * given();
      if (affine_) turn += 0.3 * given() - 0.3 * given();
      keep(given() + m * turn);
    }
    keep(given() + m * e);
    keep(function_of(function_of(given() * e, 0.0) + speed, given()));
  }

  // --- the passes
  Pass drift() {
    begin();
    for (int d = 0; d < dim; ++d) keep(given() + given() * given());
    return {2 * vector, vector, counted()};
  }
  // The node below each point; is anything out of order; the new order from the old; columns that are not stale follow it,
  // read through it; bins.
  Pass sort(bool stress_is_stale) {
    const double columns = 2 * vector + tensor() + 2 + (stress_is_stale ? 0 : 4);
    begin();
    for (int d = 0; d < dim; ++d) keep(given() + function_of((given() - given()) * given(), 0.5));
    return {vector + 2 * whole_number + columns * (1 + whole_number) + 4 * whole_number + whole_number,
            2 * whole_number + columns + 2 * whole_number, counted()};
  }
  Pass map(bool with_mass) {
    begin();
    const Kernel weights = stencil();
    scatter_momentum(weights, given(), with_mass);
    return {2 * vector + tensor() + 1, 0, counted()};
  }
  // Strain rates, density, stress, and what the map lost: x, v, C, m, e; V, rate, loss, p, sigma.
  Pass stress(bool ahead) {
    begin();
    const Kernel weights = stencil();
    strain_rate(weights);
    density(weights);
    map_loss(weights);
    equation_of_state(ahead);
    return {2 * vector + tensor() + 2, 5, counted()};
  }
  // x, V, sigma; with heat exchange m, e and the rate; nothing anew in the pass that found the stress.
  Pass forces(bool with_stress) {
    begin();
    const Kernel weights = stencil();
    const Traced s = -given() * given();
    Traced sums[nodes * dim];
    for (Traced& sum : sums) sum = given();
    if (axisymmetric_) {
      const Traced hoop = s / given();
      weights.spread(hoop, sums, dim);
      keep(given() + hoop);
    }
    weights.spread_divergence(s, sums, dim);
    for (const Traced& sum : sums) keep(sum);
    if (exchange_) {
      const Traced m = given();
      scatter(weights, m * given());
      scatter(weights, m * function_of(-given(), 0.0));
    }
    return {with_stress ? 0 : vector + 2 + (exchange_ ? 3 : 0), 0, counted()};
  }
  Pass cooling() {
    begin();
    strain_rate(stencil());
    keep((given() + given()) * given());
    return {vector + 3, 1, counted()};
  }
  // Places twice (where the weights come from, and where the points are), m, e, V, p, sigma, loss; x, v, C, e, rate, loss.
  Pass finish(bool drifts) {
    begin();
    const Kernel weights = stencil();
    strain_rate(weights);
    if (exchange_) exchange(weights);
    motion(weights, drifts);
    stress_power();
    viscous_power();
    heat();
    keep(given() + given() / given());  // the maps' loss
    survey_point();
    return {vector + 6, 2 * vector + tensor() + 3 + (drifts ? 0 : vector), counted()};
  }
  Pass rates() {
    begin();
    strain_rate(stencil());
    return {vector, 1, counted()};
  }
  Pass power() {
    begin();
    stress_power();
    viscous_power();
    return {4, 0, counted()};
  }
  Pass move() {
    begin();
    motion(stencil(), false);
    return {3 * vector + 1 + vector, 3 * vector, counted()};  // places are kept first
  }
  Pass advance() {
    begin();
    heat();
    stress_power();
    return {5, 1, counted()};
  }
  Pass place_again() {
    begin();
    for (int d = 0; d < dim; ++d) keep(given() + function_of((given() - given()) * given(), 0.5));
    return {vector + whole_number, whole_number, counted()};
  }
  Pass mass_alone() {
    begin();
    scatter(stencil(), given());
    return {vector + 1, 0, counted()};
  }
  Pass density_and_stress() {
    begin();
    density(stencil());
    equation_of_state(false);
    return {vector + 3, 3, counted()};
  }
  Pass survey() {
    begin();
    survey_point();
    return {2 * vector + 3, 0, counted()};
  }

  bool affine_, increments_, axisymmetric_, exchange_;
  PointWork work_;
  std::vector<int> results_;
};

template <int dim>
PointWork work_in(const BenchFlow& flow) {
  if (flow.shape == "linear") return Passes<dim, Linear>(flow).of(flow.integrator);
  if (flow.shape == "quadratic") return Passes<dim, Quadratic>(flow).of(flow.integrator);
  return Passes<dim, Cubic>(flow).of(flow.integrator);
}

}  // namespace

std::optional<PointWork> work_per_point(const BenchFlow& flow) {
  if (flow.integrator != "leapfrog" && flow.integrator != "energy" && flow.integrator != "musl") return {};
  return flow.dimension == 1 ? work_in<1>(flow) : flow.dimension == 2 ? work_in<2>(flow) : work_in<3>(flow);
}

}  // namespace plumbline
