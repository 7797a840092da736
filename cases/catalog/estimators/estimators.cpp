// What the harness itself computes of runs, of data whose answers closed forms give.
#include "cases/catalog/estimators/answers.hpp"

namespace plumbline::estimators {
namespace {

constexpr double of_bisection = 1.5e-9, of_close_pieces = 1e-5, of_differences = 1e-7, of_floats = 1e-7;
constexpr const char* as_floats = "numbers that are rounded to single precision, 2^-24 or 6e-8 of their size";

// The estimators, in the order of what they take: levels, samples, fields, histories, steps, gates.
const std::vector<KnownTrial> all_estimators{
    {"lines", "straight lines and Student's t", "Residuals orthogonal to the line leave it as it is.", line_answers,
     few_roundings, rounded},
    {"orders", "observed orders and their intervals", "Power laws with known scatter have known orders and intervals.",
     order_answers, few_roundings, rounded},
    {"samples", "ratios of times, bands, costs at equal error", "Powers of three order all ratios of two samples.",
     sample_answers, few_roundings, rounded},
    {"norms", "norms of errors", "Of two points they are sums by hand.", norm_answers, few_roundings, rounded},
    {"periods", "extremes and periods", "A parabola through samples of a parabola is that parabola.", period_answers,
     few_roundings, rounded},
    {"halvings", "limits for small steps", "Polynomials of the step are extrapolated exactly.", halving_answers,
     few_roundings, rounded},
    {"growth", "growth of perturbations in runs", "A size that grows by a known factor a step.", growth_answers,
     few_roundings, rounded},
    {"limits", "largest stable steps", "Steps that grow beyond known ends.", limit_answers, of_bisection,
     "two bisections to a relative width of 1e-9, of which one counts twice: three halves of it at most"},
    {"comparisons", "changes between two results folders", "Studies, limits and times that change by a known amount.",
     comparison_answers, few_roundings, rounded},
    {"handed-in", "final states of other programs", "Points whose sums are known by hand.", handed_in_answers,
     few_roundings, rounded},
    {"verdicts", "verdicts and margins", "The rules of judgement, row by row.", verdict_answers, few_roundings,
     rounded},
    {"shapes", "gates of shapes", "Shapes that are wrong by a known amount.", shape_answers, few_roundings, rounded},
    {"contacts", "gates of contact", "Laws that are wrong by a known amount.", contact_answers, few_roundings, rounded},
    {"materials", "gates of materials", "A solid that is wrong by a known amount.", material_answers, of_differences,
     "differences of 1e-5 in strain, whose own errors are below 1e-7"},
    {"paths", "gates of shapes along lines", "Values or gradients that jump by a known amount.", path_answers,
     of_close_pieces,
     "slopes and curvatures of ten a cell along the pieces of 2^-20 cells on which jumps are seen; integrals are "
     "nearer: third derivatives that jump within a hundredth of a cell, cubed"},
    {"frames", "instants and points of snapshots", "Points that drift by a known velocity, without a force.",
     frame_answers, of_floats, as_floats},
    {"frame-values", "stresses of snapshots", "Stresses whose principal ones are known.", frame_value_answers,
     of_floats, as_floats},
    {"starts", "starts for other programs", "Scenes of a few points, read back column by column.", start_answers,
     few_roundings, rounded},
    {"files", "files of HDF5", "Numbers and texts of all kinds, read as they were written.", file_answers,
     few_roundings, rounded},
    {"final-states", "reading of final states", "Files of two points, read and completed by hand.", final_state_answers,
     few_roundings, rounded},
    {"scores", "scores of final states", "Two points whose speeds are off by a known amount.", score_answers,
     few_roundings, rounded}};

Case estimators() { return known_answers_case("estimators", all_estimators); }
PLUMBLINE_CASE(estimators);

}  // namespace
}  // namespace plumbline::estimators
