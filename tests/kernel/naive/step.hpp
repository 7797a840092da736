// The step written straight from the printed equations, as slowly as can be: every node meets every point,
// weights come from the distance between them, and nothing is shared with the kernel but the scene it starts
// from. Free sides only. All vectors and tensors have three components: x, y, z, or r, z and the hoop direction of an
// axisymmetric scene, whose points may stand at negative radii as the mirror images of others.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {

struct NaivePoint {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero();
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero(), stress = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d eps = Eigen::Matrix3d::Zero(), f = Eigen::Matrix3d::Identity();  // of solids
  Eigen::Vector3d half = 0.5 * Eigen::Vector3d::Ones(), half_at_start = half;      // of the box, in cells
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();  // half edges of the domain, a column each, in cells
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();       // of the segments on the point
  double m = 0, volume = 0, density = 0, energy = 0, pressure = 0, strain = 0, loss = 0, exchanged = 0, rest = 0;
  double sound = 0, closing = 0;  // of the stress: c, and how fast the flow is compressed
  double theta = 0;               // the dilatation that cells share
};

struct NaiveNode {
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), momentum = x, force = x;
  Eigen::Vector3d start = x, end = x, middle = x, again = x;
  double m = 0, volume = 0, heat = 0, alpha = 0, kept = 0;
};

class NaiveStep {
 public:
  using Vec = Eigen::Vector3d;
  using Mat = Eigen::Matrix3d;
  enum class Of { start, end, middle, again };

  std::vector<NaivePoint> points;
  double transfer = 0, integration = 0, constitutive = 0, body_work = 0;  // the ledger's flows of energy

  explicit NaiveStep(const Scene& scene);

  void step(const std::string& integrator, double dt);

  // Densities and pressures where the points stand now.
  void refresh();

 private:
  friend class NaiveStages;
  struct Pair {
    std::size_t point, node;
    double n;
    Vec g;
  };

  // --- step.cpp
  bool rings() const { return scene_.grid.axisymmetric; }
  // Components of a column as the tensors they are: the plane's, the hoop's, those of space; shears are halved.
  Mat strain_tensor(const Columns& from, std::size_t p) const;
  Mat deformation(const Columns& from, std::size_t p) const;
  void to_grid();
  void forces();
  void advance(double dt);
  // 1 - alpha_i of the velocities' filter. [Filter 1]
  void keep_shares(double dt);
  void drift(double dt) {
    for (NaivePoint& point : points) point.x += dt * point.v;  // [Leapfrog 1]
  }
  // What the nodes have of u after it went to the points and back.
  std::vector<Vec> passed(const std::vector<Vec>& u);
  // The nodal velocities that points take with xpic and fmpm. [XPIC 1] [FMPM 1]
  std::vector<Vec> filtered();
  // alpha of [Blend 1].
  double share_kept() const { return scene_.transfer == "flip" ? 1 : scene_.transfer == "blend" ? 0.95 : 0; }
  void move(double dt, bool along, bool with_middle);
  void again();

  // --- maps.cpp
  void make_nodes();
  // Integral of N |r|, by Boole's rule on half cells: exact for these pieces of degree four. The axis, if there is one,
  // is a node line.
  double radial_volume(double centre) const;
  bool boxes() const { return boxes_; }
  bool domains() const { return domains_; }
  // half: of the boxes, in cells.
  double spline(double u, double half) const;
  double slope(double u, double half) const;
  bool apart(const Vec& x, const NaiveNode& node) const {
    for (int d = 0; d < 3; ++d) {
      if (std::abs(x[d] - node.x[d]) >= 2.001 * h_) return true;
    }
    return false;
  }
  // visit(share of N_i, factor of grad N_i) for each corner of a domain: tents there, and (s_c . r^k)_k. [CPDI 2, 3]
  template <class Visit>
  void for_corners(const NaivePoint& p, const NaiveNode& node, Visit&& visit) const;
  double weight(const NaivePoint& p, const NaiveNode& node) const;
  Vec gradient(const NaivePoint& p, const NaiveNode& node) const;
  // D = sum N r r^T where the point stands.
  Mat inertia(const NaivePoint& p) const;
  // Boxes that follow the deformation have the second moments of what the box at the start became; what their inertia
  // gains of the points' affine energy is booked. [GIMP 2] So it is of domains. [CPDI 1]
  void deform_boxes();
  template <class Visit>
  void for_pairs(Visit&& visit) {
    for (const Pair& k : pairs_) visit(points[k.point], nodes_[k.node], k.n, k.g);
  }
  template <class Visit>
  void for_nodes_of(std::size_t p, Visit&& visit) const {
    for (std::size_t k = first_pair_[p]; k < first_pair_[p + 1]; ++k) {
      visit(nodes_[pairs_[k].node], pairs_[k].n, pairs_[k].g);
    }
  }
  void locate();
  const Vec& frozen(const NaivePoint& point) const { return at_[static_cast<std::size_t>(&point - points.data())]; }
  // The node so many steps from another along d, if there is one.
  std::optional<std::size_t> beside(std::size_t i, int d, int side) const;

