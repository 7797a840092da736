// Problems that references refuse: one number at a time on both sides of where its range ends.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/estimators/answers.hpp"
#include "reference/parameter.hpp"

namespace plumbline::reference::refused_problems {

// Whether work names the parameter that it refuses.
template <class Work>
bool refused(const std::string& key, const Work& work) {
  try {
    work();
  } catch (const ParameterError& error) {
    return error.key == key;
  }
  return false;
}

// Rows of one reference, which takes `valid`.
template <class Solution, class Problem>
class Refused {
 public:
  using Members = std::vector<std::pair<const char*, double Problem::*>>;

  Refused(KnownAnswers& all, std::string name, Problem valid = {})
      : all_(all),
        name_(std::move(name)),
        valid_(std::move(valid)) {}

  const Refused& positive(const Members& members) const {
    for (const auto& [key, member] : members) {
      refuses(key, member, 0);
      refuses(key, member, infinity);
    }
    return *this;
  }
  const Refused& not_negative(const Members& members) const {
    for (const auto& [key, member] : members) {
      takes(key, member, 0);
      refuses(key, member, -least);
      refuses(key, member, infinity);
    }
    return *this;
  }
  const Refused& finite(const Members& members) const {
    for (const auto& [key, member] : members) {
      refuses(key, member, infinity);
      refuses(key, member, -infinity);
    }
    return *this;
  }
  // Ends that belong to the range are taken, others not.
  const Refused& between(const char* key, double Problem::*member, double low, double high, bool with_low,
                         bool with_high) const {
    if (with_low) takes(key, member, low);
    if (with_high) takes(key, member, high);
    refuses(key, member, with_low ? low - least : low);
    refuses(key, member, with_high ? high + least : high);
    const double near = 0.01 * (high - low);
    takes(key, member, low + near);
    takes(key, member, high - near);
    return *this;
  }
  const Refused& above(const char* key, double Problem::*member, double low) const {
    refuses(key, member, low);
    refuses(key, member, infinity);
    takes(key, member, low + 0.01);
    return *this;
  }
  template <class Number>
  const Refused& refuses(const char* key, Number Problem::*member, double value) const {
    Problem changed = valid_;
    changed.*member = static_cast<Number>(value);
    return refuses(key, changed);
  }
  const Refused& refuses(const char* key, const Problem& problem) const {
    all_.push_back(yes(label(key), refused(key, [&] { Solution{problem}; })));
    return *this;
  }
  template <class Number>
  const Refused& takes(const char* key, Number Problem::*member, double value) const {
    Problem changed = valid_;
    changed.*member = static_cast<Number>(value);
    all_.push_back(no(label(key) + ".taken", throws<ParameterError>([&] { Solution{changed}; })));
    return *this;
  }
  // Of a solution for the valid problem.
  template <class Work>
  const Refused& refuses_argument(const char* key, const Work& work) const {
    const Solution solution{valid_};
    all_.push_back(yes(label(key), refused(key, [&] { work(solution); })));
    return *this;
  }
  template <class Work>
  const Refused& takes_argument(const char* key, const Work& work) const {
    const Solution solution{valid_};
    all_.push_back(no(label(key) + ".taken", throws<ParameterError>([&] { work(solution); })));
    return *this;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity(), least = 1e-9;

  std::string label(const char* key) const { return name_ + "." + key; }

  KnownAnswers& all_;
  std::string name_;
  Problem valid_;
};

// Parts of the trial, by what the references are about.
void add_refused_strings(KnownAnswers& all);
void add_refused_solids(KnownAnswers& all);
void add_refused_sheets(KnownAnswers& all);
void add_refused_gases(KnownAnswers& all);

}  // namespace plumbline::reference::refused_problems
