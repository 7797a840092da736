#include "kernel/materials/surface_membrane.hpp"

#include <cmath>
#include <stdexcept>

#include "kernel/materials/material_entry.hpp"
#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// Positions of all points, and how they move.
struct Places {
  const double *x[3], *v[3];
  explicit Places(const Columns& points) {
    for (int d = 0; d < 3; ++d) {
      x[d] = points(column::position, d);
      v[d] = points(column::strain_rate, d);
    }
  }
};

// Two vectors in space, f_1 and f_2 or their rates.
struct Pair {
  double first[3] = {}, second[3] = {};

  SurfaceLaw::Metric metric() const {
    SurfaceLaw::Metric c{0, 0, 0};
    for (int d = 0; d < 3; ++d) {
      c.first += first[d] * first[d];
      c.mixed += first[d] * second[d];
      c.second += second[d] * second[d];
    }
    return c;
  }
};

// sum_k c_pka q_k.
Pair weighted(const SurfaceNeighbours::Links& of, int p, const double* const (&q)[3]) {
  Pair sum;
  for (int k = of.first[at(p)]; k < of.first[at(p) + 1]; ++k) {
    const int other = of.other[at(k)];
    const double along = of.along[at(k)], across = of.across[at(k)];
    for (int d = 0; d < 3; ++d) {
      sum.first[d] += along * q[d][other];
      sum.second[d] += across * q[d][other];
    }
  }
  return sum;
}

// As they will be `ahead` seconds later, if points keep the velocities in the strain_rate column. [Surface 1]
Pair tangents_of(const SurfaceNeighbours& all, const Places& places, int p, double ahead) {
  Pair f = weighted(all.of, p, places.x);
  if (!all.fixed.empty()) {
    for (int d = 0; d < 3; ++d) {
      f.first[d] += all.fixed[at(6 * p + d)];
      f.second[d] += all.fixed[at(6 * p + 3 + d)];
    }
  }
  if (ahead != 0) {
    const Pair rate = weighted(all.of, p, places.v);
    for (int d = 0; d < 3; ++d) {
      f.first[d] += ahead * rate.first[d];
      f.second[d] += ahead * rate.second[d];
    }
  }
  return f;
}

// Both vectors of a point in a column of six components.
struct PairColumn {
  double* at[6];
  PairColumn(Columns& points, const ColumnId& id) {
    for (int k = 0; k < 6; ++k) at[k] = points(id, k);
  }
  double dot(int p, const Pair& other) const {
    double sum = 0;
    for (int d = 0; d < 3; ++d) sum += at[d][p] * other.first[d] + at[3 + d][p] * other.second[d];
    return sum;
  }
  void set(int p, const Pair& value) const {
    for (int d = 0; d < 3; ++d) {
      at[d][p] = value.first[d];
      at[3 + d][p] = value.second[d];
    }
  }
};

const RegisterPart surface_membrane_entry(material_entry<SurfaceMembrane>(
    "a membrane in space, strained as the surface through its points", "reports/docs/theory/membranes.md",
    {{"youngs_modulus", "Pa", &SurfaceMembrane::youngs_modulus},
     {"poissons_ratio", "1", &SurfaceMembrane::poissons_ratio},
     {"density", "kg/m^3", &SurfaceMembrane::density},
     {"thickness", "m", &SurfaceMembrane::thickness},
     {"one_way", &SurfaceMembrane::one_way},
     {"neo_hookean", &SurfaceMembrane::neo_hookean},
     {"reach", "1", &SurfaceMembrane::reach}}));

}  // namespace

void SurfaceMembrane::add_columns(Columns& points, int dim) const {
  refuse_what_cannot_work(dim);
  points.add(column::tangents, 6);
  points.add(column::surface_pull, 6);
  points.add(column::surface_energy);
}

double SurfaceMembrane::spacing(const Columns& points) const {
  const auto volumes = points.values(column::volume);
  double sum = 0;
  for (const double v : volumes) sum += v;
  return std::sqrt(sum / thickness / points.points());
}

std::shared_ptr<const Material> SurfaceMembrane::of_rest(const Columns& points) const {
  return of_rest(points, {}, {});
}

std::shared_ptr<const SurfaceMembrane> SurfaceMembrane::of_rest(const Columns& points,
                                                                const std::vector<OddImage>& images,
                                                                const std::vector<int>& sheet,
                                                                const std::vector<std::array<double, 3>>& outward,
                                                                const std::vector<std::vector<int>>& given) const {
  auto own = std::make_shared<SurfaceMembrane>(*this);
  own->neighbours = std::make_shared<const SurfaceNeighbours>(
      surface_neighbours(points, reach * spacing(points), images, sheet, outward, given));
  return own;
}

