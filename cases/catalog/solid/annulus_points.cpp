#include "cases/catalog/solid/annulus_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/shapes/domain_columns.hpp"

namespace plumbline {
namespace {

// A sector of a band between two circles.
struct Sector {
  double low, high;     // radii
  double angle, width;  // of its middle, and between its sides

  double middle() const { return 0.5 * (low + high); }
  double area() const { return 0.5 * (high * high - low * low) * width; }
  // The first moment of its radii over its area; the centre of mass is nearer by the mean of the cosine over its angles.
  double mean_radius() const { return 2.0 / 3 * (high * high * high - low * low * low) / (high * high - low * low); }
  double centroid_radius() const { return mean_radius() * std::sin(width / 2) / (width / 2); }
};

// Bands a spacing wide (the nearest that divides the ring's width), of sectors about as long: in each band for itself, or
// in all alike, so that each has its sides in common with those of the next band.
std::vector<Sector> sectors_of(const Annulus& a, double spacing, bool alike) {
  const int circles = std::max(1, whole(std::round((a.outer - a.inner) / spacing)));
  const double width = (a.outer - a.inner) / circles, turn = (a.quarter ? 0.5 : 2.0) * std::numbers::pi;
  std::vector<Sector> sectors;
  for (int c = 0; c < circles; ++c) {
    Sector sector{a.inner + c * width, a.inner + (c + 1) * width, 0, 0};
    const double radius = alike ? 0.5 * (a.inner + a.outer) : sector.middle();
    const int count = std::max(a.quarter ? 1 : 4, whole(std::round(turn * radius / width)));
    sector.width = turn / count;
    for (int k = 0; k < count; ++k) {
      sector.angle = (k + 0.5) * sector.width;
      sectors.push_back(sector);
    }
  }
  return sectors;
}

// Area, first and second moments of what lies inside.
struct Piece {
  double area = 0;
  std::array<double, 2> first{}, second{};
  void add(const Piece& o) {
    area += o.area;
    for (std::size_t d = 0; d < 2; ++d) {
      first[d] += o.first[d];
      second[d] += o.second[d];
    }
  }
  double middle(std::size_t d) const { return first[d] / area; }
  // Half the edge of the box with this variance.
  double half(std::size_t d) const { return std::sqrt(3 * (second[d] / area - middle(d) * middle(d))); }
};

bool inside(const Annulus& a, double x, double y) {
  const double r = std::hypot(x, y);
  return r >= a.inner && r <= a.outer && (!a.quarter || (x >= 0 && y >= 0));
}

// The square of the lattice with this corner, seen from the centre, by samples.
Piece piece_of(const Annulus& a, double x, double y, double edge) {
  constexpr int samples = 40;
  const double reach = std::sqrt(2.0) * edge, middle = std::hypot(x + edge / 2, y + edge / 2);
  Piece piece;
  if (middle > a.outer + reach || middle < a.inner - reach) return piece;
  const double share = edge / samples, own = share * share / 12;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const std::array<double, 2> at{x + (i + 0.5) * share, y + (j + 0.5) * share};
      if (!inside(a, at[0], at[1])) continue;
      Piece sample{share * share, {}, {}};
      for (std::size_t d = 0; d < 2; ++d) {
        sample.first[d] = sample.area * at[d];
        sample.second[d] = sample.area * (at[d] * at[d] + own);
      }
      piece.add(sample);
    }
  }
  return piece;
}

