// What functions of the harness give for data whose answer closed forms give, by what is looked at.
#pragma once

#include "cases/catalog/estimators/known_answers.hpp"

namespace plumbline {

KnownAnswers line_answers();         // straight lines by least squares, and Student's t
KnownAnswers order_answers();        // observed orders and their intervals
KnownAnswers sample_answers();       // ratios of two samples of times, bands of ensembles, costs at equal error
KnownAnswers norm_answers();         // of fields and errors
KnownAnswers period_answers();       // extremes of histories, and periods
KnownAnswers halving_answers();      // limits for dt -> 0
KnownAnswers comparison_answers();   // changes between two results folders
KnownAnswers handed_in_answers();    // what final states of other programs kept of the start
KnownAnswers verdict_answers();      // verdicts and margins of gates
KnownAnswers growth_answers();       // growth of runs and of small steps
KnownAnswers carried_answers();      // columns that are sorted and copied, runs that are saved and taken up
KnownAnswers step_map_answers();     // a step as a map of one vector of numbers
KnownAnswers content_answers();      // what the laboratory reads off scenes
KnownAnswers oscillation_answers();  // gates of integrators, of Runge-Kutta steps: to the width of a bisection
KnownAnswers filter_answers();       // gates of transfers, of filters: to what logarithms of small shares keep
KnownAnswers rule_answers();         // ranges, bands, names, lattices
KnownAnswers wave_answers();         // matrices of steps of a bar: to differences of the step
KnownAnswers pull_answers();         // gates of points that pull at each other: to differences of 1e-5
KnownAnswers limit_answers();        // largest stable steps by bisection: to their own width
KnownAnswers shape_answers();        // what gates of shapes measure of shapes that are wrong by known amounts
KnownAnswers contact_answers();      // gates of contact, of laws
KnownAnswers material_answers();     // gates of materials, of a solid: to differences of 1e-5
KnownAnswers path_answers();         // and along lines across the grid: to what a piece of 2^-20 cells adds

}  // namespace plumbline
