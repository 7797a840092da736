// What the harness itself computes, of data whose answers closed forms give.
#include "cases/catalog/estimators/answers.hpp"

namespace plumbline::estimators {
namespace {

constexpr double of_bisection = 1.5e-9, of_close_pieces = 1e-5, of_differences = 1e-7, of_small_shares = 1e-9,
                 of_derivatives = 1e-8, of_floats = 1e-7;
constexpr const char* as_bisected =
    "two bisections to a relative width of 1e-9, of which one counts twice: three halves of it at most";
constexpr const char* as_floats = "numbers that are rounded to single precision, 2^-24 or 6e-8 of their size";

// In the order of answers.hpp.
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
    {"comparisons", "changes between two results folders", "Studies, limits and times that change by a known amount.",
     comparison_answers, few_roundings, rounded},
    {"verdicts", "verdicts and margins", "The rules of judgement, row by row.", verdict_answers, few_roundings,
     rounded},
    {"rules", "ranges, bands, names, lattices", "Each rule at both sides of where it changes.", rule_answers,
     few_roundings, rounded},
    {"sizes", "what runs are foreseen to take", "Scenes whose points grow as known powers.", size_answers,
     few_roundings, rounded},
    {"flows", "flows on which steps are timed", "Sums of waves over a lattice, and columns counted by hand.",
     flow_answers, few_roundings, rounded},
    {"growth", "growth of perturbations in runs", "A size that grows by a known factor a step.", growth_answers,
     few_roundings, rounded},
    {"limits", "largest stable steps", "Steps that grow beyond known ends.", limit_answers, of_bisection, as_bisected},
    {"contents", "what the laboratory reads off scenes", "Boxes and chains whose edges are known by hand.",
     content_answers, few_roundings, rounded},
    {"step-maps", "a step as a map of numbers", "States set by hand are found in the columns.", step_map_answers,
     few_roundings, rounded},
    {"waves", "matrices of steps of a bar", "One point a cell, whose dispersion is known.", wave_answers,
     of_derivatives, "derivatives of a step by differences, good to 1e-9, of which a radius sums a few"},
    {"oscillations", "gates of integrators", "Runge-Kutta steps on springs, and points that fall.", oscillation_answers,
     of_bisection, as_bisected},
    {"carried", "columns and runs that are carried on", "Each number has a value that no other has.", carried_answers,
     few_roundings, rounded},
    {"frames", "instants and points of snapshots", "Points that drift by a known velocity, without a force.",
     frame_answers, of_floats, as_floats},
    {"frame-values", "stresses of snapshots", "Stresses whose principal ones are known.", frame_value_answers,
     of_floats, as_floats},
    {"files", "files of HDF5", "Numbers and texts of all kinds, read as they were written.", file_answers,
     few_roundings, rounded},
    {"starts", "starts for other programs", "Scenes of a few points, read back column by column.", start_answers,
     few_roundings, rounded},
    {"final-states", "reading of final states", "Files of two points, read and completed by hand.", final_state_answers,
     few_roundings, rounded},
    {"handed-in", "final states of other programs", "Points whose sums are known by hand.", handed_in_answers,
     few_roundings, rounded},
    {"scores", "scores of final states", "Two points whose speeds are off by a known amount.", score_answers,
     few_roundings, rounded},
    {"bounds", "numbers with bounds", "Bounds of operands, and roundings, by hand.", bound_answers, few_roundings,
     rounded},
    {"functions", "functions, integrals, roots, spectra", "Tables, polynomials and small matrices.", function_answers,
     few_roundings, rounded},
    {"refusals", "problems that references refuse", "One number at a time, on both sides of where its range ends.",
     refusal_answers, few_roundings, rounded},
    {"gas-schemes", "schemes for flows of gas", "Images at walls, totals that stay, first steps by hand.",
     gas_scheme_answers, few_roundings, rounded},
    {"shapes", "gates of shapes", "Shapes that are wrong by a known amount.", shape_answers, few_roundings, rounded},
    {"paths", "gates of shapes along lines", "Values or gradients that jump by a known amount.", path_answers,
     of_close_pieces,
     "slopes and curvatures of ten a cell along the pieces of 2^-20 cells on which jumps are seen; integrals are "
     "nearer: third derivatives that jump within a hundredth of a cell, cubed"},
    {"filters", "gates of transfers", "Filters that are known in closed form.", filter_answers, of_small_shares,
     "shares of 1e-6 and more of a wave, whose logarithms keep ten digits"},
    {"contacts", "gates of contact", "Laws that are wrong by a known amount.", contact_answers, few_roundings, rounded},
    {"materials", "gates of materials", "A solid that is wrong by a known amount.", material_answers, of_differences,
     "differences of 1e-5 in strain, whose own errors are below 1e-7"},
    {"pulls", "gates of points that pull", "Forces that are wrong by a known amount, and blocks without any.",
     pull_answers, of_differences, "differences of 1e-5 in place, whose own errors are below 1e-7"}};

Case estimators() { return known_answers_case("estimators", all_estimators); }
PLUMBLINE_CASE(estimators);

}  // namespace
}  // namespace plumbline::estimators