  // --- gas.cpp
  bool at_nodes() const { return gas_ && scene_.nodal_pressure && !rings() && gas_->viscosity == 0; }
  double mass_of(std::optional<std::size_t> i) const { return i ? nodes_[*i].m : 0.0; }
  // visit(j, b_fj) of the face above node i along d. [Pressure 2]
  template <class Visit>
  void for_face(std::size_t i, int d, Visit&& visit) const;
  // u_f above node i along d. [Pressure 2]
  double face_velocity(std::size_t i, int d, const std::vector<Vec>& u) const;
  // D_p. [Pressure 2]
  double divergence(std::size_t p, Of which) const;
  // [Pressure 1, 3]
  void press_nodes();
  bool corrects() const {
    return gas_ && scene_.quadrature > 0 && dim_ > 1 && !rings() && gas_->viscosity == 0 && !at_nodes() &&
           scene_.density == DensityMethod::grid && (linear_ || quadratic_ || scene_.shape == "cubic");
  }
  // int N N(. - k) and int N N'(. - k) over cells for k = -3 to 3, by Gauss's rule of four places on half cells: exact for these
  // pieces. [Quadrature 4]
  struct Overlaps {
    std::array<double, 7> values, slopes;
    // int N dN'/dx_d, N' the shape of a node these steps away, in cells.
    double gradient(const std::array<int, 3>& steps, int d, int dim) const;
  };
  Overlaps overlaps() const;
  // visit(j, steps from i to j along each axis) of the nodes that reach what i reaches; false: one of them does not exist.
  template <class Visit>
  bool for_overlapping(std::size_t i, Visit&& visit) const;
  // [Quadrature 1, 2]
  void correct_forces();
  // What D_p has beside div v_p. [Quadrature 3]
  double correction(std::size_t p, Of which) const;
  // B: the mean of the shape over a cell, by Simpson's rule on quarters of a cell, exact for these cubic pieces. [Pressure 4]
  double wider_spline(double u) const;
  // w where a point stood. [Pressure 4]
  Vec flow_at(std::size_t p, Of which) const;
  // Half the variance of the shape.
  double theta() const;
  // The neighbour of a node that has mass.
  std::optional<std::size_t> massive(std::size_t i, int d, int side) const;
  // Of two sides their mean, or that by the share of their densities in those of the pair. [Limiter 1] [Limiter 2]
  double slope_at(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const;
  // psi of a nodal velocity. [Limiter 1]
  double linear_share(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const;
  // How much steeper the slopes beside a node are than its own, which opens. [Limiter 2]
  double slopes_beside(const std::vector<Vec>& u, std::size_t i, int d) const;
  // t of what is sharpened, by the velocity that was mapped. [Limiter 2]
  std::vector<Vec> kept_of_sharpening() const;
  // Each node against its neighbours, one axis after another, up to the third power. [Sharpening 1]
  std::vector<Vec> sharpened(const std::vector<Vec>& u) const;
  // Nodal densities with what two maps smoothed of them undone. [Read-off 1]
  void sharpen_densities(std::vector<double>& rho) const;
  // Of what points hold, the nodes' amount per volume where the points stand; and what nodes have, there. [EC-APIC 2] [Read-off 2]
  std::vector<double> per_volume(const std::vector<double>& amounts) const;
  std::vector<double> at_points(const std::vector<double>& nodal) const;
  // chi of node i. [Quadrature 1]
  double even_share(const std::vector<double>& mapped, std::size_t i, double evenness) const;
  // All of kappa at an extremum of the nodal energies, a quarter where these are monotone. [Exchange 1]
  double exchange_share(std::size_t i) const;
  // What a point will get through the nodes. [Exchange 1]
  void exchange(Of which, double dt);
  void densities();
  // What of the compression is not linear in the flow along an axis. [Limiter 1]
  double limited(std::size_t p, Of which) const;
  // Where the viscous stress takes heat out over the midpoint velocity, it is taken from that velocity.
  // [EC-APIC viscous heat]
  bool viscosity_would_cool();

  // --- stress.cpp
  // The nodal velocities that strain.
  const std::vector<Vec>& straining_velocity(Of which) const;
  Mat gradient_of_velocity(std::size_t p, Of which) const;
  Mat strain_rate(std::size_t p, Of which) const;
  Vec velocity_at(std::size_t p, Of which) const;
  // What the stress of a point takes from the grid, W.
  double power_of(std::size_t p, Of which) const;
  // Of the segment that starts at p; the last point of an open chain starts none. [Segments 1]
  bool starts_segment(std::size_t p) const { return segments_->closed || p + 1 < points.size(); }
  double stretch(std::size_t p) const;
  // Energy of a point's strain, J. [Hooke 1] [Neo-Hookean 1] [Segments 1] [York 5.5]
  double stored_energy(std::size_t p) const;
  LameConstants constants() const;
  double own_dilatation(const Mat& f, const Mat& eps) const;
  // What of lambda cells share, beyond 2 mu. [Dilatation 3]
  double lambda_shared() const;
  double lambda_own() const { return constants().lambda - lambda_shared(); }
  bool same_cell(std::size_t p, std::size_t q) const;
  // Over the points of p's cell, by their masses.
  template <class Value>
  double mean_about(std::size_t p, Value&& value) const;
  double mean_rate(std::size_t p, Of which) const;
  // What lambda adds to the normal stresses, over J of finite strains. [Dilatation 2]
  double tension(std::size_t p, double own, double ahead, Of which) const;
  // The pull of the segments on their points as places will be. [Segments 2]
  void set_pulls(Of which, double ahead);
  // Strains and internal variables; what is stored beyond the stress power goes to the flows.
  void strain(double dt, Of which);
  // Strain before the forces: the stress power that counts is that of the stress that the forces will use.
  void strain_first(double dt);
  void book_work(double dt);
  void set_stress(Of which, double ahead = 0);
  bool wrinkled(double strain) const { return membrane_->one_way && strain <= 0; }
  // Means of the angles of the adjoining segments. [York 7.1]
  Vec tangent(std::size_t p) const;
  // `ahead` seconds later, should the strain rates go on: an isentropic gas to first order, e' = -(gamma - 1) e div v, from the
  // side that stays positive; a membrane strained further. [Leapfrog 2]
  Mat stress_of(std::size_t p, const Mat& l, double ahead = 0, Of which = Of::start);

  const Scene scene_;
  // Of the shape's name, which all pairs of points and nodes would compare: most of what the tests took.
  const bool linear_ = scene_.shape == "linear", quadratic_ = scene_.shape == "quadratic";
  const bool boxes_ = scene_.shape == "gimp" || scene_.shape == "contiguous-gimp", domains_ = scene_.shape == "cpdi";
  int dim_;
  double h_;
  const IdealGas* gas_;
  const UniaxialMembrane* membrane_;
  const LinearElastic* hooke_;
  const NeoHookean* neo_;
  const SegmentMembrane* segments_;
  std::vector<NaiveNode> nodes_;
  Vec gravity_ = Vec::Zero();
  std::vector<Pair> pairs_;  // points and the nodes they reach, point by point
  std::vector<std::size_t> first_pair_;
  std::vector<Vec> at_, tangent_of_;
  mutable std::array<std::vector<Vec>, 4> straining_;  // nodal velocities whose gradients strain, by Of
  std::vector<double> even_share_;  // P_i / p_i of the forces of this step; empty: not known [Quadrature 1]
  mutable std::array<std::vector<double>, 4> corrections_;  // on the nodes [Quadrature 3]
  mutable std::array<std::vector<Vec>, 4> faces_;           // of these, u_f above the nodes [Pressure 2]
  bool forces_known_ = false, drifted_ = false;
  double stored_first_ = 0;
};

}  // namespace plumbline
