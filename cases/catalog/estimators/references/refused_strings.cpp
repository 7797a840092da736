// Strings, chains, pendulums, springs.
#include <cmath>

#include "cases/catalog/estimators/references/refused.hpp"
#include "reference/bar_chain.hpp"
#include "reference/catenary.hpp"
#include "reference/elastic_pendulum.hpp"
#include "reference/geo_tube.hpp"
#include "reference/hanging_chain.hpp"
#include "reference/heavy_spring.hpp"
#include "reference/incline.hpp"
#include "reference/slack_string.hpp"
#include "reference/spring_oscillator.hpp"
#include "reference/string_vibration.hpp"

namespace plumbline::reference::refused_problems {
namespace {

void add_pendulum(KnownAnswers& all) {
  using P = ElasticPendulumProblem;
  const Refused<ElasticPendulum, P> pendulum(all, "pendulum");
  pendulum.finite({{"pivot_x", &P::pivot_x}, {"pivot_y", &P::pivot_y}, {"bob_x", &P::bob_x}, {"bob_y", &P::bob_y}})
      .positive(
          {{"mass", &P::mass}, {"gravity", &P::gravity}, {"youngs_modulus", &P::youngs_modulus}, {"area", &P::area}})
      .not_negative({{"density", &P::density}})
      .between("strain", &P::strain, -0.1, 0.1, false, false)
      .refuses("bob_y", &P::bob_y, P{}.pivot_y)
      .refuses("bob_x", &P::bob_x, P{}.pivot_x);
  const double weight = P{}.mass * P{}.gravity / P{}.area;
  pendulum.refuses("youngs_modulus", &P::youngs_modulus, 9.9 * weight)
      .takes("youngs_modulus", &P::youngs_modulus, 10.1 * weight)
      .takes("youngs_modulus", &P::youngs_modulus, 0.99e9 * weight)
      .refuses("youngs_modulus", &P::youngs_modulus, 1.01e9 * weight);
  const double most = 1e6 / ElasticPendulum(P{}).axial_omega().value;
  const auto at = [](std::vector<double> times) { return [times](const ElasticPendulum& p) { p.at(times); }; };
  pendulum.refuses_argument("time", at({-1e-9}))
      .refuses_argument("time", at({0.2, 0.1}))
      .takes_argument("time", at({0.1, 0.1}))
      .refuses_argument("time", at({1.001 * most}));
  const double swings = std::floor(1e6 / (4 * std::sqrt(P{}.youngs_modulus / weight)));
  pendulum.refuses_argument("n", [](const ElasticPendulum& p) { p.crossing(0); })
      .refuses_argument("n", [](const ElasticPendulum& p) { p.extremes(-1); })
      .refuses_argument("n", [](const ElasticPendulum& p) { p.crossings(-1); })
      .refuses_argument("n", [=](const ElasticPendulum& p) { p.extremes(static_cast<int>(swings) + 1); })
      .takes_argument("n", [](const ElasticPendulum& p) { p.extremes(0); });
}

void add_chain(KnownAnswers& all) {
  using P = BarChainProblem;
  const Refused<BarChain, P> chain(all, "bar_chain");
  chain
      .positive({{"mass", &P::mass},
                 {"gravity", &P::gravity},
                 {"youngs_modulus", &P::youngs_modulus},
                 {"area", &P::area},
                 {"density", &P::density}})
      .between("strain", &P::strain, -0.5, 0.1, false, false);
  for (const auto member : {&P::support_x, &P::support_y, &P::end_x, &P::end_y}) {
    chain.refuses("end_x", member, std::numeric_limits<double>::infinity());
  }
  P short_one;
  short_one.end_x = short_one.support_x;
  short_one.end_y = short_one.support_y;
  chain.refuses("end_y", short_one);
  const double weight = P{}.mass * P{}.gravity / P{}.area;
  chain.refuses("youngs_modulus", &P::youngs_modulus, 9.9 * weight)
      .takes("youngs_modulus", &P::youngs_modulus, 10.1 * weight);
  const double rest = BarChain(P{}).rest_length(), equal = P{}.mass / (P{}.area * rest);
  chain.refuses("density", &P::density, 1.01 * equal).takes("density", &P::density, 0.99 * equal);
  const auto made = [&](const char* key, bool exact, int elements, double tolerance) {
    all.push_back(whether(std::string("bar_chain.made.") + key,
                          refused(key, [&] { BarChain(P{}, elements, tolerance); }), exact));
  };
  made("elements", true, 0, 1e-8);
  made("elements", true, 404, 1e-8);
  made("elements", true, 10, 1e-8);
  made("elements", false, 4, 1e-8);
  made("elements", false, 400, 1e-8);
  made("tolerance", true, 8, 0.99e-12);
  made("tolerance", false, 8, 1.01e-12);
  made("tolerance", false, 8, 0.99e-4);
  made("tolerance", true, 8, 1.01e-4);
  chain.refuses_argument("time", [](const BarChain& c) { c.at(-1e-9); })
      .refuses_argument("time",
                        [](const BarChain& c) {
                          const double back[] = {0.02, 0.01};
                          c.at(back);
                        })
      .refuses_argument("count", [](const BarChain& c) { c.turns(ChainTurn::swing, -1); });
  Refused<BarChain, P>(all, "bar_chain_down", chain_spring_problem()).refuses_argument("end_x", [](const BarChain& c) {
    c.turns(ChainTurn::swing, 1);
  });
}

void add_hanging(KnownAnswers& all) {
  using C = CatenaryProblem;
  Refused<Catenary, C>(all, "catenary")
      .positive({{"span", &C::span}, {"length", &C::length}, {"weight", &C::weight}})
      .not_negative({{"compliance", &C::compliance}})
      .refuses("length", &C::length, 1)
      .takes("length", &C::length, 1.001)
      .refuses_argument("position", [](const Catenary& c) { c.x(-1e-9); })
      .refuses_argument("position", [](const Catenary& c) { c.tension(1.2 + 1e-9); });
  using H = HangingChainProblem;
  Refused<HangingChain, H>(all, "hanging_chain")
      .positive({{"length", &H::length}, {"gravity", &H::gravity}, {"line_density", &H::line_density}})
      .finite({{"amplitude", &H::amplitude}})
      .refuses_argument("position", [](const HangingChain& c) { c.displacement(-1e-9, 0); })
      .refuses_argument("position", [](const HangingChain& c) { c.displacement(1 + 1e-9, 0); })
      .refuses_argument("time", [](const HangingChain& c) { c.displacement(0.5, INFINITY); })
      .refuses_argument("time", [](const HangingChain& c) { c.velocity(0.5, INFINITY); })
      .refuses_argument("position", [](const HangingChain& c) { c.tension(1 + 1e-9); });
  using V = StringVibrationProblem;
  Refused<StringVibration, V>(all, "string")
      .positive({{"youngs_modulus", &V::youngs_modulus},
                 {"area", &V::area},
                 {"density", &V::density},
                 {"strain", &V::strain},
                 {"length", &V::length}})
      .finite({{"amplitude", &V::amplitude}})
      .refuses("mode", &V::mode, 0)
      .refuses_argument("position", [](const StringVibration& s) { s.displacement(1 + 1e-9, 0); })
      .refuses_argument("time", [](const StringVibration& s) { s.displacement(0.5, INFINITY); })
      .refuses_argument("position", [](const StringVibration& s) { s.velocity(-1e-9, 0); })
      .refuses_argument("time", [](const StringVibration& s) { s.velocity(0.5, INFINITY); });
  using S = SlackStringProblem;
  Refused<SlackString, S>(all, "slack_string")
      .positive({{"youngs_modulus", &S::youngs_modulus},
                 {"area", &S::area},
                 {"length", &S::length},
                 {"mass", &S::mass},
                 {"gravity", &S::gravity}})
      .not_negative({{"slack", &S::slack}})
      .refuses_argument("time", [](const SlackString& s) { s.displacement(-1e-9); });
}

void add_springs(KnownAnswers& all) {
  using P = SpringProblem;
  const auto spring = [&](const auto& one) {
    one.positive(
           {{"youngs_modulus", &P::youngs_modulus}, {"area", &P::area}, {"length", &P::length}, {"mass", &P::mass}})
        .not_negative({{"density", &P::density}})
        .finite({{"gravity", &P::gravity}});
  };
  spring(Refused<MasslessSpring, P>(all, "spring"));
  using O = SpringOscillatorProblem;
  const auto stops = [&](const char* key, const O& problem, double time) {
    all.push_back(yes(std::string("oscillator.") + key, refused(key, [&] { spring_oscillator(problem, time); })));
  };
  stops("damping", {.damping = -1e-9}, 1);
  stops("time", {.displacement = 1}, -1e-9);
  stops("gravity", {.gravity = INFINITY}, 1);
  stops("velocity", {.velocity = INFINITY}, 1);
  stops("displacement", {.displacement = INFINITY}, 1);
  stops("gamma", {.law = SpringLaw::gas_column, .gamma = 1}, 1);
  stops("displacement", {.law = SpringLaw::gas_column, .displacement = -1}, 1);
  using I = InclineProblem;
  Refused<Incline, I>(all, "incline")
      .not_negative({{"slope", &I::slope}, {"friction", &I::friction}, {"rise", &I::rise}})
      .positive({{"gravity", &I::gravity}})
      .refuses_argument("time", [](const Incline& i) { i.velocity_time(-1e-9); })
      .refuses_argument("time", [](const Incline& i) { i.way_time(-1e-9); });
}

// Without weight a tube is round, its circumference L (1 + c p r) = 2 pi r: none holds a pressure of 2 pi/(c L) or more. Weight
// adds to the pressure, so that the membrane gives way at less on top.
void add_tube(KnownAnswers& all) {
  using P = GeoTubeProblem;
  const Refused<GeoTube, P> tube(all, "geo_tube"), round(all, "round_tube", {.specific_weight = 0});
  tube.positive({{"perimeter", &P::perimeter}, {"top_pressure", &P::top_pressure}})
      .not_negative({{"specific_weight", &P::specific_weight}, {"compliance", &P::compliance}});
  const double most = 2 * std::acos(-1.0) / (P{}.perimeter * P{}.top_pressure);
  round.refuses("compliance", &P::compliance, 1.01 * most).takes("compliance", &P::compliance, 0.99 * most);
  tube.refuses("compliance", &P::compliance, 0.99 * most).takes("compliance", &P::compliance, 0.01 * most);
  tube.refuses_argument("along", [](const GeoTube& t) { t.at(-1e-9); }).refuses_argument("along", [](const GeoTube& t) {
    t.at(4 + 1e-9);
  });
}

}  // namespace

void add_refused_strings(KnownAnswers& all) {
  add_pendulum(all);
  add_chain(all);
  add_hanging(all);
  add_springs(all);
  add_tube(all);
}

}  // namespace plumbline::reference::refused_problems
