#include "cases/catalog/coupled/membrane.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "cases/harness/files/whole.hpp"
#include "kernel/curve_order.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

using Place = std::array<double, 2>;

double distance(const Place& a, const Place& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

Place between(const Place& a, const Place& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

std::vector<double> chords(const Curve& curve, bool closed) {
  if (curve.size() < 2) throw std::invalid_argument("a membrane needs two vertices at least");
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) all.push_back(distance(curve[k], curve[k + 1]));
  if (closed) all.push_back(distance(curve.back(), curve.front()));
  return all;
}

void put(Columns& points, std::size_t p, const Place& at) {
  points(column::position)[p] = at[0];
  points(column::position, 1)[p] = at[1];
}

Body segment_body(const std::string& name, const MembraneMaterial& m, const Curve& curve, double strain, bool closed) {
  auto material = std::make_shared<SegmentMembrane>();
  material->youngs_modulus = m.plane_modulus();
  material->density = m.density;
  material->section = m.thickness;
  material->one_way = m.one_way;
  material->closed = closed;
  Body body = make_body(name, material, static_cast<int>(curve.size()), 2);
  const std::vector<double> chord = chords(curve, closed);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    const double after = p < chord.size() ? chord[p] : 0.0;
    const double before = p > 0 ? chord[p - 1] : closed ? chord.back() : 0.0;
    const double share = 0.5 * (before + after) / (1 + strain);
    put(body.points, p, curve[p]);
    body.points(column::volume)[p] = m.thickness * share;
    body.points(column::mass)[p] = m.density * m.thickness * share;
    if (p < chord.size()) body.points(column::rest_length)[p] = chord[p] / (1 + strain);
  }
  return body;
}

Body accumulating_body(const std::string& name, const MembraneMaterial& m, const Curve& curve, double strain,
                       bool closed) {
  auto material = std::make_shared<PlaneStressMembrane>();
  material->youngs_modulus = m.youngs_modulus;
  material->poissons_ratio = m.poissons_ratio;
  material->density = m.density;
  material->one_way = m.one_way;
  material->closed = closed;
  const std::vector<double> chord = chords(curve, closed);
  Body body = make_body(name, material, static_cast<int>(chord.size()), 2);
  for (std::size_t p = 0; p < chord.size(); ++p) {
    put(body.points, p, between(curve[p], curve[(p + 1) % curve.size()], 0.5));
    body.points(column::volume)[p] = m.thickness * chord[p] / (1 + strain);
    body.points(column::mass)[p] = m.density * m.thickness * chord[p] / (1 + strain);
    body.points(column::strain)[p] = strain;
  }
  return body;
}

const SegmentMembrane* segments_of(const Body& membrane) {
  return dynamic_cast<const SegmentMembrane*>(membrane.material.get());
}

}  // namespace

double length(const Curve& curve) {
  double sum = 0;
  for (const double chord : chords(curve, false)) sum += chord;
  return sum;
}

Curve evenly(const Curve& curve, int segments) {
  if (segments < 1) throw std::invalid_argument("a curve needs a segment at least");
  const std::vector<double> chord = chords(curve, false);
  const double whole = length(curve);
  Curve even{curve.front()};
  std::size_t k = 0;
  double start = 0;
  for (int s = 1; s < segments; ++s) {
    const double at = whole * s / segments;
    while (k + 1 < chord.size() && start + chord[k] < at) start += chord[k++];
    even.push_back(between(curve[k], curve[k + 1], (at - start) / chord[k]));
  }
  even.push_back(curve.back());
  return even;
}

Curve out_of_order(const Curve& curve) {
  const std::size_t n = curve.size();
  std::size_t stride = n * 5 / 8;
  while (std::gcd(stride, n) > 1) ++stride;
  Curve all;
  for (std::size_t k = 0; k < n; ++k) all.push_back(curve[(k + 1) * stride % n]);
  return all;
}

Curve in_order(const Curve& vertices, const Curve& corners) {
  std::vector<double> x, y;
  for (const Place& at : vertices) {
    x.push_back(at[0]);
    y.push_back(at[1]);
  }
  Curve all;
  for (const int k : order_along_curve(x, y).points) all.push_back(vertices[static_cast<std::size_t>(k)]);
  Curve bounded = all;
  bounded.insert(bounded.end(), corners.begin(), corners.end());
  if (enclosed(bounded) < 0) std::reverse(all.begin(), all.end());
  return all;
}

Body membrane_body(const Settings& settings, const std::string& name, const MembraneMaterial& material,
                   const Curve& curve, double strain, bool closed) {
  Body body = settings.text("membrane.strain") == "segments" ? segment_body(name, material, curve, strain, closed)
                                                             : accumulating_body(name, material, curve, strain, closed);
  const std::vector<double> chord = chords(curve, closed);
  double whole = 0;
  for (const double c : chord) whole += c;
  body.spacing = whole / static_cast<double>(chord.size());
  return body;
}

