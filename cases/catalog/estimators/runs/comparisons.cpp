// What a comparison of two results folders finds of changes that are known.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/runs/closed_forms.hpp"
#include "cases/harness/compare/comparison.hpp"

namespace plumbline {
namespace {

const Finding& finding_in(const Comparison& comparison, const std::string& kind, const std::string& quantity) {
  for (const Finding& one : comparison.findings) {
    if (one.kind == kind && one.quantity.starts_with(quantity)) return one;
  }
  throw std::logic_error("no finding of " + kind + " " + quantity);
}

class Changes {
 public:
  explicit Changes(KnownAnswers& all) : all_(all) {}

  // NaN: not looked at.
  void add(const std::string& name, const Finding& found, Change change, double size = NAN, double half_width = NAN) {
    all_.push_back({name + ".change", static_cast<double>(found.change), static_cast<double>(change)});
    if (!std::isnan(size)) all_.push_back({name + ".size", found.size.value_or(NAN), size});
    if (std::isnan(half_width)) return;
    all_.push_back({name + ".low", found.interval ? found.interval->first : NAN, size - half_width});
    all_.push_back({name + ".high", found.interval ? found.interval->second : NAN, size + half_width});
  }

 private:
  KnownAnswers& all_;
};

// --- studies ---

// Six levels a factor two apart, errors c h^p, whose logarithms are off by `off` times off_line.
struct PowerStudy {
  double order = 2, constant = 0.5, off = 0, half_width = 0.1;
  double first = 8;  // cells of the coarsest level
  std::size_t levels = 6;
  bool stops = false;  // the finest

