// Total Lagrangian weights: B-splines N_i of the places X_p where the points stood at the start,
//   N_ip = N_i(X_p)                                                                                   [Lagrangian 1]
//   grad N_ip = F_p^-T grad N_i(X_p)                                                                  [Lagrangian 2]
// with F_p of the step's start, of the places X: the deformation that the points carry, times the inverse of what they carried at the
// start. The velocity gradient of the points is then dF/dt F^-1 and the force of a Cauchy stress sigma in the
// volume J V_0 is -V_0 P grad N_i(X_p), P = J sigma F^-T. No point comes to another cell, none reaches a node that it did not reach
// at the start: what the mesh adds to large strains and long ways is gone. A body cannot touch itself or another.
// Nodes stand where they are, so that their angular momentum is another than the points': in a map to and fro these lose
//   sum_p m_p (x_p - X_p) x (v_p - v_p')                                                              [Lagrangian 3]
// beyond what other shapes take, and what the forces turn is sum_i x_i x f_i = -V_0 (P_ba - P_ab) of directions a, b. Waves cross
// the cells of the start: along a principal stretch s at 1 / s of their speed in space
//   c_0 = c / s, at most c max |F^-1|                                                                 [Lagrangian 4]
#include <Eigen/LU>
#include <string>

#include "kernel/engine/loops/list_entry.hpp"
#include "kernel/points/components.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "kernel/shapes/reference_columns.hpp"

namespace plumbline {
namespace {

template <class Spline, int dim>
class Lagrangian final : public ListedShape<dim> {
 public:
  explicit Lagrangian(const Grid<dim>& grid) : grid_(grid) {}

  ShapeTraits traits() const override {
    return {.support = Spline::support,
            .blur = Spline::blur,
            .fixed_inertia = Spline::fixed_inertia,
            .boxes = false,
            .at_start = true};
  }

  bool follows() const override { return true; }
  void follow(Columns& points) const override {
    if (!points.has(column::deformation_at_start)) return;  // of strains that are small
    points.add(column::inverse_deformation, dim * dim);
    const Components<Matrix, const double> now(points, column::deformation),
        at_start(points, column::deformation_at_start);
    Components<Matrix, double> inverse(points, column::inverse_deformation);
    for (int p = 0; p < points.points(); ++p) inverse.set(p, at_start[p] * now[p].inverse());
  }

  void list(const Columns& points, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const override {
    const bool deforms = points.has(column::inverse_deformation);
    const Components<Matrix, const double> inverse(points, column::inverse_deformation, deforms);
    for (int p = range.first; p < range.last; ++p) {
      Along along[dim];
      for (int d = 0; d < dim; ++d) along[d] = weights(grid_.logical(at.x[d][p], d), d);
      const Matrix turn = deforms ? Matrix(inverse[p].transpose() / grid_.h()) : Matrix(Matrix::Identity() / grid_.h());
      for (int k = 0; k < count; ++k) list_node(along, k, turn, nodes);
      nodes.end_point();
    }
  }

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;
  static constexpr int support = Spline::support;
  static constexpr int count = dim == 1 ? support : dim == 2 ? support * support : support * support * support;
  struct Along {
    int lowest;                             // in the flat arrays
    double value[support], slope[support];  // slope: per cell
  };

  Along weights(double x, int d) const {
    Along along;
    double local;
    const int anchor = Spline::anchor(x, grid_.cells(d), local);
    along.lowest = (anchor + Spline::first + Grid<dim>::ghosts) * grid_.stride(d);
    Spline::weights(local, along.value);
    Spline::gradients(local, along.slope);
    return along;
  }

  // turn: F^-T / h.
  void list_node(const Along (&along)[dim], int k, const Matrix& turn, NodeList<dim>& nodes) const {
    int node = 0;
    double value = 1;
    Vec slope = Vec::Ones();
    for (int d = 0; d < dim; ++d, k /= support) {
      const int own = k % support;
      node += along[d].lowest + own * grid_.stride(d);
      value *= along[d].value[own];
      for (int e = 0; e < dim; ++e) slope[e] *= d == e ? along[d].slope[own] : along[d].value[own];
    }
    nodes.add(node, value, turn * slope);  // [Lagrangian 1] [Lagrangian 2]
  }

  Grid<dim> grid_;
};

template <int dim>
using LagrangianQuadratic = Lagrangian<Quadratic, dim>;
template <int dim>
using LagrangianCubic = Lagrangian<Cubic, dim>;

template <template <int> class Shape, class Spline>
ShapeEntry lagrangian(const std::string& degree) {
  ShapeEntry entry = list_entry<Shape>("lagrangian-" + degree, degree + " B-splines of the points' places at the start",
                                       "de Vaucorbeil, Nguyen, Hutchinson 2020, doi 10.1016/j.cma.2019.112783",
                                       {Trait::smooth_gradients, Trait::constant_inertia});
  entry.inertia = Spline::inertia(0.0);
  entry.at_start = true;
  return entry;
}

const RegisterPart quadratic(lagrangian<LagrangianQuadratic, Quadratic>("quadratic"));
const RegisterPart cubic(lagrangian<LagrangianCubic, Cubic>("cubic"));

}  // namespace
}  // namespace plumbline
