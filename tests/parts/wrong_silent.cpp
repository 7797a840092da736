#include "tests/parts/around_touching.hpp"

namespace plumbline::wrong::wrong_silent {
namespace {

template <int dim>
class Silent final : public AroundTouching<dim> {
 public:
  using AroundTouching<dim>::AroundTouching;
  using typename AroundTouching<dim>::Fields;

 private:
  void alter(const Fields&, Fields&) const override {}
  bool tells() const override { return false; }
};
const RegisterPart entry(law<Silent>("wrong-silent", "contact tells of none of its changes"));

}  // namespace
}  // namespace plumbline::wrong::wrong_silent
