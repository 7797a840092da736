#include <cmath>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/description/measures.hpp"
#include "cases/harness/integrators/extrapolation.hpp"
#include "cases/harness/integrators/measured_limit.hpp"
#include "cases/harness/run/extremes.hpp"

namespace plumbline {
namespace {

void add_norm(const Measure& norm, double error, double scale, double bound, KnownAnswers& all) {
  all.push_back({norm.name + ".error", norm.error, error});
  all.push_back({norm.name + ".scale", norm.scale, scale});
  all.push_back({norm.name + ".bound", norm.reference_bound, bound});
}

}  // namespace

KnownAnswers norm_answers() {
  // Volumes 1 and 3; errors 2 and -1 of 3 and -5, known to 0.25 and 0.5.
  const std::vector<FieldSample> samples{{1, 0, 5, 3, 0.25}, {3, 1, -6, -5, 0.5}};
  const std::vector<Measure> norms = field_norms("field", "1", samples);
  KnownAnswers all;
  add_norm(norms[0], 5.0 / 4, 18.0 / 4, 1.75 / 4, all);
  add_norm(norms[1], std::sqrt(7.0 / 4), std::sqrt(84.0 / 4), std::sqrt(0.8125 / 4), all);
  add_norm(norms[2], 2, 5, 0.5, all);
  const std::vector<FieldSample> unknown{{1, 0, NAN, 0, 0}, {1, 0, 0, 0, 0}};
  for (const Measure& norm : field_norms("unknown", "1", unknown)) {
    all.push_back(yes(norm.name, std::isnan(norm.error)));
  }
  const Measure scalar = scalar_measure("scalar", -3, -5, 0.1, "1"), share = share_measure("share", 0.5, 0.75, 0.01);
  add_norm(scalar, 2, 5, 0.1, all);
  add_norm(share, 0.25, 1, 0.01, all);
  all.push_back({"larger", larger(2, -3), 2});
  all.push_back({"smaller", smaller(2, -3), -3});
  const std::pair<const char*, double> nowhere[] = {{"larger.first", larger(NAN, 1)},
                                                    {"larger.second", larger(1, NAN)},
                                                    {"smaller.first", smaller(NAN, 1)},
                                                    {"smaller.second", smaller(1, NAN)}};
  for (const auto& [name, chosen] : nowhere) all.push_back(yes(name, std::isnan(chosen)));
  return all;
}

namespace {

// Parabolas of length 1, maxima of 1 and minima of -1 in turn, at halves: those through three samples are exact.
struct Waves {
  std::vector<double> times, values;
  void sample(double t) {
    const double u = t - std::floor(t) - 0.5;
    times.push_back(t);
    values.push_back((std::fmod(std::floor(t), 2.0) == 0 ? 1 : -1) * (1 - 4 * u * u));
  }
};

void add_extremes(const std::string& name, const std::vector<Extreme>& found, KnownAnswers& all) {
  double time = 0, value = 0, kind = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool maximum = k % 2 == 0;
    time = larger(time, std::abs(found[k].time - (static_cast<double>(k) + 0.5)));
    value = larger(value, std::abs(found[k].value - (maximum ? 1 : -1)));
    kind += found[k].maximum != maximum;
  }
  all.push_back({name + ".count", static_cast<double>(found.size()), 5});
  all.push_back({name + ".time", time, 0});
  all.push_back({name + ".value", value, 0});
  all.push_back({name + ".kind", kind, 0});
  all.push_back({name + ".period", mean_period(found).value_or(NAN), 2});
}

}  // namespace

