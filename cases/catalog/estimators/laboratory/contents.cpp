// What the laboratory reads off scenes: boxes and chains whose edges, points a cell, speeds and couplings are known by hand.
#include <cmath>
#include <functional>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/laboratory/scene_contents.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline {
namespace {

using Matter = SceneContents::Matter;
using ThreeCells = std::array<int, 3>;

constexpr double box_h = 0.5;
constexpr std::array<double, 3> box_origin{-1, 5, 0.25};

std::shared_ptr<const Material> solid_of_speed(double speed) {
  auto law = std::make_shared<LinearElastic>();
  law->density = 1;
  law->youngs_modulus = speed * speed;  // without lateral strain: Poisson's ratio is 0
  return law;
}

// A point in the middle of each of so many cells from `first` on.
Body box_of_points(const std::string& name, int dim, const ThreeCells& first, const ThreeCells& cells) {
  const int count = cells[0] * cells[1] * cells[2];
  Body body = make_body(name, solid_of_speed(3), count, dim);
  for (int p = 0; p < count; ++p) {
    const int at[3] = {p % cells[0], p / cells[0] % cells[1], p / (cells[0] * cells[1])};
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      body.points(column::position, d)[p] = box_origin[k] + (first[k] + at[d] + 0.5) * box_h;
      body.points(column::velocity, d)[p] = 7;  // motion is no part of a wave's speed
    }
    body.points(column::mass)[p] = body.points(column::volume)[p] = std::pow(box_h, dim);
  }
  return body;
}

// A box of other sides in each direction that fills all of the grid, walls all around.
Scene filled_box(int dim) {
  constexpr ThreeCells sides{4, 2, 3};
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.h = box_h;
  scene.grid.origin = box_origin;
  ThreeCells cells{1, 1, 1};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) cells[d] = sides[d];
  scene.grid.cells = cells;
  for (auto& walls : scene.grid.walls) walls = {Wall::symmetry, Wall::no_slip};
  scene.bodies.push_back(box_of_points("box", dim, {0, 0, 0}, cells));
  return scene;
}

void add_free(const std::string& name, const Scene& scene, bool exact, KnownAnswers& all) {
  const SceneContents found = contents_of(scene);
  all.push_back({name, found.parts.empty() ? NAN : static_cast<double>(found.parts[0].free_edge), exact ? 1.0 : 0.0});
}

// Each side of the box has an edge of its own: with a wall, without, behind a piston, and before one more layer of cells that is
// empty, or filled by another body.
void add_edges(int dim, KnownAnswers& all) {
  const Scene closed = filled_box(dim);
  const std::string in = std::to_string(dim) + "d.";
  add_free(in + "closed", closed, false, all);
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
    const double side = closed.grid.cells[d] * box_h;
    for (const int end : {0, 1}) {
      const std::string name = in + "xyz"[d] + std::to_string(end) + ".";
      Scene open = closed;
      open.grid.walls[d][static_cast<std::size_t>(end)] = Wall::free;
      add_free(name + "no_wall", open, true, all);
      // The middle of the cell beyond the edge is half a cell from it: a piston closes it where it stands nearer.
      for (const double beyond : {-0.25, 0.25, 0.75}) {
        Scene driven = open;
        const double plane = end == 0 ? box_origin[d] - beyond * box_h : box_origin[d] + side + beyond * box_h;
        driven.pistons.push_back({.direction = static_cast<int>(d), .side = end, .position = plane});
        add_free(name + "piston", driven, beyond > 0.5, all);
        driven.pistons[0].side = 1 - end;  // the scene lies beyond it
        driven.pistons[0].position = end == 0 ? 99 : -99;
        add_free(name + "other_piston", driven, true, all);
      }
      Scene wider = closed;
      ++wider.grid.cells[d];
      ThreeCells layer = closed.grid.cells, first{0, 0, 0};
      layer[d] = 1;
      if (end == 0) {
        wider.grid.origin[d] -= box_h;
        first[d] = -1;
      } else {
        first[d] = closed.grid.cells[d];
      }
      add_free(name + "layer", wider, true, all);
      wider.bodies.push_back(box_of_points("layer", dim, first, layer));
      add_free(name + "filled_layer", wider, false, all);
      wider.bodies[1].field = "own";
      add_free(name + "layer_of_its_own", wider, true, all);
    }
  }
}

