// What functions that the kernel is built from give where closed forms or another computation give the answer.
#pragma once

#include "cases/catalog/estimators/known_answers.hpp"

namespace plumbline::kernel_functions {

KnownAnswers shape_answers();        // weights, gradients, integrals of B-splines and of tents averaged over boxes
KnownAnswers circle_answers();       // normals by circles, and tangents of chains
KnownAnswers surface_fit_answers();  // normals by planes and quadratics in space
KnownAnswers enclosed_answers();     // what of a polygon is each node's
KnownAnswers cell_volume_answers();  // what of space is
KnownAnswers speed_answers();        // of waves, by which materials bound the step
KnownAnswers membrane_answers();     // of membranes in space: stresses, energies, rates, speeds
KnownAnswers layer_answers();        // of layers of points with tangents
KnownAnswers chain_answers();        // and of chains of segments
KnownAnswers tensor_answers();       // of packs of tensors, places by cubes, largest values, sums over lanes, rotations
KnownAnswers logarithm_answers();    // in units in the last place

}  // namespace plumbline::kernel_functions
