// Membranes, drums, spheres.
#include "cases/catalog/estimators/references/refused.hpp"
#include "reference/circular_membrane.hpp"
#include "reference/drum.hpp"
#include "reference/pressurised_sphere.hpp"
#include "reference/tension_field.hpp"
#include "reference/twisted_annulus.hpp"

namespace plumbline::reference::refused_problems {
namespace {

void add_flat_sheets(KnownAnswers& all) {
  using D = DrumProblem;
  Refused<Drum, D>(all, "drum")
      .positive({{"radius", &D::radius}, {"tension", &D::tension}, {"area_density", &D::area_density}})
      .refuses_argument("position", [](const Drum& d) { d.shape(1, -1e-9); })
      .refuses_argument("position", [](const Drum& d) { d.shape(1, 1 + 1e-9); });
  using P = PrestretchedSheet;
  struct Stretched {
    explicit Stretched(const P& sheet) { drum_of(sheet); }
  };
  Refused<Stretched, P>(all, "stretched_drum")
      .positive({{"youngs_modulus", &P::youngs_modulus},
                 {"thickness", &P::thickness},
                 {"density", &P::density},
                 {"radius", &P::radius}})
      .between("poisson_ratio", &P::poisson_ratio, -1, 0.5, false, true)
      .above("stretch", &P::stretch, 1);
  using T = TensionFieldProblem;
  Refused<TensionField, T>(all, "tension_field")
      .positive({{"youngs_modulus", &T::youngs_modulus},
                 {"thickness", &T::thickness},
                 {"density", &T::density},
                 {"stretch", &T::stretch},
                 {"half_side", &T::half_side}})
      .between("poisson_ratio", &T::poisson_ratio, -1, 0.5, false, true)
      .between("shear", &T::shear, 0, 1, true, false);
  using A = TwistedAnnulusProblem;
  Refused<TwistedAnnulus, A>(all, "annulus")
      .positive({{"youngs_modulus", &A::youngs_modulus}, {"thickness", &A::thickness}})
      .refuses("poisson_ratio", &A::poisson_ratio, -1e-9)
      .refuses("poisson_ratio", &A::poisson_ratio, 0.5)  // taut across its lines
      .takes("poisson_ratio", &A::poisson_ratio, 0)
      .refuses("inner_radius", &A::inner_radius, 0)
      .refuses("outer_radius", &A::outer_radius, 1.019 * 0.5)
      .refuses("outer_radius", &A::outer_radius, 50.1 * 0.5)
      .refuses("twist", &A::twist, 0.99e-6)
      .takes("twist", &A::twist, 1.01e-6)
      .refuses("twist", &A::twist, 3.01)
      .refuses_argument("position", [](const TwistedAnnulus& a) { a.at(0.5 - 1e-9); })
      .refuses_argument("position", [](const TwistedAnnulus& a) { a.at(1 + 1e-9); });
}

void add_blown_sheets(KnownAnswers& all) {
  using C = CircularMembraneProblem;
  Refused<CircularMembrane, C>(all, "membrane")
      .refuses("load", &C::load, 0.99e-9)
      .takes("load", &C::load, 1.01e-9)
      .takes("load", &C::load, 1)
      .refuses("load", &C::load, 1.01)
      .between("poisson_ratio", &C::poisson_ratio, 0, 0.5, true, true)
      .positive({{"radius", &C::radius}})
      .refuses_argument("position", [](const CircularMembrane& c) { c.at(-1e-9); })
      .refuses_argument("position", [](const CircularMembrane& c) { c.at(1 + 1e-9); });
  using S = PressurisedSphereProblem;
  Refused<PressurisedSphere, S>(all, "sphere")
      .positive({{"youngs_modulus", &S::youngs_modulus},
                 {"thickness", &S::thickness},
                 {"density", &S::density},
                 {"radius", &S::radius},
                 {"stretch", &S::stretch}})
      .between("poisson_ratio", &S::poisson_ratio, -1, 0.5, false, true);
}

}  // namespace

void add_refused_sheets(KnownAnswers& all) {
  add_flat_sheets(all);
  add_blown_sheets(all);
}

}  // namespace plumbline::reference::refused_problems

namespace plumbline {

KnownAnswers refusal_answers() {
  KnownAnswers all;
  reference::refused_problems::add_refused_strings(all);
  reference::refused_problems::add_refused_solids(all);
  reference::refused_problems::add_refused_sheets(all);
  reference::refused_problems::add_refused_gases(all);
  return all;
}

}  // namespace plumbline
