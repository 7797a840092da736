// A shape outside the repository: moving least squares on the nodes, exact for linear functions. With r_i = (x_i - x_p) / h,
// P_i = (1, r_i) and a weight w that is a product of (1 - (2 r / 3)^2)^2 along the axes, on the three nearest node lines of each:
//   N_ip = w_i P_i . b,  M b = (1, 0),  M = sum_i w_i P_i P_i^T
// The gradient is the derivative of N_ip, that of M included.
#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "kernel/engine/loops/list_entry.hpp"

namespace {

using namespace plumbline;

template <int dim>
class MovingLeastSquares final : public ListedShape<dim> {
 public:
  explicit MovingLeastSquares(const Grid<dim>& grid) : grid_(grid) {}

  // blur: half the mean over a cell of sum_i N_ip r_i^2 on a line.
  ShapeTraits traits() const override { return {.support = 3, .blur = 0.1599, .fixed_inertia = false, .boxes = false}; }

  void list(const Columns&, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const override {
    for (int p = range.first; p < range.last; ++p) {
      std::array<double, dim> x;
      for (int d = 0; d < dim; ++d) x[static_cast<std::size_t>(d)] = grid_.logical(at.x[d][p], d);
      list_one(x, nodes);
      nodes.end_point();
    }
  }

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Basis = Eigen::Matrix<double, dim + 1, 1>;
  using Square = Eigen::Matrix<double, dim + 1, dim + 1>;
  static constexpr int count = dim == 1 ? 3 : dim == 2 ? 9 : 27;
  struct Node {
    int node = 0;
    double w = 1;
    Vec slope = Vec::Ones();  // dw / dx_p, times h
    Basis basis = Basis::Ones();
  };

  void list_one(const std::array<double, dim>& x, NodeList<dim>& nodes) const {
    std::array<Node, count> around;
    Square m = Square::Zero();
    std::array<Square, dim> change;  // dM / dx_p, times h
    change.fill(Square::Zero());
    for (int k = 0; k < count; ++k) {
      Node& node = around[static_cast<std::size_t>(k)] = node_at(x, k);
      m += node.w * node.basis * node.basis.transpose();
      for (int d = 0; d < dim; ++d) {
        Square& along = change[static_cast<std::size_t>(d)];
        along += node.slope[d] * node.basis * node.basis.transpose();
        along.row(d + 1) -= node.w * node.basis.transpose();  // dr_i / dx_p = -1 / h
        along.col(d + 1) -= node.w * node.basis;
      }
    }
    const Eigen::LDLT<Square> solver(m);
    const Basis b = solver.solve(Basis::Unit(0));
    for (const Node& node : around) {
      const double fit = node.basis.dot(b);
      Vec gradient;
      for (int d = 0; d < dim; ++d) {
        const Basis b_change = -solver.solve(change[static_cast<std::size_t>(d)] * b);
        gradient[d] = node.slope[d] * fit + node.w * (node.basis.dot(b_change) - b[d + 1]);
      }
      nodes.add(node.node, node.w * fit, gradient / grid_.h());
    }
  }

  // The k-th node around x.
  Node node_at(const std::array<double, dim>& x, int k) const {
    Node node;
    for (int d = 0; d < dim; ++d, k /= 3) {
      const double line = std::floor(x[static_cast<std::size_t>(d)] + 0.5) + k % 3 - 1,
                   r = line - x[static_cast<std::size_t>(d)];
      const double inside = 1 - r * r / 2.25, slope = 4 * inside * r / 2.25;
      node.node += (static_cast<int>(line) + Grid<dim>::ghosts) * grid_.stride(d);
      node.w *= inside * inside;
      for (int e = 0; e < dim; ++e) node.slope[e] *= d == e ? slope : inside * inside;
      node.basis[d + 1] = r;
    }
    return node;
  }

  Grid<dim> grid_;
};

const RegisterPart entry(list_entry<MovingLeastSquares>(
    "moving-least-squares", "linear fit to the three nearest node lines of each axis",
    "Lancaster, Salkauskas 1981, doi 10.1090/S0025-5718-1981-0616367-1", {Trait::smooth_gradients}));

}  // namespace
