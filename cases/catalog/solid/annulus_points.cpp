#include "cases/catalog/solid/annulus_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

struct Place {
  std::array<double, 2> x;
  double volume;
};

std::vector<Place> places_on_circles(const Annulus& a, double spacing) {
  const int circles = std::max(1, whole(std::round((a.outer - a.inner) / spacing)));
  const double width = (a.outer - a.inner) / circles, turn = (a.quarter ? 0.5 : 2.0) * std::numbers::pi;
  std::vector<Place> places;
  for (int c = 0; c < circles; ++c) {
    const double low = a.inner + c * width, high = low + width, middle = 0.5 * (low + high);
    // The first moment of a band over its area, for a share of small angle.
    const double radius = 2.0 / 3 * (high * high * high - low * low * low) / (high * high - low * low);
    const int count = std::max(a.quarter ? 1 : 4, whole(std::round(turn * middle / width)));
    for (int k = 0; k < count; ++k) {
      const double angle = (k + 0.5) * turn / count;
      places.push_back({{a.centre[0] + radius * std::cos(angle), a.centre[1] + radius * std::sin(angle)},
                        0.5 * (high * high - low * low) * turn / count});
    }
  }
  return places;
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

Body ring_annulus(std::string name, std::shared_ptr<const Material> material, const Annulus& annulus, double density,
                  int ppc, const GridSpec& grid) {
  const std::vector<Place> places = places_on_circles(annulus, grid.h / ppc);
  Body body = make_body(std::move(name), std::move(material), static_cast<int>(places.size()), 2);
  double total = 0;
  for (int p = 0; p < body.points.points(); ++p) {
    const Place& place = places[static_cast<std::size_t>(p)];
    for (int d = 0; d < 2; ++d) body.points(column::position, d)[p] = place.x[static_cast<std::size_t>(d)];
    body.points(column::volume)[p] = place.volume;
    body.points(column::mass)[p] = density * place.volume;
    total += place.volume;
  }
  body.spacing = std::sqrt(total / static_cast<double>(places.size()));
  return body;
}

AnnulusLayout annulus_layout(const std::string& name) {
  return name == "cut" ? cut_annulus : name == "circles" ? ring_annulus : fill_annulus;
}

Key layout_key(std::string value) {
  return {.name = "layout",
          .value = std::move(value),
          .choices = {"cut", "circles", "lattice"},
          .description = "the lattice with cut squares, points on circles, or whole squares"};
}

}  // namespace plumbline
