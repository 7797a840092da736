// Scenes of a few points whose columns hold known numbers.
#pragma once

#include <vector>

#include "kernel/scene.hpp"

namespace plumbline {

// What the columns that files may hold are filled with: numbers of which no two are alike, exact in binary. Deformations have 2
// more on their diagonal.
double given_number(const ColumnId& id, int component, int point, int dim);
// All columns of the body that have such numbers.
void fill_columns(Body& body, int dim);
// Row after row, of a body that is not filled but by this.
std::vector<double> given_rows(const ColumnId& id, int components, int points, int dim);

Scene plane_of_gas_and_chains();  // a gas with a load in time, an open and a closed chain, a layer; walls and pistons
Scene rings_of_bands();           // one chain
Scene rings_of_solids();          // at small and at finite strains
Scene space_of_solids();          // the same, one with a load that asks how high it is, one with a force on each point
Scene line_of_solids();           // of which loads ask where they are, and how fast

}  // namespace plumbline
