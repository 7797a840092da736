// What gates of shapes measure of shapes that are wrong by known amounts.
#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/parts/flawed_shape.hpp"
#include "cases/catalog/estimators/parts/reading.hpp"
#include "cases/harness/parts/shape_gates.hpp"

namespace plumbline {
namespace {

constexpr double shape_flaw = 1e-3;  // far above roundings, far below what shapes themselves are

// The subject of a shape with flaws on one of both grids.
SharedSubject with_flaws(const std::string& shape, std::size_t geometry, const ShapeFlaws& flaws,
                         std::unique_ptr<ShapeProbe> ShapeSubject::*grid = &ShapeSubject::walled) {
  auto subject = std::make_shared<ShapeSubject>(shape_named(shape), geometry);
  std::unique_ptr<ShapeProbe>& probe = (*subject).*grid;
  probe = flawed(std::move(probe), flaws);
  return subject;
}
SharedSubject of_one_node(std::size_t geometry, const MapFlaws& flaws) {
  auto subject = std::make_shared<ShapeSubject>(shape_named("linear"), geometry);
  subject->walled = one_node(geometry, {});
  subject->open = one_node(geometry, flaws);
  return subject;
}

struct FlawedRow {
  const char* row;  // without the geometry
  ShapeFlaws flaws;
  double exact;
};

ShapeFlaws made(const std::function<void(ShapeFlaws&)>& set) {
  ShapeFlaws flaws;
  set(flaws);
  return flaws;
}

// The shape says that places up to so many cells beyond the sides are on the grid.
ShapeFlaws reaching(const GridSpec& grid, double cells) {
  return made([&](auto& f) {
    f.inside = [grid, beyond = cells * grid.h](const ProbePoint& point) {
      for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
        const double low = grid.origin[d] - beyond, high = grid.origin[d] + grid.cells[d] * grid.h + beyond;
        if (!(point.x[d] >= low && point.x[d] <= high)) return false;
      }
      return true;
    };
  });
}

// Of any geometry; h: size of a cell, dim: number of directions.
std::vector<FlawedRow> flawed_rows(double h, int dim) {
  return {
      {"unity", made([](auto& f) { f.value = shape_flaw; }), shape_flaw},
      {"unity", made([](auto& f) { f.value = -shape_flaw; }), shape_flaw},
      {"linear", made([](auto& f) { f.value = shape_flaw; }), shape_flaw / h},
      {"gradient/sums", made([](auto& f) { f.constant_slope = shape_flaw; }), shape_flaw},
      {"gradient/sums", made([h](auto& f) { f.slope = shape_flaw * h; }), shape_flaw},
      {"gradient/sums", made([h, dim](auto& f) { f.slope = shape_flaw * h, f.direction = dim - 1; }), shape_flaw},
      {"inertia/second-moment", made([](auto& f) { f.inertia = shape_flaw; }), shape_flaw},
      {"inertia/constant", made([](auto& f) { f.inertia = -shape_flaw; }), shape_flaw},
      {"inertia/blur", made([](auto& f) { f.blur = shape_flaw; }), shape_flaw},
      {"inertia/blur", made([](auto& f) { f.inertia = shape_flaw; }), shape_flaw / 2},
      {"inertia/affine", made([](auto& f) { f.taken_velocity = shape_flaw; }), shape_flaw},
      {"inertia/affine", made([](auto& f) { f.taken_slope = shape_flaw; }), shape_flaw},
      {"volume", made([](auto& f) { f.volume = shape_flaw; }), shape_flaw},
  };
}

}  // namespace

KnownAnswers shape_answers() {
  KnownAnswers all;
  for (std::size_t geometry = 0; geometry < geometry_names().size(); ++geometry) {
    const std::string& where = geometry_names()[geometry];
    const GridSpec grid = probe_grid(geometry, true);
    int number = 0;
    for (const FlawedRow& one : flawed_rows(grid.h, grid.dim)) {
      const SharedSubject subject = with_flaws("quadratic", geometry, one.flaws);
      const std::string name = one.row + ("/" + where);
      all.push_back({std::to_string(number++) + "." + name, reading(shape_identity_gates(subject), name), one.exact});
    }
    const SharedSubject open = with_flaws("quadratic", geometry, made([](auto& f) { f.value = shape_flaw; }),
                                          &ShapeSubject::open);
    all.push_back({"open/" + where, reading(shape_identity_gates(open), "unity/" + where), shape_flaw});
    // Places are tried along each direction: two a millionth of a cell beyond the sides, two five cells, two far off, one nowhere
    // and one that is no number; two on the sides, two a millionth of a cell inside, and the middle.
    for (const auto& [beyond, wrong] : {std::pair{0.0, 0.0},
                                        {0.9e-6, 0},
                                        {1.1e-6, 2},
                                        {4.9, 2},
                                        {5.1, 4},
                                        {1e301, 6},
                                        {HUGE_VAL, 7},
                                        {-0.9e-6, 2},
                                        {-1.1e-6, 4},
                                        {-9, 5}}) {
      const SharedSubject subject = with_flaws("quadratic", geometry, reaching(grid, beyond));
      all.push_back({std::to_string(number++) + ".sides/" + where,
                     reading(shape_support_gates(subject), "support/sides/" + where), wrong * grid.dim});
    }
    // One node: what points give and take are sums.
    const std::pair<const char*, MapFlaws> maps[] = {
        {"adjoint/values", {.spread = shape_flaw}}, {"adjoint/values", {.mass = -shape_flaw}},
        {"adjoint/forces", {.force = shape_flaw}},  {"volume/read", {.density = shape_flaw}},
        {"volume/read", {.specific = -shape_flaw}}, {"adjoint/loss", {.loss = shape_flaw}}};
    for (const auto& [row, flaws] : maps) {
      const std::string name = row + ("/" + where);
      all.push_back({std::to_string(number++) + "." + name,
                     reading(shape_identity_gates(of_one_node(geometry, flaws)), name), shape_flaw});
    }
  }
  // On a line the reach of linear shapes is two nodes: of one left out the slope is 1/h at least once.
  const SharedSubject shifted = with_flaws("linear", 0, made([](auto& f) { f.lowest = 1; }));
  all.push_back({"reach", reading(shape_support_gates(shifted), "support/reach/line"), 1});
  return all;
}

KnownAnswers path_answers() {
  KnownAnswers all;
  // On a line of nine cells of 0.3 m, in the middle of one, two and a half before the end. Cubic shapes have smooth gradients.
  constexpr double size = 0.5, beyond = 2.5;
  const GridSpec grid = probe_grid(0, true);
  ShapeFlaws jump, kink, slope;
  jump.from = kink.from = grid.origin[0] + (9 - beyond) * grid.h;
  jump.jump = kink.kink = size;
  slope.slope = -size;
  const auto of = [&](const ShapeFlaws& flaws, const std::string& row) {
    return reading(shape_path_gates(with_flaws("cubic", 0, flaws)), row + "/line");
  };
  all.push_back({"jump.value", of(jump, "continuity/value"), size});
  all.push_back({"jump.integral", of(jump, "gradient/derivative"), size});
  all.push_back({"kink.slope", of(kink, "continuity/gradient"), size});
  all.push_back({"kink.value", of(kink, "continuity/value"), 0});
  // Between points an edge of their domains apart the same jump.
  const SharedSubject domains = with_flaws("cpdi", 0, jump);
  all.push_back({"jump.domains", reading(shape_domain_gates(domains), "gradient/domain/line"), size});
  all.push_back({"slope.integral", of(slope, "gradient/derivative"), 9 * size});
  return all;
}

}  // namespace plumbline
