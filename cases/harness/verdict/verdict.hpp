// Gates, and what a measurement makes of them. The one place where a verdict is decided.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace plumbline {

struct OrderFit;

enum class Verdict { pass, fail, inconclusive, xfail, xpass, invalid, none };
inline constexpr std::array all_verdicts{Verdict::pass,  Verdict::fail,    Verdict::inconclusive, Verdict::xfail,
                                         Verdict::xpass, Verdict::invalid, Verdict::none};

// Where the number in a gate comes from.
enum class Origin {
  theory,           // derived: order of a scheme, stability limit
  literature,       // published
  reference_bound,  // the reference's own error
  identity,         // holds exactly but for rounding
  requirement,      // what users of such a code expect, said in words and compared with something
  regression        // the yardstick is a run of this program: an earlier measurement (two-sided, with date and commit,
                    // guards against drift) or a reference run made beside it (the reason says the factor)
};
inline constexpr std::array all_origins{Origin::theory,   Origin::literature,  Origin::reference_bound,
                                        Origin::identity, Origin::requirement, Origin::regression};

// Spelled as in results: "PASS", "reference_bound".
std::string_view name(Verdict verdict);
std::string_view name(Origin origin);
std::optional<Verdict> verdict_from(std::string_view name);
// Until 0.8 takes "frozen" for regression and "target" for requirement.
std::optional<Origin> origin_from(std::string_view name);

// Closed interval; an end that is absent does not bind.
struct Range {
  std::optional<double> low, high;
  bool contains(double value) const;  // false for NaN, and for an unbounded range
};

// A run that stops at a step in [step_low, step_high] on this field.
struct StopBand {
  long step_low = 0;
  long step_high = 0;
  std::string field;
};

// Asserts *how* a gate fails: the wrong value lies in `band`, or the run stops as `stops` says.
struct ExpectedFailure {
  std::string cause;
  Range band;
  std::optional<StopBand> stops;
  std::string measured_on;  // date and commit of the measurement behind the band; empty if it is not our own
};

struct Gate {
  std::string id;
  std::string quantity;
  Range expected;  // in the unit of the quantity
  Origin origin = Origin::requirement;
  std::string reason;  // why this number
  std::optional<ExpectedFailure> expected_failure;
  bool order = false;       // judge the 95 % interval, not the value
  std::string measured_on;  // Origin::regression, stored measurement: "2026-11-21 a1b2c3d"; empty: reference run
};

struct Measured {
  struct Stop {
    long step = 0;
    std::string field;
  };
  std::optional<double> value;
  std::optional<std::pair<double, double>> interval;  // low, high; for order gates
  double reference_bound = 0;  // bound of the error that the reference brings into `value`, same unit
  double scale = 0;            // characteristic size of what was compared; sets the ulp of the reference
  bool invalid = false;        // the measurement itself failed; `note` says how
  bool inconclusive = false;   // too little data to judge; `note` says why
  std::string note;
  std::optional<Stop> stopped;  // the run ended early

  static Measured of(double value);          // a number without more
  static Measured failed(std::string note);  // the measurement itself
};

struct Judgement {
  Verdict verdict = Verdict::none;
  std::optional<double> margin;  // see `margin`; absent where no value was compared
  std::string note;
};

// What `judge` needs of an order fit.
Measured measured_order(const OrderFit& fit);

// Throws std::invalid_argument naming the gate if its declaration is not complete: no id, quantity or
// reason; neither end, a NaN or infinite end, low above high; an order gate without exactly one end; a
// regression gate that names a stored measurement and is one-sided or lacks date or commit, or that names none and is
// two-sided; an expected failure without cause, without band
// and stop, with an impossible band, or with a band that lies wholly inside the expected range (it could
// not fail).
void validate(const Gate& gate);

// The gate's tolerance, its margin: half the width of a two-sided range, the size of the bound of a
// one-sided one (an error of at most 0.007 has the tolerance 0.007; a bound of 0 has none).
double tolerance(const Range& expected);

// How far inside the expected range: 0 at its end, negative beyond, in units of the tolerance. An upper
// bound b gives 1 - value/b (b > 0), a lower one value/b - 1, two ends the distance to the nearer end over
// half the width. Absent where the tolerance is 0.
std::optional<double> margin(const Range& expected, double value);

// The verdict, in this order:
//  1. `invalid` -> INVALID.
//  2. A stopped run -> XFAIL where the gate's expected failure names its step and field; otherwise FAIL.
//  3. The reference is not good enough -> INVALID: its bound is above 1 % of the tolerance and above 10 ulp
//     of the scale, or not a number. (Order gates are exempt: there the estimator sets single levels
//     aside.)
//  4. A value or interval that is not a number -> INVALID.
//  5. `inconclusive` -> INCONCLUSIVE.
//  6. No value, or no interval for an order gate, or a value outside its own interval -> INVALID.
//  7. The gate is met (value in the range; interval of an order gate wholly on the right side of the one
//     bound) -> PASS, or XPASS where a failure is expected.
//  8. It is not met: FAIL, or XFAIL where the value lies in the band of the expected failure.
//  9. The interval of an order gate straddles the bound: INCONCLUSIVE; but FAIL where a failure is expected
//     and the point estimate is outside its band. An expected failure that is not established is not green.
// The margin of an order gate is that of the interval's end next to the bound, so that it is >= 0 exactly
// where the gate is met. Throws what `validate` throws.
Judgement judge(const Gate& gate, const Measured& measured);

struct Counts {
  std::array<std::size_t, all_verdicts.size()> by_verdict{};
  std::size_t operator[](Verdict verdict) const { return by_verdict[static_cast<std::size_t>(verdict)]; }
  std::size_t total() const;
};
Counts tally(std::span<const Verdict> verdicts);

// The verdict of a whole: the worst of INVALID, FAIL, XPASS, INCONCLUSIVE, XFAIL, PASS; NONE if nothing was
// judged.
Verdict overall(std::span<const Verdict> verdicts);

// 0 if every verdict is PASS, XFAIL or NONE (or INCONCLUSIVE where allowed), else 1. An empty set is 1:
// nothing was judged; a run without gates passes NONE.
int exit_status(std::span<const Verdict> verdicts, bool allow_inconclusive);

}  // namespace plumbline