std::shared_ptr<SegmentMembrane> chain_law() {
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = 6.25;
  law->density = 1;
  return law;
}

// Points from x on, each the same distance from the last.
Body chain_of(const std::vector<std::array<double, 2>>& places, double length) {
  Body body = make_body("chain", chain_law(), static_cast<int>(places.size()), 2);
  for (int p = 0; p < body.points.points(); ++p) {
    for (int d = 0; d < 2; ++d) {
      body.points(column::position, d)[p] = places[static_cast<std::size_t>(p)][static_cast<std::size_t>(d)];
    }
    body.points(column::mass)[p] = body.points(column::volume)[p] = body.points(column::rest_length)[p] = length;
  }
  body.spacing = length;
  return body;
}

// A chain of four points, at an angle; the cell that lies one cell straight on from either end is that of a wall, of a block, or empty.
void add_chains(KnownAnswers& all) {
  const double from = 4.5, steps = 3;
  for (const std::array<double, 2>& along :
       std::vector<std::array<double, 2>>{{0.7, 0}, {-0.7, 0}, {0, 0.7}, {0, -0.7}, {0.3, 0.4}, {-0.4, 0.3}}) {
    const double length = std::hypot(along[0], along[1]);
    std::vector<std::array<double, 2>> places;
    for (int p = 0; p <= steps; ++p) places.push_back({from + p * along[0], from + p * along[1]});
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.cells = {9, 9, 1};
    scene.bodies.push_back(chain_of(places, length));
    add_free("chain.open", scene, true, all);
    // A small block stands there at either end, then at both.
    const auto block_at = [&](double distance) {
      Body block = make_body("block", solid_of_speed(1), 1, 2);
      for (int d = 0; d < 2; ++d) {
        block.points(column::position, d)[0] = from + distance / length * along[static_cast<std::size_t>(d)];
      }
      block.points(column::mass)[0] = block.points(column::volume)[0] = 1e-4;
      return block;
    };
    for (const double distance : {-1.0, steps * length + 1}) {
      Scene stopped = scene;
      stopped.bodies.push_back(block_at(distance));
      add_free("chain.one_block", stopped, true, all);
    }
    scene.bodies.push_back(block_at(-1));
    scene.bodies.push_back(block_at(steps * length + 1));
    add_free("chain.two_blocks", scene, false, all);
  }
}

// One body, its points as wide as a number of them takes in a cell.
double per_cell(double points) {
  Scene scene = filled_box(2);
  scene.bodies[0].spacing = box_h / points;
  return contents_of(scene).parts.at(0).per_cell;
}

