#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_pull {
namespace {

template <int dim>
class Pull final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields& before, Fields& fields) const override {
    for (std::size_t f = 0; f < 2; ++f) {
      for (std::size_t i = 0; i < fields[f].end.size(); ++i) {
        fields[f].end[i][0] = 2 * before[f].end[i][0] - fields[f].end[i][0];
      }
    }
  }
};
const RegisterPart entry(law<Pull>("wrong-pull", "impulses in the first direction pull"));

}  // namespace
}  // namespace plumbline::wrong::wrong_pull
