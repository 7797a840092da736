// Gradients are the derivatives of values, and both are as continuous as is claimed: what a random nodal field changes by
// along a line is the integral of its gradient, exactly. Lines are cut into pieces, and those where both differ are halved
// again and again, so that kinks are found wherever they are. Where gradients are means over domains, lines are cut into many
// pieces, and those along which values or gradients change more than continuous ones could are halved.
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "cases/harness/parts/shape_gates.hpp"

namespace plumbline {
namespace {

constexpr unsigned long paths_seed = 40;
constexpr double agreed = 1e-13;            // difference on a piece that is rounding
constexpr double shortest = 0x1p-36;        // of pieces, in cells
constexpr double close = 0x1p-20;           // pieces that short show jumps, cells
constexpr std::size_t most_pieces = 1000;   // that are halved at once: more is no matter of kinks
constexpr double steepest = 10;             // slopes and curvatures, a cell
constexpr double most_jump = 1e-5;          // what these make of a piece that is close
constexpr int pieces_a_cell = 8;            // to begin with
constexpr int pieces_of_domains = 1000;     // a cell: along these, what is continuous changes by a hundredth
constexpr double most_integral_off = 1e-9;  // thirty kinks, each a jump of 2/h in the gradient, on the shortest pieces

struct PathFindings {
  double off = 0;                            // integral of |derivative of the values - gradient| along the line
  double value_jump = 0, gradient_jump = 0;  // the largest on close pieces, the latter times h
};

struct Piece {
  double from, to;  // shares of the line
};

ProbePoint at(const ProbePoint& from, const ProbePoint& to, double share) {
  ProbePoint point = from;
  for (std::size_t d = 0; d < 3; ++d) point.x[d] = share == 1 ? to.x[d] : from.x[d] + share * (to.x[d] - from.x[d]);
  return point;
}

// Gauss points of a piece behind its ends: exact for gradients that are polynomials of degree 5.
constexpr int points_a_piece = 5;
const double abscissae[] = {0, 1, 0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
constexpr double gauss[] = {0, 0, 5.0 / 18, 8.0 / 18, 5.0 / 18};

class Path {
 public:
  // derivatives: gradients have to be those of the values.
  Path(const ShapeProbe& probe, bool derivatives, const ProbePoint& from, const ProbePoint& to)
      : probe_(probe),
        derivatives_(derivatives),
        from_(from),
        to_(to),
        field_(random_field(probe, paths_seed)) {
    for (std::size_t d = 0; d < static_cast<std::size_t>(probe.grid().dim); ++d) way_.push_back(to.x[d] - from.x[d]);
    for (const double w : way_) cells_ += w * w / (probe.grid().h * probe.grid().h);
    cells_ = std::sqrt(cells_);
  }

  PathFindings walk() {
    ProbeRandom random(paths_seed + 1);
    std::vector<double> cuts{0, 1};
    for (int k = 0; k < (derivatives_ ? pieces_a_cell : pieces_of_domains) * cells_; ++k) cuts.push_back(random(0, 1));
    std::sort(cuts.begin(), cuts.end());
    std::vector<Piece> pieces;
    for (std::size_t k = 1; k < cuts.size(); ++k) pieces.push_back({cuts[k - 1], cuts[k]});
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(field_.cols());
    while (!pieces.empty()) pieces = halved(pieces, sum);
    found_.off = sum.hasNaN() ? std::numeric_limits<double>::quiet_NaN() : sum.maxCoeff();
    return found_;
  }

 private:
  // Pieces whose ends differ by the integral of the gradient are done; the halves of the others are left.
  std::vector<Piece> halved(const std::vector<Piece>& pieces, Eigen::ArrayXd& sum) {
    std::vector<ProbePoint> points;
    for (const Piece& piece : pieces) {
      for (const double a : abscissae) points.push_back(at(from_, to_, piece.from + a * (piece.to - piece.from)));
    }
    const Interpolated all = probe_.interpolated(points, field_);
    std::vector<Piece> rest;
    const bool too_many = derivatives_ && pieces.size() > most_pieces;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Piece& piece = pieces[k];
      const auto row = static_cast<Eigen::Index>(k) * points_a_piece;
      const double share = piece.to - piece.from, length = share * cells_;
      const Eigen::ArrayXd change = (all.value.row(row + 1) - all.value.row(row)).transpose();
      Eigen::ArrayXd off = change;
      for (std::size_t d = 0; d < way_.size(); ++d) {
        for (int g = 2; g < points_a_piece; ++g) {
          off -= gauss[g] * share * way_[d] * all.gradient[d].row(row + g).transpose().array();
        }
      }
      off = off.abs();
      const bool unlike = derivatives_ ? (off > agreed).any() : jump(all, row, change) > steepest * length;
      if (unlike && length > (derivatives_ ? shortest : close / 2) && !too_many) {
        const double middle = piece.from + share / 2;
        rest.insert(rest.end(), {{piece.from, middle}, {middle, piece.to}});
        continue;
      }
      sum += off;
      if (length <= close) note_jumps(all, row, change);
    }
    return rest;
  }

  void note_jumps(const Interpolated& all, Eigen::Index row, const Eigen::ArrayXd& change) {
    found_.value_jump = std::max(found_.value_jump, change.abs().maxCoeff());
    found_.gradient_jump = std::max(found_.gradient_jump, gradient_jump(all, row));
  }
  // The larger of both.
  double jump(const Interpolated& all, Eigen::Index row, const Eigen::ArrayXd& change) const {
    return std::max(change.abs().maxCoeff(), gradient_jump(all, row));
  }
  // Along a piece, times h.
  double gradient_jump(const Interpolated& all, Eigen::Index row) const {
    double most = 0;
    for (const Eigen::MatrixXd& gradient : all.gradient) {
      most = std::max(most, (gradient.row(row + 1) - gradient.row(row)).cwiseAbs().maxCoeff() * probe_.grid().h);
    }
    return most;
  }

  const ShapeProbe& probe_;
  bool derivatives_;
  ProbePoint from_, to_;
  Eigen::MatrixXd field_;
  std::vector<double> way_;  // m
  double cells_ = 0;
  PathFindings found_;
};

// Across the grid along each direction: slanted from side to side, and along the sides themselves.
PathFindings across(const ShapeProbe& probe, bool derivatives) {
  const GridSpec& grid = probe.grid();
  ProbeRandom random(paths_seed + 2);
  PathFindings worst;
  for (std::size_t along = 0; along < static_cast<std::size_t>(grid.dim); ++along) {
    for (const bool on_side : {false, true}) {
      if (on_side && grid.dim == 1) continue;
      ProbePoint from, to;
      from.half = to.half = 0.3 * grid.h;
      for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
        const double extent = grid.cells[d] * grid.h;
        from.x[d] = grid.origin[d] + (d == along || on_side ? 0 : random(0, extent));
        to.x[d] = d == along ? grid.origin[d] + extent : on_side ? from.x[d] : grid.origin[d] + random(0, extent);
      }
      const PathFindings found = Path(probe, derivatives, from, to).walk();
      if (!(found.off <= worst.off)) worst.off = found.off;
      worst.value_jump = std::max(worst.value_jump, found.value_jump);
      worst.gradient_jump = std::max(worst.gradient_jump, found.gradient_jump);
    }
  }
  return worst;
}

// Whether gradients have to be the derivatives of values.
bool derivatives(const ShapeSubject& subject) { return !subject.entry->domain_gradients; }

// Found by the first gate that asks.
class SharedFindings {
 public:
  explicit SharedFindings(SharedSubject subject) : subject_(std::move(subject)) {}
  const PathFindings& operator()() {
    std::call_once(done_, [&] { found_ = across(*subject_->walled, derivatives(*subject_)); });
    return found_;
  }

