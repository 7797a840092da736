#include "reference/line_contact.hpp"

#include <cmath>
#include <numbers>

namespace plumbline::reference {

double LineContact::half_width() const {  // [Johnson 4.2]
  return std::sqrt(8 * force * radius * (1 - poisson * poisson) / (std::numbers::pi * youngs_modulus));
}

double LineContact::approach(double depth) const {  // [Johnson 5.6]
  const double a = half_width(), scale = force * (1 - poisson * poisson) / (std::numbers::pi * youngs_modulus);
  return scale * (2 * std::log(4 * radius / a) - 1 + 2 * std::log(2 * depth / a) - poisson / (1 - poisson));
}

double LineContact::creep(double friction, double pull) const {  // [Johnson 8.3]
  return friction * half_width() / radius * (1 - std::sqrt(1 - pull / (friction * force)));
}

}  // namespace plumbline::reference
