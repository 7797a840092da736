// Membranes of coupled cases: one layer of points along a curve, and what it encloses.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cases/harness/description/settings.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

using Curve = std::vector<std::array<double, 2>>;  // vertices, m, in order

struct MembraneMaterial {
  double youngs_modulus = 0;  // E, Pa, > 0
  double poissons_ratio = 0;  // nu, [0, 1/2)
  double density = 0;         // rho, kg/m^3, > 0, unstretched
  double thickness = 0;       // t, m, > 0, unstretched
  bool one_way = true;        // no stress under compression
  double plane_modulus() const { return youngs_modulus / (1 - poissons_ratio * poissons_ratio); }  // E', Pa
};

double length(const Curve& curve);  // m
// The curve's n + 1 vertices at even distances along it; first and last stay.
Curve evenly(const Curve& curve, int segments);

// The vertices in an order that says nothing of who follows whom, always the same one.
Curve out_of_order(const Curve& curve);
// Vertices in no order, put in order along the curve that they stand on, counter-clockwise round what it bounds with the corners
// behind its last. Throws std::invalid_argument as order_along_curve().
Curve in_order(const Curve& vertices, const Curve& corners);

// The body, held out of the plane, as the key `membrane.strain` says.
//   segments     points at the vertices (the two ends carry half a segment), rest lengths L_s = chord / (1 + strain)
//   accumulated  points at the middles of the chords, York's layout: none on a wall; they start with `strain`
// Volumes and masses are those of the unstretched membrane, t L_s and rho t L_s. [York 5.12-5.15]
// closed: the last vertex is joined to the first by one more segment.
Body membrane_body(const Settings& settings, const std::string& name, const MembraneMaterial& material,
                   const Curve& curve, double strain = 0, bool closed = false);

// The same as a surface of revolution about the axis x = 0, per radian, for axisymmetric grids; segments alone.
Body revolved_body(const std::string& name, const MembraneMaterial& material, const Curve& curve);

// Gas at rest inside a polygon, counter-clockwise or not: points on a lattice of h / sqrt(ppc), shifted by half of that
// from the grid's origin, each with the same mass (axisymmetric: in proportion to its radius); mass and energy are exact.
Body fill_polygon(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
                  const Curve& polygon, double density, double energy);

// Area inside a polygon (axisymmetric: volume per radian); positive counter-clockwise. m^2 (m^3)
double enclosed(const Curve& polygon, bool axisymmetric = false);
bool inside(const Curve& polygon, double x, double y);

// Where the points of a membrane stand, in order, and on through the corners: the polygon that it bounds.
Curve outline(const Body& membrane, const Curve& corners);

// What a bag of gas looks like at one instant. In the plane.
struct BagState {
  double area = 0;          // enclosed, m^2
  double gas_volume = 0;    // sum V_p, m^2
  double pressure = 0;      // sum V_p p_p / sum V_p, Pa
  double hoop_stress = 0;   // sum sigma l / sum l, Pa
  double hoop_scatter = 0;  // standard deviation of sigma over its mean
  int escaped = 0;          // gas points outside
};
BagState look_at(const Body& gas, const Body& membrane, const MembraneMaterial& material, const Curve& corners);

// Stress along the membrane, E' eps of each segment or point; zero where it is slack and the law is one-way. Pa
std::vector<double> hoop_stresses(const Body& membrane, const MembraneMaterial& material);

// The mean, and the standard deviation over it: of stresses of points that stand for equal parts.
std::array<double, 2> mean_and_scatter(const std::vector<double>& stress);

}  // namespace plumbline
