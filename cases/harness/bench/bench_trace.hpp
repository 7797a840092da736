// Counts the floating-point operations of an expression by computing it with numbers that remember how they were made.
// The same operation on the same numbers counts once, one whose result nobody uses not at all: as a compiler has it.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace plumbline {

class Trace {
 public:
  struct Step {
    char operation;  // one of + - * / f (any other function); i: an input, c: a constant
    int left, right;
  };
  int input() { return add({'i', inputs_++, 0}); }
  int constant(double value) {
    const auto [at, is_new] = constants_.try_emplace(value, static_cast<int>(steps_.size()));
    if (is_new) steps_.push_back({'c', 0, 0});
    return at->second;
  }
  int apply(char operation, int left, int right) {
    const int zero = constant(0), one = constant(1);
    if (operation == '*' && (left == zero || right == zero)) return zero;
    if ((operation == '+' || operation == '*') && left == (operation == '+' ? zero : one)) return right;
    if ((operation == '+' || operation == '-') && right == zero) return left;
    if ((operation == '*' || operation == '/') && right == one) return left;
    if ((operation == '+' || operation == '*') && right < left) std::swap(left, right);
    return add({operation, left, right});
  }
  // Operations that the results need, sums, differences, products, quotients and functions alike.
  int operations(const std::vector<int>& results) const {
    std::vector<char> needed(steps_.size());
    for (const int r : results) needed[static_cast<std::size_t>(r)] = 1;
    int count = 0;
    for (std::size_t k = steps_.size(); k-- > 0;) {  // operands stand before what is made of them
      const Step& step = steps_[k];
      if (!needed[k] || step.operation == 'i' || step.operation == 'c') continue;
      ++count;
      needed[static_cast<std::size_t>(step.left)] = needed[static_cast<std::size_t>(step.right)] = 1;
    }
    return count;
  }

  static Trace& current() {
    static Trace trace;
    return trace;
  }

 private:
  int add(const Step& step) {
    const auto [at, is_new] = known_.try_emplace({step.operation, step.left, step.right},
                                                 static_cast<int>(steps_.size()));
    if (is_new) steps_.push_back(step);
    return at->second;
  }
  std::vector<Step> steps_;
  std::map<std::tuple<char, int, int>, int> known_;
  std::map<double, int> constants_;
  int inputs_ = 0;
};

// A number on Trace::current().
class Traced {
 public:
  Traced(double constant = 0) : at_(Trace::current().constant(constant)) {}
  static Traced input() { return Traced(Trace::current().input(), 0); }
  int at() const { return at_; }

  friend Traced operator+(const Traced& a, const Traced& b) { return made('+', a, b); }
  friend Traced operator-(const Traced& a, const Traced& b) { return made('-', a, b); }
  friend Traced operator*(const Traced& a, const Traced& b) { return made('*', a, b); }
  friend Traced operator/(const Traced& a, const Traced& b) { return made('/', a, b); }
  Traced operator-() const { return *this * -1.0; }
  Traced& operator+=(const Traced& o) { return *this = *this + o; }
  Traced& operator-=(const Traced& o) { return *this = *this - o; }
  Traced& operator*=(const Traced& o) { return *this = *this * o; }
  // A square root, a maximum, a choice, ...
  friend Traced function_of(const Traced& a, const Traced& b) { return made('f', a, b); }

 private:
  Traced(int at, int) : at_(at) {}
  static Traced made(char operation, const Traced& a, const Traced& b) {
    return Traced(Trace::current().apply(operation, a.at_, b.at_), 0);
  }
  int at_;
};

}  // namespace plumbline
