// The largest of values that are not negative, read pack by pack; a NaN stays.
#pragma once

#include <limits>

#include "kernel/pack.hpp"

namespace plumbline {

// Lane by lane.
[[gnu::always_inline]] inline Pack larger(const Pack& a, const Pack& b) { return choose(b <= a || isnan(a), a, b); }

class Largest {
 public:
  // The first `count` lanes.
  [[gnu::always_inline]] inline void include(const Pack& values, int count) {
    lanes_ = larger(lanes_, kept(values, count));
  }
  // Zero if there were none.
  double value() const { return any_of(isnan(lanes_)) ? std::numeric_limits<double>::quiet_NaN() : hmax(lanes_); }

 private:
  Pack lanes_ = 0.0;
};

}  // namespace plumbline
