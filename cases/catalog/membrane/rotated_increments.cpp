#include "cases/catalog/membrane/rotated_increments.hpp"

#include <memory>
#include <vector>

#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

const ColumnId summed_strain{"summed_strain", "1"};  // xx, yy, xy

struct RotatedIncrements final : UniaxialMembrane {
  explicit RotatedIncrements(const UniaxialMembrane& of) : UniaxialMembrane(of) {}

  std::string name() const override { return "rotated_increments"; }
  void add_columns(Columns& points, int dim) const override {
    UniaxialMembrane::add_columns(points, dim);
    points.add(summed_strain, 3);
  }

  double advance(Columns& points, PointRange range, const MaterialContext& context, double dt) const override {
    const double* strain = points(column::strain);
    const std::vector<double> before(strain + range.first, strain + range.last);
    const double stored = UniaxialMembrane::advance(points, range, context, dt);
    const double *tx = points(column::tangent), *ty = points(column::tangent, 1);
    for (int p = range.first; p < range.last; ++p) {
      const double increment = strain[p] - before[static_cast<std::size_t>(p - range.first)];
      points(summed_strain)[p] += increment * tx[p] * tx[p];
      points(summed_strain, 1)[p] += increment * ty[p] * ty[p];
      points(summed_strain, 2)[p] += increment * tx[p] * ty[p];
    }
    return stored;
  }

  void evaluate_stress(Columns& points, PointRange range, const MaterialContext& context) const override {
    UniaxialMembrane::evaluate_stress(points, range, context);
    for (int p = range.first; p < range.last; ++p) {
      const bool carries = !one_way || points(column::strain)[p] > 0;
      for (int k = 0; k < 3; ++k) {
        points(column::stress, k)[p] = carries ? modulus() * points(summed_strain, k)[p] : 0.0;
      }
    }
  }
};

}  // namespace

void rotate_increments_once(Body& body) {
  auto material = std::make_shared<RotatedIncrements>(dynamic_cast<const UniaxialMembrane&>(*body.material));
  material->add_columns(body.points, 2);
  body.material = std::move(material);
}

}  // namespace plumbline