// All pieces of at least half a square.
std::vector<Piece> pieces_of(const Annulus& a, double spacing) {
  const int reach = whole(std::ceil(a.outer / spacing)) + 1, low = a.quarter ? 0 : -reach, count = reach - low;
  std::vector<Piece> grid(static_cast<std::size_t>(count * count));
  const auto at = [&](int i, int j) -> Piece& { return grid[static_cast<std::size_t>((i - low) * count + (j - low))]; };
  for (int i = low; i < reach; ++i) {
    for (int j = low; j < reach; ++j) at(i, j) = piece_of(a, i * spacing, j * spacing, spacing);
  }
  const double least = 0.5 * spacing * spacing;
  const std::vector<Piece> before = grid;
  const auto area = [&](int i, int j) { return before[static_cast<std::size_t>((i - low) * count + (j - low))].area; };
  for (int i = low; i < reach; ++i) {
    for (int j = low; j < reach; ++j) {
      if (area(i, j) == 0 || area(i, j) >= least) continue;
      // Into the neighbour along an axis that has most of itself inside.
      int best_i = i, best_j = j;
      double best = 0;
      for (const auto& [di, dj] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
        const int ni = i + di, nj = j + dj;
        if (ni < low || nj < low || ni >= reach || nj >= reach || area(ni, nj) <= best) continue;
        best = area(ni, nj);
        best_i = ni;
        best_j = nj;
      }
      if (best < least) continue;
      at(best_i, best_j).add(at(i, j));
      at(i, j) = Piece{};
    }
  }
  std::vector<Piece> pieces;
  for (const Piece& piece : grid) {
    if (piece.area > 0) pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

Body cut_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                 int ppc, const GridSpec& grid) {
  const double spacing = grid.h / ppc;
  const std::vector<Piece> pieces = pieces_of(annulus, spacing);
  Body body = make_body(std::move(name), std::move(material), static_cast<int>(pieces.size()), 2);
  body.spacing = spacing;
  for (const ColumnId& id : {column::half_size, column::half_size_at_start}) body.points.add(id, 2);
  for (int p = 0; p < body.points.points(); ++p) {
    const Piece& piece = pieces[static_cast<std::size_t>(p)];
    for (int d = 0; d < 2; ++d) {
      const auto k = static_cast<std::size_t>(d);
      body.points(column::position, d)[p] = annulus.centre[k] + piece.middle(k);
      body.points(column::half_size, d)[p] = body.points(column::half_size_at_start, d)[p] = piece.half(k);
    }
    body.points(column::volume)[p] = piece.area;
    body.points(column::mass)[p] = density * piece.area;
  }
  return body;
}

Body fill_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                  int ppc, const GridSpec& grid) {
  SolidShape shape;
  const double spacing = grid.h / ppc;
  for (std::size_t d = 0; d < 2; ++d) {
    // The lattice of the grid's cells, from the first that the ring may reach.
    const double low = annulus.centre[d] - (annulus.quarter ? 0 : annulus.outer);
    shape.low[d] = grid.origin[d] + std::floor((low - grid.origin[d]) / spacing + 1e-6) * spacing;
    shape.high[d] = annulus.centre[d] + annulus.outer;
  }
  shape.inside = [annulus](const std::array<double, 3>& x) {
    const double dx = x[0] - annulus.centre[0], dy = x[1] - annulus.centre[1], r = std::hypot(dx, dy);
    return r >= annulus.inner && r <= annulus.outer && (!annulus.quarter || (dx >= 0 && dy >= 0));
  };
  return fill_solid(std::move(name), std::move(material), shape, density, ppc, grid);
}

namespace {

// A point for each sector, at this radius and its middle angle.
Body points_of(const std::vector<Sector>& sectors, double (Sector::*radius)() const, std::string name,
               std::shared_ptr<const Material> material, const Annulus& annulus, double density) {
  Body body = make_body(std::move(name), std::move(material), static_cast<int>(sectors.size()), 2);
  double total = 0;
  for (int p = 0; p < body.points.points(); ++p) {
    const Sector& sector = sectors[static_cast<std::size_t>(p)];
    const double r = (sector.*radius)();
    body.points(column::position, 0)[p] = annulus.centre[0] + r * std::cos(sector.angle);
    body.points(column::position, 1)[p] = annulus.centre[1] + r * std::sin(sector.angle);
    body.points(column::volume)[p] = sector.area();
    body.points(column::mass)[p] = density * sector.area();
    total += sector.area();
  }
  body.spacing = std::sqrt(total / static_cast<double>(sectors.size()));
  return body;
}

}  // namespace

Body ring_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                  int ppc, const GridSpec& grid) {
  return points_of(sectors_of(annulus, grid.h / ppc, false), &Sector::mean_radius, std::move(name), std::move(material),
                   annulus, density);
}

Body polar_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                   int ppc, const GridSpec& grid) {
  const std::vector<Sector> sectors = sectors_of(annulus, grid.h / ppc, true);
  Body body = points_of(sectors, &Sector::centroid_radius, std::move(name), std::move(material), annulus, density);
  body.points.add(column::half_edges_at_start, 4);
  for (int p = 0; p < body.points.points(); ++p) {
    const Sector& sector = sectors[static_cast<std::size_t>(p)];
    const double across = (sector.high - sector.low) / 2, along = sector.middle() * sector.width / 2;
    const double c = std::cos(sector.angle), s = std::sin(sector.angle);
    const double edges[] = {across * c, across * s, -along * s, along * c};
    for (int k = 0; k < 4; ++k) body.points(column::half_edges_at_start, k)[p] = edges[k];
  }
  return body;
}

AnnulusLayout annulus_layout(const std::string& name) {
  return name == "cut"       ? cut_annulus
         : name == "polar"   ? polar_annulus
         : name == "circles" ? ring_annulus
                             : fill_annulus;
}

Key layout_key(std::string value) {
  return {.name = "layout",
          .value = std::move(value),
          .choices = {"polar", "cut", "circles", "lattice"},
          .description = "sectors with domains, the lattice with cut squares, points on circles, or whole squares"};
}

}  // namespace plumbline
