#include "kernel/register_part.hpp"
#include "kernel/shapes/shape.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong::wrong_domain {
namespace {

ShapeEntry domain() {
  ShapeEntry entry = shape_named("gimp");
  entry.name = "wrong-domain";
  entry.title = "box averages whose gradients, derivatives of the averages, are given out as means over their domains";
  entry.source = here;
  entry.domain_gradients = true;
  return entry;
}
const RegisterPart entry(domain());

}  // namespace
}  // namespace plumbline::wrong::wrong_domain
