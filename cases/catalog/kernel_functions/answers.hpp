// What functions that the kernel is built from give where closed forms or another computation give the answer.
#pragma once

#include "cases/catalog/estimators/known_answers.hpp"

namespace plumbline::kernel_functions {

KnownAnswers shape_answers();  // weights, gradients, integrals and moments of B-splines and of tents averaged over boxes

}  // namespace plumbline::kernel_functions
