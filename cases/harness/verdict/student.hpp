// Student's t-distribution.
#pragma once

namespace plumbline {

// The value that is exceeded with a probability of 2.5 %: an interval of so many standard errors either side is one of
// 95 %. `degrees` of freedom > 0, not necessarily whole; infinity at 0 and below, where nothing is known of the scatter.
double student_quantile(double degrees);

}  // namespace plumbline
