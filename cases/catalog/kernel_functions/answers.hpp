// What functions that the kernel is built from give where closed forms or another computation give the answer.
// Each source has a namespace of its own: several are compiled as one.
#pragma once

#include "cases/catalog/estimators/known_answers.hpp"

namespace plumbline::kernel_functions {

namespace shapes_trial {
KnownAnswers shape_answers();  // weights, gradients, integrals of B-splines and of tents averaged over boxes
}  // namespace shapes_trial
namespace circles_trial {
KnownAnswers circle_answers();       // normals by circles, and tangents of chains
KnownAnswers surface_fit_answers();  // normals by planes and quadratics in space
}  // namespace circles_trial
namespace enclosed_trial {
KnownAnswers enclosed_answers();     // what of a polygon is each node's
KnownAnswers cell_volume_answers();  // what of space is
}  // namespace enclosed_trial
namespace speeds_trial {
KnownAnswers speed_answers();  // of waves, by which materials bound the step
}  // namespace speeds_trial
namespace membranes_trial {
KnownAnswers membrane_answers();  // of membranes in space: stresses, energies, rates, speeds
}  // namespace membranes_trial
namespace layers_trial {
KnownAnswers layer_answers();  // of layers of points with tangents
}  // namespace layers_trial
namespace chains_trial {
KnownAnswers chain_answers();  // and of chains of segments
}  // namespace chains_trial
namespace tensors_trial {
KnownAnswers tensor_answers();     // of packs of tensors, places by cubes, largest values, sums over lanes, rotations
KnownAnswers logarithm_answers();  // in units in the last place
}  // namespace tensors_trial

}  // namespace plumbline::kernel_functions
