// Bars, disks, cylinders, plates.
#include <cmath>

#include "cases/catalog/estimators/references/refused.hpp"
#include "reference/bar_impact.hpp"
#include "reference/bar_vibration.hpp"
#include "reference/cook_panel.hpp"
#include "reference/cylinder_vibration.hpp"
#include "reference/elastic_plastic_impact.hpp"
#include "reference/plate_impact.hpp"
#include "reference/rotating_disk.hpp"
#include "reference/two_bar.hpp"
#include "reference/two_disks.hpp"

namespace plumbline::reference::refused_problems {
namespace {

void add_bars(KnownAnswers& all) {
  using R = BarRiemannProblem;
  const auto with = [](std::vector<BarPiece> pieces) {
    R problem;
    problem.pieces = std::move(pieces);
    return problem;
  };
  Refused<BarRiemann, R>(all, "bar")
      .positive({{"youngs_modulus", &R::youngs_modulus},
                 {"density", &R::density},
                 {"area", &R::area},
                 {"length", &R::length}})
      .finite({{"left", &R::left}})
      .refuses("from", with({}))
      .refuses("from", with({{0.1, 1, 0}}))
      .refuses("from", with({{0, 1, 0}, {1, 0, 0}}))
      .refuses("from", with({{0, 1, 0}, {0.6, 0, 0}, {0.5, 0, 0}}))
      .refuses("velocity", with({{0, INFINITY, 0}}))
      .refuses("stress", with({{0, 1, INFINITY}}))
      .refuses_argument("position", [](const BarRiemann& b) { b.state(-1e-9, 0.1); })
      .refuses_argument("position", [](const BarRiemann& b) { b.state(1 + 1e-9, 0.1); })
      .refuses_argument("time", [](const BarRiemann& b) { b.state(0.5, INFINITY); })
      .refuses_argument("time", [](const BarRiemann& b) { b.state(0.5, -1e-9); });
  using I = BarImpactProblem;
  Refused<BarImpact, I>(all, "bar_impact")
      .positive({{"youngs_modulus", &I::youngs_modulus},
                 {"density", &I::density},
                 {"area", &I::area},
                 {"length", &I::length}})
      .finite({{"left", &I::left}, {"velocity_left", &I::velocity_left}, {"velocity_right", &I::velocity_right}})
      .not_negative({{"gap", &I::gap}})
      .refuses("velocity_left", &I::velocity_left, 0)
      .takes("velocity_left", &I::velocity_left, 1e-3)
      .refuses_argument("distance", [](const BarImpact& b) { b.state_from_contact(ImpactBar::left, -1e-9, 0.1); })
      .refuses_argument("distance",
                        [](const BarImpact& b) { b.state_from_contact(ImpactBar::right, 1.25 + 1e-9, 0.1); })
      .refuses_argument("position", [](const BarImpact& b) { b.state(ImpactBar::left, 2.25 + 1e-9, 0.1); })
      .refuses_argument("time", [](const BarImpact& b) { b.state(ImpactBar::left, 1.5, -1e-9); })
      .refuses_argument("time", [](const BarImpact& b) { b.strain_energy(-1e-9); });
  using V = BarVibrationProblem;
  Refused<BarVibration, V>(all, "bar_vibration")
      .positive({{"youngs_modulus", &V::youngs_modulus},
                 {"density", &V::density},
                 {"area", &V::area},
                 {"length", &V::length}})
      .finite({{"velocity", &V::velocity}})
      .refuses("mode", &V::mode, 0)
      .refuses_argument("position", [](const BarVibration& b) { b.displacement(25 + 1e-9, 0); })
      .refuses_argument("position", [](const BarVibration& b) { b.stress(-1e-9, 0); })
      .refuses_argument("time", [](const BarVibration& b) { b.displacement(1, INFINITY); })
      .refuses_argument("time", [](const BarVibration& b) { b.velocity(1, INFINITY); })
      .refuses_argument("time", [](const BarVibration& b) { b.stress(1, INFINITY); })
      .refuses_argument("time", [](const BarVibration& b) { b.mean_velocity(INFINITY); });
  using T = TwoBarProblem;
  Refused<TwoBar, T>(all, "two_bar")
      .positive({{"width", &T::width},
                 {"height", &T::height},
                 {"youngs_modulus", &T::youngs_modulus},
                 {"density", &T::density},
                 {"speed", &T::speed}})
      .refuses("poisson", &T::poisson, -1e-9)
      .refuses("poisson", &T::poisson, 0.45 + 1e-9)
      .refuses("height", &T::height, 0.2499 * 1.25);
  const auto run = [&](const char* key, bool exact, int elements, int aspect) {
    all.push_back(whether(std::string("two_bar_run.") + key,
                          refused(key, [&] { run_two_bar({.height = 0.3126}, elements, aspect); }), exact));
  };
  run("elements", true, 7, 4);
  run("elements", false, 8, 4);
  run("elements", true, 5001, 4);
  run("aspect", true, 8, 0);
  run("aspect", false, 8, 1);
  run("aspect", true, 8, 17);
  all.push_back(yes("two_bar.elements", refused("elements", [] { TwoBar({}, 31); })));
}

void add_round_bodies(KnownAnswers& all) {
  using C = CylinderVibrationProblem;
  Refused<CylinderVibration, C>(all, "cylinder")
      .positive({{"radius", &C::radius}, {"youngs_modulus", &C::youngs_modulus}, {"density", &C::density}})
      .between("poisson", &C::poisson, -1, 0.5, false, false)
      .finite({{"velocity", &C::velocity}})
      .refuses("mode", &C::mode, 0)
      .refuses_argument("radius", [](const CylinderVibration& c) { c.displacement(1 + 1e-9, 0); })
      .refuses_argument("radius", [](const CylinderVibration& c) { c.hoop_stress(-1e-9, 0); })
      .refuses_argument("time", [](const CylinderVibration& c) { c.displacement(1, INFINITY); })
      .refuses_argument("time", [](const CylinderVibration& c) { c.velocity(1, INFINITY); })
      .refuses_argument("time", [](const CylinderVibration& c) { c.radial_stress(1, INFINITY); })
      .refuses_argument("time", [](const CylinderVibration& c) { c.hoop_stress(1, INFINITY); });
  using D = RotatingDiskProblem;
  Refused<RotatingDisk, D>(all, "disk")
      .positive({{"radius", &D::radius}, {"youngs_modulus", &D::youngs_modulus}, {"density", &D::density}})
      .between("poisson", &D::poisson, -1, 0.5, false, false)
      .finite({{"angular_velocity", &D::angular_velocity}})
      .refuses("angular_velocity", &D::angular_velocity, 1e3)
      .refuses_argument("radius", [](const RotatingDisk& d) { d.displacement(1 + 1e-9); })
      .refuses_argument("radius", [](const RotatingDisk& d) { d.radial_stress(1 + 1e-9); })
      .refuses_argument("radius", [](const RotatingDisk& d) { d.hoop_stress(-1e-9); });
  using T = TwoDisksProblem;
  const double half = 0.3 * std::sqrt(2.0);
  Refused<TwoDisks, T>(all, "two_disks")
      .finite({{"left_x", &T::left_x}, {"left_y", &T::left_y}, {"right_x", &T::right_x}, {"right_y", &T::right_y}})
      .positive({{"radius", &T::radius},
                 {"youngs_modulus", &T::youngs_modulus},
                 {"density", &T::density},
                 {"speed", &T::speed}})
      .between("poisson", &T::poisson, -1, 0.5, false, false)
      .refuses("radius", &T::radius, 1.001 * half)
      .takes("radius", &T::radius, 0.999 * half);
}

void add_struck_bodies(KnownAnswers& all) {
  using E = ElasticPlasticImpactProblem;
  Refused<ElasticPlasticImpact, E>(all, "piston_on_solid")
      .positive({{"youngs_modulus", &E::youngs_modulus},
                 {"density", &E::density},
                 {"yield_stress", &E::yield_stress},
                 {"velocity", &E::velocity}})
      .not_negative({{"hardening_modulus", &E::hardening_modulus}, {"rise_time", &E::rise_time}})
      .between("poissons_ratio", &E::poissons_ratio, -1, 0.5, false, false)
      .refuses_argument("position", [](const ElasticPlasticImpact& i) { i.state(-1e-9, 1.0); })
      .refuses_argument("position", [](const ElasticPlasticImpact& i) { i.state(INFINITY, 1.0); })
      .refuses_argument("time", [](const ElasticPlasticImpact& i) { i.state(0.1, -1e-9); })
      .refuses_argument("time", [](const ElasticPlasticImpact& i) { i.heat(-1e-9); });
  using P = PlateImpactProblem;
  Refused<PlateImpact, P>(all, "plate")
      .positive({{"youngs_modulus", &P::youngs_modulus},
                 {"density", &P::density},
                 {"yield_stress", &P::yield_stress},
                 {"velocity", &P::velocity}})
      .not_negative({{"hardening_modulus", &P::hardening_modulus}})
      .refuses("poissons_ratio", &P::poissons_ratio, -1)
      .refuses("poissons_ratio", &P::poissons_ratio, 0.5)
      .refuses("velocity", &P::velocity, 3000)
      .refuses_argument("place", [](const PlateImpact& p) { p.state(-1e-9, 1e-6); })
      .refuses_argument("time", [](const PlateImpact& p) { p.state(0.1, -1e-9); });
  const auto panel = [&](const char* key, const CookPanelProblem& problem, int elements) {
    all.push_back(yes(std::string("panel.") + key, refused(key, [&] { cook_panel_on(problem, elements); })));
  };
  panel("youngs_modulus", {.youngs_modulus = 0}, 2);
  panel("load", {.load = 0}, 2);
  panel("poisson", {.poisson = -1e-9}, 2);
  panel("poisson", {.poisson = 0.5}, 2);
  panel("elements", {}, 1);
  panel("elements", {}, 129);
}

}  // namespace

void add_refused_solids(KnownAnswers& all) {
  add_bars(all);
  add_round_bodies(all);
  add_struck_bodies(all);
}

}  // namespace plumbline::reference::refused_problems