 private:
  SharedSubject subject_;
  std::once_flag done_;
  PathFindings found_;
};

}  // namespace

std::vector<MeasuredGate> shape_path_gates(const SharedSubject& subject) {
  const std::string where = geometry_names()[subject->geometry];
  const auto findings = std::make_shared<SharedFindings>(subject);
  std::vector<MeasuredGate> all{
      {"continuity",
       gate_row("continuity", "value/" + where, "largest change of a random field within 2^-20 cells", {{}, most_jump},
                Origin::theory,
                "values are continuous, or energy is not kept where points cross cells; slopes of ten a cell"),
       "values of two cells that do not meet at their side", [findings] { return plain((*findings)().value_jump); }}};
  if (derivatives(*subject)) {
    all.insert(
        all.begin(),
        {"gradient",
         gate_row(
             "gradient", "derivative/" + where,
             "integral of |d(N u)/ds - (grad N u) . t| along lines across the grid and along its sides, u random "
             "within 1",
             {{}, most_integral_off}, Origin::theory,
             "the gradient is the derivative of the value; kinks are enclosed to 2^-36 cells, where thirty of them "
             "leave 1e-9"),
         "the gradient is that of another function, or lacks a factor",
         [findings] { return plain((*findings)().off); }});
  }
  if (subject->entry->offers.count(Trait::smooth_gradients) > 0) {
    all.push_back({"continuity",
                   gate_row("continuity", "gradient/" + where,
                            "largest change of a random field's gradient within 2^-20 cells, in cells", {{}, most_jump},
                            Origin::theory, "the shape offers the trait smooth-gradients; curvatures of ten a cell"),
                   "gradients of two cells that do not meet at their side",
                   [findings] { return plain((*findings)().gradient_jump); }});
  }
  return all;
}

}  // namespace plumbline
