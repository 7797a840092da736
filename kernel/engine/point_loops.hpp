// The loops between the points of one chunk and the nodes they reach. A step calls them once a chunk and does not know
// which shape or transfer they are compiled for.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "kernel/bins.hpp"
#include "kernel/engine/sums.hpp"
#include "kernel/engine/weights.hpp"
#include "kernel/pack.hpp"
#include "kernel/points/body.hpp"
#include "kernel/velocity_field.hpp"

namespace plumbline {

// Component d of a nodal array of vectors, `dim` numbers apart.
template <class Vec>
double* component(std::vector<Vec>& nodes, int d) {
  return nodes.front().data() + d;
}
template <class Vec>
const double* component(const std::vector<Vec>& nodes, int d) {
  return nodes.front().data() + d;
}

// What a step asks of the shape by value.
struct ShapeTraits {
  int support;            // nodes per direction that a point reaches
  double blur;            // theta of S(k) = 1 - theta k^2 h^2 + ... [Sharpening 1]
  bool fixed_inertia;     // D_p is the same wherever a point stands
  bool boxes;             // points have half sizes
  bool at_start = false;  // weights are those of the places where the points stood at the start
  int degree = 0;         // of the B-splines that the shape is; 0: it is none [Quadrature 4]
};

// What a gas puts on the nodes beside its forces.
//   heat            sum_p m_p e_p N_ip and sum_p m_p N_ip max(0, -div v) [Exchange 1]
//   heat_and_sound  these and sum_p m_p c_p N_ip [Filter 1]
enum class Shares { none, heat, heat_and_sound };

template <class Geometry>
class PointLoops {
 public:
  static constexpr int dim = Geometry::dim;
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Field = VelocityField<dim>;

  virtual ~PointLoops() = default;

  // --- the shape
  virtual ShapeTraits shape() const = 0;
  // 1 / |cell_i| for each node of the flat arrays, m^-dim; axisymmetric per radian, m^-3. Zero where no space is.
  virtual std::vector<double> inverse_volumes() const = 0;
  // |cell_i| inside the closed line of a chain's points and corners, m^2 (m^3 per radian). Two dimensions. [Coupling 4]
  virtual void find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                                     std::vector<double>& volume) const = 0;
  // Lowest nodes of the points; false: one of them stands outside of the grid.
  virtual bool find_lowest(const Columns& points, PointRange range, int* lowest) const = 0;
  // D_p along d where the point stands, m^2.
  virtual double inertia(const Columns& points, int d, int p) const = 0;
  // The same of a pack of points from p on, `count` of them; the other lanes hold anything.
  virtual Pack pack_inertia(const Columns& points, int d, int p, int count) const {
    return Pack([&](auto lane) {
      const int k = static_cast<int>(lane);
      return k < count ? inertia(points, d, p + k) : 0.0;
    });
  }
  // Whether weights depend on columns of the shape's own; follow() sets these from the points as they are, once a step, before
  // they are located.
  virtual bool follows() const { return false; }
  virtual void follow(Columns&) const {}

  // --- points to nodes
  // M_i and M_i v_i. [York 3.15, 3.16] [EC-APIC 1]
  virtual void map_mass_and_momentum(const Body& body, const Weights<dim>& at, const Chunk& chunk,
                                     Field& field) const = 0;
  // M_i v_i alone.
  virtual void map_momentum(const Body& body, const Weights<dim>& at, const Chunk& chunk, Field& field) const = 0;
  // -sum_p V_p sigma_p grad N_ip [York 3.17] [EC-APIC 4]; returns what hoop stress adds to the radial momentum, N.
  // Also what `shares` says. Where the field has nodal pressures, stresses that are pressures add to those, sum_p V_p p_p N_ip,
  // and not to the forces [Pressure 1].
  virtual double map_forces(const Body& body, const Weights<dim>& at, const Chunk& chunk, Shares shares,
                            Field& field) const = 0;
  // f_i -= sum_p V_p (sum_j N_jp P_j) grad N_ip and nodes_i += sum_p V_p N_ip div v_p, of shapes that are B-splines. [Quadrature 2, 3]
  virtual void take_pressure(const Columns&, const Weights<dim>&, const Chunk&, const std::vector<double>&,
                             Field&) const {
    throw std::logic_error("only of B-splines are the integrals of pressures known");
  }
  virtual void map_divergence(const Columns&, const Weights<dim>&, const Chunk&, const std::vector<Vec>&,
                              std::vector<double>&) const {
    throw std::logic_error("only of B-splines are the integrals of pressures known");
  }
  // nodes_i += sum_p N_ip q_p of values q, weighted with the points' masses or not; nodes are `stride` numbers apart.
  struct Spread {
    const double *values, *mass;  // mass null: not weighted
    double* nodes;
    int stride;
  };
  static constexpr int most_spread = 1 + dim;
  virtual void spread(const Columns& points, const Weights<dim>& at, const Chunk& chunk,
                      std::span<const Spread> all) const = 0;

