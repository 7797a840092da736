// Flows of gas, and gases in rings, bags and behind pistons.
#include <cmath>

#include "cases/catalog/estimators/references/refused.hpp"
#include "reference/affine_expansion.hpp"
#include "reference/airbag_lumped.hpp"
#include "reference/converged_gas.hpp"
#include "reference/finite_volume.hpp"
#include "reference/gas_ring.hpp"
#include "reference/gas_sphere.hpp"
#include "reference/membrane_equilibrium.hpp"
#include "reference/noh.hpp"
#include "reference/piston_container.hpp"
#include "reference/piston_shock.hpp"
#include "reference/released_ring.hpp"
#include "reference/sedov.hpp"
#include "reference/shear_decay.hpp"
#include "reference/simple_wave.hpp"
#include "reference/standing_wave.hpp"
#include "reference/uniform_compression.hpp"

namespace plumbline::reference::refused_problems {
namespace {

void add_similar_flows(KnownAnswers& all) {
  using A = AffineExpansionProblem;
  Refused<AffineExpansion, A>(all, "affine")
      .positive({{"radius", &A::radius}, {"density", &A::density}, {"pressure", &A::pressure}})
      .above("gamma", &A::gamma, 1)
      .refuses("dimension", &A::dimension, 0)
      .refuses("dimension", &A::dimension, 4)
      .refuses_argument("time", [](const AffineExpansion& a) { a.at(-1e-9); })
      .refuses_argument("radius", [](const AffineExpansion& a) { a.at(0.001).sample(-1e-9); });
  using N = NohProblem;
  Refused<Noh, N>(all, "noh")
      .positive({{"density", &N::density}, {"velocity", &N::velocity}})
      .above("gamma", &N::gamma, 1)
      .refuses("dimension", &N::dimension, 0)
      .refuses("dimension", &N::dimension, 4)
      .refuses_argument("time", [](const Noh& n) { n.sample(1, -1e-9); })
      .refuses_argument("radius", [](const Noh& n) { n.sample(-1e-9, 1); });
  using S = SedovProblem;
  Refused<Sedov, S>(all, "sedov")
      .positive({{"density", &S::density}, {"energy", &S::energy}})
      .above("gamma", &S::gamma, 1)
      .refuses("gamma", &S::gamma, 7)
      .takes("gamma", &S::gamma, 6.9)
      .refuses("dimension", &S::dimension, 0)
      .refuses("dimension", &S::dimension, 4)
      .refuses_argument("time", [](const Sedov& s) { s.sample(1, 0); })
      .refuses_argument("radius", [](const Sedov& s) { s.sample(-1e-9, 1); });
  using P = PistonShockProblem;
  Refused<PistonShock, P>(all, "piston_shock")
      .positive({{"piston_velocity", &P::piston_velocity}, {"density", &P::density}})
      .not_negative({{"pressure", &P::pressure}})
      .above("gamma", &P::gamma, 1)
      .refuses_argument("position", [](const PistonShock& p) { p.sample(INFINITY, 1); })
      .refuses_argument("time", [](const PistonShock& p) { p.sample(1, -1e-9); });
}

void add_waves(KnownAnswers& all) {
  using V = ShearDecayProblem;
  const double sound = std::sqrt(1.4);
  const double pi = std::acos(-1.0);
  Refused<ShearDecay, V>(all, "shear_decay")
      .finite({{"amplitude", &V::amplitude}})
      .positive({{"wavenumber", &V::wavenumber}, {"density", &V::density}, {"pressure", &V::pressure}})
      .not_negative({{"viscosity", &V::viscosity}})
      .above("gamma", &V::gamma, 1)
      .refuses("amplitude", &V::amplitude, -0.505 * sound)
      .takes("amplitude", &V::amplitude, -0.495 * sound)
      .refuses("viscosity", &V::viscosity, 0.505 * sound / pi)
      .takes("viscosity", &V::viscosity, 0.495 * sound / pi)
      .refuses_argument("time", [](const ShearDecay& s) { s.sample(0.1, -1e-9); })
      .refuses_argument("position", [](const ShearDecay& s) { s.sample(INFINITY, 1); })
      .refuses_argument("position", [](const ShearDecay& s) { s.longitudinal_velocity(INFINITY, 1); });
  using S = SimpleWaveProblem;
  const double parting = -2 * sound / 0.4;
  const Refused<SimpleWave, S> simple(all, "simple_wave");
  simple.finite({{"amplitude", &S::amplitude}, {"centre", &S::centre}})
      .positive({{"half_width", &S::half_width}, {"density", &S::density}, {"pressure", &S::pressure}})
      .above("gamma", &S::gamma, 1)
      .refuses("amplitude", &S::amplitude, 1.01 * parting)
      .takes("amplitude", &S::amplitude, 0.99 * parting);
  const double breaks = SimpleWave(S{}).breaking_time().value;
  simple.refuses_argument("time", [=](const SimpleWave& s) { s.sample(0.3, 1.01 * breaks); })
      .takes_argument("time", [=](const SimpleWave& s) { s.sample(0.3, 0.99 * breaks); })
      .refuses_argument("time", [](const SimpleWave& s) { s.sample(0.3, -1e-9); })
      .refuses_argument("position", [](const SimpleWave& s) { s.sample(INFINITY, 0.1); });
  using W = StandingWaveProblem;
  const double half = 0.5 / (1.2 * 1e-3 * 6.283185307179586);
  Refused<StandingWave, W>(all, "standing_wave")
      .finite({{"amplitude", &W::amplitude}})
      .positive({{"wavenumber", &W::wavenumber}, {"density", &W::density}, {"pressure", &W::pressure}})
      .above("gamma", &W::gamma, 1)
      .refuses("amplitude", &W::amplitude, -0.0101 * sound)
      .takes("amplitude", &W::amplitude, -0.0099 * sound)
      .refuses_argument("position", [](const StandingWave& s) { s.sample(INFINITY, 0.1); })
      .refuses_argument("time", [](const StandingWave& s) { s.sample(0.3, -1e-9); })
      .takes_argument("time", [=](const StandingWave& s) { s.sample(0.3, 0.99 * half); })
      .refuses_argument("time", [=](const StandingWave& s) { s.sample(0.3, 1.01 * half); });
  using U = UniformCompressionProblem;
  Refused<UniformCompression, U>(all, "compression")
      .finite({{"rate", &U::rate}})
      .not_negative({{"viscosity", &U::viscosity}, {"linear", &U::linear}, {"quadratic", &U::quadratic}})
      .positive({{"density", &U::density}, {"pressure", &U::pressure}})
      .above("gamma", &U::gamma, 1)
      .refuses("dimension", &U::dimension, 0)
      .refuses("dimension", &U::dimension, 4)
      .refuses("linear", U{.viscosity = 0.1, .linear = 0.1})
      .refuses("linear", U{.linear = 0.1, .quadratic = 0.1})
      .refuses_argument("time", [](const UniformCompression& c) { c.instant(-1e-9); })
      .refuses_argument("time", [](const UniformCompression& c) { c.instant(2); })
      .takes_argument("time", [](const UniformCompression& c) { c.instant(1.98); })
      .refuses_argument("position", [](const UniformCompression& c) { c.sample(INFINITY, 1); });
}

void add_closed_gases(KnownAnswers& all) {
  using R = GasRingProblem;
  const double wide = R{}.radius + 1e-9;
  Refused<GasRing, R>(all, "gas_ring")
      .positive({{"youngs_modulus", &R::youngs_modulus},
                 {"thickness", &R::thickness},
                 {"radius", &R::radius},
                 {"line_mass", &R::line_mass},
                 {"pressure", &R::pressure},
                 {"gas_density", &R::gas_density}})
      .between("poisson_ratio", &R::poisson_ratio, -0.5, 0.5, false, false)
      .above("gamma", &R::gamma, 1)
      .finite({{"velocity", &R::velocity}})
      .refuses_argument("mode", [](const GasRing& g) { g.omega(0); })
      .refuses_argument("mode", [](const GasRing& g) { g.omega(1001); })
      .refuses_argument("radius", [=](const GasRing& g) { g.shape(wide); })
      .refuses_argument("radius", [](const GasRing& g) { g.pressure_shape(-1e-9); })
      .refuses_argument("time", [](const GasRing& g) { g.displacement(-1e-9); })
      .refuses_argument("time", [](const GasRing& g) { g.velocity(-1e-9); });
  using S = GasSphereProblem;
  Refused<GasSphere, S>(all, "gas_sphere")
      .positive({{"gas_density", &S::gas_density}})
      .above("gamma", &S::gamma, 1)
      .finite({{"velocity", &S::velocity}})
      .refuses("stretch", S{.sheet = {.stretch = 1}})
      .refuses_argument("mode", [](const GasSphere& g) { g.omega(0); })
      .refuses_argument("mode", [](const GasSphere& g) { g.omega(1001); })
      .refuses_argument("radius", [](const GasSphere& g) { g.shape(1.2 + 1e-9); })
      .refuses_argument("radius", [](const GasSphere& g) { g.pressure_shape(-1e-9); })
      .refuses_argument("time", [](const GasSphere& g) { g.velocity(-1e-9); });
  using M = MembraneEquilibriumProblem;
  Refused<MembraneEquilibrium, M>(all, "membrane")
      .positive({{"gas_energy", &M::gas_energy},
                 {"gas_area", &M::gas_area},
                 {"length", &M::length},
                 {"youngs_modulus", &M::youngs_modulus},
                 {"thickness", &M::thickness},
                 {"density", &M::density}})
      .above("gamma", &M::gamma, 1)
      .between("poisson_ratio", &M::poisson_ratio, -0.5, 0.5, false, false)
      .not_negative({{"lost", &M::lost}})
      .refuses("lost", &M::lost, M{}.gas_energy)
      .refuses_argument("segments", [](const MembraneEquilibrium& m) { m.state(-1); })
      .refuses_argument("segments", [](const MembraneEquilibrium& m) { m.state(1000001); });
  using L = ReleasedRingProblem;
  Refused<ReleasedRing, L>(all, "released_ring")
      .positive({{"youngs_modulus", &L::youngs_modulus},
                 {"thickness", &L::thickness},
                 {"membrane_density", &L::membrane_density},
                 {"radius", &L::radius},
                 {"pressure", &L::pressure},
                 {"gas_density", &L::gas_density}})
      .above("gamma", &L::gamma, 1)
      .refuses("poisson_ratio", &L::poisson_ratio, -1e-9)
      .refuses("poisson_ratio", &L::poisson_ratio, 0.5);
  using C = PistonContainerProblem;
  Refused<PistonContainer, C>(all, "piston")
      .positive({{"spring_modulus", &C::spring_modulus},
                 {"spring_length", &C::spring_length},
                 {"area", &C::area},
                 {"mass", &C::mass},
                 {"gas_density", &C::gas_density},
                 {"bulk_modulus", &C::bulk_modulus},
                 {"gas_length", &C::gas_length}})
      .not_negative({{"spring_density", &C::spring_density}})
      .finite({{"velocity", &C::velocity}})
      .refuses_argument("mode", [](const PistonContainer& p) { p.omega(0); });
  using B = AirbagProblem;
  Refused<AirbagLumped, B>(all, "airbag")
      .positive(
          {{"mass", &B::mass}, {"speed", &B::speed}, {"meridian", &B::meridian}, {"probe_radius", &B::probe_radius}})
      .not_negative(
          {{"height", &B::height}, {"ambient_pressure", &B::ambient_pressure}, {"gas_volume", &B::gas_volume}})
      .above("gamma", &B::gamma, 1)
      .finite({{"pressure", &B::pressure}})
      .refuses("pressure", &B::pressure, B{}.ambient_pressure)
      .refuses("height", &B::height, 0.33)  // the free bag is 0.3276 high
      .takes("height", &B::height, 0.325)
      .refuses("gas_volume", &B::gas_volume, 0.0562)  // it holds 0.05612
      .takes("gas_volume", &B::gas_volume, 0.056)
      .refuses_argument("time", [](const AirbagLumped& a) { a.at(-1e-9); });
}

void add_computed_flows(KnownAnswers& all) {
  const auto stops = [&](const std::string& name, const char* key, bool exact, const auto& work) {
    all.push_back(whether(name + "." + key, refused(key, work), exact));
  };
  const GasProblem sod = riemann_tube({{1, 0, 1}, {0.125, 0, 0.1}, 1.4}, 0.5, 0.01);
  const auto changed = [&](auto change) {
    GasProblem problem = sod;
    change(problem);
    return problem;
  };
  const auto tube = [&](const char* key, bool exact, const GasProblem& problem, int cells, double courant) {
    stops("tube", key, exact, [&] { solve_finite_volume(problem, cells, courant); });
  };
  tube("cells", true, sod, 1, 0.8);
  tube("cells", false, sod, 2, 0.8);
  tube("courant", true, sod, 4, 0);
  tube("courant", true, sod, 4, 1);
  tube("courant", false, sod, 4, 0.99);
  tube("dimension", true, changed([](GasProblem& p) { p.dimension = 2; }), 4, 0.8);
  tube("dimension", true, changed([](GasProblem& p) { p.dimension = 4; }), 4, 0.8);
  tube("gamma", true, changed([](GasProblem& p) { p.gamma = 1; }), 4, 0.8);
  tube("end_time", true, changed([](GasProblem& p) { p.end_time = 0; }), 4, 0.8);
  tube("low", true, changed([](GasProblem& p) { p.low = 1; }), 4, 0.8);
  tube("low", false, changed([](GasProblem& p) { p.low = -0.1; }), 4, 0.8);
  for (const auto end : {&GasProblem::left, &GasProblem::right}) {
    const GasProblem open = changed([=](GasProblem& p) { p.*end = GasBoundary::vacuum; });
    all.push_back(yes("tube.vacuum", throws<std::invalid_argument>([&] { solve_finite_volume(open, 4); })));
  }
  const auto moving = [&](const char* key, bool exact, const GasProblem& problem, int cells, double courant) {
    stops("moving", key, exact, [&] { solve_lagrangian(problem, lagrangian_mesh(problem, cells), courant); });
  };
  moving("cells", true, sod, 0, 0.8);
  moving("courant", true, sod, 4, 0);
  moving("courant", true, sod, 4, 1);
  moving("courant", false, sod, 4, 0.99);
  moving("gamma", true, changed([](GasProblem& p) { p.gamma = 1; }), 4, 0.8);
  moving("low", true, changed([](GasProblem& p) {
           p.dimension = 2;
           p.low = -0.1;
         }),
         4, 0.8);
  const auto expansion = [&](const char* key, double radius, double time) {
    stops("expansion", key, true, [=] { gas_expansion(radius, time); });
  };
  expansion("radius", 0, 0.001);
  expansion("time", 0.3, 0);
  expansion("time", 0.3, 0.808 * 0.3 / std::sqrt(140));
}

}  // namespace

void add_refused_gases(KnownAnswers& all) {
  add_similar_flows(all);
  add_waves(all);
  add_closed_gases(all);
  add_computed_flows(all);
}

}  // namespace plumbline::reference::refused_problems