  Snapshot snapshot() const {
    StudyRecord study;
    study.case_name = "known";
    study.vary = "cells";
    for (std::size_t k = 0; k < levels; ++k) {
      LevelRecord level;
      level.value = first * std::ldexp(1.0, static_cast<int>(k));
      level.h = 1 / level.value;
      level.finished = !(stops && k + 1 == levels);
      if (level.finished)
        level.errors["error"].error = constant * std::pow(level.h, order) * std::exp(off * off_line[k]);
      study.levels.push_back(level);
    }
    FitRecord fit;
    fit.order = order;
    fit.low = order - half_width;
    fit.high = order + half_width;
    fit.constant = constant;
    study.fits["error"] = fit;
    Snapshot all;
    all.studies[study.key()] = {study};
    return all;
  }
};

void add_studies(Changes changes) {
  const auto compared = [](const PowerStudy& before, const PowerStudy& after) {
    return compare(before.snapshot(), after.snapshot());
  };
  const double off = 0.03, half = student_of_four() * slope_error_of_six(off);
  const Comparison better = compared({}, {.order = 2.3, .off = off}), worse = compared({}, {.order = 1.7, .off = off});
  changes.add("order.better", finding_in(better, "order", "error"), Change::better, 0.3, half);
  changes.add("order.worse", finding_in(worse, "order", "error"), Change::worse, -0.3, half);
  // An order may move by 0.05; then the constant is looked at, whose finest errors are h^0.04 = 256^-0.04 smaller.
  const Comparison unsure = compared({}, {.order = 2.1, .off = 10 * off}), same = compared({}, {.order = 2.04});
  changes.add("order.unsure", finding_in(unsure, "order", "error"), Change::inconclusive, 0.1, 10 * half);
  changes.add("order.same", finding_in(same, "order", "error"), Change::same, 0.04, 0);
  const double mean = -0.04 * std::log(8 * std::pow(2, 2.5));  // of ln h^0.04 over the levels
  changes.add("order.constant", finding_in(same, "constant", "error"), Change::better, std::expm1(mean));
  changes.add("error.better", finding_in(same, "error", "error"), Change::better, std::pow(256, -0.04) - 1);
  // Errors and constants may move by 1 %.
  const Comparison more = compared({}, {.constant = 0.52}), little = compared({}, {.constant = 0.504});
  changes.add("constant.worse", finding_in(more, "constant", "error"), Change::worse, 0.04);
  changes.add("constant.same", finding_in(little, "constant", "error"), Change::same, 0.008);
  changes.add("error.worse", finding_in(more, "error", "error"), Change::worse, 0.04);
  changes.add("error.same", finding_in(little, "error", "error"), Change::same, 0.008);
  // No mesh in common: intervals with one degree of freedom each, a standard error of theirs is the half width over t(1), add up
  // to one with two [B. L. Welch, doi 10.1093/biomet/34.1-2.28].
  const PowerStudy three{.half_width = 0.2, .levels = 3};
  PowerStudy shifted = three;
  shifted.order = 2.4;
  shifted.first = 32;
  const Comparison apart = compared(three, shifted);
  const double standard_error = 0.2 / student_of_one() * std::numbers::sqrt2;
  changes.add("order.apart", finding_in(apart, "order", "error"), Change::better, 0.4,
              student_of_two() * standard_error);
  const Comparison stopped = compared({}, {.stops = true}), goes_on = compared({.stops = true}, {});
  changes.add("run.stops", finding_in(stopped, "run", "cells"), Change::worse);
  changes.add("run.goes_on", finding_in(goes_on, "run", "cells"), Change::better);
}

// --- limits ---

Snapshot limited(std::vector<Range> predicted, Range observed, double order = 2, double half_width = 0.01) {
  LimitRecord record;
  record.problem = "known";
  record.predicted = std::move(predicted);
  record.observed = {observed};
  record.orders["known"].order = order;
  record.orders["known"].low = order - half_width;
  record.orders["known"].high = order + half_width;
  Snapshot all;
  all.limits[record.key()] = record;
  return all;
}

void add_limits(Changes changes) {
  const Snapshot one = limited({{0.0, 1.5}}, {1.49, 1.51});
  const auto of = [&](const Snapshot& after, const std::string& kind, const std::string& quantity) {
    return finding_in(compare(one, after), kind, quantity);
  };
  // Predicted limits may move by 1e-4, observed ones as long as brackets overlap.
  changes.add("predicted.better", of(limited({{0.0, 1.8}}, {1.49, 1.51}), "limit", "predicted"), Change::better, 0.2);
  changes.add("predicted.worse", of(limited({{0.0, 1.2}}, {1.49, 1.51}), "limit", "predicted"), Change::worse, -0.2);
  changes.add("predicted.same", of(limited({{0.0, 1.5 * (1 + 9e-5)}}, {1.49, 1.51}), "limit", "predicted"),
              Change::same, 9e-5);
  changes.add("predicted.moved", of(limited({{0.0, 1.5 * (1 + 2e-4)}}, {1.49, 1.51}), "limit", "predicted"),
              Change::better, 2e-4);
  changes.add("predicted.more", of(limited({{0.0, 1.5}, {2.0, 2.2}}, {1.49, 1.51}), "limit", "predicted"),
              Change::better, 0);
  changes.add("observed.same", of(limited({{0.0, 1.5}}, {1.505, 1.52}), "limit", "observed"), Change::same);
  changes.add("observed.better", of(limited({{0.0, 1.5}}, {1.52, 1.54}), "limit", "observed"), Change::better);
  changes.add("observed.worse", of(limited({{0.0, 1.5}}, {1.46, 1.48}), "limit", "observed"), Change::worse);
  // Half widths of 0.01 and 0.03 add up in squares.
  const double half = 0.01 * std::sqrt(10.0);
  changes.add("order.worse_in_time", of(limited({{0.0, 1.5}}, {1.49, 1.51}, 1.9, 0.03), "order", "order of known"),
              Change::worse, -0.1, half);
  changes.add("order.unsure_in_time", of(limited({{0.0, 1.5}}, {1.49, 1.51}, 2.06, 0.3), "order", "order of known"),
              Change::inconclusive, 0.06, 0.01 * std::sqrt(901.0));
}

// --- costs ---

// One level, timed five times: by 1 %, 2 %, ... longer than the shortest.
Snapshot timed(double shortest, std::optional<double> instructions = {}) {
  CostRecord record;
  record.case_name = "known";
  for (int k = 0; k < 5; ++k) record.wall_s.push_back(shortest * (1 + 0.01 * k));
  record.instructions = instructions;
  Snapshot all;
  all.costs[record.key()] = {record};
  return all;
}

void add_costs(Changes changes) {
  const auto of = [](const Snapshot& before, const Snapshot& after, const std::string& quantity) {
    return finding_in(compare(before, after), "cost", quantity);
  };
  changes.add("time.worse", of(timed(1), timed(1.3), "wall"), Change::worse, 1.3);
  changes.add("time.better", of(timed(1.3), timed(1), "wall"), Change::better, 1 / 1.3);
  changes.add("time.same", of(timed(1), timed(1.02), "wall"), Change::same, 1.02);
  changes.add("time.unsure", of(timed(1), timed(1.1), "wall"), Change::inconclusive, 1.1);
  // Counts decide where times do not say that it is worse: beyond 2 %.
  changes.add("count.same", of(timed(1, 1e9), timed(1.1, 1.01e9), "instructions"), Change::same, 1.01);
  changes.add("count.worse", of(timed(1, 1e9), timed(1, 1.03e9), "instructions"), Change::worse, 1.03);
  changes.add("count.better", of(timed(1, 1e9), timed(1.02, 0.96e9), "instructions"), Change::better, 0.96);
  changes.add("count.overruled", of(timed(1, 1e9), timed(1.3, 1e9), "wall"), Change::worse, 1.3);
}

}  // namespace

KnownAnswers comparison_answers() {
  KnownAnswers all;
  add_studies(Changes(all));
  add_limits(Changes(all));
  add_costs(Changes(all));
  return all;
}

}  // namespace plumbline
