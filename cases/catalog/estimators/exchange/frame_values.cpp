// What snapshots hold of a point: pressures and stresses that a scene gives, in each geometry, and those of membranes.
#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/given_stress.hpp"
#include "cases/harness/run/frames.hpp"
#include "kernel/materials/carried_membrane.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

// Points on a row along (3, 4)/5 or, on a line, along it; half a metre apart.
Body row_of_points(const std::shared_ptr<const Material>& material, int points, int dim, bool rings) {
  Body body = make_body("row", material, points, dim, rings);
  for (int p = 0; p < points; ++p) {
    for (int d = 0; d < dim; ++d) {
      body.points(column::position, d)[p] = 1.5 + (dim == 1 ? 0.5 : d == 0 ? 0.3 : d == 1 ? 0.4 : 0) * p;
    }
    body.points(column::mass)[p] = body.points(column::volume)[p] = 0.125;
  }
  return body;
}

FrameSet first_frame(Body body, int dim, bool rings) {
  Scene scene;
  scene.grid.dim = dim;
  scene.grid.axisymmetric = rings;
  scene.grid.h = 0.5;
  scene.grid.cells = {8, dim > 1 ? 8 : 1, dim > 2 ? 8 : 1};
  scene.bodies.push_back(std::move(body));
  const Simulation simulation(std::move(scene), "usl", {.dt = 0.25});
  FrameRecorder recorder({2, 0}, simulation.scene(), 1);
  recorder.look(simulation);
  return recorder.take();
}

struct ToBeSeen {
  std::string kind, material;
  bool chain = false, closed = false;
  std::vector<double> pressure, stress;  // of each point
};

void add_seen(const std::string& name, const FrameSet& set, const ToBeSeen& exact, KnownAnswers& all) {
  const FrameSet::BodyInfo& body = set.bodies.at(0);
  const bool described = body.name == "row" && body.material == exact.material && body.kind == exact.kind;
  all.push_back(yes(name + ".described", described));
  all.push_back(whether(name + ".chain", body.chain, exact.chain));
  all.push_back(whether(name + ".closed", body.closed, exact.closed));
  all.push_back({name + ".pressure", farthest(set.frames.at(0).pressure, exact.pressure), 0});
  all.push_back({name + ".stress", farthest(set.frames.at(0).stress, exact.stress), 0});
}

struct StressByHand {
  std::string name;
  int dim;
  bool rings;
  StressMeasure measure;
  std::vector<double> components;
  double pressure, difference;
};

// In the plane the principal stresses of (5, 1.5; 1.5, 1) are 3 +- 2.5. In space they are 9, -9 and 18 along the rows of
// (1, 2, 2; 2, 1, -2; 2, -2, 1)/3. Of full matrices the symmetric part counts.
const std::vector<StressByHand> stresses_by_hand{
    {"line", 1, false, StressMeasure::symmetric, {-3}, 3, 3},
    {"line.full", 1, false, StressMeasure::full, {-3}, 3, 3},
    {"plane", 2, false, StressMeasure::symmetric, {5, 1, 1.5}, -3, 5},
    {"plane.full", 2, false, StressMeasure::full, {5, 2, 1, 1}, -3, 5},
    {"rings", 2, true, StressMeasure::symmetric, {5, 1, 9, 1.5}, -5, 8.5},
    {"rings.full", 2, true, StressMeasure::full, {5, 2, 1, 1, -6}, 0, 11.5},
    {"space", 3, false, StressMeasure::symmetric, {5, 11, 2, 2, 10, -8}, -6, 27},
    {"space.full", 3, false, StressMeasure::full, {5, -7, 11, -9, 11, 3, 9, 1, 2}, -6, 27}};

// The second point has twice the stress of the first.
void add_solids(KnownAnswers& all) {
  for (const StressByHand& one : stresses_by_hand) {
    Body body = row_of_points(std::make_shared<GivenStress>(one.measure), 2, one.dim, one.rings);
    for (std::size_t k = 0; k < one.components.size(); ++k) {
      for (int p = 0; p < 2; ++p) body.points(column::stress, static_cast<int>(k))[p] = (p + 1) * one.components[k];
    }
    const std::vector<double> pressures{one.pressure, 2 * one.pressure}, stresses{one.difference, 2 * one.difference};
    add_seen(one.name, first_frame(std::move(body), one.dim, one.rings),
             {.kind = "solid", .material = "given-stress", .pressure = pressures, .stress = stresses}, all);
  }
}

