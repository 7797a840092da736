#include "reference/quadrature.hpp"

#include "reference/gsl_owned.hpp"

namespace plumbline::reference {
namespace {

constexpr int points = 32, deepest = 40;

class Rule {
 public:
  explicit Rule(const std::function<Bounded(double)>& f) : f_(f), table_(gsl_integration_glfixed_table_alloc(points)) {}

  Bounded panel(double low, double high) const {
    double sum = 0, own = 0, size = 0;
    for (int i = 0; i < points; ++i) {
      double x = 0, weight = 0;
      gsl_integration_glfixed_point(low, high, static_cast<std::size_t>(i), &x, &weight, table_.get());
      const Bounded value = f_(x);
      sum += weight * value.value;
      own += weight * value.bound;
      size += weight * std::abs(value.value);
    }
    return {sum, own + points * rounding::unit * size};
  }

  Bounded halved(double low, double high, Bounded whole, double small, int depth) const {
    const double middle = 0.5 * (low + high);
    const Bounded left = panel(low, middle), right = panel(middle, high);
    const Bounded both = left + right;
    const double difference = std::abs(both.value - whole.value);
    // A difference below the bounds of f's own values is rounding: halving would not make it smaller.
    if (difference <= std::max(small, both.bound + whole.bound) || depth == deepest) {
      return {both.value, both.bound + difference};
    }
    return halved(low, middle, left, small, depth + 1) + halved(middle, high, right, small, depth + 1);
  }

 private:
  const std::function<Bounded(double)>& f_;
  Owned<gsl_integration_glfixed_table> table_;
};

}  // namespace

Bounded integrate(const std::function<Bounded(double)>& f, double low, double high) {
  const Rule rule(f);
  const Bounded whole = rule.panel(low, high);
  return rule.halved(low, high, whole, rounding::unit * std::abs(whole.value), 0);
}

}  // namespace plumbline::reference
