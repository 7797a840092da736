// What functions of the harness give for data whose answer closed forms give, by what is looked at.
#pragma once

#include "cases/catalog/estimators/known_answers.hpp"

namespace plumbline {

// What is made of runs.
KnownAnswers line_answers();        // straight lines by least squares, and Student's t
KnownAnswers order_answers();       // observed orders and their intervals
KnownAnswers sample_answers();      // ratios of two samples of times, bands of ensembles, costs at equal error
KnownAnswers norm_answers();        // of fields and errors
KnownAnswers period_answers();      // extremes of histories, and periods
KnownAnswers halving_answers();     // limits for dt -> 0
KnownAnswers comparison_answers();  // changes between two results folders
KnownAnswers verdict_answers();     // verdicts and margins of gates
KnownAnswers rule_answers();        // recorded ranges, bands of expected failures, nearest names, lattices of points
KnownAnswers size_answers();        // points, cells and bytes that are foreseen
KnownAnswers flow_answers();        // flows on which steps are timed, and the bytes that these move

// What the laboratory makes of steps.
KnownAnswers growth_answers();       // growth of runs and of small steps
KnownAnswers limit_answers();        // largest stable steps by bisection: to their own width
KnownAnswers content_answers();      // what is read off scenes
KnownAnswers step_map_answers();     // a step as a map of one vector of numbers
KnownAnswers wave_answers();         // matrices of steps of a bar: to differences of the step
KnownAnswers oscillation_answers();  // gates of integrators, of Runge-Kutta steps: to the width of a bisection

// What is kept, written and read.
KnownAnswers carried_answers();      // columns that are sorted and copied, runs that are saved and taken up
KnownAnswers frame_answers();        // snapshots of runs: of which instants and points
KnownAnswers frame_value_answers();  // and what they hold of a point: numbers in single precision
KnownAnswers file_answers();         // files of HDF5
KnownAnswers start_answers();        // starts for other programs
KnownAnswers final_state_answers();  // final states of other programs: what is read of them
KnownAnswers handed_in_answers();    // what these kept of the start
KnownAnswers score_answers();        // and how they are judged

// What references are made of.
KnownAnswers bound_answers();       // numbers with bounds
KnownAnswers function_answers();    // functions, integrals, roots, spectra
KnownAnswers refusal_answers();     // problems that they refuse
KnownAnswers gas_scheme_answers();  // schemes for flows of gas

// Gates of parts.
KnownAnswers shape_answers();     // of shapes that are wrong by known amounts
KnownAnswers path_answers();      // along lines across the grid: to what a piece of 2^-20 cells adds
KnownAnswers filter_answers();    // of transfers, of their filters: to what logarithms of small shares keep
KnownAnswers contact_answers();   // of laws of contact
KnownAnswers material_answers();  // of a solid: to differences of 1e-5
KnownAnswers pull_answers();      // of points that pull at each other: to differences of 1e-5

}  // namespace plumbline
