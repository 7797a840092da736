#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_passing {
namespace {

template <int dim>
class Passing final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields& before, Fields& fields) const override { fields = before; }
};
const RegisterPart entry(law<Passing>("wrong-passing", "bodies that touch pass through each other"));

}  // namespace
}  // namespace plumbline::wrong::wrong_passing