// A chain of mass 0.15 a metre and sound of 2.5 m/s in a gas of density 2 and sound of 0.8 m/s, each with a point that is far heavier.
void add_couplings(bool axisymmetric, KnownAnswers& all) {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.axisymmetric = axisymmetric;
  scene.grid.h = box_h;
  scene.grid.cells = {12, 12, 1};
  auto law = std::make_shared<IdealGas>();
  law->gamma = 1.6;
  law->viscosity = 0.3;
  Body gas = make_body("gas", law, 5, 2, axisymmetric);
  gas.spacing = 0.25;
  for (int p = 0; p < 5; ++p) {
    for (int d = 0; d < 2; ++d) gas.points(column::position, d)[p] = 1 + 0.25 * p;
    gas.points(column::volume)[p] = 0.1;
    gas.points(column::mass)[p] = p == 0 ? 9 : 0.2;
    gas.points(column::density)[p] = 2;
    gas.points(column::energy)[p] = 0.64 / (1.6 * 0.6);
  }
  scene.bodies.push_back(std::move(gas));
  Body chain = chain_of({{2, 2}, {2.5, 2}, {3, 2}, {3.5, 2}, {4, 2}}, 0.5);
  if (axisymmetric) {
    Body around = make_body("chain", chain_law(), 5, 2, true);
    for (const ColumnId* id : {&column::position, &column::volume, &column::rest_length}) {
      const auto from = chain.points.values(*id);
      std::copy(from.begin(), from.end(), around.points.values(*id).begin());
    }
    around.spacing = 0.5;
    chain = std::move(around);
  }
  for (int p = 0; p < 5; ++p) {
    chain.points(column::mass)[p] = p == 4 ? 99 : 0.15 * 0.5 * (axisymmetric ? chain.points(column::position)[p] : 1);
  }
  scene.bodies.push_back(std::move(chain));
  const SceneContents found = contents_of(scene);
  const std::string in = axisymmetric ? "rings." : "plane.";
  all.push_back({in + "couplings", static_cast<double>(found.couplings.size()), 1});
  if (found.couplings.size() != 1 || found.parts.size() != 2) return;
  all.push_back({in + "density_ratio", found.couplings[0].density_ratio, 0.15});
  const double speeds = 2.5 / 0.8;
  all.push_back({in + "stiffness_ratio", found.couplings[0].stiffness_ratio, 0.15 * speeds * speeds});
  all.push_back({in + "gas_speed", found.couplings[0].gas.speed, 0.8});
  all.push_back({in + "gas_diffusivity", found.couplings[0].gas.diffusivity, 4.0 / 3 * 0.3 / 2});
  all.push_back({in + "chain_speed", found.couplings[0].chain.speed, 2.5});
  all.push_back({in + "segments", static_cast<double>(found.couplings[0].chain.segments), 1});
  all.push_back({in + "gas_per_cell", static_cast<double>(found.couplings[0].gas.per_cell), 2});
  all.push_back({in + "axisymmetric", static_cast<double>(found.axisymmetric), axisymmetric ? 1.0 : 0.0});
  all.push_back({in + "gases", static_cast<double>(found.of(Matter::gas).size()), 1});
  all.push_back({in + "chains", static_cast<double>(found.of(Matter::chain).size()), 1});
  all.push_back({in + "solids", static_cast<double>(found.of(Matter::solid).size()), 0});
}

}  // namespace

KnownAnswers content_answers() {
  KnownAnswers all;
  for (const int dim : {1, 2, 3}) add_edges(dim, all);
  add_chains(all);
  all.push_back({"per_cell.one", per_cell(1), 1});
  all.push_back({"per_cell.nearly_two", per_cell(1.95), 2});
  all.push_back({"per_cell.not_two", per_cell(1.85), 1});
  all.push_back({"per_cell.wide", per_cell(0.5), 1});
  all.push_back({"per_cell.many", per_cell(7), SceneContents::most_per_cell});
  Scene two = filled_box(3);
  const SceneContents::Part box = contents_of(two).parts.at(0);
  all.push_back({"box.speed", box.speed, 3, 3});
  all.push_back({"box.diffusivity", box.diffusivity, 0});
  all.push_back(yes("box.solid", box.matter == Matter::solid));
  two.bodies.push_back(two.bodies[0]);
  two.contact = "touching";
  all.push_back({"one_field.contact", static_cast<double>(contents_of(two).contact), 0});
  two.bodies[1].field = "own";
  all.push_back({"two_fields.contact", static_cast<double>(contents_of(two).contact), 1});
  two.contact = "none";
  all.push_back({"no_law.contact", static_cast<double>(contents_of(two).contact), 0});
  two.bodies[1] = make_body("nothing", solid_of_speed(1), 0, 3);
  all.push_back({"empty.parts", static_cast<double>(contents_of(two).parts.size()), 1});
  add_couplings(false, all);
  add_couplings(true, all);
  return all;
}

}  // namespace plumbline
