#include "reference/carlson.hpp"

#include <stdexcept>

#include "reference/circle.hpp"

namespace plumbline::reference {
namespace {

constexpr double deviation = 1.5e-3;  // of an argument from the mean: its sixth power is below the rounding

struct Triple {
  Bounded x, y, z;
};

/// [DLMF 19.26.18]: lambda = sqrt x sqrt y + sqrt y sqrt z + sqrt z sqrt x; x becomes (x + lambda)/4, and so on.
Bounded duplicate(Triple& t) {
  const Bounded x = sqrt(t.x), y = sqrt(t.y), z = sqrt(t.z);
  const Bounded lambda = x * y + y * z + z * x;
  t = {Bounded(0.25) * (t.x + lambda), Bounded(0.25) * (t.y + lambda), Bounded(0.25) * (t.z + lambda)};
  return lambda;
}

double largest_deviation(const Triple& t, double mean) {
  const double x = std::abs(1 - t.x.value / mean), y = std::abs(1 - t.y.value / mean);
  return std::max({x, y, std::abs(1 - t.z.value / mean)});
}

/// The error of leaving out what is beyond the fifth order, from the deviation.
Bounded truncated(Bounded series, double error) { return {series.value, (series.bound + error) * rounding::inflate}; }

constexpr int most_duplications = 600;  // each takes two binary digits off the ratio of the arguments

}  // namespace

Bounded carlson_RF(Bounded x, Bounded y, Bounded z) {
  Triple t{x, y, z};
  for (int n = 0; n < most_duplications; ++n) {
    const Bounded mean = (t.x + t.y + t.z) / 3.0;
    const double e = largest_deviation(t, mean.value);
    if (e < deviation) {
      const Bounded a = Bounded(1) - t.x / mean, b = Bounded(1) - t.y / mean, c = -(a + b);
      const Bounded second = a * b - c * c, third = a * b * c;
      const Bounded series = Bounded(1) - second / 10.0 + third / 14.0 + second * second / 24.0 -
                             Bounded(3) * second * third / 44.0;  // [DLMF 19.36.1]
      return truncated(series, std::pow(e + 1e-12, 6) / (4 * (1 - deviation)) * 1.01) / sqrt(mean);
    }
    duplicate(t);
  }
  throw std::domain_error("carlson_RF: arguments out of range");
}

Bounded carlson_RD(Bounded x, Bounded y, Bounded z) {
  Triple t{x, y, z};
  Bounded sum = 0.0;
  double quarter = 1;  // 4^-n
  for (int n = 0; n < most_duplications; ++n, quarter *= 0.25) {
    const Bounded mean = (t.x + t.y + Bounded(3) * t.z) / 5.0;
    const double e = largest_deviation(t, mean.value);
    if (e < deviation) {
      const Bounded a = Bounded(1) - t.x / mean, b = Bounded(1) - t.y / mean, c = -(a + b) / 3.0;
      const Bounded ab = a * b, cc = c * c;
      const Bounded second = ab - Bounded(6) * cc, third = (Bounded(3) * ab - Bounded(8) * cc) * c;
      const Bounded fourth = Bounded(3) * (ab - cc) * cc, fifth = ab * cc * c;
      const Bounded series = Bounded(1) - Bounded(3) * second / 14.0 + third / 6.0 +
                             Bounded(9) * second * second / 88.0 - Bounded(3) * fourth / 22.0 -
                             Bounded(9) * second * third / 52.0 + Bounded(3) * fifth / 26.0;  // [DLMF 19.36.2]
      const double error = 3 * std::pow(e + 1e-12, 6) / std::pow(1 - deviation, 1.5) * 1.01;
      return Bounded(3) * sum + Bounded(quarter) * truncated(series, error) / (mean * sqrt(mean));
    }
    const Bounded before = t.z;
    const Bounded lambda = duplicate(t);
    sum = sum + Bounded(quarter) / (sqrt(before) * (before + lambda));  // [DLMF 19.26.20]
  }
  throw std::domain_error("carlson_RD: arguments out of range");
}

LegendreFD legendre_FD(Bounded sine, Bounded cosine, Bounded delta) {
  const Bounded c = cosine * cosine, d = delta * delta;
  return {sine * carlson_RF(c, d, 1.0),                              // [DLMF 19.25.5]
          sine * sine * sine * carlson_RD(c, d, 1.0) / Bounded(3)};  // [DLMF 19.25.13]
}

// Gauss's means a, b of 1 and k' and half their differences c, c' = c^2/(4 a'), give K - E = K sum 2^(n-1) c_n^2 from
// n = 0 [DLMF 19.8.6]. As c_0 = k that is k^2 D = K (k^2/2 + sum from 1), hence C = K sum 2^n e_n^2 with e = c/k^2.
CompleteKDC complete_KDC(Bounded square, Bounded complement) {
  Bounded a = Bounded(0.5) * (Bounded(1) + complement), b = sqrt(complement);
  Bounded e = Bounded(1) / (Bounded(4) * a), sum = 0.0;
  double two = 2, rest = rounding::infinity;
  for (int n = 1; n < 64; ++n, two *= 2) {
    const Bounded term = Bounded(two) * e * e;
    sum = sum + term;
    rest = highest(term) / 4;  // terms fall to an eighth, and faster: c <= a
    if (std::abs(a.value - b.value) <= 4 * rounding::unit * a.value && rest <= rounding::unit * sum.value) break;
    const Bounded mean = Bounded(0.5) * (a + b);  // [DLMF 19.8.5]
    b = sqrt(a * b);
    a = mean;
    e = e * e * square / (Bounded(4) * a);
  }
  const Bounded K = pi / (Bounded(2) * hull(a, b));
  const Bounded C = K * Bounded(sum.value, (sum.bound + rest) * rounding::inflate);
  return {K, Bounded(0.5) * (K + square * C), C};
}

}  // namespace plumbline::reference