const SurfaceNeighbours& SurfaceMembrane::known() const {
  if (!neighbours) throw std::logic_error("a surface_membrane knows no neighbours: of_rest() comes first");
  return *neighbours;
}

std::vector<const ColumnId*> SurfaceMembrane::internal_variables(const MaterialContext&) const {
  return {&column::surface_energy};
}

void SurfaceMembrane::prepare_stress(Columns& points, PointRange range, const MaterialContext& context) const {
  const SurfaceNeighbours& all = known();
  const Places places(points);
  const PairColumn tangents(points, column::tangents), pull(points, column::surface_pull);
  const double* volume = points(column::volume);
  for (int p = range.first; p < range.last; ++p) {
    const Pair f = tangents_of(all, places, p, context.ahead);
    const State s = state(f.metric());
    Pair t;
    for (int d = 0; d < 3; ++d) {
      t.first[d] = volume[p] * (s.first * f.first[d] + s.mixed * f.second[d]);
      t.second[d] = volume[p] * (s.mixed * f.first[d] + s.second * f.second[d]);
    }
    tangents.set(p, f);
    pull.set(p, t);
  }
}

void SurfaceMembrane::evaluate_stress(Columns& points, PointRange range, const MaterialContext&) const {
  const SurfaceNeighbours::Links& on = known().on;
  const PairColumn pull(points, column::surface_pull);
  const double* volume = points(column::volume);
  double* stress[3] = {points(column::stress, 0), points(column::stress, 1), points(column::stress, 2)};
  for (int p = range.first; p < range.last; ++p) {
    double sum[3] = {};
    for (int k = on.first[at(p)]; k < on.first[at(p) + 1]; ++k) {
      const int other = on.other[at(k)];
      const double along = on.along[at(k)], across = on.across[at(k)];
      for (int d = 0; d < 3; ++d) sum[d] += along * pull.at[d][other] + across * pull.at[3 + d][other];
    }
    for (int d = 0; d < 3; ++d) stress[d][p] = sum[d] / volume[p];  // -F_p / V_p [Surface 3]
  }
}

// What of the stored energy the forces' work does not account for is the point's own loss, or gain.
double SurfaceMembrane::advance(Columns& points, PointRange range, const MaterialContext&, double dt) const {
  const SurfaceNeighbours& all = known();
  const Places places(points);
  const PairColumn tangents(points, column::tangents), pull(points, column::surface_pull);
  const double* volume = points(column::volume);
  double* energy = points(column::surface_energy);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) {
    const Pair f = tangents_of(all, places, p, 0);
    const double change = volume[p] * state(f.metric()).energy - energy[p];
    tangents.set(p, f);
    energy[p] += change;
    stored += change;
    if (loss) loss[p] += dt * pull.dot(p, weighted(all.of, p, places.v)) - change;  // [Coupling 1]
  }
  return stored;
}

std::vector<double> SurfaceMembrane::rates(const Columns& points, const MaterialContext&) const {
  std::vector<double> all(at(points.points()));
  const Places places(points);
  for (int p = 0; p < points.points(); ++p) {
    const Pair rate = weighted(known().of, p, places.v);
    for (int d = 0; d < 3; ++d) {
      all[at(p)] += points(column::surface_pull, d)[p] * rate.first[d] +
                    points(column::surface_pull, 3 + d)[p] * rate.second[d];
    }
  }
  return all;
}

double SurfaceMembrane::stored_energy(const Columns& points, PointRange range) const {
  const double* energy = points(column::surface_energy);
  double sum = 0;
  for (int p = range.first; p < range.last; ++p) sum += energy[p];
  return sum;
}

void SurfaceMembrane::describe(Columns& points) const {
  const Places places(points);
  const PairColumn tangents(points, column::tangents);
  for (int p = 0; p < points.points(); ++p) {
    const Pair f = tangents_of(known(), places, p, 0);
    tangents.set(p, f);
    points(column::surface_energy)[p] = points(column::volume)[p] * state(f.metric()).energy;
  }
}

StepBounds SurfaceMembrane::step_bounds(const Columns& points, PointRange range, int dim) const {
  return {.fastest = fastest_wave(points, range.first, range.last) + fastest_point(points, range, dim)};
}

Material::Fault SurfaceMembrane::first_fault(const Columns& points, PointRange range) const {
  const Fault fault = first_not_finite(points, range, column::surface_energy,
                                       "the energy of a membrane must be finite");
  if (fault.point >= 0) return fault;
  for (int p = range.first; p < range.last; ++p) {
    const double area = metric_of(points, p).determinant();
    if (!(area > 0)) return {p, column::tangents.name(), area, "the tangents of a membrane point span no area"};
  }
  return {};
}

}  // namespace plumbline
