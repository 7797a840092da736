#include "reference/drum.hpp"

#include "reference/argument.hpp"
#include "reference/bessel.hpp"
#include "reference/equal_stretches.hpp"

namespace plumbline::reference {

Drum::Drum(const DrumProblem& problem)
    : radius_(problem.radius),
      tension_(problem.tension),
      area_density_(problem.area_density) {
  check_positive("radius", problem.radius);
  check_positive("tension", problem.tension);
  check_positive("area_density", problem.area_density);
}

Drum drum_of(const PrestretchedSheet& sheet) {
  const EqualStretches law{sheet.youngs_modulus, sheet.poisson_ratio, false};
  check_law(law);
  check_positive("thickness", sheet.thickness);
  check_positive("density", sheet.density);
  check({"stretch", 0, 1, rounding::infinity, true, true, "", ""}, sheet.stretch);
  check_positive("radius", sheet.radius);
  Drum drum;
  drum.radius_ = sheet.radius;
  drum.tension_ = Bounded(sheet.thickness) * law.stress(sheet.stretch);
  drum.area_density_ = Bounded(sheet.density) * sheet.thickness / (Bounded(sheet.stretch) * sheet.stretch);
  return drum;
}

Bounded Drum::wave_speed() const { return sqrt(tension_ / area_density_); }

Bounded Drum::omega(int around, int across) const {
  return bessel_zero_J(around, across) / radius_ * wave_speed();  // [Surface 9]
}

Bounded Drum::shape(int around, double r, int across) const {
  check_within("position", r, 0, radius_);
  return bessel_J(around, bessel_zero_J(around, across) * r / radius_);  // [Surface 9]
}

}  // namespace plumbline::reference
