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
KnownAnswers limit_answers();        // largest stable steps by bisection: to their own width
KnownAnswers shape_answers();        // what gates of shapes measure of shapes that are wrong by known amounts
KnownAnswers contact_answers();      // gates of contact, of laws
KnownAnswers material_answers();     // gates of materials, of a solid: to differences of 1e-5
KnownAnswers frame_answers();        // snapshots of runs: of which instants and points
KnownAnswers frame_value_answers();  // and what they hold of a point: numbers in single precision
KnownAnswers start_answers();        // starts as they are written for other programs
KnownAnswers file_answers();         // files of HDF5, written and read
KnownAnswers final_state_answers();  // final states of other programs: what is read of them
KnownAnswers score_answers();        // and how they are judged
KnownAnswers path_answers();         // and along lines across the grid: to what a piece of 2^-20 cells adds

}  // namespace plumbline
