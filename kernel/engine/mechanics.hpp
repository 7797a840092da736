// The stages as loops over chunks of bins. Each stage is a short list of loops over one chunk, so that what a chunk
// computes is still in the cache when the next loop wants it. Included only by files that instantiate it for a geometry.
// Shape and transfer are the loops' (point_loops.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/bins.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/engine/chunks.hpp"
#include "kernel/engine/point_loops.hpp"
#include "kernel/engine/sums.hpp"
#include "kernel/engine/weights.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/normals/membrane_tangents.hpp"
#include "kernel/pack.hpp"
#include "kernel/parallel.hpp"
#include "kernel/pistons.hpp"
#include "kernel/rotations.hpp"
#include "kernel/sharpening.hpp"
#include "kernel/summation.hpp"
#include "kernel/transfers/transfers.hpp"
#include "kernel/velocity_field.hpp"
#include "kernel/walls.hpp"

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
    pistons_.set_time(time);
    points_added();
  }
  void points_added() override;

 private:
  static constexpr int block_height = dim == 1 ? 64 : 4;  // layers; a stencil reaches 3 beyond its own
  static constexpr int place_stretch = 4096;
  static constexpr long fewest_shared = 2048;  // points below which waking a thread costs more than it does
  static constexpr int rotations = Geometry::rotations;
  static constexpr int most_components = dim * dim + 1;  // of stress, whatever the material
  using Field = VelocityField<dim>;
  static constexpr std::size_t about = dim == 2 ? 2 : 0;  // the first rotation's place in a Turn
  using Loops = PointLoops<Geometry>;
  using Wanted = typename Loops::Wanted;

  // What the engine knows of a body beside its columns.
  struct Located {
    std::size_t field = 0;
    Weights<dim> weights;
  };
  // Flows of the step under way; the last advance_momentum and map count, and move_points books them.
  struct Pending {
    WallAction<dim> wall, map_wall;
    Vec body = Vec::Zero();
    Spin<dim> body_angular = Spin<dim>::Zero();
    Spin<dim> force_turn = Spin<dim>::Zero(), filter_turn = Spin<dim>::Zero();
    struct {
      Vec linear = Vec::Zero();
      Spin<dim> angular = Spin<dim>::Zero();
      double work = 0;
    } contact;
    double wall_work = 0, map_wall_work = 0, body_work = 0, stress_power = 0, map_loss = 0, viscous = 0, dt = 0;
    bool power = false;  // advance_momentum has been called and its stress power is not yet summed
    bool loss = false;   // the map's loss is not yet summed
  };
  MaterialContext context(double ahead = 0) const {
    return {dim,
            grid_.h(),
            scene_.density == DensityMethod::continuity,
            ahead,
            scene_.density == DensityMethod::grid,
            tangents_.given()};
  }
  const std::vector<Vec>& nodal(const Field& field, NodalVelocity which) const;
  Field& field_of(std::size_t body) { return fields_[located_[body].field]; }
  const Field& field_of(std::size_t body) const { return fields_[located_[body].field]; }

  // --- one chunk of one body
  double map_forces(std::size_t body, const Chunk& chunk);
  double stress_power(const Body& body, PointRange range, double dt) const;
  static std::pair<double, double> extent(const double* x, PointRange range);
  void reflect(Body& body, PointRange range, MotionSums& sums) const;
  void reflect_point(Body& body, int p, int d, double wall, MotionSums& sums) const;

  // --- one body or all
  static void refuse_other_geometry(const Body& body);
  void refuse_relaxation() const;
  void add_boxes(Body& body) const;
  void deform_boxes(Body& body);
  void place(const Body& body, Weights<dim>& at) const;
  static bool in_order(const Body& body, const Weights<dim>& at);
  bool sort_points(Body& body, Weights<dim>& at);
  void touch(const Weights<dim>& at, Field& field) const;
  void touch_alone(const Weights<dim>& at, Field& field) const;
  void want_places(const char* stage) const;
  void want_losses(const char* stage) const;
  void solve_velocity(Field& field, std::vector<Vec>& velocity) const;
  const std::vector<Vec>& straining_velocity(Field& field, NodalVelocity which) const;
  double drive(const Field& field, std::vector<Vec>& velocity, WallAction<dim>& action) const;
  void solve_exchange(Field& field, double dt) const;
  void evaluate_stress_ahead(NodalVelocity velocity, double ahead, bool and_forces);
  void clear_forces();
  void gather_all_motion(double dt, std::optional<double> drift, NodalVelocity carrying);
  void filter_velocities();
  void pass_to_points_and_back(std::size_t field_index, const std::vector<Vec>& from, std::vector<Vec>& to);
  void finish_points(double dt, std::optional<double> drift);
  bool exchanges_heat(const Body& body) const { return scene_.heat_exchange > 0 && body.material->takes_heat(); }
  void find_grid_density(Field& field, const std::vector<double>& mass, const Body& body);
  void map_own_mass(const Body& body, Weights<dim>& at, Field& field);
  void find_all_strain_rates(NodalVelocity which);
  void add_body_force(Field& field, double dt);
  void map_load(std::size_t body);
  void add_stress_turn(std::size_t body);
  void touch_bodies(double dt);
  bool hands_over(std::size_t body) const;
  void hand_loss_over();
  void take_loss(std::size_t body);
  void relax_chain(std::size_t body, MotionSums& sums);
  void shift_chain(Body& body, MotionSums& sums) const;
  void smooth_strain(std::size_t body, double dt);
  bool mixed(const Field& field) const { return !field.gas_mass.empty(); }
  const std::vector<double>& gas_mass(const Field& field) const { return mixed(field) ? field.gas_mass : field.mass; }
  std::vector<std::size_t> field_indices() const {
    std::vector<std::size_t> indices;
    for (const Located& at : located_) indices.push_back(at.field);
    return indices;
  }
  void settle_pending_strain();
  void settle_power();
  void settle_loss();
  void book_motion(const MotionSums& sums, double dt);
  void stop_if_too_far(const MotionSums& sums, const Body& body) const;
  const Survey& surveyed() const;
  template <class Visit>
  void for_state_columns(Visit&& visit) const;
  void want_size(const State& state) const;

  Scene& scene_;
  Ledger& ledger_;
  EngineOptions options_;
  TransferChoice transfer_;
  std::unique_ptr<Loops> loops_;
  ShapeTraits shape_;
  Grid<dim> grid_;
  Walls<dim> walls_;
  Pistons<dim> pistons_;
  Sharpening<dim> sharpening_;
  Vec gravity_;
  std::vector<Field> fields_;
  std::vector<Located> located_;
  std::vector<bool> alone_;             // per field: whether a single body moves with it
  std::vector<double> inverse_volume_;  // 1 / |cell_i|, m^-dim; axisymmetric per radian
  std::optional<Field> own_field_;      // one body's mass alone
  std::vector<double> space_;           // nodal volumes of the enclosure last asked for, m^dim; axisymmetric per radian
  std::vector<double> chain_force_, chain_shift_;
  MembraneTangents tangents_;
  BinSort bin_sort_;
  std::vector<int> spare_;
  Pending pending_;
  NodalVelocity current_ = NodalVelocity::start;
  std::unique_ptr<Contact<dim>> contact_;  // null: none
  bool places_known_ = false;              // the weights of where the points were last located are at hand
  bool moved_ = true, forces_mapped_ = false, sorting_ = true, loaded_ = false, contact_decided_ = false;
  double time_ = 0, load_ahead_ = 0;  // of the step's start; how far after it the loads are wanted, s
  double drifted_ = 0;                // how far after it points stand by drift_points() alone, s
  double grid_mass_ = 0, hoop_force_ = 0;
  Spin<dim> stress_turn_ = Spin<dim>::Zero();          // torque of the forces as mapped that should be none, N m
  NodalVelocity rate_of_ = NodalVelocity::current;     // velocity the strain_rate columns hold; current: none
  double pending_strain_dt_ = 0, pending_stored_ = 0;  // strained before the forces were known
  mutable std::optional<Survey> survey_;
};

}  // namespace plumbline