void add_gas(KnownAnswers& all) {
  Body body = row_of_points(std::make_shared<GivenStress>(StressMeasure::pressure), 2, 2, false);
  for (int p = 0; p < 2; ++p) body.points(column::pressure)[p] = 2.5 + p;
  add_seen("gas", first_frame(std::move(body), 2, false),
           {.kind = "gas", .material = "given-stress", .pressure = {2.5, 3.5}, .stress = {NAN, NAN}}, all);
}

// E = 4 Pa, strains of a quarter, a half and three quarters.
void add_layer(const std::string& name, int dim, bool closed, KnownAnswers& all) {
  auto law = std::make_shared<UniaxialMembrane>();
  law->youngs_modulus = 4;
  law->density = 1;
  law->closed = closed;
  Body body = row_of_points(law, 3, dim, false);
  if (closed) body.points(column::position, 1)[1] += 0.5;  // a triangle
  for (int p = 0; p < 3; ++p) body.points(column::strain)[p] = 0.25 * (p + 1);
  add_seen(name, first_frame(std::move(body), dim, false),
           {.kind = "membrane",
            .material = "uniaxial_membrane",
            .chain = true,
            .closed = closed,
            .pressure = {NAN, NAN, NAN},
            .stress = {1, 2, 3}},
           all);
}

// Segments of which the second is strained twice as much as the first. The last point of an open chain has the stress of the
// segment before it; that of a closed one starts a segment, from the third point to the first, of one metre.
std::shared_ptr<SegmentMembrane> stretched_segments(bool closed, bool revolved) {
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = revolved ? 3 : 4;
  law->density = 1;
  law->section = 0.5;
  law->closed = closed;
  law->revolved = revolved;
  law->poissons_ratio = revolved ? 0.5 : 0;
  return law;
}
ToBeSeen of_segments(bool closed, std::vector<double> stress) {
  return {.kind = "membrane",
          .material = "segment_membrane",
          .chain = true,
          .closed = closed,
          .pressure = {NAN, NAN, NAN},
          .stress = std::move(stress)};
}
void add_segments(const std::string& name, bool closed, KnownAnswers& all) {
  Body body = row_of_points(stretched_segments(closed, false), 3, 2, false);
  const double rest[] = {0.5 / 1.25, 0.5 / 1.5, 1 / 1.125};
  for (int p = 0; p < 3; ++p) body.points(column::rest_length)[p] = rest[p];
  add_seen(name, first_frame(std::move(body), 2, false), of_segments(closed, {1, 2, closed ? 0.5 : 2}), all);
}

// Bands with E = 3 Pa and nu = 1/2, so that E / (1 - nu^2) = 4 Pa: 4 (eps + eps_h / 2), eps_h = 1/4.
void add_bands(KnownAnswers& all) {
  Body body = row_of_points(stretched_segments(false, true), 3, 2, true);
  const double rest[] = {0.5 / 1.25, 0.5 / 1.5, 1};
  for (int p = 0; p < 3; ++p) {
    body.points(column::rest_length)[p] = rest[p];
    body.points(column::rest_radius)[p] = (1.5 + 0.3 * (p + 0.5)) / 1.25;
  }
  add_seen("bands", first_frame(std::move(body), 2, true), of_segments(false, {1.5, 2.5, 2.5}), all);
}

// Tangents (3/2, 0, 0) and (0, 0, 2), E = 2 Pa, nu = 0: S = 2 (c - 1)/2 = (1.25, 3), of which the larger resultant is
// 3 c_22 / (3/2 2) = 4.
void add_sheet(KnownAnswers& all) {
  auto law = std::make_shared<CarriedMembrane>();
  law->youngs_modulus = 2;
  law->density = law->thickness = 1;
  Body body = row_of_points(law, 2, 3, false);
  for (int p = 0; p < 2; ++p) {
    body.points(column::tangents, 0)[p] = 1.5;
    body.points(column::tangents, 5)[p] = 2;
  }
  add_seen("sheet", first_frame(std::move(body), 3, false),
           {.kind = "membrane", .material = "carried_membrane", .pressure = {NAN, NAN}, .stress = {4, 4}}, all);
}

}  // namespace

KnownAnswers frame_value_answers() {
  KnownAnswers all;
  add_solids(all);
  add_gas(all);
  add_layer("layer", 2, false, all);
  add_layer("layer.line", 1, false, all);
  add_layer("layer.closed", 2, true, all);
  add_segments("segments", false, all);
  add_segments("segments.closed", true, all);
  add_bands(all);
  add_sheet(all);
  return all;
}

}  // namespace plumbline
