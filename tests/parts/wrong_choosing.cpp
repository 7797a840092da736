#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_choosing {
namespace {

template <int dim>
class Choosing final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields, typename AroundTouching<dim>::Visit;
  void apply(Fields& fields, double dt, bool, const Visit& visit) override {
    AroundTouching<dim>::apply(fields, dt, true, visit);
  }

 private:
  void alter(const Fields&, Fields&) const override {}
};
const RegisterPart entry(law<Choosing>("wrong-choosing", "nodes in contact are chosen anew in every pass of a step"));

}  // namespace
}  // namespace plumbline::wrong::wrong_choosing
