#include "cases/catalog/gas/fill_ball.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

using std::numbers::pi;

// What a part of the gas holds.
struct Part {
  double volume = 0, mass = 0, heat = 0;
  Position moment{};

  void add(const Position& x, double dv, double rho, double p, double gamma) {
    volume += dv;
    mass += rho * dv;
    heat += p * dv / (gamma - 1);  // [York 4.4]
    for (std::size_t d = 0; d < 3; ++d) moment[d] += x[d] * rho * dv;
  }
  void add(const Part& other) {
    volume += other.volume;
    mass += other.mass;
    heat += other.heat;
    for (std::size_t d = 0; d < 3; ++d) moment[d] += other.moment[d];
  }
};

Body body_of(std::shared_ptr<const IdealGas> gas, const std::vector<Part>& parts, const RadialGeometry& geometry) {
  const double gamma = gas->gamma;
  Body body = make_body("gas", std::move(gas), static_cast<int>(parts.size()), geometry.dim, geometry.axisymmetric);
  Columns& points = body.points;
  for (int p = 0; p < points.points(); ++p) {
    const Part& part = parts[static_cast<std::size_t>(p)];
    for (int d = 0; d < geometry.dim; ++d) {
      points(column::position, d)[p] = part.moment[static_cast<std::size_t>(d)] / part.mass;
    }
    points(column::volume)[p] = part.volume;
    points(column::mass)[p] = part.mass;
    points(column::density)[p] = part.mass / part.volume;
    points(column::energy)[p] = part.heat / part.mass;
    points(column::pressure)[p] = (gamma - 1) * part.heat / part.volume;  // [York 4.4]
  }
  return body;
}

// The places and weights of Gauss's rule.
template <class Visit>
void over_interval(const Interval& over, Visit&& visit) {
  for (const auto& [place, weight] : gauss_points) visit(over.middle() + place * over.length(), weight * over.length());
}

// The part of the gas in a lattice cell: stations along all directions but the last, along that the exact interval.
class LatticeCell {
 public:
  LatticeCell(const GasBall& ball, double gamma, double size) : ball_(ball), gamma_(gamma), size_(size) {}

  Part at(const std::array<int, 3>& cell) const {
    Part part;
    const int planes = ball_.geometry.dim == 3 ? stations : 1;
    for (int k = 0; k < planes; ++k) {
      for (int j = 0; j < stations; ++j) {
        Position x{station(cell[0], j), 0, 0};
        if (planes > 1) x[1] = station(cell[1], k);
        along(cell, x, std::pow(size_ / stations, ball_.geometry.dim - 1), part);
      }
    }
    return part;
  }

 private:
  static constexpr int stations = 8;

  double station(int cell, int k) const { return size_ * (cell + (k + 0.5) / stations); }
  void along(const std::array<int, 3>& cell, Position x, double measure, Part& part) const {
    const std::size_t last = ball_.geometry.dim == 3 ? 2 : 1;
    const double r = radius_of(ball_.geometry, x), from = size_ * cell[last];
    if (r >= ball_.radius) return;
    const double to = std::min(from + size_, std::sqrt((ball_.radius - r) * (ball_.radius + r)));
    if (to <= from) return;
    over_interval({from, to}, [&](double s, double ds) {
      x[last] = s;
      const reference::GasState state = ball_.initial(radius_of(ball_.geometry, x));
      const double weight = ball_.geometry.axisymmetric ? x[0] : 1.0;
      part.add(x, ds * measure * weight, state.density, state.pressure, gamma_);
    });
  }

  const GasBall& ball_;
  double gamma_, size_;
};

// Parts of less than a quarter of a cell are given to the next cell inwards: a sliver at the edge would be a point of
// next to no mass, and where the gas ends in nothing, of next to no energy.
std::vector<Part> lattice(const GasBall& ball, double gamma, double size) {
  const LatticeCell cells(ball, gamma, size);
  const int count = whole(std::ceil(ball.radius / size));
  const int deep = ball.geometry.dim == 3 ? count : 1;
  const auto place = [&](const std::array<int, 3>& cell) {
    return static_cast<std::size_t>((cell[2] * count + cell[1]) * count + cell[0]);
  };
  std::vector<Part> all(static_cast<std::size_t>(count * count * deep));
  for (int k = deep - 1; k >= 0; --k) {
    for (int j = count - 1; j >= 0; --j) {
      for (int i = count - 1; i >= 0; --i) {
        std::array<int, 3> cell{i, j, k};
        Part& part = all[place(cell)];
        part.add(cells.at(cell));
        const double whole = std::pow(size, ball.geometry.dim) * (ball.geometry.axisymmetric ? (i + 0.5) * size : 1.0);
        if (part.volume == 0 || part.volume >= 0.25 * whole) continue;
        int& outermost = *std::max_element(cell.begin(), cell.end());
        if (outermost == 0) continue;
        --outermost;
        all[place(cell)].add(part);
        part = {};
      }
    }
  }
  std::erase_if(all, [](const Part& part) { return part.volume == 0; });
  return all;
}

