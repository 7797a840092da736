// The stages as loops over chunks of bins. Each stage is a short list of loops over one chunk, so that what a chunk
// computes is still in the cache when the next loop wants it. Included only by files that instantiate it for a geometry.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/bins.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/normals/membrane_tangents.hpp"
#include "kernel/pack.hpp"
#include "kernel/parallel.hpp"
#include "kernel/pistons.hpp"
#include "kernel/rotations.hpp"
#include "kernel/sharpening.hpp"
#include "kernel/stencil.hpp"
#include "kernel/summation.hpp"
#include "kernel/transfers/transfers.hpp"
#include "kernel/velocity_field.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

template <class Geometry, class Shape, class Transfer>
class Mechanics final : public Engine {
 public:
  static constexpr int dim = Geometry::dim;
  using Vec = Eigen::Matrix<double, dim, 1>;
  // So far beyond a side, in cells, a point still stands on it: on a wall it drifts by the rounding of a sum that is zero.
  static constexpr double on_side = 1e-9;

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
  static constexpr int support = Shape::support;
  static constexpr int nodes = Stencil<dim, Shape, double>::nodes;
  static constexpr int block_height = dim == 1 ? 64 : 4;  // layers; a stencil reaches 3 beyond its own
  static constexpr int place_stretch = 4096;
  static constexpr long fewest_shared = 2048;  // points below which waking a thread costs more than it does
  static constexpr int rotations = Geometry::rotations;
  static constexpr int most_components = dim * dim + 1;  // of stress, whatever the material
  using Field = VelocityField<dim>;
  using PackStencil = Stencil<dim, Shape, Pack>;
  using Print = Footprint<dim>;
  using Turn = std::array<double, 3>;  // about x, y, z

  // Nodal arrays that gather_start reads; null: that part is not wanted.
  struct Wanted {
    const std::vector<Vec>* loss = nullptr;   // nodal velocity of the map
    const std::vector<Vec>* rates = nullptr;  // nodal velocity that strains
    const std::vector<double>* density = nullptr;
    bool specific = false;  // `density` holds specific volumes
    bool none() const { return !loss && !rates && !density; }
  };
  struct RateColumns {
    double* at[most_components];
    StressMeasure measure;
  };
  // What the engine knows of a body beside its columns.
  struct Located {
    std::size_t field = 0;
    std::vector<int> lowest;                      // flat index of the lowest node reached, per point
    std::array<std::vector<double>, dim> frozen;  // where the points stood when they were located, once they have moved
    Bins bins;
    bool bins_hold = false;  // the points are in the order of the bins, each sorted by id
  };
  struct MotionSums {
    double lost = 0;
    Turn torque{}, moved{};
    Turn reflected{}, reflected_turn{};  // momenta given by walls that sent points back
    int too_far = -1;                    // first point that moved more than a cell
    MotionSums& operator+=(const MotionSums& o);
    friend MotionSums operator+(MotionSums a, const MotionSums& b) { return a += b; }
  };
  // Everything that is read off the points after a step, for the ledger, the next step's limit and the checks.
  struct Survey {
    Totals totals;
    StepBounds bounds;
    bool admissible = true;
    Survey& operator+=(const Survey& o);
    friend Survey operator+(Survey a, const Survey& b) { return a += b; }
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
  struct StartSums {
    double lost = 0, hoop_force = 0;
    StartSums& operator+=(const StartSums& o) {
      lost += o.lost;
      hoop_force += o.hoop_force;
      return *this;
    }
    friend StartSums operator+(StartSums a, const StartSums& b) { return a += b; }
  };
  struct PowerSums {
    double power = 0, viscous = 0;
    PowerSums& operator+=(const PowerSums& o) {
      power += o.power;
      viscous += o.viscous;
      return *this;
    }
    friend PowerSums operator+(PowerSums a, const PowerSums& b) { return a += b; }
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

