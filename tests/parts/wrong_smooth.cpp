#include "kernel/shapes/linear.hpp"
#include "tests/parts/wrong_shape.hpp"

namespace plumbline::wrong::wrong_smooth {
namespace {

struct Smooth : Linear {
  static constexpr bool smooth_gradients = true;
};
const RegisterPart entry(shape<Smooth>("wrong-smooth", "tents that offer gradients continuous across cells"));

}  // namespace
}  // namespace plumbline::wrong::wrong_smooth
