#include "kernel/points/body.hpp"

#include <numeric>
#include <utility>

#include "kernel/geometry.hpp"

namespace plumbline {

Body make_body(std::string name, std::shared_ptr<const Material> material, int points, int dim, bool axisymmetric) {
  const int strains = material->isotropic() ? 1 : strain_components(dim, axisymmetric);
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

}  // namespace plumbline