KnownAnswers period_answers() {
  KnownAnswers all;
  Waves uneven, even;
  for (int k = 0; k <= 250; ++k) uneven.sample(0.02 * k + (k % 3 == 1 ? 0.007 : k % 3 == 2 ? -0.006 : 0));
  for (int k = 0; k < 80; ++k) even.sample((k + 0.5) / 16);  // two samples at every top are equal
  even.sample(5);
  add_extremes("uneven", find_extremes(uneven.times, uneven.values), all);
  add_extremes("equal", find_extremes(even.times, even.values), all);
  const double noise = 0.01;
  add_extremes("wide", find_extremes(uneven.times, uneven.values, noise), all);
  std::vector<double> shaken = uneven.values;  // which reverses them at every top
  for (std::size_t k = 0; k < shaken.size(); ++k) shaken[k] += 0.99 * (k % 2 == 0 ? noise : -noise);
  all.push_back({"shaken.count", static_cast<double>(find_extremes(uneven.times, shaken, noise).size()), 5});
  // Three alike: the middle one.
  const std::vector<double> times{0, 1, 2, 4, 5, 6}, flat{0, 1, 3, 3, 3, 2};
  const std::vector<Extreme> top = find_extremes(times, flat);
  all.push_back({"flat.count", static_cast<double>(top.size()), 1});
  all.push_back({"flat.time", top.empty() ? NAN : top.front().time, 3.5});
  all.push_back({"flat.value", top.empty() ? NAN : top.front().value, 3});
  // One period of maxima, none of minima; of two extremes no period.
  const std::vector<Extreme> few{{1, 2, true}, {2, 0, false}, {4, 2, true}};
  all.push_back({"few.period", mean_period(few).value_or(NAN), 3});
  all.push_back({"few.none", static_cast<double>(mean_period(std::span(few).first(2)).has_value()), 0});
  return all;
}

namespace {

// l + a dt + b dt^2 + c dt^3 at dt = 1/steps.
double cubic(double l, double a, double b, double c, double steps) { return l + (a + (b + c / steps) / steps) / steps; }
std::vector<double> two_cubics(int steps) {
  return {cubic(0.2, 0.3, -0.7, 0.1, steps), cubic(-0.6, 1, 0.5, 0.4, steps)};
}

}  // namespace

KnownAnswers halving_answers() {
  KnownAnswers all;
  std::vector<std::vector<double>> values;
  for (const int steps : {1, 2, 4, 8, 16}) values.push_back(two_cubics(steps));
  const StepLimit limit = limit_of_halvings(values);  // a cubic's fourth column is exact, and two of it agree
  all.push_back({"limit.size", limit.size, 0.6});
  all.push_back({"limit.uncertainty", limit.uncertainty, 0});
  all.push_back({"limit.finest", limit.finest, std::abs(cubic(-0.6, 1, 0.5, 0.4, 16))});
  all.push_back({"limit.before", limit.before, std::abs(cubic(-0.6, 1, 0.5, 0.4, 4))});
  // Of three values 1 + dt^2 the extrapolations, 0.5 and 0.875, differ by more than the last two values: these tell.
  const StepLimit three = limit_of_halvings({{2}, {1.25}, {1.0625}});
  all.push_back({"three.size", three.size, 1.0625});
  all.push_back({"three.uncertainty", three.uncertainty, 0.1875});

  const auto measured = [&](const std::string& name, const Measured& found, double value, double off) {
    all.push_back({name + ".value", found.value.value_or(NAN), value});
    all.push_back({name + ".low", found.interval ? found.interval->first : NAN, std::max(0.0, value - off)});
    all.push_back({name + ".high", found.interval ? found.interval->second : NAN, value + off});
  };
  measured("falls", measured_limit({1, 5, 5}, two_cubics), 0.6, 0);
  measured("vanishes", measured_limit({1, 5, 5}, [](int steps) { return std::vector{cubic(0, 1, 1, 1, steps)}; }), 0,
           0);
  // At once on one side of the bound; and what does not fall is its own limit.
  measured("early", measured_limit({1, 3, 9, 0.1}, [](int steps) { return std::vector{1 + 1.0 / steps / steps}; }),
           1.0625, 3 * 0.1875);
  measured("stalls", measured_limit({1, 3, 4, 1}, [](int steps) { return std::vector{1 + 0.1 * (steps % 3)}; }), 1.2,
           0);
  return all;
}

}  // namespace plumbline
