// What the loops of a shape do for points anywhere. Nodes are those of the flat arrays, ghosts included.
#pragma once

#include <Eigen/Core>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cases/harness/parts/probe_random.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {

struct ProbePoint {
  std::array<double, 3> x{};  // m
  double half = 0;            // half size of its box where the shape has boxes, m
};

// Of a nodal vector field u, row by row the points.
struct Interpolated {
  Eigen::MatrixXd value;                  // sum_i N_ip u_i, a column for each component
  std::vector<Eigen::MatrixXd> gradient;  // sum_i dN_ip/dx_d u_i, 1/m, for each direction d
};

class ShapeProbe {
 public:
  virtual ~ShapeProbe() = default;

  virtual const GridSpec& grid() const = 0;
  virtual int support() const = 0;
  virtual double blur() const = 0;
  virtual int nodes() const = 0;
  virtual Eigen::RowVectorXd place(int node) const = 0;    // m
  virtual std::array<int, 3> index(int node) const = 0;    // along each direction, ghosts counted
  virtual bool inside(const ProbePoint& point) const = 0;  // whether it is taken to stand on the grid

  // All that follow throw std::logic_error where a point reaches beyond the ghost nodes, and InadmissibleState where it is
  // refused. u: row by row the nodes.
  virtual Interpolated interpolated(const std::vector<ProbePoint>& points, const Eigen::MatrixXd& u) const = 0;
  // What points put on the nodes of values q_p; of masses m_p; and of stresses sigma in volumes V_p, -sum_p V_p sigma grad N_ip,
  // N, row by row the nodes. hoop: the stress around the axis of rings.
  virtual Eigen::VectorXd spread(const std::vector<ProbePoint>& points, const Eigen::VectorXd& q) const = 0;
  virtual Eigen::VectorXd mapped_mass(const std::vector<ProbePoint>& points, const Eigen::VectorXd& m) const = 0;
  virtual Eigen::MatrixXd forces(const std::vector<ProbePoint>& points, const Eigen::VectorXd& volume,
                                 const Eigen::Matrix3d& sigma, double hoop) const = 0;
  // Index along each direction of the lowest node a point reaches, ghosts counted.
  virtual std::vector<std::array<int, 3>> lowest(const std::vector<ProbePoint>& points) const = 0;
  // D_p along d, m^2: row by row the points.
  virtual Eigen::MatrixXd inertia(const std::vector<ProbePoint>& points) const = 0;
  // Velocity and C_p, row by row, that points take from the nodal velocity a + B x.
  virtual Eigen::MatrixXd taken(const std::vector<ProbePoint>& points, const Eigen::Vector3d& a,
                                const Eigen::Matrix3d& b) const = 0;
  // V_p that points of masses m_p take from nodal densities, kg/m^dim, or from specific volumes.
  virtual Eigen::VectorXd read_off(const std::vector<ProbePoint>& points, const Eigen::VectorXd& m,
                                   const Eigen::VectorXd& nodal, bool specific) const = 0;
  // Kinetic energy, J, that the map to nodal velocities u takes from points of masses m_p and velocities v_p, row by row, which
  // all have the velocity gradient c.
  virtual Eigen::VectorXd lost(const std::vector<ProbePoint>& points, const Eigen::VectorXd& m,
                               const Eigen::MatrixXd& v, const Eigen::MatrixXd& c, const Eigen::MatrixXd& u) const = 0;
  // Of all nodes, m^dim; axisymmetric per radian, m^3. Zero where no space is.
  virtual std::vector<double> volumes() const = 0;
};

// The four geometries: "line", "plane", "rings", "space".
const std::vector<std::string>& geometry_names();

// A grid of a few cells that are no unit of length, off the origin but for the radius of rings; walls on all sides or on none.
GridSpec probe_grid(std::size_t geometry, bool walls);
std::unique_ptr<ShapeProbe> probe(const ShapeEntry& shape, std::size_t geometry, const GridSpec& grid);

// Random points of a grid, fixed by the seed; a third of their coordinates stand on sides, on node lines, half way between them
// or a rounding off. Those off the axis of rings stand at a tenth of a cell from it or more.
std::vector<ProbePoint> probe_points(const GridSpec& grid, int count, unsigned long seed, bool off_axis = false);

}  // namespace plumbline
