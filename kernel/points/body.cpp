#include "kernel/points/body.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace plumbline {

Body make_body(std::string name, std::shared_ptr<const Material> material, int points, int dim, bool axisymmetric) {
  const int strains = stress_components(material->measure(), dim, axisymmetric);
  Body body;
  body.name = std::move(name);
  body.points = Columns(points);
  body.points.add(column::position, dim);
  body.points.add(column::velocity, dim);
  body.points.add(column::mass);
  body.points.add(column::volume);
  body.points.add(column::strain_rate, strains);
  body.points.add(column::stress, strains);
  body.id.resize(static_cast<std::size_t>(points));
  std::iota(body.id.begin(), body.id.end(), 0);
  body.chain = material->chain();
  material->add_columns(body.points, dim);
  body.material = std::move(material);
  return body;
}

double point_spacing(const Body& body, int p, int dim, bool axisymmetric) {
  if (body.spacing > 0) return body.spacing;
  double volume = body.points(column::volume)[p];
  if (axisymmetric) volume /= body.points(column::position)[p];
  return std::pow(volume, 1.0 / dim);
}

}  // namespace plumbline
