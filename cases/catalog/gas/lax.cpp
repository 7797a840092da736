// Lax's shock tube.
#include "cases/catalog/gas/tube_case.hpp"

namespace plumbline::lax {
namespace {

Case lax() {
  return tube_case({.name = "lax", .tube = {{{0.445, 0.698, 3.528}, {0.5, 0, 0.571}, 1.4}, 0, 1, 0.5, 0.16}});
}
PLUMBLINE_CASE(lax);

}  // namespace
}  // namespace plumbline::lax
