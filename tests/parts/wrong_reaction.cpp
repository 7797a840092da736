#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_reaction {
namespace {

template <int dim>
class Reaction final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields& before, Fields& fields) const override {
    for (std::size_t i = 0; i < fields[1].end.size(); ++i) {
      fields[1].end[i] += 1e-6 * (fields[1].end[i] - before[1].end[i]);
    }
  }
};
const RegisterPart entry(law<Reaction>("wrong-reaction",
                                       "the second body is given 1.000001 of what the first gives it"));

}  // namespace
}  // namespace plumbline::wrong::wrong_reaction