// Of a band between the radii a and b: its area per radian is L (a + b)/2, of which each end carries the half next to it.
Body revolved_body(const std::string& name, const MembraneMaterial& m, const Curve& curve) {
  auto material = std::make_shared<SegmentMembrane>();
  material->youngs_modulus = m.youngs_modulus;
  material->poissons_ratio = m.poissons_ratio;
  material->density = m.density;
  material->section = m.thickness;
  material->revolved = true;
  Body body = make_body(name, material, static_cast<int>(curve.size()), 2, true);
  const std::vector<double> chord = chords(curve, false);
  for (std::size_t p = 0; p < curve.size(); ++p) put(body.points, p, curve[p]);
  for (std::size_t s = 0; s < chord.size(); ++s) {
    const double a = curve[s][0], b = curve[s + 1][0];
    body.points(column::rest_length)[s] = chord[s];
    body.points(column::rest_radius)[s] = 0.5 * (a + b);
    const double halves[2] = {0.5 * chord[s] * (0.75 * a + 0.25 * b), 0.5 * chord[s] * (0.25 * a + 0.75 * b)};
    for (std::size_t end = 0; end < 2; ++end) {
      body.points(column::volume)[s + end] += m.thickness * halves[end];
      body.points(column::mass)[s + end] += m.density * m.thickness * halves[end];
    }
  }
  body.spacing = length(curve) / static_cast<double>(chord.size());
  return body;
}

Body fill_polygon(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
                  const Curve& polygon, double density, double energy) {
  const double spacing = grid.h / std::sqrt(static_cast<double>(ppc));
  Curve places;
  double weights = 0;
  const auto across = whole(std::round(grid.cells[0] * grid.h / spacing)) + 1;
  const auto up = whole(std::round(grid.cells[1] * grid.h / spacing)) + 1;
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i) {
      const Place at{grid.origin[0] + (i + 0.5) * spacing, grid.origin[1] + (j + 0.5) * spacing};
      if (!inside(polygon, at[0], at[1])) continue;
      places.push_back(at);
      weights += grid.axisymmetric ? at[0] : 1.0;
    }
  }
  if (places.empty()) throw std::invalid_argument("no point of the lattice lies in the space of " + name);
  Body body = make_body(name, std::move(gas), static_cast<int>(places.size()), 2, grid.axisymmetric);
  const double space = std::abs(enclosed(polygon, grid.axisymmetric));
  for (std::size_t p = 0; p < places.size(); ++p) {
    const double volume = space * (grid.axisymmetric ? places[p][0] : 1.0) / weights;
    put(body.points, p, places[p]);
    body.points(column::volume)[p] = volume;
    body.points(column::mass)[p] = density * volume;
    body.points(column::density)[p] = density;
    body.points(column::energy)[p] = energy;
  }
  return body;
}

// Area x dy around; volume per radian x^2/2 dy, exact for straight edges.
double enclosed(const Curve& polygon, bool axisymmetric) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Place &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    sum += axisymmetric ? (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 6 * (b[1] - a[1])
                        : 0.5 * (a[0] * b[1] - b[0] * a[1]);
  }
  return sum;
}

bool inside(const Curve& polygon, double x, double y) {
  bool in = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Place &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])) in = !in;
  }
  return in;
}

Curve outline(const Body& membrane, const Curve& corners) {
  Curve polygon;
  const double *x = membrane.points(column::position), *y = membrane.points(column::position, 1);
  for (int p = 0; p < membrane.points.points(); ++p) polygon.push_back({x[p], y[p]});
  polygon.insert(polygon.end(), corners.begin(), corners.end());
  return polygon;
}

std::vector<double> hoop_stresses(const Body& membrane, const MembraneMaterial& material) {
  const SegmentMembrane* segments = segments_of(membrane);
  const int count = membrane.points.points() - (segments && !segments->closed ? 1 : 0);
  std::vector<double> all;
  for (int p = 0; p < count; ++p) {
    const double strain = membrane.points(column::strain)[p];
    all.push_back(material.one_way && strain < 0 ? 0.0 : material.plane_modulus() * strain);
  }
  return all;
}

BagState look_at(const Body& gas, const Body& membrane, const MembraneMaterial& material, const Curve& corners) {
  BagState state;
  const Curve polygon = outline(membrane, corners);
  state.area = enclosed(polygon);
  const double *volume = gas.points(column::volume), *pressure = gas.points(column::pressure);
  const double *x = gas.points(column::position), *y = gas.points(column::position, 1);
  double push = 0;
  for (int p = 0; p < gas.points.points(); ++p) {
    state.gas_volume += volume[p];
    push += volume[p] * pressure[p];
    if (!inside(polygon, x[p], y[p])) ++state.escaped;
  }
  state.pressure = push / state.gas_volume;
  const std::vector<double> stress = hoop_stresses(membrane, material);
  const double* own = segments_of(membrane) ? membrane.points(column::rest_length) : membrane.points(column::volume);
  double sum = 0, whole = 0, squares = 0;
  for (std::size_t s = 0; s < stress.size(); ++s) {
    sum += own[s] * stress[s];
    whole += own[s];
  }
  state.hoop_stress = sum / whole;
  for (std::size_t s = 0; s < stress.size(); ++s) {
    squares += own[s] * (stress[s] - state.hoop_stress) * (stress[s] - state.hoop_stress);
  }
  state.hoop_scatter = std::sqrt(squares / whole) / state.hoop_stress;
  return state;
}

std::array<double, 2> mean_and_scatter(const std::vector<double>& stress) {
  const auto count = static_cast<double>(stress.size());
  double sum = 0, squares = 0;
  for (const double s : stress) sum += s;
  for (const double s : stress) squares += (s - sum / count) * (s - sum / count);
  return {sum / count, std::sqrt(squares / count) / (sum / count)};
}

}  // namespace plumbline