// A quarter turn in equal angles.
std::vector<Interval> quarter(double arc, double width) {
  const int count = std::max(1, whole(std::round(arc / width)));
  std::vector<Interval> all;
  for (int k = 0; k < count; ++k) all.push_back({pi / 2 * k / count, pi / 2 * (k + 1) / count});
  return all;
}

// Integrals over one sector of a shell: of the directions' components, and of 1, over solid angle.
struct Sector {
  Position direction{};
  double angle = 0;
};

std::vector<Sector> sectors(const RadialGeometry& geometry, double radius, double width) {
  std::vector<Sector> all;
  for (const Interval& t : quarter(pi / 2 * radius, width)) {
    const double c = std::cos(t.from) - std::cos(t.to), s = std::sin(t.to) - std::sin(t.from);
    if (geometry.dim == 2 && !geometry.axisymmetric) {
      all.push_back({{s, c, 0}, t.length()});
      continue;
    }
    // Polar angle t from the axis; sin t dt = c over the band.
    const double out = 0.5 * (t.length() - 0.5 * (std::sin(2 * t.to) - std::sin(2 * t.from)));  // sin^2
    const double up = 0.5 * s * (std::sin(t.to) + std::sin(t.from));                            // sin cos
    if (geometry.axisymmetric) {
      all.push_back({{out, up, 0}, c});
      continue;
    }
    for (const Interval& f : quarter(pi / 2 * radius * std::sin(t.middle()), width)) {
      const double fs = std::sin(f.to) - std::sin(f.from), fc = std::cos(f.from) - std::cos(f.to);
      all.push_back({{out * fs, out * fc, up * f.length()}, c * f.length()});
    }
  }
  return all;
}

// One line of rings above another; the flow is the same at all heights.
std::vector<Sector> lines(double height, int count) {
  std::vector<Sector> all;
  for (int k = 0; k < count; ++k) all.push_back({{1, 0, 0}, height / count});
  return all;
}

std::vector<Part> shells(const GasBall& ball, double gamma, const std::function<double(double)>& per_length, double h,
                         int lines_a_cell) {
  const RadialGeometry& geometry = ball.geometry;
  const int on_height = whole(std::round(slice_height(h) / h)) * lines_a_cell;
  std::vector<Part> parts;
  for (const Interval& shell : equal_shares({0, ball.radius}, per_length)) {
    double volume = 0, mass = 0, heat = 0, moment = 0;
    over_interval(shell, [&](double r, double dr) {
      const reference::GasState state = ball.initial(r);
      const double dv = std::pow(r, geometry.dimension - 1) * dr;
      volume += dv;
      mass += state.density * dv;
      heat += state.pressure * dv / (gamma - 1);  // [York 4.4]
      moment += r * state.density * dv;
    });
    const std::vector<Sector> all = geometry.slice ? lines(slice_height(h), on_height)
                                                   : sectors(geometry, shell.middle(), shell.length());
    for (std::size_t k = 0; k < all.size(); ++k) {
      Part part{volume * all[k].angle, mass * all[k].angle, heat * all[k].angle, {}};
      for (std::size_t d = 0; d < 3; ++d) part.moment[d] = moment * all[k].direction[d];
      if (geometry.slice) {
        part.moment[0] *= all[k].angle;
        part.moment[1] = part.mass * slice_height(h) * (static_cast<double>(k) + 0.5) / on_height;
      }
      parts.push_back(part);
    }
  }
  return parts;
}

// Points a length along the radius.
std::function<double(double)> points_per_length(const GasBall& ball, const PointRule& rule, double h) {
  if (ball.spacing) return [&ball](double r) { return 1 / ball.spacing(r); };
  // Points of one mass, rho s^d, stand s = (mass/rho)^(1/d) apart.
  const double least = std::min(rule.ppc, 2 * rule.least);
  return [&ball, rule, least, h, centre = ball.initial(0).density](double r) {
    return std::max(rule.ppc * std::pow(ball.initial(r).density / centre, 1.0 / ball.geometry.dim), least) / h;
  };
}

}  // namespace

Body fill_ball(std::shared_ptr<const IdealGas> gas, const GasBall& ball, const PointRule& rule, const GridSpec& grid) {
  if (ball.geometry.slice && !ball.spacing) {
    GasBox box;
    box.high = {ball.radius, slice_height(grid.h), 0};
    box.state = [&](const Position& x) {
      const reference::GasState state = ball.initial(x[0]);
      return GasAt{state.density, {}, state.pressure};
    };
    return fill_gas(std::move(gas), box, rule, grid);
  }
  const double gamma = gas->gamma;
  const bool on_lattice = !ball.spacing && (ball.uniform || !rule.equal_mass);
  const std::vector<Part> parts = on_lattice
                                      ? lattice(ball, gamma, grid.h / rule.ppc)
                                      : shells(ball, gamma, points_per_length(ball, rule, grid.h), grid.h, rule.lines);
  return body_of(std::move(gas), parts, ball.geometry);
}

}  // namespace plumbline
