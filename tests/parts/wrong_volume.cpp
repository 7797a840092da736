#include "tests/parts/around_quadratic.hpp"

namespace plumbline::wrong::wrong_volume {
namespace {

template <class Geometry>
struct Volume final : AroundQuadratic<Geometry> {
  using Base = AroundQuadratic<Geometry>;
  using Base::Base;
  std::vector<double> inverse_volumes() const override {
    std::vector<double> all = Base::inverse_volumes();
    for (std::size_t i = all.size(); i-- > 0;) {
      if (all[i] == 0) continue;
      all[i] /= 1.001;
      break;
    }
    return all;
  }
};
const RegisterPart entry(shape_around<Volume>("wrong-volume",
                                              "quadratic B-splines whose last node has 1.001 of its volume"));

}  // namespace
}  // namespace plumbline::wrong::wrong_volume
