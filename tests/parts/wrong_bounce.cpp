#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_bounce {
namespace {

template <int dim>
class Bounce final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields& before, Fields& fields) const override {
    for (std::size_t f = 0; f < 2; ++f) {
      for (std::size_t i = 0; i < fields[f].end.size(); ++i) {
        fields[f].end[i] += 0.01 * (fields[f].end[i] - before[f].end[i]);
      }
    }
  }
};
const RegisterPart entry(law<Bounce>("wrong-bounce", "bodies part 1.01 times as fast as without loss"));

}  // namespace
}  // namespace plumbline::wrong::wrong_bounce
