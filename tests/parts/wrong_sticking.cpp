#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_sticking {
namespace {

template <int dim>
class Sticking final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields& before, Fields& fields) const override {
    for (std::size_t i = 0; i < fields[0].end.size(); ++i) {
      const double a = fields[0].mass[i], b = fields[1].mass[i];
      if (!(a > least_mass && b > least_mass)) continue;
      fields[0].end[i] = fields[1].end[i] = (a * before[0].end[i] + b * before[1].end[i]) / (a + b);
    }
  }
};
const RegisterPart entry(law<Sticking>("wrong-sticking", "bodies that touch move in common, also where they part"));

}  // namespace
}  // namespace plumbline::wrong::wrong_sticking
