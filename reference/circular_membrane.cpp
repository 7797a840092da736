#include "reference/circular_membrane.hpp"

#include "reference/shooting.hpp"

namespace plumbline::reference {
namespace {

/// Clamped at the rim.
struct ClampedShot {
  static constexpr const char* refusal = "less: the sheet overhangs its rim";
  TautSheet sheet;
  double middle_strain;
  TautSheet::Point rim{};

  ClampedShot(const SheetSettings& settings, double strain) : sheet(settings, strain, false), middle_strain(strain) {
    if (sheet.reaches_rim()) rim = sheet.at(1);
  }

  /// In parts of the strain in the middle: of small strains r - 1 knows few digits.
  double excess() const { return sheet.reaches_rim() ? rim.hoop_strain / middle_strain : -1; }
  std::vector<double> numbers() const { return {rim.drop, sheet.at(0).meridian, rim.volume}; }

  std::array<double, 5> at(double s) const {
    const TautSheet::Point p = sheet.at(s);
    return {p.radius, rim.drop - p.drop, p.meridian, p.hoop, std::sqrt(1 + 2 * p.meridian_strain)};
  }
};

}  // namespace

struct CircularMembrane::Solution {
  Shooting<ClampedShot> shooting;
};

void check_circular_membrane(const CircularMembraneProblem& problem) {
  check_within("load", problem.load, 1e-9, 1);
  check_within("poisson_ratio", problem.poisson_ratio, 0, 0.5);
  check_positive("radius", problem.radius);
}

CircularMembrane::CircularMembrane(const CircularMembraneProblem& problem) : radius_(problem.radius) {
  check_circular_membrane(problem);
  solution_ = std::make_shared<const Solution>(Solution{{problem.load, problem.poisson_ratio}});
}

Bounded CircularMembrane::height() const { return solution_->shooting.number(0) * radius_; }
Bounded CircularMembrane::stress() const { return solution_->shooting.number(1); }
Bounded CircularMembrane::volume() const { return solution_->shooting.number(2) * radius_ * radius_ * radius_; }
MembranePoint CircularMembrane::at(double s) const { return solution_->shooting.at(s, radius_); }

}  // namespace plumbline::reference
