// Rules by which gates, names and bodies are made: ranges recorded beside bounds, bands of expected failures, the nearest names, and
// lattices of points, each at both sides of where it changes.
#include <cmath>
#include <memory>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/compare/bands.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/files/nearest.hpp"
#include "cases/harness/judge/regressions.hpp"
#include "kernel/materials/ideal_gas.hpp"

namespace plumbline {
namespace {

struct RecordedCase {
  Range bound;
  Origin origin;
  bool order;
  double measured;
  std::optional<Range> exact;
};

// A factor of three for values, 0.3 for orders; 30 for roundings, to 64 units in the last place of one.
void add_recorded(KnownAnswers& all) {
  constexpr double least = 64 * 0x1p-52;
  const std::vector<RecordedCase> cases{{{1.9, {}}, Origin::theory, true, 2.3, Range{2.0, 2.6}},
                                        {{1.9, {}}, Origin::theory, true, 2.15, {}},
                                        {{{}, 2.2}, Origin::theory, true, 1.8, Range{1.5, 2.1}},
                                        {{{}, 2.2}, Origin::theory, true, 1.95, {}},
                                        {{{}, 1.0}, Origin::theory, false, 0.2, Range{0.2 / 3, 0.6}},
                                        {{{}, 1.0}, Origin::theory, false, 0.4, {}},
                                        {{{}, 1.0}, Origin::theory, false, -0.2, Range{-0.6, -0.2 / 3}},
                                        {{{}, -1.0}, Origin::theory, false, -5, Range{-15, -5.0 / 3}},
                                        {{{}, -1.0}, Origin::theory, false, -2, {}},
                                        {{-1.0, {}}, Origin::theory, false, -0.2, Range{-0.6, -0.2 / 3}},
                                        {{-1.0, {}}, Origin::theory, false, -0.4, {}},
                                        {{1.0, {}}, Origin::theory, false, 5, Range{5.0 / 3, 15}},
                                        {{1.0, {}}, Origin::theory, false, 2, {}},
                                        {{{}, 1.0}, Origin::theory, false, 0, Range{0, least}},
                                        {{{}, 1e-3}, Origin::identity, false, 1e-5, Range{0, 3e-4}},
                                        {{{}, 1e-3}, Origin::identity, false, -1e-5, Range{-3e-4, 3e-4}},
                                        {{-1e-3, 1e-3}, Origin::identity, false, 1e-5, Range{-3e-4, 3e-4}},
                                        {{{}, 1e-3}, Origin::identity, false, 2e-4, {}},
                                        {{{}, 1e-9}, Origin::theory, false, 1e-12, Range{0, 3e-11}},
                                        {{{}, 1e-8}, Origin::theory, false, 1e-9, Range{1e-9 / 3, 3e-9}},
                                        {{{}, 1e3}, Origin::theory, false, 1e-8, Range{0, 3e-7}},
                                        {{{}, 1e3}, Origin::theory, false, 2e-7, Range{2e-7 / 3, 6e-7}},
                                        {{{}, 1e3}, Origin::theory, false, 1e-16, Range{0, 1e3 * least}},
                                        {{{}, 1.0}, Origin::theory, false, NAN, {}}};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const RecordedCase& one = cases[k];
    const std::optional<Range> found = recorded_range(one.bound, one.origin, one.order, one.measured);
    const std::string name = "recorded." + std::to_string(k);
    all.push_back({name, static_cast<double>(found.has_value()), one.exact ? 1.0 : 0.0});
    if (!found || !one.exact) continue;
    const double scale = std::max(std::abs(*one.exact->low), *one.exact->high);
    all.push_back({name + ".low", found->low.value_or(NAN), *one.exact->low, scale});
    all.push_back({name + ".high", found->high.value_or(NAN), *one.exact->high, scale});
  }
}

// A factor of 1.35, 0.2 of an order, or half the width of sixteen runs and more to either side.
void add_bands(KnownAnswers& all) {
  const auto row = [&](const char* name, const Range& band, bool order, const Ensemble* runs, bool wide) {
    Gate gate;
    gate.order = order;
    gate.expected_failure = ExpectedFailure{"known", band, {}, {}};
    all.push_back({name, too_wide(gate, runs).empty() ? 0.0 : 1.0, wide ? 1.0 : 0.0});
  };
  row("band.value", {1, 1.35}, false, nullptr, false);
  row("band.wide_value", {1, 1.36}, false, nullptr, true);
  row("band.negative", {-1.35, -1}, false, nullptr, false);
  row("band.wide_negative", {-1.36, -1}, false, nullptr, true);
  row("band.both_signs", {-1, 1}, false, nullptr, true);
  row("band.zero", {0, 0}, false, nullptr, false);
  row("band.order", {1, 1.2}, true, nullptr, false);
  row("band.wide_order", {1, 1.21}, true, nullptr, true);
  row("band.one_end", {1, {}}, false, nullptr, true);
  row("band.other_end", {{}, 1}, false, nullptr, true);
  row("band.none", {}, false, nullptr, false);
  Ensemble runs;
  for (int k = 0; k < 16; ++k) runs.values.push_back(k % 2 == 0 ? 1 : 3);
  const Range shown = widened(runs);
  all.push_back({"ensemble.low", shown.low.value_or(NAN), 0});
  all.push_back({"ensemble.high", shown.high.value_or(NAN), 4});
  row("ensemble.within", {0, 4}, false, &runs, false);
  row("ensemble.below", {-0.01, 4}, false, &runs, true);
  row("ensemble.above", {0, 4.01}, false, &runs, true);
  runs.values.pop_back();
  row("ensemble.too_few", {0, 4}, false, &runs, true);
  runs.stopped.push_back({12, "density"});
  row("ensemble.stopped", {0, 4}, false, &runs, true);
  Gate stops;
  for (const auto& [low, high, field, wide] : {std::tuple{12L, 12L, "density", 0.0},
                                               {13L, 20L, "density", 1.0},
                                               {1L, 11L, "density", 1.0},
                                               {1L, 20L, "energy", 1.0}}) {
    stops.expected_failure = ExpectedFailure{"known", {0, 4}, StopBand{low, high, field}, {}};
    all.push_back({"ensemble.expected_stop", too_wide(stops, &runs).empty() ? 0.0 : 1.0, wide});
  }
}

// The names that are offered, in their order.
void add_names(KnownAnswers& all) {
  const std::vector<std::string> known{"leapfrog", "musl", "midpoint", "rk4", "ssp-rk3", "usf", "usl", "energy", "usf"};
  const auto row = [&](const char* wrong, std::size_t most, const std::vector<std::string>& exact) {
    all.push_back(yes(std::string("nearest.") + wrong, nearest(wrong, known, most) == exact));
  };
  row("lepafrog", 3, {"leapfrog"});  // neighbours swapped: one change
  row("MUSL", 3, {"musl", "usl"});
  row("usg", 3, {"usf", "usl"});  // each once
  row("usg", 1, {"usf"});
  row("rk3", 3, {"rk4", "ssp-rk3"});  // a part of the name is as near as one letter; the longer beginning first
  row("le", 3, {"leapfrog"});         // a beginning
  row("midpont", 3, {"midpoint"});    // dropped
  row("midpoiint", 3, {"midpoint"});  // inserted
  row("mdipiont", 3, {"midpoint"});   // two swaps of eight letters are near, three other letters are not
  row("mxxxoint", 3, {});
  row("enexxy", 3, {"energy"});
  row("enxxxy", 3, {});
  row("xyz", 3, {});
}

// Lattices: counts, sums of volumes, masses and places.
void add_lattice(const char* name, int dim, bool axisymmetric, const SolidShape& shape, double count, double volume,
                 double places, KnownAnswers& all) {
  GridSpec grid;
  grid.dim = dim;
  grid.axisymmetric = axisymmetric;
  grid.h = 1;
  const Body body = fill_solid("body", std::make_shared<IdealGas>(), shape, 3, 2, grid);
  double volumes = 0, masses = 0, sum = 0;
  for (int p = 0; p < body.points.points(); ++p) {
    volumes += body.points(column::volume)[p];
    masses += body.points(column::mass)[p];
    for (int d = 0; d < dim; ++d) sum += (d + 1) * body.points(column::position, d)[p];
  }
  const auto row = [&](const char* what, double found, double exact) {
    all.push_back({std::string(name) + "." + what, found, exact, std::max(1.0, exact)});
  };
  row("count", body.points.points(), count);
  row("spacing", body.spacing, 0.5);
  row("volume", volumes, volume);
  row("mass", masses, 3 * volume);
  row("places", sum, places);
}

void add_lattices(KnownAnswers& all) {
  // 3 points from 0.75 on, in the mean at 1.25; with one more where the box is a little longer than that.
  add_lattice("line", 1, false, {.low = {0.5, 0, 0}, .high = {2, 0, 0}}, 3, 1.5, 3 * 1.25, all);
  add_lattice("longer", 1, false, {.low = {0.5, 0, 0}, .high = {2.01, 0, 0}}, 4, 2, 4 * 1.5, all);
  // 2 x 3 points, means 1.5 and 0.75.
  add_lattice("plane", 2, false, {.low = {1, 0, 0}, .high = {2, 1.5, 0}}, 6, 1.5, 6 * (1.5 + 2 * 0.75), all);
  // The same around the axis: volumes of a radius of 1.5 in the mean.
  add_lattice("rings", 2, true, {.low = {1, 0, 0}, .high = {2, 1.5, 0}}, 6, 1.5 * 1.5, 6 * (1.5 + 2 * 0.75), all);
  // 1 x 2 x 3 points, means 0.25, 1.5 and 2.75.
  add_lattice("space", 3, false, {.low = {0, 1, 2}, .high = {0.5, 2, 3.5}}, 6, 0.75, 6 * (0.25 + 2 * 1.5 + 3 * 2.75),
              all);
  // A disk in a square of 4 x 4 points, without the corners.
  const auto in_disk = [](const std::array<double, 3>& x) { return std::hypot(x[0] - 1, x[1] - 1) < 1; };
  add_lattice("disk", 2, false, {.low = {0, 0, 0}, .high = {2, 2, 0}, .inside = in_disk}, 12, 3, 12 * (1 + 2 * 1), all);
}

}  // namespace

KnownAnswers rule_answers() {
  KnownAnswers all;
  add_recorded(all);
  add_bands(all);
  add_names(all);
  add_lattices(all);
  return all;
}

}  // namespace plumbline
