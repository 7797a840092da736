#include "cases/harness/parts/shape_gates.hpp"

#include <cmath>
#include <utility>

namespace plumbline {
ShapeSubject::ShapeSubject(const ShapeEntry& shape, std::size_t geometry_)
    : entry(&shape),
      geometry(geometry_),
      walled(probe(shape, geometry, probe_grid(geometry, true))),
      open(probe(shape, geometry, probe_grid(geometry, false))) {}

double ShapeSubject::larger_of_both(const std::function<double(const ShapeProbe&)>& measure) const {
  const double a = measure(*walled), b = measure(*open);
  return std::isnan(a) || a > b ? a : b;
}

Eigen::MatrixXd random_field(const ShapeProbe& probe, unsigned long seed) {
  ProbeRandom random(seed);
  return Eigen::MatrixXd::NullaryExpr(probe.nodes(), probe.grid().dim, [&] { return random(-1, 1); });
}

std::vector<MeasuredGate> shape_gates(const ShapeEntry& shape) {
  std::vector<MeasuredGate> all;
  for (std::size_t geometry = 0; geometry < geometry_names().size(); ++geometry) {
    const auto subject = std::make_shared<const ShapeSubject>(shape, geometry);
    for (auto* rows :
         {shape_identity_gates, shape_support_gates, shape_path_gates, shape_domain_gates, shape_order_gates}) {
      std::vector<MeasuredGate> some = rows(subject);
      std::move(some.begin(), some.end(), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace plumbline
