// A shape outside the repository whose points reach nodes far apart: each is a parallelogram (on a line an edge, in space a
// parallelepiped) of half edges r_k = F r_k(0), and its weights are the means over the corners of quadratic splines:
//   N_ip = 2^-dim sum_c N_i(x_p + sum_k +-r_k)
// The corners are those of Sadeghirad, Brannon, Burghardt 2011, doi 10.1002/nme.3110; the gradient is the derivative of N_ip where
// theirs is a mean over the domain. No domain reaches further than a cell, or across a side of the grid: there it is squeezed along
// that axis, so that gradients jump.
#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/engine/loops/list_entry.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace {

using namespace plumbline;

const ColumnId half_edges{"half_edges", "m"};  // r_k, one after another

template <int dim>
class Corners final : public ListedShape<dim> {
 public:
  explicit Corners(const Grid<dim>& grid) : grid_(grid) {}

  // blur: half the variance of the spline and of the two ends of an edge of half a cell.
  ShapeTraits traits() const override {
    return {.support = 5, .blur = 1.0 / 8 + 1.0 / 32, .fixed_inertia = false, .boxes = true};
  }

  bool follows() const override { return true; }
  void follow(Columns& points) const override {
    points.add(half_edges, dim * dim);
    const bool deforms = points.has(column::deformation);
    for (int p = 0; p < points.points(); ++p) {
      for (int k = 0; k < dim * dim; ++k) {
        const int edge = k / dim, d = k % dim;
        const double f = deforms ? points(column::deformation, d * dim + edge)[p] : d == edge ? 1.0 : 0.0;
        points(half_edges, k)[p] = f * points(column::half_size, edge)[p];
      }
    }
  }

  void list(const Columns& points, const Places<dim>& at, PointRange range, NodeList<dim>& nodes) const override {
    for (int p = range.first; p < range.last; ++p) {
      Vec x, edges[dim];
      for (int d = 0; d < dim; ++d) x[d] = grid_.logical(at.x[d][p], d);
      for (int k = 0; k < dim * dim; ++k) {
        const int edge = k / dim, d = k % dim;
        const double straight = d == edge ? at.half_size[d][p] : 0.0;
        edges[edge][d] = (points.has(half_edges) ? points(half_edges, k)[p] : straight) / grid_.h();
      }
      list_corners(x, edges, nodes);
      nodes.end_point();
    }
  }

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;
  static constexpr double furthest = 1;  // cells

  void list_corners(const Vec& x, const Vec (&edges)[dim], NodeList<dim>& nodes) const {
    Vec scale, change;  // of the domain along each axis, and how it depends on x
    for (int d = 0; d < dim; ++d) {
      double extent = 0;
      for (const Vec& edge : edges) extent += std::abs(edge[d]);
      const double low = x[d], high = grid_.cells(d) - x[d], distance = std::min({low, high, furthest});
      const bool squeezed = extent > distance;
      scale[d] = squeezed ? distance / extent : 1;
      change[d] = !squeezed || distance == furthest ? 0 : (low < high ? 1 : -1) / extent;
    }
    for (int c = 0; c < 1 << dim; ++c) {
      Vec off = Vec::Zero();
      for (int k = 0; k < dim; ++k) off += (c >> k & 1 ? 1 : -1) * edges[k];
      list_corner(x + scale.cwiseProduct(off), Vec::Ones() + change.cwiseProduct(off), nodes);
    }
  }

  // moves: how fast the corner moves along each axis as the point does.
  void list_corner(const Vec& corner, const Vec& moves, NodeList<dim>& nodes) const {
    constexpr double share = 1.0 / (1 << dim);
    int anchor[dim];
    double w[dim][3], slope[dim][3];
    for (int d = 0; d < dim; ++d) {
      double local;
      anchor[d] = Quadratic::anchor(std::clamp(corner[d], 0.0, 1.0 * grid_.cells(d)), grid_.cells(d), local);
      Quadratic::weights(local, w[d]);
      Quadratic::gradients(local, slope[d]);
    }
    for (int k = 0; k < (dim == 1 ? 3 : dim == 2 ? 9 : 27); ++k) {
      const int offset[3] = {k % 3, k / 3 % 3, k / 9};
      int node = 0;
      double value = share;
      Vec gradient = share / grid_.h() * moves;
      for (int d = 0; d < dim; ++d) {
        node += (anchor[d] + offset[d] - 1 + Grid<dim>::ghosts) * grid_.stride(d);
        value *= w[d][offset[d]];
        for (int e = 0; e < dim; ++e) gradient[e] *= d == e ? slope[d][offset[d]] : w[d][offset[d]];
      }
      nodes.add(node, value, gradient);
    }
  }

  Grid<dim> grid_;
};

ShapeEntry with_boxes() {
  ShapeEntry entry = list_entry<Corners>("corners", "quadratic splines averaged over the corners of deforming domains",
                                         "after Sadeghirad et al. 2011, doi 10.1002/nme.3110");
  entry.boxes = true;
  return entry;
}

const RegisterPart entry(with_boxes());

}  // namespace