  // --- nodes to points
  // values_p = sum_i N_ip nodes_i.
  struct Gather {
    const double* nodes;
    int stride;
    double* values;
  };
  virtual void gather(const Columns& points, const Weights<dim>& at, const Chunk& chunk,
                      std::span<const Gather> all) const = 0;
  // The nodal arrays that strain points; both: the sum of the two [Quadrature 3]; both null: none.
  struct Straining {
    const std::vector<Vec>* velocity = nullptr;       // by its gradients [York 3.23]
    const std::vector<double>* divergence = nullptr;  // their one rate is sum_i N_ip D_i [Pressure 3]
    explicit operator bool() const { return velocity || divergence; }
  };
  // Nodal arrays that gather_start reads; null: that part is not wanted.
  struct Wanted {
    const std::vector<Vec>* loss = nullptr;  // nodal velocity of the map
    Straining rates = {};
    const std::vector<double>* closing = nullptr;  // with it: how fast it closes; null: nobody asks
    const std::vector<double>* density = nullptr;
    bool specific = false;  // `density` holds specific volumes
    bool none() const { return !loss && !rates && !density; }
  };
  // What the points of a chunk take from the grid of the start of the step.
  //   loss     sum_p m_p A_p with A_p = sum_i N_ip |v_p + C_p (x_i - x_p) - v_i|^2 / 2, returned, as the sum of three terms
  //            that are never negative: what v_p and C_p differ by from the grid's, and what of the grid's velocity is
  //            not affine [EC-APIC 1]
  //   rates    strain rates, and the column closing, min(max(0, -div v), sum_i N_ip K_i)
  //   density  V_p = m_p / rho_p, rho_p = sum_i N_ip rho_i [EC-APIC 2]; specific: V_p = m_p sum_i N_ip v_i [Coupling 4]
  virtual double gather_start(Body& body, const Weights<dim>& at, const Chunk& chunk, const Wanted& wanted) const = 0;
  // How gather_motion moves points.
  struct Motion {
    double dt;
    std::optional<double> drift;  // how long they then move with the velocity they got; none: over dt with the grid's
    Straining straining = {};     // also the strain rates by this
    const std::vector<Vec>* carrying = nullptr;  // nodal velocity that carries them; null: the end's
    const std::vector<Vec>* beyond = nullptr;    // nodal velocity that carries them too, over dt [Sharpening 2]
    // How fast cells stretch, and the velocities of the faces above the nodes: what carries them instead [Pressure 4]
    const std::vector<Vec>*stretch = nullptr, *faces = nullptr;
    // Also e_p += sum_i N_ip alpha_i (E_i - e_p), which conserves sum_p m_p e_p node by node, and leaves no energy
    // negative: each becomes a mean of what points have. [Exchange 1]
    bool exchange = false;
  };
  virtual MotionSums gather_motion(Body& body, const Weights<dim>& at, const Chunk& chunk, const Field& field,
                                   const Motion& motion) const = 0;

  // --- points alone
  virtual Survey survey(const Body& body, PointRange range) const = 0;
  // What of a survey depends on the weights: kinetic energy and angular momentum.
  virtual Totals survey_motion(const Body& body, PointRange range) const { return survey(body, range).totals; }
};

}  // namespace plumbline
