// The loops over points whose shape lists the nodes that they reach: for each point and node in turn, from the definitions that
// shape_loops.hpp evaluates for packs of points and products of shapes.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <vector>

#include "kernel/engine/point_loops.hpp"
#include "kernel/shapes/listed_shape.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {

template <class Geometry>
class ListLoops : public PointLoops<Geometry> {
 public:
  using Base = PointLoops<Geometry>;
  static constexpr int dim = Geometry::dim;
  using typename Base::Field, typename Base::Vec;
  using typename Base::Gather, typename Base::Motion, typename Base::Spread, typename Base::Straining,
      typename Base::Wanted;
  using At = Weights<dim>;

  ListLoops(const GridSpec& grid, const Transfer& transfer, MakeListed<dim> make);

  ShapeTraits shape() const override { return traits_; }
  std::vector<double> inverse_volumes() const override;
  void find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                             std::vector<double>& volume) const override;
  // Throws std::logic_error for a point that reaches further than the shape's support, or off the grid.
  bool find_lowest(const Columns& points, PointRange range, int* lowest) const override;
  double inertia(const Columns& points, int d, int p) const override;
  bool follows() const override { return shape_->follows(); }
  void follow(Columns& points) const override { shape_->follow(points); }

  void map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override;
  void map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const override;
  double map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const override;
  void spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const override;

  void gather(const Columns& points, const At& at, const Chunk& chunk, std::span<const Gather> all) const override;
  double gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const override;
  MotionSums gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                           const Motion& motion) const override;
  Survey survey(const Body& body, PointRange range) const override;

 protected:
  using Matrix = Eigen::Matrix<double, dim, dim>;
  static constexpr int rotations = Geometry::rotations;
  static constexpr std::size_t about = dim == 2 ? 2 : 0;  // the first rotation's place in a Turn

  const Grid<dim>& grid() const { return grid_; }
  const Transfer& transfer() const { return transfer_; }
  bool on_grid(const Columns& points, int p) const;
  // What has stress in all directions and no heat.
  static bool is_solid(const Body& body) {
    const StressMeasure measure = body.material->measure();
    return (measure == StressMeasure::full || measure == StressMeasure::symmetric) && !body.material->takes_heat();
  }
  // What C is multiplied by for tr(C D C^T) to be the same with D of another place, by both as they are. [CPDI 5]
  template <class Number>
  static Number kept_share(const Number& before, const Number& after) {
    using std::sqrt;
    return choose(before > 0.0 && after > 0.0, sqrt(before / after), Number(1.0));
  }

 private:
  using Entries = std::span<const typename NodeList<dim>::Entry>;

  // Some points, where they stand, and what they reach.
  struct Reach {
    PointRange range;
    std::array<std::vector<double>, dim> x;  // of the range, on the grid
    SpareList<dim> nodes;
    Entries of(int p) const { return (*nodes).of(p - range.first); }
    Vec place(int p) const {
      Vec at;
      for (int d = 0; d < dim; ++d) at[d] = x[static_cast<std::size_t>(d)][static_cast<std::size_t>(p - range.first)];
      return at;
    }
  };
  // What a nodal field of vectors is at a point: sum N f, sum f grad N^T, sum N f (x_i - x_p)^T.
  struct Jet {
    Vec value = Vec::Zero();
    Matrix gradient = Matrix::Zero(), moment = Matrix::Zero();
  };

  Reach reach(const Columns& points, const Places<dim>& places, PointRange range) const;
  Reach reach(const Columns& points, PointRange range) const;  // from where they stand now
  Vec arm(const Reach& at, int p, int node) const { return grid_.position(node) - at.place(p); }
  // sum N f of f(node).
  template <class Value>
  static double mean(Entries entries, Value&& f);
  // The node with the largest share. What maps lose is a difference of squares, taken relative to its velocity: one at the edge of
  // what a point reaches could be all but massless and fast.
  static std::size_t heaviest(Entries entries);
  // The jet of f(node) - base.
  template <class Value>
  Jet jet(const Reach& at, int p, const Vec& base, Value&& f) const;
  Matrix inertia_of(const Reach& at, int p) const;  // D_p = sum N (x_i - x_p) (x_i - x_p)^T, m^2
  int lowest_node(Entries entries) const;

  void map_motion(const Body& body, const At& at, const Chunk& chunk, bool with_mass, Field& field) const;
  void store_strain_rates(Body& body, const Reach& at, int p, const Straining& by) const;
  struct Taken;
  void filter(const Body& body, const Reach& at, int p, const Field& field, const Vec& base, Taken& taken) const;
  Taken take(const Body& body, const Reach& at, int p, const Field& field) const;
  void settle_affine(Body& body, const Reach& here, const Reach& there, int p, Taken& taken, MotionSums& sums) const;
  static void exchange_heat(Body& body, const Reach& at, int p, const Field& field);
  // Torque m (S - S^T) of S = sum N f (x_i - x_p)^T.
  static void add_turn(double m, const Matrix& s, Turn& turn);

  Grid<dim> grid_;
  GridSpec spec_;
  Transfer transfer_;
  MakeListed<dim> make_;
  std::unique_ptr<const ListedShape<dim>> shape_;
  ShapeTraits traits_;
};

extern template class ListLoops<Line>;
extern template class ListLoops<Plane>;
extern template class ListLoops<Axisymmetric>;
extern template class ListLoops<Solid>;

}  // namespace plumbline
