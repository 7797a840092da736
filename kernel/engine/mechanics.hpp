// The stages of a step. Each is a short list of loops over one chunk of bins, so that what a chunk computes is still in the
// cache when the next loop wants it. Included only by files that instantiate it for a geometry; shape and transfer are
// the loops' (point_loops.hpp).
#pragma once

#include <optional>
#include <vector>

#include "kernel/engine/chains.hpp"
#include "kernel/engine/densities.hpp"
#include "kernel/engine/discretisation.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/engine/loss_to_gas.hpp"
#include "kernel/engine/nodal_momentum.hpp"
#include "kernel/engine/placing.hpp"
#include "kernel/engine/reflection.hpp"
#include "kernel/engine/step_record.hpp"
#include "kernel/engine/velocity_filter.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/normals/membrane_tangents.hpp"

namespace plumbline {

template <class Geometry>
class Mechanics final : public Engine {
 public:
  static constexpr int dim = Geometry::dim;
  using Vec = Eigen::Matrix<double, dim, 1>;

  Mechanics(Scene& scene, Ledger& ledger, const EngineOptions& options);

  void locate_points() override;
  void map_mass_and_momentum() override;
  void map_forces() override;
  void advance_momentum(double dt) override;
  void move_points(double dt, NodalVelocity carrying) override;
  void drift_points(double dt) override;
  void kick_points(double dt) override;
  void map_momentum() override;
  void strain_points(double dt, NodalVelocity velocity) override;
  void evaluate_stress(NodalVelocity velocity) override;
  void predict_stress(double ahead, NodalVelocity velocity) override;
  void predict_stress_and_map_forces(double ahead) override;
  bool reverse_cooling() override;
  void return_transfer_loss() override;
  void move_and_heat_points(double dt) override;
  void kick_heat_and_drift_points(double dt, double drift) override;
  State state() const override;
  void set_state(const State& state) override;
  State rate() override;
  State velocities_of(State state) const override;

  void initialise() override;
  Totals totals() const override;
  void refresh_density() override;
  void check() const override;
  double step_limit() const override;
  void set_time(double time) override {
    time_ = time;
    drifted_ = 0;
  }
  void points_changed(double time) override {
    survey_.reset();
    momentum_.set_time(time);
    points_added();
  }
  void points_added() override;

 private:
  static constexpr long fewest_shared = 2048;  // points below which waking a thread costs more than it does
  static constexpr int rotations = Geometry::rotations;
  static constexpr int most_components = dim * dim + 1;  // of stress, whatever the material
  using Space = Discretisation<Geometry>;
  using Field = typename Space::Field;
  using Loops = typename Space::Loops;
  static constexpr std::size_t about = Space::about;

  static int threads_for(const Scene& scene, const EngineOptions& options);
  void add_columns();
  std::size_t bodies() const { return scene_.bodies.size(); }
  Field& field_of(std::size_t body) { return layout_.fields[layout_.field_of_body[body]]; }
  MaterialContext context(double ahead = 0) const;
  const std::vector<Vec>& nodal(const Field& field, NodalVelocity which) const;
  std::vector<ColumnId> stale_columns(const Body& body) const;
  // Heat is exchanged as points move or are kicked, by integrators that give heat back. [Exchange 1]
  bool exchanges_heat(const Body& body) const {
    return scene_.heat_exchange > 0 && options_.keep_loss && body.material->takes_heat();
  }
  void want_places(const char* stage) const;
  void want_losses(const char* stage) const;

  // --- to the nodes
  void clear_forces();
  double map_forces(std::size_t body, const Chunk& chunk);
  void add_stress_turn(std::size_t body);
  void map_load(std::size_t body);
  void settle_loss();

  // --- strain and stress
  void find_all_strain_rates(NodalVelocity which);
  double stress_power(const Body& body, PointRange range, double dt) const;
  void evaluate_stress_ahead(NodalVelocity velocity, double ahead, bool and_forces);
  void settle_pending_strain();
  void settle_power();

  // --- motion
  void gather_all_motion(double dt, std::optional<double> drift, NodalVelocity carrying);
  void filter_velocities();
  void finish_points(double dt, std::optional<double> drift);
  void hand_loss_over();
  void book_motion(const MotionSums& sums, double dt);
  void stop_if_too_far(const MotionSums& sums, const Body& body, double dt) const;

  const Survey& surveyed() const;
  template <class Visit>
  void for_state_columns(Visit&& visit) const;
  void want_size(const State& state) const;

  Scene& scene_;
  Ledger& ledger_;
  EngineOptions options_;
  Space space_;
  Layout<dim> layout_;
  Placing<Geometry> placing_;
  NodalMomentum<Geometry> momentum_;
  Densities<Geometry> densities_;
  Chains<Geometry> chains_;
  Reflection<Geometry> reflection_;
  VelocityFilter<Geometry> filter_;
  LossToGas<Geometry> loss_to_gas_;
  MembraneTangents tangents_;
  StepRecord<dim, rotations> step_;
  std::optional<MappedForces<dim>> forces_;  // none: not mapped in this step
  NodalVelocity current_ = NodalVelocity::start;
  std::optional<NodalVelocity> rate_of_;  // velocity whose strain rates the points hold
  struct {
    double dt = 0, stored = 0;
  } strained_;  // before the forces were known
  bool sorting_ = true;
  double time_ = 0, load_ahead_ = 0;  // of the step's start; how far after it the loads are wanted, s
  double drifted_ = 0;                // how far after it points stand by drift_points() alone, s
  double grid_mass_ = 0;
  mutable std::optional<Survey> survey_;
};

}  // namespace plumbline