  // --- loops over the chunks of one body
  // work(chunk) for each, in any order.
  template <class Work>
  void for_chunks(const Located& at, Work&& work) const;
  // work(chunk) for each; chunks that could write the same node are never under way together, and always in the same
  // order.
  template <class Work>
  void for_chunks_writing_nodes(const Located& at, Work&& work) const;
  // The sum of work(chunk) over all chunks, which does not depend on threads.
  template <class T, class Work>
  T sum_over_chunks(const Located& at, Work&& work) const;
  // The same for work that writes nodes.
  template <class T, class Work>
  T sum_over_chunks_writing_nodes(const Located& at, Work&& work) const;
  // visit(footprint, anchor, first point, last point) for each bin of a chunk; anchor: node index per direction, ghosts
  // not counted.
  template <class Visit>
  void for_bins(const Bins& bins, const Chunk& chunk, Visit&& visit) const;
  // Where the frozen weights come from: the positions, or what they were before the points moved.
  struct Places {
    const double *x[dim], *half_size[dim];
  };
  Places places(const Body& body, const Located& at) const;
  PackStencil stencil(const Places& places, const double (&anchor)[dim], int p) const;
  Pack box(const Places& places, int d, int p) const;
  template <class Number>
  static Number inertia_at(const Number& x, const Number& half);
  // Sums the lanes of a bin's node sums into `to[node]` (component k of each node's value).
  template <int components, class Add>
  void add_to_nodes(const Print& print, const Pack (&sums)[nodes * components], Add&& add) const;
  // The nodal velocities of a bin relative to its first node, and that node's.
  struct BinVelocity {
    double u[nodes][dim], square[nodes];
    Vec base;
  };
  BinVelocity bin_velocity(const Print& print, const std::vector<Vec>& velocity) const;
  RateColumns rate_columns(Body& body) const;
  template <class Component>
  void store_strain_rates(const RateColumns& rates, const PackStencil& weights, const Pack& radius, int p, int count,
                          Component&& u) const;
  template <class Visit>
  static void for_stencil_nodes(const Print& print, Visit&& visit);

  // --- one chunk of one body
  template <bool with_mass, bool with_momentum>
  void scatter_mass_and_momentum(const Body& body, const Located& at, const Chunk& chunk, Field& field) const;
  double gather_start(Body& body, const Located& at, const Chunk& chunk, const Wanted& wanted) const;
  template <StressMeasure measure, bool exchange>
  double scatter_forces(const Body& body, const Located& at, const Chunk& chunk, Field& field) const;
  double scatter_forces(const Body& body, const Located& at, const Chunk& chunk, Field& field) const;
  double stress_power(const Body& body, PointRange range, double dt) const;
  // drift: how long the points then move with the velocity they got; none: over dt with the grid's.
  MotionSums gather_motion(Body& body, const Located& at, const Chunk& chunk, const Field& field, double dt,
                           std::optional<double> drift, const std::vector<Vec>* straining, bool exchange,
                           const std::vector<Vec>* carrying) const;
  static std::pair<double, double> extent(const double* x, PointRange range);
  void reflect(Body& body, PointRange range, MotionSums& sums) const;
  void reflect_point(Body& body, int p, int d, double wall, MotionSums& sums) const;
  Survey survey(const Body& body, PointRange range) const;

  // --- one body or all
  static void refuse_other_geometry(const Body& body);
  void refuse_relaxation() const;
  void add_boxes(Body& body) const;
  void deform_boxes(Body& body);
  double inertia_of(const Columns& points, int d, int p) const;
  void place(Body& body, Located& at) const;
  static bool in_order(const Body& body, const Located& at);
  bool sort_points(Body& body, Located& at);
  void touch(const Located& at, Field& field) const;
  void touch_alone(const Located& at, Field& field) const;
  void keep_places(Body& body, Located& at) const;
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
  void map_own_mass(Body& body, Located& at, Field& field);
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
